// Every representation to every other one, with and without its conventions.

#include <algorithm>

#include <rotconv/conversion.hpp>

#include "accuracy.hpp"
#include "catch.hpp"
#include "oracle.hpp"
#include "strata.hpp"

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
