#include <rotconv/product.hpp>

#include "../row_options.hpp"

namespace rotconv::cli {
namespace {

struct ComposeOptions final : RowOptions {
    ComposeOptions() {
        from.about = "The representation of FILE, the left factor: NAME[:MODIFIER]...";
        to.is_list = true;
        add("What", {&from, &by, &to});
        add_attitudes_of_file("Turn the attitudes R of FILE: compose L R; L as \"SPEC: NUMBERS\"",
                              "Turn the attitudes R of FILE: compose R S; S as \"SPEC: NUMBERS\"");
        add("What", {&continuous});
        add_pairing();
        add("Columns", {&interpolate, &allow_unpaired});
        add_reading();
        add_writing();
        add("Errors", {&lock_margin});
    }

    [[nodiscard]] Command command() const override {
        if (!from.given() && !to.given()) {
            throw MissingSpec("{} SPEC and {} SPEC are missing", from.name(), to.name());
        }
        const Spec first = spec_of(from);
        const Spec second = by.given() ? spec_of(by) : first;
        const std::vector<Spec> written = specs_of(to, degrees.given());
        const ConversionSettings conversion = attitude_settings();
        const operations::PairedRows rows = paired_rows();
        const auto product_as = [&](const Spec& spec) {
            return operations::compose(Composition(first, second, spec, conversion), rows, continuous.given());
        };
        RowsCommand made = rows_command(operations::several(mapped(written, product_as)));
        pair(made, second);
        made.allow_unpaired = allow_unpaired.given() && one_of("kind of rows for --allow-unpaired", allow_unpaired,
                                                               Choices<bool>{{"reference", true}});
        if (rows.paired) {
            made.options.pairing->needs_partner = true;
            made.options.pairing->tells_partner = false;
        }
        return made;
    }

private:
    Option by{"--by", "SPEC", "The representation of REFERENCE, the right factor (default: as --from)"};
    Option allow_unpaired{
        "--allow-unpaired", "WHOSE", "reference: rows of REFERENCE that are left over are no failure", {"reference"}};
};

} // namespace

CommandEntry compose_command() {
    return {"compose", "Multiply the attitudes of two streams, or of two in a row",
            "Usage: rotconv compose -f SPEC [--by SPEC] -t SPEC [OPTION]... FILE REFERENCE\n"
            "       rotconv compose -f SPEC [--by SPEC] -t SPEC [OPTION]... [FILE]\n"
            "       rotconv compose -f SPEC [--by SPEC] -t SPEC [OPTION]... VALUE...\n",
            make_options<ComposeOptions>, 2};
}

} // namespace rotconv::cli
