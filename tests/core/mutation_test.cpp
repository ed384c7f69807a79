// Small losses in the place of rotconv's own answers: the checks that hold rotconv must reject each of them. What they
// say of published methods stands in tests/methods.

#include <rotconv/conversion.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"
#include "strata.hpp"

namespace {

using accuracy::spec;
using Row = std::span<const double>;

/// ZYX angles, with everything nearer to lock than 1e-7 treated as locked.
std::vector<double> lock_threshold(Row q) {
    return accuracy::converted(spec("quat"), spec("euler:ZYX"), q, {.tolerance = 1e300, .lock_margin = 1e-7}).numbers;
}

} // namespace

// Catches checks that do not look near enough to lock.
TEST_CASE("the checks reject a lock threshold of 1e-7") {
    const auto from = spec("quat");
    const auto to = spec("euler:ZYX");
    const double limit = accuracy::limit_to(to);
    const auto rows = accuracy::inputs(from, to, 200);
    CHECK(accuracy::worst_error(from, to, accuracy::fast(from, to), rows).error <= limit);
    CHECK(accuracy::worst_error(from, to, lock_threshold, rows).error > 1e3 * limit);
    const auto harmless = oracle::numbers(from, oracle::about({1, 2, 3}, oracle::Real(1)));
    CHECK(accuracy::worst_error(from, to, lock_threshold, {harmless}).error <= limit);
}

// Catches a suite whose limits no longer notice one lost digit.
TEST_CASE("the checks reject an answer that is off by five eps") {
    const auto rotvec = spec("rotvec");
    const auto quat = spec("quat");
    const auto own = accuracy::fast(rotvec, quat);
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
