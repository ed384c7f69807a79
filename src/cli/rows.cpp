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

#include "messages/answers.hpp"

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

/// A text to stderr, in one piece. If that fails there is nobody to tell.
void show(std::string_view text) { static_cast<void>(stream::File(STDERR_FILENO).write(text)); }

/// A line on a terminal that says how far work of more than a second is, until it is cleared.
class Progress {
public:
    /// @param size bytes of the whole; 0: that is not known
    /// @param row bytes of a row; 0: a row is a line
    Progress(bool is_shown, std::size_t size, std::size_t row) : is_shown_(is_shown), size_(size), row_(row) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() { clear(); }

    /// Adds bytes that have been read.
    void add(std::string_view bytes) {
        if (!is_shown_) {
            return;
        }
        done_ += bytes.size();
        rows_ = row_ > 0 ? done_ / row_ : rows_ + static_cast<std::size_t>(std::ranges::count(bytes, '\n'));
        if (const auto now = Clock::now(); now >= next_) {
            next_ = now + interval;
            has_line_ = true;
            const double seconds = std::chrono::duration<double>(now - begin_).count();
            const double part = size_ > 0 ? static_cast<double>(done_) / static_cast<double>(size_) : 0.0;
            const std::string percent = size_ > 0 ? fmt::format("{:.0f} %, ", 100.0 * part) : "";
            const std::string left = part > 0.0 ? fmt::format(", {:.0f} s left", seconds / part - seconds) : "";
            show(fmt::format("rotconv: {}{} rows, {:.3g} rows/s{}\033[K\r", percent, rows_, // a message overwrites it
                             static_cast<double>(rows_) / seconds, left));
        }
    }
    void clear() {
        if (std::exchange(has_line_, false)) {
            show("\033[K");
        }
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds before_first{1000};
    static constexpr std::chrono::milliseconds interval{200};

    bool is_shown_;
    bool has_line_ = false;
    std::size_t size_;
    std::size_t row_;
    std::size_t done_ = 0; ///< bytes
    std::size_t rows_ = 0;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point next_ = begin_ + before_first;
};

/// Reads a file, and keeps its first bytes.
class Input final : public stream::Source {
public:
    Input(stream::File& file, bool shows_progress, std::size_t row_size)
        : file_(&file), progress_(shows_progress && ::isatty(STDERR_FILENO) != 0, file.size(), row_size) {}

    std::ptrdiff_t read(std::span<char> to) override {
        const auto count = file_->read(to);
        if (count > 0) {
            const auto more = std::min(static_cast<std::size_t>(count), most_first_bytes - beginning_.size());
            beginning_.append(to.data(), more);
        }
        progress_.add({to.data(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(count, 0))});
        return count;
    }
    [[nodiscard]] bool is_ready() const override { return file_->is_ready(); }

    /// The first bytes, up to 64 KiB: where fewer have been read it reads on, so that they do not depend on the pieces
    /// in which they come. A pipe whose writer is silent is waited for two seconds, what a person types is not.
    [[nodiscard]] std::string_view beginning() {
        std::array<char, 4096> next{};
        while (reads_on() && file_->is_ready_within(most_patience) && read(next) > 0) {
        }
        return stream::without_byte_order_mark(beginning_);
    }
    /// Whether beginning() may have to wait.
    [[nodiscard]] bool may_wait() const { return reads_on() && !file_->is_regular(); }

    void clear() { progress_.clear(); }

private:
    static constexpr std::chrono::milliseconds most_patience{2000};

    [[nodiscard]] bool reads_on() const {
        return beginning_.size() < most_first_bytes && ::isatty(file_->descriptor()) == 0;
    }

    stream::File* file_;
    std::string beginning_;
    Progress progress_;
};

std::string rows_from(std::size_t rows, std::size_t first_line) {
    return fmt::format("{}, first at line {}", counted(rows, "row"), first_line);
}

/// Counts the events of a run, and prints them and their summary.
class Reporter {
public:
    Reporter(const RowsCommand& command, Input& input)
        : command_(&command),
          input_(&input), inputs_{command.has_values ? "argument" : shown(command.input), shown(command.reference)} {}

    void add(const stream::Event& event) {
        std::visit([this](const auto& what) { add(what); }, event);
    }
    void add(const stream::StreamError& error) const {
        using What = stream::StreamError::What;
        const std::string message = messages::explain(error, subject_of(error.place));
        const stream::Place place{error.what == What::read ? 0 : error.place.line, error.place.side};
        const bool has_answers = error.what == What::json || error.what == What::columns || error.what == What::count;
        has_answers ? tell_with_answers(place, message) : tell(place, message);
    }
    /// The error of a row that ended the run, with advice if no row could be read, or other ones.
    void add_last_error(const stream::RunResult& ending) const {
        if (!last_error_) {
            return;
        }
        using enum stream::RowError::What;
        const auto what = last_error_->what;
        const bool is_gap = what == not_a_number && !command_->has_values &&
                            last_error_->text.find_first_not_of("\" \t") == std::string::npos;
        const std::string message = in_words(*last_error_) + (is_gap ? "; --on-error skip or nan goes on" : "");
        const bool has_answers =
            ending.answered == 0 || what == other_width || what == missing_column || what == attitude;
        has_answers ? tell_with_answers(last_error_->place, message) : tell(last_error_->place, message);
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
        const std::size_t line = note.kind == stream::Note::Kind::comments ? 0 : note.place.line;
        const std::string message =
            note.place.line == 0 ? note.text : told({.line = line, .side = note.place.side}, note.text);
        if (told_notes_.insert(message).second) { // FILE and REFERENCE may be the same
            print_error(message);
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
            constexpr DiagnosticSet ignored{normalized, large_angle};
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

    void add(const stream::RowError& error) {
        const bool ends_run = error.key == stream::KeyError::has_unit;
        failed_.at(index_of(error.place.side)) += ends_run ? 0 : 1;
        if (errors() > most_errors && !ends_run) {
            return;
        }
        if (command_->options.on_error == stream::OnError::stop && may_be_advised(error)) {
            last_error_ = error; // told after the run, in which the input may be read at the same time
        } else {
            tell(error.place, in_words(error));
        }
    }
    void add(const stream::Diagnostic& diagnostic) {
        Count& count =
            counts_.try_emplace({diagnostic.place.side, diagnostic.kind}, Count{.first = diagnostic}).first->second;
        if (count.rows > 0 && count.last_line >= diagnostic.place.line) { // a reference's row may be in several pairs
            return;
        }
        ++count.rows;
        count.last_line = diagnostic.place.line;
        if (command_->diagnostics == ShowDiagnostics::rows) {
            tell(diagnostic.place, messages::describe(diagnostic));
        }
    }

    [[nodiscard]] std::string in_words(const stream::RowError& error) const {
        const bool is_partners = error.cause.line > 0;
        return (is_partners ? fmt::format("its partner {}: ", text_of(error.cause)) : "") +
               messages::explain(error, subject_of(is_partners ? error.cause : error.place));
    }
    /// Whether there may be another way to read the row.
    [[nodiscard]] bool may_be_advised(const stream::RowError& error) const noexcept {
        using enum stream::RowError::What;
        return command_->options.input.width == 0 && !error.place.is_in_reference() && error.cause.line == 0 &&
               (error.what == not_a_number || error.what == wrong_count || error.what == missing_column ||
                error.what == other_width || error.what == open_quote ||
                (error.what == attitude && error.error == Error::coarse_step) ||
                may_be_tolerated(*command_->line, error));
    }
    [[nodiscard]] std::string text_of(const stream::Place& place) const {
        const std::string at = place.line == 0 || command_->has_values ? "" : fmt::format(":{}", place.line);
        return inputs_.at(index_of(place.side)) + at;
    }
    [[nodiscard]] std::string told(const stream::Place& place, const std::string& message) const {
        return fmt::format("{}: {}", text_of(place), message);
    }
    void tell(const stream::Place& place, const std::string& message) const { print_error(told(place, message)); }
    /// The message does not wait for more of the input, though the answers do.
    void tell_with_answers(const stream::Place& place, const std::string& message) const {
        std::string text = fmt::format("rotconv: {}", told(place, message));
        if (command_->has_values) {
            const std::string commands = answers(command_->line->words);
            show(text + (commands.empty() && last_error_ ? messages::fix_hint(*last_error_) : "") + "\n" + commands);
            return;
        }
        if (input_->may_wait()) {
            show(std::exchange(text, {}));
        }
        show(text + end_of_message(*command_, input_->beginning()));
    }
    [[nodiscard]] const messages::Subject& subject_of(const stream::Place& place) const noexcept {
        return place.is_in_reference() ? command_->reference_subject : *command_->subject;
    }

    const RowsCommand* command_;
    Input* input_;
    std::array<std::string, 2> inputs_; ///< by Side; no reference: empty
    std::optional<stream::RowError> last_error_{};
    std::map<std::pair<stream::Side, DiagnosticKind>, Count> counts_;
    std::set<std::pair<stream::Note::Kind, stream::Side>> notes_; ///< that were met
    std::set<std::string> told_notes_;
    std::array<std::size_t, 2> failed_{}; ///< see RowsResult
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

/// What is told of a run that came to its end, and its exit status.
void judge(const RowsCommand& command, Reporter& reporter, RowsResult& result) {
    const auto& step = command.options.operation->first_step;
    const auto [seconds, line] = step ? *step : std::pair<double, std::size_t>();
    if (seconds >= least_doubtful_step && !command.options.input.numbers.has_unit) {
        reporter.add(stream::Note{
            .kind = stream::Note::Kind::time_unit,
            .text = fmt::format("times {:.6g} apart are read in s; if not: --time-unit ms, us or ns", seconds),
            .place = {line}});
    }
    if (result.keys.likely) {
        reporter.add(stream::Note{.kind = stream::Note::Kind::pairing,
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
        print_error(messages::few_keys_met(result.keys, *pairing));
    }
}

ExitCode run_pass(const RowsCommand& command) {
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
    Input input(*inputs.front(), !on_screen && command.diagnostics != ShowDiagnostics::off,
                command.options.input.width * sizeof(double));
    stream::Source& source = command.source ? *command.source : input;
    Reporter reporter(command, input);
    std::ranges::for_each(command.notes, [&reporter](const stream::Note& note) { reporter.add(note); });
    const stream::RunResult ending = stream::run(
        source, &rows_output, command.options, [&reporter](const stream::Event& event) { reporter.add(event); },
        inputs.size() > 1 ? inputs.back().get() : nullptr);
    if (ending.reader_left) { // closed the pipe: nothing more is known, and nothing is to be said
        return ExitCode::done;
    }
    reporter.add_last_error(ending);
    reporter.summarize();
    if (ending.error) {
        if (ending.error->what == What::write) {
            return failed(command.output, What::write, ending.error->error_number);
        }
        reporter.add(*ending.error);
    }
    input.clear();
    const bool is_whole = !ending.error && !ending.stopped;
    RowsResult result = reporter.result(ending);
    if (is_whole) {
        judge(command, reporter, result);
    }
    reporter.count_rest();
    if (command.conclude && is_whole) {
        const Conclusion conclusion = command.conclude(command, result);
        if (const int error = rows_output.write(conclusion.text); error != 0) {
            return error == EPIPE ? ExitCode::done : failed(command.output, What::write, error);
        }
        const bool is_done = conclusion.holds || result.code != ExitCode::done;
        result.code = is_done ? result.code : ExitCode::completed_with_failures;
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

std::optional<std::string> look_through(const RowsCommand& command, const Operation& operation,
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

ExitCode run_rows(RowsCommand command) {
    if (const auto wrong = command.prepare ? command.prepare(command) : std::nullopt) {
        if (!wrong->empty()) {
            return failed(*wrong);
        }
        command.options.writes_rows = false; // it is run for the messages
        command.conclude = [](const auto&, const auto&) { return Conclusion(); };
    }
    return run_pass(command);
}

} // namespace rotconv::cli
