#include <rotconv/sampling.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include "checks.hpp"
#include "numerics/angles.hpp"
#include "numerics/philox.hpp"
#include "representations/codec.hpp"

// Bytes are the same on every machine: no function of the C library but the square root, which is rounded correctly.

namespace rotconv {
namespace {

using Quaternion = std::array<double, 4>;

// The least distances, as powers of 1/2.
constexpr int deepest = 985;        ///< nothing comes below 1e-300
constexpr int deepest_cayley = 900; ///< no number of cayley overflows
constexpr int deepest_near_1 = 56;  ///< doubles near 1 differ by no less

/// The random numbers of a row. What they are for tells those of its attitude from those of its numbers.
class Draws {
public:
    Draws(std::uint64_t seed, std::uint64_t row, bool for_numbers) noexcept
        : seed_(seed), counter_{static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(row >> 32U), 0,
                                for_numbers ? 1U : 0U} {}

    std::uint64_t bits() noexcept {
        if ((next_ ^= 2U) == 0) {
            block_ = philox(counter_, seed_);
            ++counter_[2];
        }
        return std::uint64_t{block_[next_]} << 32U | block_[next_ + 1];
    }
    std::size_t below(std::size_t count) noexcept { return static_cast<std::size_t>((bits() >> 32U) * count >> 32U); }
    bool one_in(std::size_t count) noexcept { return below(count) == 0; }
    double sign() noexcept { return one_in(2) ? -1.0 : 1.0; }
    /// In (0, 1): an odd multiple of 2^-53, thus exact.
    double fraction() noexcept { return (static_cast<double>(bits() >> 12U) + 0.5) * 0x1p-52; }
    /// In (-1, 1), and not 0.
    double signed_fraction() noexcept { return 2.0 * fraction() - 1.0; }
    /// From 2^least up to 2^(most + 1), each power of two equally likely.
    double of_size(int least, int most) noexcept {
        const int exponent = least + static_cast<int>(below(static_cast<std::size_t>(most - least) + 1));
        return (1.0 + fraction()) * power_of_two(exponent);
    }
    /// Below 1/32; half of them above 1e-20, where most formulas fail, and half down to 2^-depth.
    double distance(int depth) noexcept { return of_size(one_in(2) ? -depth : -std::min(66, depth), -6); }

    struct Point {
        double x, y, square; ///< that of its distance from the origin
    };
    /// Uniform.
    Point in_disc() noexcept {
        Point point{};
        do {
            point.x = signed_fraction();
            point.y = signed_fraction();
            point.square = point.x * point.x + point.y * point.y;
        } while (point.square >= 1.0);
        return point;
    }
    /// Uniform (Marsaglia 1972).
    Quaternion unit_quaternion() noexcept {
        const Point first = in_disc();
        const Point second = in_disc();
        const double factor = std::sqrt((1.0 - first.square) / second.square);
        return {first.x, first.y, factor * second.x, factor * second.y};
    }

private:
    std::uint64_t seed_;
    std::array<std::uint32_t, 4> counter_;
    std::array<std::uint32_t, 4> block_{};
    std::size_t next_ = 2; ///< the half of the block that was used last
};

/// At first axis = third, w and the component along it have together the size cos(middle/2), the other two that of the
/// sine: at lock one of the pairs is 0. A quarter turn about the middle axis leads to three different axes.
Quaternion near_lock(Draws& draws, EulerSequence sequence, bool is_exact) {
    const auto i = static_cast<std::size_t>(sequence.axis(sequence.intrinsic() ? 0 : 2));
    const auto j = static_cast<std::size_t>(sequence.axis(1));
    const Draws::Point large = draws.in_disc();
    const Draws::Point little = draws.in_disc();
    const double half_margin =
        is_exact ? 0.0 : draws.distance(sequence.proper() ? deepest_cayley : deepest_near_1); // tangent
    const double factor = half_margin * std::sqrt(large.square / little.square);
    const double sign = draws.sign();
    Quaternion q{large.x, large.y, factor * little.x, factor * little.y}; // w, along i, along j and along the third
    if (!sequence.proper()) {
        const double handed = (i + 1) % 3 == j ? sign : -sign; // by whether i, j and the third are right-handed
        q = {q[0] - sign * q[2], q[1] - handed * q[3], q[2] + sign * q[0], q[3] + handed * q[1]};
    } else if (sign < 0.0) {
        std::swap(q[0], q[2]);
        std::swap(q[1], q[3]);
    }
    Quaternion in_order{q[0]};
    in_order.at(1 + i) = q[1];
    in_order.at(1 + j) = q[2];
    in_order.at(4 - i - j) = q[3];
    return in_order;
}

/// Where formulas from matrices choose a branch: by the larger of two components, or by the trace of the matrix, which
/// is 0 where w is half the norm.
void move_to_border(Draws& draws, Quaternion& q) {
    const std::size_t kind = draws.below(4);
    const double factor = draws.sign() * (kind == 0 ? 1.0 : 1.0 - draws.distance(deepest_near_1));
    if (kind == 1) {
        q[0] = factor * std::sqrt((q[1] * q[1] + q[2] * q[2] + q[3] * q[3]) / 3.0);
    } else {
        const std::size_t first = draws.below(4);
        q.at(first) = draws.sign();
        q.at((first + 1 + draws.below(3)) % 4) = factor;
    }
}

/// One, two or four components of equal size, the first of them positive.
std::vector<Quaternion> rotations_of_cube(bool with_half_turns) {
    std::vector<Quaternion> rotations;
    for (int code = 0; code < 81; ++code) {
        Quaternion q{};
        for (int rest = code; double& component : q) {
            component = 1 - rest % 3;
            rest /= 3;
        }
        const auto zeros = std::ranges::count(q, 0.0);
        const double* const first = std::ranges::find_if(q, [](double component) { return component != 0.0; });
        if (zeros != 1 && zeros != 4 && *first > 0.0 && (with_half_turns || q[0] != 0.0)) {
            rotations.push_back(q);
        }
    }
    return rotations;
}

/// Near a limit of the middle angle, or on it; the outer angles are free.
void choose_near_lock(const Spec& spec, Draws& draws, std::span<double> angles) {
    const double half_turn = half_turn_in(spec.unit).hi;
    for (const std::size_t outer : {std::size_t{0}, std::size_t{2}}) {
        angles[outer] = half_turn * (spec.positive ? 2.0 * draws.fraction() : draws.signed_fraction());
    }
    const bool is_upper = draws.one_in(2);
    const double limit = !spec.sequence.proper() ? 0.5 * half_turn : is_upper ? half_turn : 0.0;
    const double margin = draws.one_in(8) ? 0.0 : draws.distance(limit == 0.0 ? deepest : deepest_near_1);
    angles[1] = limit == 0.0 ? margin : limit - margin * units_per_radian(spec.unit);
    angles[1] *= spec.sequence.proper() || is_upper ? 1.0 : -1.0;
}

void multiply(std::span<double> numbers, double factor) {
    std::ranges::transform(numbers, numbers.begin(), [factor](double number) { return factor * number; });
}

} // namespace

std::vector<SampleKind> sample_kinds_of(RepresentationId name) {
    using enum SampleKind;
    std::vector kinds{uniform, small, half_turn, lock, border, cube};
    if (codec_of(name).has_any_length) {
        kinds.push_back(scaled);
    } else if (codec_of(name).exact_defect != nullptr) {
        kinds.push_back(noise);
    } else if (representation(name).has_angles()) {
        kinds.push_back(many_turns);
    }
    return kinds;
}

Sampler::Sampler(const Spec& spec, SampleSettings settings)
    : conversion_(Spec{}, spec, {.tolerance = any_defect, .lock_margin = 0.0}), settings_(std::move(settings)),
      cube_(rotations_of_cube(representation(spec.name).has_half_turns)) {}

void Sampler::run(std::span<const double> rows, std::span<double> out) {
    check_size(out.size(), rows.size() * conversion_.to().size());
    attitudes_.clear();
    for (const double row : rows) {
        const auto q = attitude_of(static_cast<std::uint64_t>(row));
        attitudes_.insert(attitudes_.end(), q.begin(), q.end());
    }
    conversion_.run(attitudes_, out, reports_);
    const std::size_t size = conversion_.to().size();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        choose_numbers(static_cast<std::uint64_t>(rows[i]), out.subspan(i * size, size));
    }
}

Quaternion Sampler::attitude_of(std::uint64_t row) const {
    static const auto sequences = EulerSequence::all();
    const SampleKind kind = settings_.kinds[row % settings_.kinds.size()];
    const auto round = static_cast<std::size_t>(row / settings_.kinds.size());
    Draws draws(settings_.seed, row, false);
    const bool is_exact = draws.one_in(8) && representation(conversion_.to().name).has_half_turns;
    if (kind == SampleKind::cube) {
        return cube_[round % cube_.size()];
    }
    Quaternion q = kind == SampleKind::lock ? near_lock(draws, sequences.at(round % sequences.size()), is_exact)
                                            : draws.unit_quaternion();
    if (kind == SampleKind::small) { // the tangent of half of the angle
        multiply(std::span(q).subspan(1), draws.distance(deepest));
        q[0] = std::copysign(1.0, q[0]);
    } else if (kind == SampleKind::half_turn) { // of half of the distance
        q.at(1 + draws.below(3)) *= draws.one_in(4) ? 0.0 : 1.0;
        q[0] = std::copysign(is_exact ? 0.0 : draws.distance(deepest_cayley), q[0]) *
               std::sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    } else if (kind == SampleKind::border) {
        move_to_border(draws, q);
    }
    const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    std::ranges::transform(q, q.begin(), [norm](double component) { return component / norm; });
    return q;
}

void Sampler::choose_numbers(std::uint64_t row, std::span<double> numbers) const {
    const Spec& spec = conversion_.to();
    Draws draws(settings_.seed, row, true);
    switch (settings_.kinds[row % settings_.kinds.size()]) {
    case SampleKind::lock:
        if (representation(spec.name).has_gimbal_lock) {
            choose_near_lock(spec, draws, numbers);
        }
        break;
    case SampleKind::noise: {
        std::array<double, 9> noisy{};
        const auto drawn = std::span(noisy).first(numbers.size());
        const auto off = [&](double number) { return number + settings_.noise * draws.signed_fraction(); };
        do { // until there is an attitude
            std::ranges::transform(numbers, drawn.begin(), off);
        } while (!read_attitude(spec, drawn));
        std::ranges::copy(drawn, numbers.begin());
        break;
    }
    case SampleKind::scaled: multiply(numbers, draws.sign() * draws.of_size(-498, 497)); break; // 2^498 is 8e149
    case SampleKind::many_turns:
        if (representation(spec.name).angle_is_length) {
            multiply(numbers, draws.of_size(12, 40));
        } else { // all are angles, but for an axis
            std::ranges::generate(numbers.subspan(representation(spec.name).first_angle),
                                  [&] { return draws.sign() * draws.of_size(9, 48); });
        }
        break;
    default: break;
    }
}

} // namespace rotconv
