#include "row_options.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/axes.hpp>
#include <rotconv/rates.hpp>

#include "../stream/delimiter.hpp"
#include "../stream/number_text.hpp"
#include "column_names.hpp"
#include "values.hpp"

namespace rotconv::cli {
namespace {

stream::ColumnList parse(const std::string& list, std::size_t count, std::string_view option,
                         const messages::Subject& subject) {
    auto parsed = stream::ColumnList::parse(list, count);
    if (const auto* error = std::get_if<stream::ColumnError>(&parsed)) {
        throw Usage("{}: {}", option, messages::explain(*error, subject));
    }
    return std::get<stream::ColumnList>(std::move(parsed));
}

/// The columns of one of two streams, with its key.
SelectedColumns with_key(SelectedColumns columns, const Option& option, const std::string& key) {
    if (!key.empty()) {
        static_cast<void>(parse(key, 1, option.name(), {.text = "a key", .count = 1}));
        if (columns.list.empty()) {
            throw Usage("{} needs --columns, because a row with only the attitude's numbers has no key", option.name());
        }
        columns.key = key;
    }
    return columns;
}

[[noreturn]] void refuse(const Option& option, const Spec& spec, const stream::RowError& error,
                         double tolerance = 0.0) {
    throw Usage("{}: {}{}", option.name(), messages::explain(error, messages::subject_of(spec, tolerance)),
                messages::mend(error));
}

std::string or_else(const std::string& text, const std::string& other) { return text.empty() ? other : text; }

/// The change of axes that the option names; none if it is not given.
AxesChange axes_of(const Option& option) {
    const auto parsed = parse_axes(option.given() ? option.text() : "xyz:xyz");
    if (const auto* error = std::get_if<AxesError>(&parsed)) {
        throw Usage("{} {}", option.name(), message(AxesError{error->what, shortened(error->text), error->triple}));
    }
    return std::get<AxesChange>(parsed);
}

/// For a change of hand on one side alone, which gives no rotation.
std::string no_rotation(const Option& option, const AxesChange& change, const Option& other) {
    const std::string& text = option.text();
    const auto colon = text.find(':');
    const std::string left = change.from_left_handed ? text.substr(0, colon) : text.substr(colon + 1);
    return fmt::format("{0} {1} changes hand, because {2} is left-handed; so must {3}, such as {3} {1}", option.name(),
                       text, quoted(left), other.name());
}

ShowDiagnostics shown_diagnostics_of(const Option& option) {
    using enum ShowDiagnostics;
    return one_of<ShowDiagnostics>(fmt::format("place for {}", option.name()), or_else(option.text(), "summary"),
                                   {{"off", off}, {"summary", summary}, {"rows", rows}, {"columns", columns}});
}

stream::Digits digits_of(const RowOptions& options) {
    constexpr int most = 100;
    const auto& [precision, decimals] = std::tie(options.precision, options.decimals);
    if (precision.given() && decimals.given()) {
        throw Usage("{} cannot be combined with {}", precision.name(), decimals.name());
    }
    return {.significant = static_cast<int>(count_of(precision, most)),
            .decimals = decimals.given() ? static_cast<int>(count_of(decimals, most, 0)) : -1};
}

/// Doubles of a binary row; 0 if the input is text.
std::size_t width_of(const RowOptions& options, const std::string& columns_option, const stream::InputOptions& in) {
    const std::size_t needed = in.numbers.names.size();
    const std::size_t row = count_of(options.width, widest_row, 1, needed);
    if (!one_of<bool>("input format", options.input_format, {{"csv", false}, {"f64", true}})) {
        return 0;
    }
    if (in.columns.has_names()) {
        throw Usage("{} selects by name, but f64 rows have no names; use indices", columns_option);
    }
    const auto positions = in.columns.positions();
    const std::size_t least = positions.empty() ? needed : *std::ranges::max_element(positions) + 1;
    if (row < least || (positions.empty() && row != needed)) {
        throw Usage("rows of {} doubles (--width) where {} are {}", row, least,
                    positions.empty() ? "wanted (--columns selects)" : "the least for --columns");
    }
    return row;
}

/// How one stream is read, or the VALUEs.
stream::InputOptions input_of(const RowOptions& options, const SelectedColumns& selected, const Option& time_option,
                              stream::RowNumbers numbers, const messages::Subject& subject, bool refuses) {
    using stream::HeaderMode;
    stream::InputOptions in{.numbers = std::move(numbers)};
    in.header = one_of<HeaderMode>(
        fmt::format("mode of {}", options.header.name()), options.header,
        {{"auto", HeaderMode::automatic}, {"yes", HeaderMode::yes}, {"no", HeaderMode::no}, {"add", HeaderMode::add}});
    in.ragged = options.ragged.given();
    in.refuses_json = in.header == HeaderMode::automatic && options.policy() == stream::OnError::stop;
    const Option& delimiter = options.delimiter;
    in.delimiter = stream::Delimiter::parse(delimiter.text());
    if (!in.delimiter && delimiter.given()) {
        throw Usage("{} {} is neither comma, tab, semicolon or blank nor a character that can part numbers",
                    delimiter.name(), quoted(delimiter.text()));
    }
    if (!selected.list.empty()) {
        const std::size_t count = in.numbers.names.size();
        const std::size_t keys = selected.key.empty() ? 0 : 1;
        static_cast<void>(parse(selected.list, count - keys, selected.option, subject)); // for its message
        in.columns = parse(selected.key.empty() ? selected.list : selected.key + "," + selected.list, count,
                           selected.option, subject);
    }
    const bool has_values = !options.values.empty();
    const bool headless = in.header == HeaderMode::no || in.header == HeaderMode::add;
    if (in.columns.has_names() && (headless || has_values)) {
        throw Usage("{} selects by name, but there is no header with names; use indices", selected.option);
    }
    in.width = has_values ? 0 : width_of(options, selected.option, in);
    const std::string& comment = options.comment.text();
    in.comment = has_values || comment == "none" ? "" : or_else(comment, in.comment);
    add_notes(options, selected, time_option, refuses, in);
    return in;
}

/// What the labels of VALUEs say of them, as a header's names do.
void hold_labels(const std::vector<std::string>& labels, RowsCommand& command) {
    const stream::InputOptions& in = command.options.input;
    if (labels.size() != in.numbers.names.size() || !in.columns.empty()) {
        return; // the count is told, or other numbers are read
    }
    const auto parts = parts_of(in.numbers);
    for (const Part& part : parts) {
        const auto own = part.of(labels);
        for (auto label = own.begin(); label != own.end(); ++label) {
            if (!label->empty() && std::count(own.begin(), label, *label) > 0) {
                throw Usage("two of the numbers are called {}: {}", quoted(*label), command.values);
            }
        }
    }
    for (stream::Note& note : in.notes_of({.names = labels, .header = labels})) {
        if (note.text.starts_with("the header")) {
            note.text.replace(4, 6, note.kind == stream::Note::Kind::order ? "order of the labels" : "label");
        }
        if (note.ends_run) {
            throw Usage(note.text);
        }
        command.notes.push_back(std::move(note));
    }
    if (!in.numbers.attitude) {
        return;
    }
    const Part& part = parts.front();
    const auto own = part.of(labels);
    const auto given = filtered(own, [](const std::string& label) { return !label.empty(); });
    const auto known = find_names(part.names, own);
    if (!given.empty() && !find_names(part, own) && !(known && known->are_in_order())) {
        command.notes.push_back(
            {.kind = stream::Note::Kind::order,
             .text = fmt::format("the labels {} are not names of {}: the numbers are read as they stand",
                                 fmt::join(given, ","), part.attitude->text())});
    }
}

} // namespace

Spec RowOptions::spec_of(const Option& option, const std::string& text, bool as_degrees) {
    if (text.empty()) {
        throw MissingSpec("{} SPEC is missing; see rotconv --help", option.name());
    }
    const auto parsed = parse_spec(text);
    if (const auto* error = std::get_if<SpecError>(&parsed)) {
        const auto is_spec = [](std::string_view each) { return std::holds_alternative<Spec>(parse_spec(each)); };
        if (std::ranges::all_of(items_of(text), is_spec)) {
            throw Usage("{} {}: it takes one SPEC here", option.name(), quoted(text));
        }
        throw Usage("{} {}: {}", option.name(), quoted(text), messages::explain(*error));
    }
    const Spec& spec = std::get<Spec>(parsed);
    return as_degrees ? spec.in_degrees() : spec;
}

std::vector<Spec> RowOptions::specs_of(const Option& option) const {
    std::vector<Spec> specs;
    std::vector<std::string> names;
    for (const std::string_view text : items_of(option.text())) {
        if (text.empty() && option.given()) {
            throw Usage("{} {}: a SPEC of this list is empty", option.name(), quoted(option.text()));
        }
        specs.push_back(spec_of(option, std::string(text), degrees.given()));
        for (const std::string& name : operations::names_of(specs.back())) {
            if (std::ranges::count(names, name) > 0) {
                throw Usage("{} {}: two of these have a column {}", option.name(), quoted(option.text()), quoted(name));
            }
            names.push_back(name);
        }
    }
    return specs;
}

void require_rates(const Option& option, const Spec& spec) {
    if (!has_rates(spec.name)) {
        throw Usage("{} {}: its axis has no rate at the identity, but rotvec has one", option.name(),
                    representation(spec.name).text);
    }
}

GivenNumbers RowOptions::numbers_of(const Option& option) const {
    const std::string& text = option.text();
    const auto colon = text.rfind(':');
    if (colon == std::string::npos) {
        throw Usage("{} needs 'SPEC: NUMBERS' in one argument, such as 'quat: 1 0 0 0', not {}", option.name(),
                    quoted(text));
    }
    GivenNumbers read{spec_of(option, text.substr(0, colon), degrees.given()),
                      stream::trimmed(std::string_view(text).substr(colon + 1))};
    std::vector<std::string_view> fields;
    stream::Delimiter::of_row(read.row).split(read.row, fields);
    if (fields.size() != read.spec.size()) {
        throw Usage("{}: {} has {} numbers, not {}: {}", option.name(), representation(read.spec.name).text,
                    read.spec.size(), fields.size(), quoted(read.row));
    }
    for (const std::string_view field : fields) {
        const auto error = stream::read_number(field, read.numbers.emplace_back());
        if (error != stream::NumberError::none) {
            using What = stream::RowError::What;
            refuse(option, read.spec,
                   {.what = error == stream::NumberError::too_large ? What::too_large : What::not_a_number,
                    .text = std::string(read.row)});
        }
    }
    return read;
}

std::optional<FixedRotation> RowOptions::attitude_of(const Option& option) const {
    if (!option.given()) {
        return std::nullopt;
    }
    const GivenNumbers read = numbers_of(option);
    const double most = most_defect();
    std::array<double, 4> q{};
    std::vector<RowReport> reports;
    Conversion(read.spec, Spec{}, {.tolerance = most}).run(read.numbers, q, reports);
    if (!reports.empty() && reports.front().error != Error::none) {
        refuse(option, read.spec,
               {.what = stream::RowError::What::attitude,
                .text = std::string(read.row),
                .error = reports.front().error,
                .defect = reports.front().defect},
               most);
    }
    return FixedRotation::of_numbers(read.spec, read.numbers);
}

void RowOptions::check_attitudes() const {
    for (const Option* option : all()) {
        static_cast<void>(option->argument == "ATTITUDE" ? attitude_of(*option) : std::nullopt);
    }
}

double number_of(const Option& option, double default_value, std::string_view must,
                 const std::function<bool(double)>& holds) {
    double value = default_value;
    const std::string& text = option.text();
    if (option.given() && (stream::read_number(text, value) != stream::NumberError::none || !holds(value))) {
        throw Usage("{} {} must be a {}", option.name(), quoted(text), must);
    }
    return value;
}

double amount_of(const Option& option, double default_value, bool infinite) {
    return number_of(option, default_value,
                     infinite ? "number that is not negative" : "finite number that is not negative",
                     [infinite](double value) { return value >= 0.0 && (infinite || !std::isinf(value)); });
}

std::size_t count_of(const Option& option, std::size_t most, std::size_t least, std::size_t default_value) {
    const auto range = std::pair(static_cast<double>(least), static_cast<double>(most));
    return static_cast<std::size_t>(number_of(
        option, static_cast<double>(default_value), fmt::format("whole number from {} to {}", least, most),
        [range](double value) { return value == std::floor(value) && value >= range.first && value <= range.second; }));
}

int time_power_of(const Option& option) {
    return one_of<int>("time unit", option, {{"s", 0}, {"ms", -3}, {"us", -6}, {"ns", -9}});
}

double GivenAngle::in(const AngleUnitName& other) const noexcept {
    if (unit.text == other.text) {
        return value;
    }
    const double radians = unit.text == "deg" ? value * radians_per_degree : value / unit.per_radian;
    return radians * other.per_radian;
}

GivenAngle RowOptions::given_angle(const Option& option, const std::string& text) const {
    static constexpr std::array<AngleUnitName, 3> units{{{"mrad", 1000.0}, {}, in_degrees}};
    const auto* unit = std::ranges::find_if(units, [&](const auto& each) { return text.ends_with(each.text); });
    const bool is_bare = unit == units.end();
    const std::string number = text.substr(0, text.size() - (is_bare ? 0 : unit->text.size()));
    double value = 0.0;
    if (stream::trimmed(number) != number || stream::read_number(number, value) != stream::NumberError::none ||
        !(value >= 0.0)) {
        throw Usage("{} {} must be an angle that is not negative, such as 0.3deg, 5mrad or 0.1rad", option.name(),
                    quoted(text));
    }
    const AngleUnitName own = !is_bare ? *unit : degrees.given() ? in_degrees : AngleUnitName();
    return {fmt::format("{} {}", number, own.text), value, own, is_bare};
}

double RowOptions::angle_of(const Option& option, double default_value) const {
    const double angle = option.given() ? given_angle(option, option.text()).in({}) : default_value;
    if (std::isinf(angle)) {
        throw Usage("{} {} must be a finite angle", option.name(), quoted(option.text()));
    }
    return angle;
}

double RowOptions::most_defect() const { return amount_of(tolerance, ConversionSettings{}.tolerance, true); }

stream::OnError RowOptions::policy() const {
    using stream::OnError;
    return one_of<OnError>(fmt::format("policy of {}", on_error.name()), on_error,
                           {{"stop", OnError::stop}, {"nan", OnError::nan}, {"skip", OnError::skip}});
}

ConversionSettings RowOptions::settings() const {
    return {.tolerance = most_defect(),
            .sensitivity = shown_diagnostics_of(diagnostics) == ShowDiagnostics::columns,
            .decimal = !values.empty() || input_format.text() != "f64"};
}

ConversionSettings RowOptions::attitude_settings() const {
    ConversionSettings all = settings();
    all.lock_margin = angle_of(lock_margin, all.lock_margin);
    all.left = attitude_of(left);
    all.right = attitude_of(right);
    const AxesChange reference = axes_of(reference_axes);
    const AxesChange body = axes_of(body_axes);
    if (reference.changes_hand() != body.changes_hand()) {
        throw Usage(reference.changes_hand() ? no_rotation(reference_axes, reference, body_axes)
                                             : no_rotation(body_axes, body, reference_axes));
    }
    const FixedRotation none{Rotation{}};
    if (reference_axes.given()) { // L M R N' S
        all.left = all.left.value_or(none) * reference.turn();
    }
    if (body_axes.given()) {
        all.right = body.turn().inverse() * all.right.value_or(none);
    }
    return all;
}

void RowOptions::add_reading() {
    add("What", {&degrees});
    add("Columns", {&columns, &header, &comment, &ragged, &delimiter, &input, &input_format, &width});
    add("Output", {&output});
    add("Errors", {&on_error, &tolerance});
}

void RowOptions::add_writing() {
    add("Output", {&append, &format, &precision, &decimals});
    add("More", {&threads});
    add("Errors", {&diagnostics, &strict});
}

void RowOptions::add_pairing() {
    time_unit.about = "Keys are times in s, ms, us or ns, and the two T are seconds";
    add("Columns",
        {&reference_columns, &key, &reference_key, &key_within, &key_offset, &time_unit, &reference_time_unit});
}

void RowOptions::add_attitudes_of_file(std::string_view about_left, std::string_view about_right) {
    reference_axes.about = "Other reference axes of FILE's attitudes, such as ned:enu";
    body_axes.about = "Other body axes of FILE's attitudes, such as frd:flu, by their names";
    left.about = about_left;
    right.about = about_right;
    add_attitudes();
}

SelectedColumns RowOptions::columns_of_file() const {
    const bool has_keys = !key.group.empty();
    for (const Option* option :
         {&time_unit, &reference_time_unit, &key_offset, &interpolate, &key_within, &reference_key}) {
        if (has_keys && option->given() && !key.given()) {
            throw Usage("{} needs {}, because rows are paired by their number without it", option->name(), key.name());
        }
    }
    if (interpolate.given() && !key_within.given()) {
        throw Usage("{} needs {}: how far apart two rows of REFERENCE may be", interpolate.name(), key_within.name());
    }
    SelectedColumns selected{.list = columns.text(), .option = std::string(columns.name())};
    if (is_paired()) {
        return with_key(selected, key, key.text());
    }
    if (columns.given() && reference_columns.given()) {
        selected.list += "," + reference_columns.text();
    }
    return selected;
}

RowsCommand RowOptions::rows_command(const stream::RowNumbers& numbers, operations::Operation operation,
                                     messages::Subject subject) const {
    using stream::Format;
    const SelectedColumns selected = columns_of_file();
    RowsCommand command;
    command.has_values = !values.empty();
    command.diagnostics = shown_diagnostics_of(diagnostics);
    command.strict = strict.given();
    command.input = or_else(files.empty() ? input.text() : files[0], command.input);
    command.output = or_else(output.text(), command.output);
    command.options = {
        .input = input_of(*this, selected, time_unit, numbers, subject,
                          numbers.attitude || !numbers.second), // identify does not refuse names
        .operation = std::move(operation),
        .format = one_of<Format>(
            "format", format,
            {{"csv", Format::csv}, {"json", Format::json}, {"pretty", Format::pretty}, {"f64", Format::f64}}),
        .on_error = policy(),
        .digits = digits_of(*this),
        .append = append.given(),
        .diagnostic_columns = command.diagnostics == ShowDiagnostics::columns,
        .show_diagnostics = command.diagnostics != ShowDiagnostics::off,
        .threads = count_of(threads, std::size_t{1} << 20U, 1, stream::processors()),
        .describe = messages::describe,
    };
    command.notes = notes_on_options(*this);
    command.subject = std::make_shared<messages::Subject>(std::move(subject));
    if (command.has_values) {
        stream::InputOptions& in = command.options.input;
        Values given = values_of(values, in.delimiter);
        const auto& spec = in.numbers.attitude;
        if (spec && in.numbers.names.size() == spec->size() && in.columns.empty()) {
            take_attitude(given, *spec);
        }
        command.values = std::move(given.row);
        in.delimiter = given.delimiter;
        hold_labels(given.labels, command);
        in.header = in.header == stream::HeaderMode::add ? in.header : stream::HeaderMode::no;
    }
    return command;
}

RowsCommand RowOptions::pairs_command(const Spec& first, const Spec& second, operations::Operation operation) const {
    const double most = most_defect();
    const operations::PairedRows rows = paired_rows();
    RowsCommand command =
        rows_command(operations::pair_numbers(first, second, rows), std::move(operation),
                     rows.paired ? messages::subject_of(first, most) : messages::subject_of_two(first, second, most));
    if (rows.paired) {
        pair(command, operations::attitude_numbers(second, rows.by_key), messages::subject_of(second, most));
    }
    return command;
}

void RowOptions::pair(RowsCommand& command, stream::RowNumbers numbers, messages::Subject subject) const {
    const bool has_own_columns = reference_columns.given();
    const SelectedColumns selected =
        with_key({.list = (has_own_columns ? reference_columns : columns).text(),
                  .option = has_own_columns ? std::string(reference_columns.name())
                                            : fmt::format("{} (of REFERENCE too)", columns.name())},
                 reference_key, key.given() ? or_else(reference_key.text(), key.text()) : "");
    stream::InputOptions& in = command.options.input;
    stream::Pairing& pairs = command.options.pairing.emplace();
    const bool refuses = in.numbers.attitude.has_value(); // identify does not
    pairs.reference = input_of(*this, selected, reference_time_unit, std::move(numbers), subject, refuses);
    pairs.by_key = key.given();
    pairs.interpolates = interpolate.given();
    if (key_within.given()) {
        static_cast<void>(amount_of(key_within, 0.0, false));
        pairs.within = stream::read_distance(key_within.text());
    }
    in.key_power = time_power_of(time_unit);
    in.numbers.has_unit = time_unit.given();
    if (key_offset.given()) {
        const stream::ReadKey offset = stream::read_key(key_offset.text());
        constexpr stream::KeyDistance limit{stream::Uint128{1} << 123U}; // about 1e19; it is added to keys below 1e20
        if (offset.error != stream::KeyError::none || distance(offset.value, {}) > limit) {
            throw Usage("{} {} must be a number of less than 1e19 in size", key_offset.name(),
                        quoted(key_offset.text()));
        }
        in.key_offset = offset.value;
    }
    const Option& own_unit = reference_time_unit.given() ? reference_time_unit : time_unit;
    pairs.reference.key_power = time_power_of(own_unit);
    pairs.reference.numbers.has_unit = own_unit.given() && reference_time_unit.text() != "s"; // ISO 8601 is in seconds
    command.reference = files[1];
    command.reference_subject = std::move(subject);
}

void RowOptions::refuse_values(std::string_view command) const {
    if (!values.empty()) {
        throw Usage("{} reads rows, not arguments: {}", command, quoted(values[0]));
    }
}

} // namespace rotconv::cli
