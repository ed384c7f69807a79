#include <utility>

#include <rotconv/product.hpp>

#include "row_options.hpp"

namespace rotconv::cli {
namespace {

Command compose(const Given& given) {
    const Spec first = spec_of(given, "--from");
    const Spec second = given.has("--by") ? spec_of(given, "--by") : first;
    const std::vector<Spec> to = specs_of(given, "--to");
    const ConversionSettings settings = attitude_settings_of(given);
    const operations::PairedRows rows = paired_rows_of(given);
    messages::Subject subject = rows.paired ? messages::subject_of(first, settings.tolerance)
                                            : messages::subject_of_two(first, second, settings.tolerance);
    const auto product_as = [&](const Spec& spec) {
        return operations::compose(Composition(first, second, spec, settings), rows, given.has("--continuous"));
    };
    RowsCommand command = rows_command(given, columns_of_file(given), operations::pair_numbers(first, second, rows),
                                       operations::several(mapped(to, product_as)), std::move(subject));
    if (given.has("--allow-unpaired")) {
        static_cast<void>(
            one_of<bool>("kind of rows for --allow-unpaired", given.text("--allow-unpaired"), {{"reference", true}}));
    }
    command.allow_unpaired = given.has("--allow-unpaired");
    if (rows.paired) {
        pair(given, command, operations::attitude_numbers(second, rows.by_key),
             messages::subject_of(second, settings.tolerance));
        command.options.pairing->needs_partner = true;
        command.options.pairing->tells_partner = false;
    }
    return command;
}

} // namespace

CommandEntry compose_command() {
    OptionSet set;
    set.begin_group("What");
    set.add("-f,--from", "SPEC", "The representation of FILE, the left factor: NAME[:MODIFIER]...");
    set.add("--by", "SPEC", "The representation of REFERENCE, the right factor (default: that of --from)");
    set.add("-t,--to", "SPEC", "The representation to write: NAME[:MODIFIER]...");
    add_attitudes(set);
    set.describe("--reference-axes", "Other reference axes of FILE's attitudes, such as ned:enu");
    set.describe("--body-axes", "Other body axes of FILE's attitudes, such as frd:flu, by their names");
    set.describe("--left", "Turn the attitudes R of FILE: compose L R; L as \"SPEC: NUMBERS\"");
    set.describe("--right", "Turn the attitudes R of FILE: compose R S; S as \"SPEC: NUMBERS\"");
    add_continuous(set);
    add_pairing(set);
    set.add_flag("--interpolate", "Take the reference at FILE's key, between two rows --key-within apart");
    set.add("--allow-unpaired", "WHOSE", "reference: rows of REFERENCE that are left over are no failure");
    add_reading(set);
    add_writing(set);
    add_lock_margin(set);
    return {"compose",
            "Multiply the attitudes of two streams, or of two in a row",
            "Usage: rotconv compose -f SPEC [--by SPEC] -t SPEC [OPTION]... FILE REFERENCE\n"
            "       rotconv compose -f SPEC [--by SPEC] -t SPEC [OPTION]... [FILE]\n"
            "       rotconv compose -f SPEC [--by SPEC] -t SPEC [OPTION]... VALUE...\n",
            std::move(set),
            compose,
            2};
}

} // namespace rotconv::cli
