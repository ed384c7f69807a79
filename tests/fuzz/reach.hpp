#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <utility>

namespace fuzz {

/// What a fuzzer is to reach, each with how often it did. Printed at the end of the process, one line each, so that a
/// short run can be required to have reached all.
class Reach {
public:
    Reach(std::initializer_list<std::string_view> names);
    ~Reach();
    Reach(const Reach&) = delete;
    Reach& operator=(const Reach&) = delete;

    /// Counts; a name that is not among those to reach is a mistake in the fuzzer.
    void add(std::string_view name, std::size_t count = 1);

private:
    std::deque<std::pair<std::string, std::atomic<std::size_t>>> counts_;
};

} // namespace fuzz
