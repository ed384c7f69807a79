#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/alignment.hpp>
#include <rotconv/comparison.hpp>

#include "../../operations/operations.hpp"
#include "../../stream/numbers/number_text.hpp"
#include "../row_options.hpp"

/// What compare prints of its pairs, and the verdict.
namespace rotconv::cli {

/// A constant rotation as an option, --left or --right.
struct FoundRotation {
    std::string_view side;
    std::string text;
    FixedRotation rotation; ///< as the text has it
    double size;            ///< of what was found, radians
};
using FoundRotations = std::vector<FoundRotation>;

/// @param found rotations of attitudes that were rotated as `given`
[[nodiscard]] FoundRotations found_rotations(const ConstantRotations& found, const ConversionSettings& given);

/// How many pairs must have been compared.
struct LeastPairs {
    std::string text{}; ///< as it is given; empty: by default
    std::size_t pairs = 0;
    double percent = 0.0; ///< of FILE's data rows
};

/// What is to be told of the pairs, and what they must hold to.
struct Check {
    stream::Format format = stream::Format::pretty;
    stream::Digits digits{};              ///< of the numbers that are told
    AngleUnitName unit{};                 ///< of the angles that are told
    std::array<bool, 2> allow_unpaired{}; ///< rows of FILE, of REFERENCE
    LeastPairs least_pairs{};
    std::size_t worst = 0; ///< pairs to show
    operations::ComparisonRows rows{};
    ComparisonSettings comparing{};
    std::shared_ptr<const operations::PairFold> pairs{};
    std::shared_ptr<const FoundRotations> aligned{}; ///< null: they are not
};

/// The report and the verdict.
[[nodiscard]] Conclusion conclusion_of(const Check& check, const RowsCommand& command, const RowsResult& result);

} // namespace rotconv::cli
