#include "wide.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <list>
#include <mutex>
#include <utility>

#ifndef BOOST_NO_CXX98_FUNCTION_BASE
#define BOOST_NO_CXX98_FUNCTION_BASE // libc++ has them no more, which Boost 1.74 does not know
#endif
#include <boost/multiprecision/cpp_int.hpp>

#include "elementary.hpp"
#include "power_of_two.hpp"

// NOLINTBEGIN(bugprone-exception-escape,bugprone-unhandled-exception-at-new,cppcoreguidelines-owning-memory): see
// wide.hpp
namespace rotconv {
namespace {

namespace mp = boost::multiprecision;
using Int = mp::number<mp::cpp_int_backend<1024, 0, mp::signed_magnitude, mp::unchecked>, mp::et_off>;
using Exponent = std::int64_t;

thread_local int work_bits = 256;     // NOLINT(*-avoid-non-const-global-variables): of a thread
thread_local bool is_doubted = false; // NOLINT(*-avoid-non-const-global-variables)

/// An upper bound, 0 or v 2^x with v in [1/2, 1).
struct Bound {
    double v = 0.0;
    Exponent x = 0;

    bool operator==(const Bound&) const = default;
};
Bound bound(double v, Exponent x) noexcept { // v: 0, or of ordinary size
    const double scale = unit_scale(v);
    return v == 0.0 ? Bound() : Bound{v * scale, x - exponent_of(scale)};
}
Bound bound_of_bit(Exponent x) noexcept { return {0.5, x + 1}; }
constexpr double upwards = 1.0 + 0x1p-40;
Bound operator+(Bound a, Bound b) noexcept {
    if (a.v == 0.0 || b.v == 0.0) {
        return a.v == 0.0 ? b : a;
    }
    if (a.x < b.x) {
        std::swap(a, b);
    }
    const Exponent distance = std::min<Exponent>(a.x - b.x, 60);
    return bound((a.v + b.v * power_of_two(-static_cast<int>(distance))) * upwards, a.x);
}
Bound operator*(Bound a, Bound b) noexcept { return bound(a.v * b.v * upwards, a.x + b.x); }
Bound operator/(Bound a, Bound b) noexcept { return bound(a.v / b.v * upwards, a.x - b.x); }
Bound root_of(Bound a) noexcept {
    const bool odd = (a.x & 1) != 0;
    return bound(std::sqrt(odd ? 2.0 * a.v : a.v) * upwards, (a.x - (odd ? 1 : 0)) / 2);
}
bool operator<(Bound a, Bound b) noexcept {
    return b.v != 0.0 && (a.v == 0.0 || a.x < b.x || (a.x == b.x && a.v < b.v));
}

Exponent length(const Int& m) noexcept {
    const auto& digits = m.backend();
    const mp::limb_type first = digits.limbs()[digits.size() - 1];
    const Exponent others = static_cast<Exponent>(digits.size() - 1) * std::numeric_limits<mp::limb_type>::digits;
    return others + static_cast<Exponent>(std::bit_width(first));
}
Int one_at(Exponent bit) noexcept { return Int(1) << static_cast<unsigned long>(bit); }

void negate_if(bool condition, Int& m) noexcept {
    if (condition) {
        m.backend().negate();
    }
}

/// m 2^by, rounded towards 0; whether it is exact.
bool shift(Int& m, Exponent by) noexcept {
    if (by >= 0 || m.is_zero()) {
        m <<= static_cast<unsigned long>(std::max<Exponent>(by, 0));
        return true;
    }
    const bool is_negative = m.sign() < 0;
    negate_if(is_negative, m);
    const bool is_exact = static_cast<Exponent>(lsb(m)) >= -by;
    m >>= static_cast<unsigned long>(-by);
    negate_if(is_negative, m);
    return is_exact;
}

/// a b 2^-places within 2, where b is below 2^places: by the digits of b that count.
Int times(const Int& a, const Int& b, Exponent places) noexcept {
    const auto unused = static_cast<unsigned long>(std::max<Exponent>(0, places - length(a)));
    return (a * (b >> unused)) >> (static_cast<unsigned long>(places) - unused);
}

/// pi 2^bits, less than 2 too small (Machin 1706).
Int pi_to(Exponent bits) noexcept {
    static std::mutex mutex;        // no thread's own, for MinGW destroys such objects after their memory
    static auto& digits = *new Int; // NOLINT(*-avoid-non-const-global-variables)
    static Exponent held = -1;
    const std::lock_guard lock(mutex);
    if (held < bits) {
        held = bits + 64;
        const auto inverse_tangent = [](unsigned n) {
            Int power = one_at(held + 16) / n;
            Int sum = power;
            for (unsigned k = 3; !power.is_zero(); k += 2) {
                power /= n * n;
                sum += (k & 2U) != 0 ? Int(-(power / k)) : Int(power / k);
            }
            return sum;
        };
        digits = (16 * inverse_tangent(5) - 4 * inverse_tangent(239)) >> 16U;
    }
    return digits >> static_cast<unsigned long>(held - bits);
}

/// The whole part of the root: Newton's steps, from above, after that of the first half of the digits.
Int root_of(const Int& a) noexcept { // NOLINT(misc-no-recursion): as often as the digits can be halved
    const Exponent by = length(a) > 124 ? length(a) / 4 : std::max<Exponent>(length(a) - 61, 0) / 2;
    const Int leading = a >> static_cast<unsigned long>(2 * by);
    Int x =
        length(leading) > 62
            ? root_of(leading) + 1
            : Int(static_cast<std::uint64_t>(std::sqrt(static_cast<double>(static_cast<std::uint64_t>(leading)))) + 1);
    x <<= static_cast<unsigned long>(by);
    for (Int next = (x + a / x) >> 1U; next < x; next = (x + a / x) >> 1U) {
        x = next;
    }
    return x;
}

/// The nearest double of m 2^e, even of two.
double nearest_double(Int m, Exponent e) noexcept {
    const double sign = m.sign() < 0 ? -1.0 : 1.0;
    m = abs(m);
    const Exponent top = e + length(m);
    if (m.is_zero() || top < -1080) {
        return sign * 0.0;
    }
    if (top > 1024) {
        return sign * std::numeric_limits<double>::infinity();
    }
    const Exponent last = std::max<Exponent>(top - 53, -1074); // the place of the double's last bit
    bool goes_up = false;
    if (last > e) {
        const auto half = static_cast<unsigned>(last - e - 1);
        const bool is_above = static_cast<unsigned>(lsb(m)) < half || bit_test(m, half + 1);
        goes_up = bit_test(m, half) && is_above;
    }
    shift(m, e - last);
    const auto digits = static_cast<std::uint64_t>(m) + (goes_up ? 1U : 0U);
    return sign * std::ldexp(static_cast<double>(digits), static_cast<int>(last));
}

} // namespace

/// m 2^e within r; not finite: of the sign of m.
struct Wide::Number {
    Int m;
    Exponent e = 0;
    Bound r{};
    bool is_infinite = false;

    bool operator==(const Number&) const = default;
    [[nodiscard]] Exponent top() const noexcept { return e + length(m); } ///< the number is below 2^top
    [[nodiscard]] Bound size() const noexcept { return m.is_zero() ? Bound() : bound_of_bit(top()); }
    [[nodiscard]] Bound least() const noexcept { return m.is_zero() ? Bound() : bound_of_bit(top() - 1); }
    /// Where it may not, it is at least half of least().
    [[nodiscard]] bool may_be_near_zero() const noexcept { return m.is_zero() || !(r < bound_of_bit(top() - 2)); }
    [[nodiscard]] int clear_sign() const noexcept { return is_infinite || may_be_near_zero() ? 0 : m.sign(); }
    Number* normalized() noexcept {
        const Exponent excess = length(m) - work_bits;
        if (excess > 0) {
            shift_to(e + excess);
        }
        e = m.is_zero() ? 0 : e;
        return this;
    }
    void shift_to(Exponent place) noexcept {
        if (!shift(m, e - place)) {
            r = r + bound_of_bit(place);
        }
        e = place;
    }
    static Number* of(Int digits, Exponent exponent, Bound error) noexcept {
        auto* const n = new Number;
        n->m = std::move(digits);
        n->e = exponent;
        n->r = error;
        return n->normalized();
    }
};

Wide::Bits::Bits(int bits) noexcept : bits_before_(work_bits), doubted_before_(is_doubted) {
    work_bits = bits;
    is_doubted = false;
}
Wide::Bits::~Bits() {
    work_bits = bits_before_;
    is_doubted = doubted_before_;
}
bool Wide::Bits::doubted() noexcept { return is_doubted; }
int Wide::Bits::bits() noexcept { return work_bits; }
void Wide::Bits::doubt() noexcept { is_doubted = true; }

Wide::Wide(double value) noexcept : number_(new Number) {
    number_->is_infinite = !std::isfinite(value);
    const Binary binary(number_->is_infinite ? std::copysign(1.0, value) : value);
    number_->m = binary.digits;
    number_->e = binary.digits == 0 ? 0 : binary.exponent;
    negate_if(binary.is_negative, number_->m);
}
Wide::Wide(double high, double low) noexcept : Wide(low == 0.0 ? Wide(high) : Wide(high) + Wide(low)) {}
Wide::Wide(const Wide& other) noexcept : number_(new Number(*other.number_)) {}
Wide::~Wide() { delete number_; }

bool Wide::round(double& nearest) const noexcept {
    const Number& n = *number_;
    nearest = rounded();
    if (n.is_infinite || n.r.v == 0.0) {
        return true;
    }
    // the bound as a power of two, or the least that counts beside the number
    const Exponent x = n.m.is_zero() ? n.r.x : std::max(n.r.x, n.top() - work_bits - 128);
    const Exponent e = std::min(x, n.e);
    Int middle = n.m;
    shift(middle, n.e - e);
    const Int low = middle - one_at(x - e);
    const Int high = middle + one_at(x - e);
    const double a = nearest_double(low, e);
    const double b = nearest_double(high, e);
    if (a == b) {
        nearest = a;
        return true;
    }
    if (low.sign() <= 0 && high.sign() >= 0) {
        nearest = 0.0;
    } else if (std::nextafter(a, b) == b) {
        nearest = (__builtin_bit_cast(std::uint64_t, a) & 1U) == 0 ? a : b;
    }
    return false;
}
double Wide::rounded() const noexcept {
    return number_->is_infinite ? number_->m.sign() * std::numeric_limits<double>::infinity()
                                : nearest_double(number_->m, number_->e);
}
bool Wide::may_be_zero() const noexcept {
    return !number_->is_infinite && number_->r.v != 0.0 && number_->may_be_near_zero();
}
bool Wide::is_below(int exponent) const noexcept {
    return !number_->is_infinite && number_->size() + number_->r < bound_of_bit(exponent);
}
Wide Wide::middle() const noexcept {
    Wide a = *this;
    a.number_->r = {};
    return a;
}
void Wide::widen(const Wide& error) noexcept { number_->r = number_->r + (error.number_->size() + error.number_->r); }
int Wide::sign() const noexcept {
    if (may_be_zero()) {
        is_doubted = true;
        return 0;
    }
    return number_->m.sign();
}
int Wide::exponent() const noexcept { return number_->m.is_zero() ? -1'000'000 : static_cast<int>(number_->top() - 1); }
Wide Wide::shifted(int power) const noexcept {
    Wide a = *this;
    a.number_->e += a.number_->m.is_zero() ? 0 : power;
    a.number_->r.x += a.number_->r.v == 0.0 ? 0 : power;
    return a;
}

Wide operator-(const Wide& a) noexcept {
    Wide b = a;
    b.number_->m.backend().negate();
    return b;
}
Wide operator+(const Wide& a, const Wide& b) noexcept {
    Wide::Number x = *a.number_;
    Wide::Number y = *b.number_;
    if (x.is_infinite || y.is_infinite) {
        return x.is_infinite ? a : b;
    }
    if (x.m.is_zero() || y.m.is_zero()) {
        Wide sum = x.m.is_zero() ? b : a;
        sum.number_->r = x.r + y.r;
        sum.number_->normalized();
        return sum;
    }
    const Exponent place = std::max(std::min(x.e, y.e), std::max(x.top(), y.top()) - work_bits - 32);
    x.shift_to(place);
    y.shift_to(place);
    return Wide(Wide::Number::of(x.m + y.m, place, x.r + y.r));
}
Wide operator-(const Wide& a, const Wide& b) noexcept { return a + -b; }
Wide operator*(const Wide& a, const Wide& b) noexcept {
    const Wide::Number& x = *a.number_;
    const Wide::Number& y = *b.number_;
    auto* const n = Wide::Number::of(x.m * y.m, x.e + y.e, (x.size() * y.r + y.size() * x.r) + x.r * y.r);
    n->is_infinite = x.is_infinite || y.is_infinite;
    return Wide(n);
}
Wide operator/(const Wide& a, const Wide& b) noexcept {
    const Wide::Number& x = *a.number_;
    const Wide::Number& y = *b.number_;
    if (x.is_infinite || y.is_infinite || y.may_be_near_zero()) {
        is_doubted = is_doubted || y.r.v != 0.0;
        auto* const n = new Wide::Number;
        n->is_infinite = true;
        n->m = x.m.sign() < 0 ? -1 : 1;
        return Wide(n);
    }
    const Exponent by = std::max<Exponent>(0, work_bits + 32 + length(y.m) - length(x.m));
    const Int dividend = x.m << static_cast<unsigned long>(by);
    Wide::Number quotient;
    Int rest;
    divide_qr(dividend, y.m, quotient.m, rest);
    quotient.e = x.e - y.e - by;
    const Bound divisor = bound_of_bit(y.top() - 2); // half of what |b| is at least
    const Bound error = (x.r + (quotient.size() + bound_of_bit(quotient.e)) * y.r) / divisor;
    return Wide(Wide::Number::of(quotient.m, quotient.e, rest.is_zero() ? error : error + bound_of_bit(quotient.e)));
}
Wide root(const Wide& a) noexcept {
    const Wide::Number& x = *a.number_;
    if (x.is_infinite) {
        return a;
    }
    if (x.m.sign() <= 0) { // it is not negative: 0, as far as can be told
        return Wide(Wide::Number::of(0, 0, root_of(x.r + x.size())));
    }
    Exponent by = std::max<Exponent>(0, 2 * Exponent{work_bits + 32} - length(x.m));
    by += (x.e - by) & 1;
    const Int square = x.m << static_cast<unsigned long>(by);
    Wide::Number whole;
    whole.m = root_of(square);
    whole.e = (x.e - by) / 2;
    const bool is_exact = x.r.v == 0.0 && whole.m * whole.m == square;
    const Bound error = x.may_be_near_zero() ? root_of(x.r + x.size()) : x.r / whole.least();
    return Wide(Wide::Number::of(whole.m, whole.e, is_exact ? Bound() : error + bound_of_bit(whole.e)));
}
Wide scaled(const Wide& a, double power) noexcept {
    int own = 0;
    const double f = std::frexp(power, &own);
    Wide b = a.shifted(own - 1);
    negate_if(f < 0.0, b.number_->m);
    return b;
}

Wide Wide::half_turn(bool in_degrees) noexcept {
    const Exponent e = -(work_bits + 8);
    return in_degrees ? Wide(180.0) : Wide(Number::of(pi_to(-e), e, bound_of_bit(e + 1)));
}

/// Taylor's series of 1 - cos of an angle up to a quarter turn, of so small a part of it that they are short, and then
/// doubled.
void Wide::series_of(const Wide& rest, Wide& sine, Wide& cosine) noexcept {
    const int doublings = work_bits < 512 ? 4 : work_bits / 160;
    work_bits += 2 * doublings + 16;
    const Wide part = rest.middle().shifted(-doublings);
    const Exponent fine = work_bits + 32;
    Int z = part.number_->m * part.number_->m;
    shift(z, 2 * part.number_->e + fine);
    Int sum = one_at(fine); // 1 - z/(3 4) + ...
    Int term = sum;
    unsigned k = 3;
    for (; !term.is_zero(); k += 2) {
        term = times(term, z, fine) / (k * (k + 1));
        sum += (k & 2U) != 0 ? Int(-term) : term;
    }
    Wide versine = square(part).shifted(-1) * Wide(Number::of(sum, -fine, bound(2.0 * k, -fine)));
    for (int i = 0; i < doublings; ++i) {
        versine = versine.shifted(1) * (Wide(2.0) - versine);
    }
    const bool is_negative = rest.number_->m.sign() < 0;
    sine = root(versine * (Wide(2.0) - versine));
    negate_if(is_negative, sine.number_->m);
    cosine = Wide(1.0) - versine;
    work_bits -= 2 * doublings + 16;
    for (Wide* const both : {&sine, &cosine}) { // neither changes by more than the angle
        both->number_->r = both->number_->r + rest.number_->r;
        both->number_->normalized();
    }
}

void Wide::sine_cosine(const Wide& angle, bool in_degrees, Wide& sine, Wide& cosine) noexcept {
    struct Known {
        Number angle{};
        bool in_degrees = false;
        int bits = 0;
        Wide sine, cosine;
    };
    constexpr std::size_t most = 64;
    // the latest first: the angles of fixed rotations come again with each row; no thread's own: see pi_to()
    static std::mutex mutex;
    static auto& all = *new std::list<Known>; // NOLINT(*-avoid-non-const-global-variables)
    const Number& n = *angle.number_;
    {
        const std::lock_guard lock(mutex);
        const auto known = std::find_if(all.begin(), all.end(), [&](const Known& each) {
            return each.bits == work_bits && each.in_degrees == in_degrees && each.angle == n;
        });
        if (known != all.end()) {
            all.splice(all.begin(), all, known);
            sine = known->sine;
            cosine = known->cosine;
            return;
        }
    }
    const Number own = n; // one of the results may be the angle
    find_sine_cosine(angle, in_degrees, sine, cosine);
    const std::lock_guard lock(mutex);
    all.size() < most ? all.splice(all.begin(), std::list<Known>(1))
                      : all.splice(all.begin(), all, std::prev(all.end()));
    all.front() = {own, in_degrees, work_bits, sine, cosine};
}

void Wide::find_sine_cosine(const Wide& angle, bool in_degrees, Wide& sine, Wide& cosine) noexcept {
    const int own_bits = work_bits;
    work_bits = own_bits + 64 + static_cast<int>(std::max<Exponent>(0, angle.number_->top()));
    const Wide quarter = half_turn(in_degrees).shifted(-1);
    Wide rest = angle;
    unsigned quadrant = 0;
    if (angle.number_->top() > (in_degrees ? 5 : -1)) { // quarter turns, to the nearest
        const Wide turns = angle / quarter;
        const bool is_negative = turns.number_->m.sign() < 0;
        Int count = abs(turns.number_->m);
        shift(count, turns.number_->e + 1);
        count = (count + 1) >> 1U;
        const auto quarters = static_cast<unsigned>(static_cast<std::uint64_t>(Int(count & 3U)));
        quadrant = is_negative ? (4U - quarters) & 3U : quarters;
        auto* const n = new Number;
        n->m = is_negative ? Int(-count) : count;
        rest = angle - Wide(n) * quarter;
    }
    if (in_degrees) {
        rest = rest * half_turn(false) / Wide(180.0);
    }
    work_bits = own_bits;
    rest.number_->normalized();
    if (rest.number_->m.is_zero()) {
        sine = rest;
        cosine = 1.0;
        cosine.number_->r = rest.number_->r;
    } else {
        series_of(rest, sine, cosine);
    }
    if ((quadrant & 1U) != 0) {
        std::swap(sine, cosine);
    }
    negate_if(quadrant >= 2, sine.number_->m);
    negate_if(quadrant == 1 || quadrant == 2, cosine.number_->m);
}

/// The angle of a tangent of at most about 1, in radians: that of its double, and Gregory's series of the rest.
Wide Wide::acute_angle(const Wide& near, const Wide& far) noexcept {
    Wide t = near / far;
    Wide first = 0.0;
    if (t.exponent() >= -30) {
        first = rotconv::angle_of(1.0, t.rounded(), AngleUnit::radians).hi;
        Wide s;
        Wide c;
        sine_cosine(first, false, s, c);
        t = (near * c - far * s) / (far * c + near * s);
    }
    const Exponent fine = work_bits + 32;
    Int z = t.number_->m * t.number_->m;
    shift(z, 2 * t.number_->e + fine);
    Int sum = one_at(fine);
    Int power = sum;
    unsigned k = 1;
    while (!power.is_zero()) {
        power = times(power, z, fine);
        k += 2;
        sum += (k & 2U) != 0 ? Int(-(power / k)) : Int(power / k);
    }
    Wide rest = t.middle() * Wide(Number::of(sum, -fine, bound(4.0 * k, -fine)));
    rest.number_->r = rest.number_->r + t.number_->r;
    return first + rest;
}

Wide Wide::angle_of(const Wide& x, const Wide& y, bool in_degrees) noexcept {
    const int x_sign = x.number_->clear_sign();
    const int y_sign = y.number_->clear_sign();
    const Wide half = half_turn(in_degrees);
    const auto beside_axis = [](Wide angle, const Wide& near, const Wide& far) { // by 2 |near/far| 57.3 at most
        const Number& n = *near.number_;
        if (n.r.v != 0.0 || !n.m.is_zero()) {
            angle.number_->r = angle.number_->r + (n.r + n.size()) / far.number_->least() * bound_of_bit(7);
        }
        return angle;
    };
    if (y_sign == 0 && x_sign == 0) {
        is_doubted = is_doubted || x.number_->r.v != 0.0 || y.number_->r.v != 0.0;
        return 0.0;
    }
    if (y_sign == 0) {
        return beside_axis(x_sign < 0 ? half : Wide(0.0), y, x);
    }
    if (x_sign == 0) {
        return beside_axis(scaled(half, y_sign < 0 ? -0.5 : 0.5), x, y);
    }
    const Wide x_size = x_sign < 0 ? -x : x;
    const Wide y_size = y_sign < 0 ? -y : y;
    const Number distance = *(x_size - y_size).number_;
    const bool is_flat = distance.m.sign() >= 0;
    Wide angle = half.shifted(-2);
    if (!distance.m.is_zero() || distance.r.v != 0.0) {
        angle = is_flat ? acute_angle(y_size, x_size) : acute_angle(x_size, y_size);
        angle = in_degrees ? angle * Wide(180.0) / half_turn(false) : angle;
    }
    angle = is_flat ? angle : half.shifted(-1) - angle;
    angle = x_sign < 0 ? half - angle : angle;
    return y_sign < 0 ? -angle : angle;
}

} // namespace rotconv
// NOLINTEND(bugprone-exception-escape,bugprone-unhandled-exception-at-new,cppcoreguidelines-owning-memory)
