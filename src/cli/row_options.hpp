#pragma once

#include <string>

#include <rotconv/conversion.hpp>

#include "../operations/operations.hpp"
#include "command.hpp"

/// The options that commands share which go through rows.
namespace rotconv::cli {

/// Where rows come from, how they are read, and where the answer goes.
struct ReadingOptions {
    std::string input; ///< empty: stdin
    std::string output = "-";
    std::string input_format = "csv";
    std::string width;
    std::string columns;
    std::string delimiter;
    std::string header = "auto";
    std::string on_error = "stop";
    std::string tolerance;
    bool degrees = false;

    void add_to(OptionSet& set);
    [[nodiscard]] stream::OnError on_error_policy() const;
    /// See ConversionSettings.
    [[nodiscard]] double greatest_defect() const;
};

/// How rows are written.
struct WritingOptions {
    std::string format; ///< empty: csv, or the command's own
    std::string precision;
    std::string decimals;
    std::string diagnostics = "summary";
    std::string threads;
    bool append = false;
    bool strict = false;

    void add_to(OptionSet& set);
    [[nodiscard]] ShowDiagnostics shown_diagnostics() const;
    [[nodiscard]] stream::Digits digits() const;
};

/// What is done to attitudes before they are written, and which of their numbers are.
struct AttitudeOptions {
    std::string left;
    std::string right;
    std::string lock_margin;
    bool continuous = false;

    void add_to(OptionSet& set);
    void add_lock_margin_to(OptionSet& set);
    [[nodiscard]] ConversionSettings settings(const ReadingOptions& reading, const WritingOptions& writing) const;
};

/// How a FILE and its REFERENCE are read side by side.
struct PairingOptions {
    std::string reference_columns;
    std::string key;
    std::string reference_key;
    std::string key_within;

    void add_to(OptionSet& set);
    /// There is a REFERENCE.
    /// @throw Usage where both are stdin
    [[nodiscard]] static bool is_paired(const Operands& operands);
    [[nodiscard]] bool by_key(const Operands& operands) const { return is_paired(operands) && !key.empty(); }
};

/// Which columns of a stream are read, by which option.
struct ChosenColumns {
    std::string list;
    std::string option = "--columns";
    std::string key{}; ///< a column before them

    [[nodiscard]] std::string all() const { return key.empty() ? list : key + "," + list; }
};

/// Of the FILE: with the key, where there is one, as the first; or where the rows hold both attitudes, those of both.
[[nodiscard]] ChosenColumns file_columns(const ReadingOptions& reading, const PairingOptions& pairing,
                                         const Operands& operands);

/// The command of an operation that takes those numbers of a row.
/// @throw Usage
[[nodiscard]] RowsCommand rows_command(const ReadingOptions& reading, const WritingOptions& writing,
                                       const ChosenColumns& columns, stream::RowNumbers numbers,
                                       operations::Operation operation, messages::Subject subject,
                                       const Operands& operands);

inline constexpr int widest_row = 100'000; ///< doubles

/// Has the command's rows paired with those of the REFERENCE.
/// @throw Usage
void pair(RowsCommand& command, const ReadingOptions& reading, const PairingOptions& pairing,
          stream::RowNumbers numbers, messages::Subject subject, const Operands& operands);

/// @throw Usage where there are VALUEs
void refuse_values(const Operands& operands, std::string_view command);

} // namespace rotconv::cli
