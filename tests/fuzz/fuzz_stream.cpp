// The first line is the program's command line, its words parted by blanks, the rest a stream: any bytes; where a
// REFERENCE is named, that follows a form feed. Never a crash; the bytes arrive whole and in pieces, and are worked on
// by one thread and by many, and must become the same; and this must be what a second implementation of the row rules
// says.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include <fmt/format.h>

#include "command_text.hpp"
#include "comparison_model.hpp"
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
        "row compared", "failed row under stop", "failed row under nan", "failed row under skip", "header", "added header",
        "blank row", "comment", "byte order mark", "CRLF", "last row without newline", "missing field", "quoted number",
        "row of another width",
        "detected delimiter comma", "detected delimiter tab", "detected delimiter semicolon", "detected delimiter blank",
        "given delimiter comma", "given delimiter tab", "given delimiter semicolon", "given delimiter blank",
        "given delimiter character",
        "pair by row", "pair by key", "unpaired row of the stream", "unpaired row of the reference",
        "failed row of the stream", "failed row of the reference", "failed key of the stream", "failed key of the reference",
        "angle that agrees", "product that agrees", "refusal that agrees", "angle of turns that agrees",
        "verdict that agrees", "worst pair that agrees", "alignment that agrees", "sample that agrees",
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

/// Keeps the results, of pairs also the angles, and hands the rows on.
struct Results final : Fold {
    explicit Results(std::shared_ptr<Fold> to) : next(std::move(to)) {}
    void add(const AnsweredRows& rows) override {
        const std::size_t width = rows.results.size() / rows.lines.size();
        auto report = rows.reports.begin();
        for (std::size_t row = 0; row < rows.lines.size(); ++row) {
            const bool is_reported = report != rows.reports.end() && report->row == row;
            if (is_reported && (report++)->error != Error::none) {
                continue;
            }
            const auto result = std::span(rows.results).subspan(row * width, width);
            bytes.append(reinterpret_cast<const char*>(result.data()),
                         result.size_bytes()); // NOLINT(*-reinterpret-cast)
            if (!std::isnan(result[0])) {
                angles.push_back(result[0]);
            }
        }
        next->add(rows);
    }
    std::shared_ptr<Fold> next;
    std::string bytes;
    std::vector<double> angles;
};

struct Result {
    std::string bytes;
    std::vector<fuzz::Failure> failed;
    bool to_the_end = false;
    std::string error;    ///< of a stream, that ended the run
    std::size_t rows = 0; ///< of the stream
    std::size_t answered = 0;
    std::size_t beyond = 0;
    std::array<std::size_t, 4> unpaired{}; ///< of the stream and of the reference how many, and the line of the first
    std::string conclusion;                ///< of survey, identify and compare
    bool holds = false;                    ///< what compare checks
    std::vector<double> angles;            ///< that compare sums up...
    std::vector<double> angles_before;     ///< ...and before --align turned the attitudes
    std::shared_ptr<RowOperation> aligned; ///< before its first row
    std::string notes;                     ///< letters, each with a line
    std::size_t threads = 0;
    friend bool operator==(const Result& a, const Result& b) {
        return a.bytes == b.bytes && a.failed == b.failed && a.to_the_end == b.to_the_end && a.answered == b.answered &&
               a.unpaired == b.unpaired && a.error == b.error && a.conclusion == b.conclusion && a.notes == b.notes &&
               a.holds == b.holds;
    }
};

/// A command that is run on streams.
struct Program {
    cli::RowsCommand command;
    bool reports = false; ///< what is made of all pairs together is looked at

    [[nodiscard]] const Options& options() const { return command.options; }
    [[nodiscard]] const RowOperation& operation() const { return *options().operation; }
    [[nodiscard]] bool is_paired() const { return options().pairing.has_value(); }
    [[nodiscard]] bool is_by_key() const { return is_paired() && options().pairing->by_key; }
    /// Its rows go nowhere, and to no fold that knows pairs.
    [[nodiscard]] bool has_text_alone() const { return !options().writes_rows && !command.is_check; }
    /// It serves one run.
    [[nodiscard]] bool remembers() const {
        return operation().in_order || operation().is_continuous() || options().fold || options().input.take_count ||
               command.source != nullptr || command.first_pass || reports;
    }
};

/// Has compare take what only its report shows.
bool is_about_report(const std::string& word) {
    constexpr std::array<std::string_view, 4> options{"--align", "--allow-", "--min-pairs", "--worst"};
    return word.find('@') != std::string::npos ||
           std::ranges::any_of(options, [&word](std::string_view option) { return word.starts_with(option); });
}

/// What the words say.
std::optional<Program> program_of(const std::vector<std::string>& words) {
    try {
        auto command = fuzz::command_of(words);
        auto* const rows = std::get_if<cli::RowsCommand>(&command);
        if (rows == nullptr || rows->has_values) {
            return std::nullopt;
        }
        const bool reports =
            !rows->options.writes_rows && rows->is_check && std::ranges::any_of(words, is_about_report);
        return Program{std::move(*rows), reports};
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

/// The program as its first pass makes it; false where there is nothing to go on with.
bool run_first_pass(const Input& input, Program& own, Result& result) {
    cli::FirstPass& first = *own.command.first_pass;
    Options options = own.options();
    options.operation = first.operation;
    const auto results = std::make_shared<Results>(first.fold);
    options.fold = results;
    TextSource text{std::string(input.text)};
    TextSource reference{std::string(input.reference)};
    const RunResult ending = run(
        text, nullptr, options, [](const Event&) {}, own.is_paired() ? &reference : nullptr);
    if (ending.error || ending.stopped) {
        own.command.options.writes_rows = false;
        own.command.conclude = nullptr;
        own.reports = false;
        return true;
    }
    auto found = first.conclude();
    if (const auto* wrong = std::get_if<std::string>(&found)) {
        result.error = *wrong;
        return false;
    }
    own.command.options.operation = std::get<cli::Operation>(found);
    result.aligned = std::make_shared<RowOperation>(own.operation());
    result.angles_before = results->angles;
    return true;
}

Result run_once(const Input& input, const std::vector<std::string>& words, const Program& given, std::size_t threads) {
    Program own = given.remembers() ? *program_of(words) : given;
    Options& options = own.command.options;
    options.threads = threads;
    Result result;
    if (own.command.first_pass && !run_first_pass(input, own, result)) {
        return result;
    }
    TextSource text{std::string(input.text)};
    Pieces source(own.command.source ? *own.command.source : text, input.piece);
    Text sink;
    const auto results = options.fold ? std::make_shared<Results>(options.fold) : nullptr;
    options.fold = results;
    std::string notes_of_reference;
    const auto report = [&result, &notes_of_reference](const Event& event) {
        if (const auto* error = std::get_if<RowError>(&event)) {
            result.failed.push_back({error->place.line, error->place.is_in_reference(), error->cause.line});
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
    result.angles = own.reports ? results->angles : std::vector<double>();
    result.to_the_end = !ending.stopped && !ending.error;
    const bool has_results = own.command.is_check && result.to_the_end; // else some may come of rows after an error
    result.bytes = options.writes_rows ? std::move(sink.text) : has_results ? results->bytes : "";
    if (result.to_the_end && !notes_of_reference.empty()) { // in a run that stops, how much of it is read is not said
        result.notes += " of the reference " + notes_of_reference;
    }
    if (ending.error) {
        result.error = fmt::format("{} {}{}", static_cast<int>(ending.error->what), ending.error->place.line,
                                   ending.error->place.is_in_reference() ? " of the reference" : "");
    }
    result.rows = ending.rows;
    result.answered = ending.answered;
    for (std::size_t i = 0; i < 2 && result.to_the_end; ++i) {
        result.unpaired.at(2 * i) = ending.unpaired.at(i).rows;
        result.unpaired.at(2 * i + 1) = ending.unpaired.at(i).first_line;
    }
    result.threads = source.threads();
    if (own.command.conclude && (own.has_text_alone() || own.reports) && result.to_the_end && result.answered > 0) {
        const auto of_reference = std::ranges::count(result.failed, true, &fuzz::Failure::of_reference);
        const std::array failed{result.failed.size() - static_cast<std::size_t>(of_reference),
                                static_cast<std::size_t>(of_reference)};
        const auto look_again = [](const cli::Operation& /*operation*/) {}; // as of a pipe, no row is read again
        const auto answer = own.command.conclude(own.command, {ending, cli::ExitCode::done, failed, look_again});
        result.conclusion = answer.text;
        result.holds = answer.holds;
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

std::string name_of_command(const std::vector<std::string>& words) {
    const auto& first = words.front();
    constexpr std::array commands{"rates", "propagate", "survey", "compare", "compose", "rotate", "identify", "sample"};
    return std::ranges::count(commands, first) > 0 ? first : "conversion";
}

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

void require(fuzz::Agreement agreement, const std::string& what, std::span<const double> numbers,
             std::span<const double> result) {
    if (agreement == fuzz::Agreement::no) {
        differ(what + " does not agree with the definition", fmt::format("{}", fmt::join(result, " ")),
               fmt::format("what is right for {}", fmt::join(numbers, " ")));
    }
    reach.add(what + " that agrees", agreement == fuzz::Agreement::yes ? 1 : 0);
}

/// The answer of a comparison stands by the definitions.
void check(const fuzz::Compared& compared, std::span<const double> numbers, const fuzz::Answer& answer,
           fuzz::ComparedTurns& turns) {
    const std::span<const double> result = answer.numbers;
    require(check_refusal(compared, numbers, answer.failed, answer.of_reference), "refusal", numbers, result);
    if (answer.failed) {
        return;
    }
    if (compared.product) {
        require(check_product(compared, numbers, result.first(compared.product->size())), "product", numbers, result);
    } else if (compared.delta > 0) {
        require(turns.check_angle(compared, numbers, result[0]), "angle of turns", numbers, result);
    } else {
        require(check_angle(compared, numbers, result[0]), "angle", numbers, result);
    }
}

/// What compare's report says of the angles, and its verdict.
void check_report(const Result& result, const std::vector<std::string>& words) {
    std::vector<double> angles = result.angles;
    std::ranges::sort(angles, std::greater());
    const auto argument = [&words](std::string_view name) { return argument_of(words, name); };
    const auto is_met = [&angles](const std::string& word) {
        const std::string limit = word.starts_with("--within=") ? word.substr(word.find('=') + 1) : "";
        const std::size_t at = limit.find('@');
        const double percent = at == std::string::npos ? 100.0 : std::strtod(limit.c_str() + at + 1, nullptr);
        const auto within = std::ranges::count_if(
            angles, [most = std::strtod(limit.c_str(), nullptr)](double angle) { return angle <= most; });
        return limit.empty() || 100.0 * static_cast<double>(within) >= percent * static_cast<double>(angles.size());
    };
    const std::string allowed = argument("--allow-unpaired");
    const std::string least = argument("--min-pairs");
    const bool leaves_out = !allowed.empty() || has(words, "--allow-failed");
    const double needed =
        least.ends_with('%') || (least.empty() && leaves_out)
            ? std::strtod(least.empty() ? "50" : least.c_str(), nullptr) / 100.0 * static_cast<double>(result.rows)
            : std::strtod(least.c_str(), nullptr);
    const bool holds = !angles.empty() && std::ranges::all_of(words, is_met) &&
                       static_cast<double>(result.answered) >= needed &&
                       (result.unpaired[0] == 0 || allowed == "file" || allowed == "both") &&
                       (result.unpaired[2] == 0 || allowed == "reference" || allowed == "both") &&
                       (result.failed.empty() || has(words, "--allow-failed"));
    if (holds != result.holds) {
        differ("the verdict does not agree", result.conclusion, holds ? "pass" : "fail");
    }
    reach.add("verdict that agrees");
    if (argument("--format") == "json" || !(argument("--precision") + argument("--decimals")).empty()) {
        return;
    }
    const std::size_t worst =
        std::min<std::size_t>(std::strtoul(argument("--worst").c_str(), nullptr, 10), angles.size());
    for (std::size_t i = 0; i <= worst; ++i) {
        const std::string name = fmt::format("\n{:9} ", fmt::format("worst {}", i + 1));
        const std::size_t at = result.conclusion.find(name);
        const double shown =
            at == std::string::npos ? -1.0 : std::strtod(result.conclusion.c_str() + at + name.size(), nullptr);
        const double expected = i < worst ? std::strtod(fmt::format("{:.6g}", angles[i]).c_str(), nullptr) : -1.0;
        if (shown != expected) {
            differ("the worst pairs do not agree", result.conclusion, fmt::format("{}", fmt::join(angles, " ")));
        }
        reach.add("worst pair that agrees", i < worst ? 1 : 0);
    }
}

/// Of the unit of compare's angles: that of the first limit which has one, otherwise that of --degrees or of a SPEC.
double per_radian_of(const std::vector<std::string>& words) {
    const auto in_degrees = [&words](std::string_view option) {
        const auto spec = parse_spec(argument_of(words, option, "quat"));
        return std::get<Spec>(spec).unit == AngleUnit::degrees;
    };
    for (const std::string& word : words) {
        const auto has_unit = [&word](std::string_view unit) { return word.find(unit) != std::string::npos; };
        if (word.starts_with("--within=") && (has_unit("rad") || has_unit("deg") || has(words, "--degrees"))) {
            return has_unit("mrad") ? 1000.0 : has_unit("rad") ? 1.0 : degrees_per_radian;
        }
    }
    return has(words, "--degrees") || in_degrees("--from") || in_degrees("--to") ? degrees_per_radian : 1.0;
}

/// What --align promises: the sum of the squared sines of the half angles does not grow. With both sides it is looked
/// for, and may be missed, where noise is as large as the motion.
void check_alignment(const Result& result, const std::vector<std::string>& words) {
    const std::string side = argument_of(words, "--align");
    const double unit = 1.0 / per_radian_of(words);
    const auto sum_of = [unit](const std::vector<double>& angles) {
        double sum = 0.0;
        for (const double angle : angles) {
            const double sine = std::sin(0.5 * unit * angle);
            sum += sine * sine;
        }
        return sum;
    };
    if (result.aligned == nullptr || !result.to_the_end || result.angles.empty() || side == "both" ||
        !argument_of(words, "--delta").empty()) {
        return;
    }
    const bool is_right = result.angles.size() == result.angles_before.size() &&
                          (side == "first" ? result.angles[0] * unit <= 1e-12
                                           : sum_of(result.angles) <= sum_of(result.angles_before) + 1e-12);
    if (!is_right) {
        differ("the turn of --align does not align", fmt::format("{}", fmt::join(result.angles, " ")),
               fmt::format("less than {}", fmt::join(result.angles_before, " ")));
    }
    reach.add("alignment that agrees");
}

/// Rows of doubles are so many as were asked for, and each is an attitude.
void check_sample(const Result& result, const std::vector<std::string>& words, const Program& program) {
    const Spec spec = *program.operation().parts.front().attitude;
    if (argument_of(words, "--format") != "f64") {
        return;
    }
    std::vector<double> numbers(result.bytes.size() / sizeof(double));
    std::memcpy(numbers.data(), result.bytes.data(), numbers.size() * sizeof(double));
    std::vector<double> quaternions(numbers.size() / spec.size() * 4);
    std::vector<RowReport> reports;
    Conversion(spec, Spec{}, {.tolerance = any_defect}).run(numbers, quaternions, reports);
    const bool is_right =
        numbers.size() == spec.size() * std::strtoul(argument_of(words, "--rows", "1000").c_str(), nullptr, 10) &&
        std::ranges::all_of(reports, [](const RowReport& report) { return report.error == Error::none; });
    if (!is_right) {
        differ("a sample is not one of attitudes", fmt::format("{}", fmt::join(numbers, " ")), "");
    }
    reach.add("sample that agrees", numbers.size() / spec.size());
}

fuzz::Compared compared_of(const std::vector<std::string>& words, const Program& program) {
    const bool degrees = has(words, "--degrees");
    const bool composes = name_of_command(words) == "compose";
    const std::string to = argument_of(words, composes ? "--by" : "--to", argument_of(words, "--from"));
    const Spec reference = std::get<Spec>(parse_spec(to));
    return {.from = *program.options().input.numbers.attitude,
            .reference = degrees ? reference.in_degrees() : reference,
            .product = composes ? std::optional(*program.operation().parts.front().attitude) : std::nullopt,
            .per_radian = per_radian_of(words),
            .tolerance = std::strtod(argument_of(words, "--tolerance", "1e-3").c_str(), nullptr),
            .lock_margin = std::strtod(argument_of(words, "--lock-margin", "1e-15").c_str(), nullptr),
            .delta = std::strtoul(argument_of(words, "--delta", "0").c_str(), nullptr, 10),
            .turns =
                fuzz::turns_of(argument_of(words, "--left"), argument_of(words, "--right"),
                               argument_of(words, "--reference-axes"), argument_of(words, "--body-axes"), degrees)};
}

/// What the command makes of the numbers of one row alone.
fuzz::Calculate calculate_of(const Program& program, bool diagnostic_columns) {
    return [operation = std::make_shared<RowOperation>(program.operation()),
            kept = program.options().input.numbers.kept, columns = diagnostic_columns,
            other_key = program.is_by_key() ? program.options().input.numbers.names.size() : 0](
               const std::vector<double>& numbers, const std::vector<std::string>& texts) {
        fuzz::Answer answer{.numbers = std::vector<double>(operation->width()), .notes = {}};
        std::vector<double> others;
        std::vector<double> kept_numbers;
        std::vector<std::string_view> kept_texts;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (i < kept || (other_key > 0 && i == other_key)) { // the key of the reference
                kept_numbers.push_back(numbers[i]);
                kept_texts.emplace_back(texts[i]);
            } else {
                others.push_back(numbers[i]);
            }
        }
        const std::size_t line = 1;
        std::vector<RowReport> reports;
        operation->run({others, {&line, 1}, kept_numbers, kept_texts}, answer.numbers, reports);
        const RowReport report = reports.empty() ? RowReport{} : reports.front();
        answer.failed = report.error != Error::none;
        answer.of_reference = report.at_fault > 0;
        if (columns) {
            answer.numbers.insert(answer.numbers.end(), {report.sensitivity.margin, report.sensitivity.condition,
                                                         std::max(report.defect, report.references[0].defect)});
        }
        for (std::size_t i = 0; i < diagnostic_kind_count; ++i) {
            const auto kind = static_cast<DiagnosticKind>(i);
            if (!answer.failed && columns && report.diagnostics.has(kind) && answer.notes != name_of(kind)) {
                answer.notes += (answer.notes.empty() ? "" : "+") + std::string(name_of(kind));
            }
        }
        return answer;
    };
}

/// How a stream is read.
fuzz::Rules reading_rules_of(const std::vector<std::string>& words, const RowNumbers& numbers) {
    fuzz::Rules rules;
    rules.inputs = numbers.names.size();
    rules.numbers = numbers.names;
    rules.kept = numbers.kept;
    rules.columns = argument_of(words, "--columns");
    rules.comment = argument_of(words, "--comment", "#");
    rules.delimiter = argument_of(words, "--delimiter");
    rules.header = argument_of(words, "--header", "auto");
    rules.ragged = has(words, "--ragged");
    rules.on_error = argument_of(words, "--on-error", "stop");
    return rules;
}

void add_reference(fuzz::Rules& rules, const std::vector<std::string>& words, const Program& program) {
    fuzz::Rules reference = reading_rules_of(words, program.options().pairing->reference.numbers);
    reference.columns = argument_of(words, "--reference-columns", rules.columns);
    reference.header = rules.header == "add" ? "no" : rules.header;
    rules.by_key = program.is_by_key();
    reference.by_key = rules.by_key;
    if (rules.by_key) {
        const std::string key = argument_of(words, "--key");
        rules.key_within = argument_of(words, "--key-within");
        rules.key_offset = argument_of(words, "--key-offset");
        rules.columns = key + ',' + rules.columns;
        reference.columns = argument_of(words, "--reference-key", key) + ',' + reference.columns;
    }
    rules.reference = std::make_shared<fuzz::Rules>(std::move(reference));
}

/// What the model is to know: the options' words, and the command's numbers.
std::optional<fuzz::Rules> rules_of(const std::vector<std::string>& words, const Program& program) {
    const RowOperation& operation = program.operation();
    const std::string command = name_of_command(words);
    const bool compares = command == "compare";
    const bool composes = command == "compose";
    const bool sums_up = !program.options().writes_rows;
    const std::string format = sums_up ? "result" : argument_of(words, "--format", "csv");
    const std::string to = compares ? "" : argument_of(words, "--to");
    const int precision = std::atoi(argument_of(words, "--precision", "0").c_str());
    const bool fixed = !argument_of(words, "--decimals").empty();
    const bool is_euler = to.starts_with("euler") || to.starts_with("rpy");
    const bool waits = has(words, "--differences") || argument_of(words, "--interpolation") == "cubic";
    if ((format != "csv" && !sums_up) || program.options().input.width > 0 || program.has_text_alone() || waits ||
        ((precision > 0 || fixed) && is_euler)) {
        return std::nullopt; // other formats, rows that go nowhere, rows that wait, and -pi that rounds
    }
    // Nor are names that are kept, rows of a product that lack a partner, and a key beside columns that are not given.
    if ((command == "rotate" && argument_of(words, "--header", "auto") != "no") || (composes && program.is_paired()) ||
        (composes && operation.is_continuous()) || (program.is_by_key() && argument_of(words, "--columns").empty())) {
        return std::nullopt;
    }
    // Nor are references between two rows, and keys with units: pieces and threads must give the same, and a test of
    // the pairs looks at all rows. The options that an identification answers with are counted, and not tried.
    if (const auto& pairing = program.options().pairing;
        pairing && (pairing->interpolates || program.options().input.numbers.has_unit ||
                    pairing->reference.numbers.has_unit || pairing->reference.key_power != 0)) {
        return std::nullopt;
    }
    fuzz::Rules rules = reading_rules_of(words, program.options().input.numbers);
    rules.precision = precision;
    rules.decimals = fixed ? std::atoi(argument_of(words, "--decimals").c_str()) : -1;
    rules.names = operation.names();
    rules.format = format;
    rules.append = has(words, "--append") || compares;
    rules.diagnostic_columns = argument_of(words, "--diagnostics") == "columns" && !sums_up;
    if (rules.diagnostic_columns) {
        rules.names.insert(rules.names.end(), {"margin", "condition", "defect", "notes"});
    }
    if (program.is_paired()) {
        add_reference(rules, words, program);
    }
    rules.calculate = calculate_of(program, rules.diagnostic_columns);
    if (compares || composes) {
        fuzz::Compared compared = compared_of(words, program);
        if (program.command.first_pass) {
            compared.turns.reset(); // which only the program knows
        }
        rules.calculate = [compared, turns = std::make_shared<fuzz::ComparedTurns>(), calculate = rules.calculate,
                           by_key = program.is_by_key()](const std::vector<double>& numbers,
                                                         const std::vector<std::string>& texts) {
            auto bare = numbers;
            if (by_key) {
                bare.erase(bare.begin() + 1 + static_cast<std::ptrdiff_t>(compared.from.size()));
                bare.erase(bare.begin());
            }
            fuzz::Answer answer = calculate(numbers, texts);
            check(compared, bare, answer, *turns);
            return answer;
        };
    }
    return rules;
}

std::string description(const Result& result) {
    std::string text = result.bytes + "\nfailed:";
    for (const fuzz::Failure& failure : result.failed) {
        text += fmt::format(" {}{}", failure.line,
                            failure.of_reference ? " of the reference"
                            : failure.cause > 0  ? fmt::format(" by {}", failure.cause)
                                                 : "");
    }
    return text + fmt::format("\nto the end: {}, error: {}, answered: {}, unpaired: {}, notes: {}\n{}",
                              result.to_the_end, result.error, result.answered, fmt::join(result.unpaired, " "),
                              result.notes, result.conclusion);
}

void require_same(std::string_view what, const Result& a, const Result& b) {
    if (!(a == b)) {
        differ(what, description(a), description(b));
    }
}

void compare_with_model(const Input& input, const std::vector<std::string>& words, const Program& program,
                        Result result) {
    Program own = program.remembers() ? *program_of(words) : program;
    if (result.aligned != nullptr) {
        own.command.options.operation = result.aligned;
    }
    const auto rules = own.command.source || (own.command.first_pass && result.aligned == nullptr)
                           ? std::nullopt
                           : rules_of(words, own);
    auto outcome = !rules                ? std::nullopt
                   : program.is_paired() ? fuzz::model(input.text, input.reference, *rules)
                                         : fuzz::model(input.text, *rules);
    if (!outcome) {
        return;
    }
    Result right{
        .failed = std::move(outcome->failed), .to_the_end = outcome->to_the_end, .answered = outcome->answered};
    right.conclusion = result.conclusion; // which is checked by itself
    right.holds = result.holds;
    right.notes = result.notes; // nor are these modelled
    if (!program.options().writes_rows && !right.to_the_end) {
        outcome->bytes.clear();
    }
    right.bytes = std::move(outcome->bytes);
    for (std::size_t i = 0; i < 2 && right.to_the_end; ++i) {
        const auto& lines = outcome->unpaired.at(i);
        right.unpaired.at(2 * i) = lines.size();
        right.unpaired.at(2 * i + 1) = lines.empty() ? 0 : lines.front();
    }
    std::ranges::sort(right.failed); // those of the reference and of the stream come as they are read
    std::ranges::sort(result.failed);
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
    if (program->reports && whole.to_the_end && whole.answered > 0 && whole.error.empty()) {
        check_report(whole, words);
        check_alignment(whole, words);
    }
    if (program->command.source) {
        check_sample(whole, words, *program);
    } else if (!argument_of(words, "--threads").empty() && !first.empty()) {
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
