#include "command_line.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>

#include <rotconv/version.hpp>

#include "../stream/file.hpp"
#include "../stream/fmt.hpp"
#include "advice.hpp"
#include "arguments.hpp"
#include "commands.hpp"

namespace rotconv::cli {
namespace {

struct Entry {
    std::string_view name; ///< empty: the conversion
    const char* about;
    const char* usage;
    std::unique_ptr<CommandOptions> (*make)();
    std::size_t most_files = 1;
};

constexpr std::array<Entry, 7> entries{
    {{"", "Converts rotations from any representation into any other.",
      "Usage: rotconv -f FROM -t TO [OPTION]... [VALUE]...\n"
      "       rotconv -f FROM -t TO [OPTION]... [FILE]\n"
      "       rotconv list [NAME]\n"
      "       rotconv rates|propagate|survey [OPTION]... [FILE]\n"
      "       rotconv compare|identify [OPTION]... [FILE [REFERENCE]]\n",
      convert_options},
     {"list", "List the representations, methods or presets, or explain one",
      "Usage: rotconv list [NAME]\n       rotconv list methods [FROM [TO]]\n", list_options},
     {"rates", "Turn angular velocity into rates of change of the numbers, and back",
      "Usage: rotconv rates -f SPEC [OPTION]... [VALUE]...\n"
      "       rotconv rates -f SPEC [OPTION]... [FILE]\n"
      "       rotconv rates --differences -f SPEC [OPTION]... [FILE]\n",
      rates_options},
     {"propagate", "Integrate angular velocities to attitudes", "Usage: rotconv propagate -t SPEC [OPTION]... [FILE]\n",
      propagate_options},
     {"survey", "Find the representations that serve a motion, and the smallest",
      "Usage: rotconv survey -f SPEC [OPTION]... [FILE]\n", survey_options},
     {"compare", "Check attitudes against a reference, by the angles between them",
      "Usage: rotconv compare -f SPEC [-t SPEC] [OPTION]... FILE REFERENCE\n"
      "       rotconv compare -f SPEC [-t SPEC] [OPTION]... [FILE]\n"
      "       rotconv compare -f SPEC [-t SPEC] [OPTION]... VALUE...\n",
      compare_options, 2},
     {"identify", "Find the convention of numbers, from the same attitudes in a known one",
      "Usage: rotconv identify -t KNOWN [-f NAME] [OPTION]... FILE [REFERENCE]\n"
      "       rotconv identify -t KNOWN [-f NAME] [OPTION]... VALUE...\n",
      identify_options, 2}}};

std::unique_ptr<CommandOptions> options_of(const Entry& entry) {
    auto options = entry.make();
    options->set.begin_group("More");
    options->set.add("-h,--help", options->wants_help, "Print this help and exit");
    if (entry.name.empty()) {
        options->set.add("--version", options->wants_version, "Print the version and exit");
    }
    return options;
}

std::vector<std::string_view> command_names() {
    std::vector<std::string_view> names;
    std::transform(entries.begin() + 1, entries.end(), std::back_inserter(names),
                   [](const Entry& e) { return e.name; });
    return names;
}

std::string help(const Entry& entry, const OptionSet& options) {
    HelpText text{.about = entry.about, .usage = entry.usage, .commands = {}, .footer = {}};
    if (entry.name.empty()) {
        std::for_each(entries.begin() + 1, entries.end(),
                      [&](const Entry& each) { text.commands.emplace_back(each.name, each.about); });
        text.footer = help_footer();
    }
    return help_of(options, text);
}

/// A word that is no option of the command, with the nearest that is.
std::string unexpected(const OptionSet& options, const std::string& word) {
    if (!word.starts_with('-')) {
        return "unexpected argument " + quoted(word);
    }
    std::vector<std::string> names;
    for (const Option& option : options.all()) {
        if (!option.is_operand()) {
            names.push_back(option.name());
        }
    }
    return messages::no_such_option(word.substr(0, word.find('=')), {names.begin(), names.end()});
}

/// Refuses operands that exclude each other, and FILEs that are none.
void check(const Arguments& operands, bool has_input, std::size_t most_files) {
    for (const std::string& file : operands.files) {
        if (const int error = stream::File::why_unreadable(file.c_str()); error != 0) {
            throw Usage(messages::no_operand(file, error, command_names()));
        }
    }
    const std::string file = operands.files.empty() ? std::string() : quoted(operands.files[0]);
    if (operands.files.size() > 1 && most_files == 1) {
        throw Usage(fmt::format("{} and {} are two FILEs, and one is read; cat joins them: cat A B | rotconv ...", file,
                                quoted(operands.files[1])));
    }
    if (operands.files.size() > most_files) {
        throw Usage(fmt::format("{} is one FILE too many", quoted(operands.files[most_files])));
    }
    if (!operands.values.empty() && !operands.files.empty()) {
        throw Usage(fmt::format("VALUEs and the FILE {} exclude each other", file));
    }
    if (has_input && !operands.files.empty()) {
        throw Usage(fmt::format("the FILE {} and --input exclude each other", file));
    }
    if (has_input && !operands.values.empty()) {
        throw Usage("VALUEs and --input exclude each other");
    }
}

/// What prints a compressed file, by the file's name; empty for others.
std::string unpacked(std::string_view file) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> unpackers{
        {{".gz", "zcat"}, {".zst", "zstdcat"}, {".xz", "xzcat"}}};
    for (const auto& [ending, program] : unpackers) {
        if (file.ends_with(ending)) {
            return fmt::format("{} {}{}", program, file.starts_with('-') ? "./" : "", in_shell(file));
        }
    }
    return {};
}

/// Refuses files that their names call compressed, with the same command line behind what unpacks the first.
void refuse_compressed(const std::vector<std::string>& words, const std::vector<FileWord>& files) {
    std::string first;
    std::string unpack;
    std::string command = "rotconv";
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto file = std::ranges::find(files, i, &FileWord::word);
        const std::string name = file == files.end() ? "" : words[i].substr(file->begin);
        const std::string before = file == files.end() ? words[i] : words[i].substr(0, file->begin);
        const std::string by = unpacked(name);
        if (by.empty()) {
            command += " " + in_shell(words[i]);
        } else if (first.empty()) {
            first = name;
            unpack = by;
            command += " " + before + "-";
        } else {
            command += fmt::format(" {}<({})", before, by);
        }
    }
    if (!first.empty()) {
        throw Usage(fmt::format("{} is compressed: {}", quoted(first), shown(fmt::format("{} | {}", unpack, command))));
    }
}

Command read(const std::vector<std::string>& words) {
    const Entry* entry = entries.data();
    auto chosen = options_of(*entry);
    Arguments arguments = sort_arguments(chosen->set, words, 0, [](std::string_view word) {
        return !word.empty() && std::ranges::count(entries, word, &Entry::name) > 0;
    });
    std::string misplaced; // an option of the conversion before a command
    if (arguments.end < words.size()) {
        const Arguments before = std::move(arguments);
        const auto unknown = chosen->set.read(before.options);
        if (!unknown.empty()) {
            throw Usage(unexpected(chosen->set, unknown.front()));
        }
        const bool wants_help = chosen->wants_help;
        const bool wants_version = chosen->wants_version;
        misplaced = before.options.empty() ? "" : before.options.front();
        entry = std::ranges::find(entries, words[before.end], &Entry::name);
        chosen = options_of(*entry);
        arguments = sort_arguments(chosen->set, words, before.end + 1, [](auto) { return false; });
        arguments.error = before.error.empty() ? arguments.error : before.error;
        chosen->wants_help = wants_help;
        chosen->wants_version = wants_version;
    }
    if (!arguments.error.empty()) {
        throw Usage(arguments.error);
    }
    const auto unknown = chosen->set.read(arguments.options);
    if (chosen->wants_help) {
        return PrintCommand{help(*entry, chosen->set)};
    }
    if (chosen->wants_version) {
        return PrintCommand{"rotconv " ROTCONV_VERSION "\n"};
    }
    if (!unknown.empty()) {
        throw Usage(unexpected(chosen->set, unknown.front()));
    }
    if (!misplaced.empty()) {
        throw Usage(fmt::format("{} stands before {}; options come after the command",
                                misplaced.substr(0, misplaced.find('=')), entry->name));
    }
    const std::string input = chosen->input();
    check(arguments, !input.empty(), entry->most_files);
    refuse_compressed(words, arguments.file_words);
    try {
        return chosen->command({arguments.values, arguments.files});
    } catch (const MissingSpec& error) {
        throw Usage(error.what() + contents_advice(arguments.files.empty() ? input : arguments.files.front()));
    }
}

} // namespace

Command read_command_line(int argc, const char* const* argv) {
    try {
        return read({argv + std::min(argc, 1), argv + argc});
    } catch (const Usage& error) {
        return UsageError{error.what()};
    }
}

std::vector<CommandText> command_table() {
    std::vector<CommandText> table;
    for (const Entry& entry : entries) {
        table.push_back({std::string(entry.name), entry.about, options_of(entry)});
    }
    return table;
}

} // namespace rotconv::cli
