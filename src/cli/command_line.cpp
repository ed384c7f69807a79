#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include <rotconv/version.hpp>

#include "../core/conversion/kernels.hpp"
#include "../core/projects.hpp"
#include "../operations/operations.hpp"
#include "../stream/bytes/file.hpp"
#include "../stream/numbers/number_text.hpp"
#include "grammar/value_text.hpp"
#include "messages/answers.hpp"
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

/// The mend by which VALUEs stand in each row of the FILE: one attitude for many vectors, or one vector.
std::vector<Mend> with_values_in_rows(const CommandOptions& operands) {
    const auto parsed = parse_spec(operands.command_name() == "rotate" ? operands.find("--from")->text() : "");
    const auto* const spec = std::get_if<Spec>(&parsed);
    std::string text = joined(operands.values, " ");
    std::ranges::replace(text, ',', ' ');
    const auto numbers = words_in(text);
    const auto bytes = operands.files.size() == 1 ? first_bytes(operands.files[0]) : std::nullopt;
    const auto rows = bytes ? simple_rows(*bytes) : std::nullopt;
    if (spec == nullptr || !rows || operands.value_words.empty() || !std::ranges::all_of(numbers, stream::is_number)) {
        return {};
    }
    const bool is_attitude = numbers.size() == spec->size();
    const bool are_first = operands.value_words[0].word < operands.file_words[0].word;
    const bool is_vector = numbers.size() == 3;
    if (is_attitude && is_vector ? !are_first : !is_attitude && !is_vector) { // it may be either
        return {};
    }
    const auto added = [&](const std::vector<std::string>& words) {
        return is_attitude ? joined(words, rows->mark) + rows->mark : rows->mark + joined(words, rows->mark);
    };
    const std::string own = added(numbers);
    const std::string names =
        added(is_attitude ? operations::names_of(*spec) : std::vector<std::string>{"x", "y", "z"});
    const char end = is_attitude ? '^' : '$';
    const std::string filter = rows->has_header() ? fmt::format("sed '1s/{0}/{1}/;2,$s/{0}/{2}/'", end, names, own)
                                                  : fmt::format("sed 's/{}/{}/'", end, own);
    return {operands.piped(operands.with_values({}), filter,
                           filtered_lines(*bytes, [&](std::size_t index, const std::string& line) {
                               const std::string& more = rows->has_header() && index == 0 ? names : own;
                               return is_attitude ? more + line : line + more;
                           }))};
}

/// Refuses operands that cannot be combined, and FILEs that cannot be read.
void check(const CommandOptions& operands, std::size_t most_files) {
    const bool has_input = operands.input.given();
    const auto verb = std::ranges::find_if_not(operands.files, holds_number); // behind labels: yaw=30 to quat
    const bool is_verb =
        verb != operands.files.end() && messages::is_verb(*verb) && stream::File::why_unreadable(verb->c_str()) != 0;
    const auto first = is_verb ? static_cast<std::size_t>(verb - operands.files.begin()) : std::size_t{0};
    for (std::size_t at = first; at < operands.files.size(); ++at) {
        const std::string& file = operands.files[at];
        if (const int error = stream::File::why_unreadable(file.c_str()); error != 0) {
            if (at > 0 && most_files == 1 && file.find_first_of("./") != std::string::npos &&
                operands.missing("--output") != nullptr) {
                throw Usage("{} and {} are two FILEs, but one is read, and -o names the one to write",
                            quoted(operands.files[0]), quoted(file))
                    .with({{{{operands.file_words[at], 1, {"-o", file}}}}});
            }
            const bool is_absent = error == ENOENT;
            const bool may_be_number = file.find_first_of("0123456789") != std::string::npos;
            throw Usage("{}{}{}{}", is_absent && !may_be_number ? "no file " : "", quoted(file),
                        !is_absent      ? " cannot be read: " + std::generic_category().message(error)
                        : may_be_number ? " is neither a number nor a file"
                                        : "",
                        messages::meaning_of_word(file))
                .with(messages::meant_by_operand(operands, operands.file_words[at].word),
                      messages::is_spec(file) ? fmt::format("; if it is a SPEC: -f {0} or -t {0}", file)
                                              : messages::fix_hint(file));
        }
    }
    const std::string file = operands.files.empty() ? "" : "the FILE " + quoted(operands.files[0]);
    if (operands.files.size() > 1 && most_files == 1) {
        Mend joined{mapped(operands.file_words, [](const WordEnd& word) { return Edit{word}; })};
        joined.pipe = fmt::format("cat {}", fmt::join(mapped(operands.files, file_in_shell), " "));
        joined.text = first_bytes(operands.files[0]).value_or("") + first_bytes(operands.files[1]).value_or("");
        throw Usage("{} and {} are two FILEs, but one is read (-o names the one to write)", quoted(operands.files[0]),
                    quoted(operands.files[1]))
            .with({joined});
    }
    if (operands.files.size() > most_files) {
        throw Usage("{} is one FILE too many", quoted(operands.files[most_files]));
    }
    const bool has_values = !operands.values.empty();
    if ((has_values && (has_input || !file.empty())) || (has_input && !file.empty())) {
        throw Usage("{} cannot be combined with {}", has_values ? "VALUEs" : file,
                    has_values && !file.empty() ? file : "--input")
            .with(has_input ? messages::with_specs_of_others(operands) : with_values_in_rows(operands));
    }
}

/// Refuses files whose names say that they are compressed.
void refuse_compressed(const CommandOptions& operands) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> unpackers{
        {{".gz", "zcat"}, {".zst", "zstdcat"}, {".xz", "xzcat"}}};
    auto files = operands.files;
    files.insert(files.end(), operands.input.texts.begin(), operands.input.texts.end());
    for (std::size_t at = 0; at < files.size(); ++at) {
        for (const auto& [ending, program] : unpackers) {
            if (files[at].ends_with(ending)) {
                const std::string by = fmt::format("{}<({} {})", raw_word, program, file_in_shell(files[at]));
                throw Usage("{} is compressed", quoted(files[at]))
                    .with({at == 0 ? operands.piped({}, std::string(program), std::nullopt)
                                   : Mend{{{operands.file_words[at], 1, {by}}}}});
            }
        }
    }
}

/// The command that alone serves of those that a project's name may mean, with a note that says so.
Command chosen(const CommandOptions& given, Command command) {
    if (auto* const rows = std::get_if<RowsCommand>(&command)) {
        const Option& columns = *rows->line->find("--columns");
        const std::string selected =
            columns.given() && !given.find("--columns")->given() ? " --columns " + columns.text() : "";
        rows->notes.push_back(
            {stream::Note::Kind::chosen,
             fmt::format("{0} {1} has several SPECs, of which one fits: {0} {2}{3}", "--from",
                         given.find("--from")->text(), rows->line->find("--from")->text(), selected)});
        const auto is_on_axes = [](const stream::Note& note) { return note.kind == stream::Note::Kind::axes; };
        if (const auto note = note_on_axes(given); note && std::ranges::none_of(rows->notes, is_on_axes)) {
            rows->notes.push_back(*note); // the SPEC that fits does not name the project
        }
    }
    return command;
}

void refuse_unknown(const CommandOptions& options) {
    if (!options.unknown.empty()) {
        throw messages::no_such_option(options);
    }
}

void refuse_verb(const CommandOptions& options) {
    const std::string verb = options.files.empty() ? "" : options.files[0];
    if (!verb.empty() && verb == options.words[0] && messages::is_verb(verb) &&
        verb.find_first_of("./") == std::string::npos && stream::File::why_unreadable(verb.c_str()) != 0) {
        throw Usage("{} is not a command{}", quoted(verb), messages::meaning_of_word(verb))
            .with(messages::meant_by_operand(options, 0));
    }
}

} // namespace

std::vector<std::string> words_of(int argc, const char* const* argv) {
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    const bool is_help = !words.empty() && words[0] == "help" && stream::File::why_unreadable("help") != 0; // no FILE
    const std::string topic = is_help && words.size() > 1 ? words[1] : "";
    if (!words.empty() && words[0] == "--list") {
        words[0] = "list";
    } else if (topic == "help") {
        words = {"--help"};
    } else if (is_help && !topic.empty() && !is_command(topic)) {
        words[0] = topic.starts_with('-') ? "--help" : "list";
    } else if (is_help) {
        words.erase(words.begin());
        words.emplace_back("--help");
    }
    return words;
}

Mend CommandOptions::piped(Mend mend, const std::string& command, std::optional<std::string> text,
                           std::string_view others) const {
    mend.pipe = file().empty() || file() == "-"
                    ? command
                    : fmt::format("{} {}{}", command, command.starts_with("tr ") ? "< " : "", file_in_shell(file()));
    mend.pipe += others;
    if (input.given()) {
        mend.edits.push_back(setting(input, "-"));
    } else if (!files.empty() && file() != "-") {
        mend.edits.push_back(
            {file_words[0], 1, files.size() > 1 ? std::vector<std::string>{"-"} : std::vector<std::string>()});
    }
    mend.text = std::move(text);
    return mend;
}

// NOLINTNEXTLINE(misc-no-recursion): once more, for the command that is meant
Command read_command_line(const std::vector<std::string>& words) {
    if (words.size() > 1 && words[0] == "--complete") {
        return completions(std::span(words).subspan(2), words[1]);
    }
    const auto table = command_table();
    const auto commands = std::span<const CommandEntry>(table).subspan(1);
    const CommandEntry* entry = table.data();
    const std::shared_ptr<CommandOptions> of_conversion = entry->options();
    std::shared_ptr<CommandOptions> options = of_conversion;
    const std::size_t end = options->read(words, 0, is_command);
    const bool has_command = end < words.size();
    if (has_command) {
        refuse_unknown(*options);
        entry = &*std::ranges::find(table, words[end], &CommandEntry::name);
        options = entry->options();
        static_cast<void>(options->read(words, end + 1, [](auto) { return false; }));
    } else {
        refuse_verb(*options);
    }
    for (const std::string& misuse : {of_conversion->misuse, options->misuse}) {
        if (!misuse.empty()) {
            throw Usage(misuse).with(messages::with_second_options(*options));
        }
    }
    if (of_conversion->help_flag.given() || options->help_flag.given()) {
        return help(*entry, *options, *of_conversion, commands);
    }
    if (of_conversion->version_flag.given()) {
        return fmt::format("rotconv " ROTCONV_VERSION " (kernels: {})\n", kernel_table().target);
    }
    options->check_attitudes();
    refuse_unknown(*options);
    if (has_command && !of_conversion->first_option.empty()) {
        throw Usage("{} stands before {}; options come after the command", of_conversion->first_option, entry->name)
            .with({{{{{end}}, {{0}, 0, {words[end]}}}}});
    }
    if (!options->takes_names()) {
        check(*options, entry->most_files);
        refuse_compressed(*options);
    }
    try {
        Command command = options->command();
        if (auto* const rows = std::get_if<RowsCommand>(&command)) {
            rows->line = options;
        }
        return command;
    } catch (const MissingSpec& error) {
        throw missing_spec(*options, error);
    } catch (const Usage& error) {
        const auto only = error.is_choice ? only_answer(words, error.mends) : std::nullopt;
        if (!only) {
            throw;
        }
        return chosen(*options, read_command_line(*only));
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

bool is_command(std::string_view word) {
    return !word.empty() && std::ranges::count(command_table(), word, &CommandEntry::name) > 0;
}

std::vector<CommandEntry> command_table() {
    return {convert_command(), list_command(),    rates_command(),  propagate_command(), survey_command(),
            compare_command(), compose_command(), rotate_command(), identify_command(),  sample_command()};
}

} // namespace rotconv::cli
