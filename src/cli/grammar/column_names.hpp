#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rotconv/spec.hpp>

#include "../../stream/options.hpp"
#include "../../stream/rows/row_operation.hpp"
#include "words.hpp"

/// Names of numbers, as headers have them, held against a SPEC.
namespace rotconv::cli {

/// The name, in lower case, and the unit (deg, rad, s, ms, us or ns, if it is one) that a text of a header holds:
/// "yaw [deg]", "w_x_rad_s".
[[nodiscard]] std::pair<std::string, std::string_view> name_and_unit(const std::string& text);

/// Where names stand that are those of numbers.
struct KnownNames {
    std::vector<std::size_t> places; ///< of the numbers, in their order
    bool decides = true;  ///< otherwise they do not say which number each is: q0 q1 q2 q3, or yaw of euler:ZXZ
    int rank = 0;         ///< 0: rotconv's own names; 1: they share nothing; 2: a prefix or a suffix
    std::string prefix{}; ///< what they share before the numbers' own words, and behind them
    std::string suffix{};

    /// Their texts, of all that are there, in the order of the numbers.
    [[nodiscard]] std::vector<std::string> of(std::span<const std::string> names) const {
        return mapped(places, [names](std::size_t place) { return names[place]; });
    }
};

/// Numbers of a row that belong together: a time or key, an attitude, a vector, or velocities.
struct Part {
    std::vector<std::string> names; ///< as rotconv writes them
    std::size_t begin = 0;          ///< the place of the first number
    std::optional<Spec> attitude{};
    bool is_kept = false;     ///< a time or a key
    bool is_labelled = false; ///< x y z are components of a vector along the axes, or angles about them

    /// This part's slice of a list with an entry for each number of a row.
    [[nodiscard]] std::span<const std::string> of(std::span<const std::string> row) const {
        return row.subspan(begin, names.size());
    }
};

/// The numbers of a row.
[[nodiscard]] std::vector<Part> parts_of(const stream::RowNumbers& numbers);

/// Looks among names, in any case, for those of all numbers of a part; of several such sets the first counts. What
/// counts is what is left of them without a prefix and a suffix that all of them share, and without units: the names as
/// rotconv writes them; w (or s, scalar) x y z; 11 to 33, or 00 to 22; roll (or bank) pitch yaw (or heading, azimuth),
/// bare also r p y; of an angular velocity p q r, and x y z after a prefix such as gyro. Those that do not decide come
/// last: 0 1 2 3 and 1 2 3 4 of a quaternion, and roll pitch yaw of a sequence without y in the middle of three axes.
[[nodiscard]] std::optional<KnownNames> find_names(const Part& part, std::span<const std::string> names);
[[nodiscard]] std::optional<KnownNames> find_names(const Spec& spec, std::span<const std::string> names);

/// All sets of columns that may be taken for the numbers of parts, although nobody selects them: of each part the sets
/// that are the least unusual (its own column names, then others that share nothing, then the rest), but none of rates,
/// errors, commands and the like. A part with the SPEC of an earlier one takes the next of its sets, and of these
/// commands may be one.
struct ColumnSets {
    bool are_known = false;                       ///< each part has a set
    std::vector<std::vector<std::size_t>> rows{}; ///< each a choice of columns for all numbers
};
/// @param key the column of the key, by name or index, if a part is one
[[nodiscard]] ColumnSets sets_of_row(const std::vector<Part>& parts, const std::vector<std::string>& names,
                                     const std::string& key);

/// A LIST of columns: by name where each name is one word without marks, and of one column; else by index, so many or
/// more in a row as a range.
[[nodiscard]] std::string list_of_columns(std::span<const std::size_t> places,
                                          const std::vector<std::string>& names = {}, std::size_t least_range = 2);

/// Where rows of so many fields have the numbers of a SPEC in the files of its project.
[[nodiscard]] stream::ChosenColumns columns_of_project(const Spec& spec, std::size_t fields);

/// t, time, timestamp or stamp, perhaps with a unit.
[[nodiscard]] bool is_name_of_time(const std::string& name);

/// Whether nothing says which number of a quaternion is its first.
[[nodiscard]] bool has_open_order(const Spec& spec);

/// deg or rad, also of a rate, or a unit of time, as headers write it, in brackets or not; empty for others.
[[nodiscard]] std::string_view unit_of(std::string_view text);

/// Whether a name says that numbers are rates, errors, commands and the like.
[[nodiscard]] bool is_of_other_quantity(std::string_view name);

/// Whether a text is a unit and nothing else, in brackets or not.
[[nodiscard]] bool is_unit(std::string_view text);

/// What the names of columns say of the numbers of a row.
struct RowNames {
    std::vector<std::optional<KnownNames>> sets{}; ///< of each part; a column of one is in no other
    std::vector<std::size_t> places{}; ///< of each number: by its name if that decides, otherwise as the columns stand
};
[[nodiscard]] RowNames names_of_row(const std::vector<Part>& parts, std::vector<std::string> names);

} // namespace rotconv::cli
