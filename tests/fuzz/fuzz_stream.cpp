// The first line is the program's command line, its words parted by blanks, the rest a stream: any bytes; where a
// REFERENCE is named, that follows a form feed. Never a crash; the bytes arrive whole and in pieces, and are worked on
// by one thread and by many, and must become the same; and rows of one stream, written as csv, must be what a second
// implementation of the row rules says.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include <unistd.h>

#include <fmt/format.h>

#include "command_text.hpp"
#include "operations/operations.hpp"
#include "reach.hpp"
#include "row_model.hpp"
#include "stream/run.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using namespace rotconv;
using namespace rotconv::stream;
using fuzz::words_of;

fuzz::Reach reach{
    // clang-format off
        "rows converted by conversion", "rows converted by rates", "rows converted by propagate", "rows converted by survey",
        "rows converted by compare", "rows converted by compose", "rows converted by rotate",
        "rows converted by identify", "rows converted by sample",
        "rows failed in conversion", "rows failed in rates", "rows failed in propagate", "rows failed in survey",
        "rows failed in compare", "rows failed in compose", "rows failed in rotate", "rows failed in identify",
        "rows failed under --on-error=stop", "rows failed under --on-error=nan", "rows failed under --on-error=skip",
        "rows converted under --format=csv", "rows converted under --format=json", "rows converted under --format=pretty",
        "rows converted under --format=f64", "rows converted under --input-format=f64",
        "rows converted under --header=auto", "rows converted under --header=yes", "rows converted under --header=no",
        "rows converted under --header=add",
        "rows converted under --columns of indices", "rows converted under --columns in another order",
        "rows converted under --columns of names", "rows converted without --columns", "rows converted under --append",
        "rows converted under --continuous", "rows converted under --left", "rows converted under --right",
        "rows converted under --diagnostics=columns", "rows converted under --precision", "rows converted under --comment",
        "rows converted under --ragged",
        "rows compared under --format=csv", "rows compared under --format=json", "rows compared under --format=pretty",
        "rows compared of one stream", "rows compared by row", "rows compared by key",
        "rows compared under --input-format=f64", "rows compared beyond --within",
        "rows compared under --align", "rows compared under --delta", "rows compared under --interpolate",
        "rows compared under --key-offset", "rows compared under --worst", "rows compared under --min-pairs",
        "rows compared under a limit with a percentage", "rows composed by row", "rows composed by key",
        "rows compared under --allow-failed", "rows compared under --allow-unpaired",
        "rows identified of one stream", "rows identified by row", "rows identified by key",
        "conventions identified", "conventions identified with turns", "identifications that are ambiguous",
        "runs of which many threads had a part", "runs of pairs by row of which many threads had a part",
        "runs of pairs by key of which many threads had a part",
        "row compared", "failed row under stop", "failed row under nan", "failed row under skip",
        "blank row", "comment", "byte order mark", "CRLF", "last row without newline", "missing field", "quoted number",
        "row of another width",
        "detected delimiter comma", "detected delimiter tab", "detected delimiter semicolon", "detected delimiter blank",
        "given delimiter comma", "given delimiter tab", "given delimiter semicolon", "given delimiter blank",
        "given delimiter character",
    // clang-format on
};

/// The bytes of a source in pieces. Remembers which threads read it.
class Pieces final : public Source {
public:
    Pieces(Source& whole, std::size_t piece) : whole_(&whole), piece_(piece) {}
    std::ptrdiff_t read(std::span<char> to) override {
        threads_.insert(std::this_thread::get_id());
        return whole_->read(to.first(std::min(piece_, to.size())));
    }
    [[nodiscard]] std::size_t threads() const { return threads_.size(); }

private:
    Source* whole_;
    std::size_t piece_;
    std::set<std::thread::id> threads_;
};

/// Keeps the bytes.
struct Text final : Sink {
    int write(std::string_view bytes) override {
        text += bytes;
        return 0;
    }
    std::string text;
};

struct Result {
    std::string bytes;
    std::vector<std::string> failed; ///< lines
    bool to_the_end = false;
    std::string error; ///< of a stream, that ended the run
    std::size_t answered = 0;
    std::size_t beyond = 0;
    std::array<std::size_t, 4> unpaired{}; ///< of the stream and of the reference how many, and the line of the first
    std::string conclusion;                ///< of survey, identify and compare
    std::string notes;                     ///< letters, each with a line
    std::size_t threads = 0;
    friend bool operator==(const Result& a, const Result& b) {
        return a.bytes == b.bytes && a.failed == b.failed && a.to_the_end == b.to_the_end && a.answered == b.answered &&
               a.unpaired == b.unpaired && a.error == b.error && a.conclusion == b.conclusion && a.notes == b.notes;
    }
};

/// A command that is run on streams.
struct Program {
    cli::RowsCommand command;
    [[nodiscard]] const Options& options() const { return command.options; }
    [[nodiscard]] const RowOperation& operation() const { return *options().operation; }
    [[nodiscard]] bool is_paired() const { return options().pairing.has_value(); }
    [[nodiscard]] bool is_by_key() const { return is_paired() && options().pairing->by_key; }
    /// It serves one run.
    [[nodiscard]] bool remembers() const {
        return operation().in_order || operation().is_continuous() || options().fold || options().input.take_count ||
               command.source != nullptr || command.prepare;
    }
};

/// What the words say.
std::optional<Program> program_of(const std::vector<std::string>& words) {
    try {
        auto command = fuzz::command_of(words);
        auto* const rows = std::get_if<cli::RowsCommand>(&command);
        if (rows == nullptr || rows->has_values) {
            return std::nullopt;
        }
        return Program{std::move(*rows)};
    } catch (const cli::Usage&) {
        return std::nullopt;
    }
}

/// The same, for a look at it: to read a command line takes longer than a run.
const std::optional<Program>& known_program_of(const std::string& line, const std::vector<std::string>& words) {
    static std::map<std::string, std::optional<Program>> known;
    if (known.size() > 1000) {
        known.clear();
    }
    const auto [at, is_new] = known.try_emplace(line);
    if (is_new && !words.empty()) {
        at->second = program_of(words);
    }
    return at->second;
}

/// The streams, and how they arrive.
struct Input {
    std::string_view text;
    std::string_view reference;
    std::size_t piece = static_cast<std::size_t>(-1);
};

/// A file with that text, until it goes: some commands look through their rows twice.
struct TemporaryFile {
    std::string path;

    TemporaryFile(std::string_view text, const char* name)
        : path(fmt::format("/tmp/rotconv_fuzz_{}_{}", getpid(), name)) {
        std::ofstream(path, std::ios::binary) << text;
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() { std::remove(path.c_str()); }
};

std::string name_of_command(const std::vector<std::string>& words) {
    return cli::is_command(words.front()) ? words.front() : "conversion";
}

constexpr const char* of_reference = " of the reference ";

Result run_once(const Input& input, const std::vector<std::string>& words, const Program& given, std::size_t threads) {
    Program own = given.remembers() ? *program_of(words) : given;
    Options& options = own.command.options;
    options.threads = threads;
    Result result;
    std::optional<TemporaryFile> files[2];
    if (own.command.prepare || name_of_command(words) == "identify") {
        own.command.input = files[0].emplace(input.text, "input").path;
        own.command.reference = own.is_paired() ? files[1].emplace(input.reference, "reference").path : "";
    }
    if (const auto wrong = own.command.prepare ? own.command.prepare(own.command) : std::nullopt) {
        if (!wrong->empty()) {
            result.error = *wrong;
            return result;
        }
        options.writes_rows = false; // it is run for the messages
        own.command.conclude = nullptr;
    }
    TextSource text{std::string(input.text)};
    Pieces source(own.command.source ? *own.command.source : text, input.piece);
    Text sink;
    std::string notes_of_reference;
    const auto report = [&result, &notes_of_reference](const Event& event) {
        if (const auto* error = std::get_if<RowError>(&event)) {
            result.failed.push_back(fmt::format("{}{}{}", error->place.line,
                                                error->place.is_in_reference() ? of_reference : "",
                                                error->cause.line > 0 ? fmt::format(" by {}", error->cause.line) : ""));
        } else if (const auto* diagnostic = std::get_if<Diagnostic>(&event)) {
            result.beyond += diagnostic->kind == DiagnosticKind::beyond ? 1 : 0;
        } else if (const auto* note = std::get_if<Note>(&event)) {
            const char kind = static_cast<char>('a' + static_cast<int>(note->kind));
            std::string& notes = note->place.is_in_reference() ? notes_of_reference : result.notes;
            const bool is_known = notes.find(kind) != std::string::npos;
            notes += is_known ? "" : fmt::format("{}{}", kind, note->place.line);
        }
    };
    TextSource reference_text{std::string(input.reference)};
    Pieces reference(reference_text, input.piece);
    const RunResult ending = run(source, &sink, options, report, own.is_paired() ? &reference : nullptr);
    result.to_the_end = !ending.stopped && !ending.error;
    result.bytes = options.writes_rows ? std::move(sink.text) : "";
    if (result.to_the_end && !notes_of_reference.empty()) { // in a run that stops, how much of it is read is not said
        result.notes += of_reference + notes_of_reference;
    }
    if (ending.error) {
        result.error = fmt::format("{} {}{}", static_cast<int>(ending.error->what), ending.error->place.line,
                                   ending.error->place.is_in_reference() ? of_reference : "");
    }
    result.answered = ending.answered;
    for (std::size_t i = 0; i < 2 && result.to_the_end; ++i) {
        result.unpaired.at(2 * i) = ending.unpaired.at(i).rows;
        result.unpaired.at(2 * i + 1) = ending.unpaired.at(i).first_line;
    }
    result.threads = source.threads();
    if (own.command.conclude && result.to_the_end && result.answered > 0) {
        const auto count = static_cast<std::size_t>(std::ranges::count_if(
            result.failed, [](const std::string& line) { return line.find(of_reference) != std::string::npos; }));
        const auto answer =
            own.command.conclude(own.command, {ending, cli::ExitCode::done, {result.failed.size() - count, count}});
        result.conclusion = answer.text + (answer.holds ? " holds" : "");
    }
    return result;
}

/// The argument of `--name=argument` among the words.
std::string argument_of(const std::vector<std::string>& words, std::string_view name, std::string_view otherwise = "") {
    const auto found = std::ranges::find_if(words, [name](const std::string& word) {
        return word.starts_with(name) && word.substr(0, word.find('=')) == name;
    });
    return found == words.end() ? std::string(otherwise) : found->substr(std::min(name.size() + 1, found->size()));
}

bool has(const std::vector<std::string>& words, std::string_view word) { return std::ranges::count(words, word) > 0; }

void count_reach(const Result& result, const std::vector<std::string>& words, const Program& program) {
    const std::string command = name_of_command(words);
    const std::size_t rows = result.answered;
    const bool is_binary = argument_of(words, "--input-format") == "f64";
    const std::string pairing = !program.is_paired() ? "of one stream" : program.is_by_key() ? "by key" : "by row";
    reach.add("rows converted by " + command, rows);
    if (command != "sample") { // of which none fails
        reach.add("rows failed in " + command, result.failed.size());
    }
    reach.add("rows failed under --on-error=" + argument_of(words, "--on-error", "stop"), result.failed.size());
    if (command == "compare") {
        reach.add("rows compared under --format=" + argument_of(words, "--format", "pretty"), rows);
        reach.add("rows compared " + pairing, rows);
        reach.add("rows compared under --input-format=f64", is_binary ? rows : 0);
        reach.add("rows compared beyond --within", result.beyond);
        for (const std::string option : {"--align", "--delta", "--interpolate", "--key-offset", "--worst",
                                         "--min-pairs", "--allow-failed", "--allow-unpaired"}) {
            const bool is_given = std::ranges::any_of(
                words, [&option](const auto& word) { return word.substr(0, word.find('=')) == option; });
            reach.add("rows compared under " + option, is_given ? rows : 0);
        }
        const bool has_percentage =
            std::ranges::any_of(words, [](const auto& word) { return word.find('@') != std::string::npos; });
        reach.add("rows compared under a limit with a percentage", has_percentage ? rows : 0);
    } else if (command == "compose") {
        reach.add("rows composed by row", program.is_paired() && !program.is_by_key() ? rows : 0);
        reach.add("rows composed by key", program.is_by_key() ? rows : 0);
    } else if (command == "identify") {
        reach.add("rows identified " + pairing, rows);
        const std::size_t found = std::min(result.conclusion.find("-f "), result.conclusion.size());
        const std::string convention = result.conclusion.substr(found);
        const auto has_turn = [&convention](std::string_view option) {
            return convention.find(option) != std::string::npos;
        };
        reach.add("conventions identified", convention.empty() ? 0 : 1);
        reach.add("conventions identified with turns",
                  has_turn(" --left ") || has_turn(" --right ") || has_turn("-axes ") ? 1 : 0);
        reach.add("identifications that are ambiguous",
                  result.conclusion.find("ambiguous") != std::string::npos ? 1 : 0);
    } else if (command != "survey") { // whose rows go nowhere
        reach.add("rows converted under --format=" + argument_of(words, "--format", "csv"), rows);
    }
    reach.add("rows converted under --header=" + argument_of(words, "--header", "auto"), rows);
    const std::string columns = argument_of(words, "--columns");
    const bool are_names = columns.find_first_not_of("0123456789,-") != std::string::npos;
    const auto items = words_of(columns, ',');
    reach.add(columns.empty()                 ? "rows converted without --columns"
              : are_names                     ? "rows converted under --columns of names"
              : std::ranges::is_sorted(items) ? "rows converted under --columns of indices"
                                              : "rows converted under --columns in another order",
              rows);
    const auto add_where = [&](bool holds, std::string_view what) { reach.add(what, holds ? rows : 0); };
    add_where(is_binary, "rows converted under --input-format=f64");
    add_where(has(words, "--append"), "rows converted under --append");
    add_where(has(words, "--continuous"), "rows converted under --continuous");
    add_where(!argument_of(words, "--left").empty(), "rows converted under --left");
    add_where(!argument_of(words, "--right").empty(), "rows converted under --right");
    add_where(argument_of(words, "--diagnostics") == "columns", "rows converted under --diagnostics=columns");
    add_where(!argument_of(words, "--precision").empty(), "rows converted under --precision");
    add_where(!argument_of(words, "--comment").empty(), "rows converted under --comment");
    add_where(has(words, "--ragged"), "rows converted under --ragged");
}

[[noreturn]] void differ(std::string_view what, std::string_view a, std::string_view b) {
    std::fprintf(stderr, "%.*s\n--- the program:\n%.*s\n--- it should be:\n%.*s\n---\n", static_cast<int>(what.size()),
                 what.data(), static_cast<int>(a.size()), a.data(), static_cast<int>(b.size()), b.data());
    std::abort();
}

/// What the command makes of the numbers of one row alone.
fuzz::Calculate calculate_of(const Program& program) {
    return [operation = std::make_shared<RowOperation>(program.operation()), input = program.options().input](
               const std::vector<double>& numbers,
               const std::vector<std::string>& texts) -> std::optional<std::vector<double>> {
        stream::NumberRows row;
        const auto kept = static_cast<std::ptrdiff_t>(input.numbers.kept);
        if (kept > 0) {
            row.kept = {{texts[0], stream::read_key(texts[0], input.key_power), numbers[0]}};
        }
        row.numbers.append(numbers.data() + kept, numbers.data() + numbers.size());
        row.lines = {1};
        std::vector<double> result(operation->width());
        std::vector<RowReport> reports;
        operation->run(row, result, reports);
        const bool is_failed = !reports.empty() && reports.front().error != Error::none;
        return is_failed ? std::nullopt : std::optional(result);
    };
}

/// What the model is to know: the options' words, and the command's numbers. Nothing where other rules have a part:
/// pairs, other formats, headers, columns of diagnostics, fewer digits, and rows that wait for others.
std::optional<fuzz::Rules> rules_of(const std::vector<std::string>& words, const Program& program) {
    const auto argument = [&words](std::string_view name, std::string_view otherwise = "") {
        return argument_of(words, name, otherwise);
    };
    const InputOptions& input = program.options().input;
    const std::string header = argument("--header", "auto");
    const bool is_plain = !program.is_paired() && program.options().writes_rows &&
                          argument("--format", "csv") == "csv" && input.width == 0 && !input.columns.has_names() &&
                          !program.command.source && !program.command.prepare;
    if (!is_plain || header == "add" || argument("--diagnostics") == "columns" || !argument("--precision").empty() ||
        !argument("--decimals").empty() || has(words, "--differences") || argument("--interpolation") == "cubic" ||
        !argument("--delta").empty()) {
        return std::nullopt;
    }
    fuzz::Rules rules;
    rules.inputs = input.numbers.names.size();
    rules.kept = input.numbers.kept;
    rules.results = program.operation().width();
    rules.calculate = calculate_of(program);
    rules.columns = argument("--columns");
    rules.comment = argument("--comment", "#");
    rules.delimiter = argument("--delimiter");
    rules.header = header;
    rules.ragged = has(words, "--ragged");
    rules.on_error = argument("--on-error", "stop");
    rules.append = has(words, "--append") || name_of_command(words) == "compare";
    return rules;
}

std::string description(const Result& result) {
    return fmt::format("{}\nfailed: {}\nto the end: {}, error: {}, answered: {}, unpaired: {}, notes: {}\n{}",
                       result.bytes, fmt::join(result.failed, ", "), result.to_the_end, result.error, result.answered,
                       fmt::join(result.unpaired, " "), result.notes, result.conclusion);
}

void require_same(std::string_view what, const Result& a, const Result& b) {
    if (!(a == b)) {
        differ(what, description(a), description(b));
    }
}

void compare_with_model(const Input& input, const std::vector<std::string>& words, const Program& program,
                        const Result& result) {
    const Program own = program.remembers() ? *program_of(words) : program;
    const auto rules = rules_of(words, own);
    const auto outcome = rules ? fuzz::model(input.text, *rules) : std::nullopt;
    if (!outcome) {
        return;
    }
    Result right = result; // for what is not modelled
    right.bytes = outcome->bytes;
    right.failed.clear();
    for (const std::size_t line : outcome->failed) {
        right.failed.push_back(std::to_string(line));
    }
    right.answered = outcome->answered;
    right.to_the_end = outcome->to_the_end;
    require_same("the rules of rows say otherwise", result, right);
    std::ranges::for_each(outcome->met, [](const std::string& rule) { reach.add(rule); });
}

/// The text many times over, so that it is worth threads; a key at the beginning of a row increases from one copy to
/// the next.
std::string repeated(std::string_view text, std::size_t times, bool by_key) {
    constexpr std::size_t digits = 9;
    std::string all;
    for (std::size_t copy = 0; copy < times; ++copy) {
        for (std::string_view rest = text; !rest.empty();) {
            const std::string_view line = rest.substr(0, std::min(rest.find('\n'), rest.size() - 1) + 1);
            rest.remove_prefix(line.size());
            const std::size_t whole = std::min(line.find_first_not_of("0123456789"), line.size());
            if (by_key && whole > 0 && whole <= digits) {
                all += std::to_string(1'000'000 + copy).append(digits - whole, '0');
            }
            all += line;
        }
        all += by_key && !all.ends_with('\n') ? "\n" : "";
    }
    return all;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view all(reinterpret_cast<const char*>(data), size);
    reach.begin(all);
    const std::string_view line = all.substr(0, all.find('\n'));
    const std::string_view text = all.substr(std::min(line.size() + 1, size));
    const auto words = words_of(line, ' ');
    const auto& program = known_program_of(std::string(line), words);
    if (!program) {
        return 0;
    }
    const std::string_view first = program->is_paired() ? text.substr(0, text.find('\f')) : text;
    const Input input{.text = first, .reference = text.substr(std::min(first.size() + 1, text.size()))};
    const Result whole = run_once(input, words, *program, 1);
    count_reach(whole, words, *program);
    require_same("in pieces", run_once({input.text, input.reference, 1 + size % 16}, words, *program, 1), whole);
    compare_with_model(input, words, *program, whole);
    if (!program->command.source && !argument_of(words, "--threads").empty() && !first.empty()) {
        constexpr std::size_t enough = std::size_t{24} << 10U;
        const std::size_t times = 1 + enough / first.size();
        const std::string many_times = repeated(first, times, program->is_by_key());
        const std::string references = repeated(input.reference, times, program->is_by_key());
        const Input larger{.text = many_times, .reference = references};
        const Result many = run_once(larger, words, *program, program->options().threads);
        require_same("with threads", many, run_once(larger, words, *program, 1));
        const std::string pairs = program->is_by_key()   ? "pairs by key of "
                                  : program->is_paired() ? "pairs by row of "
                                                         : "";
        reach.add("runs of " + pairs + "which many threads had a part", many.threads > 1 ? 1 : 0);
    }
    return 0;
}

namespace {

/// Options that are put in the place of those of a command line. A new option is tried once it stands here.
const std::vector<std::string> option_words =
    words_of("--from=quat --from=quat:xyzw --from=dcm --from=dcm:col:passive --from=6d --from=5d --from=rotvec:deg "
             "--from=axis-angle --from=euler:ZYX:deg --from=rpy --from=cayley --from=mrp --to=quat --to=dcm:col "
             "--to=6d --to=5d --to=euler:zxz:deg --to=rotvec --to=axis-angle:passive --to=cayley --to=mrp --to=rpy "
             "--header=auto --header=yes --header=no --header=add --format=csv --format=json --format=pretty "
             "--format=f64 --on-error=stop --on-error=nan --on-error=skip --columns=2-5 --columns=4,3,2,1 "
             "--columns=a,b,c,d --columns=qw,qx,qy,qz --columns=x,2-4 --columns=2-4 --columns=3,1,2 --columns=a,b,c "
             "--columns=2-10 --columns=1,3-7 --columns=3-8 --columns=t,wx,wy,wz --columns=1-7 --delimiter=comma "
             "--delimiter=tab --delimiter=semicolon --delimiter=blank --delimiter=| --append --strict --degrees "
             "--precision=6 --precision=17 --decimals=0 --decimals=6 --threads=16 --input-format=f64 --width=4 "
             "--width=6 --width=10 --comment=none --comment=% --comment=1 --tolerance=inf --tolerance=0 "
             "--lock-margin=0.01rad --diagnostics=columns "
             "--diagnostics=off --diagnostics=rows --inverse --differences --frame=reference --with=rpy --with=mrp "
             "--integrator=rk4 --integrator=magnus6 --substeps=3 --interpolation=cubic --renormalise "
             "--initial=quat:0,1,0,0 --continuous --left=quat:0,1,0,0 --right=rpy:deg:0,90,30 --time-unit=ns "
             "--reference-axes=ned:enu --body-axes=frd:flu --reference-axes=ruf:flu --body-axes=ruf:flu "
             "--condition=10 --method=shepperd --method=all --key=1 --key=t --key-within=0.5 --key-within=0.000000001 "
             "--reference-key=2 --reference-columns=2-5 --reference-columns=a,b,c,d --reference-columns=3,1,2 "
             "--reference-columns=2-4 --within=0.1rad --within=0 --by=quat --by=rpy:deg --by=cayley --by=dcm:passive "
             "--from=mrp:passive --from=euler --columns=1-4 --columns=1-8 --columns=5-8,1-4 --columns=1-12 "
             "--align=reference --align=body --align=both --align=yaw --align=first --delta=1 --delta=2 --interpolate "
             "--key-offset=0.25 --key-offset=-1 --worst=1 --worst=3 --min-pairs=2 --min-pairs=60% --within=0.1rad@95 "
             "--within=100deg@50 --allow-failed --allow-unpaired=file --allow-unpaired=reference --allow-unpaired=both "
             "--ragged --columns=roll,pitch,yaw --rows=40 --seed=7 --kind=cube,small --kind=noise --kind=many-turns "
             "--noise=0.1",
             ' ');

/// Another option, in the place of the same with another argument; the line as it was where none of a few is legal.
std::string with_another_option(const std::string& line, unsigned seed) {
    for (int attempt = 0; attempt < 4; ++attempt) {
        seed = seed * 1664525U + 1013904223U;
        const std::string& option = option_words[(seed >> 8U) % option_words.size()];
        auto words = words_of(line, ' ');
        const std::string name = option.substr(0, option.find('='));
        const bool removes = (seed >> 4U) % 3 == 0;
        std::erase_if(words, [&name](const std::string& word) { return word.substr(0, word.find('=')) == name; });
        if (!removes) {
            words.push_back(option);
        }
        if (const std::string text = fmt::format("{}", fmt::join(words, " ")); known_program_of(text, words)) {
            return text;
        }
    }
    return line;
}

/// Rows of numbers, those of a unit quaternion or any. The first may be a key: it mostly increases, by quarters, so
/// that there are pairs, ties and faults.
std::string some_rows(std::minstd_rand& random, std::size_t fields, bool by_key, char delimiter) {
    constexpr std::array numbers{"0", "1", "-1", "0.1", "-0.7", "3", "1e-9", "x", "0.25"};
    std::string text;
    long quarters = 0;
    for (std::size_t rows = random() % 32; rows > 0; --rows) {
        const bool is_unit = random() % 4 != 0;
        const unsigned step = random() % 16;
        quarters += step == 0 ? 0 : step == 1 ? -1 : 1 + static_cast<long>(step % 5);
        std::vector<std::string> row;
        if (by_key) {
            row.push_back(fmt::format("{}", 0.25 * static_cast<double>(quarters)));
        }
        while (row.size() < fields) {
            row.emplace_back(is_unit ? (random() % 2 == 0 ? "0.5" : "-0.5") : numbers[random() % numbers.size()]);
        }
        text += fmt::format("{}\n", fmt::join(row, std::string_view(&delimiter, 1)));
        text += random() % 16 == 0 ? "# a\n" : "";
    }
    return text;
}

/// Two streams for a command that pairs them; nothing for another one, or where columns have names.
std::optional<std::string> pairs_for(const std::string& line, unsigned seed) {
    const auto words = words_of(line, ' ');
    const auto& program = known_program_of(line, words);
    if (!program || !program->is_paired() || program->options().input.width > 0 ||
        program->options().input.columns.has_names()) {
        return std::nullopt;
    }
    constexpr std::size_t many = 12;
    std::minstd_rand random(seed);
    const auto rows = [&](const InputOptions& options, char delimiter) {
        const std::size_t fields = options.columns.empty() ? options.numbers.names.size() : many;
        return some_rows(random, fields, program->is_by_key(), delimiter);
    };
    const std::string text = rows(program->options().input, random() % 2 == 0 ? ',' : ' ');
    return text + '\f' + rows(program->options().pairing->reference, ';');
}

std::size_t put(std::string_view line, std::string_view text, std::uint8_t* to, std::size_t most) {
    const std::string all = std::string(line) + '\n' + std::string(text);
    const std::size_t size = std::min(all.size(), most);
    std::memcpy(to, all.data(), size);
    return size;
}

} // namespace

/// Mutates the stream and leaves the command line legal. Seven times in eight it is an input that has reached what is
/// reached least, so that all counters grow; to read another command line takes longer than ten such runs.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    std::string all(reinterpret_cast<const char*>(data), size);
    const bool is_rare = seed % 8 != 0 && !reach.rarest().empty();
    if (is_rare) {
        all = reach.rarest().substr(0, most);
    }
    const std::string line = all.substr(0, all.find('\n'));
    std::string text = all.substr(std::min(line.size() + 1, all.size()));
    const unsigned kind = is_rare ? 4 : seed / 8 % 4;
    if (kind == 0) {
        return put(with_another_option(line, seed), text, data, most);
    }
    if (kind == 1) {
        if (const auto pairs = pairs_for(line, seed)) {
            return put(line, *pairs, data, most);
        }
    }
    if (is_rare && seed / 8 % 4 != 0) { // a row again, by which little is lost
        const std::size_t begin = text.rfind('\n', seed % (text.size() + 1)) + 1;
        const std::string row = text.substr(begin, text.find('\n', begin) - begin) + '\n';
        for (unsigned copies = seed / 32 % 8; copies > 0; --copies) {
            text.insert(begin, row);
        }
        return put(line, text, data, most);
    }
    if (line.size() + 1 >= most) {
        return size;
    }
    const std::size_t room = most - line.size() - 1;
    const std::size_t length = std::min(text.size(), room);
    text.resize(room);
    text.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(text.data()), length, room));
    return put(line, text, data, most);
}

/// The command line of one with the stream of the other.
extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* one, std::size_t one_size,
                                                 const std::uint8_t* other, std::size_t other_size, std::uint8_t* to,
                                                 std::size_t most, unsigned /*seed*/) {
    const std::string_view first(reinterpret_cast<const char*>(one), one_size);
    const std::string_view second(reinterpret_cast<const char*>(other), other_size);
    return put(first.substr(0, first.find('\n')), second.substr(std::min(second.find('\n') + 1, second.size())), to,
               most);
}
