#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../grammar/column_names.hpp"
#include "answers.hpp"

namespace rotconv::cli {

MendGroups numpy_mends(const RowsCommand& command, std::string_view bytes) {
    constexpr std::size_t prefix = 10; // \x93NUMPY, the version, and the size of the header
    const Option* const format = command.line->missing("--input-format");
    if (!bytes.starts_with("\x93NUMPY\x01") || bytes.size() < prefix || format == nullptr) {
        return {};
    }
    const auto byte = [bytes](std::size_t at) { return std::size_t{static_cast<unsigned char>(bytes[at])}; };
    const std::size_t begin = prefix + byte(8) + 256 * byte(9);
    const std::string_view header = bytes.substr(0, begin);
    const std::string shape = fmt::format(", {})", command.options.input.numbers.names.size());
    const bool has_rows = header.find("'descr': '<f8'") != std::string_view::npos &&
                          header.find("'fortran_order': False") != std::string_view::npos &&
                          header.find(shape) != std::string_view::npos;
    if (!has_rows || bytes.size() <= begin) {
        return {};
    }
    const std::string_view rows = bytes.substr(begin);
    const std::size_t whole = rows.size() - rows.size() % (8 * command.options.input.numbers.names.size());
    const auto reading = [&](const std::vector<Edit>& more) {
        Mend mend{{command.line->setting(*format, "f64")}};
        mend.edits.insert(mend.edits.end(), more.begin(), more.end());
        return command.line->piped(std::move(mend), fmt::format("tail -c +{}", begin + 1),
                                   std::string(rows.substr(0, whole)));
    };
    const auto& spec = command.options.input.numbers.attitude;
    std::vector<Mend> mends{reading({})};
    if (spec && has_open_order(*spec)) {
        mends.push_back(reading({command.line->setting(*command.line->find("--from"), "quat:xyzw")})); // SciPy's
    }
    return {mends};
}

} // namespace rotconv::cli
