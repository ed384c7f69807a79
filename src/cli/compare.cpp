#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/alignment.hpp>
#include <rotconv/axis_angle.hpp>
#include <rotconv/comparison.hpp>
#include <rotconv/quaternion.hpp>

#include "../stream/fmt.hpp"
#include "../stream/json.hpp"
#include "../stream/number_text.hpp"
#include "angle_statistics.hpp"
#include "row_options.hpp"

namespace rotconv::cli {
namespace {

/// Two attitudes of a pair, and the angle between them, for a sink of `operations::numbers_of_pair` numbers.
struct PairNumbers {
    double angle;
    std::array<double, 4> own, reference;
    double line;
};
static_assert(sizeof(PairNumbers) == operations::numbers_of_pair * sizeof(double));

/// Hands on the pairs that have an angle.
class PairSink final : public stream::Sink {
public:
    using Take = std::function<void(double angle, const Rotation& own, const Rotation& reference)>;
    explicit PairSink(Take take) : take_(std::move(take)) {}
    int write(std::string_view bytes) override {
        const auto rotation = [](const std::array<double, 4>& q) {
            return Rotation::near_unit(q[0], q[1], q[2], q[3]);
        };
        PairNumbers pair{};
        for (; !bytes.empty(); bytes.remove_prefix(sizeof pair)) {
            std::memcpy(&pair, bytes.data(), sizeof pair);
            if (!std::isnan(pair.angle)) {
                take_(pair.angle, rotation(pair.own), rotation(pair.reference));
            }
        }
        return 0;
    }

private:
    Take take_;
};

using Numbers = std::function<std::string(double)>;

/// Constant turns as options, and their sizes.
class TurnOptions {
public:
    TurnOptions() = default;
    /// @param found turns of attitudes that were turned as `given`
    TurnOptions(const ConstantTurns& found, const ConversionSettings& given) {
        const FixedRotation none{Rotation{}};
        add("left", found.left, FixedRotation(found.left) * given.left.value_or(none));
        add("right", found.right, given.right.value_or(none) * FixedRotation(found.right));
    }

    /// The settings with the turns as the options have them.
    [[nodiscard]] ConversionSettings replaced_in(ConversionSettings settings) const {
        settings.left.reset();
        settings.right.reset();
        for (const Side& side : sides_) {
            (side.name == "left" ? settings.left : settings.right) = FixedRotation::of_numbers(Spec{}, side.q);
        }
        return settings;
    }
    [[nodiscard]] std::string text(const Numbers& angle) const {
        std::string sizes;
        std::string options;
        for (const Side& side : sides_) {
            sizes += (sizes.empty() ? "" : " and ") + angle(side.size);
            options += fmt::format(" --{} '{}'", side.name, side.text());
        }
        return sides_.empty() ? "by nothing" : fmt::format("by {}:{}", sizes, options);
    }
    [[nodiscard]] JsonValue json(const Numbers& number) const {
        std::vector<std::pair<std::string_view, JsonValue>> object;
        for (const Side& side : sides_) {
            object.emplace_back(side.name, side.text());
            object.emplace_back(side.name == "left" ? "left_angle" : "right_angle",
                                JsonValue::as_written(number(side.size)));
        }
        return json_object(object);
    }

private:
    struct Side {
        std::string_view name;
        std::array<double, 4> q;
        double size; ///< of what was found, radians

        [[nodiscard]] std::string text() const { return fmt::format("quat: {}", fmt::join(q, " ")); }
    };

    void add(std::string_view name, const Rotation& found, const FixedRotation& all) {
        if (all.rotation.vector_length() > 0.0) {
            const Eigen::Quaterniond q = quaternion::from_rotation(all.rotation);
            sides_.push_back({name,
                              {q.w() + 0.0, q.x() + 0.0, q.y() + 0.0, q.z() + 0.0}, // no -0
                              axis_angle::from_rotation(found).angle});
        }
    }

    std::vector<Side> sides_;
};

enum class Format : std::uint8_t { pretty, json, csv };

/// The largest angle that passes.
struct Limit {
    std::string text{};                                     ///< as it was given, with its unit; empty: there is none
    double angle = std::numeric_limits<double>::infinity(); ///< in the unit of the output
    std::string_view unit{};
};

/// What is to be told of the pairs, and what they must hold to.
struct Check {
    Format format = Format::pretty;
    Limit within{};
    Limit within_p95{};
    std::array<bool, 2> allow_unpaired{}; ///< rows of FILE, of REFERENCE
    bool allow_failed = false;
    std::vector<std::pair<std::string, double>> percentiles{}; ///< with their names
    std::size_t worst = 0;                                     ///< pairs to show
    bool degrees = false;
    bool turns = false; ///< --delta: no constant turn is looked for
    bool by_key = false;
    stream::Digits digits{};
    std::string file{};
    std::string reference{};  ///< empty: there is none
    std::size_t own_size = 0; ///< numbers of the first attitude
    ConversionSettings reading{};

    [[nodiscard]] std::string_view unit() const { return degrees ? "deg" : "rad"; }
    [[nodiscard]] std::string number(double value) const {
        stream::Buffer text;
        stream::append_number(text, value, digits);
        return fmt::to_string(text);
    }
    [[nodiscard]] std::string angle(double value) const { return fmt::format("{} {}", number(value), unit()); }
    [[nodiscard]] std::string angle_in_unit_of(const Limit& limit, double value) const {
        const double radians = degrees ? radians_per_degree * value : value;
        return fmt::format("{} {}",
                           number(limit.unit == unit()   ? value
                                  : limit.unit == "deg"  ? degrees_per_radian * radians
                                  : limit.unit == "mrad" ? 1000.0 * radians
                                                         : radians),
                           limit.unit);
    }
    /// Of radians.
    [[nodiscard]] double in_unit(double radians) const { return degrees ? degrees_per_radian * radians : radians; }
};

class ComparisonConclusion final : public Conclusion {
public:
    ComparisonConclusion(Check check, std::shared_ptr<operations::PairWatch> watch,
                         std::shared_ptr<const TurnOptions> aligned)
        : check_(std::move(check)), watch_(std::move(watch)), aligned_(std::move(aligned)) {}

    [[nodiscard]] stream::Sink* rows() override { return check_.format == Format::csv ? nullptr : &sink_; }
    [[nodiscard]] bool is_check() const override { return true; }

    [[nodiscard]] Answer answer(const RowsResult& result) override {
        const std::size_t pairs = watch_->pairs();
        if (pairs == 0 && result.code == ExitCode::done) {
            print_error(check_.by_key && !result.keys.any_pair && result.unpaired[0].rows + result.unpaired[1].rows > 0
                            ? messages::no_key_met(result.keys)
                        : check_.turns && result.answered > 0 ? "no pair has one after it at the distance of --delta"
                                                              : std::string(messages::nothing_read));
        }
        const std::string fault = fault_of(result);
        const bool is_checked = !check_.within.text.empty() || !check_.within_p95.text.empty();
        const std::string verdict = !is_checked ? "not checked" : fault.empty() ? "pass" : "fail: " + fault;
        if (const std::string of_p95 = fault_of_p95(); check_.format == Format::csv && !of_p95.empty()) {
            print_error(of_p95); // of which the rows say nothing
        }
        return {.text = check_.format == Format::csv    ? ""
                        : check_.format == Format::json ? in_json(result, is_checked ? verdict : JsonValue())
                                                        : in_lines(result, verdict),
                .holds = fault.empty()};
    }

private:
    void add(double angle, const Rotation& own, const Rotation& reference) {
        angles_.add(angle);
        if (!check_.turns) {
            left_.add(reference * own.inverse());
            right_.add(own.inverse() * reference);
        }
    }

    [[nodiscard]] std::string fault_of_p95() const {
        const std::size_t pairs = watch_->pairs();
        if (watch_->beyond() * 100 <= pairs * 5) {
            return {};
        }
        const std::string figure =
            angles_.count() == 0 ? "" : check_.angle_in_unit_of(check_.within_p95, angles_.percentile(95.0)) + " ";
        return fmt::format("p95 {}is beyond {}, {} of {} rows", figure, check_.within_p95.text, watch_->beyond(),
                           pairs);
    }

    /// What does not hold; empty if all does.
    [[nodiscard]] std::string fault_of(const RowsResult& result) const {
        std::vector<std::string> faults;
        const std::size_t pairs = watch_->pairs();
        if (pairs == 0) {
            faults.emplace_back("no pairs");
        }
        if (result.beyond > 0) {
            faults.push_back(fmt::format("max {} is beyond {}, {} of {} rows, first at line {}",
                                         check_.angle_in_unit_of(check_.within, watch_->worst().begin()->angle),
                                         check_.within.text, result.beyond, pairs, result.first_beyond));
        }
        if (const std::string fault = fault_of_p95(); !fault.empty()) {
            faults.push_back(fault);
        }
        for (const std::size_t side : {0U, 1U}) {
            const std::size_t rows = result.unpaired.at(side).rows;
            if (rows > 0 && !check_.allow_unpaired.at(side)) {
                faults.push_back(
                    fmt::format("{} of {} unpaired", counted(rows, "row"), side == 0 ? "FILE" : "REFERENCE"));
            }
        }
        if (result.failed > 0 && !check_.allow_failed) {
            faults.push_back(counted(result.failed, "row") + " failed");
        } else if (result.code == ExitCode::completed_with_failures) {
            faults.emplace_back("--strict met a diagnostic");
        }
        return fmt::format("{}", fmt::join(faults, "; "));
    }

    /// The turns on one side that leave less than a hundredth, if there are such, and what they leave, in radians.
    [[nodiscard]] std::optional<std::pair<TurnOptions, double>> constant() const {
        if (check_.turns || angles_.count() < 2) {
            return std::nullopt;
        }
        const double all = angles_.root_mean_square() / check_.in_unit(1.0);
        const double left = left_.rms();
        const double right = right_.rms();
        constexpr double rounding = 0x1p-50;
        const bool is_left = left <= std::max(1.01 * right, rounding); // of equals
        const double rest = is_left ? left : right;
        if (!(rest < 0.01 * all) || all < rounding) {
            return std::nullopt;
        }
        const ConstantTurns turns = is_left ? ConstantTurns{left_.mean(), {}} : ConstantTurns{{}, right_.mean()};
        return std::pair(TurnOptions(turns, check_.reading), rest);
    }

    /// The figures of all angles by their names.
    [[nodiscard]] std::vector<std::pair<std::string, double>> figures() const {
        std::vector<std::pair<std::string, double>> all{
            {"rms", angles_.root_mean_square()}, {"mean", angles_.mean()}, {"std", angles_.standard_deviation()}};
        for (const auto& [name, percent] : check_.percentiles) {
            all.emplace_back(name, angles_.percentile(percent));
        }
        return all;
    }

    [[nodiscard]] std::string attitude(const operations::WorstPair& pair, bool of_reference,
                                       std::string_view separator = " ") const {
        const auto numbers = std::span(pair.numbers);
        const auto own = of_reference ? numbers.subspan(check_.own_size) : numbers.first(check_.own_size);
        return fmt::format("{}", fmt::join(own, separator));
    }

    [[nodiscard]] std::string in_lines(const RowsResult& result, const std::string& verdict) const {
        const auto angle = [this](double radians) { return check_.angle(check_.in_unit(radians)); };
        const auto line = [](std::string_view name, const auto& value) {
            return fmt::format("{:9} {}\n", name, value);
        };
        std::string text = line("rows", watch_->pairs());
        if (!check_.within.text.empty()) {
            text += line("beyond", result.beyond);
        }
        const auto& [own, other] = result.unpaired;
        text +=
            line("unpaired",
                 own.rows + other.rows == 0 ? "0" : fmt::format("{} of FILE, {} of REFERENCE", own.rows, other.rows));
        text += line("failed", result.failed);
        const auto where = [this](const operations::WorstPair& pair) {
            return fmt::format("{} at {}{}", check_.angle(pair.angle), pair.line,
                               check_.by_key ? fmt::format(" (key {})", pair.keys[0]) : "");
        };
        if (aligned_) {
            text += line("aligned", aligned_->text(angle));
        }
        if (angles_.count() > 0) {
            text += line("max", where(*watch_->worst().begin()));
            for (const auto& [name, value] : figures()) {
                text += line(name, check_.angle(value));
            }
        }
        if (const auto found = constant()) {
            text +=
                line("constant", fmt::format("{}, which leaves {}", found->first.text(angle), angle(found->second)));
        }
        std::size_t shown = 0;
        for (const operations::WorstPair& pair : watch_->worst()) {
            if (shown++ == check_.worst) {
                break;
            }
            std::string reference;
            if (pair.reference_line > 0) {
                reference = fmt::format(", reference {}{}", pair.reference_line,
                                        check_.by_key ? fmt::format(" (key {})", pair.keys[1]) : "");
            }
            text += line(fmt::format("worst {}", shown), fmt::format("{}{}: {} against {}", where(pair), reference,
                                                                     attitude(pair, false), attitude(pair, true)));
        }
        return text + verdict + "\n";
    }

    /// A key, or a number, as JSON has it.
    static JsonValue in_json(const std::string& text) {
        return stream::is_json_number(text) ? JsonValue::as_written(text) : escaped(text);
    }
    static JsonValue escaped(const std::string& text) {
        stream::Buffer to;
        stream::append_json_string(to, text);
        return JsonValue::as_written(fmt::to_string(to));
    }

    [[nodiscard]] JsonValue worst_in_json() const {
        std::vector<std::string> pairs;
        for (const operations::WorstPair& pair : watch_->worst()) {
            const auto list = [&](bool of_reference) {
                return JsonValue::as_written(fmt::format("[{}]", attitude(pair, of_reference, ", ")));
            };
            pairs.push_back(
                json_object({{"angle", JsonValue::as_written(check_.number(pair.angle))},
                             {"line", pair.line},
                             {"reference_line", pair.reference_line > 0 ? JsonValue(pair.reference_line) : JsonValue()},
                             {"key", check_.by_key ? in_json(pair.keys[0]) : JsonValue()},
                             {"reference_key", check_.by_key ? in_json(pair.keys[1]) : JsonValue()},
                             {"attitude", list(false)},
                             {"reference", list(true)}})
                    .text);
        }
        return check_.worst == 0 ? JsonValue() : JsonValue::as_written(fmt::format("[{}]", fmt::join(pairs, ", ")));
    }

    [[nodiscard]] std::string in_json(const RowsResult& result, const JsonValue& verdict) const {
        const bool has_pairs = angles_.count() > 0;
        const auto value_if = [](bool is_there, JsonValue value) { return is_there ? std::move(value) : JsonValue(); };
        const auto number = [&](double value) {
            return value_if(has_pairs, JsonValue::as_written(check_.number(value)));
        };
        const auto in_unit = [this](double radians) { return check_.number(check_.in_unit(radians)); };
        const auto limit = [&](const Limit& given) { return value_if(!given.text.empty(), given.angle); };
        const operations::WorstPair worst = has_pairs ? *watch_->worst().begin() : operations::WorstPair();
        std::vector<std::pair<std::string_view, JsonValue>> object{
            {"rows", watch_->pairs()},
            {"unit", std::string(check_.unit())},
            {"file", escaped(check_.file)},
            {"reference", value_if(!check_.reference.empty(), escaped(check_.reference))},
            {"version", ROTCONV_VERSION},
            {"within", limit(check_.within)},
            {"beyond", value_if(!check_.within.text.empty(), result.beyond)},
            {"first_beyond", value_if(result.beyond > 0, result.first_beyond)},
            {"within_p95", limit(check_.within_p95)},
            {"beyond_p95", value_if(!check_.within_p95.text.empty(), watch_->beyond())},
            {"unpaired", result.unpaired[0].rows + result.unpaired[1].rows},
            {"unpaired_file", result.unpaired[0].rows},
            {"unpaired_reference", result.unpaired[1].rows},
            {"failed", result.failed},
            {"max", number(worst.angle)},
            {"max_line", value_if(has_pairs, worst.line)},
            {"max_key", value_if(has_pairs && check_.by_key, in_json(worst.keys[0]))}};
        const auto all = figures();
        for (const auto& [name, value] : all) {
            object.emplace_back(name, number(value));
        }
        const auto found = constant();
        object.emplace_back("constant", found ? found->first.json(in_unit) : JsonValue());
        object.emplace_back("aligned", aligned_ ? aligned_->json(in_unit) : JsonValue());
        object.emplace_back("worst", worst_in_json());
        object.emplace_back("verdict", verdict);
        return json_line(object);
    }

    Check check_;
    std::shared_ptr<operations::PairWatch> watch_;
    std::shared_ptr<const TurnOptions> aligned_; ///< null: they are not
    PairSink sink_{
        [this](double angle, const Rotation& own, const Rotation& reference) { add(angle, own, reference); }};
    AngleStatistics angles_;
    MeanTurn left_;
    MeanTurn right_;
};

/// An angle, perhaps with its unit, as a limit in the unit of the output.
Limit limit_of(const Given& given, std::string_view option) {
    const std::string& text = given.text(option);
    const bool degrees = given.has("--degrees");
    if (text.empty()) {
        return {};
    }
    constexpr std::array<std::string_view, 3> units{"mrad", "rad", "deg"};
    const auto* const unit = std::ranges::find_if(units, [&](std::string_view end) { return text.ends_with(end); });
    const bool has_unit = unit != units.end();
    const std::string number = text.substr(0, text.size() - (has_unit ? unit->size() : 0));
    double value = 0.0;
    if (stream::trimmed(number) != number || stream::read_number(number, value) != stream::NumberError::none ||
        !(value >= 0.0)) {
        throw Usage(fmt::format("{} {} must be an angle that is not negative, such as 0.3deg, 5mrad or 0.1rad", option,
                                quoted(text)));
    }
    const std::string_view unit_name = has_unit ? *unit : degrees ? "deg" : "rad";
    value = unit_name == "mrad" ? value / 1000.0 : value;
    const bool is_degrees = unit_name == "deg";
    return {.text = fmt::format("{} {}", number, unit_name),
            .angle = is_degrees == degrees ? value : value * (degrees ? degrees_per_radian : radians_per_degree),
            .unit = unit_name};
}

/// "50,95.5" with names such as "p95.5".
std::vector<std::pair<std::string, double>> percentiles_of(const std::string& list) {
    if (list.empty()) {
        return {{"median", 50.0}, {"p95", 95.0}};
    }
    std::vector<std::pair<std::string, double>> percentiles;
    for (const std::string_view text : items_of(list)) {
        double value = 0.0;
        if (stream::read_number(text, value) != stream::NumberError::none || !(value > 0.0 && value <= 100.0)) {
            throw Usage(fmt::format("--percentiles {}: {} is not above 0 and at most 100", quoted(list), quoted(text)));
        }
        if (std::ranges::count(percentiles, value, &std::pair<std::string, double>::second) > 0) {
            throw Usage(fmt::format("--percentiles {} has {} twice", quoted(list), quoted(text)));
        }
        percentiles.emplace_back(fmt::format("p{}", value), value);
    }
    return percentiles;
}

/// Has the command find the turns of --align first.
/// @return where they will be
std::shared_ptr<TurnOptions> align(const Given& given, RowsCommand& command, const Comparison& comparison,
                                   const operations::ComparisonRows& rows,
                                   const std::shared_ptr<operations::PairWatch>& watch) {
    const auto side = one_of<AlignedSide>("side of --align", given.text("--align"),
                                          {{"reference", AlignedSide::reference},
                                           {"body", AlignedSide::body},
                                           {"both", AlignedSide::both},
                                           {"yaw", AlignedSide::yaw},
                                           {"first", AlignedSide::first}});
    if (command.has_values || command.input == "-" || command.reference == "-") {
        throw Usage("--align reads its input twice: give FILEs, not VALUEs or stdin");
    }
    operations::ComparisonRows as_they_are = rows;
    as_they_are.as_numbers = true;
    as_they_are.delta = 0;
    const auto alignment = std::make_shared<Alignment>(side);
    auto found = std::make_shared<TurnOptions>();
    command.first_pass = {
        operations::compare(comparison, as_they_are, std::make_shared<operations::PairWatch>(1, Limit().angle)),
        std::make_shared<PairSink>([alignment](double /*angle*/, const Rotation& attitude, const Rotation& known) {
            alignment->add(attitude, known);
        }),
        [=]() -> std::variant<operations::Operation, std::string> {
            const auto turns = alignment->turns();
            if (!turns) {
                return "the pairs do not determine the turn of --align";
            }
            ComparisonSettings turned = comparison.settings();
            *found = TurnOptions(*turns, turned.reading);
            turned.reading = found->replaced_in(turned.reading);
            return operations::compare(Comparison(comparison.from(), comparison.reference(), turned), rows, watch);
        }};
    return found;
}

/// A bare limit is in radians, whatever FILE is in.
void note_unit(const Given& given, std::string_view option, double limit, RowsCommand& command) {
    if (const std::string& text = given.text(option); stream::is_number(text) && std::isfinite(limit)) {
        command.notes.push_back(
            {.kind = stream::Note::Kind::limit,
             .text = fmt::format("{0} {1} is in radians, and the angles that are read are in degrees: {0} {1}deg, or "
                                 "{1}rad",
                                 option, text)});
    }
}

Command compare(const Given& given) {
    const Spec from = spec_of(given, "--from");
    const Spec reference = given.has("--to") ? spec_of(given, "--to") : from;
    Check check{.format = one_of<Format>(given, "--format", "format of compare",
                                         {{"pretty", Format::pretty}, {"json", Format::json}, {"csv", Format::csv}}),
                .within = limit_of(given, "--within"),
                .within_p95 = limit_of(given, "--within-p95"),
                .allow_failed = given.has("--allow-failed"),
                .percentiles = percentiles_of(given.text("--percentiles")),
                .worst = count_of(given, "--worst", 1'000'000),
                .degrees = given.has("--degrees"),
                .turns = given.has("--delta"),
                .by_key = is_by_key(given),
                .own_size = from.size(),
                .reading = attitude_settings_of(given)};
    if (given.has("--allow-unpaired")) {
        check.allow_unpaired = one_of<std::array<bool, 2>>(
            "kind of rows for --allow-unpaired", given.text("--allow-unpaired"),
            {{"file", {true, false}}, {"reference", {false, true}}, {"both", {true, true}}});
    }
    const bool as_rows = check.format == Format::csv;
    if (!as_rows && given.has("--as")) {
        throw Usage("--as needs --format csv");
    }
    if (!given.has("--as") && given.has("--frame")) {
        throw Usage("--frame is about the relative attitude, and needs --as SPEC");
    }
    ComparisonSettings comparing{.reading = check.reading,
                                 .within = check.within.angle,
                                 .unit = check.degrees ? AngleUnit::degrees : AngleUnit::radians,
                                 .frame = frame_of(given)};
    if (given.has("--as")) {
        comparing.relative = spec_of(given, "--as");
    }
    const Comparison comparison(from, reference, comparing);

    operations::ComparisonRows rows{.paired = is_paired(given),
                                    .by_key = check.by_key,
                                    .as_numbers = !as_rows,
                                    .interpolates = given.has("--interpolate") && is_paired(given),
                                    .delta = count_of(given, "--delta", 1'000'000)};
    messages::Subject subject = messages::subject_of(from, comparing.reading.tolerance);
    if (!rows.paired) {
        subject.text += given.has("--to") ? fmt::format(" with {}", representation(reference.name).text) : " twice";
        subject.count = comparison.inputs();
    }
    const auto watch =
        std::make_shared<operations::PairWatch>(std::max<std::size_t>(check.worst, 1), check.within_p95.angle);
    RowsCommand command = rows_command(given, columns_of_file(given), operations::comparison_numbers(comparison, rows),
                                       operations::compare(comparison, rows, watch), std::move(subject));
    command.options.append = as_rows;
    command.options.format = as_rows ? stream::Format::csv : stream::Format::result;
    command.allow_failed = check.allow_failed;
    if (rows.paired) {
        pair(given, command, operations::attitude_numbers(reference, rows.by_key),
             messages::subject_of(reference, comparing.reading.tolerance));
    }
    if (!check.degrees && (from.unit == AngleUnit::degrees || reference.unit == AngleUnit::degrees)) {
        note_unit(given, "--within", check.within.angle, command);
        note_unit(given, "--within-p95", check.within_p95.angle, command);
    }
    check.digits = command.options.digits;
    check.file = command.has_values ? "argument" : command.input;
    check.reference = command.reference;
    const auto aligned = given.has("--align") ? align(given, command, comparison, rows, watch) : nullptr;
    command.conclusion = std::make_shared<ComparisonConclusion>(std::move(check), watch, aligned);
    return command;
}

} // namespace

CommandEntry compare_command() {
    OptionSet set;
    set.begin_group("What");
    set.add("-f,--from", "SPEC", "The representation to read: NAME[:MODIFIER]...");
    set.add("-t,--to", "SPEC", "The representation of the reference (default: that of --from)");
    set.add("--as", "SPEC", "With --format csv: print the relative attitude too, in SPEC");
    set.add("--frame", "FRAME", "Axes of the relative attitude: body (default) or reference");
    set.add("--align", "SIDE", "Turn FILE by the best constant: reference, body, both, yaw, or first");
    set.add("--delta", "N", "Compare the turns from each pair to the N-th after it");
    add_attitudes(set);
    set.begin_group("Check");
    set.add("--within", "ANGLE", "The largest angle that passes, such as 0.3deg, 5mrad or 0.1rad");
    set.add("--within-p95", "ANGLE", "The angle that 95 in 100 pairs must not exceed");
    set.add("--allow-unpaired", "WHOSE", "Rows without a partner pass: file, reference or both");
    set.add_flag("--allow-failed", "Rows without an attitude pass, with --on-error skip or nan");
    add_pairing(set);
    set.add_flag("--interpolate", "Take the reference at FILE's key, between two rows --key-within apart");
    add_reading(set);
    add_writing(set);
    set.describe("--reference-axes", "Other reference axes of FILE's attitudes, such as ned:enu");
    set.describe("--body-axes", "Other body axes of FILE's attitudes, such as frd:flu, by their names");
    set.describe("--left", "Turn the attitudes R of FILE: compare L R; L as \"SPEC: NUMBERS\"");
    set.describe("--right", "Turn the attitudes R of FILE: compare R S; S as \"SPEC: NUMBERS\"");
    set.describe("--format", "pretty (default), json, or csv: every pair with its angle");
    set.begin_group("Output");
    set.add("--worst", "N", "Show the N pairs that differ most");
    set.add("--percentiles", "LIST", "Of the angles (default: the median and 95)");
    add_lock_margin(set);
    return {"compare",
            "Check attitudes against a reference, by the angles between them",
            "Usage: rotconv compare -f SPEC [-t SPEC] [OPTION]... FILE REFERENCE\n"
            "       rotconv compare -f SPEC [-t SPEC] [OPTION]... [FILE]\n"
            "       rotconv compare -f SPEC [-t SPEC] [OPTION]... VALUE...\n",
            std::move(set),
            compare,
            2};
}

} // namespace rotconv::cli
