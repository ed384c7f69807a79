#include "column_names.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>

#include <rotconv/euler.hpp>

#include "../operations/operations.hpp"
#include "../stream/key.hpp"

namespace rotconv::cli {
namespace {

/// Bytes of the longest text that is a unit, without blanks and _: microseconds.
constexpr std::size_t longest_unit = 12;

bool is_in_unit(char c) noexcept { return c != ' ' && c != '\t' && c != '_'; }

/// deg or rad, also of a rate, or a unit of time, as headers write it; empty for others.
std::string_view unit_of(std::string_view text) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> units{
        {{"deg", " deg degree degrees dps \u00B0 "},
         {"rad", " rad radian radians rps "},
         {"s", " s sec secs second seconds "},
         {"ms", " ms msec millisecond milliseconds "},
         {"us", " us usec \u00B5s \u03BCs microsecond microseconds "},
         {"ns", " ns nsec nsecs nanosecond nanoseconds "}}};
    std::string unit = lower(text);
    std::erase_if(unit, [](char c) { return !is_in_unit(c); });
    if (unit.size() > longest_unit) {
        return {};
    }
    for (const std::string_view per_second : {"", "/sec", "/s", "s^-1", "s-1", "pers", "s"}) {
        const std::string word = ' ' + unit.substr(0, unit.size() - std::min(unit.size(), per_second.size())) + ' ';
        for (const auto& [name, words] : units) {
            const bool fits = per_second.empty() || name == "deg" || name == "rad";
            if (fits && unit.ends_with(per_second) && word.size() > 2 && words.find(word) != std::string_view::npos) {
                return name;
            }
        }
    }
    return {};
}

/// What the names of a part's numbers may be, without what they share, in the order of the part.
using Spelling = std::vector<std::string>;

/// How headers spell a representation's own names, in its own order.
constexpr auto usual_spellings =
    std::to_array<std::pair<RepresentationId, std::string_view>>({{RepresentationId::quat, "w x y z"},
                                                                  {RepresentationId::quat, "s x y z"},
                                                                  {RepresentationId::quat, "scalar x y z"},
                                                                  {RepresentationId::quat, "0 1 2 3"},
                                                                  {RepresentationId::dcm, "11 12 13 21 22 23 31 32 33"},
                                                                  {RepresentationId::dcm, "00 01 02 10 11 12 20 21 22"},
                                                                  {RepresentationId::rpy, "roll pitch yaw"}});

/// In the order of a SPEC; none for most representations.
std::vector<Spelling> spellings_of(const Spec& spec) {
    std::array<std::size_t, 9> places{};
    std::ranges::copy(spec.order(), places.begin());
    RepresentationId name = spec.name;
    if (name == RepresentationId::euler || name == RepresentationId::rpy) {
        for (std::size_t i = 0; i < 3; ++i) {
            places.at(i) = static_cast<std::size_t>(spec.sequence.axis(i));
        }
        // Roll is about x and pitch about y: not in Metashape's -ZXY of yaw, pitch and roll, for example.
        const bool has_usual_axes = !spec.sequence.has_signs() || places[1] == 1;
        name = !spec.sequence.proper() && has_usual_axes ? RepresentationId::rpy : name;
    }
    std::vector<Spelling> spellings;
    for (const auto& [known, text] : usual_spellings) {
        if (known == name) {
            const auto words = words_in(text);
            Spelling& spelling = spellings.emplace_back();
            for (std::size_t i = 0; i < spec.size(); ++i) {
                spelling.push_back(words[places.at(i)]);
            }
        }
    }
    return spellings;
}

/// The SPECs with the same modifiers whose numbers have those names in an order of their own.
std::array<Spec, 2> alike(const Spec& like) {
    std::array<Spec, 2> specs{like, like};
    auto& [first, second] = specs;
    if (like.name == RepresentationId::quat) {
        second.scalar_last = !like.scalar_last;
    } else if (like.name == RepresentationId::dcm) {
        second.column_major = !like.column_major;
    } else { // yaw, pitch, roll about the body's axes are roll, pitch, yaw about the fixed ones
        std::array<bool, 3> is_negative{};
        for (std::size_t i = 0; i < 3; ++i) {
            is_negative.at(static_cast<std::size_t>(like.sequence.axis(i))) = like.sequence.sign(i) < 0.0;
        }
        const auto [x, y, z] = is_negative;
        first.name = x || y || z ? RepresentationId::euler : RepresentationId::rpy;
        first.sequence = roll_pitch_yaw.with_signs(x, y, z);
        second.name = RepresentationId::euler;
        second.sequence = EulerSequence("ZYX").with_signs(z, y, x);
    }
    return specs;
}

/// The sum of a text's bytes, each times a power of a base by its place, modulo 2^61 - 1. Where a part of a text is
/// replaced the new sum follows from the old one, without a look at the rest: names of any length take linear time.
struct TextSum {
    static constexpr std::uint64_t modulus = (std::uint64_t{1} << 61U) - 1;
    static constexpr std::uint64_t base = 1'229'363'429'801'019'168;
    static constexpr std::uint64_t inverse = 1'000'003; ///< base * inverse is 1

    std::uint64_t value = 0;
    std::uint64_t weight = 1; ///< of the byte behind the text

    explicit TextSum(std::string_view text = {}) { add(text); }
    void add(std::string_view text) {
        for (const char c : text) {
            value = reduced(stream::Uint128{weight} * (static_cast<unsigned char>(c) + 1U) + value);
            weight = reduced(stream::Uint128{weight} * base);
        }
    }
    static std::uint64_t reduced(stream::Uint128 number) noexcept {
        const auto sum = static_cast<std::uint64_t>((number & modulus) + (number >> 61U));
        return sum % modulus;
    }
};

/// A word that may stand in the place of another.
struct Replacement {
    Replacement(std::string_view word, std::size_t size) : text(word), sum(TextSum(word).value) {
        for (std::size_t i = std::min(size, word.size()); i < std::max(size, word.size()); ++i) {
            shift = TextSum::reduced(stream::Uint128{shift} * (size < word.size() ? TextSum::base : TextSum::inverse));
        }
    }
    /// The sum of the text with the word between what stands before it and after it.
    [[nodiscard]] std::uint64_t sum_between(const TextSum& before, std::uint64_t after) const noexcept {
        return TextSum::reduced(stream::Uint128{before.weight} * sum + stream::Uint128{after} * shift + before.value);
    }
    [[nodiscard]] bool is_between(std::string_view before, std::string_view after, std::string_view name) const {
        return name.size() == before.size() + text.size() + after.size() && name.starts_with(before) &&
               name.substr(before.size()).starts_with(text) && name.ends_with(after);
    }

    std::string_view text;
    std::uint64_t sum;
    std::uint64_t shift = 1; ///< what the weights of the bytes behind it are multiplied by
};

/// The places of a spelling among names, which may share a prefix and a suffix; none if not all of it is there.
std::vector<std::size_t> places_of(const Spelling& spelling, const std::vector<std::string>& names) {
    if (names.size() < spelling.size()) {
        return {};
    }
    const std::string& first = spelling.front();
    const auto words = mapped(spelling, [&first](const std::string& word) { return Replacement(word, first.size()); });
    const auto sums = mapped(names, [](const std::string& name) { return TextSum(name).value; });
    std::unordered_map<std::uint64_t, std::size_t> place_of;
    for (std::size_t i = 0; i < names.size(); ++i) {
        place_of.emplace(sums[i], i);
    }
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string_view name = names[i];
        TextSum before;
        std::size_t begin = 0;
        for (auto at = name.find(first); at != std::string_view::npos; at = name.find(first, at + 1)) {
            before.add(name.substr(begin, at - begin));
            begin = at;
            const std::uint64_t with_first = words.front().sum_between(before, 0);
            const std::uint64_t after = TextSum::reduced(stream::Uint128{sums[i]} + TextSum::modulus - with_first);
            places.clear();
            for (const Replacement& word : words) {
                const auto found = place_of.find(word.sum_between(before, after));
                if (found == place_of.end()) {
                    break;
                }
                places.push_back(found->second);
            }
            const auto is_there = [&](const Replacement& word, std::size_t place) { // and no other text of that sum
                return word.is_between(name.substr(0, at), name.substr(at + first.size()), names[place]);
            };
            if (std::ranges::equal(words, places, is_there)) {
                return places;
            }
        }
    }
    return {};
}

} // namespace

std::pair<std::string, std::string_view> name_and_unit(const std::string& text) {
    const auto bracket = text.ends_with(']')   ? text.rfind('[')
                         : text.ends_with(')') ? text.rfind('(')
                                               : std::string::npos;
    if (bracket != std::string::npos) {
        return {lower(stream::trimmed(text.substr(0, bracket))),
                unit_of(std::string_view(text).substr(bracket + 1, text.size() - bracket - 2))};
    }
    std::size_t end = text.size(); // of the name: the first _ behind which there is a unit and nothing else
    std::string_view unit;
    std::string_view unit_of_tail;
    bool is_new = true; // the tail has bytes that unit_of_tail has not seen
    for (std::size_t at = text.size(), count = 0; at-- > 1 && count <= longest_unit;) {
        if (is_in_unit(text[at])) {
            ++count;
            is_new = true;
        } else if (text[at] == '_') {
            unit_of_tail = std::exchange(is_new, false) ? unit_of(std::string_view(text).substr(at)) : unit_of_tail;
            if (!unit_of_tail.empty()) {
                end = at;
                unit = unit_of_tail;
            }
        }
    }
    return {lower(text.substr(0, end)), unit};
}

bool KnownNames::are_in_order() const noexcept {
    std::size_t next = 0;
    return std::ranges::all_of(places, [&next](std::size_t place) { return place == next++; });
}

std::vector<Part> parts_of(const stream::RowNumbers& numbers) {
    std::vector<Part> parts;
    auto name = numbers.names.begin();
    const auto add = [&](std::size_t size, const std::optional<Spec>& attitude = {}) {
        const auto begin = std::exchange(name, name + static_cast<std::ptrdiff_t>(size));
        if (size > 0) {
            parts.push_back({{begin, name}, static_cast<std::size_t>(begin - numbers.names.begin()), attitude});
        }
    };
    const std::size_t size = numbers.attitude ? numbers.attitude->size() : 0;
    const std::size_t second = numbers.second ? numbers.second->size() : 0;
    add(numbers.kept);
    add(size, numbers.attitude);
    add(numbers.names.size() - numbers.kept - size - second);
    add(second, numbers.second);
    return parts;
}

std::optional<KnownNames> find_names(const Part& part, std::span<const std::string> names) {
    const auto& spec = part.attitude;
    auto spellings = spec ? spellings_of(*spec) : std::vector<Spelling>();
    if (!spec || spec->has_own_columns) { // which come first
        spellings.insert(spellings.begin(), spec ? mapped(part.names, lower) : part.names);
    }
    std::vector<std::vector<std::string>> texts{mapped(names, lower)};
    texts.push_back(mapped(names, [](const std::string& name) { return name_and_unit(name).first; }));
    texts.resize(texts[0] == texts[1] ? 1 : 2); // without units, if there are any
    for (const Spelling& spelling : spellings) {
        for (const auto& each : texts) {
            if (auto places = places_of(spelling, each); !places.empty()) {
                return KnownNames{std::move(places), std::ranges::count(spelling, "0") > 0};
            }
        }
    }
    return std::nullopt;
}

std::optional<KnownNames> find_names(const Spec& spec, std::span<const std::string> names) {
    return find_names({operations::names_of(spec), 0, spec}, names);
}

std::string wrong_order(const Part& part, std::span<const std::string> names) {
    const auto known = find_names(part, names);
    if (!known || known->are_in_order()) {
        return {};
    }
    std::string order = joined(part.names);
    if (const auto& spec = part.attitude) {
        const auto specs = alike(*spec);
        const auto* const right =
            std::ranges::find_if(specs, [&](const Spec& each) { return find_names(each, names)->are_in_order(); });
        const bool is_euler = spec->name == RepresentationId::euler && !spec->has_own_columns;
        order = fmt::format("{}, which is {}{}", spec->text(), is_euler ? joined(spellings_of(*spec)[0]) : order,
                            right == specs.end() ? "" : fmt::format("; it is the order of {}", right->text()));
    }
    return fmt::format("{} is not the order of {}", quoted(joined(names)), order);
}

} // namespace rotconv::cli
