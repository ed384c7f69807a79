#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/identification.hpp>

#include "../stream/fmt.hpp"
#include "commands.hpp"
#include "options.hpp"
#include "print_error.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

constexpr std::size_t listed = 10;

std::string name_of(const Spec& spec) { return std::string(representation(spec.name).text); }

/// What the rows are.
messages::Subject subject_of(const operations::IdentificationRows& rows, double tolerance) {
    const std::string unknown = fmt::format("{} unknown numbers", rows.count);
    if (rows.paired) {
        return {unknown, rows.count, rows.known.name, tolerance};
    }
    return {(rows.count == 0 ? "" : unknown + " with ") + name_of(rows.known), rows.count + rows.known.size(),
            rows.known.name, tolerance};
}

/// Of so many numbers those that are not the known attitude's, or why no representation has so many.
std::variant<std::size_t, std::string> unknown_of(std::size_t all, const operations::IdentificationRows& rows) {
    const std::size_t count = rows.paired ? all : all - std::min(all, rows.known.size());
    if (Identification::is_count(count)) {
        return count;
    }
    std::vector<std::size_t> legal;
    for (std::size_t i = 1; i <= 9; ++i) {
        if (Identification::is_count(i)) {
            legal.push_back(i);
        }
    }
    const std::string known =
        rows.paired ? "" : fmt::format(" where {} has {}", name_of(rows.known), rows.known.size());
    return fmt::format("{}{}: {} unknown (legal: {})", counted(all, "number"), known, count, fmt::join(legal, " "));
}

std::optional<RepresentationId> name_of(const std::string& text) {
    if (text.empty()) {
        return std::nullopt;
    }
    const Representation* found = find_representation(text);
    if (found != nullptr) {
        return found->name;
    }
    const auto spec = parse_spec(text);
    if (std::holds_alternative<Spec>(spec)) {
        throw Usage(fmt::format("--from {}: all sequences and modifiers are tried, so that a name alone is given: {}",
                                quoted(text), name_of(std::get<Spec>(spec))));
    }
    throw Usage(fmt::format("--from takes a name alone, all its modifiers and sequences are tried: {}",
                            messages::explain(SpecError{SpecError::What::unknown_name, text})));
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
            text += fmt::format("{:<22}  {:<9}  {:>11}  {:>7}  {:>7}  {}\n", candidate.spec.text(),
                                columns_of(candidate), angle_text(candidate), candidate.angle_row, candidate.rows,
                                identification_->fits(candidate) ? "yes" : "no");
        }
        return fmt::format("{}\n{}; the convention that fits within {:.6g} {}:\n{}{}\n", text,
                           counted(identification_->rows(), "row"), within * unit_, unit_name_, word(),
                           verdict_.fitting > 1 ? fmt::format(": {} fit; {}", verdict_.fitting, lack()) : "");
    }

    [[nodiscard]] std::string in_json() const {
        std::string text;
        for (const Candidate& candidate : candidates_) {
            text += fmt::format(
                R"({{"spec": "{}", "columns": "{}", "angle": {}, "angle_line": {}, "rows": {}, "fits": {}}})"
                "\n",
                candidate.spec.text(), columns_of(candidate),
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
        return fmt::format("-f {} --columns {}", best.spec.text(), columns_of(best));
    }

    /// What the rows lack.
    [[nodiscard]] std::string lack() const {
        using Ambiguity = Verdict::Ambiguity;
        switch (verdict_.ambiguity) {
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

class IdentificationConclusion final : public Conclusion {
public:
    struct Settings {
        operations::IdentificationRows rows{};  ///< their count is 0 where the first row tells it
        std::optional<RepresentationId> name{}; ///< the only one that is tried
        IdentificationSettings identification{};
        bool degrees = false; ///< the angles of the answer
        bool json = false;
    };

    IdentificationConclusion(const Settings& settings, std::shared_ptr<messages::Subject> subject)
        : settings_(settings), subject_(std::move(subject)) {
        begin(settings.rows.count);
    }

    void begin(std::size_t count) {
        settings_.rows.count = count;
        identification_.emplace(count, settings_.rows.known, settings_.name, settings_.identification);
        *subject_ = subject_of(settings_.rows, settings_.identification.tolerance);
    }

    /// See stream::InputOptions::take_count.
    [[nodiscard]] std::variant<std::size_t, std::string> take_count(std::size_t fields) {
        auto count = unknown_of(fields, settings_.rows);
        if (const auto* unknown = std::get_if<std::size_t>(&count)) {
            begin(*unknown);
            return fields;
        }
        return count;
    }

    [[nodiscard]] Identification& identification() noexcept { return *identification_; }
    [[nodiscard]] std::vector<std::size_t>& positions() noexcept { return positions_; }
    [[nodiscard]] stream::Sink* rows() override { return &nowhere_; }

    [[nodiscard]] std::string text(const RowsResult& /*result*/) override {
        if (identification_->rows() == 0) {
            print_error(messages::nothing_read);
            return settings_.json ? "{\"rows\": 0, \"fit\": 0, \"answer\": \"none\"}\n" : "none\n";
        }
        const Answer answer(*identification_, positions_, settings_.degrees);
        is_one_ = answer.is_one();
        return settings_.json ? answer.in_json() : answer.in_table(settings_.identification.within);
    }

    [[nodiscard]] bool holds(const RowsResult& /*result*/) const override { return is_one_; }

private:
    Settings settings_;
    std::shared_ptr<messages::Subject> subject_; ///< of the rows
    std::optional<Identification> identification_;
    std::vector<std::size_t> positions_;
    bool is_one_ = false;
    stream::NullSink nowhere_;
};

class IdentifyOptions final : public CommandOptions {
public:
    IdentifyOptions() {
        set.begin_group("What");
        set.add("-t,--to", to_, "KNOWN", "The representation of the known attitudes: NAME[:MODIFIER]...");
        set.add("-f,--from", from_, "NAME", "Try only this representation for the unknown numbers");
        set.add("--within", within_, "ANGLE", "The largest angle that fits (default 1e-3 rad; with -d in degrees)");
        pairing_.add_to(set);
        reading_.add_to(set);
        set.begin_group("Output");
        set.add("--format", format_, "FORMAT", "pretty (default), a table, or json");
    }

    [[nodiscard]] std::string input() const override { return reading_.input; }

    [[nodiscard]] Command command(const Operands& operands) const override {
        IdentificationConclusion::Settings settings{
            .name = name_of(from_),
            .identification = {.tolerance = reading_.greatest_defect()},
            .degrees = reading_.degrees,
            .json = choose<bool>("format of identify", format_, {{"pretty", false}, {"json", true}})};
        if (!within_.empty()) {
            settings.identification.within =
                amount_of("--within", within_, 0.0, false) * (reading_.degrees ? radians_per_degree : 1.0);
        }
        operations::IdentificationRows& rows = settings.rows;
        rows.known = spec_of("--to", to_, reading_.degrees);
        rows.paired = PairingOptions::is_paired(operands);
        rows.by_key = pairing_.by_key(operands);
        rows.count = settings.name ? representation(*settings.name).size : given_count(operands, rows);
        const auto subject = std::make_shared<messages::Subject>();
        const auto conclusion = std::make_shared<IdentificationConclusion>(settings, subject);
        RowsCommand command = rows_command(
            reading_, {}, file_columns(reading_, pairing_, operands), operations::identification_numbers(rows),
            operations::identify(
                rows, [self = conclusion.get()]() -> Identification& { return self->identification(); },
                conclusion->positions()),
            *subject, operands);
        command.subject = subject;
        if (rows.count == 0) {
            command.options.input.take_count = [self = conclusion.get()](std::size_t fields) {
                return self->take_count(fields);
            };
        }
        command.options.format = stream::Format::result;
        command.conclusion = conclusion;
        if (rows.paired) {
            pair(command, reading_, pairing_, operations::attitude_numbers(rows.known, rows.by_key),
                 messages::subject_of(rows.known, settings.identification.tolerance), operands);
        }
        return command;
    }

private:
    /// The unknown numbers of a row, where the command line tells how many there are; else 0.
    [[nodiscard]] std::size_t given_count(const Operands& operands, const operations::IdentificationRows& rows) const {
        std::size_t all = 0;
        const ChosenColumns columns = file_columns(reading_, pairing_, operands);
        if (!columns.list.empty()) {
            const auto parsed = stream::ColumnList::parse(columns.list, 0);
            const auto* error = std::get_if<stream::ColumnError>(&parsed);
            if (error == nullptr || error->what != stream::ColumnError::What::wrong_count) {
                return 0; // a list that is refused
            }
            all = error->count;
        } else if (operands.values.empty() && reading_.input_format == "f64") {
            if (reading_.width.empty()) {
                throw Usage("f64 rows do not tell how many numbers they have; --width, --columns or --from does");
            }
            all = static_cast<std::size_t>(count_of("--width", reading_.width, widest_row));
        } else {
            return 0;
        }
        auto count = unknown_of(all, rows);
        if (const auto* wrong = std::get_if<std::string>(&count)) {
            throw Usage(*wrong);
        }
        return std::get<std::size_t>(count);
    }

    std::string to_;
    std::string from_;
    std::string within_;
    std::string format_ = "pretty";
    PairingOptions pairing_;
    ReadingOptions reading_;
};

} // namespace

std::unique_ptr<CommandOptions> identify_options() { return std::make_unique<IdentifyOptions>(); }

} // namespace rotconv::cli
