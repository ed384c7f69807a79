#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rotconv/conversion.hpp>

#include "../operations/operations.hpp"
#include "command.hpp"
#include "messages.hpp"

/// The options of commands that go through rows.
namespace rotconv::cli {

// What the arguments of options mean; each function throws Usage on others.

/// The value of a word that is one of the choices.
/// @throw Usage if it is not
template <class Value> Value one_of(std::string_view what, std::string_view text,
                                    const std::vector<std::pair<std::string_view, Value>>& choices) {
    std::vector<std::string_view> legal;
    for (const auto& [word, value] : choices) {
        if (word == text) {
            return value;
        }
        legal.push_back(word);
    }
    throw Usage(messages::no_such_word(what, text, legal));
}

[[nodiscard]] Spec spec_of(std::string_view option, const std::string& text, bool degrees);
/// What is wrong with canonical names, written as the list, in another order than the SPEC's; otherwise empty.
[[nodiscard]] std::string wrong_order(const Spec& spec, const std::vector<std::string_view>& names,
                                      std::string_view list);
/// Refuses a SPEC whose numbers have no rates.
void require_rates(std::string_view option, const Spec& spec);
/// An option's "SPEC: NUMBERS".
struct GivenNumbers {
    Spec spec;
    std::string_view row; ///< the numbers as they are written
    std::vector<double> numbers{};
};
/// @param text must outlive the result
[[nodiscard]] GivenNumbers numbers_of(std::string_view option, const std::string& text, bool degrees);
/// Their attitude.
[[nodiscard]] FixedRotation attitude_of(std::string_view option, const std::string& text, bool degrees,
                                        double tolerance);
/// A number that is not negative; `default_value` if the option was not given.
[[nodiscard]] double amount_of(std::string_view option, const std::string& text, double default_value, bool infinite);
/// A whole number from `least` to `most`; 0 if the option was not given.
[[nodiscard]] std::int64_t count_of(std::string_view option, const std::string& text, std::int64_t most,
                                    std::int64_t least = 1);
[[nodiscard]] Frame frame_of(const std::string& text);
/// The power of ten of the seconds in a unit of time.
[[nodiscard]] int time_power_of(const std::string& text);

// What the input says of its numbers against how they are read: names and units in a header, large angles; in
// notes.cpp.

/// How a command takes numbers, beside their SPEC.
struct ReadAs {
    bool degrees = false;    ///< -d: angular velocities too
    std::string time_unit{}; ///< empty: seconds; keys have none then
    std::string time_option = "--time-unit";
    bool refuses = true; ///< names in another order end the run, unless --columns selects
};
void add_notes(stream::InputOptions& input, const ReadAs& reading);
/// The same for an option's "SPEC: NUMBERS", which has been read; nothing for no text.
[[nodiscard]] std::optional<stream::Note> note_on(std::string_view option, const std::string& text, bool degrees);

inline constexpr int widest_row = 100'000; ///< doubles

/// How a FILE and its REFERENCE are read side by side.
struct PairingOptions {
    std::string reference_columns;
    std::string key;
    std::string reference_key;
    std::string key_within;
    std::string time_unit;
    std::string reference_time_unit;
    std::string key_offset;
    bool interpolates = false;

    void add_to(OptionSet& set, bool with_interpolation = false);
    /// @throw Usage if an option about keys was given without a key
    void check() const;
    /// There is a REFERENCE.
    /// @throw Usage if both are stdin
    [[nodiscard]] static bool is_paired(const Operands& operands);
    [[nodiscard]] bool by_key(const Operands& operands) const { return is_paired(operands) && !key.empty(); }
};

/// The columns to read of one stream, and the option that names them.
struct SelectedColumns {
    std::string list;
    std::string option = "--columns";
    std::string key{}; ///< a column before them
    std::string time_option = "--time-unit";

    [[nodiscard]] std::string all() const { return key.empty() ? list : key + "," + list; }
};

/// A command that goes through rows: where they come from, how they are read and written, and where the answer goes.
class RowOptions : public CommandOptions {
protected:
    void add_reading();
    void add_writing();
    /// Those of the above that a command without input has.
    void add_output();
    void add_format();
    /// Options are read with this tolerance, and report the sensitivity of each row if its columns are shown.
    [[nodiscard]] ConversionSettings settings() const;
    [[nodiscard]] double tolerance() const;
    [[nodiscard]] stream::OnError on_error() const;
    /// The columns of FILE: its key, if there is one, and those of one attitude, or of both if there is no REFERENCE.
    [[nodiscard]] SelectedColumns columns_of_file(const PairingOptions& pairing, const Operands& operands) const;

    /// The command of an operation that takes those numbers of a row.
    /// @throw Usage
    [[nodiscard]] RowsCommand rows_command(const SelectedColumns& selected, const stream::RowNumbers& numbers,
                                           operations::Operation operation, messages::Subject subject,
                                           const Operands& operands) const;
    /// Has the command's rows paired with those of the REFERENCE.
    /// @throw Usage
    void pair(RowsCommand& command, const PairingOptions& pairing, stream::RowNumbers numbers,
              messages::Subject subject, const Operands& operands) const;

    // NOLINTBEGIN(*-non-private-member-variables-in-classes): commands read them as they read their own
    std::string columns;
    std::string format; ///< empty: the default of the command
    std::string input_format = "csv";
    std::string width;
    bool degrees = false;
    // NOLINTEND(*-non-private-member-variables-in-classes)

private:
    [[nodiscard]] ShowDiagnostics shown_diagnostics() const;
    [[nodiscard]] stream::Digits digits() const;
    [[nodiscard]] std::size_t width_of(const stream::InputOptions& in) const;
    [[nodiscard]] stream::InputOptions input_of(const SelectedColumns& selected, stream::RowNumbers numbers,
                                                const messages::Subject& subject, bool has_values, bool refuses) const;
    /// What was given; empty if the command does not have the option.
    [[nodiscard]] std::string argument_of(std::string_view option) const;

    std::string output_ = "-";
    std::string comment_ = "#";
    std::string delimiter_;
    std::string header_ = "auto";
    std::string on_error_ = "stop";
    std::string tolerance_;
    std::string precision_;
    std::string decimals_;
    std::string diagnostics_ = "summary";
    std::string threads_;
    bool append_ = false;
    bool strict_ = false;
};

/// What is done to attitudes before they are written, and which of their numbers are.
struct AttitudeOptions {
    std::string left;
    std::string right;
    std::string reference_axes;
    std::string body_axes;
    std::string lock_margin;
    bool continuous = false;

    void add_to(OptionSet& set, bool with_continuous = true);
    void add_lock_margin_to(OptionSet& set);
    /// The settings with those of these options.
    [[nodiscard]] ConversionSettings added_to(ConversionSettings settings, bool degrees) const;
};

/// @throw Usage if there are VALUEs
void refuse_values(const Operands& operands, std::string_view command);

} // namespace rotconv::cli
