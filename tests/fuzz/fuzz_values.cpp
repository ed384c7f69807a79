// The first line is a SPEC, the rest a text with its attitude, as people type and programs print it; after "words"
// instead of a SPEC each byte is a word, a bracket, a sign or a number of such a text. Never a crash; and what is
// accepted is held against a second, plain reading: no number is made up, moved, negated or lost without a label, and
// no operation, order or unit is passed over.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "cli/grammar/values.hpp"
#include "cli/option_set.hpp"
#include "command_text.hpp"
#include "operations/operations.hpp"
#include "reach.hpp"

namespace {

using namespace rotconv;

// Counted are texts that were accepted, by what they have, and those that were refused.
fuzz::Reach reach{
    // clang-format off
        "accepted", "refused", "accepted of words", "refused of words", "bare numbers", "brackets", "elements",
        "quotes", "several lines", "labels", "numbers left out", "sums", "units", "orders applied", "calls", "4x4",
        "notes",
    // clang-format on
};

constexpr std::array specs{"quat", "quat:xyzw", "rpy",        "rpy:deg", "euler:ZYX:deg",
                           "dcm",  "rotvec",    "axis-angle", "6d",      "kuka"};

/// A byte of a text of words is one of these.
const std::vector<std::string> words = [] {
    auto all = fuzz::words_of(
        "w x y z roll pitch yaw A B C q R quat rpy dcm Quaternion from_quat array np.float64 matrix rotation "
        "orientation position pos translation t header xyzw wxyz xyz ZYX ypr passive deg rad degrees ° mm m "
        "in inv inverse conj transpose .T dtype frame_id order degrees=True scalar_first True foo foo.bar _ "
        "rpy_deg q_xyzw i j k f deg = : := , ; ( ) [ ] { } < > /> </q> <q ' \" | - + * / ~ ^ ! --- ... \\ 0x "
        "1e",
        ' ');
    all.insert(all.end(), {"\n", "\n  ", "\n    ", "- "});
    return all;
}();

void check(bool holds, const char* what, const std::string& text, const std::string& row) {
    if (!holds) {
        std::fprintf(stderr, "%s\n--- text\n%s\n--- read\n%s\n", what, text.c_str(), row.c_str());
        std::abort();
    }
}

/// A number of a text, and the name before it.
struct Numeral {
    std::string text, label;
    char letter = '\0';      ///< i, j or k behind it
    bool after_sign = false; ///< a sign or operator stands by itself before it, which does not begin a line
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<signed char>(c) < 0;
}

/// The size of the decimal at the beginning.
std::size_t decimal_size(std::string_view text) {
    const auto digits = [&text](std::size_t at) {
        const std::size_t begin = at;
        while (at < text.size() && is_digit(text[at])) {
            ++at;
        }
        return at - begin;
    };
    std::size_t at = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
    for (const std::string_view word : {"infinity", "inf", "nan"}) {
        std::string begin(text.substr(at, word.size()));
        std::ranges::transform(begin, begin.begin(), [](char c) { return static_cast<char>(c | ' '); });
        if (begin == word) {
            return at + word.size();
        }
    }
    const std::size_t whole = digits(at);
    at += whole;
    const std::size_t part = at < text.size() && text[at] == '.' ? digits(at + 1) : 0;
    if (whole + part == 0) {
        return 0;
    }
    at += at < text.size() && text[at] == '.' ? part + 1 : 0;
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        const std::size_t sign = at + 1 < text.size() && (text[at + 1] == '-' || text[at + 1] == '+') ? 1 : 0;
        const std::size_t exponent = digits(at + 1 + sign);
        at += exponent > 0 ? 1 + sign + exponent : 0;
    }
    return at;
}

/// The name that ends before `end`, with quotes, : and = between, but no bracket.
std::string label_before(const std::string& text, std::size_t end) {
    const std::size_t last = text.find_last_not_of(" \t\"'=:", end - 1);
    if (end == 0 || last == std::string::npos || !(is_letter(text[last]) || is_digit(text[last]))) {
        return {};
    }
    std::size_t begin = last;
    while (begin > 0 && (is_letter(text[begin - 1]) || is_digit(text[begin - 1]) || text[begin - 1] == '.')) {
        --begin;
    }
    return is_letter(text[begin]) ? text.substr(begin, last + 1 - begin) : std::string();
}

std::vector<Numeral> numerals_of(const std::string& text) {
    std::vector<Numeral> numerals;
    for (std::size_t at = 0; at < text.size();) {
        const char before = at > 0 ? text[at - 1] : ' ';
        const bool is_in_name =
            is_letter(before) || before == '.' || (before == '-' && at > 1 && is_letter(text[at - 2]));
        const bool begins = !is_in_name && (!is_digit(before) || text[at] == '+' || text[at] == '-');
        std::size_t size = begins ? decimal_size(std::string_view(text).substr(at)) : 0;
        const std::size_t end = at + size;
        std::size_t after = end;
        while (after < text.size() && is_letter(text[after])) {
            ++after;
        }
        const std::string tail = text.substr(end, after - end);
        const std::string units = " f F i j k deg degree degrees rad radian radians mm cm m in ° ";
        if (size > 0 && (tail.empty() || units.find(" " + tail + " ") != std::string::npos)) {
            const std::size_t sign = at > 0 ? text.find_last_not_of(" \t(", at - 1) : std::string::npos;
            const bool is_mark = sign != std::string::npos && sign > 1 && text.substr(sign - 2, 3) == "---";
            const bool is_sign = sign != std::string::npos && !is_mark &&
                                 std::string_view("+-*/~^!").find(text[sign]) != std::string_view::npos;
            const std::size_t line = is_sign && sign > 0 ? text.find_last_not_of(" \t", sign - 1) : std::string::npos;
            const bool begins_line = line == std::string::npos || text[line] == '\n';
            numerals.push_back({text.substr(at, size), label_before(text, at),
                                tail == "i" || tail == "j" || tail == "k" ? tail[0] : '\0',
                                is_sign && !(begins_line && text[sign] == '-')});
        }
        at = size > 0 ? after : at + 1;
    }
    return numerals;
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | ' ') : c; });
    return text;
}

/// Whether the word stands in the text by itself.
bool has_word(const std::string& text, std::string_view word) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const char after = at + word.size() < text.size() ? text[at + word.size()] : ' ';
        const char before = at > 0 ? text[at - 1] : ' ';
        if (!is_letter(after) && !is_digit(after) && (before == '_' || (!is_letter(before) && !is_digit(before)))) {
            return true;
        }
    }
    return false;
}
bool has_any(const std::string& text, std::initializer_list<std::string_view> list) {
    return std::ranges::any_of(list, [&text](std::string_view word) { return has_word(text, word); });
}

/// The place of a number that is called so, or -1.
int place_of(const std::string& label, const Spec& spec) {
    const auto columns = spec.columns();
    const std::string name = lower(label.substr(label.find_last_of('_') + 1));
    for (std::size_t i = 0; i < spec.size(); ++i) {
        const std::string column = lower(std::string(columns.at(i)));
        if (name == column || (spec.name == RepresentationId::quat && column == "q" + name)) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

/// Holds the numbers of an accepted text against it.
void hold(const std::string& text, const Spec& spec, const cli::Values& values) {
    const auto numerals = numerals_of(text);
    const std::string low = lower(text);
    std::vector<std::string> read;
    std::string row = values.row;
    std::ranges::replace_if(
        row, [](char c) { return c == ',' || c == '\t'; }, ' ');
    for (std::size_t at = row.find_first_not_of(' '); at != std::string::npos; at = row.find_first_not_of(' ', at)) {
        const std::size_t end = std::min(row.find(' ', at), row.size());
        read.push_back(row.substr(at, end - at));
        at = end;
    }
    const auto is = [&](bool holds, const char* what) { check(holds, what, text, values.row); };
    const bool has_text = has_any(low, {"dtype", "device", "layout", "requires_grad", "grad_fn", "frame_id",
                                        "child_frame_id", "name", "type", "class", "frame", "relative_to"});
    const bool is_sum = std::ranges::any_of(numerals, [](const Numeral& each) { return each.letter != '\0'; });
    const bool is_left_out = numerals.size() > read.size();
    // Nothing is passed over.
    is(has_text || text.find_first_of("*~^!%&?$@#\\") == std::string::npos, "an operator is passed over");
    is(has_text || is_left_out || !has_any(low, {"inv", "inverse", "conj", "transpose", "neg", "minus"}),
       "an operation is passed over");
    is(is_sum || has_text || std::ranges::none_of(numerals, &Numeral::after_sign), "a sign is passed over");
    if (values.notes.empty() && !is_left_out && !has_text && representation(spec.name).has_angles() &&
        spec.name != RepresentationId::axis_angle) {
        const bool is_degrees = spec.unit == AngleUnit::degrees;
        is(!(is_degrees ? has_any(text, {"rad", "radian", "radians"})
                        : has_any(text, {"deg", "degree", "degrees"}) || low.find("°") != std::string::npos),
           "a unit is passed over");
    }
    reach.add("units",
              has_any(low, {"deg", "degrees", "rad", "radians"}) || low.find("°") != std::string::npos ? 1 : 0);
    if (is_sum) {
        reach.add("sums");
        return;
    }
    const bool is_of_project =
        !values.notes.empty() && values.notes[0].text.find("are read as those of") != std::string::npos;
    const bool is_pose =
        is_of_project || (spec.name == RepresentationId::dcm && read.size() == 9 && numerals.size() >= 16);
    reach.add("4x4", is_pose ? 1 : 0);
    // Each number is one of the text, and where all of the text's differ it is known which.
    std::vector<std::size_t> places;
    for (const std::string& number : read) {
        const auto count = std::ranges::count(numerals, number, &Numeral::text);
        is(count > 0, "a number is made up");
        places.push_back(
            static_cast<std::size_t>(std::ranges::find(numerals, number, &Numeral::text) - numerals.begin()));
        if (count > 1) {
            return;
        }
    }
    std::string letters = low;
    std::erase_if(letters, [](char c) { return c == ',' || c == ' ' || c == ';' || c == '\t'; });
    const bool has_order = has_any(low, {"from_quat", "scalar_first", "quaternion", "order", "seq"}) ||
                           letters.find("xyzw") != std::string::npos || letters.find("wxyz") != std::string::npos;
    bool has_label = false;
    const bool are_named = read.size() == spec.size() && std::ranges::all_of(places, [&](std::size_t place) {
                               return place_of(numerals[place].label, spec) >= 0;
                           });
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::string& label = numerals[places[i]].label;
        const int own = are_named ? place_of(label, spec) : -1;
        has_label = has_label || own >= 0 || lower(label).find_first_of("xyzwijkrpyabc") != std::string::npos;
        is(own < 0 || read.size() != spec.size() || own == static_cast<int>(i) ||
               std::ranges::count(numerals, label, &Numeral::label) > 1,
           "a number is not where its label says");
    }
    is(is_pose || has_label || has_order || std::ranges::is_sorted(places), "numbers without labels are moved");
    if (has_order && values.notes.size() == 1 && values.notes[0].text.find("is applied") != std::string::npos) {
        reach.add("orders applied");
        is(places.size() == 4 && places[0] == places[3] + 1 && places[1] + 2 == places[3], "an order is not applied");
    }
    // What is lost stands behind a name.
    const auto first_letter = std::ranges::find_if(text, is_letter);
    const std::size_t bare = numerals_of(std::string(text.begin(), first_letter)).size();
    is(is_pose || bare <= read.size(), "a number without a label is lost");
    is(is_pose || first_letter != text.end() || numerals.size() == read.size(), "a bare number is lost");
    reach.add("numbers left out", is_left_out && !is_pose ? 1 : 0);
    reach.add("labels", has_label ? 1 : 0);
    reach.add("bare numbers", first_letter == text.end() ? 1 : 0);
}

std::string text_of(std::string_view bytes) {
    std::string text;
    std::size_t count = 0;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < words.size()) {
            text += words.at(byte);
        } else if (byte < 128) {
            text += ' ';
        } else { // all differ
            text += fmt::format("{}0.{}", byte % 2 == 0 ? "" : "-", 101 + ++count);
        }
        text += byte % 16 == 15 ? "" : " ";
    }
    return text;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    const std::string_view line = input.substr(0, input.find('\n'));
    const std::string_view rest = input.substr(std::min(line.size() + 1, input.size()));
    const bool is_of_words = line == "words";
    const auto parsed = parse_spec(line);
    const auto* const own = std::get_if<Spec>(&parsed);
    const std::size_t which = rest.empty() ? 0 : static_cast<unsigned char>(rest[0]) % specs.size();
    const Spec spec = own != nullptr ? *own : std::get<Spec>(parse_spec(specs.at(which)));
    std::string text = is_of_words && !rest.empty() ? text_of(rest.substr(1)) : std::string(rest);
    text = text.substr(0, text.find('\0'));
    cli::Values values;
    try {
        values = cli::values_of({text}, std::nullopt, operations::attitude_numbers(spec),
                                own != nullptr ? line : specs.at(which), false);
    } catch (const cli::Usage& error) {
        check(std::string_view(error.what()).starts_with(cli::argument_error), "an error of another kind", text,
              error.what());
        reach.add("refused");
        reach.add("refused of words", is_of_words ? 1 : 0);
        return 0;
    }
    if (numerals_of(text).empty() || values.row.find(",,") != std::string::npos || values.row.starts_with(',') ||
        values.row.ends_with(',')) {
        return 0; // an error of the row
    }
    hold(text, spec, values);
    reach.add("accepted");
    reach.add("accepted of words", is_of_words ? 1 : 0);
    reach.add("brackets", text.find_first_of("[({") != std::string::npos ? 1 : 0);
    reach.add("calls", text.find('(') != std::string::npos && std::ranges::any_of(text, is_letter) ? 1 : 0);
    reach.add("elements", text.find('<') != std::string::npos ? 1 : 0);
    reach.add("quotes", text.find_first_of("'\"") != std::string::npos ? 1 : 0);
    reach.add("several lines", text.find('\n') != std::string::npos ? 1 : 0);
    reach.add("notes", values.notes.size());
    return 0;
}
