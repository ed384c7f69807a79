#include "options.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <CLI/CLI.hpp>

#include "../stream/file.hpp"
#include "../stream/fmt.hpp"
#include "../stream/io_block.hpp"
#include "../stream/number_text.hpp"

namespace rotconv::cli {
namespace {

/// One row of numbers, whatever they are.
bool is_row(std::string_view text) {
    return !stream::is_blank(text) && !stream::is_comment(text) && text.find_first_of("\r\n") == std::string_view::npos;
}

ShowDiagnostics diagnostics_of(const RawOptions& texts) {
    return choose<ShowDiagnostics>("place for --diagnostics", texts.diagnostics,
                                   {{"off", ShowDiagnostics::off},
                                    {"summary", ShowDiagnostics::summary},
                                    {"rows", ShowDiagnostics::rows},
                                    {"columns", ShowDiagnostics::columns}});
}

/// The canonical names of quat, dcm, or roll, pitch and yaw, in the order in which the SPEC has them; for other SPECs
/// none.
std::vector<std::string_view> name_order(const Spec& spec) {
    if (spec.name == RepresentationId::quat || spec.name == RepresentationId::dcm) {
        const auto columns = spec.columns();
        return {columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(spec.size())};
    }
    std::vector<std::string_view> order;
    if (spec.name == RepresentationId::rpy || (spec.name == RepresentationId::euler && !spec.sequence.proper())) {
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
        first.name = RepresentationId::rpy;
        first.sequence = roll_pitch_yaw;
        second.name = RepresentationId::euler;
        second.sequence = "ZYX";
    }
    return name_order(first) == names ? first : name_order(second) == names ? std::optional(second) : std::nullopt;
}

stream::ColumnList columns_of(const RawOptions& texts, const stream::RowOperation& operation,
                              const messages::Subject& subject) {
    const auto parse = [&](const std::string& list, std::size_t count) {
        auto parsed = stream::ColumnList::parse(list, count);
        if (const auto* error = std::get_if<stream::ColumnError>(&parsed)) {
            throw Usage(fmt::format("{}: {}", texts.columns_option, messages::explain(*error, subject)));
        }
        return std::get<stream::ColumnList>(std::move(parsed));
    };
    if (texts.leading_key.empty()) {
        return parse(texts.columns, operation.inputs);
    }
    static_cast<void>(parse(texts.columns, operation.inputs - 1));
    return parse(fmt::format("{},{}", texts.leading_key, texts.columns), operation.inputs);
}

/// Canonical names in another order than the SPEC's would be a wrong attitude in silence.
void refuse_other_order(const RawOptions& texts, const stream::Options& options) {
    const auto& from = options.operation.from;
    if (!from) {
        return;
    }
    auto names = options.columns.names();
    names.erase(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(options.operation.kept)); // such as a key
    names.resize(std::min(names.size(), from->size()));
    const auto order = name_order(*from);
    if (names != order && std::ranges::is_permutation(names, order)) {
        throw Usage(fmt::format("{} {}", texts.columns_option,
                                messages::other_order(texts.columns, *from, order, spec_in_order(*from, names))));
    }
}

stream::Digits digits_of(const RawOptions& texts) {
    constexpr int most = 100;
    if (texts.decimals.empty()) {
        return {.significant = count_of("--precision", texts.precision, most)};
    }
    if (!texts.precision.empty()) {
        throw Usage("--precision and --decimals exclude each other");
    }
    return {.decimals = count_of("--decimals", texts.decimals, most, 0)};
}

/// Doubles of a binary row; 0 where the input is text.
std::size_t width_of(const RawOptions& texts, const stream::Options& options) {
    constexpr int widest = 100'000;
    const auto given = static_cast<std::size_t>(count_of("--width", texts.width, widest));
    if (!choose<bool>("input format", texts.input_format, {{"csv", false}, {"f64", true}})) {
        return 0;
    }
    const std::size_t needed = options.operation.inputs;
    const std::size_t width = given > 0 ? given : needed;
    if (options.columns.has_names()) {
        throw Usage("--columns selects by name, and f64 rows have none; use indices");
    }
    const auto positions = options.columns.positions();
    const std::size_t least = positions.empty() ? needed : *std::ranges::max_element(positions) + 1;
    if (width < least || (positions.empty() && width != needed)) {
        throw Usage(fmt::format("rows of {} doubles (--width) where {} are {}", width, least,
                                positions.empty() ? "wanted (--columns selects)" : "the least for --columns"));
    }
    return width;
}

} // namespace

void begin_group(CLI::App& app, const char* title) { app.option_defaults()->group(title); }

void define_from(CLI::App& app, RawOptions& texts) {
    begin_group(app, "What");
    app.add_option("-f,--from", texts.from, "The representation to read: NAME[:MODIFIER]...")->type_name("SPEC");
}

void define_to(CLI::App& app, RawOptions& texts) {
    begin_group(app, "What");
    app.add_option("-t,--to", texts.to, "The representation to write: NAME[:MODIFIER]...")->type_name("SPEC");
}

void define_lock_margin(CLI::App& app, RawOptions& texts) {
    begin_group(app, "Errors");
    app.add_option("--lock-margin", texts.lock_margin,
                   "Treat attitudes this near to lock as locked (radians; default 1e-15)")
        ->type_name("ANGLE");
}

void define_attitudes(CLI::App& app, RawOptions& texts) {
    begin_group(app, "What");
    app.add_option("--left", texts.left, "Other reference axes: write L R instead of R; L as \"SPEC: NUMBERS\"")
        ->type_name("ATTITUDE");
    app.add_option("--right", texts.right, "Other body axes: write R S instead of R; S as \"SPEC: NUMBERS\"")
        ->type_name("ATTITUDE");
    app.add_flag("--continuous", texts.continuous, "Let signs and angles run on from the last row, without jumps");
}

void define_input(CLI::App& app, RawOptions& texts) {
    begin_group(app, "What");
    app.add_flag("-d,--degrees", texts.degrees, "All angles are in degrees, read and written");
    begin_group(app, "Columns");
    app.add_option("--columns", texts.columns, "The columns to read: indices from 1, ranges such as 5-8, or names")
        ->type_name("LIST");
    app.add_option("--header", texts.header, "Is there a header: auto (default), yes, no, or add, to print one")
        ->type_name("MODE");
    app.add_option("--delimiter", texts.delimiter,
                   "What separates fields: a character, or comma, tab, semicolon, blank")
        ->type_name("D");
    app.add_option("-i,--input", texts.input, "Read FILE; - is standard input")->type_name("FILE");
    app.add_option("--input-format", texts.input_format, "csv (default), which is text, or f64, little-endian doubles")
        ->type_name("FORMAT");
    app.add_option("--width", texts.width, "Doubles in an f64 row of input, if more than those that are read")
        ->type_name("N");
    begin_group(app, "Output");
    app.add_option("-o,--output", texts.output, "Write FILE; - is standard output")->type_name("FILE");
    begin_group(app, "Errors");
    app.add_option("--on-error", texts.on_error, "What becomes of a row without a result: stop (default), nan, skip")
        ->type_name("POLICY");
    app.add_option("--tolerance", texts.tolerance, "How far from exact a quaternion or matrix may be (default 1e-3)")
        ->type_name("T");
}

void define_output(CLI::App& app, RawOptions& texts) {
    begin_group(app, "Output");
    app.add_flag("--append", texts.append, "Keep the whole row and add the result at its end");
    app.add_option("--format", texts.format, "csv (default), json, pretty for people, or f64, little-endian doubles")
        ->type_name("FORMAT");
    app.add_option("-p,--precision", texts.precision, "Significant digits (default: the fewest that read back equal)")
        ->type_name("N");
    app.add_option("--decimals", texts.decimals, "Digits after the decimal point, instead of --precision")
        ->type_name("N");
    begin_group(app, "Errors");
    app.add_option("--diagnostics", texts.diagnostics,
                   "Where to show diagnostics: off, summary (default), rows or columns")
        ->type_name("WHERE");
    app.add_flag("--strict", texts.strict, "Exit with 1 if there was a diagnostic other than normalized");
    begin_group(app, "More");
    app.add_option("--threads", texts.threads, "At most N threads; the output is the same for every N")->type_name("N");
}

Spec spec_of(std::string_view option, const std::string& text, bool degrees) {
    if (text.empty()) {
        throw MissingSpec(fmt::format("{} SPEC is missing; see rotconv --help", option));
    }
    const auto parsed = parse_spec(text);
    if (const auto* error = std::get_if<SpecError>(&parsed)) {
        throw Usage(fmt::format("{} {}: {}", option, messages::quoted(text), messages::explain(*error)));
    }
    const Spec& spec = std::get<Spec>(parsed);
    return degrees ? spec.in_degrees() : spec;
}

FixedRotation attitude_of(std::string_view option, const std::string& text, bool degrees, double tolerance) {
    const auto colon = text.rfind(':');
    if (colon == std::string::npos) {
        throw Usage(fmt::format("{} {} is not SPEC: NUMBERS, such as 'quat: 1 0 0 0'", option, messages::quoted(text)));
    }
    const Spec spec = spec_of(option, text.substr(0, colon), degrees);
    const std::string_view row = stream::trimmed(std::string_view(text).substr(colon + 1));
    stream::RowError error;
    error.text = row;
    const auto refuse = [&](stream::RowError::What what) {
        error.what = what;
        throw Usage(fmt::format("{}: {}", option, messages::explain(error, messages::subject_of(spec, tolerance))));
    };
    std::vector<std::string_view> fields;
    stream::Delimiter::of_row(row).split(row, fields);
    if (fields.size() != spec.size()) {
        throw Usage(fmt::format("{}: {} has {} numbers, not {}: {}", option, representation(spec.name).text,
                                spec.size(), fields.size(), messages::quoted(row)));
    }
    std::array<double, 9> numbers{};
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto number_error = stream::read_number(fields[i], numbers.at(i));
        if (number_error != stream::NumberError::none) {
            refuse(number_error == stream::NumberError::too_large ? stream::RowError::What::too_large
                                                                  : stream::RowError::What::not_a_number);
        }
    }
    std::array<double, 4> q{};
    std::vector<RowReport> reports;
    Conversion(spec, Spec{}, {.tolerance = tolerance}).run(std::span(numbers).first(spec.size()), q, reports);
    if (!reports.empty() && reports.front().error != Error::none) {
        error.error = reports.front().error;
        error.defect = reports.front().defect;
        refuse(stream::RowError::What::attitude);
    }
    return FixedRotation::of_numbers(spec, std::span(numbers).first(spec.size()));
}

double amount_of(std::string_view option, const std::string& text, double default_value, bool infinite) {
    if (text.empty()) {
        return default_value;
    }
    double value = 0.0;
    if (stream::read_number(text, value) != stream::NumberError::none || !(value >= 0.0) ||
        (std::isinf(value) && !infinite)) {
        throw Usage(fmt::format("{} {} must be a {}number that is not negative", option, messages::quoted(text),
                                infinite ? "" : "finite "));
    }
    return value;
}

int count_of(std::string_view option, const std::string& text, int most, int least) {
    if (text.empty()) {
        return 0;
    }
    double value = 0.0;
    if (stream::read_number(text, value) != stream::NumberError::none || value != std::floor(value) || value < least ||
        value > most) {
        throw Usage(
            fmt::format("{} {} must be a whole number from {} to {}", option, messages::quoted(text), least, most));
    }
    return static_cast<int>(value);
}

stream::OnError on_error_of(const RawOptions& texts) {
    return choose<stream::OnError>(
        "policy of --on-error", texts.on_error,
        {{"stop", stream::OnError::stop}, {"nan", stream::OnError::nan}, {"skip", stream::OnError::skip}});
}

ConversionSettings settings_of(const RawOptions& texts) {
    ConversionSettings settings{
        .tolerance = amount_of("--tolerance", texts.tolerance, ConversionSettings{}.tolerance, true),
        .lock_margin = amount_of("--lock-margin", texts.lock_margin, ConversionSettings{}.lock_margin, false),
        .sensitivity = diagnostics_of(texts) == ShowDiagnostics::columns};
    if (!texts.left.empty()) {
        settings.left = attitude_of("--left", texts.left, texts.degrees, settings.tolerance);
    }
    if (!texts.right.empty()) {
        settings.right = attitude_of("--right", texts.right, texts.degrees, settings.tolerance);
    }
    return settings;
}

RowsCommand rows_command(const RawOptions& texts, stream::RowOperation operation, messages::Subject subject,
                         const Operands& operands) {
    RowsCommand command(std::move(operation), std::move(subject));
    command.diagnostics = diagnostics_of(texts);
    command.strict = texts.strict;
    command.input = operands.files.empty() ? texts.input : operands.files[0];
    command.output = texts.output;
    stream::Options& options = command.options;
    const auto threads = static_cast<std::size_t>(count_of("--threads", texts.threads, 1 << 20U));
    options.threads = threads > 0 ? threads : stream::processors();
    options.append = texts.append;
    options.digits = digits_of(texts);
    options.diagnostic_columns = command.diagnostics == ShowDiagnostics::columns;
    options.show_diagnostics = command.diagnostics != ShowDiagnostics::off;
    options.describe = messages::describe;
    options.header = choose<stream::HeaderMode>("mode of --header", texts.header,
                                                {{"auto", stream::HeaderMode::automatic},
                                                 {"yes", stream::HeaderMode::yes},
                                                 {"no", stream::HeaderMode::no},
                                                 {"add", stream::HeaderMode::add}});
    options.format = choose<stream::Format>("format", texts.format.empty() ? "csv" : texts.format,
                                            {{"csv", stream::Format::csv},
                                             {"json", stream::Format::json},
                                             {"pretty", stream::Format::pretty},
                                             {"f64", stream::Format::f64}});
    options.on_error = on_error_of(texts);
    if (!texts.delimiter.empty()) {
        options.delimiter = stream::Delimiter::parse(texts.delimiter);
        if (!options.delimiter) {
            throw Usage(fmt::format(
                "--delimiter {} is neither comma, tab, semicolon or blank nor a character that can part numbers",
                messages::quoted(texts.delimiter)));
        }
    }
    if (!texts.columns.empty()) {
        options.columns = columns_of(texts, options.operation, command.subject);
        refuse_other_order(texts, options);
    }
    const bool headless = options.header == stream::HeaderMode::no || options.header == stream::HeaderMode::add;
    if (options.columns.has_names() && (headless || !operands.values.empty())) {
        throw Usage("--columns selects by name, and there is no header to look in; use indices");
    }
    options.width = operands.values.empty() ? width_of(texts, options) : 0;
    if (!operands.values.empty()) {
        command.has_values = true;
        command.values = fmt::format("{}", fmt::join(operands.values, " "));
        if (!is_row(command.values)) {
            throw Usage(fmt::format("the VALUEs are no row of numbers: {}", messages::quoted(command.values)));
        }
        if (operands.values.size() > 1) {
            options.delimiter = stream::Delimiter::blanks();
        }
        if (options.header != stream::HeaderMode::add) {
            options.header = stream::HeaderMode::no;
        }
    }
    return command;
}

} // namespace rotconv::cli
