#include "../row_options.hpp"

namespace rotconv::cli {
namespace {

struct RotateOptions final : RowOptions {
    RotateOptions() {
        from.about = "The representation of the attitudes: NAME[:MODIFIER]...";
        add("What", {&from});
        add_reading();
        add_writing();
    }

    [[nodiscard]] Command command() const override {
        const Spec read = spec_of(from);
        return rows_command(operations::rotate(VectorRotation(read, settings())),
                            fmt::format("{} with a vector", representation(read.name).text));
    }
};

} // namespace

CommandEntry rotate_command() {
    return {"rotate", "Take vectors from body to reference coordinates",
            "Usage: rotconv rotate -f SPEC [OPTION]... [VALUE]...\n"
            "       rotconv rotate -f SPEC [OPTION]... [FILE]\n",
            make_options<RotateOptions>};
}

} // namespace rotconv::cli
