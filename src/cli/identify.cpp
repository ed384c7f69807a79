#include "identify.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "../stream/fmt.hpp"
#include "messages.hpp"
#include "pairing.hpp"
#include "print_error.hpp"
#include "rows.hpp"

namespace rotconv::cli {
namespace {

constexpr std::size_t listed = 10;

std::string name_of(const Spec& spec) { return std::string(representation(spec.name).text); }

/// What the rows are.
messages::Subject subject_of(const stream::IdentificationRows& rows, double tolerance) {
    if (rows.paired) {
        return {fmt::format("{} unknown numbers", rows.count), rows.count, rows.known.name, tolerance};
    }
    const std::string unknown = rows.count == 0 ? "" : fmt::format("{} unknown numbers with ", rows.count);
    return {unknown + name_of(rows.known), rows.count + rows.known.size(), rows.known.name, tolerance};
}

/// Of so many numbers those that are not the known attitude's; 0 and why, where no representation has so many.
std::pair<std::size_t, std::string> unknown_of(std::size_t all, const stream::IdentificationRows& rows) {
    const std::size_t count = rows.paired ? all : all - std::min(all, rows.known.size());
    if (Identification::is_count(count)) {
        return {count, {}};
    }
    std::vector<std::size_t> legal;
    for (std::size_t i = 1; i <= 9; ++i) {
        if (Identification::is_count(i)) {
            legal.push_back(i);
        }
    }
    const std::string known =
        rows.paired ? "" : fmt::format(" where {} has {}", name_of(rows.known), rows.known.size());
    return {0, fmt::format("{} number{}{}: {} unknown (legal: {})", all, all == 1 ? "" : "s", known, count,
                           fmt::join(legal, " "))};
}

std::size_t count_fields(std::string_view row, std::optional<stream::Delimiter> delimiter) {
    std::vector<std::string_view> fields;
    delimiter.value_or(stream::Delimiter::of_row(row)).split(row, fields);
    return fields.size();
}

/// The unknown numbers of a row, where the command line tells how many there are; else 0.
std::size_t count_of(const RawOptions& texts, const Operands& operands, const stream::IdentificationRows& rows,
                     const std::optional<RepresentationId>& name) {
    if (name) {
        return representation(*name).size;
    }
    std::size_t all = 0;
    if (!texts.columns.empty()) {
        const auto parsed = stream::ColumnList::parse(texts.columns, 0);
        const auto* error = std::get_if<stream::ColumnError>(&parsed);
        if (error == nullptr || error->what != stream::ColumnError::What::wrong_count) {
            return 0; // a list that is refused
        }
        all = error->count;
    } else if (operands.values.size() > 1) {
        all = count_fields(fmt::format("{}", fmt::join(operands.values, " ")), stream::Delimiter::blanks());
    } else if (!operands.values.empty()) {
        all = count_fields(operands.values[0], stream::Delimiter::parse(texts.delimiter));
    } else if (texts.input_format == "f64") {
        if (texts.width.empty()) {
            throw Usage("f64 rows do not tell how many numbers they have; --width, --columns or --from does");
        }
        all = static_cast<std::size_t>(cli::count_of("--width", texts.width, 1000));
    } else {
        return 0;
    }
    const auto [count, wrong] = unknown_of(all, rows);
    if (!wrong.empty()) {
        throw Usage(wrong);
    }
    return count;
}

std::optional<RepresentationId> name_of(const std::string& text) {
    if (text.empty()) {
        return std::nullopt;
    }
    const Representation* found = find_representation(text);
    if (found == nullptr) {
        const SpecError error{SpecError::What::unknown_name, text};
        throw Usage(fmt::format("--from takes a name alone, all its modifiers and sequences are tried: {}",
                                messages::explain(error)));
    }
    return found->name;
}

/// Indices from 1 as --columns takes them: three or more in a row as a range.
std::string list_of(const std::vector<std::size_t>& columns) {
    std::string text;
    for (std::size_t i = 0; i < columns.size();) {
        std::size_t end = i + 1;
        while (end < columns.size() && columns[end] == columns[end - 1] + 1) {
            ++end;
        }
        text += text.empty() ? "" : ",";
        if (end - i > 2) {
            text += fmt::format("{}-{}", columns[i], columns[end - 1]);
            i = end;
        } else {
            text += std::to_string(columns[i++]);
        }
    }
    return text;
}

/// What has come out, as text.
class Answer {
public:
    Answer(const Identification& identification, const std::vector<std::size_t>& positions, bool degrees)
        : identification_(&identification), positions_(&positions), candidates_(identification.best_first()),
          verdict_(identification.verdict()), unit_(degrees ? degrees_per_radian : 1.0),
          unit_name_(degrees ? "degrees" : "rad") {
        candidates_.resize(std::min(candidates_.size(), listed));
    }

    [[nodiscard]] bool is_one() const noexcept { return verdict_.fitting == 1; }

    [[nodiscard]] std::string in_table(double within) const {
        std::string text = fmt::format("{:<22}  {:<9}  {:>11}  {:>7}  {:>7}  {}\n", "SPEC", "columns", "worst angle",
                                       "at line", "rows", "fits");
        for (const Candidate& candidate : candidates_) {
            text += fmt::format("{:<22}  {:<9}  {:>11}  {:>7}  {:>7}  {}\n", messages::text_of(candidate.spec),
                                columns_of(candidate), angle_text(candidate), candidate.angle_row, candidate.rows,
                                identification_->fits(candidate) ? "yes" : "no");
        }
        const std::size_t rows = identification_->rows();
        return fmt::format("{}\n{} row{}; the convention that fits within {:.6g} {}:\n{}{}\n", text, rows,
                           rows == 1 ? "" : "s", within * unit_, unit_name_, word(),
                           verdict_.fitting > 1 ? fmt::format(": {} fit; {}", verdict_.fitting, lack()) : "");
    }

    [[nodiscard]] std::string in_json() const {
        std::string text;
        for (const Candidate& candidate : candidates_) {
            text += fmt::format(
                R"({{"spec": "{}", "columns": "{}", "angle": {}, "angle_line": {}, "rows": {}, "fits": {}}})"
                "\n",
                messages::text_of(candidate.spec), columns_of(candidate),
                std::isinf(candidate.angle) ? "null" : fmt::format("{}", candidate.angle * unit_), candidate.angle_row,
                candidate.rows, identification_->fits(candidate));
        }
        const std::string lacking = verdict_.fitting > 1 ? fmt::format(R"(, "lack": "{}")", lack()) : "";
        return fmt::format(R"({}{{"rows": {}, "fit": {}, "answer": "{}"{}}})"
                           "\n",
                           text, identification_->rows(), verdict_.fitting, word(), lacking);
    }

private:
    /// The options that read the numbers, or why there are none.
    [[nodiscard]] std::string word() const {
        if (!is_one()) {
            return verdict_.fitting > 1 ? "ambiguous" : "none";
        }
        const Candidate& best = candidates_.front();
        return fmt::format("-f {} --columns {}", messages::text_of(best.spec), columns_of(best));
    }

    /// What the rows lack.
    [[nodiscard]] std::string lack() const {
        using Ambiguity = Verdict::Ambiguity;
        switch (verdict_.lack) {
        case Ambiguity::rows: return "there is one row";
        case Ambiguity::attitudes: return "all rows have the same attitude";
        case Ambiguity::size:
            return fmt::format("all are small, at most {:.3g} {}", verdict_.angle * unit_, unit_name_);
        case Ambiguity::axes:
            return fmt::format("all turn about one axis, ({:.3g}, {:.3g}, {:.3g})", verdict_.axis[0] + 0.0,
                               verdict_.axis[1] + 0.0, verdict_.axis[2] + 0.0);
        case Ambiguity::zero: return fmt::format("the number in column {} is always 0", column(verdict_.column));
        case Ambiguity::equal:
            return fmt::format("the numbers in columns {} and {} are always equal", column(verdict_.column),
                               column(verdict_.other));
        case Ambiguity::difference: return "these rows do not tell them apart";
        case Ambiguity::nothing: break;
        }
        return {};
    }

    /// The index from 1 of an unknown number.
    [[nodiscard]] std::size_t column(std::size_t number) const {
        return (positions_->empty() ? number : positions_->at(number)) + 1;
    }

    [[nodiscard]] std::string columns_of(const Candidate& candidate) const {
        std::vector<std::size_t> columns;
        for (std::size_t i = 0; i < candidate.spec.size(); ++i) {
            columns.push_back(column(candidate.columns.at(i)));
        }
        return list_of(columns);
    }

    [[nodiscard]] std::string angle_text(const Candidate& candidate) const {
        return std::isinf(candidate.angle) ? "no attitude" : fmt::format("{:.6g}", candidate.angle * unit_);
    }

    const Identification* identification_;
    const std::vector<std::size_t>* positions_;
    std::vector<Candidate> candidates_; ///< the best
    Verdict verdict_;
    double unit_;
    std::string_view unit_name_;
};

} // namespace

void define_identify(CLI::App& app, RawOptions& texts) {
    begin_group(app, "What");
    app.add_option("-t,--to", texts.to, "The representation of the known attitudes: NAME[:MODIFIER]...")
        ->type_name("KNOWN");
    app.add_option("-f,--from", texts.from, "Try only this representation for the unknown numbers")->type_name("NAME");
    app.add_option("--within", texts.within, "The largest angle that fits (default 1e-3 rad; with -d in degrees)")
        ->type_name("ANGLE");
    define_pairing(app, texts);
    define_input(app, texts);
    begin_group(app, "Output");
    app.add_option("--format", texts.format, "pretty (default), a table, or json")->type_name("FORMAT");
}

IdentifyCommand identify_command(const RawOptions& texts, const Operands& operands) {
    const auto name = name_of(texts.from);
    stream::IdentificationRows layout{.known = spec_of("--to", texts.to, texts.degrees), .paired = is_paired(operands)};
    layout.by_key = layout.paired && !texts.key.empty();
    layout.count = count_of(file_options(texts, layout.paired), operands, layout, name);
    IdentificationSettings settings{.tolerance = settings_of(texts).tolerance};
    if (!texts.within.empty()) {
        const double unit = texts.degrees ? radians_per_degree : 1.0;
        settings.within = amount_of("--within", texts.within, 0.0, false) * unit;
    }
    RawOptions input = file_options(texts, layout.paired);
    input.format.clear(); // that of the answer
    IdentifyCommand command{.rows = rows_command(input, stream::identification_operation(layout, nullptr),
                                                 subject_of(layout, settings.tolerance), operands),
                            .layout = layout,
                            .name = name,
                            .settings = settings,
                            .degrees = texts.degrees,
                            .json = choose<bool>("format of identify", texts.format.empty() ? "pretty" : texts.format,
                                                 {{"pretty", false}, {"json", true}})};
    if (layout.paired) {
        pair(command.rows, texts, operands, stream::reference_operation(layout.known, layout.by_key),
             messages::subject_of(layout.known, settings.tolerance));
    }
    return command;
}

ExitCode identify(const IdentifyCommand& command) {
    std::optional<Identification> identification;
    std::vector<std::size_t> positions;
    const auto begin = [&](std::size_t count, RowsCommand& rows) {
        stream::IdentificationRows layout = command.layout;
        layout.count = count;
        identification.emplace(count, layout.known, command.name, command.settings);
        rows.options.operation = stream::identification_operation(layout, &*identification);
        rows.options.operation.selected = [&positions, layout](const auto& selected) {
            positions.assign(selected.begin() + (layout.by_key ? 1 : 0), selected.end());
        };
        rows.subject = subject_of(layout, command.settings.tolerance);
    };
    const auto begin_with = [&](std::string_view first_row, RowsCommand& rows) -> std::string {
        if (first_row.empty() || first_row.starts_with('{') || first_row.starts_with('[')) {
            return {}; // the reader says so
        }
        const auto [count, wrong] = unknown_of(count_fields(first_row, rows.options.delimiter), command.layout);
        if (wrong.empty()) {
            begin(count, rows);
            return {};
        }
        return fmt::format("{}: {}", wrong, messages::quoted(first_row));
    };
    RowsCommand rows = command.rows;
    begin(command.layout.count, rows);
    bool is_one = false;
    const auto conclude = [&](const RowsResult& /*result*/) {
        const Answer answer(*identification, positions, command.degrees);
        is_one = answer.is_one();
        if (identification->rows() == 0) {
            print_error(messages::nothing_read);
            return std::string(command.json ? "{\"rows\": 0, \"fit\": 0, \"answer\": \"none\"}\n" : "none\n");
        }
        return command.json ? answer.in_json() : answer.in_table(command.settings.within);
    };
    stream::NullSink nowhere;
    const RowsResult result =
        run_rows(rows, Conclusion{nowhere, conclude}, command.layout.count == 0 ? Settle(begin_with) : Settle());
    return result.code == ExitCode::done && !result.reader_left && !is_one ? ExitCode::reservations : result.code;
}

} // namespace rotconv::cli
