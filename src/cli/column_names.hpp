#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rotconv/spec.hpp>

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
};

/// Looks among names for those of all numbers of a project, quat, dcm, or roll, pitch and yaw, in any case. What counts
/// is what is left of them without a prefix and a suffix that all of them share, and without units: w (or s, scalar) x
/// y z; 11 to 33, or 00 to 22; roll pitch yaw; 0 1 2 3 for a quaternion.
[[nodiscard]] std::optional<KnownNames> find_names(const Spec& spec, std::span<const std::string> names);

/// The same of names that are given, such as those of a vector, which count in that spelling alone.
[[nodiscard]] std::optional<KnownNames> find_names(std::span<const std::string> own,
                                                   std::span<const std::string> names);

/// What is wrong with names that are `own` ones in another order, as the end of a sentence; otherwise empty.
[[nodiscard]] std::string wrong_order(std::span<const std::string> own, std::span<const std::string> names);

/// What is wrong with names that are those of the SPEC's numbers in another order, as the end of a sentence; otherwise
/// empty.
[[nodiscard]] std::string wrong_order(const Spec& spec, std::span<const std::string> names);

} // namespace rotconv::cli
