// Each kind of sample rows is what it says, by the oracle.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include <rotconv/sampling.hpp>

#include "../../src/core/numerics/philox.hpp"
#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"

using namespace rotconv;
using accuracy::spec;
using oracle::Real;

namespace {

using Row = std::vector<double>;

std::vector<double> indices(std::size_t count) {
    std::vector<double> rows(count);
    std::iota(rows.begin(), rows.end(), 0.0);
    return rows;
}

/// The first rows of one kind.
std::vector<Row> rows_of(const Spec& to, SampleKind kind, std::size_t count, double noise = 5e-4) {
    std::vector<double> numbers(count * to.size());
    Sampler(to, {.kinds = {kind}, .noise = noise}).run(indices(count), numbers);
    std::vector<Row> rows;
    for (std::size_t i = 0; i < count; ++i) {
        const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(i * to.size());
        rows.emplace_back(first, first + static_cast<std::ptrdiff_t>(to.size()));
    }
    return rows;
}

Real norm_of(const Row& row) {
    Real square = 0;
    for (const double number : row) {
        square += Real(number) * number;
    }
    return sqrt(square);
}

/// From gimbal lock.
Real margin_of(EulerSequence sequence, const oracle::Quaternion& attitude) {
    Spec angles = spec("euler:XYZ");
    angles.sequence = sequence;
    const Real middle = abs(oracle::exact_numbers(angles, attitude)[1]);
    const Real lock = sequence.proper() ? oracle::pi() : Real(oracle::pi() / 2);
    return sequence.proper() ? std::min(middle, Real(lock - middle)) : Real(lock - middle);
}

/// A third of the sizes is below 1e-8, and so many are at most `least`.
void check_sizes(std::vector<Real> sizes, const Real& least, std::size_t so_many) {
    std::ranges::sort(sizes);
    CHECK(sizes.front() >= 0);
    CHECK(sizes.back() > Real(0.01));
    CHECK(sizes.back() <= Real(0.1));
    CHECK(sizes[sizes.size() / 3] < Real(1e-8));
    CHECK(sizes[so_many - 1] <= least);
}

/// SPECs of all representations, and what samples have apart from others.
std::vector<Spec> sampled_specs() {
    std::vector<Spec> specs;
    for (const auto& text : accuracy::all_specs()) {
        specs.push_back(spec(text));
    }
    for (const char* text : {"euler:Z-Y-X:deg", "euler:zxz:positive", "dcm:col:passive"}) {
        specs.push_back(spec(text));
    }
    return specs;
}

} // namespace

// The known answers that Random123 is published with. Catches other numbers than those of Philox.
TEST_CASE("Philox gives its published numbers") {
    using Words = std::array<std::uint32_t, 4>;
    constexpr std::uint32_t ones = 0xffffffff;
    CHECK(philox({0, 0, 0, 0}, 0) == Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
    CHECK(philox({ones, ones, ones, ones}, ~std::uint64_t{0}) == Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
    CHECK(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, 0x299f31d0a4093822) ==
          Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

// Catches a row that no program can read, such as an infinite one of cayley.
TEST_CASE("every sample row is a finite attitude, of every kind in every representation") {
    for (const Spec& to : sampled_specs()) {
        for (const SampleKind kind : sample_kinds_of(to.name)) {
            INFO(to.text() << ' ' << name_of(kind));
            for (const Row& row : rows_of(to, kind, 200, 0.5)) {
                CHECK(std::ranges::all_of(row, [](double number) { return std::isfinite(number); }));
                CHECK(read_attitude(to, row));
            }
        }
    }
}

// Catches rows that depend on those before them, and thus on threads.
TEST_CASE("a sample row is the same in any order and company") {
    for (const char* text : {"quat", "dcm:passive", "euler:ZYX:deg", "rotvec"}) {
        const Spec to = spec(text);
        SampleSettings settings{.kinds = sample_kinds_of(to.name), .seed = 7};
        constexpr std::size_t count = 300;
        auto rows = indices(count);
        Row all(count * to.size());
        Row reversed(count * to.size());
        Sampler sampler(to, settings);
        sampler.run(rows, all);
        std::ranges::reverse(rows);
        sampler.run(rows, reversed);
        Row one(to.size());
        for (std::size_t i = 0; i < count; ++i) {
            const auto expected = std::span(all).subspan(i * to.size(), to.size());
            CHECK(std::ranges::equal(expected, std::span(reversed).subspan((count - 1 - i) * to.size(), to.size())));
            Sampler(to, settings).run(std::span(rows).subspan(count - 1 - i, 1), one);
            CHECK(std::ranges::equal(expected, one));
        }
        settings.seed = 8;
        Sampler(to, settings).run(std::span(rows).last(1), one);
        CHECK(!std::ranges::equal(std::span(all).first(to.size()), one));
    }
}

// A unit quaternion keeps its bits, so that the row of quat is the exact attitude. Catches rows that were rounded
// on the way.
TEST_CASE("sample rows are rounded once") {
    using enum SampleKind;
    for (const SampleKind kind : {uniform, small, half_turn, lock, border, cube}) {
        const auto attitudes = rows_of(Spec{}, kind, 100);
        for (const char* text : {"dcm", "6d", "mrp", "rotvec:deg", "axis-angle"}) {
            const Spec to = spec(text);
            const auto rows = rows_of(to, kind, 100);
            for (std::size_t i = 0; i < rows.size(); ++i) {
                REQUIRE(abs(norm_of(attitudes[i]) - 1) < Real(3.9 * oracle::eps));
                if (attitudes[i][0] > 0.0 && attitudes[i][0] < 0x1p-90) { // either sign of the axis may come out
                    continue;
                }
                const auto exact = oracle::converted(Spec{}, to, attitudes[i]);
                for (std::size_t k = 0; k < to.size(); ++k) {
                    INFO(text << ' ' << name_of(kind) << ' ' << i << ' ' << k);
                    const bool is_tiny = std::abs(rows[i][k]) < 1e-12; // where correct rounding is not promised
                    CHECK((rows[i][k] == exact[k].value || !exact[k].certain ||
                           (is_tiny && rows[i][k] == Approx(exact[k].value).epsilon(1e-10))));
                }
            }
        }
    }
}

// Catches a corner of the rotations that is preferred.
TEST_CASE("uniform sample rows are uniform") {
    constexpr std::size_t count = 20000;
    constexpr double within = 0.02;
    Row squares(4);
    Row sums(9);
    const auto quaternions = rows_of(Spec{}, SampleKind::uniform, count);
    const auto matrices = rows_of(spec("dcm"), SampleKind::uniform, count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            squares[k] += quaternions[i][k] * quaternions[i][k] / count;
        }
        for (std::size_t k = 0; k < 9; ++k) {
            sums[k] += matrices[i][k] / count;
        }
    }
    CHECK(std::ranges::all_of(squares, [](double mean) { return std::abs(mean - 0.25) < within; }));
    CHECK(std::ranges::all_of(sums, [](double mean) { return std::abs(mean) < within; }));
}

// Catches samples that stay far from what they are to be near to.
TEST_CASE("small and half-turn sample rows come near to it") {
    std::vector<Real> angles;
    for (const Row& row : rows_of(spec("rotvec"), SampleKind::small, 1000)) {
        angles.push_back(norm_of(row));
        CHECK(angles.back() >= Real("1e-300"));
    }
    check_sizes(angles, Real("1e-280"), 10);

    std::vector<Real> distances;
    std::size_t in_plane = 0;
    for (const Row& row : rows_of(Spec{}, SampleKind::half_turn, 1000)) {
        const Real vector = norm_of({row[1], row[2], row[3]});
        distances.push_back(2 * atan2(Real(row[0]), vector));
        in_plane += row[1] * row[2] * row[3] == 0.0 ? 1 : 0;
    }
    check_sizes(distances, Real(0), 80);
    CHECK(std::ranges::count_if(distances, [](const Real& d) { return d > 0 && d < Real("1e-250"); }) > 5);
    CHECK(in_plane > 150);
    for (const Row& row : rows_of(spec("cayley"), SampleKind::half_turn, 1000)) {
        CHECK(norm_of(row) < Real("1e300"));
    }
}

// Catches the lock of another sequence, and rows that keep away from it.
TEST_CASE("sample rows come near the gimbal lock of the sequence, or of all in turn") {
    constexpr std::size_t count = 2400;
    const auto sequences = EulerSequence::all();
    for (const char* text : {"quat", "dcm:passive:col"}) {
        const Spec to = spec(text);
        std::vector<Real> margins;
        const auto rows = rows_of(to, SampleKind::lock, count);
        for (std::size_t i = 0; i < count; ++i) {
            margins.push_back(margin_of(sequences.at(i % sequences.size()), oracle::attitude(to, rows[i])));
        }
        check_sizes(margins, Real(3e-16), count / 8);
    }
    for (const char* text : {"rpy", "euler:ZYX:deg:passive", "euler:Z-X-Z:deg", "euler:zyz:positive", "euler:-x-yz"}) {
        const Spec to = spec(text);
        INFO(text);
        std::vector<Real> margins;
        std::vector<Real> outer;
        for (const Row& row : rows_of(to, SampleKind::lock, count)) {
            const Real unit = to.unit == AngleUnit::degrees ? Real(oracle::pi() / 180) : Real(1);
            const Real middle = abs(unit * row[1]);
            const Real half = oracle::pi();
            CHECK((!to.sequence.proper() || row[1] >= 0.0));
            margins.push_back(
                abs(to.sequence.proper() ? std::min(middle, Real(half - middle)) : Real(half / 2 - middle)));
            outer.push_back(unit * row[2]);
            CHECK(outer.back() <= (to.positive ? 2 : 1) * half);
            CHECK(outer.back() > (to.positive ? Real(0) : Real(-half)));
        }
        check_sizes(margins, Real(3e-16), count / 8);
        CHECK(*std::ranges::max_element(outer) > 3);
    }
}

// Catches samples that a choice of the largest component never sees.
TEST_CASE("sample rows come near the borders between quaternion components") {
    std::size_t equal = 0;
    std::size_t near = 0;
    std::size_t without_trace = 0;
    for (Row row : rows_of(Spec{}, SampleKind::border, 1000)) {
        without_trace += std::abs(4.0 * row[0] * row[0] - 1.0) < 1e-6 ? 1 : 0;
        std::ranges::transform(row, row.begin(), [](double component) { return std::abs(component); });
        std::ranges::sort(row);
        equal += row[3] == row[2] ? 1 : 0;
        near += row[3] - row[2] < 1e-6 ? 1 : 0;
    }
    CHECK(equal > 200);
    CHECK(near > equal + 200);
    CHECK(without_trace > 100);
}

// Catches a rotation that is missing or stands twice.
TEST_CASE("cube sample rows are the rotations of the cube, each once") {
    const auto rows = rows_of(spec("dcm"), SampleKind::cube, 24);
    CHECK(std::set<Row>(rows.begin(), rows.end()).size() == 24);
    for (const Row& row : rows) {
        CHECK(std::ranges::count(row, 0.0) == 6);
        CHECK(std::ranges::count(row, 1.0) + std::ranges::count(row, -1.0) == 3);
    }
    const auto again = rows_of(spec("dcm"), SampleKind::cube, 48);
    CHECK(std::equal(rows.begin(), rows.end(), again.begin() + 24));
    const auto finite = rows_of(spec("cayley"), SampleKind::cube, 15);
    CHECK(std::set<Row>(finite.begin(), finite.end()).size() == 15);
}

// Catches a kind that says more than its rows are.
TEST_CASE("scaled, noisy and long sample rows are so within their limits") {
    std::vector<Real> norms;
    for (const Row& row : rows_of(spec("quat:xyzw"), SampleKind::scaled, 1000)) {
        norms.push_back(norm_of(row));
    }
    std::ranges::sort(norms);
    CHECK(norms.front() >= Real("1e-150"));
    CHECK(norms.front() < Real("1e-140"));
    CHECK(norms.back() <= Real("1e150"));
    CHECK(norms.back() > Real("1e140"));

    for (const char* text : {"dcm:col", "6d", "5d:passive"}) {
        const Spec to = spec(text);
        const auto exact = rows_of(to, SampleKind::uniform, 500); // of the same attitudes
        for (const double noise : {0.0, 5e-4, 0.01}) {
            const auto rows = rows_of(to, SampleKind::noise, 500, noise);
            double most = 0.0;
            for (std::size_t i = 0; i < rows.size(); ++i) {
                for (std::size_t k = 0; k < to.size(); ++k) {
                    most = std::max(most, std::abs(rows[i][k] - exact[i][k]));
                }
            }
            CHECK(most <= noise * (1.0 + 1e-10));
            CHECK(most >= 0.99 * noise);
        }
    }

    for (const char* text : {"euler:ZYX:deg", "rpy", "rotvec:deg", "axis-angle"}) {
        const Spec to = spec(text);
        for (Row row : rows_of(to, SampleKind::many_turns, 200)) {
            if (to.name == RepresentationId::axis_angle) {
                row.erase(row.begin(), row.begin() + 3);
            }
            CHECK(norm_of(row) > 360);
            CHECK(norm_of(row) < Real(2e15));
        }
    }
}
