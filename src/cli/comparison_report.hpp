#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rotconv/alignment.hpp>
#include <rotconv/conversion.hpp>

#include "../operations/operations.hpp"
#include "../stream/number_text.hpp"
#include "command.hpp"
#include "words.hpp"

/// What compare prints of its pairs, and the verdict.
namespace rotconv::cli {

/// The largest angle that passes.
struct Limit {
    std::string text{};                                     ///< as it was given, with its unit; empty: there is none
    double angle = std::numeric_limits<double>::infinity(); ///< in the unit of the output
    std::string_view unit{};
};

/// What is to be told of the pairs, and what they must hold to.
struct Check {
    enum class Format : std::uint8_t { pretty, json, csv };

    Format format = Format::pretty;
    Limit within{};
    Limit within_p95{};
    std::array<bool, 2> allow_unpaired{}; ///< rows of FILE, of REFERENCE
    bool allow_failed = false;
    std::vector<std::pair<std::string, double>> percentiles{}; ///< with their names
    std::size_t worst = 0;                                     ///< pairs to show
    bool degrees = false;
    bool turns = false; ///< --delta: no constant turn is looked for
    bool by_key = false;
    stream::Digits digits{};
    std::string file{};
    std::string reference{};  ///< empty: there is none
    std::size_t own_size = 0; ///< numbers of the first attitude
    ConversionSettings reading{};

    /// Of radians.
    [[nodiscard]] double in_unit(double radians) const { return degrees ? degrees_per_radian * radians : radians; }
};

/// A constant turn as an option, --left or --right.
struct TurnOption {
    std::string_view side;
    std::array<double, 4> q;
    double size; ///< of what was found, radians

    [[nodiscard]] std::string text() const;
};
using TurnOptions = std::vector<TurnOption>;
/// @param found turns of attitudes that were turned as `given`
[[nodiscard]] TurnOptions turn_options(const ConstantTurns& found, const ConversionSettings& given);

/// @param aligned null: the attitudes are not aligned
[[nodiscard]] std::shared_ptr<Conclusion> comparison_conclusion(Check check,
                                                                std::shared_ptr<operations::PairWatch> watch,
                                                                std::shared_ptr<const TurnOptions> aligned);

} // namespace rotconv::cli
