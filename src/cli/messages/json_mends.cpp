#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <rotconv/spec.hpp>

#include "../../stream/numbers/number_text.hpp"
#include "../grammar/column_names.hpp"
#include "../grammar/vocabulary.hpp"
#include "answers.hpp"

namespace rotconv::cli {
namespace {

/// A step of a path, as jq writes it after others.
std::string jq_step(const std::string& key) {
    const bool is_plain = !key.empty() && (key[0] < '0' || key[0] > '9') &&
                          std::ranges::all_of(key, [](char c) { return is_alphanumeric(c) || c == '_'; });
    return is_plain ? "." + key : fmt::format("[\"{}\"]", key);
}
std::string jq_path(const std::string& steps) { return (steps.starts_with('.') ? "" : ".") + steps; }

/// An object or array of a JSON text, so far.
struct Nest {
    std::string path;
    bool is_array = false;
    std::string key{};                      ///< the last one
    std::vector<std::string> with_number{}; ///< keys
    std::size_t numbers = 0;                ///< of an array and of the arrays in it
    bool has_arrays = false;
    bool has_others = false; ///< than numbers and arrays of numbers
};

/// Where the numbers of a row are in a JSON text.
struct JsonRows {
    std::vector<std::string> filters{}; ///< of jq: by name, otherwise by count
    bool is_pose = false;               ///< by count, of a matrix of 3x4 or 4x4

    void look_at(const Nest& nest, std::vector<std::string> names, const std::optional<Spec>& spec) {
        const bool may_be_pose = names.size() == 9 && (nest.numbers == 12 || nest.numbers == 16);
        std::string filter = nest.path.empty() ? "" : jq_path(nest.path) + " | ";
        if (nest.is_array && !nest.has_others && (nest.numbers == names.size() || may_be_pose)) {
            is_pose = may_be_pose;
            filter += nest.has_arrays ? "flatten | @csv" : "@csv";
        } else {
            if (const auto known = spec ? find_names(*spec, nest.with_number) : std::nullopt) {
                names = known->of(nest.with_number);
            }
            const auto has = [&nest](const auto& each) { return std::ranges::count(nest.with_number, each) > 0; };
            if (names.empty() || !std::ranges::all_of(names, has)) {
                return;
            }
            const auto steps = mapped(names, [](const std::string& each) { return jq_path(jq_step(each)); });
            filter += fmt::format("[{}] | @csv", fmt::join(steps, ", "));
        }
        if (std::ranges::count(filters, filter) == 0) {
            filters.push_back(filter);
        }
    }
};

/// Looks for the numbers by their names (those of the SPEC, if it is given), and by their count.
JsonRows rows_in_json(std::string_view text, const std::vector<std::string>& wanted, const std::optional<Spec>& spec) {
    JsonRows rows;
    constexpr std::size_t deepest = 32; // paths are as long as nests are deep
    constexpr std::size_t longest_key = 100;
    constexpr std::size_t most_keys = 1000;
    std::vector<Nest> nests(1);
    for (std::size_t i = 0; i < text.size() && nests.size() < deepest; ++i) {
        const char c = text[i];
        Nest& nest = nests.back();
        if (c == '{' || c == '[') {
            const bool is_first = nests.size() == 1;
            nests.push_back(
                {.path = is_first ? "" : nest.path + (nest.is_array ? "[]" : jq_step(nest.key)), .is_array = c == '['});
        } else if ((c == '}' || c == ']') && nests.size() > 1) {
            const Nest done = std::move(nest);
            nests.pop_back();
            rows.look_at(done, wanted, spec);
            Nest& around = nests.back();
            around.numbers += done.numbers;
            around.has_arrays = true;
            around.has_others = around.has_others || !done.is_array || done.has_others;
        } else if (c == '"') {
            const std::size_t begin = i + 1;
            for (++i; i < text.size() && text[i] != '"'; ++i) {
                i += text[i] == '\\' ? 1 : 0;
            }
            nest.has_others = true;
            if (i < text.size() &&
                text.substr(std::min(text.find_first_not_of(" \t\r\n", i + 1), text.size())).starts_with(':')) {
                nest.key = text.substr(begin, std::min(i - begin, longest_key));
            }
        } else if (is_alphanumeric(c) || c == '-') {
            const std::size_t end = std::min(text.find_first_of(",]} \t\r\n", i), text.size());
            const bool is_number = stream::is_number(text.substr(i, end - i));
            nest.numbers += is_number ? 1 : 0;
            nest.has_others = nest.has_others || !is_number;
            if (is_number && nest.with_number.size() < most_keys) {
                nest.with_number.push_back(nest.key);
            }
            i = end - 1;
        }
    }
    return rows;
}

} // namespace

MendGroups json_mends(const RowsCommand& command, std::string_view beginning, bool is_guess) {
    const stream::InputOptions& input = command.options.input;
    const auto selected = input.columns.names();
    const bool by_name = input.columns.has_names();
    const std::vector<std::string> wanted =
        by_name ? std::vector<std::string>(selected.begin(), selected.end()) : input.numbers.names;
    const std::string_view text = beginning.substr(std::min(beginning.find_first_of("{["), beginning.size()));
    const JsonRows rows = rows_in_json(text, wanted, by_name ? std::nullopt : input.numbers.attitude);
    const bool is_by_count = rows.filters.size() == 1 && rows.filters[0].find("[.") == std::string::npos;
    const std::string path = rows.filters.empty() ? "" : rows.filters[0].substr(0, rows.filters[0].find(" |"));
    const std::string key = path.substr(path.rfind('.') + 1);
    const bool is_named = input.numbers.attitude && input.numbers.attitude->name == RepresentationId::quat &&
                          (is(vocabulary::attitude, key) || key == "quat" || key == "quaternion");
    if (rows.filters.size() != 1 || (is_guess && is_by_count && !rows.is_pose && !is_named)) {
        return {};
    }
    Mend mend;
    if (by_name || rows.is_pose) {
        mend.edits.push_back(OptionSet::setting(*command.line->find("--columns"), by_name ? "" : "1-3,5-7,9-11"));
    }
    return {{command.line->piped(std::move(mend), "jq -r " + in_shell(rows.filters[0]), std::nullopt)}};
}

} // namespace rotconv::cli
