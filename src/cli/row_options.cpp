#include "row_options.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "../stream/beginning/delimiter.hpp"
#include "grammar/column_names.hpp"
#include "grammar/values.hpp"
#include "messages/answers.hpp"
#include "messages/labelled_lines.hpp"

namespace rotconv::cli {
namespace {

/// @param mends where the count is wrong
stream::ColumnList parse(const std::string& list, std::size_t count, std::string_view option, std::string_view subject,
                         const std::function<std::vector<Mend>(std::size_t count)>& mends = {}) {
    auto parsed = stream::ColumnList::parse(list, count);
    if (const auto* error = std::get_if<stream::ColumnError>(&parsed)) {
        const bool has_mends = error->what == stream::ColumnError::What::wrong_count && mends;
        throw Usage("{}: {}", option, messages::explain(*error, subject))
            .with(has_mends ? mends(error->count) : std::vector<Mend>());
    }
    return std::get<stream::ColumnList>(std::move(parsed));
}

/// The columns of one of two streams, with its key.
SelectedColumns with_key(SelectedColumns columns, const Option& option, const std::string& key) {
    if (!key.empty()) {
        static_cast<void>(parse(key, 1, option.name(), "a key"));
        columns.key = key;
    }
    return columns;
}

std::string or_else(const std::string& text, const std::string& other) { return text.empty() ? other : text; }

ShowDiagnostics shown_diagnostics_of(const Option& option) {
    return option.given() ? one_of("place for --diagnostics", option, diagnostics_places) : ShowDiagnostics::summary;
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
    if (one_of("input format", options.input_format, formats) != stream::Format::f64) {
        return 0;
    }
    if (in.columns.has_names()) {
        throw Usage("{} selects by name, but f64 rows have no names; use indices", columns_option);
    }
    const auto positions = in.columns.positions();
    const std::size_t least = positions.empty() ? needed : *std::ranges::max_element(positions) + 1;
    if (row < least || (positions.empty() && row != needed)) {
        throw Usage("rows of {} doubles (--width) where {} are {}", row, least,
                    positions.empty() ? "wanted (select with --columns)" : "the least for --columns");
    }
    return row;
}

/// How one stream is read, or the VALUEs.
stream::InputOptions input_of(const RowOptions& options, const SelectedColumns& selected, const Option& time_option,
                              stream::RowNumbers numbers, std::string_view subject, bool names_decide) {
    using stream::HeaderMode;
    stream::InputOptions in{.numbers = std::move(numbers)};
    in.header = one_of("mode of --header", options.header, header_modes);
    in.ragged = options.ragged.given();
    in.stops = options.policy() == stream::OnError::stop;
    const Option& delimiter = options.delimiter;
    in.delimiter = stream::Delimiter::parse(delimiter.text());
    if (!in.delimiter && delimiter.given()) {
        throw Usage("{} {} is neither comma, tab, semicolon or blank nor a character that can part numbers",
                    delimiter.name(), quoted(delimiter.text()));
    }
    in.are_chosen = selected.list.empty() && !selected.key.empty();
    if (!selected.list.empty()) {
        const std::size_t count = in.numbers.names.size() - (selected.key.empty() ? 0 : 1);
        const Option* const option = options.given(selected.option);
        in.columns = parse(selected.list, count, selected.option, subject, [&](std::size_t selects) {
            return option == nullptr ? std::vector<Mend>() : column_mends(options, *option, in.numbers, selects);
        });
        if (!selected.key.empty()) {
            in.columns = parse(selected.key + "," + selected.list, count + 1, selected.option, subject);
        }
    }
    const bool has_values = !options.values.empty();
    const bool headless = in.header == HeaderMode::no || in.header == HeaderMode::add;
    if (in.columns.has_names() && (headless || has_values)) {
        throw Usage("{} selects by name, but there is no header with names; use indices", selected.option);
    }
    in.width = has_values ? 0 : width_of(options, selected.option, in);
    if (in.width > 0 && in.are_chosen) {
        throw Usage("{} needs --columns, because f64 rows have no names", options.key.name());
    }
    const std::string& comment = options.comment.text();
    in.comment = has_values || comment == "none" ? "" : or_else(comment, in.comment);
    const Option& unit = time_option.given() ? time_option : options.time_unit;
    in.key_power = time_power_of(unit);
    in.numbers.has_unit = unit.given() && (&unit == &options.time_unit || unit.text() != "s"); // as ISO 8601 is
    read_names(options, time_option, names_decide, selected.key, in);
    return in;
}

/// The VALUEs; an error has the SPECs that they mean as its mends.
Values values_or_mends(const RowOptions& options, const stream::InputOptions& in) {
    try {
        return values_of(options.values, in.delimiter, in.numbers, options.from.text(), !in.columns.empty());
    } catch (Usage& error) {
        error.mends = mapped(error.specs,
                             [&](const std::string& spec) { return Mend{{OptionSet::setting(options.from, spec)}}; });
        const auto labelled = labelled_numbers(joined(options.values, " "), in.numbers);
        if (error.mends.empty() && !labelled.empty() && in.columns.empty()) {
            error.mends.push_back(options.with_values(labelled));
        }
        const bool in_degrees =
            options.degrees.given() || (in.numbers.attitude && in.numbers.attitude->unit == AngleUnit::degrees);
        if (error.mends.empty() && !in_degrees) {
            error.mends = messages::with_numbers_for_pi(options);
            error.otherwise = error.mends.empty() ? "" : "; see rotconv --help";
        }
        throw;
    }
}

} // namespace

void RowOptions::check_attitudes() const {
    for (const Option* option : all()) {
        if (option->argument == "ATTITUDE") {
            static_cast<void>(attitude_of(*option));
        }
    }
}

double RowOptions::most_defect() const {
    if (tolerance.given() && has("--within") && !stream::is_number(tolerance.text())) {
        throw Usage("{} {} is a number, how far from a rotation numbers may be; the most angle is --within",
                    tolerance.name(), quoted(tolerance.text()))
            .with({{{instead_of(tolerance, "--within", tolerance.text())}}});
    }
    return amount_of(tolerance, ConversionSettings{}.tolerance, true);
}

stream::OnError RowOptions::policy() const { return one_of("policy of --on-error", on_error, policies); }

ConversionSettings RowOptions::settings() const {
    return {.tolerance = most_defect(), .sensitivity = shown_diagnostics_of(diagnostics) == ShowDiagnostics::columns};
}

ConversionSettings RowOptions::attitude_settings() const {
    ConversionSettings all = settings();
    all.lock_margin = angle_of(lock_margin, degrees.given(), all.lock_margin);
    all.left = attitude_of(left);
    all.right = attitude_of(right);
    const auto [reference, body] = axes_of(reference_axes, body_axes);
    if (reference_axes.given()) { // L M R N' S
        all.left = all.left * reference.rotation();
    }
    if (body_axes.given()) {
        all.right = body.rotation().inverse() * all.right;
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
    time_unit.about = "Keys are times; --key-within and --key-offset are in seconds";
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

RowsCommand RowOptions::rows_command(operations::Operation operation, const std::string& subject) const {
    using stream::Format;
    const SelectedColumns selected = columns_of_file();
    const stream::RowNumbers& numbers = operation->input;
    RowsCommand command;
    command.subject = std::make_shared<messages::Subject>(messages::subject_of(numbers, most_defect()));
    command.subject->text = or_else(subject, command.subject->text);
    command.has_values = !values.empty();
    command.diagnostics = shown_diagnostics_of(diagnostics);
    command.strict = strict.given();
    command.input = or_else(file(), command.input);
    command.output = or_else(output.text(), command.output);
    command.options = {
        .input = input_of(*this, selected, time_unit, numbers, command.subject->text,
                          numbers.attitude || !numbers.second), // identify reads columns as they stand
        .operation = std::move(operation),
        .format = one_of("format", format, formats),
        .on_error = policy(),
        .digits = digits_of(*this),
        .append = append.given(),
        .diagnostic_columns = command.diagnostics == ShowDiagnostics::columns,
        .show_diagnostics = command.diagnostics != ShowDiagnostics::off,
        .threads = count_of(threads, std::size_t{1} << 20U, 1, stream::processors()),
        .describe = messages::describe,
    };
    command.notes = notes_on_options(*this);
    if (command.has_values) {
        stream::InputOptions& in = command.options.input;
        const Values given = values_or_mends(*this, in);
        in.delimiter = given.delimiter;
        std::ranges::copy(given.notes, std::back_inserter(command.notes));
        command.source = std::make_shared<stream::TextSource>(given.row);
        in.header = in.header == stream::HeaderMode::add ? in.header : stream::HeaderMode::no;
    }
    return command;
}

void RowOptions::pair(RowsCommand& command, const Spec& reference) const {
    if (!is_paired()) {
        return;
    }
    const stream::RowNumbers numbers = operations::pair_numbers(operations::attitude_numbers(reference), paired_rows());
    const bool has_own_columns = reference_columns.given();
    const SelectedColumns selected =
        with_key({.list = (has_own_columns ? reference_columns : columns).text(),
                  .option = has_own_columns ? std::string(reference_columns.name())
                                            : fmt::format("{} (of REFERENCE too)", columns.name())},
                 reference_key, key.given() ? or_else(reference_key.text(), key.text()) : "");
    stream::InputOptions& in = command.options.input;
    stream::Pairing& pairs = command.options.pairing.emplace();
    const bool names_decide = in.numbers.attitude.has_value(); // identify reads columns as they stand
    command.reference_subject = messages::subject_of(numbers, most_defect());
    pairs.reference =
        input_of(*this, selected, reference_time_unit, numbers, command.reference_subject.text, names_decide);
    pairs.by_key = key.given();
    pairs.looks_for_key = strict.given() || command.diagnostics != ShowDiagnostics::off;
    pairs.interpolates = interpolate.given();
    if (key_within.given()) {
        static_cast<void>(amount_of(key_within, 0.0, false));
        pairs.within = stream::read_distance(key_within.text());
    }
    if (key_offset.given()) {
        const stream::ReadKey offset = stream::read_key(key_offset.text());
        constexpr stream::KeyDistance limit{stream::Uint128{1} << 123U}; // about 1e19; it is added to keys below 1e20
        if (offset.error != stream::KeyError::none || distance(offset.value, {}) > limit) {
            throw Usage("{} {} must be a number of less than 1e19 in size", key_offset.name(),
                        quoted(key_offset.text()));
        }
        in.key_offset = offset.value;
    }
    command.reference = files[1];
}

void RowOptions::refuse_values(std::string_view command) const {
    if (!values.empty()) {
        throw Usage("{} reads rows, not arguments: {}", command, quoted(values[0]));
    }
}

} // namespace rotconv::cli
