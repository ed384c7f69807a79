#include "pairing.hpp"

#include <memory>
#include <utility>

#include <CLI/CLI.hpp>

#include "../stream/fmt.hpp"

namespace rotconv::cli {
namespace {

/// The same options for one of the two streams.
RawOptions with_columns(const RawOptions& texts, std::string_view key_option, const std::string& key,
                        const std::string& columns) {
    RawOptions side = texts;
    side.columns = columns;
    if (texts.key.empty()) {
        return side;
    }
    const auto parsed = stream::ColumnList::parse(key, 1);
    if (const auto* error = std::get_if<stream::ColumnError>(&parsed)) {
        throw Usage(fmt::format("{}: {}", key_option, messages::explain(*error, {.text = "a key", .count = 1})));
    }
    if (columns.empty()) {
        throw Usage(fmt::format("{} awaits --columns, for a row of numbers alone has no key", key_option));
    }
    side.leading_key = key;
    return side;
}

const std::string& or_else(const std::string& text, const std::string& other) { return text.empty() ? other : text; }

} // namespace

void define_pairing(CLI::App& app, RawOptions& texts) {
    begin_group(app, "Columns");
    app.add_option("--reference-columns", texts.reference_columns,
                   "The columns to read in REFERENCE (default: those of --columns)")
        ->type_name("LIST");
    app.add_option("--key", texts.key, "Pair rows by the key in this column, such as a time, not by number")
        ->type_name("COLUMN");
    app.add_option("--reference-key", texts.reference_key,
                   "The column of the key in REFERENCE (default: that of --key)")
        ->type_name("COLUMN");
    app.add_option("--key-within", texts.key_within, "By how much the keys of a pair may differ (default 0)")
        ->type_name("T");
}

bool is_paired(const Operands& operands) {
    if (operands.files.size() < 2) {
        return false;
    }
    if (operands.files[0] == "-" && operands.files[1] == "-") {
        throw Usage("both FILE and REFERENCE are stdin (-), which can be read once");
    }
    return true;
}

RawOptions file_options(const RawOptions& texts, bool paired) {
    if (paired) {
        return with_columns(texts, "--key", texts.key, texts.columns);
    }
    RawOptions both = texts;
    if (!texts.columns.empty() && !texts.reference_columns.empty()) {
        both.columns += "," + texts.reference_columns;
    }
    return both;
}

void pair(RowsCommand& command, const RawOptions& texts, const Operands& operands, stream::RowOperation operation,
          messages::Subject subject) {
    RawOptions input = with_columns(texts, "--reference-key", or_else(texts.reference_key, texts.key),
                                    or_else(texts.reference_columns, texts.columns));
    input.columns_option = texts.reference_columns.empty() ? "--columns (of REFERENCE too)" : "--reference-columns";
    input.format.clear();
    RowsCommand reading = rows_command(input, std::move(operation), subject, {});
    reading.options.format = stream::Format::result;
    stream::Pairing pairing{.reference = std::move(reading.options), .by_key = !texts.key.empty()};
    if (!texts.key_within.empty()) {
        static_cast<void>(amount_of("--key-within", texts.key_within, 0.0, false));
        pairing.within = *stream::Decimal::parse(texts.key_within);
    }
    command.reference = operands.files[1];
    command.reference_subject = std::move(subject);
    command.options.pairing = std::make_shared<const stream::Pairing>(std::move(pairing));
}

} // namespace rotconv::cli
