#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include <rotconv/version.hpp>

#include "../stream/file.hpp"
#include "../stream/fmt.hpp"
#include "command.hpp"

namespace rotconv::cli {
namespace {

struct Entry {
    std::string_view name; ///< empty: the conversion
    const char* about;
    const char* usage;
    std::unique_ptr<CommandOptions> (*make)();
    std::size_t most_files = 1;
};

constexpr std::array<Entry, 8> entries{
    {{"", "Converts rotations from any representation into any other.",
      "Usage: rotconv -f FROM -t TO [OPTION]... [VALUE]...\n"
      "       rotconv -f FROM -t TO [OPTION]... [FILE]\n"
      "       rotconv list [NAME]\n"
      "       rotconv rates|propagate|survey [OPTION]... [FILE]\n"
      "       rotconv compare|identify [OPTION]... [FILE [REFERENCE]]\n"
      "       rotconv sample -t SPEC [OPTION]...\n",
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
      identify_options, 2},
     {"sample", "Write rows on which conversions often fail, to test other programs",
      "Usage: rotconv sample -t SPEC [OPTION]...\n"
      "\nKinds of rows:\n"
      "  uniform     all attitudes alike\n"
      "  small       angles down to 1e-300\n"
      "  half-turn   near a half-turn, and half-turns (cayley: not those)\n"
      "  lock        near gimbal lock, and locked: of SPEC's sequence, else of all 24\n"
      "  border      two quaternion components of equal size, or the trace of dcm 0\n"
      "  cube        the 24 rotations of the cube\n"
      "On request alone; scaled and noise are to be read with --tolerance inf:\n"
      "  scaled      quat: norms from 1e-150 to 1e150\n"
      "  noise       dcm, 6d, 5d: numbers off by up to --noise\n"
      "  many-turns  euler, rpy, rotvec, axis-angle: angles up to 1e15\n",
      sample_options, 0}}};

std::unique_ptr<CommandOptions> options_of(const Entry& entry) {
    auto options = entry.make();
    options->set.begin_group("More");
    options->set.add("-h,--help", options->wants_help, "Print this help and exit");
    if (entry.name.empty()) {
        options->set.add("--version", options->wants_version, "Print the version and exit");
    }
    return options;
}

/// The commands without the conversion.
constexpr std::span commands(entries.begin() + 1, entries.end());

std::string help(const Entry& entry, const OptionSet& options) {
    std::string text = fmt::format("{}\n{}{}", entry.about, entry.usage, options.help());
    if (entry.name.empty()) {
        text += "\nCommands:\n";
        for (const Entry& each : commands) {
            text += fmt::format("  {:<28}{}\n", each.name, each.about);
        }
        text += "\n" + help_footer();
    }
    return text;
}

/// A word that is not an option of the command, with the nearest option.
std::string unexpected(const OptionSet& options, const std::string& word) {
    const auto names = mapped(options.all(), &Option::name);
    return messages::no_such_option(word.substr(0, word.find('=')), {names.begin(), names.end()});
}

/// Refuses operands that cannot be combined, and FILEs that cannot be read.
void check(const Arguments& operands, bool has_input, std::size_t most_files) {
    for (const std::string& file : operands.files) {
        if (const int error = stream::File::why_unreadable(file.c_str()); error != 0) {
            throw Usage(messages::no_operand(file, error, mapped(commands, &Entry::name)));
        }
    }
    const std::string file = operands.files.empty() ? "" : "the FILE " + quoted(operands.files[0]);
    if (operands.files.size() > 1 && most_files == 1) {
        throw Usage(fmt::format("{} and {} are two FILEs, but one is read; cat joins them: cat A B | rotconv ...",
                                quoted(operands.files[0]), quoted(operands.files[1])));
    }
    if (operands.files.size() > most_files) {
        throw Usage(fmt::format("{} is one FILE too many", quoted(operands.files[most_files])));
    }
    if (!operands.values.empty() && (has_input || !file.empty())) {
        throw Usage(fmt::format("VALUEs cannot be combined with {}", file.empty() ? "--input" : file));
    }
    if (has_input && !file.empty()) {
        throw Usage(file + " cannot be combined with --input");
    }
}

/// The command that prints a file whose name says that it is compressed; empty for other files.
std::string unpacked(const std::string& file) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> unpackers{
        {{".gz", "zcat"}, {".zst", "zstdcat"}, {".xz", "xzcat"}}};
    for (const auto& [ending, program] : unpackers) {
        if (file.ends_with(ending)) {
            return fmt::format("{} {}", program, file_in_shell(file));
        }
    }
    return {};
}

/// Refuses files whose names say that they are compressed; the message has the command line that unpacks them.
void refuse_compressed(const std::vector<std::string>& words, const std::vector<FileWord>& files) {
    std::vector<std::string> command = mapped(words, in_shell);
    std::string first;
    std::string unpack;
    for (const FileWord& file : files) {
        const std::string name = words[file.word].substr(file.begin);
        if (const std::string by = unpacked(name); !by.empty()) {
            command[file.word] =
                words[file.word].substr(0, file.begin) + (first.empty() ? "-" : fmt::format("<({})", by));
            unpack = first.empty() ? by : unpack;
            first = first.empty() ? name : first;
        }
    }
    if (!first.empty()) {
        throw Usage(fmt::format("{} is compressed: {}", quoted(first),
                                shown(fmt::format("{} | rotconv {}", unpack, fmt::join(command, " ")))));
    }
}

bool is_command(std::string_view word) { return std::ranges::count(commands, word, &Entry::name) > 0; }

/// The command line that is meant by one with `help` or `--list` in front.
std::vector<std::string> translated(std::vector<std::string> words) {
    const std::string first = words.empty() ? "" : words[0];
    if (first == "--list") {
        words[0] = "list";
    } else if (first == "help" && stream::File::why_unreadable("help") == 0) {
        return words; // a FILE
    } else if (first == "help" && words.size() > 1 && words[1] == "help") {
        words = {"--help"};
    } else if (first == "help" && words.size() > 1 && !is_command(words[1])) {
        words[0] = words[1].starts_with('-') ? "--help" : "list";
    } else if (first == "help") {
        words.erase(words.begin());
        words.emplace_back("--help");
    }
    return words;
}

Command read(const std::vector<std::string>& words) {
    const Entry* entry = entries.data();
    auto options = options_of(*entry);
    Arguments arguments = options->set.read(words, 0, is_command);
    std::string misplaced; // the first option that stands before the name of a command
    if (arguments.end < words.size()) {
        if (!arguments.unknown.empty()) {
            throw Usage(unexpected(options->set, arguments.unknown));
        }
        const auto conversion = std::move(options);
        const std::string error = arguments.error;
        misplaced = arguments.first_option;
        entry = std::ranges::find(entries, words[arguments.end], &Entry::name);
        options = options_of(*entry);
        arguments = options->set.read(words, arguments.end + 1, [](auto) { return false; });
        arguments.error = error.empty() ? arguments.error : error;
        options->wants_help |= conversion->wants_help;
        options->wants_version = conversion->wants_version;
    }
    const std::string verb = arguments.files.empty() || options->set.takes_names() ? "" : arguments.files.front();
    if (entry == entries.data() && verb.find_first_of("./") == std::string::npos &&
        stream::File::why_unreadable(verb.c_str()) != 0) { // before its options are looked at
        if (const std::string answer = messages::answer_to_verb(verb); !answer.empty()) {
            throw Usage(fmt::format("{} is not a command: {}", quoted(verb), answer));
        }
    }
    if (!arguments.error.empty()) {
        throw Usage(arguments.error);
    }
    if (options->wants_help) {
        return PrintCommand{help(*entry, options->set)};
    }
    if (options->wants_version) {
        return PrintCommand{"rotconv " ROTCONV_VERSION "\n"};
    }
    if (!arguments.unknown.empty()) {
        throw Usage(unexpected(options->set, arguments.unknown));
    }
    if (!misplaced.empty()) {
        throw Usage(fmt::format("{} stands before {}; options come after the command", misplaced, entry->name));
    }
    if (!options->set.takes_names()) {
        check(arguments, !options->input.empty(), entry->most_files);
        refuse_compressed(words, arguments.file_words);
    }
    try {
        return options->command({arguments.values, arguments.files});
    } catch (const MissingSpec& error) {
        throw Usage(error.what() +
                    messages::contents_advice(arguments.files.empty() ? options->input : arguments.files.front()));
    }
}

} // namespace

Command read_command_line(int argc, const char* const* argv) {
    try {
        return read(translated({argv + std::min(argc, 1), argv + argc}));
    } catch (const Usage& error) {
        return UsageError{error.what()};
    }
}

std::vector<CommandText> command_table() {
    std::vector<CommandText> table;
    table.reserve(entries.size());
    for (const Entry& entry : entries) {
        table.push_back({std::string(entry.name), entry.about, options_of(entry)});
    }
    return table;
}

} // namespace rotconv::cli
