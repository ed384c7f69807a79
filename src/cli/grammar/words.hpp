#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "../../core/text.hpp"
#include "../../stream/numbers/fmt.hpp"
#include "../../stream/numbers/json.hpp"

/// How texts from outside, counts and values look in messages and other output.
namespace rotconv::cli {

/// What the function makes of each.
template <class Range, class Function> [[nodiscard]] auto mapped(const Range& range, const Function& function) {
    std::vector<std::decay_t<std::invoke_result_t<const Function&, decltype(*std::begin(range))>>> made;
    std::ranges::transform(range, std::back_inserter(made), function);
    return made;
}

/// Those for which the condition holds.
template <class Range, class Condition> [[nodiscard]] auto filtered(const Range& range, const Condition& condition) {
    std::vector<std::decay_t<decltype(*std::begin(range))>> chosen;
    std::ranges::copy_if(range, std::back_inserter(chosen), condition);
    return chosen;
}

/// The items with the mark between them.
[[nodiscard]] std::string joined(const auto& items, std::string_view mark = ",") {
    return fmt::format("{}", fmt::join(items, mark));
}

/// A text for messages: characters that could move a terminal's cursor, hide or end the line are escaped.
[[nodiscard]] std::string shown(std::string_view text);

/// shown(), and cut if it is long.
[[nodiscard]] std::string shortened(std::string_view text);

/// shortened() in quotes.
[[nodiscard]] std::string quoted(std::string_view text);

/// The texts in quotes, or "none".
[[nodiscard]] std::string quoted_list(const std::vector<std::string>& texts);

/// "1 qw, 2 qx": the texts numbered from 1, as many as fit.
[[nodiscard]] std::string numbered(const std::vector<std::string>& texts);

/// "1 row", "2 rows".
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

/// The words of a text, which has blanks between them.
[[nodiscard]] std::vector<std::string> words_in(std::string_view text);

/// Only the letters and digits.
[[nodiscard]] std::string without_marks(std::string_view text);

/// A word as a shell reads it: in quotes if it needs them.
[[nodiscard]] std::string in_shell(std::string_view word);

/// The path of a file for a command; one that begins with a dash is not taken for an option.
[[nodiscard]] std::string file_in_shell(const std::string& file);

/// A value as JSON writes it: null, a text, a truth, a count or a number (a text if it is not finite).
struct JsonValue {
    std::string text = "null";

    JsonValue() = default;
    JsonValue(const std::string& value) : text(stream::json_string(value)) {}
    JsonValue(const char* value) : JsonValue(std::string(value)) {}
    JsonValue(bool value) : text(value ? "true" : "false") {}
    JsonValue(std::size_t value) : text(std::to_string(value)) {}
    JsonValue(double value) : text(std::isfinite(value) ? fmt::to_string(value) : fmt::format("\"{}\"", value)) {}
    /// A number that is already text; without a text the key is left out.
    static JsonValue as_written(std::string number) {
        JsonValue value;
        value.text = std::move(number);
        return value;
    }
    /// Null if that is so.
    [[nodiscard]] JsonValue unless(bool is_absent) const { return is_absent ? JsonValue() : *this; }
};

/// An array of values or of numbers.
[[nodiscard]] JsonValue json_array(const auto& items) {
    const auto texts = mapped(items, [](const JsonValue& item) { return item.text; });
    return JsonValue::as_written(fmt::format("[{}]", fmt::join(texts, ", ")));
}

/// An object of these keys, which must not need escapes.
[[nodiscard]] JsonValue json_object(const std::vector<std::pair<std::string_view, JsonValue>>& object);
/// The same, as a line.
[[nodiscard]] std::string json_line(const std::vector<std::pair<std::string_view, JsonValue>>& object);

/// Writes `rotconv: message` and a line end to stderr, in one piece. If that fails there is nobody to tell.
void print_error(std::string_view message);

} // namespace rotconv::cli
