#pragma once

#include <cstdint>

#include "../representations/euler_formulas.hpp"
#include "careful_rows.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {

// Numbers that are exactly 0. No number of bits proves that sin a cos a - cos a sin a is 0, but the formulas are
// analytic functions of the numbers of a row: what is 0 in a row whose numbers have nothing to do with each other is 0
// in all rows with the same pattern, of numbers that are 0, and angles that are multiples of 90 or 15 degrees, which
// stay as they are (a test of identities, as Schwartz and Zippel have it for polynomials). Of matrices and axes the
// signs belong to it: with others, what is 0 may be another number (r11 = 1 and -1 in a turn about x).

enum : unsigned { code_of_zero = 0, code_of_any = 1, code_of_multiple = 2, code_of_negative = 2 }; // and up to 47 more

inline bool is_angle_in_degrees(const Spec* spec, const double* numbers, std::size_t k) noexcept {
    if (spec == nullptr || spec->unit != AngleUnit::degrees) {
        return false;
    }
    const Representation& entry = representation(spec->name);
    const bool is_component = entry.angle_is_length && (numbers[(k + 1) % 3] != 0.0 || numbers[(k + 2) % 3] != 0.0);
    return k >= entry.first_angle && !is_component;
}

/// The numbers of an attitude or of a vector as a pattern has them. Of angles multiples of `step` degrees, 90 or 15,
/// are known, and of matrices and axes the signs; with a step of 0 no angles.
class PartOfPattern {
public:
    PartOfPattern(const Spec* spec, const double* numbers, double step) noexcept
        : spec_(spec), numbers_(numbers), step_(step),
          has_angles_(spec != nullptr && spec->unit == AngleUnit::degrees && step > 0.0) {
        if (spec == nullptr) {
            return;
        }
        const Kernel& kernel = kernel_of(spec->name);
        is_matrix_ = kernel.column > 0;
        size_ = spec->size();
        signed_ = is_matrix_ ? size_ : representation(spec->name).first_angle;
        column_ = is_matrix_ ? kernel.column : size_; // each is of a size of its own
        for (std::size_t k = 0; k < size_ && is_matrix_; ++k) {
            small_[k / column_] = larger_of(small_[k / column_], 0x1p-8 * __builtin_fabs(numbers[k]));
        }
        hidden_sign_ = kernel.hidden_sign == nullptr ? 0U : kernel.hidden_sign(numbers);
    }

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] unsigned hidden_sign() const noexcept { return hidden_sign_; }
    [[nodiscard]] unsigned code(std::size_t k) const noexcept {
        const double number = numbers_[k];
        if (number == 0.0) {
            return code_of_zero;
        }
        if (has_sign(k)) {
            return number < 0.0 ? code_of_negative : code_of_any;
        }
        const double multiple = number / step_;
        if (!has_angles_ || !is_angle_in_degrees(spec_, numbers_, k) || !(__builtin_fabs(multiple) < 0x1p28)) {
            return code_of_any;
        }
        const auto whole = static_cast<int>(multiple);
        if (step_ * whole != number) {
            return code_of_any;
        }
        const int fifteens = whole * (step_ == 90.0 ? 6 : 1) % 48;
        return code_of_multiple + static_cast<unsigned>(fifteens < 0 ? fifteens + 48 : fifteens);
    }
    [[nodiscard]] bool is_known(std::size_t k, unsigned own_code) const noexcept {
        return own_code == code_of_zero || (own_code != code_of_any && !has_sign(k));
    }
    [[nodiscard]] unsigned bits(std::size_t k) const noexcept {
        return has_sign(k) ? 2U : has_angles_ && (size_ == 3 || k == 3) ? 6U : 1U;
    }
    /// Another number of the same code; of a matrix it is to stay near a rotation.
    [[nodiscard]] double stand_in(std::size_t k, double fraction) const noexcept {
        const double number = numbers_[k];
        if (is_known(k, code(k))) {
            return number;
        }
        const double other = 0.25 + 0.5 * fraction;
        if (!has_sign(k)) {
            return (has_angles_ ? 57.0 : 1.0) * other;
        }
        const bool is_large = is_matrix_ && __builtin_fabs(number) > small_[k / column_];
        return is_large ? number * (1.0 + 0x1p-12 * fraction)
                        : __builtin_copysign((is_matrix_ ? small_[k / column_] : 1.0) * other, number);
    }

private:
    [[nodiscard]] bool has_sign(std::size_t k) const noexcept { return k < signed_; }

    const Spec* spec_; ///< null of a vector
    const double* numbers_;
    double step_;
    bool has_angles_;
    bool is_matrix_ = false;
    unsigned hidden_sign_ = 0;
    std::size_t size_ = 3;
    std::size_t signed_ = 0; ///< so many of the numbers have their signs in it
    std::size_t column_ = 3;
    double small_[2] = {}; ///< entries of its columns up to here are small
};

/// The pattern of a row: the codes of its numbers, in 40 bits at most, with a second attitude between two in 59.
/// `all_known`: there is no other number in it.
inline std::uint64_t zero_pattern(const Task& task, const TaskNumbers& row, double step, bool& all_known) noexcept {
    all_known = task.fixed->left.count + task.fixed->right.count == 0;
    std::uint64_t pattern = task.lock_margin == LockLimit::at_lower   ? 1
                            : task.lock_margin == LockLimit::at_upper ? 2
                                                                      : 0;
    const auto add = [&](const PartOfPattern& part) {
        pattern = pattern << 1U | part.hidden_sign();
        for (std::size_t k = 0; k < part.size(); ++k) {
            const unsigned code = part.code(k);
            all_known = all_known && part.is_known(k, code);
            pattern = pattern << part.bits(k) | code;
        }
    };
    add({task.first, row.first, step});
    if (row.second != nullptr) {
        add({task.second, row.second, step});
    }
    if (row.later != nullptr) {
        add({task.second, row.later, step});
    }
    return pattern;
}

/// The task for other rows that are like a row: all locked, at the end where it is, for there angles are other
/// functions of a row; or, if it is not locked, none.
inline Task at_lock(const Task& task, DiagnosticSet diagnostics, double middle) noexcept {
    Task like = task;
    like.lock_margin = 0.0;
    if (diagnostics.has(DiagnosticKind::gimbal_lock)) {
        const AngleRanges ranges(FixedAxes(task.to->sequence), *task.to);
        like.lock_margin = middle == ranges.upper.hi ? LockLimit::at_upper : LockLimit::at_lower;
    }
    return like;
}

/// Other numbers of the same pattern.
inline void take_stand_ins(const PartOfPattern& part, std::size_t first, double* others) noexcept {
    constexpr double fractions[] = {0.6180339887498949, 0.7320508075688773, 0.2360679774997897, 0.4142135623730951,
                                    0.3166247903553998, 0.1231056256176605, 0.7958315233127196, 0.9160797830996161,
                                    0.5677643628300219, 0.8284271247461903, 0.4641016151377546, 0.6055512754639892,
                                    0.3588989435406736, 0.0717967697244908, 0.6904157598234297, 0.9487539562906138,
                                    0.1414284285428503, 0.5249378105604451, 0.7416573867739413, 0.8729833462074170,
                                    0.5825756949558400, 0.0990195135927845, 0.3851648071345040, 0.4772255750516610,
                                    0.7445626465380290, 0.8309518948453010, 0.4494897427831780};
    for (std::size_t k = 0; k < part.size(); ++k) {
        others[k] = part.stand_in(k, fractions[first + k]);
    }
}

constexpr int least = -400; // in size less than 2^least is 0

/// Whether numbers of a fixed rotation are so small that what comes of them may be.
inline bool has_tiny(const FixedSide& side) noexcept {
    bool found = false;
    for (std::size_t n = 0; n < side.count; ++n) {
        for (const double number : side.factors[n].numbers) {
            found = found || (number != 0.0 && __builtin_fabs(number) < 0x1p-60);
        }
        for (const double number : side.factors[n].rest) {
            found = found || number != 0.0;
        }
    }
    return found;
}

inline bool has_half_turns(const Task& task) noexcept {
    return task.to != nullptr && representation(task.to->name).has_gimbal_lock;
}

/// Bit k: the number k is 0, or an angle of half a turn, in all rows of the row's pattern; bit 16 + k: the component k
/// of the attitude is.
inline std::uint32_t zeros_of_stand_ins(const Task& task, const TaskNumbers& other,
                                        Careful (&results)[most_numbers]) noexcept {
    Careful q[4];
    std::uint32_t zeros = 0;
    if (has_tiny(task.fixed->left) || has_tiny(task.fixed->right)) {
        for (Careful& result : results) {
            result = __builtin_nan("");
        }
        return 0;
    }
    read_carefully(task, other, q);
    for (unsigned k = 0; k < 4; ++k) {
        if (q[k].is_below(least)) {
            q[k] = 0.0;
            zeros |= 1U << (16U + k);
        }
    }
    write_carefully(task, other, q, results);
    for (unsigned k = 0; k < task.out_size(); ++k) {
        const auto beyond = [&](double sign) {
            return results[k] + scaled(Wide::half_turn(task.to->unit == AngleUnit::degrees), sign);
        };
        if (results[k].is_below(least) ||
            (has_half_turns(task) && (beyond(1.0).is_below(least) || beyond(-1.0).is_below(least)))) {
            zeros |= 1U << k;
        }
    }
    return zeros;
}

/// Calls use(other row) of stand-ins, and with bits enough.
template <class Use>
auto with_stand_ins(const Task& task, const TaskNumbers& row, double step, const Use& use) noexcept {
    const Wide::Bits enough(640);
    double first[most_numbers];
    double second[most_numbers];
    double later[most_numbers];
    constexpr double fractions[] = {0.2718281828459045, 0.0, 0.0, 1.0, 0.0, 0.0};
    take_stand_ins({task.first, row.first, step}, 0, first);
    if (row.second != nullptr) {
        take_stand_ins({task.second, row.second, step}, 9, second);
    }
    if (row.later != nullptr) {
        take_stand_ins({task.second, row.later, step}, 18, later);
    }
    return use({first, row.second == nullptr ? nullptr : second, row.later == nullptr ? nullptr : later, fractions});
}
/// What is found for a pattern, in less than `bits` bits: from the table, or put there.
template <unsigned bits, class Find>
std::uint32_t remembered(std::uint64_t (&table)[ZeroTable::size], std::uint64_t pattern, const Find& find) noexcept {
    std::uint64_t* const entry = table + ((pattern * 0x9e3779b97f4a7c15U) >> 32U) % ZeroTable::size;
    std::uint64_t known = __atomic_load_n(entry, __ATOMIC_RELAXED);
    if ((known & 1U) == 0 || known >> bits != pattern) {
        known = pattern << bits | std::uint64_t{find()} << 1U | 1U;
        __atomic_store_n(entry, known, __ATOMIC_RELAXED);
    }
    return static_cast<std::uint32_t>(known & ((std::uint64_t{1} << bits) - 1)) >> 1U;
}

ROTCONV_NOINLINE inline std::uint32_t find_zeros(const Task& task, const TaskNumbers& row, double step) noexcept {
    return with_stand_ins(task, row, step, [&](const TaskNumbers& other) {
        Careful results[most_numbers];
        return zeros_of_stand_ins(task, other, results);
    });
}

/// The same, from the table.
inline std::uint32_t known_zeros(const Task& task, const TaskNumbers& row, std::uint64_t pattern,
                                 double step) noexcept {
    const auto find = [&] {
        const std::uint32_t zeros = find_zeros(task, row, step);
        return (zeros & 0x1ffU) | (zeros >> 16U) << 9U;
    };
    const std::uint32_t bits = task.zeros == nullptr ? find() : remembered<20>(task.zeros->entries, pattern, find);
    return (bits & 0x1ffU) | bits >> 9U << 16U;
}

/// Whether what these bits stand for is 0: in all rows of the wider pattern, in which there are fewer of them to know,
/// or in those of the narrower one. Numbers of angles that are all multiples of 15 degrees are algebraic, of a degree
/// of 8 at most: what is below 2^-66, as `are_small` says, is 0.
inline bool are_zeros(const Task& task, const TaskNumbers& row, std::uint64_t bits, bool are_small) noexcept {
    if (bits == 0) {
        return true;
    }
    bool all_known = false;
    if (row.later != nullptr) { // the way between two attitudes keeps no angle
        const std::uint64_t pattern = zero_pattern(task, row, 0.0, all_known);
        const bool has_room = pattern >> 44U == 0; // those of three matrices have none in the table
        return has_room && (bits & ~std::uint64_t{known_zeros(task, row, pattern, 0.0)}) == 0;
    }
    const std::uint64_t narrow = zero_pattern(task, row, 15.0, all_known);
    if (all_known && are_small) {
        return true;
    }
    const bool has_angles =
        task.first->unit == AngleUnit::degrees || (task.second != nullptr && task.second->unit == AngleUnit::degrees);
    const std::uint64_t wide = has_angles ? zero_pattern(task, row, 90.0, all_known) : narrow;
    return (bits & ~static_cast<std::uint64_t>(known_zeros(task, row, wide, 90.0))) == 0 ||
           (narrow != wide && (bits & ~static_cast<std::uint64_t>(known_zeros(task, row, narrow, 15.0))) == 0);
}

// Angles in degrees that are sums of those given, and of a multiple of 15 degrees, are often at the midpoint of two
// doubles, of which no number of bits tells. Whether they are such sums is told as zeros are.

/// One or two of the angles, each as it is or negative, and 15 degrees times so much less whole half-turns.
struct AngleSum {
    unsigned code; ///< 0: there is none

    static constexpr unsigned most_angles = 15; ///< 2 of each, and so much of a code
    static constexpr unsigned base = 2 * most_angles;
    [[nodiscard]] Careful of(const Careful* angles) const noexcept {
        const auto angle = [&](unsigned which) { return which % 2 == 0 ? angles[which / 2] : -angles[which / 2]; };
        const unsigned first = (code - 1) % base;
        const unsigned second = (code - 1) / base % base;
        return first == second ? angle(first) : angle(first) + angle(second);
    }
    [[nodiscard]] double constant() const noexcept {
        const unsigned multiple = (code - 1) / (base * base);
        return 15.0 * multiple;
    }
};

/// The angles of a row, or between two of its attitudes, and of the fixed rotations; how many there are.
inline unsigned angles_in_degrees(const Task& task, const TaskNumbers& row,
                                  Careful (&angles)[AngleSum::most_angles]) noexcept {
    unsigned count = 0;
    const auto add = [&](const Spec* spec, const double* numbers) {
        for (std::size_t k = 0; spec != nullptr && k < spec->size() && count < AngleSum::most_angles; ++k) {
            if (is_angle_in_degrees(spec, numbers, k)) {
                angles[count++] = numbers[k];
            }
        }
    };
    add(task.first, row.first);
    for (std::size_t k = 0; row.later != nullptr && k < task.second->size(); ++k) {
        if (is_angle_in_degrees(task.second, row.second, k) && is_angle_in_degrees(task.second, row.later, k)) {
            const double turns = __builtin_floor((row.later[k] - row.second[k]) / 360.0 + 0.5);
            const Careful way = Careful(row.later[k]) - Careful(row.second[k]) - Careful(360.0 * turns);
            angles[count++] = Careful(row.second[k]) + part_of_way<Careful>(row.fractions) * way;
        }
    }
    add(row.later == nullptr ? task.second : nullptr, row.second);
    for (const FixedSide* const side : {&task.fixed->left, &task.fixed->right}) {
        for (std::size_t k = 0; k < side->count; ++k) {
            add(&side->factors[k].spec, side->factors[k].numbers);
        }
    }
    return count;
}

/// The sum that the number k is, in all rows of the row's pattern, to whole half-turns and its sign.
ROTCONV_NOINLINE inline AngleSum find_sum(const Task& task, const TaskNumbers& row, unsigned k, double step) noexcept {
    return with_stand_ins(task, row, step, [&](const TaskNumbers& other) {
        Careful results[most_numbers];
        Careful angles[AngleSum::most_angles];
        zeros_of_stand_ins(task, other, results);
        const unsigned count = 2 * angles_in_degrees(task, other, angles);
        for (unsigned a = 0; a < count; ++a) {
            for (unsigned b = a; b < count; ++b) {
                const AngleSum sum{1 + a + AngleSum::base * b};
                const Careful rest = results[k] - sum.of(angles);
                const double fifteens = __builtin_floor(rest.rounded() / 15.0 + 0.5);
                if (__builtin_fabs(fifteens) < 0x1p28 && (rest - Careful(15.0 * fifteens)).is_below(least)) {
                    const auto whole = static_cast<unsigned>((static_cast<int>(fifteens) % 12 + 12) % 12);
                    return AngleSum{sum.code + AngleSum::base * AngleSum::base * whole};
                }
            }
        }
        return AngleSum{0};
    });
}

/// Replaces the angle k, which is near the number, by the sum that it is, rounded once; false where it is none, or
/// may be two.
inline bool round_sum(const Task& task, const TaskNumbers& row, unsigned k, double& number, double* rest,
                      std::size_t rest_size) noexcept {
    if (task.zeros == nullptr || task.to == nullptr || task.to->unit != AngleUnit::degrees ||
        __builtin_fabs(number) < 1e-6) {
        return false;
    }
    const Wide::Bits enough(1280);
    Careful angles[AngleSum::most_angles];
    if (angles_in_degrees(task, row, angles) == 0) {
        return false;
    }
    bool all_known = false;
    const double step = row.later == nullptr ? 90.0 : 0.0;
    const std::uint64_t pattern = zero_pattern(task, row, step, all_known) << 2U | k;
    if (pattern >> 49U != 0) { // the table has no room for it
        return false;
    }
    const AngleSum sum{remembered<15>(task.zeros->sums, pattern, [&] { return find_sum(task, row, k, step).code; })};
    if (sum.code == 0) {
        return false;
    }
    const Careful own = sum.of(angles) + Careful(sum.constant());
    bool fits = false;
    bool is_one = true;
    Careful angle;
    for (const double sign : {1.0, -1.0}) { // the angle of an axis, and the supplement of a middle one, change sign
        const double near = sign * own.rounded();
        const double turns = __builtin_floor((number - near) / 180.0 + 0.5);
        if (__builtin_fabs(near + 180.0 * turns - number) < 1e-6) {
            const Careful other = scaled(own, sign) + Careful(180.0 * turns);
            is_one = !fits || (other - angle).sign() == 0;
            angle = other;
            fits = true;
        }
    }
    double nearest = number;
    if (!fits || !is_one || !angle.round(nearest) || nearest <= -180.0 ||
        nearest >= 360.0) { // an end is another number
        return false;
    }
    number = nearest;
    for (std::size_t i = 0; i < rest_size; ++i) {
        angle = angle - Careful(nearest);
        nearest = angle.sign() == 0 ? -0.0 : angle.rounded();
        rest[i] = nearest;
    }
    return true;
}

/// A row with the bits that there are, to numbers, to what they leave, which may be null, in `rest_size` doubles for
/// each, and to the attitude; whether the numbers are decided.
inline bool answer_once(const Task& task, const TaskNumbers& row, double* numbers, double* rest, std::size_t rest_size,
                        std::size_t place, AttitudeBatch<double>& attitudes, DiagnosticSet& diagnostics) noexcept {
    const auto is_zero = [&](const Task& which, unsigned bit) {
        return are_zeros(which, row, std::uint64_t{1} << bit, false);
    };
    Careful q[4];
    Careful results[most_numbers];
    read_carefully(task, row, q);
    for (unsigned k = 0; k < 4; ++k) {
        if (q[k].may_be_zero() && is_zero(at_lock(task, {}, 0.0), 16 + k)) {
            q[k] = 0.0;
        }
    }
    set_rounded(q, place, attitudes);
    diagnostics = write_carefully(task, row, q, results);
    const Task own = at_lock(task, diagnostics, results[1].rounded());
    bool decided = true;
    for (unsigned k = 0; k < task.out_size(); ++k) {
        if (results[k].may_be_zero() && is_zero(own, k)) {
            results[k] = 0.0;
        }
        decided = results[k].round(numbers[k]) && decided;
        // Less than a double tells may be beyond the range.
        if (has_half_turns(task) && k != 1 && !task.to->positive) {
            numbers[k] = -larger_of(-numbers[k], -half_turn_in(task.to->unit).hi);
        }
        double written = numbers[k];
        for (std::size_t i = 0; i < rest_size && rest != nullptr; ++i) {
            const bool is_finite = __builtin_fabs(written) < __builtin_inf();
            results[k] = is_finite ? results[k] - Careful(written) : Careful(0.0);
            written = results[k].rounded();
            rest[k * rest_size + i] = written;
        }
    }
    return decided;
}

/// The same with as many bits as it takes.
ROTCONV_NOINLINE inline DiagnosticSet answer_carefully(const Task& task, const TaskNumbers& row, double* numbers,
                                                       double* rest, std::size_t place,
                                                       AttitudeBatch<double>& attitudes) noexcept {
    DiagnosticSet diagnostics;
    with_enough_bits([&] { return answer_once(task, row, numbers, rest, 1, place, attitudes, diagnostics); });
    return diagnostics;
}

/// Whether a row of the batch kernels is decided: of its numbers only those are in doubt, see doubt_of(), that are
/// exactly 0, or a sum, which they become.
inline bool settle(const Task& general, const TaskNumbers& row, DiagnosticSet diagnostics, std::uint64_t doubts,
                   double* numbers, double* rest) noexcept {
    const Task task = at_lock(general, diagnostics, numbers[1]);
    constexpr std::uint64_t about_zeros = other_doubt - 1;
    if ((doubts & other_doubt) != 0 || !are_zeros(task, row, doubts & about_zeros, true)) {
        return false;
    }
    for (unsigned k = 0; k < most_numbers; ++k) {
        double left = 0.0;
        if ((doubts >> (32U + k) & 1U) != 0 &&
            !round_sum(task, row, k, numbers[k], rest == nullptr ? &left : rest + k, 1)) {
            return false;
        }
    }
    for (std::size_t k = 0; k < most_numbers; ++k) {
        if ((doubts >> k & 1U) != 0) {
            numbers[k] = 0.0;
            if (rest != nullptr) {
                rest[k] = -0.0;
            }
        }
    }
    if (task.to != nullptr && kernel_of(task.to->name).is_quaternion) {
        const double sign = canonical_sign<double>({numbers[0], numbers[1], numbers[2], numbers[3]});
        for (std::size_t k = 0; k < 4; ++k) {
            numbers[k] = sign * numbers[k] + 0.0;
        }
    }
    return true;
}

} // namespace ROTCONV_TARGET
} // namespace rotconv
