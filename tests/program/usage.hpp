#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include <catch.hpp>

#include "process.hpp"

namespace program {

/// One line on stderr with these words, nothing on stdout, exit 2.
inline void check_usage_error(const std::string& arguments, std::initializer_list<std::string_view> words) {
    INFO("rotconv " << arguments);
    const auto result = run(arguments, "1 0 0 0\n");
    CHECK(result.exit_code == 2);
    CHECK(result.out == "");
    CHECK(count_rows(result.err) == 1);
    CHECK(missing(result.err, {"rotconv: "}) == "");
    CHECK(missing(result.err, words) == "");
}

} // namespace program
