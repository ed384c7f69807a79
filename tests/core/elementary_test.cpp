// The core's own elementary functions against Boost's numbers of many digits.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include <boost/math/constants/constants.hpp>

#include "../../src/core/numerics/elementary.hpp"
#include "catch.hpp"
#include "oracle.hpp"

namespace {

namespace exact = rotconv;
using oracle::Digits;
using rotconv::AngleUnit;
using rotconv::batch_rows;

template <class Value> Value half_turn(AngleUnit unit) {
    return unit == AngleUnit::degrees ? Value(180) : boost::math::constants::pi<Value>();
}

template <class Value> Value number(exact::DoubleDouble value) { return Value(value.hi) + Value(value.lo); }

/// log2 of the relative error; what is 0 has to be 0.
template <class Value> double error_bits(exact::DoubleDouble found, const Value& expected) {
    if (expected == 0) {
        return found.hi == 0.0 && found.lo == 0.0 ? -1e9 : 1e9;
    }
    const Value error = abs(number<Value>(found) / expected - 1);
    return error == 0 ? -1e9 : std::log2(static_cast<double>(error));
}

/// The worst of many angles.
template <unsigned digits, class T = exact::DoubleDouble>
double worst_of_sine_cosine(const std::vector<exact::DoubleDouble>& angles, AngleUnit unit) {
    using Value = Digits<digits>;
    double worst = -1e9;
    for (std::size_t first = 0; first < angles.size(); first += batch_rows) {
        const std::size_t rows = std::min(batch_rows, angles.size() - first);
        exact::Column<exact::DoubleDouble> column;
        exact::Column<T> cosines;
        exact::Column<T> sines;
        for (std::size_t i = 0; i < rows; ++i) {
            column.set(i, angles[first + i]);
        }
        exact::sine_cosine(column, rows, unit, cosines, sines);
        for (std::size_t i = 0; i < rows; ++i) {
            const Value half = half_turn<Value>(unit);
            const Value angle = number<Value>(angles[first + i]);
            const Value turns = round(Value(angle / half));
            const Value rest = angle - turns * half;
            Value sine = sin(Value(rest / half * half_turn<Value>(AngleUnit::radians)));
            Value cosine = abs(rest) * 2 == half
                               ? Value(0)
                               : Value(cos(Value(rest / half * half_turn<Value>(AngleUnit::radians))));
            if (turns - 2 * round(Value(turns / 2)) != 0) { // an odd number of half-turns
                sine = -sine;
                cosine = -cosine;
            }
            const auto one = exact::sine_cosine<T>(angles[first + i], unit);
            const double error = std::max({error_bits<Value>(cosines[i], cosine), error_bits<Value>(sines[i], sine),
                                           error_bits<Value>(one.cosine, cosine), error_bits<Value>(one.sine, sine)});
            if (error > worst) {
                UNSCOPED_INFO(angles[first + i].hi << " + " << angles[first + i].lo << ": 2^" << error);
                worst = error;
            }
        }
    }
    return worst;
}

template <class T> struct Vector { T x, y; };

template <unsigned digits, class T> double worst_of_angles(const std::vector<Vector<T>>& vectors, AngleUnit unit) {
    using Value = Digits<digits>;
    double worst = -1e9;
    for (std::size_t first = 0; first < vectors.size(); first += batch_rows) {
        const std::size_t rows = std::min(batch_rows, vectors.size() - first);
        exact::Column<T> x;
        exact::Column<T> y;
        exact::Column<exact::DoubleDouble> angles;
        for (std::size_t i = 0; i < rows; ++i) {
            x.set(i, vectors[first + i].x);
            y.set(i, vectors[first + i].y);
        }
        exact::angles_of(x, y, rows, unit, angles);
        for (std::size_t i = 0; i < rows; ++i) {
            const Vector<T>& vector = vectors[first + i];
            const Value angle = atan2(number<Value>(vector.y), number<Value>(vector.x)) *
                                (half_turn<Value>(unit) / half_turn<Value>(AngleUnit::radians));
            const double error =
                std::max(error_bits(angles[i], angle), error_bits(exact::angle_of(vector.x, vector.y, unit), angle));
            if (error > worst) {
                UNSCOPED_INFO(exact::to_double(vector.x) << ", " << exact::to_double(vector.y) << ": 2^" << error);
                worst = error;
            }
        }
    }
    return worst;
}

class Source {
public:
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    exact::DoubleDouble real(double low, double high) {
        const double value = uniform(low, high);
        return exact::two_sum(value, value * uniform(-0x1p-54, 0x1p-54));
    }
    double size(double low, double high) { return std::exp2(uniform(low, high)) * (uniform(-1, 1) < 0 ? -1.0 : 1.0); }

private:
    std::mt19937_64 engine_{14};
};

constexpr int points = tried(50'000);

/// Doubles near multiples of pi/2, above all those that come nearest.
std::vector<exact::DoubleDouble> near_quarter_turns() {
    std::vector<exact::DoubleDouble> angles{0x1.6ac5b262ca1ffp849, 0x1.921fb54442d18p0,          0x1.921fb54442d18p1,
                                            0x1.475f9d9f1f8adp+28, 6381956970095103.0 * 0x1p797, 5.3190625e15};
    for (int k = 1; k < 2000; ++k) {
        const double angle = k * (0.5 * 3.14159265358979323846);
        angles.insert(angles.end(), {angle, std::nextafter(angle, 0.0), std::nextafter(angle, 1e9)});
    }
    return angles;
}

} // namespace

// Catches a digit of a table, a term of a series, a product that loses its low part.
TEST_CASE("sine and cosine are right to 2^-103, in radians and degrees") {
    Source source;
    std::vector<exact::DoubleDouble> turns;
    std::vector<exact::DoubleDouble> small;
    for (int i = 0; i < points / 4; ++i) {
        turns.push_back(source.uniform(-7, 7));
        turns.push_back(source.real(-4, 4));
        turns.push_back(source.uniform(-4096, 4096));
        small.push_back(source.size(-900, 1));
    }
    CHECK(worst_of_sine_cosine<70>(turns, AngleUnit::radians) <= -103.0);
    CHECK(worst_of_sine_cosine<70>(small, AngleUnit::radians) <= -103.0);
    for (auto& angle : turns) {
        angle = exact::scaled(angle, 64.0);
    }
    CHECK(worst_of_sine_cosine<70>(turns, AngleUnit::degrees) <= -103.0);
    CHECK(worst_of_sine_cosine<70>(small, AngleUnit::degrees) <= -103.0);
}

// Catches an angle reduced with too few digits of pi, or a large one with the wrong ones.
TEST_CASE("sine and cosine of large angles and near multiples of a quarter turn are right to 2^-103") {
    Source source;
    std::vector<exact::DoubleDouble> large;
    for (int i = 0; i < points / 50; ++i) {
        large.push_back(source.size(11, 1023.9));
    }
    large.push_back(std::numeric_limits<double>::max());
    for (const double border : {0x1p12, 0x1p44, 0x1p52, 0x1p53, 0x1p54}) {
        large.insert(large.end(), {border, std::nextafter(border, 0.0), std::nextafter(border, 1e300)});
    }
    CHECK(worst_of_sine_cosine<450>(large, AngleUnit::radians) <= -103.0);
    CHECK(worst_of_sine_cosine<450>(large, AngleUnit::degrees) <= -103.0);
    CHECK(worst_of_sine_cosine<450>(near_quarter_turns(), AngleUnit::radians) <= -103.0);
}

// Catches a quarter turn that leaves a rest.
TEST_CASE("multiples of 90 degrees have a sine or cosine of 0 and the other of 1") {
    for (int k = -400; k <= 400; ++k) {
        exact::Column<exact::DoubleDouble> columns[3];
        columns[0].set(0, 90.0 * k);
        exact::sine_cosine(columns[0], 1, AngleUnit::degrees, columns[1], columns[2]);
        const exact::Column<exact::DoubleDouble>& one = k % 2 == 0 ? columns[1] : columns[2];
        const exact::Column<exact::DoubleDouble>& zero = k % 2 == 0 ? columns[2] : columns[1];
        INFO(k);
        CHECK(std::fabs(one.hi[0]) == 1.0);
        CHECK(one.lo[0] == 0.0);
        CHECK(zero.hi[0] == 0.0);
        CHECK(zero.lo[0] == 0.0);
    }
}

// Catches a wrong quadrant, a digit of the table, a lost small angle.
TEST_CASE("the angle of a vector is right to 2^-103, in radians and degrees") {
    Source source;
    std::vector<Vector<exact::DoubleDouble>> vectors;
    for (int i = 0; i < points / 4; ++i) {
        vectors.push_back({source.real(-1, 1), source.real(-1, 1)});
        vectors.push_back({source.real(-1, 1), source.size(-900, 0)});
        vectors.push_back({source.size(-900, 0), source.real(-1, 1)});
        const exact::DoubleDouble diagonal = source.real(-1, 1);
        vectors.push_back({diagonal, diagonal + source.size(-110, -1)});
    }
    for (const double x : {0.0, 1.0, -1.0}) {
        for (const double y : {0.0, 1.0, -1.0}) {
            vectors.push_back({x, y});
        }
    }
    CHECK(worst_of_angles<70>(vectors, AngleUnit::radians) <= -103.0);
    CHECK(worst_of_angles<70>(vectors, AngleUnit::degrees) <= -103.0);
}

// Catches a term too few in the series for doubles, a table's low part left out, a rest rounded too early.
TEST_CASE("in doubles the sine and cosine are right to 2^-51.5, the angle of a vector to 2^-51") {
    Source source;
    std::vector<exact::DoubleDouble> turns;
    std::vector<Vector<double>> vectors;
    for (int i = 0; i < points / 4; ++i) {
        turns.insert(turns.end(),
                     {source.uniform(-7, 7), source.real(-4, 4), source.uniform(-4096, 4096), source.size(-900, 1)});
        vectors.push_back({source.uniform(-1, 1), source.uniform(-1, 1)});
        vectors.push_back({source.uniform(-1, 1), source.size(-900, 0)});
        vectors.push_back({source.size(-900, 0), source.uniform(-1, 1)});
    }
    const double sine_bound = -51.5;
    CHECK(worst_of_sine_cosine<70, double>(turns, AngleUnit::radians) <= sine_bound);
    CHECK(worst_of_sine_cosine<70, double>(turns, AngleUnit::degrees) <= sine_bound);
    CHECK(worst_of_sine_cosine<450, double>(near_quarter_turns(), AngleUnit::radians) <= sine_bound);
    CHECK(worst_of_angles<70>(vectors, AngleUnit::radians) <= -51.0);
    CHECK(worst_of_angles<70>(vectors, AngleUnit::degrees) <= -51.0);
}

// Catches a number made of what is none, and a place outside of a table.
TEST_CASE("of what is no number there is no sine, cosine or angle") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double value : {nan, HUGE_VAL, -HUGE_VAL}) {
        for (const AngleUnit unit : {AngleUnit::radians, AngleUnit::degrees}) {
            INFO(value);
            CHECK(std::isnan(exact::sine_cosine<double>(value, unit).sine));
            CHECK(std::isnan(exact::sine_cosine<exact::DoubleDouble>(value, unit).cosine.hi));
        }
    }
    CHECK(std::isnan(exact::angle_of(nan, 1.0, AngleUnit::radians).hi));
    CHECK(std::isnan(exact::angle_of(1.0, nan, AngleUnit::radians).hi));
    CHECK(std::isnan(exact::angle_of(exact::DoubleDouble(nan), exact::DoubleDouble(nan), AngleUnit::degrees).hi));
}
