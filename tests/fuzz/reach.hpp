#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

/// What a fuzzer is to reach, each with how often it did. Printed at the end of the process, one line each, so that a
/// run can be required to have reached all.
class Reach {
public:
    Reach(std::initializer_list<std::string_view> names);
    ~Reach();
    Reach(const Reach&) = delete;
    Reach& operator=(const Reach&) = delete;

    /// The input to which what is counted from now on belongs.
    void begin(std::string_view input) { input_ = input; }
    /// Counts; a name that is not among those to reach is a mistake in the fuzzer.
    void add(std::string_view name, std::size_t count = 1);
    /// An input that has reached what was reached least; empty before the first.
    [[nodiscard]] const std::string& rarest() const;

private:
    struct Entry {
        std::string name;
        std::size_t count = 0;
        std::string input{}; ///< the last short one
    };
    std::vector<Entry> entries_;
    std::string_view input_;
};

} // namespace fuzz
