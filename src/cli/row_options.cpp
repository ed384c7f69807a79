#include "row_options.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "../stream/fmt.hpp"
#include "../stream/io_block.hpp"
#include "../stream/number_text.hpp"
#include "options.hpp"

namespace rotconv::cli {
namespace {

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

/// Canonical names in another order than the SPEC's would be a wrong attitude in silence.
void refuse_other_order(const ChosenColumns& columns, const stream::InputOptions& input) {
    const auto& spec = input.numbers.attitude;
    if (!spec) {
        return;
    }
    auto names = input.columns.names();
    names.erase(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(input.numbers.kept)); // such as a key
    names.resize(std::min(names.size(), spec->size()));
    const auto order = name_order(*spec);
    if (names != order && std::ranges::is_permutation(names, order)) {
        throw Usage(fmt::format("{} {}", columns.option,
                                messages::other_order(columns.list, *spec, order, spec_in_order(*spec, names))));
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
ChosenColumns with_key(ChosenColumns columns, std::string_view key_option, const std::string& key) {
    if (!key.empty()) {
        static_cast<void>(parse(key, 1, key_option, {.text = "a key", .count = 1}));
        if (columns.list.empty()) {
            throw Usage(fmt::format("{} awaits --columns, for a row of numbers alone has no key", key_option));
        }
        columns.key = key;
    }
    return columns;
}

const std::string& or_else(const std::string& text, const std::string& other) { return text.empty() ? other : text; }

/// Doubles of a binary row; 0 where the input is text.
std::size_t width_of(const ReadingOptions& reading, const stream::InputOptions& input) {
    const auto given = static_cast<std::size_t>(count_of("--width", reading.width, widest_row));
    if (!choose<bool>("input format", reading.input_format, {{"csv", false}, {"f64", true}})) {
        return 0;
    }
    const std::size_t needed = input.numbers.names.size();
    const std::size_t width = given > 0 ? given : needed;
    if (input.columns.has_names()) {
        throw Usage("--columns selects by name, and f64 rows have none; use indices");
    }
    const auto positions = input.columns.positions();
    const std::size_t least = positions.empty() ? needed : *std::ranges::max_element(positions) + 1;
    if (width < least || (positions.empty() && width != needed)) {
        throw Usage(fmt::format("rows of {} doubles (--width) where {} are {}", width, least,
                                positions.empty() ? "wanted (--columns selects)" : "the least for --columns"));
    }
    return width;
}

/// How one stream is read, or the VALUEs.
stream::InputOptions input_of(const ReadingOptions& reading, const ChosenColumns& columns, stream::RowNumbers numbers,
                              const messages::Subject& subject, bool has_values) {
    stream::InputOptions input{.numbers = std::move(numbers)};
    input.header = choose<stream::HeaderMode>("mode of --header", reading.header,
                                              {{"auto", stream::HeaderMode::automatic},
                                               {"yes", stream::HeaderMode::yes},
                                               {"no", stream::HeaderMode::no},
                                               {"add", stream::HeaderMode::add}});
    input.refuses_json =
        input.header == stream::HeaderMode::automatic && reading.on_error_policy() == stream::OnError::stop;
    if (!reading.delimiter.empty()) {
        input.delimiter = stream::Delimiter::parse(reading.delimiter);
        if (!input.delimiter) {
            throw Usage(fmt::format(
                "--delimiter {} is neither comma, tab, semicolon or blank nor a character that can part numbers",
                quoted(reading.delimiter)));
        }
    }
    if (!columns.list.empty()) {
        const std::size_t count = input.numbers.names.size();
        static_cast<void>(
            parse(columns.list, count - (columns.key.empty() ? 0 : 1), columns.option, subject)); // for its message
        input.columns = parse(columns.all(), count, columns.option, subject);
        refuse_other_order(columns, input);
    }
    const bool headless = input.header == stream::HeaderMode::no || input.header == stream::HeaderMode::add;
    if (input.columns.has_names() && (headless || has_values)) {
        throw Usage("--columns selects by name, and there is no header to look in; use indices");
    }
    input.width = has_values ? 0 : width_of(reading, input);
    return input;
}

/// One row of numbers, whatever they are.
bool is_row(std::string_view text) {
    return !stream::is_blank(text) && !stream::is_comment(text) && text.find_first_of("\r\n") == std::string_view::npos;
}

} // namespace

void ReadingOptions::add_to(OptionSet& set) {
    set.begin_group("What");
    set.add("-d,--degrees", degrees, "All angles are in degrees, read and written");
    set.begin_group("Columns");
    set.add("--columns", columns, "LIST", "The columns to read: indices from 1, ranges such as 5-8, or names");
    set.add("--header", header, "MODE", "Is there a header: auto (default), yes, no, or add, to print one");
    set.add("--delimiter", delimiter, "D", "What separates fields: a character, or comma, tab, semicolon, blank");
    set.add("-i,--input", input, "FILE", "Read FILE; - is standard input");
    set.add("--input-format", input_format, "FORMAT", "csv (default), which is text, or f64, little-endian doubles");
    set.add("--width", width, "N", "Doubles in an f64 row of input, if more than those that are read");
    set.begin_group("Output");
    set.add("-o,--output", output, "FILE", "Write FILE; - is standard output");
    set.begin_group("Errors");
    set.add("--on-error", on_error, "POLICY", "What becomes of a row without a result: stop (default), nan, skip");
    set.add("--tolerance", tolerance, "T", "How far from exact a quaternion or matrix may be (default 1e-3)");
}

stream::OnError ReadingOptions::on_error_policy() const {
    return choose<stream::OnError>(
        "policy of --on-error", on_error,
        {{"stop", stream::OnError::stop}, {"nan", stream::OnError::nan}, {"skip", stream::OnError::skip}});
}

double ReadingOptions::greatest_defect() const {
    return amount_of("--tolerance", tolerance, ConversionSettings{}.tolerance, true);
}

void WritingOptions::add_to(OptionSet& set) {
    set.begin_group("Output");
    set.add("--append", append, "Keep the whole row and add the result at its end");
    set.add("--format", format, "FORMAT", "csv (default), json, pretty for people, or f64, little-endian doubles");
    set.add("-p,--precision", precision, "N", "Significant digits (default: the fewest that read back equal)");
    set.add("--decimals", decimals, "N", "Digits after the decimal point, instead of --precision");
    set.begin_group("Errors");
    set.add("--diagnostics", diagnostics, "WHERE",
            "Where to show diagnostics: off, summary (default), rows or columns");
    set.add("--strict", strict, "Exit with 1 if there was a diagnostic other than normalized");
    set.begin_group("More");
    set.add("--threads", threads, "N", "At most N threads; the output is the same for every N");
}

ShowDiagnostics WritingOptions::shown_diagnostics() const {
    return choose<ShowDiagnostics>("place for --diagnostics", diagnostics,
                                   {{"off", ShowDiagnostics::off},
                                    {"summary", ShowDiagnostics::summary},
                                    {"rows", ShowDiagnostics::rows},
                                    {"columns", ShowDiagnostics::columns}});
}

stream::Digits WritingOptions::digits() const {
    constexpr int most = 100;
    if (decimals.empty()) {
        return {.significant = count_of("--precision", precision, most)};
    }
    if (!precision.empty()) {
        throw Usage("--precision and --decimals exclude each other");
    }
    return {.decimals = count_of("--decimals", decimals, most, 0)};
}

void AttitudeOptions::add_to(OptionSet& set) {
    set.begin_group("What");
    set.add("--left", left, "ATTITUDE", "Other reference axes: write L R instead of R; L as \"SPEC: NUMBERS\"");
    set.add("--right", right, "ATTITUDE", "Other body axes: write R S instead of R; S as \"SPEC: NUMBERS\"");
    set.add("--continuous", continuous, "Let signs and angles run on from the last row, without jumps");
}

void AttitudeOptions::add_lock_margin_to(OptionSet& set) {
    set.begin_group("Errors");
    set.add("--lock-margin", lock_margin, "ANGLE",
            "Treat attitudes this near to lock as locked (radians; default 1e-15)");
}

ConversionSettings AttitudeOptions::settings(const ReadingOptions& reading, const WritingOptions& writing) const {
    ConversionSettings settings{.tolerance = reading.greatest_defect(),
                                .lock_margin =
                                    amount_of("--lock-margin", lock_margin, ConversionSettings{}.lock_margin, false),
                                .sensitivity = writing.shown_diagnostics() == ShowDiagnostics::columns};
    if (!left.empty()) {
        settings.left = attitude_of("--left", left, reading.degrees, settings.tolerance);
    }
    if (!right.empty()) {
        settings.right = attitude_of("--right", right, reading.degrees, settings.tolerance);
    }
    return settings;
}

void PairingOptions::add_to(OptionSet& set) {
    set.begin_group("Columns");
    set.add("--reference-columns", reference_columns, "LIST",
            "The columns to read in REFERENCE (default: those of --columns)");
    set.add("--key", key, "COLUMN", "Pair rows by the key in this column, such as a time, not by number");
    set.add("--reference-key", reference_key, "COLUMN", "The column of the key in REFERENCE (default: that of --key)");
    set.add("--key-within", key_within, "T", "By how much the keys of a pair may differ (default 0)");
}

bool PairingOptions::is_paired(const Operands& operands) {
    if (operands.files.size() < 2) {
        return false;
    }
    if (operands.files[0] == "-" && operands.files[1] == "-") {
        throw Usage("both FILE and REFERENCE are stdin (-), which can be read once");
    }
    return true;
}

ChosenColumns file_columns(const ReadingOptions& reading, const PairingOptions& pairing, const Operands& operands) {
    ChosenColumns columns{.list = reading.columns};
    if (PairingOptions::is_paired(operands)) {
        return with_key(columns, "--key", pairing.key);
    }
    if (!reading.columns.empty() && !pairing.reference_columns.empty()) {
        columns.list += "," + pairing.reference_columns;
    }
    return columns;
}

RowsCommand rows_command(const ReadingOptions& reading, const WritingOptions& writing, const ChosenColumns& columns,
                         stream::RowNumbers numbers, operations::Operation operation, messages::Subject subject,
                         const Operands& operands) {
    const bool has_values = !operands.values.empty();
    RowsCommand command;
    command.diagnostics = writing.shown_diagnostics();
    command.strict = writing.strict;
    command.input = operands.files.empty() ? or_else(reading.input, command.input) : operands.files[0];
    command.output = reading.output;
    const auto threads = static_cast<std::size_t>(count_of("--threads", writing.threads, 1 << 20U));
    command.options = {
        .input = input_of(reading, columns, std::move(numbers), subject, has_values),
        .operation = std::move(operation),
        .format = choose<stream::Format>("format", writing.format.empty() ? "csv" : writing.format,
                                         {{"csv", stream::Format::csv},
                                          {"json", stream::Format::json},
                                          {"pretty", stream::Format::pretty},
                                          {"f64", stream::Format::f64}}),
        .on_error = reading.on_error_policy(),
        .digits = writing.digits(),
        .append = writing.append,
        .diagnostic_columns = command.diagnostics == ShowDiagnostics::columns,
        .show_diagnostics = command.diagnostics != ShowDiagnostics::off,
        .threads = threads > 0 ? threads : stream::processors(),
        .describe = messages::describe,
    };
    command.subject = std::make_shared<messages::Subject>(std::move(subject));
    if (has_values) {
        command.has_values = true;
        command.values = fmt::format("{}", fmt::join(operands.values, " "));
        if (!is_row(command.values)) {
            throw Usage(fmt::format("the VALUEs are no row of numbers: {}", quoted(command.values)));
        }
        stream::InputOptions& input = command.options.input;
        if (operands.values.size() > 1) {
            input.delimiter = stream::Delimiter::blanks();
        }
        if (input.header != stream::HeaderMode::add) {
            input.header = stream::HeaderMode::no;
        }
    }
    return command;
}

void pair(RowsCommand& command, const ReadingOptions& reading, const PairingOptions& pairing,
          stream::RowNumbers numbers, messages::Subject subject, const Operands& operands) {
    const bool has_own = !pairing.reference_columns.empty();
    const ChosenColumns columns =
        with_key({.list = or_else(pairing.reference_columns, reading.columns),
                  .option = has_own ? "--reference-columns" : "--columns (of REFERENCE too)"},
                 "--reference-key", pairing.key.empty() ? "" : or_else(pairing.reference_key, pairing.key));
    stream::Pairing& pairs = command.options.pairing.emplace();
    pairs.reference = input_of(reading, columns, std::move(numbers), subject, false);
    pairs.by_key = !pairing.key.empty();
    if (!pairing.key_within.empty()) {
        static_cast<void>(amount_of("--key-within", pairing.key_within, 0.0, false));
        pairs.within = *stream::Decimal::parse(pairing.key_within);
    }
    command.reference = operands.files[1];
    command.reference_subject = std::move(subject);
}

void refuse_values(const Operands& operands, std::string_view command) {
    if (!operands.values.empty()) {
        throw Usage(fmt::format("{} reads rows, not arguments: {}", command, quoted(operands.values[0])));
    }
}

} // namespace rotconv::cli
