#include "vocabulary.hpp"

#include <algorithm>
#include <cctype>

#include "column_names.hpp"

namespace rotconv::cli {

bool is(std::string_view words, std::string_view word) {
    return !word.empty() && words.find(fmt::format(" {} ", lower(word))) != std::string_view::npos;
}

std::string_view unit_of_word(std::string_view word) {
    return is(vocabulary::degrees, word)   ? "deg"
           : is(vocabulary::radians, word) ? "rad"
           : is(vocabulary::length, word)  ? "m"
                                           : "";
}

std::string convention_in(std::string_view word) {
    const std::string low = lower(word);
    const std::string_view unit = unit_of_word(word);
    const auto is_named = [&low](Modifier modifier) { return name_of(modifier) == low; };
    return word.size() == 1                                                       ? ""
           : unit == "deg" || unit == "rad"                                       ? std::string(unit)
           : low == "ypr" || std::ranges::any_of(all_modifiers, is_named)         ? low
           : EulerSequence::parse(word) || named_representation(word).has_value() ? std::string(word)
                                                                                  : "";
}

std::string_view without_type(std::string_view word) {
    constexpr std::string_view decimals = "0123456789";
    const std::size_t end = word.find_last_not_of("dfi") + 1;
    word = word.substr(0, end > 0 && decimals.find(word[end - 1]) != std::string_view::npos ? end : word.size());
    const auto without_number = [decimals](std::string_view text) {
        return text.substr(0, text.find_last_not_of(decimals) + 1);
    };
    const std::string_view first = without_number(word);
    const bool is_product = first.size() < word.size() && first.size() > 1 &&
                            (first.ends_with('x') || first.ends_with('X')) &&
                            decimals.find(first[first.size() - 2]) != std::string_view::npos; // 3x4
    return is_product ? without_number(first.substr(0, first.size() - 1)) : first;
}

std::optional<RepresentationId> named_representation(std::string_view word) {
    if (word == "R") {
        return RepresentationId::dcm;
    }
    std::string text = lower(word);
    for (const std::string_view prefix : {"from_", "unit"}) {
        text.erase(0, text.starts_with(prefix) ? prefix.size() : 0);
    }
    const auto without_letter = text.substr(0, text.size() - (text.ends_with('d') || text.ends_with('f') ? 1 : 0));
    for (const std::string& each : {text, std::string(without_type(text)), without_letter}) {
        if (const Representation* const entry = find_representation(each == "rvec" ? "rotvec" : each)) {
            return entry->name;
        }
    }
    return std::nullopt;
}

std::vector<std::string> parts_of_label(std::string_view label) {
    std::vector<std::string> parts(1);
    for (std::size_t i = 0; i < label.size(); ++i) {
        const bool is_mark = std::string_view("_.: \t").find(label[i]) != std::string_view::npos;
        const bool begins = i > 0 && std::isupper(static_cast<unsigned char>(label[i])) != 0 &&
                            std::islower(static_cast<unsigned char>(label[i - 1])) != 0;
        if ((is_mark || begins) && !parts.back().empty()) {
            parts.emplace_back();
        }
        if (!is_mark) {
            parts.back() += label[i];
        }
    }
    return parts;
}

std::string unit_in(const std::string& label) {
    const auto unit = name_and_unit("_ " + joined(parts_of_label(label), "_")).second;
    return unit == "deg" || unit == "rad" ? std::string(unit) : std::string();
}

std::vector<std::string> conventions_in(const std::string& label) {
    auto words = mapped(parts_of_label(label), convention_in);
    words.erase(words.begin(), std::ranges::find(words.rbegin(), words.rend(), "").base());
    return words;
}

std::string name_in(const std::string& label) {
    const auto parts = parts_of_label(label);
    return *std::find_if_not(parts.rbegin(), parts.rend() - 1, [](const std::string& part) {
        return !unit_of_word(part).empty() || part == "xyzw" || part == "wxyz" || EulerSequence::parse(part);
    });
}

bool is_operation(std::string_view label) {
    return label.ends_with(".T") || label.ends_with("_T") ||
           std::ranges::any_of(parts_of_label(label), [](const auto& part) { return is(vocabulary::operation, part); });
}

bool is_derived(const std::string& label) {
    return std::ranges::any_of(mapped(parts_of_label(label), lower), [](const std::string& part) {
        return is(vocabulary::aside_anywhere, part) ||
               std::ranges::any_of(words_in(vocabulary::aside_beginning), [&part](const std::string& each) {
                   return part.starts_with(each) || part.ends_with(each); // rollspeed
               });
    });
}

bool is_aside(const std::string& label) { return is(vocabulary::aside, name_in(label)) || is_derived(label); }

} // namespace rotconv::cli
