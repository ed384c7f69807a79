// The first phase of a conversion: the exact kernels' numbers wherever it leaves no row open, and few rows are left
// open.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <rotconv/conversion.hpp>

#include "../../src/core/conversion/kernels.hpp"
#include "../../src/core/representations/euler_formulas.hpp"
#include "../../src/core/representations/matrices.hpp"
#include "accuracy.hpp"
#include "catch.hpp"
#include "rounding.hpp"
#include "strata.hpp"

namespace {

namespace exact = rotconv;
using exact::Approximate;
using exact::DoubleDouble;
using exact::Fixed;
using rotconv::batch_rows;
using rotconv::Spec;

struct Answers {
    std::array<double, batch_rows * 9> numbers{};
    rotconv::AttitudeBatch<double> attitudes{};
    std::array<rotconv::DiagnosticSet, batch_rows> diagnostics{};
};

struct Counts {
    std::size_t rows = 0, open = 0, different = 0;
};

/// Rows through both phases, and through the exact kernels alone, which also answer for the rest of each number.
void compare(const std::string& from_text, const std::string& to_text, double lock_margin,
             const std::vector<double>& numbers, Counts& counts) {
    const Spec from = accuracy::spec(from_text);
    const Spec to = accuracy::spec(to_text);
    const auto& kernels = rotconv::kernel_table();
    rotconv::ZeroTable zeros;
    const rotconv::Task task{&from, &to, lock_margin, &rotconv::no_rotations, &zeros};
    const std::size_t rows = numbers.size() / from.size();
    for (std::size_t first = 0; first < rows; first += batch_rows) {
        const double* const in = numbers.data() + first * from.size();
        const std::size_t count = std::min(batch_rows, rows - first);
        Answers phases;
        Answers alone;
        std::array<double, batch_rows * 9> rest{};
        std::array<bool, batch_rows> open{};
        if (!kernels.run_first(task, in, count, phases.attitudes, phases.numbers.data(), open.data())) {
            open.fill(true);
        }
        kernels.run(task, {in}, count, {phases.attitudes}, phases.numbers.data(), nullptr, phases.diagnostics.data());
        kernels.run(task, {in}, count, {alone.attitudes}, alone.numbers.data(), rest.data(), alone.diagnostics.data());
        for (std::size_t i = 0; i < count; ++i) {
            const auto same = [](const double* a, const double* b, std::size_t size) {
                return std::equal(a, a + size, b, [](double x, double y) { return x == y; });
            };
            ++counts.rows;
            counts.open += open[i] ? 1 : 0;
            bool all = phases.attitudes.error[i] == alone.attitudes.error[i];
            if (alone.attitudes.error[i] == rotconv::Error::none) {
                all = all &&
                      std::memcmp(&phases.diagnostics[i], &alone.diagnostics[i], sizeof alone.diagnostics[i]) == 0 &&
                      same(&phases.numbers[i * to.size()], &alone.numbers[i * to.size()], to.size());
                for (std::size_t k = 0; k < 4 && to.name != rotconv::RepresentationId::quat; ++k) { // which needs none
                    const double apart = phases.attitudes[k].hi[i] * alone.attitudes[0].hi[i] - // but for the length
                                         alone.attitudes[k].hi[i] * phases.attitudes[0].hi[i];
                    all = all && apart == 0.0;
                }
            }
            if (!all && ++counts.different < 4) {
                UNSCOPED_INFO(from_text << " to " << to_text << ":"
                                        << accuracy::text_of({in + i * from.size(), from.size()}));
            }
        }
    }
}

const std::vector<std::string>& specs_of_angles() {
    static const std::vector<std::string> specs{
        "rpy",       "rpy:deg",        "rpy:deg:positive",     "euler:ZYX:deg",
        "euler:zxz", "euler:Z-XZ:deg", "euler:X-Y-Z:positive", "euler:yxy:deg:positive"};
    return specs;
}

bool has_first_phase() {
    const Spec from;
    const Spec to = accuracy::spec("rpy");
    const rotconv::Task task{&from, &to, 1e-15, &rotconv::no_rotations, nullptr};
    const std::array<double, 4> identity{1.0, 0.0, 0.0, 0.0};
    Answers answers;
    std::array<bool, batch_rows> open{};
    return rotconv::kernel_table().run_first(task, identity.data(), 1, answers.attitudes, answers.numbers.data(),
                                             open.data());
}

/// All attitudes alike.
void compare_uniform(std::size_t rows) {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const std::string from : {"quat", "dcm", "euler:yzx:deg"}) {
        for (const std::string& to : specs_of_angles()) {
            pairs.emplace_back(from, to);
        }
    }
    for (const std::string from : {"rpy", "rpy:deg", "euler:zxz", "euler:Z-XY:deg"}) {
        pairs.emplace_back(from, "quat");
    }
    for (const std::string from : {"quat", "quat:passive", "rpy", "rotvec:deg"}) {
        pairs.emplace_back(from, "dcm");
    }
    pairs.emplace_back("dcm", "quat");
    pairs.emplace_back("dcm", "quat:passive");
    std::mt19937_64 engine(92);
    std::normal_distribution<double> normal;
    std::vector<double> quaternions(4 * 16 * batch_rows);
    std::vector<Counts> counts(pairs.size());
    for (std::size_t done = 0; done < rows; done += pairs.size() * 16 * batch_rows) {
        std::ranges::generate(quaternions, [&] { return normal(engine); });
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            const auto& [from, to] = pairs[k];
            const auto numbers =
                accuracy::converted(Spec{}, accuracy::spec(from), quaternions, {.tolerance = 1e9}).numbers;
            compare(from, to, 1e-15, numbers, counts[k]);
        }
    }
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        INFO(pairs[k].first << " to " << pairs[k].second << ": " << counts[k].open << " of " << counts[k].rows
                            << " rows left open");
        CHECK(counts[k].different == 0);
        CHECK(counts[k].rows > 0);
        CHECK(counts[k].open * 200 < counts[k].rows);
    }
}

} // namespace

// Catches a bound below the error, in some range of angles; a first phase that proves nothing, and costs time.
TEST_CASE("the first phase gives the exact kernels' numbers, and leaves less than 0.5 % of the rows open") {
    if (!has_first_phase()) {
        WARN("this processor has no fused multiply-add");
        return;
    }
    compare_uniform(tried(1'000'000));
}
TEST_CASE("the same of 100 million rows", "[.long]") { compare_uniform(100'000'000); }

// Catches an angle of 0, a gimbal lock or a half-turn that is taken for proven; a lock margin passed over.
TEST_CASE("hostile rows have the exact kernels' numbers") {
    if (!has_first_phase()) {
        WARN("this processor has no fused multiply-add");
        return;
    }
    for (const std::string from : {"quat", "dcm", "rotvec", "rpy:deg", "euler:zxz"}) {
        std::vector<std::string> targets = specs_of_angles();
        targets.emplace_back("dcm");
        if (accuracy::spec(from).name == rotconv::RepresentationId::rpy ||
            accuracy::spec(from).name == rotconv::RepresentationId::euler ||
            accuracy::spec(from).name == rotconv::RepresentationId::dcm) {
            targets.insert(targets.end(), {"quat", "quat:passive"});
        }
        for (const std::string& to : targets) {
            Counts counts;
            std::vector<double> numbers;
            for (const auto& stratum : strata::strata_of(accuracy::spec(from), accuracy::spec(to), tried(10))) {
                for (const auto& row : stratum.rows) {
                    numbers.insert(numbers.end(), row.begin(), row.end());
                }
            }
            for (const double lock_margin : {0.0, 1e-15, 1e-6, 1e-3, 0.3, 2.0}) {
                compare(from, to, lock_margin, numbers, counts);
            }
            CHECK(counts.different == 0);
            CHECK(counts.rows > 6 * 5);
        }
    }
}

// Catches rows that people have, turns about one axis, left to the exact kernels.
TEST_CASE("turns about one axis are not left open") {
    if (!has_first_phase()) {
        WARN("this processor has no fused multiply-add");
        return;
    }
    strata::Source source(93);
    for (const std::string from : {"quat", "dcm", "rpy:deg"}) {
        Counts counts;
        std::vector<double> numbers;
        for (int i = 0; i < 3000; ++i) {
            std::vector<double> angles(3, 0.0);
            angles.at(static_cast<std::size_t>(i) % 3) = source.uniform(-85, 85);
            const auto row = accuracy::converted(accuracy::spec("rpy:deg"), accuracy::spec(from), angles).numbers;
            numbers.insert(numbers.end(), row.begin(), row.end());
        }
        compare(from, "rpy", 1e-15, numbers, counts);
        INFO(from << ": " << counts.open << " of " << counts.rows << " rows left open");
        CHECK(counts.open * 100 < counts.rows);
    }
}

// Catches a bound that does not grow with the defect; matrices of 13 digits that are left to the exact kernels; those
// of few digits, of which the first phase proves nothing, taken for proven.
TEST_CASE("noise in matrices is part of the first phase's bound") {
    if (!has_first_phase()) {
        WARN("this processor has no fused multiply-add");
        return;
    }
    strata::Source source(95);
    std::vector<double> quaternions(4 * batch_rows * tried(40));
    std::ranges::generate(quaternions, [&] { return source.uniform(-1, 1); });
    const auto exact_ones = accuracy::converted(Spec{}, accuracy::spec("dcm"), quaternions, {.tolerance = 1e9}).numbers;
    for (const double noise : {1e-16, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-8, 1e-5, 1e-3}) {
        Counts counts;
        std::vector<double> numbers = exact_ones;
        std::ranges::for_each(numbers, [&](double& number) { number += noise * source.uniform(-1, 1); });
        compare("dcm", "quat", 1e-15, numbers, counts);
        INFO(noise << ": " << counts.open << " of " << counts.rows << " rows left open");
        CHECK(counts.different == 0);
        CHECK((noise > 1e-13 || counts.open * 1000 < counts.rows));
        CHECK((noise < 1e-10 || counts.open == counts.rows));
    }
}

namespace {

/// Climbs from random points: changes some of their coordinates by more or less, and keeps what makes the error
/// greater. The greatest.
template <std::size_t size, class Error> double climb(int starts, int steps, const Error& error_of) {
    std::mt19937_64 engine(94);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    double worst = 0.0;
    for (int start = 0; start < starts; ++start) {
        std::array<double, size> best{};
        std::ranges::generate(best, [&] { return uniform(engine); });
        double greatest = error_of(best);
        for (int step = 0; step < steps; ++step) {
            std::array<double, size> changed = best;
            const double reach = std::exp2(40 * uniform(engine) - 40);
            changed.at(engine() % size) += reach * uniform(engine);
            changed.at(engine() % size) += reach * uniform(engine);
            const double error = error_of(changed);
            if (error > greatest) {
                greatest = error;
                best = changed;
            }
        }
        worst = std::max(worst, greatest);
    }
    return worst;
}

DoubleDouble size_of(DoubleDouble a) { return a.hi < 0.0 ? -a : a; }

/// Two coordinates as a number with a low part.
DoubleDouble number(double high, double low) { return exact::two_sum(high, low * 0x1p-53 * high); }

} // namespace

// Catches a bound that is below the error of the series, or so far above it that rows are left open for nothing.
TEST_CASE("the first phase's angle of a vector is off by 2^-65 of itself at most") {
    const double worst = climb<4>(tried(400), 400, [](const std::array<double, 4>& point) {
        exact::Column<Approximate> x;
        exact::Column<Approximate> y;
        exact::Column<DoubleDouble> angle;
        x.set(0, number(point[0], point[1]));
        y.set(0, number(point[2], point[3]));
        exact::angles_of(x, y, 1, rotconv::AngleUnit::radians, angle);
        const DoubleDouble right = exact::angle_of(DoubleDouble(x.hi[0], x.lo[0]), DoubleDouble(y.hi[0], y.lo[0]),
                                                   rotconv::AngleUnit::radians);
        return std::fabs(((angle[0] - right) / right).hi);
    });
    INFO("the search came to 2^" << std::log2(worst));
    CHECK(worst <= 0x1p-65);
    CHECK(worst >= 0x1p-68);
}

namespace {

struct Off {
    double of_itself = 0.0, as_vector = 0.0;
};

/// How far sine and cosine are off, the worse of the two as part of itself.
Off off_of_turn(double angle, rotconv::AngleUnit unit) {
    exact::Column<DoubleDouble> angles;
    exact::Column<Approximate> cosine;
    exact::Column<Approximate> sine;
    angles.set(0, angle);
    exact::sine_cosine(angles, 1, unit, cosine, sine);
    const auto right = exact::sine_cosine<DoubleDouble>(angle, unit);
    const double of_sine = (DoubleDouble(sine.hi[0], sine.lo[0]) - right.sine).hi;
    const double of_cosine = (DoubleDouble(cosine.hi[0], cosine.lo[0]) - right.cosine).hi;
    const auto part = [](double off, double whole) { return off == 0.0 ? 0.0 : std::fabs(off / whole); };
    return {std::max(part(of_sine, right.sine.hi), part(of_cosine, right.cosine.hi)), std::hypot(of_sine, of_cosine)};
}

} // namespace

// Catches a bound below the error of the series; an angle next to a quarter turn that is reduced with too few
// digits.
TEST_CASE("the first phase's sine and cosine are off by 2^-63 of themselves, as a vector by 2^-68.7") {
    for (const auto unit : {rotconv::AngleUnit::radians, rotconv::AngleUnit::degrees}) {
        const double range = unit == rotconv::AngleUnit::degrees ? 200.0 : 3.5;
        const double alone = climb<1>(tried(400), 400, [&](const std::array<double, 1>& point) {
            return off_of_turn(range * point[0], unit).of_itself;
        });
        const double together = climb<1>(tried(400), 400, [&](const std::array<double, 1>& point) {
            return off_of_turn(range * point[0], unit).as_vector;
        });
        INFO("the search came to 2^" << std::log2(alone) << " and 2^" << std::log2(together));
        CHECK(alone <= 0x1p-63);
        CHECK(alone >= 0x1p-67);
        CHECK(together <= 0x1.3p-69);
        CHECK(together >= 0x1p-72);
    }
    double worst =
        0.0; // of the doubles next to all multiples of the table's step up to where they are reduced otherwise
    for (int k = 1; k < 83'443; ++k) {
        worst = std::max(worst, off_of_turn((exact::exact_pi * (k / 64.0)).hi, rotconv::AngleUnit::radians).of_itself);
    }
    CHECK(worst <= 0x1p-63);
}

// Catches a bound that is below what rounding and cleaned differences turn a vector by.
TEST_CASE("the first phase's vectors are turned by 2^-95 r at most") {
    for (const char* sequence : {"xyz", "ZYX", "zxz", "YXZ"}) {
        const exact::FixedAxes axes(rotconv::EulerSequence::parse(sequence).value());
        const double worst = climb<8>(tried(400), 400, [&](const std::array<double, 8>& point) {
            DoubleDouble q[4];    // NOLINT(*-avoid-c-arrays): as TurnVectors takes it
            Approximate given[4]; // NOLINT(*-avoid-c-arrays)
            for (std::size_t k = 0; k < 4; ++k) {
                q[k] = number(point[k], point[k + 4]);
                given[k] = q[k];
            }
            const exact::TurnVectors<DoubleDouble> right(axes, q);
            const exact::TurnVectors<Approximate> found(axes, given);
            const double c = right.cosine_length.hi;
            const double s = right.sine_length.hi;
            const double r = std::max(c, s) / std::min(c, s);
            double error = 0.0;
            const auto compare_vectors = [&](const exact::Vector<Approximate>& a,
                                             const exact::Vector<DoubleDouble>& b) {
                const DoubleDouble x = exact::two_sum(a.x.hi, a.x.lo);
                const DoubleDouble y = exact::two_sum(a.y.hi, a.y.lo);
                const DoubleDouble cross = size_of(y * b.x - x * b.y) / (b.x * b.x + b.y * b.y);
                error = std::max(error, cross.hi / r);
            };
            compare_vectors(found.first, right.first);
            compare_vectors(found.middle, right.middle);
            compare_vectors(found.last, right.last);
            return std::isfinite(error) ? error : 0.0;
        });
        INFO(sequence << ": the search came to 2^" << std::log2(worst));
        CHECK(worst <= 0x1p-95);
        CHECK(worst > 0.0);
    }
}

// Catches a bound below the error of a product, or of 2/|q|^2 where |q| is 1/2; one that leaves rows open for nothing.
TEST_CASE("the first phase's matrices are off by 2^-91 at most") {
    const double worst = climb<8>(tried(400), 400, [](const std::array<double, 8>& point) {
        DoubleDouble q[4]; // NOLINT(*-avoid-c-arrays): as formulas take it
        Fixed given[4];    // NOLINT(*-avoid-c-arrays)
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] = number(2.0 * point[k], point[k + 4]);
            given[k] = {q[k].hi, q[k].lo};
        }
        const DoubleDouble norm = exact::squared_norm(q);
        if (!(norm.hi >= 0.25 && norm.hi < 4.0)) {
            return 0.0;
        }
        DoubleDouble right[9]; // NOLINT(*-avoid-c-arrays)
        Fixed found[9];        // NOLINT(*-avoid-c-arrays)
        exact::scaled_matrix_of(q, right);
        exact::divide_entries(right, norm);
        exact::scaled_matrix_of(given, found);
        exact::divide_entries(found, exact::squared_norm(given));
        double error = 0.0;
        for (std::size_t k = 0; k < 9; ++k) {
            error = std::max(error, size_of(exact::two_sum(found[k].hi, found[k].lo) - right[k]).hi);
        }
        return error;
    });
    INFO("the search came to 2^" << std::log2(worst));
    CHECK(worst <= exact::first_error_of_entries(0.0));
    CHECK(worst >= 0x1p-10 * exact::first_error_of_entries(0.0)); // with the few tries of the sanitizers, too
}

// Catches a bound below what the defect leaves, or what rounding does to a matrix without one; one that is too large.
TEST_CASE("the first phase's quaternions of matrices are off by 256 d^2 + 2^-91 at most") {
    for (const double noise : {0.0, 0x1p-52, 0x1p-45, 0x1p-39}) {
        const double worst = climb<13>(tried(400), 400, [noise](const std::array<double, 13>& point) {
            double m[9]; // NOLINT(*-avoid-c-arrays): as formulas take it
            exact::scaled_matrix_of({point[0], point[1], point[2], point[3]}, m);
            exact::divide_entries(m, exact::squared_norm({point[0], point[1], point[2], point[3]}));
            for (std::size_t k = 0; k < 9; ++k) {
                m[k] += noise * point[4 + k];
            }
            rotconv::ExactQuaternion read{};
            rotconv::kernel_table().read_exactly(accuracy::spec("dcm"), m, read);
            DoubleDouble right[4]; // NOLINT(*-avoid-c-arrays)
            Fixed found[4];        // NOLINT(*-avoid-c-arrays)
            for (std::size_t k = 0; k < 4; ++k) {
                right[k] = {read.hi[k], read.lo[k]};
            }
            exact::divide(right, exact::root(exact::squared_norm(right)));
            exact::unit_quaternion_of(m, found);
            double error = 0.0;
            for (std::size_t k = 0; k < 4; ++k) {
                const DoubleDouble component = exact::two_sum(found[k].hi, found[k].lo);
                error = std::max(error, std::min(size_of(component - right[k]).hi, size_of(component + right[k]).hi));
            }
            return std::isfinite(error) ? error / exact::first_error_of_quaternion(exact::squared_distance(m)) : 0.0;
        });
        INFO(noise << ": the search came to 2^" << std::log2(worst) << " of the bound");
        CHECK(worst <= 1.0);
        CHECK(worst >= 0x1p-12);
    }
}
