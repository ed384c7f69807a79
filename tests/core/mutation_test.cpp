// Known-bad methods in the place of rotconv's own: the checks that hold rotconv must reject each of them, on the
// stratum where it fails, and pass it where it holds. A suite that cannot tell them apart proves nothing.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <rotconv/conversion.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"
#include "strata.hpp"

namespace {

using accuracy::spec;
using Row = std::span<const double>;

/// Baruh's Eqs (1)-(4): the scalar from the trace, the rest from differences.
std::vector<double> trace_only(Row m) {
    const double w = 0.5 * std::sqrt(m[0] + m[4] + m[8] + 1.0);
    return {w, (m[7] - m[5]) / (4 * w), (m[2] - m[6]) / (4 * w), (m[3] - m[1]) / (4 * w)};
}

/// Baruh as printed: the largest of the four, then Eqs (2)-(4), which all divide by the scalar or give it.
std::vector<double> baruh(Row m) {
    const std::array<double, 4> squares{1 + m[0] + m[4] + m[8], 1 + m[0] - m[4] - m[8], 1 - m[0] + m[4] - m[8],
                                        1 - m[0] - m[4] + m[8]};
    const std::array<double, 3> differences{m[7] - m[5], m[2] - m[6], m[3] - m[1]};
    std::size_t largest = 0;
    for (std::size_t i = 1; i < 4; ++i) {
        largest = squares[i] > squares[largest] ? i : largest;
    }
    if (largest == 0) {
        return trace_only(m);
    }
    const double e = 0.5 * std::sqrt(squares[largest]);
    const double w = differences[largest - 1] / (4 * e);
    std::vector<double> q{w, differences[0] / (4 * w), differences[1] / (4 * w), differences[2] / (4 * w)};
    q[largest] = e;
    return q;
}

/// The angle from the trace, the axis from differences.
std::vector<double> acos_of_trace(Row m) {
    const double angle = std::acos(std::min(1.0, std::max(-1.0, 0.5 * (m[0] + m[4] + m[8] - 1.0))));
    const double factor = angle == 0.0 ? 0.5 : angle / (2.0 * std::sin(angle));
    return {factor * (m[7] - m[5]), factor * (m[2] - m[6]), factor * (m[3] - m[1])};
}

/// ZYX angles, with everything nearer to lock than 1e-7 treated as locked.
std::vector<double> lock_threshold(Row q) {
    static const rotconv::Conversion conversion(spec("quat"), spec("euler:ZYX"),
                                                {.tolerance = 1e300, .lock_margin = 1e-7, .figures = false});
    std::vector<double> angles(3);
    rotconv::Report report;
    conversion.run(q, angles, {&report, 1});
    return angles;
}

struct Mutant {
    std::string name;
    std::string from;
    std::string to;
    accuracy::Convert convert;
    double holds_to; ///< eps on uniform attitudes away from the trouble: it is a known method, not nonsense
};

} // namespace

TEST_CASE("the checks reject known bad methods") {
    const auto mutant = GENERATE(values<Mutant>({
        {"trace only", "dcm", "quat", trace_only, 1e3},
        {"largest of four then differences only", "dcm", "quat", baruh, 1e3},
        {"angle from the arc cosine of the trace", "dcm", "rotvec", acos_of_trace, 1e3},
        {"lock threshold of 1e-7", "quat", "euler:ZYX", lock_threshold, 4.0},
    }));
    INFO(mutant.name);
    const auto from = spec(mutant.from);
    const auto to = spec(mutant.to);
    const double limit = accuracy::limit_from(from) + accuracy::limit_to(to);
    const auto rows = accuracy::inputs(from, to, 200);
    CHECK(accuracy::worst_error(from, to, accuracy::own(from, to), rows).error <= limit);
    CHECK(accuracy::worst_error(from, to, mutant.convert, rows).error > 1e3 * limit);

    // Turns of one radian are harmless to all of them.
    strata::Source source(31);
    std::vector<std::vector<double>> gentle;
    for (int i = 0; i < 200; ++i) {
        gentle.push_back(oracle::numbers(from, oracle::about(source.axis(), oracle::Real(1))));
    }
    CHECK(accuracy::worst_error(from, to, mutant.convert, gentle).error <= mutant.holds_to);
}

// Would catch: a suite whose limits no longer notice one lost digit.
TEST_CASE("the checks reject an answer that is off by five eps") {
    const auto rotvec = spec("rotvec");
    const auto quat = spec("quat");
    const auto own = accuracy::own(rotvec, quat);
    const auto off = [&own](Row row) {
        auto q = own(row);
        const double w = q[0];
        q[0] -= 2.5 * oracle::eps * q[1];
        q[1] += 2.5 * oracle::eps * w;
        return q;
    };
    const auto rows = accuracy::inputs(rotvec, quat, 100);
    CHECK(accuracy::worst_error(rotvec, quat, off, rows).error > accuracy::limit_from(rotvec));
}
