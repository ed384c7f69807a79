#pragma once

#include <bit>
#include <cstdint>
#include <system_error>

#include "stream/numbers/scan_number.hpp"

/// What scan_number() makes of a text, and whether fast_float::from_chars() makes the same of it.
struct ScanComparison {
    bool is_same;   ///< both find no number, or one with the same bits and the same end
    bool is_number; ///< there is one
    bool is_direct; ///< NumberScan has read it: not by from_chars() in the end
    double value;
};

inline ScanComparison compare_scan(const char* begin, const char* end) {
    using rotconv::stream::NumberScan;
    double value = 0.0;
    double other = 0.0;
    double direct = 0.0;
    const char* const stop = rotconv::stream::scan_number(begin, end, value);
    const auto [other_stop, error] = fast_float::from_chars(begin, end, other);
    const bool is_number = error != std::errc::invalid_argument;
    const bool is_direct = end - begin >= NumberScan::reach && NumberScan(begin).scan(direct) != nullptr;
    const bool is_same =
        is_number ? stop == other_stop && std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(other)
                  : stop == nullptr;
    return {is_same, is_number, is_direct, value};
}
