#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/axes.hpp>
#include <rotconv/quaternion.hpp>

#include "../../core/identification/identification.hpp"
#include "../grammar/column_names.hpp"
#include "../row_options.hpp"

namespace rotconv::cli {
namespace {

constexpr std::size_t listed = 10;

/// What the rows are.
messages::Subject subject_of(const operations::IdentificationRows& rows, double tolerance) {
    messages::Subject subject = messages::subject_of({.attitude = rows.known}, tolerance);
    const std::string unknown = fmt::format("{} unknown numbers", rows.count);
    subject.text = rows.paired ? unknown : (rows.count == 0 ? "" : unknown + " with ") + subject.text;
    return subject;
}

/// How many of a row's numbers are not the known attitude's.
std::size_t unknown_of(std::size_t all, const operations::IdentificationRows& rows) {
    return rows.paired ? all : all - std::min(all, rows.known.size());
}

/// Why no representation has so many.
std::string no_such_count(std::size_t all, const operations::IdentificationRows& rows) {
    std::vector<std::size_t> legal{1, 2, 3, 4, 5, 6, 7, 8, 9};
    std::erase_if(legal, [](std::size_t each) { return !Identification::is_count(each); });
    const std::string known =
        rows.paired ? "" : fmt::format(" where {} has {}", representation(rows.known.name).text, rows.known.size());
    return fmt::format("{}{}: {} unknown (legal: {}){}", counted(all, "number"), known, unknown_of(all, rows),
                       fmt::join(legal, " "), rows.paired ? "" : "; or the known ones are in a second FILE");
}

/// A constant rotation as an option: by axes that have names, by others such as xyz:yx-z, or as a quaternion.
/// @param axes its name, if it has one
/// @param change the rotation as a change of axes
std::string option_of(const Rotation& rotation, std::string_view axes, const Rotation& change, std::string_view side,
                      std::string_view axes_option) {
    if (rotation.is_identity()) {
        return {};
    }
    const std::string named = axes.empty() ? axes_text(change) : std::string(axes);
    const Eigen::Quaterniond q = quaternion::from_rotation(rotation);
    return named.empty() ? fmt::format(" {} 'quat: {} {} {} {}'", side, q.w(), q.x(), q.y(), q.z())
                         : fmt::format(" {} {}", axes_option, named);
}

std::string options_of(const Candidate& candidate) {
    const auto& [left, right] = candidate.constant;
    return option_of(left, candidate.reference_axes, left, "--left", "--reference-axes") +
           option_of(right, candidate.body_axes, right.inverse(), "--right", "--body-axes");
}

std::string in_brackets(const Eigen::Vector3d& v) {
    return fmt::format("({:.3g}, {:.3g}, {:.3g})", v[0] + 0.0, v[1] + 0.0, v[2] + 0.0);
}

/// What is identified, and the answer.
class IdentificationReport {
public:
    struct Settings {
        operations::IdentificationRows rows{};  ///< their count is 0 if the first row tells it
        std::optional<RepresentationId> name{}; ///< the only one that is tried
        IdentificationSettings identification{};
        AngleUnitName unit{}; ///< of the angles of the answer
        bool json = false;
    };

    IdentificationReport(const Settings& settings, std::shared_ptr<messages::Subject> subject)
        : settings_(settings), subject_(std::move(subject)) {
        begin(settings.rows.count);
    }

    /// See stream::InputOptions::take_count.
    [[nodiscard]] std::variant<std::size_t, std::string> take_count(std::size_t fields) {
        const std::size_t count = unknown_of(fields, settings_.rows);
        if (!Identification::is_count(count)) {
            return no_such_count(fields, settings_.rows);
        }
        if (identification_->count() != count) { // not when the rows are read again
            begin(count);
        }
        return fields;
    }

    [[nodiscard]] std::shared_ptr<Identification> identification() const noexcept { return identification_; }

    [[nodiscard]] Conclusion conclude(const RowsCommand& command, const RowsResult& result) {
        positions_ = result.positions;
        if (!positions_.empty() && settings_.rows.by_key) {
            positions_.erase(positions_.begin());
        }
        const std::size_t rows = identification_->rows();
        if (rows == 0) {
            print_error(messages::nothing_read);
            return {.text = settings_.json ? json_line({{"rows", rows}, {"fit", rows}, {"answer", "none"}}) : "none\n"};
        }
        Verdict verdict = identification_->verdict();
        const bool all_were_held = hold_all(verdict, command);
        const std::string limit = verdict.fitting > 1 ? smaller_limit(verdict.candidates) : "";
        verdict.candidates.resize(std::min(verdict.candidates.size(), listed));
        const std::string end = settings_.json ? json_end(verdict) : table_end(verdict, limit, all_were_held);
        return {.text = lines_of(verdict.candidates) + end, .holds = verdict.answer.has_value() && all_were_held};
    }

private:
    void begin(std::size_t count) {
        settings_.rows.count = count;
        *identification_ = Identification(count, settings_.rows.known, settings_.name, settings_.identification);
        *subject_ = subject_of(settings_.rows, settings_.identification.tolerance);
    }

    /// Holds all rows against the answer, of which only some of many were kept.
    /// @return whether they could be read again
    [[nodiscard]] bool hold_all(Verdict& verdict, const RowsCommand& command) const {
        const std::size_t rows = identification_->rows();
        if (!verdict.answer || verdict.answer->rows == rows) {
            return true;
        }
        const auto again =
            std::make_shared<Identification>(*verdict.answer, settings_.rows.known, settings_.identification);
        static_cast<void>(look_through(command, operations::identify(settings_.rows, again)));
        if (again->rows() == 0) {
            return false;
        }
        Candidate& found = *std::ranges::find_if(verdict.candidates,
                                                 [this](const Candidate& each) { return identification_->fits(each); });
        const Candidate all = again->best_first().front();
        std::tie(found.rows, found.angle, found.angle_row) = std::tuple(all.rows, all.angle, all.angle_row);
        if (all.rows < rows || !again->fits(all)) {
            verdict.answer.reset();
            verdict.fitting = 0;
        }
        return true;
    }

    /// A line for each.
    [[nodiscard]] std::string lines_of(const std::vector<Candidate>& candidates) const {
        const auto line_of = [](const auto&... cells) {
            return fmt::format("{:<22}  {:<9}  {:>11}  {:>7}  {:>7}  {}\n", cells...);
        };
        std::string text = settings_.json ? "" : line_of("SPEC", "columns", "worst angle", "at line", "rows", "fits");
        for (const Candidate& each : candidates) {
            const bool is_read = std::isfinite(each.angle);
            const double angle = each.angle * settings_.unit.per_radian;
            const bool fits = identification_->fits(each);
            const std::string constant = options_of(each);
            text += settings_.json
                        ? json_line({{"spec", each.spec.text()},
                                     {"columns", columns_of(each)},
                                     {"angle", is_read ? JsonValue(angle) : JsonValue()},
                                     {"angle_line", each.angle_row},
                                     {"rows", each.rows},
                                     {"fits", fits},
                                     {"turns", constant.empty() ? JsonValue::as_written({}) : constant.substr(1)}})
                        : line_of(each.spec.text(), columns_of(each),
                                  is_read ? fmt::format("{:.6g}", angle) : "no attitude", each.angle_row, each.rows,
                                  (fits ? "yes" : "no") + constant);
        }
        return text;
    }

    [[nodiscard]] std::string answer_of(const Verdict& verdict) const {
        if (!verdict.answer) {
            return verdict.ambiguity != Verdict::Ambiguity::nothing ? "ambiguous" : "none";
        }
        const Candidate& first = *verdict.answer;
        return fmt::format("-f {} --columns {}{}", first.spec.text(), columns_of(first), options_of(first));
    }
    [[nodiscard]] std::string json_end(const Verdict& verdict) const {
        const std::string lacking = lack(verdict);
        return json_line({{"rows", identification_->rows()},
                          {"fit", verdict.fitting},
                          {"answer", answer_of(verdict)},
                          {"lack", lacking.empty() ? JsonValue::as_written({}) : lacking}});
    }
    /// @param limit that would leave one, in words
    [[nodiscard]] std::string table_end(const Verdict& verdict, const std::string& limit, bool all_were_held) const {
        std::string best = answer_of(verdict);
        if (verdict.ambiguity != Verdict::Ambiguity::nothing) {
            best += fmt::format(": {} {}; {}{}", verdict.fitting, verdict.fitting == 1 ? "fits" : "fit", lack(verdict),
                                limit);
        } else if (!verdict.answer) {
            best += ": a turn on both sides that has no name is found by compare --align both, once the SPEC is known";
        }
        return fmt::format(
            "\n{}{}; the convention that fits within {:.6g} {}:\n{}\n", counted(identification_->rows(), "row"),
            all_were_held ? "" : fmt::format(", of which {} were held against the answer", verdict.answer->rows),
            settings_.identification.within * settings_.unit.per_radian, settings_.unit.text, best);
    }

    /// Where one of those that fit is a million times nearer than all others, by more than rounding, and the rows
    /// suffice for it.
    [[nodiscard]] std::string smaller_limit(const std::vector<Candidate>& candidates) const {
        auto fitting = filtered(candidates, [this](const auto& each) { return identification_->fits(each); });
        std::ranges::sort(fitting, {}, &Candidate::angle);
        const double limit = 1e-3 * fitting.at(1).angle;
        return 1e3 * std::max(fitting[0].angle, std::numeric_limits<double>::epsilon()) < limit &&
                       identification_->do_rows_suffice(fitting[0], limit)
                   ? fmt::format("; one is a million times nearer than the others: --within {:.0e}{}",
                                 limit * settings_.unit.per_radian, settings_.unit.text)
                   : "";
    }

    /// What the rows lack.
    [[nodiscard]] std::string lack(const Verdict& verdict) const {
        using Ambiguity = Verdict::Ambiguity;
        switch (verdict.ambiguity) {
        case Ambiguity::rows:
            return verdict.candidates.front().constant.count() == 0 ? "there is one row"
                                                                    : "there is one row, and a turn takes two";
        case Ambiguity::attitudes: return "all rows have the same attitude";
        case Ambiguity::size:
            return fmt::format("all are small, at most {:.3g} {}", verdict.angle * settings_.unit.per_radian,
                               settings_.unit.text);
        case Ambiguity::axes: return fmt::format("all turn about one axis, {}", in_brackets(verdict.axis));
        case Ambiguity::plane:
            return fmt::format("the axes of the turns between them are perpendicular to {}", in_brackets(verdict.axis));
        case Ambiguity::zero: return fmt::format("the number in column {} is always 0", place(verdict.column) + 1);
        case Ambiguity::equal:
            return fmt::format("the numbers in columns {} and {} are always equal", place(verdict.column) + 1,
                               place(verdict.other) + 1);
        case Ambiguity::difference: return "these rows do not tell them apart";
        case Ambiguity::nothing: break;
        }
        return {};
    }

    /// The place of an unknown number in a row, from 0.
    [[nodiscard]] std::size_t place(std::size_t number) const {
        return positions_.empty() ? number : positions_.at(number);
    }

    [[nodiscard]] std::string columns_of(const Candidate& candidate) const {
        const auto places = mapped(std::span(candidate.columns).first(candidate.spec.size()),
                                   [this](std::size_t number) { return place(number); });
        return list_of_columns(places, {}, 3);
    }

    Settings settings_;
    std::shared_ptr<messages::Subject> subject_; ///< of the rows
    std::shared_ptr<Identification> identification_ = std::make_shared<Identification>(0, Spec{});
    std::vector<std::size_t> positions_; ///< of the fields that hold the unknown numbers; none where all do
};

struct IdentifyOptions final : RowOptions {
    IdentifyOptions() {
        from.argument = "NAME";
        from.about = "Try only this representation for the unknown numbers";
        to.argument = "KNOWN";
        to.about = "The representation of the known attitudes: NAME[:MODIFIER]...";
        format.about = "pretty (default), a table, or json";
        format.choices = {"pretty", "json"};
        add("What", {&to, &from, &within});
        add_pairing();
        add_reading();
        add("Output", {&format});
    }

    [[nodiscard]] Command command() const override {
        IdentificationReport::Settings asked{.rows = {{paired_rows()}},
                                             .name = name_alone(),
                                             .identification = {.tolerance = most_defect()},
                                             .unit = degrees.given() ? in_degrees : AngleUnitName(),
                                             .json =
                                                 one_of("format of identify", format, formats) == stream::Format::json};
        asked.identification.within = angle_of(within, degrees.given(), asked.identification.within);
        operations::IdentificationRows& rows = asked.rows;
        rows.known = spec_of(to);
        const SelectedColumns selected = columns_of_file();
        rows.count = asked.name ? representation(*asked.name).size : given_count(selected.list, rows);
        const auto subject = std::make_shared<messages::Subject>();
        const auto report = std::make_shared<IdentificationReport>(asked, subject);
        RowsCommand made = rows_command(operations::identify(rows, report->identification()), subject->text);
        made.subject = subject;
        if (rows.count == 0) {
            made.options.input.take_count = [report](std::size_t fields) { return report->take_count(fields); };
        }
        made.options.writes_rows = false;
        made.conclude = [report](const RowsCommand& command, const RowsResult& result) {
            return report->conclude(command, result);
        };
        pair(made, rows.known);
        return made;
    }

private:
    [[nodiscard]] std::optional<RepresentationId> name_alone() const {
        const std::string& text = from.text();
        if (!from.given()) {
            return std::nullopt;
        }
        if (const Representation* found = find_representation(text)) {
            return found->name;
        }
        const auto spec = parse_spec(text);
        throw Usage("{} takes a name alone, because all its modifiers and sequences are tried: {}", from.name(),
                    std::holds_alternative<Spec>(spec)
                        ? fmt::format("{}, not {}", representation(std::get<Spec>(spec).name).text, quoted(text))
                        : messages::explain(SpecError{SpecError::What::unknown_name, text}));
    }

    /// How many unknown numbers a row has, if the command line tells it; otherwise 0.
    [[nodiscard]] std::size_t given_count(const std::string& list, const operations::IdentificationRows& rows) const {
        std::size_t all = 0;
        if (!list.empty()) {
            const auto parsed = stream::ColumnList::parse(list, 0);
            const auto* error = std::get_if<stream::ColumnError>(&parsed);
            const bool is_counted = error != nullptr && error->what == stream::ColumnError::What::wrong_count;
            all = is_counted ? error->count : 0; // which is refused
        } else if (values.empty() && input_format.text() == "f64") {
            if (!width.given()) {
                throw Usage("f64 rows do not tell how many numbers they have; {}, {} or {} does", width.name(),
                            columns.name(), from.name());
            }
            all = count_of(width, widest_row);
        }
        const std::size_t count = unknown_of(all, rows);
        if (all > 0 && !Identification::is_count(count)) {
            throw Usage(no_such_count(all, rows));
        }
        return count;
    }

    Option within{"--within", "ANGLE", "The largest angle that fits (default 1e-3rad)"};
};

} // namespace

CommandEntry identify_command() {
    return {"identify", "Find the convention of numbers, from the same attitudes in a known one",
            "Usage: rotconv identify -t KNOWN [-f NAME] [OPTION]... FILE [REFERENCE]\n"
            "       rotconv identify -t KNOWN [-f NAME] [OPTION]... VALUE...\n",
            make_options<IdentifyOptions>, 2};
}

} // namespace rotconv::cli
