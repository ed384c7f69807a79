// Every representation to every other one, with and without its conventions.

#include <algorithm>
#include <cmath>

#include <rotconv/conversion.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"
#include "strata.hpp"

namespace {

/// Of a representation without limits of its own: eps, where the margin is a radian or more.
constexpr double any_limit = 8.0;

} // namespace

// Catches a convention applied on one side only, or a representation that is right alone and wrong behind another.
TEST_CASE("any pair errs by no more than its two ways together") {
    std::vector<rotconv::Spec> specs;
    for (const auto& text : accuracy::all_specs()) {
        specs.push_back(accuracy::spec(text));
    }
    std::erase_if(specs, [](const auto& spec) { return !accuracy::has_limits(spec.name); });
    for (const auto& from : specs) {
        for (const auto& to : specs) {
            constexpr int size = is_sanitized ? 1 : 5;
            const auto worst =
                accuracy::worst_error(from, to, accuracy::fast(from, to), accuracy::inputs(from, to, size));
            INFO(worst.where);
            CHECK(worst.error <= accuracy::limit_from(from) + accuracy::limit_to(to));
        }
    }
}

// Catches a way back that is another set's.
TEST_CASE("a round trip through any representation returns the attitude") {
    const auto quat = accuracy::spec("quat");
    for (const auto& text : accuracy::all_specs()) {
        const auto via = accuracy::spec(text);
        const auto back = accuracy::own(via, quat);
        INFO(text);
        for (const auto& row : accuracy::inputs(quat, via, 60)) {
            const auto [numbers, report] =
                accuracy::converted(quat, via, row, {.tolerance = 1e300, .lock_margin = 0.0, .sensitivity = true});
            if (std::ranges::all_of(numbers, [](double v) { return std::isfinite(v); })) {
                const double limit = accuracy::has_limits(via.name)
                                         ? accuracy::limit_to(via) + accuracy::limit_from(via) + 1.0
                                         : any_limit / std::min(1.0, report.sensitivity.margin);
                CHECK(oracle::error_in_eps(oracle::attitude(quat, row), oracle::attitude(quat, back(numbers))) <=
                      limit);
            }
        }
    }
}

// Catches an alias that names another representation.
TEST_CASE("an alias means the same as its name") {
    for (const auto id : rotconv::all_representations) {
        const auto& entry = rotconv::representation(id);
        for (const auto alias : entry.aliases) {
            if (!alias.empty()) {
                CHECK(accuracy::spec(std::string(alias)).name == entry.name);
            }
        }
    }
}
