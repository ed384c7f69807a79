#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rotconv/conversion.hpp>

#include "../operations/operations.hpp"
#include "command.hpp"
#include "grammar/arguments.hpp"

/// The options of commands that go through rows.
namespace rotconv::cli {

inline constexpr std::size_t widest_row = 100'000; ///< doubles

// What words are as arguments. A command may take only some of them: see Option::choices.
// NOLINTBEGIN(cert-err58-cpp): without memory nothing works
inline const Choices<stream::Format> formats{{"csv", stream::Format::csv},
                                             {"json", stream::Format::json},
                                             {"pretty", stream::Format::pretty},
                                             {"f64", stream::Format::f64}};
inline const Choices<stream::HeaderMode> header_modes{{"auto", stream::HeaderMode::automatic},
                                                      {"yes", stream::HeaderMode::yes},
                                                      {"no", stream::HeaderMode::no},
                                                      {"add", stream::HeaderMode::add}};
inline const Choices<stream::OnError> policies{
    {"stop", stream::OnError::stop}, {"nan", stream::OnError::nan}, {"skip", stream::OnError::skip}};
inline const Choices<ShowDiagnostics> diagnostics_places{{"off", ShowDiagnostics::off},
                                                         {"summary", ShowDiagnostics::summary},
                                                         {"rows", ShowDiagnostics::rows},
                                                         {"columns", ShowDiagnostics::columns}};
/// Pairs of axes that are often met.
inline const std::vector<std::string_view> usual_axes{"ned:enu", "enu:ned", "frd:flu", "flu:frd",
                                                      "rdf:rub", "rdf:flu", "ruf:flu", "fru:flu"};
// NOLINTEND(cert-err58-cpp)

/// The columns to read of one stream.
struct SelectedColumns {
    std::string list{};
    std::string option{}; ///< which names them
    std::string key{};    ///< a column before them
};

/// The options that several commands have: where rows come from, how they are read, paired and written, what is done to
/// attitudes before that, and where results go. A command has those that it adds; the others are never given.
struct RowOptions : CommandOptions {
    Option from{"-f,--from", "SPEC", "The representation to read: NAME[:MODIFIER]..."};
    Option to{"-t,--to", "SPEC", "The representation to write: NAME[:MODIFIER]..."};
    Option degrees{"-d,--degrees", "", "All angles are in degrees, read and written"};
    Option columns{"--columns", "LIST", "The columns to read: indices from 1, ranges such as 5-8, or names"};
    Option header{"--header", "MODE", "Header of the input: auto (default), yes, no, or add (none; print one)",
                  words_of(header_modes)};
    Option comment{"--comment", "PREFIX", "What comments begin with (default #); none: there are none"};
    Option ragged{"--ragged", "", "Take rows of any number of fields that have the columns"};
    Option delimiter{"--delimiter",
                     "D",
                     "What separates fields: a character, or comma, tab, semicolon, blank",
                     {"comma", "tab", "semicolon", "blank"}};
    Option input_format{
        "--input-format", "FORMAT", "csv (default), which is text, or f64, little-endian doubles", {"csv", "f64"}};
    Option width{"--width", "N", "Doubles in an f64 row of input, if more than those that are read"};
    Option on_error{"--on-error", "POLICY", "What to do with a row that has no result: stop (default), nan, skip",
                    words_of(policies)};
    Option tolerance{"--tolerance", "T", "How far from exact a quaternion or matrix may be (default 1e-3)"};
    Option output{"-o,--output", "FILE", "Write FILE; - is standard output"};
    Option format{"--format", "FORMAT", "csv (default), json, pretty for people, or f64, little-endian doubles",
                  words_of(formats)};
    Option precision{"-p,--precision", "N", "Significant digits (default: the fewest that read back equal)"};
    Option decimals{"--decimals", "N", "Digits after the decimal point, instead of --precision"};
    Option threads{"--threads", "N", "At most N threads; the output is the same for every N"};
    Option append{"--append", "", "Keep the whole row and add the result at its end"};
    Option diagnostics{"--diagnostics", "WHERE", "Where to show diagnostics: off, summary (default), rows or columns",
                       words_of(diagnostics_places)};
    Option strict{"--strict", "", "Exit with 1 after notes or diagnostics except normalized, large-angle"};
    Option continuous{"--continuous", "", "Write the numbers nearest to the last result, so that they do not jump"};
    Option lock_margin{"--lock-margin", "ANGLE", "Treat attitudes this near gimbal lock as locked (default 1e-15rad)"};
    Option time_unit{"--time-unit", "UNIT", "Unit of the times: s (default), ms, us or ns", words_of(time_units)};

    // What is done to attitudes before they are written.
    Option reference_axes{"--reference-axes", "FROM:TO", "Other reference axes, such as ned:enu, by their names",
                          usual_axes};
    Option body_axes{"--body-axes", "FROM:TO", "Other body axes, such as frd:flu (cameras: rdf:rub), by their names",
                     usual_axes};
    Option left{"--left", "ATTITUDE", "Other reference axes: write L R instead of R; L as \"SPEC: NUMBERS\""};
    Option right{"--right", "ATTITUDE", "Other body axes: write R S instead of R; S as \"SPEC: NUMBERS\""};
    Option initial{"--initial", "ATTITUDE", "The attitude at the first row, as \"SPEC: NUMBERS\""};

    // How a FILE and its REFERENCE are read side by side.
    Option reference_columns{"--reference-columns", "LIST",
                             "The columns to read in REFERENCE (default: those of --columns)"};
    Option key{"--key", "COLUMN", "Pair rows by the key in this column, such as time, instead of in order"};
    Option reference_key{"--reference-key", "COLUMN", "The column of the key in REFERENCE (default: that of --key)"};
    Option key_within{"--key-within", "T", "The largest difference between the keys of a pair (default 0)"};
    Option key_offset{"--key-offset", "T", "Add T to the keys of FILE"};
    Option reference_time_unit{"--reference-time-unit", "UNIT", "Unit of REFERENCE's keys (default: the same)",
                               words_of(time_units)};
    Option interpolate{"--interpolate", "", "Take the reference at FILE's key, between two rows --key-within apart"};

    void add_reading();
    void add_writing();
    void add_attitudes() { add("What", {&reference_axes, &body_axes, &left, &right}); }
    /// The same where only FILE's attitudes are changed.
    void add_attitudes_of_file(std::string_view about_left, std::string_view about_right);
    void add_pairing();

    void check_attitudes() const override;

    [[nodiscard]] Spec spec_of(const Option& option) const { return cli::spec_of(option, degrees.given()); }
    /// The identity if the option is not given.
    [[nodiscard]] FixedRotation attitude_of(const Option& option) const {
        return cli::attitude_of(option, degrees.given(), most_defect());
    }
    [[nodiscard]] double most_defect() const;
    [[nodiscard]] stream::OnError policy() const;
    /// With the sensitivity of each row if its columns are shown.
    [[nodiscard]] ConversionSettings settings() const;
    /// The same with what is done to attitudes before they are written.
    [[nodiscard]] ConversionSettings attitude_settings() const;

    /// There is a REFERENCE.
    [[nodiscard]] bool is_paired() const { return files.size() == 2; }
    [[nodiscard]] operations::PairedRows paired_rows() const {
        return {is_paired(), is_paired() && key.given(), is_paired() && interpolate.given()};
    }

    /// The columns of FILE: its key, if there is one, and those of one attitude, or of both if there is no REFERENCE.
    /// @throw Usage if an option about keys is given without a key
    [[nodiscard]] SelectedColumns columns_of_file() const;
    /// @param subject what the rows are in messages; empty: their attitudes
    /// @throw Usage
    [[nodiscard]] RowsCommand rows_command(operations::Operation operation, const std::string& subject = {}) const;
    /// Has the command's rows paired with the attitudes of the REFERENCE, if there is one.
    /// @throw Usage
    void pair(RowsCommand& command, const Spec& reference) const;

    /// @throw Usage if there are VALUEs
    void refuse_values(std::string_view command) const;
};

/// The options that take the axes of one project to those of another, in notes.cpp; empty where they are the same.
[[nodiscard]] std::string change_of_axes(const Project& from, const Project& to);

/// Has the input tell what its header says against how its numbers are read, by names and units; in notes.cpp.
/// @param time_option which names the unit of its times
/// @param names_decide numbers are what their names say, unless their columns are selected by index
/// @param key the column of the key, if its name or index is given and no other column is
void read_names(const RowOptions& options, const Option& time_option, bool names_decide, const std::string& key,
                stream::InputOptions& input);

/// The same for options that are "SPEC: NUMBERS".
[[nodiscard]] std::vector<stream::Note> notes_on_options(const RowOptions& options);
/// That --from and --to, as they are given, have different axes; nothing where an option changes axes.
[[nodiscard]] std::optional<stream::Note> note_on_axes(const OptionSet& options);

} // namespace rotconv::cli
