#include <utility>

#include "row_options.hpp"

namespace rotconv::cli {
namespace {

Command rotate(const Given& given) {
    const Spec from = spec_of(given, "--from");
    const ConversionSettings settings = settings_of(given);
    const stream::RowNumbers numbers = operations::rotation_numbers(from);
    return rows_command(given, {.list = given.text("--columns")}, numbers,
                        operations::rotate(VectorRotation(from, settings)),
                        {fmt::format("{} with a vector", representation(from.name).text), numbers.names.size(),
                         from.name, settings.tolerance});
}

} // namespace

CommandEntry rotate_command() {
    OptionSet set;
    set.add("-f,--from", "SPEC", "The representation of the attitudes: NAME[:MODIFIER]...");
    add_reading(set);
    add_writing(set);
    return {"rotate", "Take vectors from body to reference coordinates",
            "Usage: rotconv rotate -f SPEC [OPTION]... [VALUE]...\n"
            "       rotconv rotate -f SPEC [OPTION]... [FILE]\n",
            std::move(set), rotate};
}

} // namespace rotconv::cli
