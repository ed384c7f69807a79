#include "elementary.hpp"

#include <cstdint>
#include <type_traits>

#include "power_of_two.hpp"

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

constexpr TurnTable turn_table;
constexpr ArcTangentTable arc_tangent_table;

/// The binary digits of 1/pi behind the point.
constexpr std::uint64_t inverse_of_pi[] = {
    0x517cc1b727220a94U, 0xfe13abe8fa9a6ee0U, 0x6db14acc9e21c820U, 0xff28b1d5ef5de2b0U, 0xdb92371d2126e970U,
    0x0324977504e8c90eU, 0x7f0ef58e5894d39fU, 0x74411afa975da242U, 0x74ce38135a2fbf20U, 0x9cc8eb1cc1a99cfaU,
    0x4e422fc5defc941dU, 0x8ffc4bffef02cc07U, 0xf79788c5ad05368fU, 0xb69b3f6793e584dbU, 0xa7a31fb34f2ff516U,
    0xba93dd63f5f2f8bdU, 0x9e839cfbc5294975U, 0x35fdafd88fc6ae84U, 0x2b0198237e3db5d5U, 0xf867de104d7a1b0eU,
    0xd4f1c8b0af730d84U, 0x32ccc2af8a503420U};

/// pi/64 in four parts.
constexpr double step_parts[] = {0x1.921fb54442d18p-5, 0x1.1a62633145c07p-59, -0x1.f1976b7ed8fbcp-115,
                                 0x1.4cf98e804177dp-169};
constexpr DoubleDouble step{step_parts[0], step_parts[1]};

/// Added and taken off again, it rounds a double below 2^51 to a whole number.
constexpr double rounding = 0x1.8p52;

/// a - b c, where that is exact, as is a less the rounded product.
ROTCONV_INLINE double exact_difference(double a, double b, double c) noexcept {
#if ROTCONV_HAS_FMA
    return __builtin_fma(-b, c, a);
#else
    const DoubleDouble product = two_prod(b, c);
    return (a - product.hi) - product.lo;
#endif
}

/// An angle as so many steps of pi/64, of which 128, a turn, are taken off at will, and a rest in radians of at most
/// half a step, or a little more.
struct Steps {
    double count;
    DoubleDouble rest;
};

/// Valid range: angles below 2^12. The product of the count with each part of pi/64 is exact.
ROTCONV_INLINE Steps steps_in_radians(DoubleDouble angle, DoubleDouble /*scalar*/) noexcept {
    const double count = (angle.hi * 0x1.45f306dc9c883p+4 + rounding) - rounding;
    const DoubleDouble first = two_prod(count, step_parts[0]);
    const DoubleDouble second = two_prod(count, -step_parts[1]);
    const DoubleDouble third = two_prod(count, -step_parts[2]);
    // the first difference is exact: its operands are within a factor of two of each other, or the count is 0
    const DoubleDouble near = two_sum(angle.hi - first.hi, -first.lo) + second;
    return {count, (near + angle.lo) + (third + count * -step_parts[3])};
}

/// The same to 2^-100 or, where more than 40 digits cancel, as many fewer.
template <class T> ROTCONV_INLINE Steps steps_in_radians(DoubleDouble angle, T /*scalar*/) noexcept {
    const double count = (angle.hi * 0x1.45f306dc9c883p+4 + rounding) - rounding;
    // exact: where the count is not 0 all are multiples of 2^-58, and the rest is below 2^-5
    const double near = exact_difference(angle.hi, count, step_parts[0]);
    const DoubleDouble rest = sloppy_sum(DoubleDouble(near), two_prod(count, -step_parts[1]));
    return {count, fast_two_sum(rest.hi, rest.lo + (angle.lo + count * -step_parts[2]))};
}

/// Valid range: angles below 2^44. A step is 2.8125 degrees, of which multiples are doubles.
ROTCONV_INLINE Steps steps_in_degrees(DoubleDouble angle) noexcept {
    constexpr double step_in_degrees = 2.8125;
    const double count = (angle.hi * (1.0 / step_in_degrees) + rounding) - rounding;
    const double rest = angle.hi - count * step_in_degrees;
    return {count, two_sum(rest, angle.lo) * exact_radians_per_degree};
}

/// Valid range: any double of 1 or more. Takes the digits of angle/(2 pi) behind the point, by way of 320 digits of
/// 1/pi (Payne and Hanek 1983).
Steps steps_in_large_radians(double angle) noexcept {
    const Binary binary(angle);
    constexpr int words = 5;
    std::uint64_t fraction[words]; // of 1/(2 pi) times 2^exponent, in words of falling weight
    for (int i = 0; i < words; ++i) {
        const int first = binary.exponent - 1 + 64 * i; // the place of the word's first digit, from 0
        const int word = (first + 64) / 64 - 1;         // first / 64, rounded down
        const auto shift = static_cast<unsigned>(first - 64 * word);
        const std::uint64_t high = word < 0 ? 0 : inverse_of_pi[word];
        // NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): it has all
        const std::uint64_t low = inverse_of_pi[word + 1];
        fraction[i] = shift == 0 ? high : (high << shift) | (low >> (64U - shift));
    }
    __extension__ using Uint128 = unsigned __int128;
    std::uint64_t carry = 0; // what it is at the end is whole turns
    for (int i = words - 1; i >= 0; --i) {
        const Uint128 product = static_cast<Uint128>(fraction[i]) * binary.digits + carry;
        fraction[i] = static_cast<std::uint64_t>(product);
        carry = static_cast<std::uint64_t>(product >> 64U);
    }
    const auto count = static_cast<double>(((fraction[0] >> 1U) + (std::uint64_t{1} << 55U)) >> 56U);
    DoubleDouble rest = 0.0; // in steps, from half a step below 0 on
    for (int i = words - 1; i >= 0; --i) {
        const std::uint64_t word = (fraction[i] << 7U) | (i + 1 < words ? fraction[i + 1] >> 57U : 0U);
        const double high =
            i == 0 ? static_cast<double>(static_cast<std::int64_t>(word) >> 32U) : static_cast<double>(word >> 32U);
        rest =
            rest + scaled(two_sum(high * 0x1p32, static_cast<double>(word & 0xffffffffU)), power_of_two(-64 * (i + 1)));
    }
    rest = rest * step;
    return binary.is_negative ? Steps{-count, -rest} : Steps{count, rest};
}

Steps steps_in_large(DoubleDouble angle, AngleUnit unit) noexcept {
    if (!(__builtin_fabs(angle.hi) <= 0x1.fffffffffffffp1023)) {
        return {0.0, angle.hi - angle.hi}; // nan
    }
    if (unit == AngleUnit::degrees) {
        // each part alone, exactly, then the sum, which may be a turn more
        return steps_in_degrees(two_sum(__builtin_fmod(angle.hi, 360.0), __builtin_fmod(angle.lo, 360.0)));
    }
    const Steps high = steps_in_large_radians(angle.hi);
    const Steps low =
        __builtin_fabs(angle.lo) >= 1.0 ? steps_in_large_radians(angle.lo) : steps_in_radians(angle.lo, DoubleDouble());
    return {high.count + low.count, high.rest + low.rest};
}

/// Valid range: any angle.
template <class T> ROTCONV_INLINE Steps steps_of_any(DoubleDouble angle, AngleUnit unit, T scalar) noexcept {
    const bool in_degrees = unit == AngleUnit::degrees;
    if (!(__builtin_fabs(angle.hi) < (in_degrees ? 0x1p44 : 0x1p12))) [[unlikely]] {
        return steps_in_large(angle, unit);
    }
    return in_degrees ? steps_in_degrees(angle) : steps_in_radians(angle, scalar);
}

/// Taylor's series of an angle up to 0.05: the sine and the cosine less 1, in full length as far as the digits of a
/// double would not do.
ROTCONV_INLINE SineCosine<DoubleDouble> small_sine_cosine(DoubleDouble angle) noexcept {
    const DoubleDouble s = angle * angle;
    const double sine_tail =
        0x1.71de3a556c734p-19 +
        s.hi * (-0x1.ae64567f544e4p-26 + s.hi * (0x1.6124613a86d09p-33 + s.hi * -0x1.ae7f3e733b81fp-41));
    const DoubleDouble sine_3 = sloppy_sum_ordered({-0x1.a01a01a01a01ap-13, -0x1.a01a01a01a01ap-73}, s.hi * sine_tail);
    const DoubleDouble sine_2 = sloppy_sum_ordered({0x1.1111111111111p-7, 0x1.1111111111111p-63}, s * sine_3);
    const DoubleDouble sine_1 = sloppy_sum_ordered({-0x1.5555555555555p-3, -0x1.5555555555555p-57}, s * sine_2);
    const double cosine_tail =
        0x1.a01a01a01a01ap-16 +
        s.hi * (-0x1.27e4fb7789f5cp-22 + s.hi * (0x1.1eed8eff8d898p-29 + s.hi * -0x1.93974a8c07c9dp-37));
    const DoubleDouble cosine_3 =
        sloppy_sum_ordered({-0x1.6c16c16c16c17p-10, 0x1.f49f49f49f49fp-65}, s.hi * cosine_tail);
    const DoubleDouble cosine_2 = sloppy_sum_ordered({0x1.5555555555555p-5, 0x1.5555555555555p-59}, s * cosine_3);
    const DoubleDouble cosine_1 = sloppy_sum_ordered(-0.5, s * cosine_2);
    return {sloppy_sum_ordered(angle, angle * (s * sine_1)), sloppy_sum_ordered(1.0, s * cosine_1)};
}

/// The sine and cosine of a sum, from those of the steps and the rest.
ROTCONV_INLINE SineCosine<DoubleDouble> turned(const SineCosine<DoubleDouble>& steps, DoubleDouble rest,
                                               DoubleDouble /*scalar*/) noexcept {
    const SineCosine<DoubleDouble> small = small_sine_cosine(rest);
    return {sloppy_sum(steps.sine * small.cosine, steps.cosine * small.sine),
            sloppy_sum(steps.cosine * small.cosine, -(steps.sine * small.sine))};
}

/// Only what is beside the steps' own sine and cosine is rounded.
ROTCONV_INLINE SineCosine<double> turned(const SineCosine<DoubleDouble>& steps, DoubleDouble rest,
                                         double /*scalar*/) noexcept {
    const double r = rest.hi;
    const SmallAngle small(r);
    const double beyond = rest.lo + small.sine_rest;
    const double less = small.cosine_less_1;
    const double sine = steps.sine.hi;
    const double cosine = steps.cosine.hi;
    return {sine + (cosine * r + (steps.sine.lo + (cosine * beyond + sine * less))),
            cosine + ((steps.cosine.lo - sine * beyond) + (cosine * less - sine * r))};
}

/// With u = 2^-53 and r <= pi/128: the term of the third degree, r^3/6, is rounded four times, and its sum with the low
/// parts three times. So the vector of cosine and sine is off by 7u r^3/6 <= 0x1.3p-69. Where the sine or the cosine is
/// nearest to 0, but not r alone, it is of size r, and off by 7u r^2/6 <= 2^-63 of itself.
ROTCONV_INLINE SineCosine<Approximate> turned(const SineCosine<DoubleDouble>& steps, DoubleDouble rest,
                                              Approximate /*scalar*/) noexcept {
    const double r = rest.hi;
    const DoubleDouble z = two_prod(r, r);
    const double sine_3 = __builtin_fma(z.hi, 0x1.71de3a556c734p-19, -0x1.a01a01a01a01ap-13);
    const double sine_1 = __builtin_fma(z.hi, __builtin_fma(z.hi, sine_3, 0x1.1111111111111p-7), -0x1.5555555555555p-3);
    const double cosine_3 = __builtin_fma(z.hi, 0x1.a01a01a01a01ap-16, -0x1.6c16c16c16c17p-10);
    const double cosine_2 = __builtin_fma(z.hi, cosine_3, 0x1.5555555555555p-5);
    const Approximate sine{r, __builtin_fma(r * z.hi, sine_1, rest.lo)};
    const Approximate less{-0.5 * z.hi, __builtin_fma(z.hi * z.hi, cosine_2, -__builtin_fma(r, rest.lo, 0.5 * z.lo))};
    // a + a less + b sine, a the larger or 0
    const auto sum = [&](DoubleDouble a, DoubleDouble b) {
        const DoubleDouble first = two_prod(b.hi, sine.hi);
        const DoubleDouble second = two_prod(a.hi, less.hi);
        const DoubleDouble one = fast_two_sum(a.hi, first.hi);
        const DoubleDouble two = fast_two_sum(one.hi, second.hi);
        const double low =
            __builtin_fma(b.hi, sine.lo, b.lo * sine.hi) + (a.lo + __builtin_fma(a.hi, less.lo, a.lo * less.hi));
        return normalized({two.hi, ((one.lo + two.lo) + (first.lo + second.lo)) + low});
    };
    return {sum(steps.sine, steps.cosine), sum(steps.cosine, -steps.sine)};
}

ROTCONV_INLINE const SineCosine<DoubleDouble>& sine_cosine_of_steps(double count) noexcept {
    return turn_table.values[static_cast<unsigned>(static_cast<std::int64_t>(count)) & 127U];
}

/// A tangent's numerator and denominator, of an angle of at most an eighth of a turn, and how many steps of 1/64 are in
/// it.
template <class T> struct Tangent {
    T near, far;
    double count;
};

template <class T> ROTCONV_INLINE Tangent<T> tangent_from_nearer_axis(T x, T y) noexcept {
    const T x_size = select(to_double(x) < 0.0, -x, x);
    const T y_size = select(to_double(y) < 0.0, -y, y);
    const bool flat = is_at_most(y_size, x_size);
    const T near = select(flat, y_size, x_size);
    const T far = select(flat, x_size, y_size);
    const T divisor = select(to_double(far) == 0.0, T(1.0), far);
    return {near, divisor, (to_double(near) / to_double(divisor) * 64.0 + rounding) - rounding};
}

/// A tangent's square in the series of the angle, or 0 where the angle is the tangent in all digits.
ROTCONV_INLINE double counting(double tangent) noexcept { return __builtin_fabs(tangent) < 0x1p-200 ? 0.0 : tangent; }
ROTCONV_INLINE DoubleDouble counting(DoubleDouble tangent) noexcept {
    return select(__builtin_fabs(tangent.hi) < 0x1p-200, DoubleDouble(), tangent);
}

/// The arc tangent of what is left of a tangent after its steps: (near - far c)/(far + near c).
ROTCONV_INLINE DoubleDouble rest_of_arc_tangent(const Tangent<DoubleDouble>& t) noexcept {
    const double c = t.count * 0x1p-6;
    const DoubleDouble tangent = sloppy_sum(t.near, t.far * -c) / sloppy_sum_ordered(t.far, t.near * c);
    const DoubleDouble s = square(counting(tangent));
    const double tail =
        0x1.c71c71c71c71cp-4 +
        s.hi * (-0x1.745d1745d1746p-4 +
                s.hi * (0x1.3b13b13b13b14p-4 + s.hi * (-0x1.1111111111111p-4 + s.hi * 0x1.e1e1e1e1e1e1ep-5)));
    const DoubleDouble third = sloppy_sum_ordered({-0x1.2492492492492p-3, -0x1.2492492492492p-57}, s.hi * tail);
    const DoubleDouble second = sloppy_sum_ordered({0x1.999999999999ap-3, -0x1.999999999999ap-57}, s * third);
    const DoubleDouble first = sloppy_sum_ordered({-0x1.5555555555555p-2, -0x1.5555555555555p-56}, s * second);
    return sloppy_sum_ordered(tangent, tangent * (s * first));
}
ROTCONV_INLINE DoubleDouble rest_of_arc_tangent(const Tangent<double>& t) noexcept {
    const double c = t.count * 0x1p-6;
    const double tangent = exact_difference(t.near, t.far, c) / (t.far + t.near * c);
    const double s = square(counting(tangent));
    return {tangent, tangent * s *
                         (-0x1.5555555555555p-2 +
                          s * (0x1.999999999999ap-3 + s * (-0x1.2492492492492p-3 + s * 0x1.c71c71c71c71cp-4)))};
}
/// With the part beside the tangent's double only as a double, s = t^2:
///     atan(t + rest) = t + (rest (1 - s) + t s (-1/3 + s/5 - s^2/7 + s^3/9))
/// For |t| <= 2^-7 the series ends 2^-73 |t| early. The term of the third degree is below 2^-15.5 |t|, and rounded five
/// times, with its sum: to 2^-66 |t| in all, and |t| is at most the angle.
ROTCONV_INLINE DoubleDouble rest_of_arc_tangent(const Tangent<Approximate>& t) noexcept {
    const double c = t.count * 0x1p-6;
    const double near = __builtin_fma(-c, t.far.hi, t.near.hi); // exact: c has 7 bits, and this is below far/64
    const double far = __builtin_fma(c, t.near.hi, t.far.hi);
    const double far_low = __builtin_fma(c, t.near.hi, t.far.hi - far) + __builtin_fma(c, t.near.lo, t.far.lo);
    const double inverse = 1.0 / far;
    const double tangent = near * inverse;
    const double near_low = __builtin_fma(-tangent, far, near) + __builtin_fma(-c, t.far.lo, t.near.lo);
    const double low = __builtin_fma(-tangent, far_low, near_low) * inverse;
    const double s = tangent * tangent;
    const double third = __builtin_fma(s, 0x1.c71c71c71c71cp-4, -0x1.2492492492492p-3);
    const double first = __builtin_fma(s, __builtin_fma(s, third, 0x1.999999999999ap-3), -0x1.5555555555555p-2);
    return {tangent, __builtin_fma(tangent * s, first, __builtin_fma(-low, s, low))};
}

/// The angle of (x, y), from the one that is counted from the nearer axis.
template <class T>
ROTCONV_INLINE DoubleDouble from_x_axis(T x, T y, DoubleDouble acute, DoubleDouble half_turn) noexcept {
    const T x_size = select(to_double(x) < 0.0, -x, x);
    const T y_size = select(to_double(y) < 0.0, -y, y);
    const bool flat = is_at_most(y_size, x_size);
    const bool back = to_double(x) < 0.0;
    // from 0, from a half-turn backwards, or from a quarter turn either way
    const double halves = flat ? (back ? 1.0 : 0.0) : 0.5;
    const DoubleDouble angle = sloppy_sum_ordered(scaled(half_turn, halves), scaled(acute, flat == back ? -1.0 : 1.0));
    return scaled(angle, to_double(y) < 0.0 ? -1.0 : 1.0);
}

ROTCONV_INLINE DoubleDouble arc_tangent_of_steps(double count) noexcept {
    return arc_tangent_table.values[static_cast<std::int64_t>(count <= 64.0 ? count : 0.0)]; // it may be nan
}

/// An angle or a tangent below this is its sine or its arc tangent in all 106 digits.
constexpr double linear = 0x1p-110;

ROTCONV_INLINE bool is_nearly_0(DoubleDouble value) noexcept { return __builtin_fabs(value.hi) < linear; }

} // namespace

template <class T> SineCosine<T> sine_cosine(DoubleDouble angle, AngleUnit unit) noexcept {
    if (is_nearly_0(angle)) { // its products may underflow
        const DoubleDouble sine = scaled(angle, 0x1p300) * unit_in_radians(unit);
        return {rounded_to<T>(scaled(sine, 0x1p-300)), T(1.0)};
    }
    const Steps steps = steps_of_any(angle, unit, T());
    return turned(sine_cosine_of_steps(steps.count), steps.rest, T());
}

SineCosine<double> half_sine_cosine(DoubleDouble angle) noexcept {
    const double count = (angle.hi * 0x1.45f306dc9c883p+3 + rounding) - rounding;
    const DoubleDouble second = two_prod(count, -step_parts[1]);
    const DoubleDouble rest = two_sum(exact_difference(0.5 * angle.hi, count, step_parts[0]), second.hi);
    const SineCosine<double> both =
        turned(sine_cosine_of_steps(count), {rest.hi, rest.lo + (second.lo + 0.5 * angle.lo)}, 0.0);
    return {alone(both.sine), alone(both.cosine)};
}

template <class T> void sine_cosine(const Column<DoubleDouble>& angles, std::size_t rows, AngleUnit unit,
                                    Column<T>& cosines, Column<T>& sines) noexcept {
    double count[batch_rows];
    Column<DoubleDouble> rest;
    const double largest = unit == AngleUnit::degrees ? 0x1p44 : 0x1p12;
    const auto set = [&](std::size_t i, const Steps& steps) {
        count[i] = steps.count;
        rest.set(i, steps.rest);
    };
    if (unit == AngleUnit::degrees) {
        for (std::size_t i = 0; i < rows; ++i) {
            set(i, steps_in_degrees(angles[i]));
        }
    } else {
        for (std::size_t i = 0; i < rows; ++i) {
            set(i, steps_in_radians(angles[i], T()));
        }
    }
    const auto is_in_range = [largest](double angle) { return __builtin_fabs(angle) < largest; };
    const bool are_in_range = all(angles.hi, rows, is_in_range);
    for (std::size_t i = 0; i < rows && !are_in_range; ++i) {
        if (!is_in_range(angles.hi[i])) {
            set(i, steps_in_large(angles[i], unit));
        }
    }
    Column<DoubleDouble> cosine_of_steps;
    Column<DoubleDouble> sine_of_steps;
    for (std::size_t i = 0; i < rows; ++i) {
        const SineCosine<DoubleDouble>& steps = sine_cosine_of_steps(count[i]);
        sine_of_steps.set(i, steps.sine);
        cosine_of_steps.set(i, steps.cosine);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const SineCosine<T> both = turned(SineCosine<DoubleDouble>{sine_of_steps[i], cosine_of_steps[i]}, rest[i], T());
        cosines.set(i, both.cosine);
        sines.set(i, both.sine);
    }
}

template <class T> DoubleDouble angle_of(T x, T y, AngleUnit unit) noexcept {
    const Tangent<T> tangent = tangent_from_nearer_axis(x, y);
    if (to_double(tangent.near) != 0.0 && to_double(tangent.near) < linear * to_double(tangent.far)) {
        return rounded_parts(angle_of(Wide(x), Wide(y), unit));
    }
    const DoubleDouble acute = sloppy_sum_ordered(arc_tangent_of_steps(tangent.count), rest_of_arc_tangent(tangent));
    const DoubleDouble in_unit = unit == AngleUnit::degrees ? acute * exact_degrees_per_radian : acute;
    return from_x_axis(x, y, in_unit, half_turn_in(unit));
}

DoubleDouble acute_angle(double x, double y) noexcept {
    const bool flat = y <= x;
    const double near = flat ? y : x;
    const double far = flat ? x : y;
    const double nearest = (near / far + 0x1p-6 * rounding) - 0x1p-6 * rounding; // multiple of 1/64
    const DoubleDouble steps = arc_tangent_of_steps(64.0 * nearest);
    const double t = exact_difference(near, far, nearest) / (far + near * nearest);
    const double s = t * t;
    const double beyond = (t * s) * ((-0x1.5555555555555p-2 + s * 0x1.999999999999ap-3) +
                                     (s * s) * (-0x1.2492492492492p-3 + s * 0x1.c71c71c71c71cp-4));
    if (flat) {
        const DoubleDouble sum = fast_two_sum(steps.hi, t);
        return {sum.hi, (sum.lo + steps.lo) + beyond};
    }
    const DoubleDouble quarter = fast_two_sum(0.5 * exact_pi.hi, -steps.hi);
    const DoubleDouble sum = fast_two_sum(quarter.hi, -t);
    return {sum.hi, (sum.lo + (quarter.lo + (0.5 * exact_pi.lo - steps.lo))) - beyond};
}

template <class T> void angles_of(const Column<T>& x, const Column<T>& y, std::size_t rows, AngleUnit unit,
                                  Column<DoubleDouble>& angles) noexcept {
    Column<T> near;
    Column<T> far;
    Column<DoubleDouble> acute;
    double count[batch_rows];
    for (std::size_t i = 0; i < rows; ++i) {
        const Tangent<T> tangent = tangent_from_nearer_axis<T>(x[i], y[i]);
        near.set(i, tangent.near);
        far.set(i, tangent.far);
        count[i] = tangent.count;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        acute.set(i, arc_tangent_of_steps(count[i]));
    }
    for (std::size_t i = 0; i < rows; ++i) {
        acute.set(i, sloppy_sum_ordered(acute[i], rest_of_arc_tangent(Tangent<T>{near[i], far[i], count[i]})));
    }
    if (unit == AngleUnit::degrees) {
        for (std::size_t i = 0; i < rows; ++i) {
            acute.set(i, acute[i] * exact_degrees_per_radian);
        }
    }
    const DoubleDouble half_turn = half_turn_in(unit);
    for (std::size_t i = 0; i < rows; ++i) {
        angles.set(i, from_x_axis<T>(x[i], y[i], acute[i], half_turn));
    }
}

#define ROTCONV_FOR_SCALAR(T)                                                                                          \
    template SineCosine<T> sine_cosine(DoubleDouble, AngleUnit) noexcept;                                              \
    template void sine_cosine(const Column<DoubleDouble>&, std::size_t, AngleUnit, Column<T>&, Column<T>&) noexcept;   \
    template DoubleDouble angle_of(T, T, AngleUnit) noexcept;                                                          \
    template void angles_of(const Column<T>&, const Column<T>&, std::size_t, AngleUnit, Column<DoubleDouble>&) noexcept;
ROTCONV_FOR_SCALAR(double)
ROTCONV_FOR_SCALAR(DoubleDouble)
#undef ROTCONV_FOR_SCALAR
template void sine_cosine(const Column<DoubleDouble>&, std::size_t, AngleUnit, Column<Approximate>&,
                          Column<Approximate>&) noexcept;
template void angles_of(const Column<Approximate>&, const Column<Approximate>&, std::size_t, AngleUnit,
                        Column<DoubleDouble>&) noexcept;

} // namespace ROTCONV_TARGET
} // namespace rotconv
