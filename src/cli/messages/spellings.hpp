#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rotconv/spec.hpp>

#include "../../core/projects.hpp"

/// What a word may mean that is spelled in another way, or belongs to another program.
namespace rotconv::cli::messages {

using Words = std::vector<std::string>;
using Legal = std::vector<std::string_view>;

/// The legal word that is written alike, or at most two letters away (one, below five letters); perhaps none.
[[nodiscard]] Words choose_nearest(std::string_view text, const Legal& legal);
/// What may be meant by a word, as Meaning::instead says it: what it means elsewhere, another way of writing what is
/// known, or the legal word that is spelled nearly so.
[[nodiscard]] Words meant(std::string_view word, const Legal& legal);
/// A SPEC with a modifier, which may also be its sequence, or the case of its letters: upper, lower.
[[nodiscard]] Words with_modifier(const std::string& spec, const std::string& modifier);
/// The SPECs that a text which is not a SPEC may mean. With an empty one the option is left out.
[[nodiscard]] Words meant_specs(const std::string& text, const SpecError& error);
/// The SPECs of a project that has several; a list of columns may stand behind one.
[[nodiscard]] Words specs_of(const Project& project);

} // namespace rotconv::cli::messages
