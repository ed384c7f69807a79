#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include <unistd.h>

#include "command.hpp"

namespace rotconv::cli {
namespace {

/// A message that ends the run.
ExitCode failed(const std::string& message) {
    print_error(message);
    return ExitCode::incomplete;
}

ExitCode failed(const std::string& file, stream::StreamError::What what, int error) {
    return failed(fmt::format("{}: {}", shown(file), messages::explain({.what = what, .error_number = error}, {})));
}

constexpr double least_doubtful_step = 1000.0; ///< seconds: a millisecond in microseconds
constexpr std::size_t most_errors = 20;        ///< of a run, told one by one

std::string rows_from(std::size_t rows, std::size_t first_line) {
    return fmt::format("{}, first at line {}", counted(rows, "row"), first_line);
}

/// Counts the events of a run, and prints them and their summary.
class Reporter {
public:
    explicit Reporter(const RowsCommand& command)
        : command_(&command), inputs_{command.has_values ? "argument" : shown(command.input),
                                      shown(command.reference)} {}

    void add(const stream::Event& event) {
        std::visit([this](const auto& what) { add(what); }, event);
    }
    void add(const stream::StreamError& error) const {
        using What = stream::StreamError::What;
        std::string message = messages::explain(error, subject_of(error.place));
        if (error.what == What::json) {
            message += messages::json_advice(beginning_, command_->options.input);
        } else if (error.what == What::columns && !error.place.is_in_reference()) {
            message += advice_at(error.place.line, !error.column.header.empty());
        }
        tell({error.what == What::read ? 0 : error.place.line, error.place.side}, message);
    }
    void add(const std::array<stream::Unpaired, 2>& unpaired) const {
        for (const stream::Side side : stream::both_sides) {
            if (const auto& [rows, first_line] = unpaired.at(index_of(side)); rows > 0) {
                tell({.side = side}, fmt::format("unpaired: {}", rows_from(rows, first_line)));
            }
        }
    }

    void summarize() const {
        for (const auto& [side_and_kind, count] : counts_) {
            const stream::Diagnostic& first = count.first;
            if (command_->diagnostics == ShowDiagnostics::summary) {
                tell({.side = first.place.side},
                     command_->has_values
                         ? messages::describe(first)
                         : fmt::format("{}: {}; {}", name_of(first.kind), rows_from(count.rows, first.place.line),
                                       messages::meaning(first)));
            }
        }
    }
    /// The row errors that were not told one by one.
    void count_rest() const {
        if (errors() > most_errors) {
            print_error(fmt::format("{}: {} without a result",
                                    fmt::join(inputs_.begin(), inputs_.end() - (inputs_[1].empty() ? 1 : 0), " and "),
                                    counted(errors() - most_errors, "more row")));
        }
    }

    void add(const stream::Note& note) {
        const bool is_new = notes_.emplace(note.kind, note.place.side).second;
        if (!is_new || command_->diagnostics == ShowDiagnostics::off) {
            return;
        }
        if (note.place.line == 0) {
            print_error(note.text);
        } else {
            tell({note.kind == stream::Note::Kind::comments ? 0 : note.place.line, note.place.side}, note.text);
        }
    }

    /// What came of a run that is stopped, unless its code is set.
    [[nodiscard]] RowsResult result(const stream::RunResult& ending) const {
        return {ending, ExitCode::incomplete, failed_};
    }
    /// A note, or any kind but three.
    [[nodiscard]] bool met_diagnostic() const noexcept {
        return !notes_.empty() || std::ranges::any_of(counts_, [](const auto& count) {
            using enum DiagnosticKind;
            constexpr DiagnosticSet ignored{normalized, large_angle, few_digits};
            return !ignored.has(count.first.second);
        });
    }

private:
    [[nodiscard]] std::size_t errors() const noexcept { return failed_[0] + failed_[1]; }

    struct Count {
        std::size_t rows = 0;
        std::size_t last_line = 0;
        stream::Diagnostic first{};
    };

    void add(const stream::FirstBytes& first) { beginning_ = first.text; }
    void add(const stream::RowError& error) {
        const stream::Place& place = error.place;
        const bool ends_run = error.key == stream::KeyError::has_unit;
        failed_.at(index_of(place.side)) += ends_run ? 0 : 1;
        if (errors() > most_errors && !ends_run) {
            return;
        }
        const bool is_partners = error.cause.line > 0;
        const bool is_key = error.what == stream::RowError::What::key; // which is told with its mend
        const bool is_first = errors() == 1 && !place.is_in_reference() && !is_partners && !is_key;
        tell(place, (is_partners ? fmt::format("its partner {}: ", text_of(error.cause)) : "") +
                        messages::explain(error, subject_of(is_partners ? error.cause : place)) +
                        (command_->has_values ? messages::mend(error)
                         : is_first           ? advice_at(place.line)
                                              : ""));
    }
    void add(const stream::Diagnostic& diagnostic) {
        Count& count = counts_[{diagnostic.place.side, diagnostic.kind}];
        if (count.rows == 0) {
            count.first = diagnostic;
        }
        if (count.rows == 0 || count.last_line != diagnostic.place.line) { // a reference's row may be in several pairs
            ++count.rows;
            count.last_line = diagnostic.place.line;
        }
        if (command_->diagnostics == ShowDiagnostics::rows) {
            tell(diagnostic.place, messages::describe(diagnostic));
        }
    }

    void tell(const stream::Place& place, const std::string& message) const {
        print_error(fmt::format("{}: {}", text_of(place), message));
    }
    [[nodiscard]] std::string text_of(const stream::Place& place) const {
        const std::string at = place.line == 0 || command_->has_values ? "" : fmt::format(":{}", place.line);
        return inputs_.at(index_of(place.side)) + at;
    }
    /// The end of the message on a line before the first row that could be read.
    [[nodiscard]] std::string advice_at(std::size_t line, bool has_header = false) const {
        const bool is_text = !command_->has_values && command_->options.input.width == 0;
        const std::string text =
            is_text ? messages::advice(beginning_, line, has_header, command_->options, command_->input)
                    : std::string();
        return text.empty() ? text : "; " + text;
    }
    [[nodiscard]] const messages::Subject& subject_of(const stream::Place& place) const noexcept {
        return place.is_in_reference() ? command_->reference_subject : *command_->subject;
    }

    const RowsCommand* command_;
    std::array<std::string, 2> inputs_; ///< by Side; no reference: empty
    std::string beginning_;             ///< of the input
    std::map<std::pair<stream::Side, DiagnosticKind>, Count> counts_;
    std::set<std::pair<stream::Note::Kind, stream::Side>> notes_; ///< that were met
    std::array<std::size_t, 2> failed_{};                         ///< see RowsResult
};

/// Reads a file, and shows on stderr how much of it is read, if that is a terminal and the file is large.
class Progress final : public stream::Source {
public:
    Progress(stream::File& file, bool wanted)
        : file_(&file), size_(wanted && ::isatty(STDERR_FILENO) != 0 ? static_cast<double>(file.size()) : 0.0) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() override { clear(); }

    std::ptrdiff_t read(std::span<char> to) override {
        const auto count = file_->read(to);
        if (count > 0 && size_ >= large) {
            done_ += static_cast<double>(count);
            if (const auto now = Clock::now(); now >= next_) {
                next_ = now + interval;
                shown_ = true;
                show(fmt::format("rotconv: {:.0f} %\r", 100.0 * done_ / size_)); // a message overwrites it
            }
        }
        return count;
    }
    [[nodiscard]] bool is_ready() const override { return file_->is_ready(); }

    void clear() {
        if (std::exchange(shown_, false)) {
            show("\033[K");
        }
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr double large = 1e6; ///< bytes
    static constexpr auto interval = std::chrono::milliseconds(200);

    static void show(std::string_view text) { static_cast<void>(stream::File(STDERR_FILENO).write(text)); }

    stream::File* file_;
    double size_; ///< bytes; 0 if nothing is shown
    double done_ = 0.0;
    Clock::time_point next_ = Clock::now() + interval;
    bool shown_ = false;
};

/// The input, and the reference if there is one, up to the first that cannot be opened: errno says why.
/// @throw Usage if both are the same pipe
std::vector<std::unique_ptr<stream::File>> open_inputs(const RowsCommand& command) {
    std::vector<std::unique_ptr<stream::File>> files;
    for (const std::string& path : {command.input, command.reference}) {
        if (!path.empty() && (files.empty() || files.back()->is_open())) {
            if (!files.empty() &&
                files.back()->shares_bytes(path.c_str())) { // opening a pipe again would wait for ever
                throw Usage("FILE {} and REFERENCE {} are one input, which can be read only once",
                            quoted(command.input), quoted(path));
            }
            files.push_back(path == "-" ? std::make_unique<stream::File>(STDIN_FILENO)
                                        : std::make_unique<stream::File>(path.c_str(), stream::File::Mode::read));
        }
    }
    return files;
}

/// Writes to an output; for a check only as long as it has a reader.
class WhileRead final : public stream::Sink {
public:
    WhileRead(stream::Sink& to, bool is_check) : to_(&to), is_check_(is_check) {}
    int write(std::string_view bytes) override {
        const int error = is_read_ ? to_->write(bytes) : 0;
        is_read_ = is_read_ && error != EPIPE;
        return is_check_ && error == EPIPE ? 0 : error;
    }

private:
    stream::Sink* to_;
    bool is_check_;
    bool is_read_ = true;
};

/// Runs an operation over rows that are also read otherwise, and tells nothing.
/// @return why the run did not come to its end, in words, or empty if another run says it; nothing if it did
std::optional<std::string> run_silently(const RowsCommand& command, const Operation& operation,
                                        const std::shared_ptr<stream::Fold>& fold) {
    if (command.source) {
        return "";
    }
    for (const std::string& path : {command.input, command.reference}) {
        if (!path.empty() && stream::File::why_unreadable(path.c_str()) == 0 &&
            !stream::File::is_regular(path.c_str())) {
            return fmt::format("{}: the input is read twice, and a pipe cannot be", shown(path));
        }
    }
    const auto files = open_inputs(command);
    if (!files.back()->is_open()) {
        return "";
    }
    stream::Options options = command.options;
    options.operation = operation;
    options.fold = fold;
    const auto ending = stream::run(
        *files.front(), nullptr, options, [](const auto&) {}, files.size() > 1 ? files.back().get() : nullptr);
    return ending.error || ending.stopped ? std::optional("") : std::nullopt;
}

/// The command as its first pass makes it.
/// @return what is wrong, in words
std::string run_first_pass(RowsCommand& command) {
    if (const auto wrong = run_silently(command, command.first_pass->operation, command.first_pass->fold)) {
        command.options.writes_rows = false; // it is run for the messages
        command.conclude = [](const auto&, const auto&) { return Conclusion(); };
        return *wrong;
    }
    auto found = command.first_pass->conclude();
    if (const auto* wrong = std::get_if<std::string>(&found)) {
        return *wrong;
    }
    command.options.operation = std::get<0>(std::move(found));
    return {};
}

ExitCode run_last_pass(const RowsCommand& command) {
    using What = stream::StreamError::What;
    const auto inputs = open_inputs(command);
    if (!inputs.back()->is_open()) {
        return failed(inputs.size() == 1 ? command.input : command.reference, What::read, errno);
    }
    stream::OutputFile output(command.output);
    if (!command.source) {
        for (const auto& input : inputs) {
            if (output.is_same(*input)) {
                return failed("the same file is input and output");
            }
            input->widen();
        }
    }

    WhileRead rows_output(output, command.is_check);
    const bool on_screen = command.options.writes_rows && command.output == "-" && ::isatty(STDOUT_FILENO) != 0;
    Progress progress(*inputs.front(), !on_screen);
    stream::Source& source = command.source ? *command.source : progress;
    Reporter reporter(command);
    std::ranges::for_each(command.notes, [&reporter](const stream::Note& note) { reporter.add(note); });
    const stream::RunResult ending = stream::run(
        source, &rows_output, command.options, [&reporter](const stream::Event& event) { reporter.add(event); },
        inputs.size() > 1 ? inputs.back().get() : nullptr);
    if (ending.reader_left) { // closed the pipe: nothing more is known, and nothing is to be said
        return ExitCode::done;
    }
    reporter.summarize();
    if (ending.error) {
        if (ending.error->what == What::write) {
            return failed(command.output, What::write, ending.error->error_number);
        }
        reporter.add(*ending.error);
    }
    progress.clear();
    const bool is_whole = !ending.error && !ending.stopped;
    RowsResult result = reporter.result(ending);
    if (is_whole) {
        const auto& [seconds, line] = command.options.operation->first_step;
        if (seconds >= least_doubtful_step && !command.options.input.numbers.has_unit) {
            reporter.add(stream::Note{
                .kind = stream::Note::Kind::time_unit,
                .text = fmt::format("times {:.6g} apart are read in s; if not: --time-unit ms, us or ns", seconds),
                .place = {line}});
        }
        if (result.keys.likely) {
            reporter.add(
                stream::Note{.kind = stream::Note::Kind::pairing,
                             .text = fmt::format("rows are paired by their number, and column {} increases in "
                                                 "both files and differs; to pair by it: --key {}",
                                                 in_shell(*result.keys.likely), in_shell(*result.keys.likely))});
        }
        const bool strict = command.strict && reporter.met_diagnostic();
        const bool has_failures = result.failed[0] + result.failed[1] > 0 && !command.allow_failed;
        const bool has_unpaired = result.unpaired[1].rows > 0 && !command.allow_unpaired;
        result.code = has_failures || has_unpaired || strict ? ExitCode::completed_with_failures : ExitCode::done;
        reporter.add(result.unpaired);
        const auto& pairing = command.options.pairing;
        if (pairing && pairing->needs_partner && pairing->by_key && !result.keys.any_pair && result.rows > 0) {
            print_error(messages::few_keys_met(result.keys));
        }
    }
    reporter.count_rest();
    if (command.conclude && is_whole) {
        result.look_again = [&command](const Operation& operation) {
            static_cast<void>(run_silently(command, operation, nullptr));
        };
        const Conclusion conclusion = command.conclude(command, result);
        if (const int error = rows_output.write(conclusion.text); error != 0) {
            return error == EPIPE ? ExitCode::done : failed(command.output, What::write, error);
        }
        if (result.code == ExitCode::done && !conclusion.holds) {
            result.code = ExitCode::completed_with_failures;
        }
    }
    if (const int error = output.finish(is_whole); error != 0) {
        return failed(command.output, What::write, error);
    }
    return result.code;
}

} // namespace

ExitCode print(std::string_view text) {
    stream::OutputFile out("-");
    int error = out.write(text);
    error = error == 0 ? out.finish(true) : error;
    return error == 0 || error == EPIPE ? ExitCode::done : failed("-", stream::StreamError::What::write, error);
}

ExitCode run_rows(RowsCommand command) {
    const std::string wrong = command.first_pass ? run_first_pass(command) : "";
    return wrong.empty() ? run_last_pass(command) : failed(wrong);
}

} // namespace rotconv::cli
