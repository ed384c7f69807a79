#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include <catch.hpp>

#include "process.hpp"

namespace program {

/// Exit 2, nothing on stdout, one line on stderr with these words.
inline void check_usage_error(const std::string& arguments, std::initializer_list<std::string_view> words) {
    INFO("rotconv " << arguments);
    CHECK(run(arguments, "1 0 0 0\n") == stopped("", Words(words.begin(), words.end())));
}

/// The same of each, whatever the words.
inline void check_usage_errors(std::initializer_list<const char*> command_lines, const std::string& input) {
    for (const char* arguments : command_lines) {
        INFO("rotconv " << arguments);
        CHECK(run(arguments, input) == stopped(""));
    }
}

} // namespace program
