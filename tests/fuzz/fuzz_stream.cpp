// The first line is the program's command line, its words parted by blanks, the rest a stream: any bytes. Never a
// crash; the bytes arrive whole and in pieces, and are converted by one thread and by many, and must become the same;
// and this must be what a second implementation of the row rules says.

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include <rotconv/survey.hpp>

#include "command_text.hpp"
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
        "rows failed in conversion", "rows failed in rates", "rows failed in propagate", "rows failed in survey",
        "rows failed under --on-error=stop", "rows failed under --on-error=nan", "rows failed under --on-error=skip",
        "rows converted under --format=csv", "rows converted under --format=json", "rows converted under --format=pretty",
        "rows converted under --format=f64", "rows converted under --input-format=f64",
        "rows converted under --header=auto", "rows converted under --header=yes", "rows converted under --header=no",
        "rows converted under --header=add",
        "rows converted under --columns of indices", "rows converted under --columns in another order",
        "rows converted under --columns of names", "rows converted without --columns", "rows converted under --append",
        "rows converted under --continuous", "rows converted under --left", "rows converted under --right",
        "rows converted under --diagnostics=columns", "rows converted under --precision",
        "runs of which many threads had a part",
        "row compared", "failed row under stop", "failed row under nan", "failed row under skip", "header", "added header",
        "blank row", "comment", "row before the header", "byte order mark", "CRLF", "last row without newline", "missing field", "quoted number",
        "detected delimiter comma", "detected delimiter tab", "detected delimiter semicolon", "detected delimiter blank",
        "given delimiter comma", "given delimiter tab", "given delimiter semicolon", "given delimiter blank",
        "given delimiter character",
    // clang-format on
};

/// The text, `times` over, in pieces. Remembers which threads read it.
class Pieces final : public Source {
public:
    Pieces(std::string_view text, std::size_t piece, std::size_t times) : text_(text), piece_(piece), times_(times) {}
    std::ptrdiff_t read(std::span<char> to) override {
        threads_.insert(std::this_thread::get_id());
        std::size_t done = 0;
        const std::size_t most = std::min(piece_, to.size());
        while (done < most && times_ > 0 && !text_.empty()) {
            const std::size_t count = std::min(most - done, text_.size() - at_);
            std::copy_n(text_.data() + at_, count, to.data() + done);
            done += count;
            at_ += count;
            if (at_ == text_.size()) {
                at_ = 0;
                --times_;
            }
        }
        return static_cast<std::ptrdiff_t>(done);
    }
    [[nodiscard]] std::size_t threads() const { return threads_.size(); }

private:
    std::string_view text_;
    std::size_t piece_;
    std::size_t times_;
    std::size_t at_ = 0;
    std::set<std::thread::id> threads_;
};

class Text final : public Sink {
public:
    int write(std::string_view bytes) override {
        text += bytes;
        return 0;
    }
    std::string text;
};

struct Result {
    std::string bytes;
    std::vector<std::size_t> failed; ///< lines
    bool to_the_end = false;
    std::size_t converted = 0;
    std::size_t threads = 0;
    friend bool operator==(const Result& a, const Result& b) {
        return a.bytes == b.bytes && a.failed == b.failed && a.to_the_end == b.to_the_end;
    }
};

bool remembers(const Options& options) { return options.operation.in_order || options.operation.choose; }

/// The command's options. A function that takes rows in their order remembers them: it serves one run.
std::optional<Options> options_of(const std::vector<std::string>& words, Survey& survey) {
    auto command = fuzz::command_of(words);
    if (auto* of_survey = std::get_if<cli::SurveyCommand>(&command)) {
        of_survey->rows.options.operation =
            reading_operation(of_survey->from, of_survey->rows.subject.tolerance,
                              [&survey](const Rotation& rotation, std::size_t line) { survey.add(rotation, line); });
        return of_survey->rows.options;
    }
    const auto* rows = std::get_if<cli::RowsCommand>(&command);
    return rows == nullptr || rows->has_values ? std::nullopt : std::optional(rows->options);
}

/// The same, for a look at it: to read a command line takes longer than a run.
const std::optional<Options>& known_options_of(const std::string& line, const std::vector<std::string>& words) {
    static std::map<std::string, std::optional<Options>> known;
    if (known.size() > 1000) {
        known.clear();
    }
    const auto [at, is_new] = known.try_emplace(line);
    if (is_new && !words.empty()) {
        static Survey nobodys;
        at->second = options_of(words, nobodys);
    }
    return at->second;
}

/// A stream, and how it is to be read.
struct Input {
    std::string_view text;
    std::size_t piece = static_cast<std::size_t>(-1);
    std::size_t times = 1;
};

Result run_once(const Input& input, const std::vector<std::string>& words, const Options& given, std::size_t threads) {
    Survey survey;
    Options options = remembers(given) ? *options_of(words, survey) : given;
    options.threads = threads;
    std::atomic<std::size_t> converted = 0;
    const auto count = [&converted](std::size_t answered, const std::vector<Report>& reports) {
        const auto failed = std::ranges::count_if(reports, [](const Report& r) { return r.error != Error::none; });
        converted += answered - static_cast<std::size_t>(failed);
    };
    options.operation.run = [run = options.operation.run, count](const NumberRows& rows, std::span<double> out,
                                                                 std::vector<Report>& reports) {
        run(rows, out, reports);
        count(rows.lines.size(), reports);
    };
    if (options.operation.run_ahead) {
        options.operation.run_ahead = [run = options.operation.run_ahead, count](const NumberRows& rows, bool flush,
                                                                                 std::span<double> out,
                                                                                 std::vector<Report>& reports) {
            const std::size_t answered = run(rows, flush, out, reports);
            count(answered, reports);
            return answered;
        };
    }
    Pieces source(input.text, input.piece, input.times);
    Text sink;
    Result result;
    const RunResult ending = run(source, sink, options, [&result](const Event& event) {
        if (const auto* error = std::get_if<RowError>(&event)) {
            result.failed.push_back(error->line);
        }
    });
    result.bytes = std::move(sink.text);
    result.to_the_end = !ending.stopped && !ending.error;
    result.converted = converted;
    result.threads = source.threads();
    static_cast<void>(survey.smallest(1e3));
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
    return first == "rates" || first == "propagate" || first == "survey" ? first : "conversion";
}

void count_reach(const Result& result, const std::vector<std::string>& words) {
    const std::string command = name_of_command(words);
    const std::size_t rows = result.converted;
    reach.add("rows converted by " + command, rows);
    reach.add("rows failed in " + command, result.failed.size());
    reach.add("rows failed under --on-error=" + argument_of(words, "--on-error", "stop"), result.failed.size());
    if (command != "survey") { // whose rows go nowhere
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
    add_where(argument_of(words, "--input-format") == "f64", "rows converted under --input-format=f64");
    add_where(has(words, "--append"), "rows converted under --append");
    add_where(has(words, "--continuous"), "rows converted under --continuous");
    add_where(!argument_of(words, "--left").empty(), "rows converted under --left");
    add_where(!argument_of(words, "--right").empty(), "rows converted under --right");
    add_where(argument_of(words, "--diagnostics") == "columns", "rows converted under --diagnostics=columns");
    add_where(!argument_of(words, "--precision").empty(), "rows converted under --precision");
}

/// What the model is to know: the options' words, and the command's numbers.
std::optional<fuzz::Rules> rules_of(const std::vector<std::string>& words, const Options& options) {
    const std::string format = argument_of(words, "--format", "csv");
    const std::string to = argument_of(words, "--to");
    fuzz::Rules rules;
    rules.precision = std::atoi(argument_of(words, "--precision", "0").c_str());
    const bool is_euler = to.starts_with("euler") || to.starts_with("rpy");
    if ((format != "csv" && format != "json") || options.width > 0 || name_of_command(words) == "survey" ||
        argument_of(words, "--interpolation") == "cubic" || (rules.precision > 0 && is_euler)) {
        return std::nullopt; // pretty and f64, rows that wait, and -pi that rounds
    }
    rules.inputs = options.operation.inputs;
    rules.kept = options.operation.kept;
    rules.names = options.operation.names;
    rules.columns = argument_of(words, "--columns");
    rules.delimiter = argument_of(words, "--delimiter");
    rules.header = argument_of(words, "--header", "auto");
    rules.format = format;
    rules.on_error = argument_of(words, "--on-error", "stop");
    rules.append = has(words, "--append");
    rules.diagnostic_columns = argument_of(words, "--diagnostics") == "columns";
    if (rules.diagnostic_columns) {
        rules.names.insert(rules.names.end(), {"margin", "condition", "defect", "notes"});
    }
    rules.input_names = options.operation.input_names;
    rules.calculate = [run = options.operation.run, choose = options.operation.choose, kept = rules.kept,
                       columns = rules.diagnostic_columns, size = options.operation.names.size()](
                          const std::vector<double>& numbers,
                          const std::vector<std::string>& texts) -> std::optional<fuzz::Answer> {
        fuzz::Answer answer{std::vector<double>(size), ""};
        const std::vector<std::string_view> kept_texts(texts.begin(),
                                                       texts.begin() + static_cast<std::ptrdiff_t>(kept));
        const std::size_t line = 1;
        std::vector<Report> reports;
        run({numbers, {&line, 1}, kept_texts}, answer.numbers, reports);
        if (choose) {
            choose(answer.numbers, reports);
        }
        const Report report = reports.empty() ? Report{} : reports.front();
        if (report.error != Error::none) {
            return std::nullopt;
        }
        if (columns) {
            answer.numbers.insert(answer.numbers.end(),
                                  {report.sensitivity.margin, report.sensitivity.condition, report.defect});
        }
        for (std::size_t i = 0; i < diagnostic_kind_count; ++i) {
            if (const auto kind = static_cast<DiagnosticKind>(i); report.diagnostics.has(kind)) {
                answer.notes += (answer.notes.empty() ? "" : "+") + std::string(name_of(kind));
            }
        }
        return answer;
    };
    return rules;
}

[[noreturn]] void differ(std::string_view what, std::string_view a, std::string_view b) {
    std::fprintf(stderr, "%.*s\n--- the program:\n%.*s\n--- it should be:\n%.*s\n---\n", static_cast<int>(what.size()),
                 what.data(), static_cast<int>(a.size()), a.data(), static_cast<int>(b.size()), b.data());
    std::abort();
}

void require_same(std::string_view what, const Result& a, const Result& b) {
    if (!(a == b)) {
        differ(what, a.bytes, b.bytes);
    }
}

void compare_with_model(std::string_view text, const std::vector<std::string>& words, const Options& options,
                        const Result& result) {
    Survey survey;
    const auto rules = rules_of(words, remembers(options) ? *options_of(words, survey) : options);
    const auto outcome = rules ? fuzz::model(text, *rules) : std::nullopt;
    if (!outcome) {
        return;
    }
    const bool same =
        rules->format == "json" ? fuzz::json_agrees(result.bytes, *outcome, *rules) : result.bytes == outcome->bytes;
    if (!same || result.failed != outcome->failed || result.to_the_end != outcome->to_the_end) {
        differ("the rules of rows say otherwise", result.bytes, outcome->bytes);
    }
    std::ranges::for_each(outcome->met, [](const std::string& rule) { reach.add(rule); });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view all(reinterpret_cast<const char*>(data), size);
    const std::string_view line = all.substr(0, all.find('\n'));
    const std::string_view text = all.substr(std::min(line.size() + 1, size));
    const auto words = words_of(line, ' ');
    const auto& options = known_options_of(std::string(line), words);
    if (!options) {
        return 0;
    }
    const Result whole = run_once({text}, words, *options, 1);
    count_reach(whole, words);
    require_same("in pieces", run_once({text, 1 + size % 16}, words, *options, 1), whole);
    compare_with_model(text, words, *options, whole);
    if (!argument_of(words, "--threads").empty() && !text.empty()) {
        // many times over, so that it is worth threads
        constexpr std::size_t enough = std::size_t{24} << 10U;
        const std::size_t times = 1 + enough / text.size();
        const Result many = run_once({.text = text, .times = times}, words, *options, options->threads);
        require_same("with threads", many, run_once({.text = text, .times = times}, words, *options, 1));
        reach.add("runs of which many threads had a part", many.threads > 1 ? 1 : 0);
    }
    return 0;
}

namespace {

constexpr std::array option_words{"--from=quat",
                                  "--from=quat:xyzw",
                                  "--from=dcm",
                                  "--from=dcm:col:passive",
                                  "--from=6d",
                                  "--from=5d",
                                  "--from=rotvec:deg",
                                  "--from=axis-angle",
                                  "--from=euler:ZYX:deg",
                                  "--from=rpy",
                                  "--from=cayley",
                                  "--from=mrp",
                                  "--to=quat",
                                  "--to=dcm:col",
                                  "--to=6d",
                                  "--to=5d",
                                  "--to=euler:zxz:deg",
                                  "--to=rotvec",
                                  "--to=axis-angle:passive",
                                  "--to=cayley",
                                  "--to=mrp",
                                  "--to=rpy",
                                  "--header=auto",
                                  "--header=yes",
                                  "--header=no",
                                  "--header=add",
                                  "--format=csv",
                                  "--format=json",
                                  "--format=pretty",
                                  "--format=f64",
                                  "--on-error=stop",
                                  "--on-error=nan",
                                  "--on-error=skip",
                                  "--columns=2-5",
                                  "--columns=4,3,2,1",
                                  "--columns=a,b,c,d",
                                  "--columns=qw,qx,qy,qz",
                                  "--columns=x,2-4",
                                  "--columns=2-4",
                                  "--columns=3,1,2",
                                  "--columns=a,b,c",
                                  "--columns=2-10",
                                  "--columns=1,3-7",
                                  "--columns=3-8",
                                  "--columns=t,wx,wy,wz",
                                  "--columns=1-7",
                                  "--delimiter=comma",
                                  "--delimiter=tab",
                                  "--delimiter=semicolon",
                                  "--delimiter=blank",
                                  "--delimiter=|",
                                  "--append",
                                  "--strict",
                                  "--degrees",
                                  "--precision=6",
                                  "--precision=17",
                                  "--threads=16",

                                  "--input-format=f64",
                                  "--width=4",
                                  "--width=6",
                                  "--width=10",
                                  "--tolerance=inf",
                                  "--tolerance=0",
                                  "--lock-margin=0.01",
                                  "--diagnostics=columns",
                                  "--diagnostics=off",
                                  "--diagnostics=rows",
                                  "--inverse",
                                  "--frame=reference",
                                  "--with=rpy",
                                  "--with=mrp",
                                  "--integrator=rk4",
                                  "--integrator=magnus6",
                                  "--substeps=3",
                                  "--interpolation=cubic",
                                  "--renormalise",
                                  "--initial=quat:0,1,0,0",
                                  "--continuous",
                                  "--left=quat:0,1,0,0",
                                  "--right=rpy:deg:0,90,30",
                                  "--time-unit=ns",
                                  "--condition=10",
                                  "--method=shepperd"};

/// Another option, in the place of the same with another argument; the line as it was where none of a few is legal.
std::string with_another_option(const std::string& line, unsigned seed) {
    for (int attempt = 0; attempt < 4; ++attempt) {
        seed = seed * 1664525U + 1013904223U;
        const std::string option = option_words[(seed >> 8U) % option_words.size()];
        auto words = words_of(line, ' ');
        const std::string name = option.substr(0, option.find('='));
        const bool removes = (seed >> 4U) % 3 == 0;
        std::erase_if(words, [&name](const std::string& word) { return word.substr(0, word.find('=')) == name; });
        if (!removes) {
            words.push_back(option);
        }
        std::string text;
        for (const std::string& word : words) {
            text += (text.empty() ? "" : " ") + word;
        }
        if (known_options_of(text, words)) {
            return text;
        }
    }
    return line;
}

std::size_t put(std::string_view line, std::string_view text, std::uint8_t* to, std::size_t most) {
    const std::string all = std::string(line) + '\n' + std::string(text);
    const std::size_t size = std::min(all.size(), most);
    std::memcpy(to, all.data(), size);
    return size;
}

} // namespace

/// Mutates the stream and leaves the command line legal.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    const std::string all(reinterpret_cast<const char*>(data), size);
    const std::string line = all.substr(0, all.find('\n'));
    std::string text = all.substr(std::min(line.size() + 1, size));
    if (seed % 4 == 0) {
        return put(with_another_option(line, seed), text, data, most);
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
