#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <rotconv/spec.hpp>

namespace rotconv {

/// A program, file format, robot or book, and what its numbers are. Those called presets are modifiers, too: each
/// representation lists what they mean for it.
struct Project {
    std::string_view text;    ///< its name
    std::string_view others;  ///< its other names, with blanks between
    std::string_view specs;   ///< the SPEC of its numbers; a few words after it, or several with "; " between, are for
                              ///< people; empty: there is none
    std::string_view columns; ///< the names of its numbers, with blanks between, in the representation's own order;
                              ///< empty: those of the representation
    std::string_view reference; ///< its reference axes, as in parse_axes(); empty: none in particular
    std::string_view body;      ///< its body axes
    std::string_view source;    ///< the file, page or book that says so
    std::string_view remark;

    /// Whether its numbers are one SPEC, for which the name stands.
    [[nodiscard]] constexpr bool is_spec() const noexcept {
        return !specs.empty() && specs.find(';') == std::string_view::npos;
    }
};

[[nodiscard]] std::span<const Project> projects() noexcept;
/// The projects that are modifiers.
[[nodiscard]] std::span<const Project> presets() noexcept;
/// The project with this name or another one, in any case and with or without - and _, or null.
[[nodiscard]] const Project* find_project(std::string_view name) noexcept;

/// Where the numbers stand in rows of a project's files, as a list of columns from 1; empty if that is not known.
/// @param size of the SPEC @param fields of a row
[[nodiscard]] std::string columns_in_rows(const Project& project, std::size_t size, std::size_t fields);

} // namespace rotconv
