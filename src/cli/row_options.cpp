#include "row_options.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <rotconv/axes.hpp>
#include <rotconv/rates.hpp>

#include "../stream/delimiter.hpp"
#include "../stream/fmt.hpp"
#include "../stream/number_text.hpp"

namespace rotconv::cli {
namespace {

/// Whether roll is about x and pitch about y: not in Metashape's -ZXY of yaw, pitch and roll, for example.
bool has_usual_axes(const EulerSequence& sequence) { return !sequence.has_signs() || sequence.axis(1) == 1; }

/// The canonical names of quat, dcm, or roll, pitch and yaw, in the SPEC's order; none for other SPECs.
std::vector<std::string_view> name_order(const Spec& spec) {
    if (spec.name == RepresentationId::quat || spec.name == RepresentationId::dcm) {
        const auto columns = spec.columns();
        return {columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(spec.size())};
    }
    std::vector<std::string_view> order;
    if (spec.name == RepresentationId::rpy ||
        (spec.name == RepresentationId::euler && !spec.sequence.proper() && has_usual_axes(spec.sequence))) {
        for (std::size_t i = 0; i < spec.size(); ++i) {
            order.push_back(
                representation(RepresentationId::rpy).columns.at(static_cast<std::size_t>(spec.sequence.axis(i))));
        }
    }
    return order;
}

/// The SPEC with the same modifiers whose numbers have the canonical names in that order.
std::optional<Spec> spec_in_order(const Spec& like, const std::vector<std::string_view>& names) {
    Spec first = like;
    Spec second = like;
    if (like.name == RepresentationId::quat) {
        second.scalar_last = !like.scalar_last;
    } else if (like.name == RepresentationId::dcm) {
        second.column_major = !like.column_major;
    } else { // yaw, pitch, roll about the body's axes are roll, pitch, yaw about the fixed ones
        std::array<bool, 3> is_negative{};
        for (std::size_t i = 0; i < 3; ++i) {
            is_negative.at(static_cast<std::size_t>(like.sequence.axis(i))) = like.sequence.sign(i) < 0.0;
        }
        const auto [x, y, z] = is_negative;
        first.name = x || y || z ? RepresentationId::euler : RepresentationId::rpy;
        first.sequence = roll_pitch_yaw.with_signs(x, y, z);
        second.name = RepresentationId::euler;
        second.sequence = EulerSequence("ZYX").with_signs(z, y, x);
    }
    return name_order(first) == names ? first : name_order(second) == names ? std::optional(second) : std::nullopt;
}

/// Refuses canonical names in another order than the SPEC's, which would give a wrong attitude in silence.
void refuse_other_order(const SelectedColumns& columns, const stream::InputOptions& input) {
    const auto& spec = input.numbers.attitude;
    if (!spec) {
        return;
    }
    auto names = input.columns.names();
    names.erase(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(input.numbers.kept)); // such as a key
    names.resize(std::min(names.size(), spec->size()));
    if (const std::string wrong = wrong_order(*spec, names, columns.list); !wrong.empty()) {
        throw Usage(fmt::format("{} {} (if the file is mislabelled, select by index)", columns.option, wrong));
    }
}

stream::ColumnList parse(const std::string& list, std::size_t count, std::string_view option,
                         const messages::Subject& subject) {
    auto parsed = stream::ColumnList::parse(list, count);
    if (const auto* error = std::get_if<stream::ColumnError>(&parsed)) {
        throw Usage(fmt::format("{}: {}", option, messages::explain(*error, subject)));
    }
    return std::get<stream::ColumnList>(std::move(parsed));
}

/// The columns of one of two streams, with its key.
SelectedColumns with_key(SelectedColumns columns, std::string_view key_option, const std::string& key) {
    if (!key.empty()) {
        static_cast<void>(parse(key, 1, key_option, {.text = "a key", .count = 1}));
        if (columns.list.empty()) {
            throw Usage(fmt::format("{} needs --columns, because a row with only the attitude's numbers has no key",
                                    key_option));
        }
        columns.key = key;
    }
    return columns;
}

[[noreturn]] void refuse(std::string_view option, const Spec& spec, const stream::RowError& error,
                         double tolerance = 0.0) {
    throw Usage(fmt::format("{}: {}{}", option, messages::explain(error, messages::subject_of(spec, tolerance)),
                            messages::mend(error)));
}

const std::string& or_else(const std::string& text, const std::string& other) { return text.empty() ? other : text; }

/// The change of axes that the option names; none if it was not given.
AxesChange axes_of(std::string_view option, const std::string& text) {
    const auto parsed = parse_axes(text.empty() ? "xyz:xyz" : text);
    if (const auto* error = std::get_if<AxesError>(&parsed)) {
        throw Usage(fmt::format("{} {}{}", option, quoted(text), messages::explain(*error)));
    }
    return std::get<AxesChange>(parsed);
}

/// For a change of hand on one side alone, which gives no rotation.
std::string no_rotation(std::string_view option, const std::string& text, const AxesChange& change,
                        std::string_view other) {
    const auto colon = text.find(':');
    const std::string left = change.from_left_handed ? text.substr(0, colon) : text.substr(colon + 1);
    return fmt::format("{0} {1} changes hand, because {2} is left-handed; so must {3}, such as {3} {1}", option, text,
                       quoted(left), other);
}

} // namespace

std::string wrong_order(const Spec& spec, const std::vector<std::string_view>& names, std::string_view list) {
    const auto order = name_order(spec);
    return names != order && std::ranges::is_permutation(names, order)
               ? messages::other_order(list, spec, order, spec_in_order(spec, names))
               : std::string();
}

Spec spec_of(std::string_view option, const std::string& text, bool degrees) {
    if (text.empty()) {
        throw MissingSpec(fmt::format("{} SPEC is missing; see rotconv --help", option));
    }
    const auto parsed = parse_spec(text);
    if (const auto* error = std::get_if<SpecError>(&parsed)) {
        throw Usage(fmt::format("{} {}: {}", option, quoted(text), messages::explain(*error)));
    }
    const Spec& spec = std::get<Spec>(parsed);
    return degrees ? spec.in_degrees() : spec;
}

void require_rates(std::string_view option, const Spec& spec) {
    if (!has_rates(spec.name)) {
        throw Usage(fmt::format("{} {}: its axis has no rate at the identity, but rotvec has one", option,
                                representation(spec.name).text));
    }
}

GivenNumbers numbers_of(std::string_view option, const std::string& text, bool degrees) {
    const auto colon = text.rfind(':');
    if (colon == std::string::npos) {
        throw Usage(fmt::format("{} {} is not SPEC: NUMBERS, such as 'quat: 1 0 0 0'", option, quoted(text)));
    }
    GivenNumbers given{spec_of(option, text.substr(0, colon), degrees),
                       stream::trimmed(std::string_view(text).substr(colon + 1))};
    std::vector<std::string_view> fields;
    stream::Delimiter::of_row(given.row).split(given.row, fields);
    if (fields.size() != given.spec.size()) {
        throw Usage(fmt::format("{}: {} has {} numbers, not {}: {}", option, representation(given.spec.name).text,
                                given.spec.size(), fields.size(), quoted(given.row)));
    }
    for (const std::string_view field : fields) {
        const auto error = stream::read_number(field, given.numbers.emplace_back());
        if (error != stream::NumberError::none) {
            using What = stream::RowError::What;
            refuse(option, given.spec,
                   {.what = error == stream::NumberError::too_large ? What::too_large : What::not_a_number,
                    .text = std::string(given.row)});
        }
    }
    return given;
}

FixedRotation attitude_of(std::string_view option, const std::string& text, bool degrees, double tolerance) {
    const GivenNumbers given = numbers_of(option, text, degrees);
    std::array<double, 4> q{};
    std::vector<RowReport> reports;
    Conversion(given.spec, Spec{}, {.tolerance = tolerance}).run(given.numbers, q, reports);
    if (!reports.empty() && reports.front().error != Error::none) {
        refuse(option, given.spec,
               {.what = stream::RowError::What::attitude,
                .text = std::string(given.row),
                .error = reports.front().error,
                .defect = reports.front().defect},
               tolerance);
    }
    return FixedRotation::of_numbers(given.spec, given.numbers);
}

double amount_of(std::string_view option, const std::string& text, double default_value, bool infinite) {
    if (text.empty()) {
        return default_value;
    }
    double value = 0.0;
    if (stream::read_number(text, value) != stream::NumberError::none || !(value >= 0.0) ||
        (std::isinf(value) && !infinite)) {
        throw Usage(fmt::format("{} {} must be a {}number that is not negative", option, quoted(text),
                                infinite ? "" : "finite "));
    }
    return value;
}

std::int64_t count_of(std::string_view option, const std::string& text, std::int64_t most, std::int64_t least) {
    if (text.empty()) {
        return 0;
    }
    double value = 0.0;
    if (stream::read_number(text, value) != stream::NumberError::none || value != std::floor(value) ||
        value < static_cast<double>(least) || value > static_cast<double>(most)) {
        throw Usage(fmt::format("{} {} must be a whole number from {} to {}", option, quoted(text), least, most));
    }
    return static_cast<std::int64_t>(value);
}

Frame frame_of(const std::string& text) {
    return one_of<Frame>("frame", text, {{"body", Frame::body}, {"reference", Frame::reference}});
}

int time_power_of(const std::string& text) {
    return text.empty() ? 0 : one_of<int>("time unit", text, {{"s", 0}, {"ms", -3}, {"us", -6}, {"ns", -9}});
}

void RowOptions::add_reading() {
    set.begin_group("What");
    set.add("-d,--degrees", degrees, "All angles are in degrees, read and written");
    set.begin_group("Columns");
    set.add("--columns", columns, "LIST", "The columns to read: indices from 1, ranges such as 5-8, or names");
    set.add("--header", header_, "MODE", "Header of the input: auto (default), yes, no, or add (none; print one)");
    set.add("--comment", comment_, "PREFIX", "What comments begin with (default #); none: there are none");
    set.add("--delimiter", delimiter_, "D", "What separates fields: a character, or comma, tab, semicolon, blank");
    set.add("-i,--input", input, "FILE", "Read FILE; - is standard input");
    set.add("--input-format", input_format, "FORMAT", "csv (default), which is text, or f64, little-endian doubles");
    set.add("--width", width, "N", "Doubles in an f64 row of input, if more than those that are read");
    add_output();
    set.begin_group("Errors");
    set.add("--on-error", on_error_, "POLICY", "What to do with a row that has no result: stop (default), nan, skip");
    set.add("--tolerance", tolerance_, "T", "How far from exact a quaternion or matrix may be (default 1e-3)");
}

void RowOptions::add_output() {
    set.begin_group("Output");
    set.add("-o,--output", output_, "FILE", "Write FILE; - is standard output");
}

void RowOptions::add_format() {
    set.begin_group("Output");
    set.add("--format", format, "FORMAT", "csv (default), json, pretty for people, or f64, little-endian doubles");
    set.add("-p,--precision", precision_, "N", "Significant digits (default: the fewest that read back equal)");
    set.add("--decimals", decimals_, "N", "Digits after the decimal point, instead of --precision");
    set.begin_group("More");
    set.add("--threads", threads_, "N", "At most N threads; the output is the same for every N");
}

void RowOptions::add_writing() {
    set.begin_group("Output");
    set.add("--append", append_, "Keep the whole row and add the result at its end");
    add_format();
    set.begin_group("Errors");
    set.add("--diagnostics", diagnostics_, "WHERE",
            "Where to show diagnostics: off, summary (default), rows or columns");
    set.add("--strict", strict_, "Exit with 1 if there was a diagnostic other than normalized");
}

double RowOptions::tolerance() const {
    return amount_of("--tolerance", tolerance_, ConversionSettings{}.tolerance, true);
}

stream::OnError RowOptions::on_error() const {
    return one_of<stream::OnError>(
        "policy of --on-error", on_error_,
        {{"stop", stream::OnError::stop}, {"nan", stream::OnError::nan}, {"skip", stream::OnError::skip}});
}

ShowDiagnostics RowOptions::shown_diagnostics() const {
    return one_of<ShowDiagnostics>("place for --diagnostics", diagnostics_,
                                   {{"off", ShowDiagnostics::off},
                                    {"summary", ShowDiagnostics::summary},
                                    {"rows", ShowDiagnostics::rows},
                                    {"columns", ShowDiagnostics::columns}});
}

ConversionSettings RowOptions::settings() const {
    return {.tolerance = tolerance(), .sensitivity = shown_diagnostics() == ShowDiagnostics::columns};
}

stream::Digits RowOptions::digits() const {
    constexpr int most = 100;
    if (!precision_.empty() && !decimals_.empty()) {
        throw Usage("--precision cannot be combined with --decimals");
    }
    if (decimals_.empty()) {
        return {.significant = static_cast<int>(count_of("--precision", precision_, most))};
    }
    return {.decimals = static_cast<int>(count_of("--decimals", decimals_, most, 0))};
}

/// Doubles of a binary row; 0 if the input is text.
std::size_t RowOptions::width_of(const stream::InputOptions& in) const {
    const auto given = static_cast<std::size_t>(count_of("--width", width, widest_row));
    if (!one_of<bool>("input format", input_format, {{"csv", false}, {"f64", true}})) {
        return 0;
    }
    if (in.columns.has_names()) {
        throw Usage("--columns selects by name, but f64 rows have no names; use indices");
    }
    const std::size_t needed = in.numbers.names.size();
    const std::size_t row = given > 0 ? given : needed;
    const auto positions = in.columns.positions();
    const std::size_t least = positions.empty() ? needed : *std::ranges::max_element(positions) + 1;
    if (row < least || (positions.empty() && row != needed)) {
        throw Usage(fmt::format("rows of {} doubles (--width) where {} are {}", row, least,
                                positions.empty() ? "wanted (--columns selects)" : "the least for --columns"));
    }
    return row;
}

/// How one stream is read, or the VALUEs.
stream::InputOptions RowOptions::input_of(const SelectedColumns& selected, stream::RowNumbers numbers,
                                          const messages::Subject& subject, bool has_values, bool refuses) const {
    using stream::HeaderMode;
    stream::InputOptions in{.numbers = std::move(numbers)};
    in.header = one_of<HeaderMode>(
        "mode of --header", header_,
        {{"auto", HeaderMode::automatic}, {"yes", HeaderMode::yes}, {"no", HeaderMode::no}, {"add", HeaderMode::add}});
    in.refuses_json = in.header == HeaderMode::automatic && on_error() == stream::OnError::stop;
    if (!delimiter_.empty()) {
        in.delimiter = stream::Delimiter::parse(delimiter_);
        if (!in.delimiter) {
            throw Usage(fmt::format(
                "--delimiter {} is neither comma, tab, semicolon or blank nor a character that can part numbers",
                quoted(delimiter_)));
        }
    }
    if (!selected.list.empty()) {
        const std::size_t count = in.numbers.names.size();
        const std::size_t keys = selected.key.empty() ? 0 : 1;
        static_cast<void>(parse(selected.list, count - keys, selected.option, subject)); // for its message
        in.columns = parse(selected.all(), count, selected.option, subject);
        if (refuses) {
            refuse_other_order(selected, in);
        }
    }
    const bool headless = in.header == HeaderMode::no || in.header == HeaderMode::add;
    if (in.columns.has_names() && (headless || has_values)) {
        throw Usage("--columns selects by name, but there is no header with names; use indices");
    }
    in.width = has_values ? 0 : width_of(in);
    in.comment = has_values || comment_ == "none" ? "" : comment_;
    add_notes(in, {.degrees = degrees,
                   .time_unit = or_else(argument_of(selected.time_option), argument_of("--time-unit")),
                   .time_option = selected.time_option,
                   .refuses = refuses});
    return in;
}

std::string RowOptions::argument_of(std::string_view option) const {
    const auto& all = set.all();
    const auto found = std::ranges::find(all, option, &Option::name);
    return found == all.end() ? std::string() : *std::get<std::string*>(found->value);
}

SelectedColumns RowOptions::columns_of_file(const PairingOptions& pairing, const Operands& operands) const {
    SelectedColumns selected{.list = columns};
    pairing.check();
    if (PairingOptions::is_paired(operands)) {
        return with_key(selected, "--key", pairing.key);
    }
    if (!columns.empty() && !pairing.reference_columns.empty()) {
        selected.list += "," + pairing.reference_columns;
    }
    return selected;
}

RowsCommand RowOptions::rows_command(const SelectedColumns& selected, const stream::RowNumbers& numbers,
                                     operations::Operation operation, messages::Subject subject,
                                     const Operands& operands) const {
    RowsCommand command;
    command.has_values = !operands.values.empty();
    command.diagnostics = shown_diagnostics();
    command.strict = strict_;
    command.input = !operands.files.empty() ? operands.files[0] : or_else(input, command.input);
    command.output = output_;
    const auto threads = static_cast<std::size_t>(count_of("--threads", threads_, 1 << 20U));
    command.options = {
        .input = input_of(selected, numbers, subject, command.has_values, numbers.attitude.has_value()),
        .operation = std::move(operation),
        .format = one_of<stream::Format>("format", format.empty() ? "csv" : format,
                                         {{"csv", stream::Format::csv},
                                          {"json", stream::Format::json},
                                          {"pretty", stream::Format::pretty},
                                          {"f64", stream::Format::f64}}),
        .on_error = on_error(),
        .digits = digits(),
        .append = append_,
        .diagnostic_columns = command.diagnostics == ShowDiagnostics::columns,
        .show_diagnostics = command.diagnostics != ShowDiagnostics::off,
        .threads = threads > 0 ? threads : stream::processors(),
        .describe = messages::describe,
    };
    for (const char* option : {"--left", "--right", "--initial"}) {
        if (const auto note = note_on(option, argument_of(option), degrees)) {
            command.notes.push_back(*note);
        }
    }
    command.subject = std::make_shared<messages::Subject>(std::move(subject));
    if (command.has_values) {
        stream::InputOptions& in = command.options.input;
        auto row = row_of_values(operands.values, in.delimiter);
        command.values = std::move(row.text);
        in.delimiter = row.delimiter;
        if (in.header != stream::HeaderMode::add) {
            in.header = stream::HeaderMode::no;
        }
    }
    return command;
}

void RowOptions::pair(RowsCommand& command, const PairingOptions& pairing, stream::RowNumbers numbers,
                      messages::Subject subject, const Operands& operands) const {
    const SelectedColumns selected =
        with_key({.list = or_else(pairing.reference_columns, columns),
                  .option = pairing.reference_columns.empty() ? "--columns (of REFERENCE too)" : "--reference-columns",
                  .time_option = "--reference-time-unit"},
                 "--reference-key", pairing.key.empty() ? "" : or_else(pairing.reference_key, pairing.key));
    stream::Pairing& pairs = command.options.pairing.emplace();
    const bool refuses = command.options.input.numbers.attitude.has_value(); // identify does not
    pairs.reference = input_of(selected, std::move(numbers), subject, false, refuses);
    pairs.by_key = !pairing.key.empty();
    pairs.interpolates = pairing.interpolates;
    if (!pairing.key_within.empty()) {
        static_cast<void>(amount_of("--key-within", pairing.key_within, 0.0, false));
        pairs.within = *stream::Decimal::parse(pairing.key_within);
    }
    stream::InputOptions& in = command.options.input;
    in.key_power = time_power_of(pairing.time_unit);
    in.numbers.has_unit = !pairing.time_unit.empty();
    if (!pairing.key_offset.empty()) {
        const auto offset = stream::Decimal::parse(pairing.key_offset);
        if (!offset) {
            throw Usage(fmt::format("--key-offset {} must be a finite number", quoted(pairing.key_offset)));
        }
        in.key_origin = stream::Decimal() - *offset;
    }
    const std::string& unit = or_else(pairing.reference_time_unit, pairing.time_unit);
    pairs.reference.key_power = time_power_of(unit);
    pairs.reference.numbers.has_unit = !unit.empty() && pairing.reference_time_unit != "s"; // ISO 8601 is in seconds
    command.reference = operands.files[1];
    command.reference_subject = std::move(subject);
}

void AttitudeOptions::add_to(OptionSet& set, bool with_continuous) {
    set.begin_group("What");
    set.add("--reference-axes", reference_axes, "FROM:TO", "Other reference axes, such as ned:enu, by their names");
    set.add("--body-axes", body_axes, "FROM:TO", "Other body axes, such as frd:flu (cameras: rdf:rub), by their names");
    set.add("--left", left, "ATTITUDE", "Other reference axes: write L R instead of R; L as \"SPEC: NUMBERS\"");
    set.add("--right", right, "ATTITUDE", "Other body axes: write R S instead of R; S as \"SPEC: NUMBERS\"");
    if (with_continuous) {
        set.add("--continuous", continuous, "Write the numbers nearest to the last result, so that they do not jump");
    }
}

void AttitudeOptions::add_lock_margin_to(OptionSet& set) {
    set.begin_group("Errors");
    set.add("--lock-margin", lock_margin, "ANGLE",
            "Treat attitudes this near gimbal lock as locked (rad; default 1e-15)");
}

ConversionSettings AttitudeOptions::added_to(ConversionSettings settings, bool degrees) const {
    settings.lock_margin = amount_of("--lock-margin", lock_margin, settings.lock_margin, false);
    if (!left.empty()) {
        settings.left = attitude_of("--left", left, degrees, settings.tolerance);
    }
    if (!right.empty()) {
        settings.right = attitude_of("--right", right, degrees, settings.tolerance);
    }
    const AxesChange reference = axes_of("--reference-axes", reference_axes);
    const AxesChange body = axes_of("--body-axes", body_axes);
    if (reference.changes_hand() != body.changes_hand()) {
        throw Usage(reference.changes_hand() ? no_rotation("--reference-axes", reference_axes, reference, "--body-axes")
                                             : no_rotation("--body-axes", body_axes, body, "--reference-axes"));
    }
    const FixedRotation none{Rotation{}};
    if (!reference_axes.empty()) { // L M R N' S
        settings.left = settings.left.value_or(none) * reference.turn();
    }
    if (!body_axes.empty()) {
        settings.right = body.turn().inverse() * settings.right.value_or(none);
    }
    return settings;
}

void PairingOptions::add_to(OptionSet& set, bool with_interpolation) {
    set.begin_group("Columns");
    set.add("--reference-columns", reference_columns, "LIST",
            "The columns to read in REFERENCE (default: those of --columns)");
    set.add("--key", key, "COLUMN", "Pair rows by the key in this column, such as time, instead of in order");
    set.add("--reference-key", reference_key, "COLUMN", "The column of the key in REFERENCE (default: that of --key)");
    set.add("--key-within", key_within, "T", "The largest difference between the keys of a pair (default 0)");
    set.add("--key-offset", key_offset, "T", "Add T to the keys of FILE");
    set.add("--time-unit", time_unit, "UNIT", "Keys are times in s, ms, us or ns, and the two T are seconds");
    set.add("--reference-time-unit", reference_time_unit, "UNIT", "Unit of REFERENCE's keys (default: the same)");
    if (with_interpolation) {
        set.add("--interpolate", interpolates, "Take the reference at FILE's key, between two rows --key-within apart");
    }
}

void PairingOptions::check() const {
    using Given = std::pair<std::string_view, bool>;
    for (const auto& [option, is_given] : {Given{"--time-unit", !time_unit.empty()},
                                           {"--reference-time-unit", !reference_time_unit.empty()},
                                           {"--key-offset", !key_offset.empty()},
                                           {"--interpolate", interpolates}}) {
        if (is_given && key.empty()) {
            throw Usage(fmt::format("{} needs --key, because rows are paired by their number without it", option));
        }
    }
    if (interpolates && key_within.empty()) {
        throw Usage("--interpolate needs --key-within: how far apart two rows of REFERENCE may be");
    }
}

bool PairingOptions::is_paired(const Operands& operands) {
    if (operands.files.size() < 2) {
        return false;
    }
    if (operands.files[0] == "-" && operands.files[1] == "-") {
        throw Usage("both FILE and REFERENCE are stdin (-), which can be read only once");
    }
    return true;
}

void refuse_values(const Operands& operands, std::string_view command) {
    if (!operands.values.empty()) {
        throw Usage(fmt::format("{} reads rows, not arguments: {}", command, quoted(operands.values[0])));
    }
}

} // namespace rotconv::cli
