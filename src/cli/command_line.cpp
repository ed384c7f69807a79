#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include <rotconv/version.hpp>

#include "../core/kernels.hpp"
#include "../stream/file.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

std::string help(const CommandEntry& entry, const OptionSet& options, const OptionSet& of_conversion,
                 std::span<const CommandEntry> commands) {
    std::string text = fmt::format("{}\n{}", entry.about, entry.usage);
    if (!entry.name.empty()) {
        text += options.help(&of_conversion);
        const bool has_shared = text.find("\n  shared:") != std::string::npos;
        return text + (has_shared ? "\nrotconv --help explains the options that are shared.\n" : "");
    }
    text += options.help() + "\nCommands:\n";
    for (const CommandEntry& each : commands) {
        text += fmt::format("  {:<28}{}\n", each.name, each.about);
    }
    return text + "\n" + help_footer();
}

/// Refuses operands that cannot be combined, and FILEs that cannot be read.
void check(const CommandOptions& operands, std::size_t most_files, std::span<const CommandEntry> commands) {
    const bool has_input = operands.input.given();
    for (const std::string& file : operands.files) {
        if (const int error = stream::File::why_unreadable(file.c_str()); error != 0) {
            if (&file != operands.files.data() && most_files == 1) {
                break; // two FILEs
            }
            throw Usage(messages::no_operand(file, error, mapped(commands, &CommandEntry::name)));
        }
    }
    const std::string file = operands.files.empty() ? "" : "the FILE " + quoted(operands.files[0]);
    if (operands.files.size() > 1 && most_files == 1) {
        throw Usage("{} and {} are two FILEs, but one is read (-o names the one to write); cat joins them: cat A B | "
                    "rotconv ...",
                    quoted(operands.files[0]), quoted(operands.files[1]));
    }
    if (operands.files.size() > most_files) {
        throw Usage("{} is one FILE too many", quoted(operands.files[most_files]));
    }
    if (!operands.values.empty() && (has_input || !file.empty())) {
        throw Usage("VALUEs cannot be combined with {}", file.empty() ? "--input" : file);
    }
    if (has_input && !file.empty()) {
        throw Usage(file + " cannot be combined with --input");
    }
}

/// Refuses files whose names say that they are compressed; the message has the command line that unpacks them.
void refuse_compressed(const std::vector<std::string>& words, const std::vector<WordEnd>& files) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> unpackers{
        {{".gz", "zcat"}, {".zst", "zstdcat"}, {".xz", "xzcat"}}};
    std::vector<std::string> command = mapped(words, in_shell);
    std::string first;
    std::string unpack;
    for (const WordEnd& file : files) {
        const std::string name = words[file.word].substr(file.begin);
        for (const auto& [ending, program] : unpackers) {
            if (name.ends_with(ending)) {
                const std::string by = fmt::format("{} {}", program, file_in_shell(name));
                command[file.word] =
                    words[file.word].substr(0, file.begin) + (first.empty() ? "-" : fmt::format("<({})", by));
                unpack = first.empty() ? by : unpack;
                first = first.empty() ? name : first;
            }
        }
    }
    if (!first.empty()) {
        throw Usage("{} is compressed: {}", quoted(first),
                    shown(fmt::format("{} | rotconv {}", unpack, fmt::join(command, " "))));
    }
}

/// The command line that is meant by one with `help` or `--list` in front.
std::vector<std::string> translated(std::vector<std::string> words, const auto& is_command) {
    const bool is_help = !words.empty() && words[0] == "help" && stream::File::why_unreadable("help") != 0; // no FILE
    const std::string topic = is_help && words.size() > 1 ? words[1] : "";
    if (!words.empty() && words[0] == "--list") {
        words[0] = "list";
    } else if (topic == "help") {
        words = {"--help"};
    } else if (is_help && words.size() > 1 && !is_command(topic)) {
        words[0] = topic.starts_with('-') ? "--help" : "list";
    } else if (is_help) {
        words.erase(words.begin());
        words.emplace_back("--help");
    }
    return words;
}

} // namespace

Command read_command_line(int argc, const char* const* argv) {
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    const auto table = command_table();
    const auto commands = std::span<const CommandEntry>(table).subspan(1);
    const auto is_command = [&](std::string_view word) {
        return std::ranges::count(commands, word, &CommandEntry::name) > 0;
    };
    words = translated(std::move(words), is_command);
    const auto has_meaning = [](std::string_view word) {
        if (word.size() < 2 || !std::ranges::all_of(word, [](char c) { return is_alphanumeric(c) || c == '-'; })) {
            return false; // the label of a number
        }
        return !messages::meaning_of_verb(word).empty() || messages::is_spec(word) ||
               (std::ranges::count(word, '2') == 1 && std::ranges::all_of(word, is_alphanumeric)); // rpy2quat
    };
    const CommandEntry* entry = table.data();
    const std::unique_ptr<CommandOptions> of_conversion = entry->options();
    CommandOptions* options = of_conversion.get();
    const auto refuse_unknown = [&options] {
        if (!options->unknown.empty()) {
            throw Usage(messages::no_such_option(options->unknown, mapped(options->all(), &Option::name)));
        }
    };
    const std::size_t end = options->read(words, 0, is_command, has_meaning);
    std::unique_ptr<CommandOptions> of_command;
    if (end < words.size()) {
        refuse_unknown();
        entry = &*std::ranges::find(table, words[end], &CommandEntry::name);
        of_command = entry->options();
        options = of_command.get();
        static_cast<void>(options->read(
            words, end + 1, [](auto) { return false; }, has_meaning));
    }
    const std::string verb = of_command == nullptr && !options->files.empty() ? options->files[0] : "";
    if (!verb.empty() && verb == words[0] && verb.find_first_of("./") == std::string::npos &&
        stream::File::why_unreadable(verb.c_str()) != 0) {
        if (const std::string meaning = messages::meaning_of_verb(verb); !meaning.empty()) {
            throw Usage("{} is not a command: {}", quoted(verb), meaning);
        }
    }
    for (const std::string& misuse : {of_conversion->misuse, options->misuse}) {
        if (!misuse.empty()) {
            throw Usage(misuse);
        }
    }
    if (of_conversion->help_flag.given() || options->help_flag.given()) {
        return help(*entry, *options, *of_conversion, commands);
    }
    if (of_conversion->version_flag.given()) {
        return fmt::format("rotconv " ROTCONV_VERSION " (kernels: {})\n", kernel_table().target);
    }
    options->check_attitudes();
    refuse_unknown();
    if (of_command != nullptr && !of_conversion->first_option.empty()) {
        throw Usage("{} stands before {}; options come after the command", of_conversion->first_option, entry->name);
    }
    const Option& input = options->input;
    if (!options->takes_names()) {
        check(*options, entry->most_files, commands);
        refuse_compressed(words, input.given() ? std::vector{input.place} : options->file_words);
    }
    try {
        return options->command();
    } catch (const MissingSpec& error) {
        throw Usage(error.what() +
                    messages::contents_advice(options->files.empty() ? input.text() : options->files[0]));
    }
}

std::unique_ptr<CommandOptions> CommandEntry::options() const {
    auto all = own_options();
    all->add("More", {&all->help_flag});
    if (name.empty()) {
        all->add("More", {&all->version_flag});
    }
    return all;
}

std::vector<CommandEntry> command_table() {
    return {convert_command(), list_command(),    rates_command(),  propagate_command(), survey_command(),
            compare_command(), compose_command(), rotate_command(), identify_command(),  sample_command()};
}

} // namespace rotconv::cli
