#pragma once

#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rotconv/conversion.hpp>

#include "../stream/row_operation.hpp"
#include "command_line.hpp"
#include "messages.hpp"

namespace CLI {
class App;
}

/// The options that commands share: their text, and what it means.
namespace rotconv::cli {

/// What the options say, as text: CLI11 reads it, and the functions below check it.
struct RawOptions {
    std::string from;
    std::string to;
    std::string input = "-";
    std::string output = "-";
    std::string input_format = "csv";
    std::string width;
    std::string columns;
    std::string columns_option = "--columns"; ///< that gave them
    std::string leading_key;                  ///< a column before them
    std::string delimiter;
    std::string header = "auto";
    std::string format; ///< empty: the command's own
    std::string on_error = "stop";
    std::string diagnostics = "summary";
    std::string precision;
    std::string decimals;
    std::string tolerance;
    std::string lock_margin;
    std::string threads;
    std::string method = "default";
    std::vector<std::string> listed;
    std::string frame = "body";
    std::string initial;
    std::string left;
    std::string right;
    std::string with = "quat";
    std::string integrator;
    std::string substeps;
    std::string interpolation = "linear";
    std::string time_unit = "s";
    std::string condition;
    std::string within;
    std::string reference_columns;
    std::string key;
    std::string reference_key;
    std::string key_within;
    std::string relative;
    bool degrees = false;
    bool append = false;
    bool continuous = false;
    bool strict = false;
    bool inverse = false;
    bool differences = false;
    bool renormalise = false;
};

/// What stands on the command line beside the options.
struct Operands {
    std::vector<std::string> values;
    std::vector<std::string> files;
};

/// Thrown while the command line is read, with words for the user.
class Usage : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The same, where a SPEC is not given.
class MissingSpec : public Usage {
    using Usage::Usage;
};

/// Under which title of the help the options that follow stand.
void begin_group(CLI::App& app, const char* title);

void define_from(CLI::App& app, RawOptions& texts);
void define_to(CLI::App& app, RawOptions& texts);
void define_lock_margin(CLI::App& app, RawOptions& texts);
/// What is done to attitudes before they are written, and which of their numbers are.
void define_attitudes(CLI::App& app, RawOptions& texts);
/// Where rows come from, how they are read, and where the answer goes.
void define_input(CLI::App& app, RawOptions& texts);
/// How rows are written.
void define_output(CLI::App& app, RawOptions& texts);

template <class Value> Value choose(std::string_view what, std::string_view text,
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
/// The attitude of "SPEC: NUMBERS".
[[nodiscard]] FixedRotation attitude_of(std::string_view option, const std::string& text, bool degrees,
                                        double tolerance);
/// A number that is not negative; `default_value` where the option was not given.
[[nodiscard]] double amount_of(std::string_view option, const std::string& text, double default_value, bool infinite);
/// A whole number from `least` to `most`; 0 where the option was not given.
[[nodiscard]] int count_of(std::string_view option, const std::string& text, int most, int least = 1);
[[nodiscard]] stream::OnError on_error_of(const RawOptions& texts);
/// Tolerance, lock margin, turns, and figures where they are to be shown.
[[nodiscard]] ConversionSettings settings_of(const RawOptions& texts);

/// The command of a row operation.
/// @throw Usage
[[nodiscard]] RowsCommand rows_command(const RawOptions& texts, stream::RowOperation operation,
                                       messages::Subject subject, const Operands& operands);

} // namespace rotconv::cli
