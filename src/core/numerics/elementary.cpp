#include "elementary.hpp"

#include <cstdint>

namespace rotconv {
inline namespace ROTCONV_TARGET {
namespace {

/// sin(k pi/64) for k = 0 ... 32.
constexpr double sine_table[33][2] = {{0.0, 0.0},
                                      {0x1.91f65f10dd814p-5, -0x1.912bd0d569a9p-61},
                                      {0x1.917a6bc29b42cp-4, -0x1.e2718d26ed688p-60},
                                      {0x1.2c8106e8e613ap-3, 0x1.13000a89a11ep-58},
                                      {0x1.8f8b83c69a60bp-3, -0x1.26d19b9ff8d82p-57},
                                      {0x1.f19f97b215f1bp-3, -0x1.42deef11da2c4p-57},
                                      {0x1.294062ed59f06p-2, -0x1.5d28da2c4612dp-56},
                                      {0x1.58f9a75ab1fddp-2, -0x1.efdc0d58cf62p-62},
                                      {0x1.87de2a6aea963p-2, -0x1.72cedd3d5a61p-57},
                                      {0x1.b5d1009e15ccp-2, 0x1.5b362cb974183p-57},
                                      {0x1.e2b5d3806f63bp-2, 0x1.e0d891d3c6841p-58},
                                      {0x1.073879922ffeep-1, -0x1.a5a014347406cp-55},
                                      {0x1.1c73b39ae68c8p-1, 0x1.b25dd267f66p-55},
                                      {0x1.30ff7fce17035p-1, -0x1.efcc626f74a6fp-57},
                                      {0x1.44cf325091dd6p-1, 0x1.8076a2cfdc6b3p-57},
                                      {0x1.57d69348cecap-1, -0x1.75720992bfbb2p-55},
                                      {0x1.6a09e667f3bcdp-1, -0x1.bdd3413b26456p-55},
                                      {0x1.7b5df226aafafp-1, -0x1.0f537acdf0ad7p-56},
                                      {0x1.8bc806b151741p-1, -0x1.2c5e12ed1336dp-55},
                                      {0x1.9b3e047f38741p-1, -0x1.30ee286712474p-55},
                                      {0x1.a9b66290ea1a3p-1, 0x1.9f630e8b6dac8p-60},
                                      {0x1.b728345196e3ep-1, -0x1.bc69f324e6d61p-55},
                                      {0x1.c38b2f180bdb1p-1, -0x1.6e0b1757c8d07p-56},
                                      {0x1.ced7af43cc773p-1, -0x1.e7b6bb5ab58aep-58},
                                      {0x1.d906bcf328d46p-1, 0x1.457e610231ac2p-56},
                                      {0x1.e212104f686e5p-1, -0x1.014c76c126527p-55},
                                      {0x1.e9f4156c62ddap-1, 0x1.760b1e2e3f81ep-55},
                                      {0x1.f0a7efb9230d7p-1, 0x1.52c7adc6b4989p-56},
                                      {0x1.f6297cff75cbp-1, 0x1.562172a361fd3p-56},
                                      {0x1.fa7557f08a517p-1, -0x1.7a0a8ca13571fp-55},
                                      {0x1.fd88da3d12526p-1, -0x1.87df6378811c7p-55},
                                      {0x1.ff621e3796d7ep-1, -0x1.c57bc2e24aa15p-57},
                                      {0x1p+0, 0.0}};

/// atan(k/64) for k = 0 ... 64.
constexpr double arc_tangent_table[65][2] = {{0.0, 0.0},
                                             {0x1.fff555bbb729bp-7, -0x1.220c39d4dff5p-61},
                                             {0x1.ffd55bba97625p-6, -0x1.5ec431444912cp-60},
                                             {0x1.7fb818430da2ap-5, -0x1.86ef8f794f105p-63},
                                             {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
                                             {0x1.3f59f0e7c559dp-4, 0x1.ac4ce285df847p-58},
                                             {0x1.7ee182602f10fp-4, -0x1.cfb654c0c3d98p-58},
                                             {0x1.be39ebe6f07c3p-4, 0x1.f7b8f29a05987p-58},
                                             {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                             {0x1.1e1fafb043727p-3, -0x1.b485914dacf8cp-59},
                                             {0x1.3d6eee8c6626cp-3, 0x1.61a3b0ce9281bp-57},
                                             {0x1.5c9811e3ec26ap-3, -0x1.054ab2c010f3dp-58},
                                             {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
                                             {0x1.9a6a8e96c8626p-3, 0x1.cf601e7b4348ep-59},
                                             {0x1.b90d7529260a2p-3, 0x1.17b10d2e0e5abp-61},
                                             {0x1.d77d5df205736p-3, 0x1.c648d1534597ep-57},
                                             {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                             {0x1.09dc597d86362p-2, 0x1.62e47390cb865p-56},
                                             {0x1.18bf5a30bf178p-2, 0x1.30ca4748b1bf9p-57},
                                             {0x1.278372057ef46p-2, -0x1.077cdd36dfc81p-56},
                                             {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
                                             {0x1.44aa436c2af0ap-2, -0x1.5d5e43c55b3bap-56},
                                             {0x1.530ad9951cd4ap-2, -0x1.2566480884082p-57},
                                             {0x1.614840309cfe2p-2, -0x1.a725715711fp-56},
                                             {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                             {0x1.7d5604b63b3f7p-2, 0x1.69c885c2b249ap-56},
                                             {0x1.8b24d394a1b25p-2, 0x1.b6d0ba3748fa8p-56},
                                             {0x1.98cd5454d6b18p-2, 0x1.9e6c988fd0a77p-56},
                                             {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
                                             {0x1.b3a911da65c6cp-2, 0x1.ae187b1ca504p-56},
                                             {0x1.c0db4c94ec9fp-2, -0x1.cc1ce70934c34p-56},
                                             {0x1.cde53432c1351p-2, -0x1.a2cfa4418f1adp-56},
                                             {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                             {0x1.e77eb7f175a34p-2, 0x1.0e53dc1bf3435p-56},
                                             {0x1.f40dd0b541418p-2, -0x1.a3992dc382a23p-57},
                                             {0x1.0039c73c1a40cp-1, -0x1.b32c949c9d593p-55},
                                             {0x1.0657e94db30dp-1, -0x1.d5b495f6349e6p-56},
                                             {0x1.0c6145b5b43dap-1, 0x1.974fa13b5404fp-58},
                                             {0x1.1255d9bfbd2a9p-1, -0x1.2bdaee1c0ee35p-58},
                                             {0x1.1835a88be7c13p-1, 0x1.c621cec00c301p-55},
                                             {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                             {0x1.23b71e2cc9e6ap-1, 0x1.c421c9f38224ep-57},
                                             {0x1.2958e59308e31p-1, -0x1.09e73b0c6c087p-56},
                                             {0x1.2ee628406cbcap-1, 0x1.c5d5e9ff0cf8dp-55},
                                             {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
                                             {0x1.39c391cd4171ap-1, -0x1.2304331d8bf46p-55},
                                             {0x1.3f13fb89e96f4p-1, 0x1.ecf8b492644fp-56},
                                             {0x1.445065b795b56p-1, -0x1.f76d0163f79c8p-56},
                                             {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                             {0x1.4e8de5bb6ec04p-1, 0x1.4a33dbeb3796cp-55},
                                             {0x1.538f57b89061fp-1, -0x1.1bb74abda520cp-55},
                                             {0x1.587d81f732fbbp-1, -0x1.5e5c9d8c5a95p-56},
                                             {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
                                             {0x1.6220d115d7b8ep-1, -0x1.2b785350ee8c1p-57},
                                             {0x1.66d663923e087p-1, -0x1.6ea6febe8bbbap-56},
                                             {0x1.6b798920b3d99p-1, -0x1.a80386188c50ep-55},
                                             {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                             {0x1.748978fba8e0fp-1, 0x1.7b2a6165884a1p-59},
                                             {0x1.78f6bbd5d315ep-1, 0x1.406a08980374p-55},
                                             {0x1.7d528289fa093p-1, 0x1.560821e2f3aa9p-55},
                                             {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
                                             {0x1.85d69576cc2c5p-1, 0x1.6b66e7fc8b8c3p-57},
                                             {0x1.89ff5ff57f1f8p-1, -0x1.55b9a5e177a1bp-55},
                                             {0x1.8e17aa99cc05ep-1, -0x1.ec182ab042f61p-56},
                                             {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};

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
constexpr Real step{step_parts[0], step_parts[1]};

/// Added and taken off again, it rounds a double below 2^51 to a whole number.
constexpr double rounding = 0x1.8p52;

/// An angle as so many steps of pi/64, of which 128, a turn, are taken off at will, and a rest in radians of at most
/// half a step, or a little more.
struct Steps {
    double count;
    Real rest;
};

/// Of angles below 2^12. The product of the count with each part of pi/64 is exact.
ROTCONV_INLINE Steps steps_in_radians(Real angle, Real /*scalar*/) noexcept {
    const double count = (angle.hi * 0x1.45f306dc9c883p+4 + rounding) - rounding;
    const Real first = exact_product(count, step_parts[0]);
    const Real second = exact_product(count, -step_parts[1]);
    const Real third = exact_product(count, -step_parts[2]);
    // the first difference is exact: its operands are within a factor of two of each other, or the count is 0
    const Real near = exact_sum(angle.hi - first.hi, -first.lo) + second;
    return {count, (near + angle.lo) + (third + count * -step_parts[3])};
}

/// The same to 2^-100 or, where more than 40 digits cancel, as many fewer.
ROTCONV_INLINE Steps steps_in_radians(Real angle, double /*scalar*/) noexcept {
    const double count = (angle.hi * 0x1.45f306dc9c883p+4 + rounding) - rounding;
    const Real first = exact_product(count, step_parts[0]);
    const Real near = exact_sum(angle.hi - first.hi, -first.lo);
    const Real rest = quick_sum(near, exact_product(count, -step_parts[1]));
    return {count, exact_sum_of_ordered(rest.hi, rest.lo + (angle.lo + count * -step_parts[2]))};
}

/// Of angles below 2^44: a step is 2.8125 degrees, of which multiples are doubles.
ROTCONV_INLINE Steps steps_in_degrees(Real angle) noexcept {
    constexpr double step_in_degrees = 2.8125;
    const double count = (angle.hi * (1.0 / step_in_degrees) + rounding) - rounding;
    // the product's low part is kept away from underflow
    const bool tiny = __builtin_fabs(angle.hi) < 0x1p-300;
    const Real rest = scaled(exact_sum(angle.hi - count * step_in_degrees, angle.lo), tiny ? 0x1p600 : 1.0);
    return {count, scaled(rest * exact_radians_per_degree, tiny ? 0x1p-600 : 1.0)};
}

struct Binary {
    std::uint64_t digits; ///< below 2^53
    int exponent;         ///< |value| = digits 2^exponent
    bool negative;
};

/// Of a normal number.
Binary binary_of(double value) noexcept {
    std::uint64_t bits = 0;
    __builtin_memcpy(&bits, &value, sizeof bits);
    return {(bits & ((std::uint64_t{1} << 52U) - 1)) | (std::uint64_t{1} << 52U),
            static_cast<int>((bits >> 52U) & 0x7ffU) - 1075, (bits >> 63U) != 0};
}

/// Of any double of 1 or more: the digits of angle/(2 pi) behind the point, by way of 320 digits of 1/pi (Payne and
/// Hanek 1983).
Steps steps_in_large_radians(double angle) noexcept {
    const Binary binary = binary_of(angle);
    constexpr int words = 5;
    std::uint64_t fraction[words]; // of 1/(2 pi) times 2^exponent, in words of falling weight
    for (int i = 0; i < words; ++i) {
        const int first = binary.exponent - 1 + 64 * i; // the place of the word's first digit, from 0
        const int word = (first + 64) / 64 - 1;         // first / 64, rounded down
        const auto shift = static_cast<unsigned>(first - 64 * word);
        const std::uint64_t high = word < 0 ? 0 : inverse_of_pi[word];
        const std::uint64_t low = inverse_of_pi[word + 1];
        fraction[i] = shift == 0 ? high : (high << shift) | (low >> (64U - shift));
    }
    __extension__ using Wide = unsigned __int128;
    std::uint64_t carry = 0; // what it is at the end is whole turns
    for (int i = words - 1; i >= 0; --i) {
        const Wide product = static_cast<Wide>(fraction[i]) * binary.digits + carry;
        fraction[i] = static_cast<std::uint64_t>(product);
        carry = static_cast<std::uint64_t>(product >> 64U);
    }
    const auto count = static_cast<double>(((fraction[0] >> 1U) + (std::uint64_t{1} << 55U)) >> 56U);
    const auto signed_first = static_cast<std::int64_t>(fraction[0] << 7U); // of the rest, in units of 2^-64 step
    Real rest = 0.0;
    for (int i = words - 1; i > 0; --i) {
        const std::uint64_t shifted =
            i + 1 < words ? (fraction[i] << 7U) | (fraction[i + 1] >> 57U) : fraction[i] << 7U;
        rest = rest + scaled(exact_sum(static_cast<double>(shifted >> 32U) * 0x1p32,
                                       static_cast<double>(shifted & 0xffffffffU)),
                             power_of_two(-64 * (i + 1)));
    }
    const auto with_carry = static_cast<std::int64_t>(static_cast<std::uint64_t>(signed_first) | (fraction[1] >> 57U));
    rest = rest + scaled(exact_sum(static_cast<double>(with_carry >> 32) * 0x1p32,
                                   static_cast<double>(static_cast<std::uint64_t>(with_carry) & 0xffffffffU)),
                         0x1p-64);
    rest = rest * step;
    return binary.negative ? Steps{-count, -rest} : Steps{count, rest};
}

/// Less whole multiples of 360; exact.
double without_turns(double degrees) noexcept {
    if (!(__builtin_fabs(degrees) >= 0x1p44)) {
        return degrees;
    }
    const Binary binary = binary_of(degrees);
    // 2^exponent is whole from 0 on; below, the digits behind the point are few and stay
    const unsigned behind = binary.exponent < 0 ? static_cast<unsigned>(-binary.exponent) : 0U;
    std::uint64_t rest = (binary.digits >> behind) % 360U;
    for (int i = 0; i < binary.exponent; ++i) {
        rest = rest * 2 % 360U;
    }
    const std::uint64_t fraction = binary.digits & ((std::uint64_t{1} << behind) - 1);
    const double value =
        static_cast<double>(rest) + static_cast<double>(fraction) * power_of_two(-static_cast<int>(behind));
    return binary.negative ? -value : value;
}

Steps sum_of(Steps a, Steps b) noexcept { return {a.count + b.count, a.rest + b.rest}; }

Steps steps_in_large(Real angle, AngleUnit unit) noexcept {
    if (!(__builtin_fabs(angle.hi) <= 0x1.fffffffffffffp1023)) {
        return {0.0, angle.hi - angle.hi}; // nan
    }
    if (unit == AngleUnit::degrees) {
        // each part alone, then the sum, which may be a turn more
        return steps_in_degrees(exact_sum(without_turns(angle.hi), without_turns(angle.lo)));
    }
    const Steps high = steps_in_large_radians(angle.hi);
    return sum_of(high, __builtin_fabs(angle.lo) >= 1.0 ? steps_in_large_radians(angle.lo)
                                                        : steps_in_radians(angle.lo, Real()));
}

/// Of any angle.
template <class T> ROTCONV_INLINE Steps steps_of_any(Real angle, AngleUnit unit, T scalar) noexcept {
    const bool in_degrees = unit == AngleUnit::degrees;
    if (!(__builtin_fabs(angle.hi) < (in_degrees ? 0x1p44 : 0x1p12))) [[unlikely]] {
        return steps_in_large(angle, unit);
    }
    return in_degrees ? steps_in_degrees(angle) : steps_in_radians(angle, scalar);
}

/// Taylor's series of an angle up to 0.05: the sine and the cosine less 1, in full length as far as the digits of a
/// double would not do.
ROTCONV_INLINE SineCosine<Real> small_sine_cosine(Real angle) noexcept {
    const Real s = angle * angle;
    const double sine_tail =
        0x1.71de3a556c734p-19 +
        s.hi * (-0x1.ae64567f544e4p-26 + s.hi * (0x1.6124613a86d09p-33 + s.hi * -0x1.ae7f3e733b81fp-41));
    const Real sine_3 = quick_sum_of_ordered({-0x1.a01a01a01a01ap-13, -0x1.a01a01a01a01ap-73}, s.hi * sine_tail);
    const Real sine_2 = quick_sum_of_ordered({0x1.1111111111111p-7, 0x1.1111111111111p-63}, s * sine_3);
    const Real sine_1 = quick_sum_of_ordered({-0x1.5555555555555p-3, -0x1.5555555555555p-57}, s * sine_2);
    const double cosine_tail =
        0x1.a01a01a01a01ap-16 +
        s.hi * (-0x1.27e4fb7789f5cp-22 + s.hi * (0x1.1eed8eff8d898p-29 + s.hi * -0x1.93974a8c07c9dp-37));
    const Real cosine_3 = quick_sum_of_ordered({-0x1.6c16c16c16c17p-10, 0x1.f49f49f49f49fp-65}, s.hi * cosine_tail);
    const Real cosine_2 = quick_sum_of_ordered({0x1.5555555555555p-5, 0x1.5555555555555p-59}, s * cosine_3);
    const Real cosine_1 = quick_sum_of_ordered(-0.5, s * cosine_2);
    return {quick_sum_of_ordered(angle, angle * (s * sine_1)), quick_sum_of_ordered(1.0, s * cosine_1)};
}

/// The sine and cosine of a sum, from those of the steps and the rest.
ROTCONV_INLINE SineCosine<Real> turned(const SineCosine<Real>& steps, Real rest, Real /*scalar*/) noexcept {
    const SineCosine<Real> small = small_sine_cosine(rest);
    return {quick_sum(steps.sine * small.cosine, steps.cosine * small.sine),
            quick_sum(steps.cosine * small.cosine, -(steps.sine * small.sine))};
}

/// Only what is beside the steps' own sine and cosine is rounded.
ROTCONV_INLINE SineCosine<double> turned(const SineCosine<Real>& steps, Real rest, double /*scalar*/) noexcept {
    const double r = rest.hi;
    const double s = r * r;
    const double beyond =
        rest.lo + r * s * (-0x1.5555555555555p-3 + s * (0x1.1111111111111p-7 + s * -0x1.a01a01a01a01ap-13));
    const double less = s * (-0.5 + s * (0x1.5555555555555p-5 + s * -0x1.6c16c16c16c17p-10));
    const double sine = steps.sine.hi;
    const double cosine = steps.cosine.hi;
    return {sine + (cosine * r + (steps.sine.lo + (cosine * beyond + sine * less))),
            cosine + ((steps.cosine.lo - sine * beyond) + (cosine * less - sine * r))};
}

/// Of all numbers of steps in a turn.
struct TurnTable {
    constexpr TurnTable() noexcept {
        for (int i = 0; i < 128; ++i) {
            const int in_half_turn = i & 63;
            const bool obtuse = in_half_turn > 32;
            const int from_axis = obtuse ? 64 - in_half_turn : in_half_turn;
            const double sine_sign = i > 63 ? -1.0 : 1.0;
            const double cosine_sign = obtuse == (i > 63) ? 1.0 : -1.0;
            for (int part = 0; part < 2; ++part) {
                parts[i][part] = sine_sign * sine_table[from_axis][part];
                parts[i][2 + part] = cosine_sign * sine_table[32 - from_axis][part];
            }
        }
    }

    double parts[128][4]{}; ///< of the sine and of the cosine
};

constexpr TurnTable turn_table;

ROTCONV_INLINE SineCosine<Real> sine_cosine_of_steps(double count) noexcept {
    const double(&parts)[4] = turn_table.parts[static_cast<unsigned>(static_cast<std::int64_t>(count)) & 127U];
    return {{parts[0], parts[1]}, {parts[2], parts[3]}};
}

/// A tangent's numerator and denominator, both of at most a quarter turn, the numerator times a power of two where it
/// is very small beside the other, for then it is the angle and is kept away from underflow.
template <class T> struct Tangent {
    T near, far;
    double unscale; ///< takes the power back
    double count;   ///< of steps of 1/64 in the tangent
};

template <class T> ROTCONV_INLINE Tangent<T> tangent_from_nearer_axis(T x, T y) noexcept {
    const T x_size = choose(nearly(x) < 0.0, -x, x);
    const T y_size = choose(nearly(y) < 0.0, -y, y);
    const bool flat = is_at_most(y_size, x_size);
    const T near = choose(flat, y_size, x_size);
    const T far = choose(flat, x_size, y_size);
    const bool tiny = nearly(near) < nearly(far) * 0x1p-200;
    const T divisor = choose(nearly(far) == 0.0, T(1.0), far);
    const T scaled_near = scaled(near, tiny ? 0x1p600 : 1.0);
    return {scaled_near, divisor, tiny ? 0x1p-600 : 1.0,
            ((tiny ? 0.0 : nearly(near)) / nearly(divisor) * 64.0 + rounding) - rounding};
}

/// The arc tangent of what is left of a tangent after its steps: (near - far c)/(far + near c).
ROTCONV_INLINE Real rest_of_arc_tangent(const Tangent<Real>& t) noexcept {
    const double c = t.count * 0x1p-6;
    const Real tangent = quick_sum(t.near, t.far * -c) / quick_sum_of_ordered(t.far, t.near * c);
    const double true_size = tangent.hi * t.unscale;
    const Real s = choose(t.unscale == 1.0, tangent * tangent, true_size * true_size);
    const double tail =
        0x1.c71c71c71c71cp-4 +
        s.hi * (-0x1.745d1745d1746p-4 +
                s.hi * (0x1.3b13b13b13b14p-4 + s.hi * (-0x1.1111111111111p-4 + s.hi * 0x1.e1e1e1e1e1e1ep-5)));
    const Real third = quick_sum_of_ordered({-0x1.2492492492492p-3, -0x1.2492492492492p-57}, s.hi * tail);
    const Real second = quick_sum_of_ordered({0x1.999999999999ap-3, -0x1.999999999999ap-57}, s * third);
    const Real first = quick_sum_of_ordered({-0x1.5555555555555p-2, -0x1.5555555555555p-56}, s * second);
    return quick_sum_of_ordered(tangent, tangent * (s * first));
}

ROTCONV_INLINE Real rest_of_arc_tangent(const Tangent<double>& t) noexcept {
    const double c = t.count * 0x1p-6;
    const Real product = exact_product(t.far, c);
    const double tangent = ((t.near - product.hi) - product.lo) / (t.far + t.near * c);
    const double true_size = tangent * t.unscale;
    const double s = true_size * true_size;
    return {tangent, tangent * s *
                         (-0x1.5555555555555p-2 +
                          s * (0x1.999999999999ap-3 + s * (-0x1.2492492492492p-3 + s * 0x1.c71c71c71c71cp-4)))};
}

/// The angle of (x, y), from the one that is counted from the nearer axis.
template <class T> ROTCONV_INLINE Real from_x_axis(T x, T y, Real acute, double unscale, Real half_turn) noexcept {
    const T x_size = choose(nearly(x) < 0.0, -x, x);
    const T y_size = choose(nearly(y) < 0.0, -y, y);
    const bool flat = is_at_most(y_size, x_size);
    const bool back = nearly(x) < 0.0;
    // from 0, from a half-turn backwards, or from a quarter turn either way
    const double halves = flat ? (back ? 1.0 : 0.0) : 0.5;
    const Real angle =
        quick_sum_of_ordered(scaled(half_turn, halves), scaled(acute, flat == back ? -unscale : unscale));
    return scaled(angle, nearly(y) < 0.0 ? -1.0 : 1.0);
}

ROTCONV_INLINE Real arc_tangent_of_steps(double count) noexcept {
    const auto place = static_cast<unsigned>(static_cast<std::int64_t>(count <= 64.0 ? count : 0.0)); // it may be nan
    return {arc_tangent_table[place][0], arc_tangent_table[place][1]};
}

} // namespace

template <class T> SineCosine<T> sine_cosine(Real angle, AngleUnit unit) noexcept {
    const Steps steps = steps_of_any(angle, unit, T());
    return turned(sine_cosine_of_steps(steps.count), steps.rest, T());
}

template <class T> void sine_cosine(const Column<Real>& angles, std::size_t rows, AngleUnit unit, Column<T>& cosines,
                                    Column<T>& sines) noexcept {
    double count[batch_rows];
    Column<Real> rest;
    const double largest = unit == AngleUnit::degrees ? 0x1p44 : 0x1p12;
    if (unit == AngleUnit::degrees) {
        for (std::size_t i = 0; i < rows; ++i) {
            const Steps steps = steps_in_degrees(angles[i]);
            count[i] = steps.count;
            rest.set(i, steps.rest);
        }
    } else {
        for (std::size_t i = 0; i < rows; ++i) {
            const Steps steps = steps_in_radians(angles[i], T());
            count[i] = steps.count;
            rest.set(i, steps.rest);
        }
    }
    for (std::size_t i = 0; i < rows; ++i) {
        if (!(__builtin_fabs(angles.hi[i]) < largest)) [[unlikely]] {
            const Steps steps = steps_in_large(angles[i], unit);
            count[i] = steps.count;
            rest.set(i, steps.rest);
        }
    }
    Column<Real> cosine_of_steps;
    Column<Real> sine_of_steps;
    for (std::size_t i = 0; i < rows; ++i) {
        const SineCosine<Real> steps = sine_cosine_of_steps(count[i]);
        sine_of_steps.set(i, steps.sine);
        cosine_of_steps.set(i, steps.cosine);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const SineCosine<T> both = turned(SineCosine<Real>{sine_of_steps[i], cosine_of_steps[i]}, rest[i], T());
        cosines.set(i, both.cosine);
        sines.set(i, both.sine);
    }
}

template <class T> Real angle_of(T x, T y, AngleUnit unit) noexcept {
    const Tangent<T> tangent = tangent_from_nearer_axis(x, y);
    const Real acute = quick_sum_of_ordered(arc_tangent_of_steps(tangent.count), rest_of_arc_tangent(tangent));
    const Real in_unit = unit == AngleUnit::degrees ? acute * exact_degrees_per_radian : acute;
    return from_x_axis(x, y, in_unit, tangent.unscale, half_turn_in(unit));
}

template <class T> void angles_of(const Column<T>& x, const Column<T>& y, std::size_t rows, AngleUnit unit,
                                  Column<Real>& angles) noexcept {
    Column<T> near;
    Column<T> far;
    Column<Real> acute;
    double count[batch_rows];
    double unscale[batch_rows];
    for (std::size_t i = 0; i < rows; ++i) {
        const Tangent<T> tangent = tangent_from_nearer_axis<T>(x[i], y[i]);
        near.set(i, tangent.near);
        far.set(i, tangent.far);
        unscale[i] = tangent.unscale;
        count[i] = tangent.count;
    }
    for (std::size_t i = 0; i < rows; ++i) {
        acute.set(i, arc_tangent_of_steps(count[i]));
    }
    for (std::size_t i = 0; i < rows; ++i) {
        const Real rest = rest_of_arc_tangent(Tangent<T>{near[i], far[i], unscale[i], count[i]});
        acute.set(i, quick_sum_of_ordered(acute[i], rest));
    }
    if (unit == AngleUnit::degrees) {
        for (std::size_t i = 0; i < rows; ++i) {
            acute.set(i, acute[i] * exact_degrees_per_radian);
        }
    }
    const Real half_turn = half_turn_in(unit);
    for (std::size_t i = 0; i < rows; ++i) {
        angles.set(i, from_x_axis<T>(x[i], y[i], acute[i], unscale[i], half_turn));
    }
}

#define ROTCONV_FOR_SCALAR(T)                                                                                          \
    template SineCosine<T> sine_cosine(Real, AngleUnit) noexcept;                                                      \
    template void sine_cosine(const Column<Real>&, std::size_t, AngleUnit, Column<T>&, Column<T>&) noexcept;           \
    template Real angle_of(T, T, AngleUnit) noexcept;                                                                  \
    template void angles_of(const Column<T>&, const Column<T>&, std::size_t, AngleUnit, Column<Real>&) noexcept;
ROTCONV_FOR_SCALAR(double)
ROTCONV_FOR_SCALAR(Real)
#undef ROTCONV_FOR_SCALAR

} // namespace ROTCONV_TARGET
} // namespace rotconv
