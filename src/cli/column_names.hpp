#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rotconv/spec.hpp>

#include "../stream/row_operation.hpp"
#include "words.hpp"

/// Names of numbers, as headers have them, held against a SPEC.
namespace rotconv::cli {

/// The name, in lower case, and the unit (deg, rad, s, ms, us or ns, if it is one) that a text of a header holds:
/// "yaw [deg]", "w_x_rad_s".
[[nodiscard]] std::pair<std::string, std::string_view> name_and_unit(const std::string& text);

/// Where names stand that are those of a SPEC.
struct KnownNames {
    std::vector<std::size_t> places; ///< of the SPEC's numbers, in its order
    bool is_numbered = false;        ///< they are 0 1 2 3, which most programs begin with the scalar

    /// They are the first ones, and in the order of the SPEC.
    [[nodiscard]] bool are_in_order() const noexcept;
    /// Their texts, of all that are there, in the order of the SPEC.
    [[nodiscard]] std::vector<std::string> of(std::span<const std::string> names) const {
        return mapped(places, [names](std::size_t place) { return names[place]; });
    }
    /// Their columns, from 1, with commas.
    [[nodiscard]] std::string columns() const {
        return joined(mapped(places, [](std::size_t place) { return place + 1; }));
    }
};

/// Numbers of a row that belong together: a time or key, an attitude, a vector, or velocities.
struct Part {
    std::vector<std::string> names; ///< as rotconv writes them
    std::size_t begin = 0;          ///< the place of the first number
    std::optional<Spec> attitude{};

    /// Its own among what stands for each number of a row.
    [[nodiscard]] std::span<const std::string> of(std::span<const std::string> row) const {
        return row.subspan(begin, names.size());
    }
};

/// The numbers of a row.
[[nodiscard]] std::vector<Part> parts_of(const stream::RowNumbers& numbers);

/// Looks among names, in any case, for those of all numbers of a project, quat, dcm, or roll, pitch and yaw, or of a
/// part without an attitude. What counts is what is left of them without a prefix and a suffix that all of them share,
/// and without units: w (or s, scalar) x y z; 11 to 33, or 00 to 22; roll pitch yaw; 0 1 2 3 for a quaternion.
[[nodiscard]] std::optional<KnownNames> find_names(const Part& part, std::span<const std::string> names);
[[nodiscard]] std::optional<KnownNames> find_names(const Spec& spec, std::span<const std::string> names);

/// What is wrong with names that are those of the part's numbers in another order, as the end of a sentence; otherwise
/// empty.
[[nodiscard]] std::string wrong_order(const Part& part, std::span<const std::string> names);

} // namespace rotconv::cli
