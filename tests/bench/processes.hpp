#pragma once

#include <filesystem>
#include <random>
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

/// A folder that is gone with the object.
class Folder {
public:
    /// @throw std::runtime_error where none can be made
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::string operator/(const char* name) const { return (path_ / name).string(); }

private:
    std::filesystem::path path_;
};

/// Uniform attitudes, the same for each run.
class Attitudes {
public:
    struct Components {
        double w, x, y, z;
    };

    Components next();
    /// One as a row of 17 digits, without line end.
    std::string next_row();

private:
    std::mt19937_64 engine_{1};
    std::normal_distribution<double> normal_;
};
