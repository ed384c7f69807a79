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
SelectedColumns with_key(SelectedColumns columns, std::string_view key_option, const std::string& key) {
    if (!key.empty()) {
        static_cast<void>(parse(key, 1, key_option, {.text = "a key", .count = 1}));
        if (columns.list.empty()) {
            throw Usage("{} needs --columns, because a row with only the attitude's numbers has no key", key_option);
        }
        columns.key = key;
    }
    return columns;
}

[[noreturn]] void refuse(std::string_view option, const Spec& spec, const stream::RowError& error,
                         double tolerance = 0.0) {
    throw Usage("{}: {}{}", option, messages::explain(error, messages::subject_of(spec, tolerance)),
                messages::mend(error));
}

std::string or_else(const std::string& text, const std::string& other) { return text.empty() ? other : text; }

/// The change of axes that the option names; none if it is not given.
AxesChange axes_of(const Given& given, std::string_view option) {
    const std::string& text = given.text(option);
    const auto parsed = parse_axes(text.empty() ? "xyz:xyz" : text);
    if (const auto* error = std::get_if<AxesError>(&parsed)) {
        throw Usage("{} {}", option, message(AxesError{error->what, shortened(error->text), error->triple}));
    }
    return std::get<AxesChange>(parsed);
}

/// For a change of hand on one side alone, which gives no rotation.
std::string no_rotation(const Given& given, std::string_view option, const AxesChange& change, std::string_view other) {
    const std::string& text = given.text(option);
    const auto colon = text.find(':');
    const std::string left = change.from_left_handed ? text.substr(0, colon) : text.substr(colon + 1);
    return fmt::format("{0} {1} changes hand, because {2} is left-handed; so must {3}, such as {3} {1}", option, text,
                       quoted(left), other);
}

ShowDiagnostics shown_diagnostics_of(const Given& given) {
    using enum ShowDiagnostics;
    return one_of<ShowDiagnostics>("place for --diagnostics", or_else(given.text("--diagnostics"), "summary"),
                                   {{"off", off}, {"summary", summary}, {"rows", rows}, {"columns", columns}});
}

stream::Digits digits_of(const Given& given) {
    constexpr int most = 100;
    if (given.has("--precision") && given.has("--decimals")) {
        throw Usage("--precision cannot be combined with --decimals");
    }
    return {.significant = static_cast<int>(count_of(given, "--precision", most)),
            .decimals = given.has("--decimals") ? static_cast<int>(count_of(given, "--decimals", most, 0)) : -1};
}

/// Doubles of a binary row; 0 if the input is text.
std::size_t width_of(const Given& given, const std::string& columns_option, const stream::InputOptions& in) {
    const std::size_t needed = in.numbers.names.size();
    const std::size_t row = count_of(given, "--width", widest_row, 1, needed);
    if (!one_of<bool>(given, "--input-format", "input format", {{"csv", false}, {"f64", true}})) {
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
stream::InputOptions input_of(const Given& given, const SelectedColumns& selected, stream::RowNumbers numbers,
                              const messages::Subject& subject, bool refuses) {
    using stream::HeaderMode;
    stream::InputOptions in{.numbers = std::move(numbers)};
    in.header = one_of<HeaderMode>(
        given, "--header", "mode of --header",
        {{"auto", HeaderMode::automatic}, {"yes", HeaderMode::yes}, {"no", HeaderMode::no}, {"add", HeaderMode::add}});
    in.ragged = given.has("--ragged");
    in.refuses_json = in.header == HeaderMode::automatic && on_error_of(given) == stream::OnError::stop;
    const std::string& delimiter = given.text("--delimiter");
    in.delimiter = stream::Delimiter::parse(delimiter);
    if (!in.delimiter && !delimiter.empty()) {
        throw Usage("--delimiter {} is neither comma, tab, semicolon or blank nor a character that can part numbers",
                    quoted(delimiter));
    }
    if (!selected.list.empty()) {
        const std::size_t count = in.numbers.names.size();
        const std::size_t keys = selected.key.empty() ? 0 : 1;
        static_cast<void>(parse(selected.list, count - keys, selected.option, subject)); // for its message
        in.columns = parse(selected.key.empty() ? selected.list : selected.key + "," + selected.list, count,
                           selected.option, subject);
    }
    const bool has_values = !given.values.empty();
    const bool headless = in.header == HeaderMode::no || in.header == HeaderMode::add;
    if (in.columns.has_names() && (headless || has_values)) {
        throw Usage("{} selects by name, but there is no header with names; use indices", selected.option);
    }
    in.width = has_values ? 0 : width_of(given, selected.option, in);
    in.comment = has_values || given.text("--comment") == "none" ? "" : or_else(given.text("--comment"), in.comment);
    add_notes(given, selected, refuses, in);
    return in;
}

/// What the labels of VALUEs say of them, as a header's names do.
void hold_labels(const std::vector<std::string>& labels, RowsCommand& command) {
    const stream::InputOptions& in = command.options.input;
    if (labels.size() != in.numbers.names.size() || !in.columns.empty()) {
        return; // the count is told, or other numbers are read
    }
    // The first attitude, the second, and what is between.
    const std::size_t kept = in.numbers.kept;
    const std::size_t end = kept + (in.numbers.attitude ? in.numbers.attitude->size() : 0);
    const std::size_t second = labels.size() - (in.numbers.second ? in.numbers.second->size() : 0);
    for (const auto& [from, to] : {std::pair(kept, end), std::pair(end, second), std::pair(second, labels.size())}) {
        for (std::size_t i = from; i < to; ++i) {
            const auto part = std::span(labels).subspan(from, i - from);
            if (!labels[i].empty() && std::ranges::count(part, labels[i]) > 0) {
                throw Usage("two of the numbers are called {}: {}", quoted(labels[i]), command.values);
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
    if (const auto& spec = in.numbers.attitude; spec && !find_names(*spec, std::span(labels).first(spec->size()))) {
        command.notes.push_back(
            {.kind = stream::Note::Kind::order,
             .text = fmt::format("the labels {} are not names of {}: the numbers are read as they stand",
                                 fmt::join(labels, ","), spec->text())});
    }
}

} // namespace

Spec spec_of(std::string_view option, const std::string& text, bool degrees) {
    if (text.empty()) {
        throw MissingSpec("{} SPEC is missing; see rotconv --help", option);
    }
    const auto parsed = parse_spec(text);
    if (const auto* error = std::get_if<SpecError>(&parsed)) {
        throw Usage("{} {}: {}", option, quoted(text), messages::explain(*error));
    }
    const Spec& spec = std::get<Spec>(parsed);
    return degrees ? spec.in_degrees() : spec;
}

std::vector<Spec> specs_of(const Given& given, std::string_view option) {
    std::vector<Spec> specs;
    std::vector<std::string> names;
    for (const std::string_view text : items_of(given.text(option))) {
        if (text.empty() && !given.text(option).empty()) {
            throw Usage("{} {}: a SPEC of this list is empty", option, quoted(given.text(option)));
        }
        specs.push_back(spec_of(option, std::string(text), given.has("--degrees")));
        for (const std::string& name : operations::names_of(specs.back())) {
            if (std::ranges::count(names, name) > 0) {
                throw Usage("{} {}: two of these have a column {}", option, quoted(given.text(option)), quoted(name));
            }
            names.push_back(name);
        }
    }
    return specs;
}

void require_rates(std::string_view option, const Spec& spec) {
    if (!has_rates(spec.name)) {
        throw Usage("{} {}: its axis has no rate at the identity, but rotvec has one", option,
                    representation(spec.name).text);
    }
}

GivenNumbers numbers_of(const Given& given, std::string_view option) {
    const std::string& text = given.text(option);
    const auto colon = text.rfind(':');
    if (colon == std::string::npos) {
        throw Usage("{} needs 'SPEC: NUMBERS' in one argument, such as 'quat: 1 0 0 0', not {}", option, quoted(text));
    }
    GivenNumbers read{spec_of(option, text.substr(0, colon), given.has("--degrees")),
                      stream::trimmed(std::string_view(text).substr(colon + 1))};
    std::vector<std::string_view> fields;
    stream::Delimiter::of_row(read.row).split(read.row, fields);
    if (fields.size() != read.spec.size()) {
        throw Usage("{}: {} has {} numbers, not {}: {}", option, representation(read.spec.name).text, read.spec.size(),
                    fields.size(), quoted(read.row));
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

std::optional<FixedRotation> attitude_of(const Given& given, std::string_view option) {
    if (!given.has(option)) {
        return std::nullopt;
    }
    const GivenNumbers read = numbers_of(given, option);
    const double tolerance = tolerance_of(given);
    std::array<double, 4> q{};
    std::vector<RowReport> reports;
    Conversion(read.spec, Spec{}, {.tolerance = tolerance}).run(read.numbers, q, reports);
    if (!reports.empty() && reports.front().error != Error::none) {
        refuse(option, read.spec,
               {.what = stream::RowError::What::attitude,
                .text = std::string(read.row),
                .error = reports.front().error,
                .defect = reports.front().defect},
               tolerance);
    }
    return FixedRotation::of_numbers(read.spec, read.numbers);
}

double number_of(const Given& given, std::string_view option, double default_value, std::string_view must,
                 const std::function<bool(double)>& holds) {
    double value = default_value;
    const std::string& text = given.text(option);
    if (!text.empty() && (stream::read_number(text, value) != stream::NumberError::none || !holds(value))) {
        throw Usage("{} {} must be a {}", option, quoted(text), must);
    }
    return value;
}

double amount_of(const Given& given, std::string_view option, double default_value, bool infinite) {
    return number_of(given, option, default_value,
                     infinite ? "number that is not negative" : "finite number that is not negative",
                     [infinite](double value) { return value >= 0.0 && (infinite || !std::isinf(value)); });
}

std::size_t count_of(const Given& given, std::string_view option, std::size_t most, std::size_t least,
                     std::size_t default_value) {
    const auto range = std::pair(static_cast<double>(least), static_cast<double>(most));
    return static_cast<std::size_t>(number_of(
        given, option, static_cast<double>(default_value), fmt::format("whole number from {} to {}", least, most),
        [range](double value) { return value == std::floor(value) && value >= range.first && value <= range.second; }));
}

double GivenAngle::in(const AngleUnitName& other) const noexcept {
    if (unit.text == other.text) {
        return value;
    }
    const double radians = unit.text == "deg" ? value * radians_per_degree : value / unit.per_radian;
    return radians * other.per_radian;
}

GivenAngle given_angle(const Given& given, std::string_view option, const std::string& text) {
    static constexpr std::array<AngleUnitName, 3> units{{{"mrad", 1000.0}, {}, in_degrees}};
    const auto* unit = std::ranges::find_if(units, [&](const auto& each) { return text.ends_with(each.text); });
    const bool is_bare = unit == units.end();
    const std::string number = text.substr(0, text.size() - (is_bare ? 0 : unit->text.size()));
    double value = 0.0;
    if (stream::trimmed(number) != number || stream::read_number(number, value) != stream::NumberError::none ||
        !(value >= 0.0)) {
        throw Usage("{} {} must be an angle that is not negative, such as 0.3deg, 5mrad or 0.1rad", option,
                    quoted(text));
    }
    const AngleUnitName own = !is_bare ? *unit : given.has("--degrees") ? in_degrees : AngleUnitName();
    return {fmt::format("{} {}", number, own.text), value, own, is_bare};
}

double angle_of(const Given& given, std::string_view option, double default_value) {
    const double angle = given.has(option) ? given_angle(given, option, given.text(option)).in({}) : default_value;
    if (std::isinf(angle)) {
        throw Usage("{} {} must be a finite angle", option, quoted(given.text(option)));
    }
    return angle;
}

Frame frame_of(const Given& given) {
    return one_of<Frame>(given, "--frame", "frame", {{"body", Frame::body}, {"reference", Frame::reference}});
}

int time_power_of(const std::string& text) {
    return text.empty() ? 0 : one_of<int>("time unit", text, {{"s", 0}, {"ms", -3}, {"us", -6}, {"ns", -9}});
}

double tolerance_of(const Given& given) {
    return amount_of(given, "--tolerance", ConversionSettings{}.tolerance, true);
}

stream::OnError on_error_of(const Given& given) {
    using stream::OnError;
    return one_of<OnError>(given, "--on-error", "policy of --on-error",
                           {{"stop", OnError::stop}, {"nan", OnError::nan}, {"skip", OnError::skip}});
}

ConversionSettings settings_of(const Given& given) {
    return {.tolerance = tolerance_of(given),
            .sensitivity = shown_diagnostics_of(given) == ShowDiagnostics::columns,
            .decimal = !given.values.empty() || given.text("--input-format") != "f64"};
}

ConversionSettings attitude_settings_of(const Given& given) {
    ConversionSettings settings = settings_of(given);
    settings.lock_margin = angle_of(given, "--lock-margin", settings.lock_margin);
    settings.left = attitude_of(given, "--left");
    settings.right = attitude_of(given, "--right");
    const AxesChange reference = axes_of(given, "--reference-axes");
    const AxesChange body = axes_of(given, "--body-axes");
    if (reference.changes_hand() != body.changes_hand()) {
        throw Usage(reference.changes_hand() ? no_rotation(given, "--reference-axes", reference, "--body-axes")
                                             : no_rotation(given, "--body-axes", body, "--reference-axes"));
    }
    const FixedRotation none{Rotation{}};
    if (given.has("--reference-axes")) { // L M R N' S
        settings.left = settings.left.value_or(none) * reference.turn();
    }
    if (given.has("--body-axes")) {
        settings.right = body.turn().inverse() * settings.right.value_or(none);
    }
    return settings;
}

void add_reading(OptionSet& set) {
    set.begin_group("What");
    set.add_flag("-d,--degrees", "All angles are in degrees, read and written");
    set.begin_group("Columns");
    set.add("--columns", "LIST", "The columns to read: indices from 1, ranges such as 5-8, or names");
    set.add("--header", "MODE", "Header of the input: auto (default), yes, no, or add (none; print one)");
    set.add("--comment", "PREFIX", "What comments begin with (default #); none: there are none");
    set.add_flag("--ragged", "Take rows of any number of fields that have the columns");
    set.add("--delimiter", "D", "What separates fields: a character, or comma, tab, semicolon, blank");
    set.add("-i,--input", "FILE", "Read FILE; - is standard input");
    set.add("--input-format", "FORMAT", "csv (default), which is text, or f64, little-endian doubles");
    set.add("--width", "N", "Doubles in an f64 row of input, if more than those that are read");
    add_output(set);
    set.begin_group("Errors");
    set.add("--on-error", "POLICY", "What to do with a row that has no result: stop (default), nan, skip");
    set.add("--tolerance", "T", "How far from exact a quaternion or matrix may be (default 1e-3)");
}

void add_output(OptionSet& set) {
    set.begin_group("Output");
    set.add("-o,--output", "FILE", "Write FILE; - is standard output");
}

void add_format(OptionSet& set) {
    set.begin_group("Output");
    set.add("--format", "FORMAT", "csv (default), json, pretty for people, or f64, little-endian doubles");
    set.add("-p,--precision", "N", "Significant digits (default: the fewest that read back equal)");
    set.add("--decimals", "N", "Digits after the decimal point, instead of --precision");
    set.begin_group("More");
    set.add("--threads", "N", "At most N threads; the output is the same for every N");
}

void add_writing(OptionSet& set) {
    set.begin_group("Output");
    set.add_flag("--append", "Keep the whole row and add the result at its end");
    add_format(set);
    set.begin_group("Errors");
    set.add("--diagnostics", "WHERE", "Where to show diagnostics: off, summary (default), rows or columns");
    set.add_flag("--strict", "Exit with 1 if there was a diagnostic other than normalized");
}

void add_attitudes(OptionSet& set) {
    set.begin_group("What");
    set.add("--reference-axes", "FROM:TO", "Other reference axes, such as ned:enu, by their names");
    set.add("--body-axes", "FROM:TO", "Other body axes, such as frd:flu (cameras: rdf:rub), by their names");
    set.add("--left", "ATTITUDE", "Other reference axes: write L R instead of R; L as \"SPEC: NUMBERS\"");
    set.add("--right", "ATTITUDE", "Other body axes: write R S instead of R; S as \"SPEC: NUMBERS\"");
}

void add_continuous(OptionSet& set) {
    set.add_flag("--continuous", "Write the numbers nearest to the last result, so that they do not jump");
}

void add_lock_margin(OptionSet& set) {
    set.begin_group("Errors");
    set.add("--lock-margin", "ANGLE", "Treat attitudes this near gimbal lock as locked (default 1e-15rad)");
}

void add_pairing(OptionSet& set) {
    set.begin_group("Columns");
    set.add("--reference-columns", "LIST", "The columns to read in REFERENCE (default: those of --columns)");
    set.add("--key", "COLUMN", "Pair rows by the key in this column, such as time, instead of in order");
    set.add("--reference-key", "COLUMN", "The column of the key in REFERENCE (default: that of --key)");
    set.add("--key-within", "T", "The largest difference between the keys of a pair (default 0)");
    set.add("--key-offset", "T", "Add T to the keys of FILE");
    set.add("--time-unit", "UNIT", "Keys are times in s, ms, us or ns, and the two T are seconds");
    set.add("--reference-time-unit", "UNIT", "Unit of REFERENCE's keys (default: the same)");
}

SelectedColumns columns_of_file(const Given& given) {
    for (const std::string_view option :
         {"--time-unit", "--reference-time-unit", "--key-offset", "--interpolate", "--key-within", "--reference-key"}) {
        if (given.has(option) && !given.has("--key")) {
            throw Usage("{} needs --key, because rows are paired by their number without it", option);
        }
    }
    if (given.has("--interpolate") && !given.has("--key-within")) {
        throw Usage("--interpolate needs --key-within: how far apart two rows of REFERENCE may be");
    }
    SelectedColumns selected{.list = given.text("--columns")};
    if (is_paired(given)) {
        return with_key(selected, "--key", given.text("--key"));
    }
    if (given.has("--columns") && given.has("--reference-columns")) {
        selected.list += "," + given.text("--reference-columns");
    }
    return selected;
}

RowsCommand rows_command(const Given& given, const SelectedColumns& selected, const stream::RowNumbers& numbers,
                         operations::Operation operation, messages::Subject subject) {
    using stream::Format;
    RowsCommand command;
    command.has_values = !given.values.empty();
    command.diagnostics = shown_diagnostics_of(given);
    command.strict = given.has("--strict");
    command.input = or_else(given.files.empty() ? given.text("--input") : given.files[0], command.input);
    command.output = or_else(given.text("--output"), command.output);
    command.options = {
        .input = input_of(given, selected, numbers, subject, numbers.attitude.has_value()),
        .operation = std::move(operation),
        .format = one_of<Format>(
            given, "--format", "format",
            {{"csv", Format::csv}, {"json", Format::json}, {"pretty", Format::pretty}, {"f64", Format::f64}}),
        .on_error = on_error_of(given),
        .digits = digits_of(given),
        .append = given.has("--append"),
        .diagnostic_columns = command.diagnostics == ShowDiagnostics::columns,
        .show_diagnostics = command.diagnostics != ShowDiagnostics::off,
        .threads = count_of(given, "--threads", std::size_t{1} << 20U, 1, stream::processors()),
        .describe = messages::describe,
    };
    command.notes = notes_on_options(given);
    command.subject = std::make_shared<messages::Subject>(std::move(subject));
    if (command.has_values) {
        stream::InputOptions& in = command.options.input;
        Values values = values_of(given.values, in.delimiter);
        const auto& spec = in.numbers.attitude;
        if (spec && spec->name == RepresentationId::dcm && in.numbers.names.size() == spec->size() &&
            in.columns.empty()) {
            take_rotation_of_pose(values);
        }
        command.values = std::move(values.row);
        in.delimiter = values.delimiter;
        hold_labels(values.labels, command);
        in.header = in.header == stream::HeaderMode::add ? in.header : stream::HeaderMode::no;
    }
    return command;
}

void pair(const Given& given, RowsCommand& command, stream::RowNumbers numbers, messages::Subject subject) {
    const bool has_own_columns = given.has("--reference-columns");
    const SelectedColumns selected = with_key(
        {.list = given.text(has_own_columns ? "--reference-columns" : "--columns"),
         .option = has_own_columns ? "--reference-columns" : "--columns (of REFERENCE too)",
         .time_option = "--reference-time-unit"},
        "--reference-key", given.has("--key") ? or_else(given.text("--reference-key"), given.text("--key")) : "");
    stream::InputOptions& in = command.options.input;
    stream::Pairing& pairs = command.options.pairing.emplace();
    const bool refuses = in.numbers.attitude.has_value(); // identify does not
    pairs.reference = input_of(given, selected, std::move(numbers), subject, refuses);
    pairs.by_key = given.has("--key");
    pairs.interpolates = given.has("--interpolate");
    if (given.has("--key-within")) {
        static_cast<void>(amount_of(given, "--key-within", 0.0, false));
        pairs.within = stream::read_distance(given.text("--key-within"));
    }
    const std::string& own_unit = given.text("--time-unit");
    in.key_power = time_power_of(own_unit);
    in.numbers.has_unit = !own_unit.empty();
    if (given.has("--key-offset")) {
        const stream::ReadKey offset = stream::read_key(given.text("--key-offset"));
        constexpr stream::KeyDistance limit{stream::Uint128{1} << 123U}; // about 1e19; it is added to keys below 1e20
        if (offset.error != stream::KeyError::none || distance(offset.value, {}) > limit) {
            throw Usage("--key-offset {} must be a number of less than 1e19 in size",
                        quoted(given.text("--key-offset")));
        }
        in.key_offset = offset.value;
    }
    const std::string unit = or_else(given.text("--reference-time-unit"), own_unit);
    pairs.reference.key_power = time_power_of(unit);
    pairs.reference.numbers.has_unit = // ISO 8601 is in seconds
        !unit.empty() && given.text("--reference-time-unit") != "s";
    command.reference = given.files[1];
    command.reference_subject = std::move(subject);
}

void refuse_values(const Given& given, std::string_view command) {
    if (!given.values.empty()) {
        throw Usage("{} reads rows, not arguments: {}", command, quoted(given.values[0]));
    }
}

} // namespace rotconv::cli
