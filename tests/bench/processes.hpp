#pragma once

#include <string>

/// What a process took, in seconds.
struct Time {
    double clock;
    double processor; ///< of the user and the system
};

/// The less of each.
[[nodiscard]] Time least(const Time& a, const Time& b);

/// Runs a shell command.
/// @throw std::runtime_error where it fails
[[nodiscard]] Time time_of(const std::string& command);
