#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../command.hpp"

/// What is answered where a command is wrong: the whole command, mended. One mend follows the other until nothing is
/// wrong any more; two that a mistake has are two answers.
namespace rotconv::cli {

/// The most bytes of an input on which a command is tried: the first.
inline constexpr std::size_t most_first_bytes = std::size_t{64} << 10U;

/// Lines `try: rotconv ...`, at most two, of commands that can be read, and that answer the first rows where these are
/// at hand.
/// @param beginning the first bytes of the input; nothing: those of the FILE, if it is one that can be read again
[[nodiscard]] std::string answers(const std::vector<std::string>& words,
                                  std::optional<std::string_view> beginning = {});

/// What a word begins with that is not to be quoted, and is no file before a shell has read it.
inline constexpr std::string_view raw_word = "\x01";

/// The words as the one of the mends makes them that alone answers the first rows; nothing where several do, or none.
[[nodiscard]] std::optional<std::vector<std::string>> only_answer(const std::vector<std::string>& words,
                                                                  const std::vector<Mend>& mends);

/// The options that take the axes of one SPEC, of a project or a convention such as ned, to those of the other.
[[nodiscard]] std::vector<std::string> axes_of_specs(const std::string& from, const std::string& to);

/// A command without a SPEC: what its numbers or its file have, and the SPECs that may be meant.
[[nodiscard]] Usage missing_spec(const CommandOptions& options, const MissingSpec& error);

/// Whether numbers are so near to a rotation that a larger tolerance may be meant.
[[nodiscard]] bool may_be_tolerated(const CommandOptions& options, const stream::RowError& error);

/// The end of the message on a row that cannot be read, and the answers.
[[nodiscard]] std::string end_of_message(const RowsCommand& command, std::string_view beginning);

/// Mends of --columns, or --reference-columns, which selects `count` columns, not as many as a row has numbers: names
/// in ranges, names of other numbers beside them, a time that is missing.
[[nodiscard]] std::vector<Mend> column_mends(const CommandOptions& options, const Option& option,
                                             const stream::RowNumbers& numbers, std::size_t count);

/// The first bytes of a file that can be read again; nothing for others.
[[nodiscard]] std::optional<std::string> first_bytes(const std::string& path);

/// Rows that a filter of lines may lengthen.
struct SimpleRows {
    std::string mark;               ///< between fields
    std::vector<std::string> names; ///< of a header

    [[nodiscard]] bool has_header() const noexcept { return !names.empty(); }
};
/// Nothing for a text with quotes, carriage returns or a byte order mark.
[[nodiscard]] std::optional<SimpleRows> simple_rows(std::string_view text);
/// Where numbers begin among fields that may be a rotation by the sum of their squares: a quaternion, or a matrix.
[[nodiscard]] std::vector<std::size_t> rotation_places(const std::vector<std::string_view>& fields, const Spec& spec);

/// What a filter makes of a text, line by line from 0 on.
[[nodiscard]] std::string
filtered_lines(std::string_view text,
               const std::function<std::string(std::size_t index, const std::string& line)>& filter);

/// Mends of a command that cannot read its first rows, those of a group as good as each other; see row_mends.cpp.
/// @param line at which reading stopped
/// @param is_guess the SPEC is one: rows must say that they are its own
/// @param has_answers rows before that line were answered
[[nodiscard]] MendGroups row_mends(const RowsCommand& command, std::string_view beginning, std::size_t line,
                                   bool is_guess, bool has_answers);

/// The same of a row whose numbers are no attitude: other columns, by their names.
[[nodiscard]] MendGroups name_mends(const RowsCommand& command, std::string_view beginning, std::size_t line);

/// The same of the REFERENCE: the columns of a file without a header, which are those of a project's or of the FILE.
/// @param text the beginning of the FILE
[[nodiscard]] MendGroups reference_mends(const RowsCommand& command, std::string_view text, std::string_view beginning);

/// The same where they are JSON.
[[nodiscard]] MendGroups json_mends(const RowsCommand& command, std::string_view beginning, bool is_guess);

/// The same of a file of NumPy's save() with rows of doubles (numpy.lib.format, version 1): what is behind its header.
[[nodiscard]] MendGroups numpy_mends(const RowsCommand& command, std::string_view bytes);

} // namespace rotconv::cli
