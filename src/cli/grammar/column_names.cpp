#include "column_names.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <unordered_map>
#include <variant>

#include <rotconv/euler.hpp>

#include "../../core/projects.hpp"
#include "../../operations/operations.hpp"
#include "../../stream/beginning/column_list.hpp"
#include "vocabulary.hpp"

namespace rotconv::cli {
namespace {

/// Whether a name has a unit of angles by time.
bool is_unit_of_rate(std::string_view name) {
    const std::string text = lower(name);
    const auto is_in = [&text](std::string_view rate) { return text.find(rate) != std::string::npos; };
    return std::ranges::any_of(split("/s,s^-1,s-1,dps,rps,deg_s,rad_s,deg_per,rad_per,per s", ','), is_in);
}

/// What names may share that are those of numbers.
enum class Shared : std::uint8_t {
    anything,
    nothing,       ///< they stand side by side
    of_velocities, ///< a prefix that says so, or nothing where all other names are times
    of_quaternion, ///< q, of which there is no fourth number: QC of CCSDS
    of_labels,     ///< r, rot and the like, or nothing, and no suffix
};

/// What the names of a part's numbers may be, without what they share, in the order of the part.
struct Spelling {
    std::vector<std::string> words;
    bool decides = true; ///< which of the words is which number
    Shared shared = Shared::anything;
};

/// Those that do not decide are the last.
std::vector<Spelling> spellings_of(const Part& part) {
    using enum RepresentationId;
    std::vector<Spelling> spellings{{mapped(part.names, lower)}};
    if (part.names.front() == "wx") {
        spellings.push_back({{"p", "q", "r"}});
        spellings.push_back({{"x", "y", "z"}, true, Shared::of_velocities});
    }
    if (!part.attitude) {
        return spellings;
    }
    const Spec& spec = *part.attitude;
    std::array<std::size_t, 9> places{};
    std::ranges::copy(spec.order(), places.begin());
    const bool has_axes = spec.name == euler || spec.name == rpy;
    for (std::size_t i = 0; has_axes && i < 3; ++i) {
        places.at(i) = static_cast<std::size_t>(spec.sequence.axis(i));
    }
    const auto add = [&](std::string_view text, bool decides = true, Shared shared = Shared::anything) {
        const auto words = words_in(text);
        auto& added = spellings.emplace_back(Spelling{words, decides, shared}).words;
        for (std::size_t i = 0; decides && i < words.size(); ++i) {
            added[i] = words[places.at(i)];
        }
    };
    if (spec.name == quat) {
        add("w x y z");
        add("s x y z");
        add("scalar x y z");
        add("c 1 2 3", true, Shared::of_quaternion);
        add("0 1 2 3", false);
        add("1 2 3 4", false);
    } else if (spec.name == dcm) {
        add("11 12 13 21 22 23 31 32 33");
        add("00 01 02 10 11 12 20 21 22");
    } else if (has_axes && (spec.project == nullptr || spec.project->body.empty() || spec.project->body[0] == 'f')) {
        const bool decides = !spec.sequence.proper() && places[1] == 1; // roll is about x, and pitch about y
        for (const std::string_view roll : {"roll", "bank"}) {
            for (const std::string_view yaw : {"yaw", "heading", "azimuth"}) {
                add(fmt::format("{} pitch {}", roll, yaw), decides);
            }
        }
        add("r p y", decides, Shared::nothing);
    }
    const bool is_vector = spec.name == rotvec || spec.name == cayley || spec.name == mrp;
    if (part.is_labelled && (is_vector || (has_axes && spec.project == nullptr && !spec.sequence.proper()))) {
        add("x y z", true, Shared::of_labels);
    }
    return spellings;
}

/// The words of a name, in lower case, each with _ before and after it. They are parted at what is no letter and at a
/// change of case.
std::string own_words(std::string_view name) {
    std::string own = "_";
    for (std::size_t i = 0; i < name.size(); ++i) {
        const std::string c = lower(name.substr(i, 1));
        const bool is_letter = c[0] >= 'a' && c[0] <= 'z';
        const bool is_capital = is_letter && c[0] != name[i];
        if (own.back() != '_' && (!is_letter || (is_capital && lower(name.substr(i - 1, 1))[0] == name[i - 1]))) {
            own += '_';
        }
        own += is_letter ? c : "";
    }
    return own + (own.back() == '_' ? "" : "_");
}

/// Whether one of the words, which have blanks between them, is the first or the last of a name's own; a _ joins two.
bool has_at_end(std::string_view name, std::string_view words) {
    const std::string own = own_words(name);
    return std::ranges::any_of(words_in(words), [&own](const std::string& word) {
        const std::string whole = '_' + word + '_';
        return own.starts_with(whole) || own.ends_with(whole);
    });
}

/// Whether a name has a word that begins with one of these, and behind that the end.
bool has_word(std::string_view name, std::string_view beginnings, std::string_view end = "") {
    const std::string own = own_words(name);
    return std::ranges::any_of(words_in(beginnings), [&](const std::string& word) {
        return own.find(fmt::format("_{}{}", word, end)) != std::string::npos;
    });
}

/// What names say of numbers that are never taken by themselves.
bool is_of_error(std::string_view name) {
    return has_word(name, "speed spd dps acc std sigma cov var err delta reset offset bias") ||
           has_word(name, "dot", "_");
}
bool is_of_rate(std::string_view name) { return has_word(name, "rate vel"); }
bool is_of_command(std::string_view name) {
    return has_word(name, "cmd setpoint target ref") || has_word(name, "sp des desired", "_");
}

/// Names that are words between one prefix and one suffix.
struct FoundWords {
    std::size_t prefix;              ///< its size
    std::vector<std::size_t> places; ///< of the names, in the order of the words
};
/// All of them. A name that stands twice, or that is as long as a text, is in none.
std::vector<FoundWords> find_words(const std::vector<std::string>& words, const std::vector<std::string>& names) {
    constexpr std::size_t longest = 200;
    std::unordered_map<std::string_view, std::vector<std::size_t>> places_of;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].size() <= longest) {
            places_of[names[i]].push_back(i);
        }
    }
    std::vector<FoundWords> found;
    for (const std::string& name : names) {
        const auto first = name.size() > longest ? std::string::npos : name.find(words.front());
        for (auto at = first; at != std::string::npos; at = name.find(words.front(), at + 1)) {
            std::vector<std::size_t> places;
            for (const std::string& word : words) {
                const auto place = places_of.find(std::string(name).replace(at, words.front().size(), word));
                if (place == places_of.end() || place->second.size() > 1) {
                    break;
                }
                places.push_back(place->second.front());
            }
            if (places.size() == words.size()) {
                found.push_back({at, std::move(places)});
            }
        }
    }
    return found;
}

/// Whether the words, which stand at `places` of the names without units, share what they may.
bool is_shared(const Spelling& spelling, std::string_view prefix, std::string_view suffix,
               const std::vector<std::size_t>& places, const std::vector<std::string>& names) {
    const auto& words = spelling.words;
    if (spelling.shared == Shared::anything) {
        return true;
    }
    if (spelling.shared == Shared::of_quaternion) {
        return lower(prefix) == "q" && std::ranges::count(names, "q0") + std::ranges::count(names, "q4") == 0;
    }
    const bool is_bare = names[places[0]] == words[0];
    if (spelling.shared == Shared::nothing) {
        return is_bare && std::ranges::max(places) - std::ranges::min(places) + 1 == places.size();
    }
    if (spelling.shared == Shared::of_labels) {
        const std::string own = without_marks(prefix);
        return (own.empty() || is(vocabulary::vector_of_angles, own)) && without_marks(suffix).empty();
    }
    const auto is_own_or_time = [&words](const std::string& name) {
        return std::ranges::count(words, name) > 0 || has_at_end(name, "t time timestamp stamp");
    };
    return is_bare ? std::ranges::all_of(names, is_own_or_time)
                   : has_at_end(prefix, "w omega gyro gyr gyroscope angular_velocity");
}

/// A name without what stands between two digits: mat[11] of Mat[1][1], r11 of r_1_1.
std::string with_indices_joined(const std::string& name) {
    const auto is_digit_at = [&name](std::size_t at) { return at < name.size() && is_digits(name.substr(at, 1)); };
    std::string joined;
    for (std::size_t i = 0; i < name.size(); ++i) {
        std::size_t next = i + 1;
        while (next < name.size() && !is_alphanumeric(name[next])) {
            ++next;
        }
        joined += name[i];
        i = is_digit_at(i) && is_digit_at(next) ? next - 1 : i;
    }
    return joined;
}

/// All sets of names, each once; those that do not decide only where no other is.
std::vector<KnownNames> all_sets(const Part& part, std::span<const std::string> names) {
    std::vector<std::vector<std::string>> texts{mapped(names, lower)};
    texts.push_back(mapped(names, [](const std::string& name) { return name_and_unit(name).first; }));
    texts.resize(texts[0] == texts[1] ? 1 : 2); // without units, if there are any
    if (part.attitude && part.attitude->name == RepresentationId::dcm) {
        texts.push_back(mapped(texts.front(), with_indices_joined));
    }
    std::vector<KnownNames> found;
    std::set<std::vector<std::size_t>> known;
    const auto spellings = spellings_of(part);
    for (const Spelling& spelling : spellings) {
        if (!found.empty() && !spelling.decides) {
            break;
        }
        for (const auto& each : texts) {
            for (const auto& [size, places] : find_words(spelling.words, each)) {
                const std::string prefix = names[places[0]].substr(0, size);
                const std::string suffix = names[places[0]].substr(size + spelling.words[0].size());
                const bool is_bare = each[places[0]] == spelling.words[0];
                const int rank = !is_bare ? 2 : &spelling == spellings.data() ? 0 : 1;
                if (is_shared(spelling, prefix, suffix, places, each) && known.insert(places).second) {
                    found.push_back({places, spelling.decides, rank, prefix, suffix});
                }
            }
        }
    }
    return found;
}

/// Whether the set may be taken although nobody selects it. @param is_pair two attitudes of one SPEC are looked for
bool may_be_taken(const KnownNames& set, const Part& part, std::span<const std::string> names, bool is_pair) {
    if (!set.decides) {
        const bool is_from_one = set.of(names)[0].find('1') != std::string::npos;
        return part.attitude->name == RepresentationId::quat && has_at_end(set.prefix, "q quat quaternion attitude") &&
               (!is_from_one || part.attitude->has_given_order || part.attitude->project != nullptr);
    }
    const bool has_angles = part.attitude && representation(part.attitude->name).has_angles();
    auto texts = set.of(names);
    texts.push_back(set.suffix);
    return std::ranges::none_of(texts, [&](const std::string& name) {
        const bool has_rate = has_angles && is_unit_of_rate(name);
        const bool is_other = set.rank > 0 && (is_of_error(name) || (part.attitude && is_of_rate(name)) ||
                                               (!is_pair && is_of_command(name)));
        return has_rate || is_other;
    });
}

/// The columns of times, or of the key.
std::vector<KnownNames> kept_columns(const std::vector<std::string>& names, const std::string& key) {
    std::vector<KnownNames> found;
    if (!key.empty()) {
        const auto places = std::get<stream::ColumnList>(stream::ColumnList::parse(key, 1)).positions(names);
        const auto* const place = std::get_if<std::vector<std::size_t>>(&places);
        return place == nullptr ? found : std::vector{KnownNames{*place}};
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        found.insert(found.end(), is_name_of_time(names[i]) ? 1 : 0, KnownNames{{i}});
    }
    return found;
}

} // namespace

std::string_view unit_of(std::string_view text) {
    if ((text.starts_with('[') && text.ends_with(']')) || (text.starts_with('(') && text.ends_with(')'))) {
        text = text.substr(1, text.size() - 2);
    }
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> units{
        {{"deg", " deg degree degrees dps \u00B0 "},
         {"rad", " rad radian radians rps "},
         {"s", " s sec secs second seconds "},
         {"ms", " ms msec millisecond milliseconds "},
         {"us", " us usec \u00B5s \u03BCs microsecond microseconds "},
         {"ns", " ns nsec nsecs nanosecond nanoseconds "}}};
    std::string unit = lower(text);
    std::erase_if(unit, [](char c) { return c == ' ' || c == '\t' || c == '_'; });
    for (const std::string_view per_second : {"", "/sec", "/s", "s^-1", "s-1", "pers", "s"}) {
        const std::string word = unit.substr(0, unit.size() - std::min(unit.size(), per_second.size()));
        for (const auto& [name, words] : units) {
            const bool fits = per_second.empty() || name == "deg" || name == "rad";
            if (fits && unit.ends_with(per_second) && is(words, word)) {
                return name;
            }
        }
    }
    return {};
}

std::pair<std::string, std::string_view> name_and_unit(const std::string& text) {
    const auto bracket = text.ends_with(']')   ? text.rfind('[')
                         : text.ends_with(')') ? text.rfind('(')
                                               : std::string::npos;
    if (bracket != std::string::npos) {
        return {lower(stream::trimmed(text.substr(0, bracket))),
                unit_of(std::string_view(text).substr(bracket + 1, text.size() - bracket - 2))};
    }
    constexpr std::size_t longest_tail = 24; // microseconds with its _
    for (std::size_t at = text.find('_', std::max(text.size(), longest_tail + 1) - longest_tail);
         at != std::string::npos; at = text.find('_', at + 1)) { // the first behind which there is a unit, and no more
        if (const auto unit = unit_of(std::string_view(text).substr(at)); !unit.empty()) {
            return {lower(text.substr(0, at)), unit};
        }
    }
    return {lower(text), {}};
}

bool is_unit(std::string_view text) {
    constexpr std::string_view in_brackets = " na n/a none % v c km ft hz pa hpa mbar ut "; // without, perhaps data
    const std::string_view own = text.substr(std::min(text.find_first_not_of("[("), text.size()));
    const std::string_view word = own.substr(0, own.find_last_not_of("])") + 1);
    return !unit_of(text).empty() || is(" m mm cm m/s m/s^2 m/s2 g 1 ", word) ||
           (own.size() < text.size() && is(in_brackets, word));
}

bool is_name_of_time(const std::string& name) { return is(" t time timestamp stamp ", name_and_unit(name).first); }

bool has_open_order(const Spec& spec) {
    return spec.name == RepresentationId::quat && !spec.has_given_order && spec.project == nullptr;
}

bool is_of_other_quantity(std::string_view name) {
    return is_of_error(name) || is_of_rate(name) || is_of_command(name) || has_word(name, "gyro", "_");
}

std::vector<Part> parts_of(const stream::RowNumbers& numbers) {
    std::vector<Part> parts;
    auto name = numbers.names.begin();
    const auto add = [&](std::size_t size, const std::optional<Spec>& attitude = {}, bool is_kept = false) {
        const auto begin = std::exchange(name, name + static_cast<std::ptrdiff_t>(size));
        if (size > 0) {
            parts.push_back(
                {{begin, name}, static_cast<std::size_t>(begin - numbers.names.begin()), attitude, is_kept});
        }
    };
    const std::size_t size = numbers.attitude ? numbers.attitude->size() : 0;
    const std::size_t second = numbers.second ? numbers.second->size() : 0;
    add(numbers.kept, {}, true);
    add(size, numbers.attitude);
    add(numbers.names.size() - numbers.kept - size - second);
    add(second, numbers.second);
    return parts;
}

std::optional<KnownNames> find_names(const Part& part, std::span<const std::string> names) {
    auto sets = all_sets(part, names);
    const auto best = std::ranges::min_element(
        sets, {}, [](const KnownNames& set) { return std::pair(!set.decides, std::ranges::min(set.places)); });
    if (best == sets.end()) {
        return std::nullopt;
    }
    if (!best->decides) {
        std::ranges::sort(best->places); // as the columns stand
    }
    return *best;
}

ColumnSets sets_of_row(const std::vector<Part>& parts, const std::vector<std::string>& names, const std::string& key) {
    ColumnSets sets{.are_known = true, .rows = {{}}};
    std::vector<KnownNames> of_pair; // of two attitudes with the same SPEC
    for (const Part& part : parts) {
        const auto is_twin = [&part](const Part& other) {
            return &other != &part && other.attitude && part.attitude &&
                   other.attitude->text() == part.attitude->text();
        };
        const bool is_pair = std::ranges::any_of(parts, is_twin);
        auto found = part.is_kept ? kept_columns(names, key) : all_sets(part, names);
        sets.are_known = sets.are_known && (part.is_kept || !found.empty());
        std::erase_if(found,
                      [&](const KnownNames& set) { return !part.is_kept && !may_be_taken(set, part, names, is_pair); });
        const int least = found.empty() ? 0 : std::ranges::min_element(found, {}, &KnownNames::rank)->rank;
        if (is_pair) {
            std::ranges::sort(found, {}, [](const KnownNames& set) { return std::ranges::min(set.places); });
            const bool is_second = std::find_if(parts.begin(), parts.end(), is_twin)->begin < part.begin;
            found = found.size() == 2 ? std::vector{found[is_second ? 1 : 0]} : std::vector<KnownNames>();
        } else {
            std::erase_if(found, [least](const KnownNames& set) { return set.rank > least; });
        }
        std::vector<std::vector<std::size_t>> longer;
        for (const auto& row : sets.rows) {
            for (const KnownNames& set : found) {
                if (std::ranges::find_first_of(row, set.places) == row.end()) {
                    longer.push_back(row);
                    longer.back().insert(longer.back().end(), set.places.begin(), set.places.end());
                }
            }
        }
        sets.rows = std::move(longer);
    }
    return sets;
}

std::optional<KnownNames> find_names(const Spec& spec, std::span<const std::string> names) {
    const auto columns = spec.columns();
    return find_names({{columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(spec.size())}, 0, spec}, names);
}

RowNames names_of_row(const std::vector<Part>& parts, std::vector<std::string> names) {
    RowNames row;
    std::vector<bool> is_free(names.size(), true);
    for (const Part& part : parts) {
        if (part.is_kept && part.names.front() == "key") { // its column is told
            names[part.begin].clear();
        }
        auto& set = row.sets.emplace_back(part.is_kept ? std::nullopt : find_names(part, names));
        if (!set && !part.is_kept) { // names that other parts have too
            set = find_names(part, part.of(names));
            for (std::size_t i = 0; set && i < set->places.size(); ++i) {
                set->places[i] += part.begin;
            }
        }
        for (const std::size_t place : set ? set->places : std::vector<std::size_t>()) {
            names[place].clear();
            is_free[place] = false;
        }
    }
    std::size_t next = 0; // of the columns in no set
    for (std::size_t k = 0; k < parts.size(); ++k) {
        auto places = row.sets[k] ? row.sets[k]->places : std::vector<std::size_t>();
        for (; places.size() < parts[k].names.size(); ++next) {
            if (is_free[next]) {
                places.push_back(next);
            }
        }
        row.places.insert(row.places.end(), places.begin(), places.end());
    }
    return row;
}

std::string list_of_columns(std::span<const std::size_t> places, const std::vector<std::string>& names,
                            std::size_t least_range) {
    const auto words = mapped(names, [](const std::string& name) { return name.substr(0, name.find(' ')); });
    const bool by_name = !names.empty() && std::ranges::all_of(places, [&words](std::size_t place) {
        const std::string& word = words[place];
        const bool has_ends = !word.empty() && word[0] != '-' && word.back() != '/';
        return has_ends && std::ranges::count(words, word) == 1 &&
               word.find_first_not_of("0123456789-") != std::string::npos && std::ranges::all_of(word, [](char c) {
                   return is_alphanumeric(c) || std::string_view("_.[]-/").find(c) != std::string_view::npos;
               });
    });
    std::vector<std::string> items;
    for (std::size_t i = 0, end = 0; i < places.size(); i = end) {
        for (end = i + 1; !by_name && end < places.size() && places[end] == places[end - 1] + 1;) {
            ++end;
        }
        const bool is_range = end - i >= least_range;
        end = is_range ? end : i + 1;
        items.push_back(by_name    ? words[places[i]]
                        : is_range ? fmt::format("{}-{}", places[i] + 1, places[end - 1] + 1)
                                   : std::to_string(places[i] + 1));
    }
    return joined(items);
}

stream::ChosenColumns columns_of_project(const Spec& spec, std::size_t fields) {
    const std::string list = spec.project == nullptr ? "" : columns_in_rows(*spec.project, spec.size(), fields);
    if (list.empty()) {
        return {};
    }
    return {.are_known = true,
            .positions = std::get<stream::ColumnList>(stream::ColumnList::parse(list, spec.size())).positions(),
            .text = fmt::format("{} fields are read as those of {}: --columns {}", fields, spec.project->text, list)};
}

} // namespace rotconv::cli
