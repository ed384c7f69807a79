// The manual and the README against the tables of names.

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <rotconv/axes.hpp>
#include <rotconv/spec.hpp>

#include "../../src/core/projects.hpp"
#include "accuracy.hpp"
#include "catch.hpp"

using namespace rotconv;

namespace {

/// Words are letters, digits and hyphens.
std::set<std::string> words_of(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char c) { return std::isalnum(c) == 0 && c != '-'; }, ' ');
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

/// What is explained in one place: its names, and the words that explain them.
struct Item {
    std::set<std::string> names;
    std::set<std::string> words;
};

/// The items of the manual's lists.
std::vector<Item> items_of_manual() {
    std::vector<Item> items;
    std::string text =
        accuracy::text_of(ROTCONV_MANUAL "/rotconv-conventions.7") + accuracy::text_of(ROTCONV_MANUAL "/rotconv.1");
    const std::string begin = "\n.It Cm ";
    for (auto at = text.find(begin); at != std::string::npos;) {
        const auto line_end = text.find('\n', at + 1);
        const auto next = text.find("\n.It ", at + 1);
        const auto end = std::min(next, text.find("\n.El", at + 1));
        items.push_back({words_of(text.substr(at + begin.size(), line_end - at - begin.size())),
                         words_of(text.substr(line_end, end - line_end))});
        at = text.find(begin, at + 1);
    }
    return items;
}

/// The rows of the README's tables: their first column, and all of it.
std::vector<Item> rows_of_readme() {
    std::vector<Item> rows;
    std::ifstream file(ROTCONV_README);
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("| ")) {
            rows.push_back({words_of(line.substr(0, line.find('|', 1))), words_of(line)});
        }
    }
    return rows;
}

/// Whether one item has all of the names, and explains them by all of the words.
bool explained(const std::vector<Item>& items, const std::vector<std::string_view>& names,
               const std::vector<std::string_view>& words = {}) {
    return std::ranges::any_of(items, [&](const Item& item) {
        return std::ranges::all_of(names, [&](auto name) { return item.names.contains(std::string(name)); }) &&
               std::ranges::all_of(words, [&](auto word) { return item.words.contains(std::string(word)); });
    });
}

std::vector<std::string_view> names_of(const Representation& entry) {
    std::vector<std::string_view> names{entry.text};
    std::ranges::copy_if(entry.aliases, std::back_inserter(names), [](auto alias) { return !alias.empty(); });
    return names;
}

} // namespace

// Catches a representation, an alias or a column that was added, or renamed, in the code alone.
TEST_CASE("the manual explains every representation with its aliases and columns") {
    const auto items = items_of_manual();
    for (const RepresentationId id : all_representations) {
        const Representation& entry = representation(id);
        INFO(entry.text);
        CHECK(explained(items, names_of(entry),
                        {entry.columns.begin(), entry.columns.begin() + static_cast<std::ptrdiff_t>(entry.size)}));
    }
}

// Catches a table in the README that leaves one out.
TEST_CASE("the README shows every representation with its aliases") {
    const auto rows = rows_of_readme();
    for (const RepresentationId id : all_representations) {
        INFO(representation(id).text);
        CHECK(explained(rows, names_of(representation(id))));
    }
}

// Catches a modifier or a preset that was added, or renamed, in the code alone.
TEST_CASE("the manual explains every modifier and preset, and the README names them") {
    const auto items = items_of_manual();
    const auto readme = words_of(accuracy::text_of(ROTCONV_README));
    std::vector<std::string> names;
    std::ranges::transform(all_modifiers, std::back_inserter(names), [](auto m) { return std::string(name_of(m)); });
    std::ranges::transform(presets(), std::back_inserter(names), [](auto& p) { return std::string(p.text); });
    for (const std::string& name : names) {
        INFO(name);
        CHECK(explained(items, {name}));
        CHECK(readme.contains(name));
    }
}

// Catches a SPEC that is mistyped, names that are too many or too few, axes that no option knows, and a name that is
// one of something else: it would never be found.
TEST_CASE("the table of projects holds SPECs, names and axes, each name once") {
    std::set<std::string> names;
    for (const Project& project : projects()) {
        INFO(project.text);
        std::istringstream words(std::string(project.text) + ' ' + std::string(project.others));
        for (std::string name; words >> name;) {
            CHECK(names.insert(name).second);
            CHECK(find_representation(name) == nullptr);
            CHECK(find_project(name) == &project);
        }
        for (std::string_view rest = project.specs; !rest.empty();) {
            const auto item = rest.substr(0, rest.find("; "));
            rest.remove_prefix(std::min(item.size() + 2, rest.size()));
            INFO(item);
            CHECK(std::holds_alternative<Spec>(parse_spec(item.substr(0, item.find(' ')))));
        }
        std::istringstream columns{std::string(project.columns)};
        const auto count = std::distance(std::istream_iterator<std::string>(columns), {});
        if (count > 0) {
            const auto spec = parse_spec(project.specs.substr(0, project.specs.find(' ')));
            CHECK(static_cast<std::size_t>(count) == std::get<Spec>(spec).size());
        }
        for (const std::string_view axes : {project.reference, project.body}) {
            const auto change = parse_axes(std::string(axes) + ':' + std::string(axes));
            CHECK((axes.empty() || std::holds_alternative<AxesChange>(change)));
        }
        CHECK((!project.source.empty() || project.remark.starts_with("no source found")));
        CHECK((!project.specs.empty() || !project.remark.empty()));
    }
}

// Catches a project that was added, or changed, in the code alone.
TEST_CASE("the manual explains every project with its SPECs, names and axes") {
    const auto items = items_of_manual();
    for (const Project& project : projects()) {
        INFO(project.text);
        std::set<std::string> words;
        for (const auto text :
             {project.specs, project.columns, project.reference, project.body, project.source, project.remark}) {
            words.merge(words_of(std::string(text)));
        }
        const auto names = words_of(std::string(project.text) + ' ' + std::string(project.others));
        CHECK(explained(items, {names.begin(), names.end()}, {words.begin(), words.end()}));
    }
}

// Catches a kind of diagnostic that was added, or renamed, in the code alone.
TEST_CASE("the manual explains every kind of diagnostic") {
    const auto items = items_of_manual();
    for (const DiagnosticKind kind : all_diagnostic_kinds) {
        INFO(name_of(kind));
        CHECK(explained(items, {name_of(kind)}));
    }
}
