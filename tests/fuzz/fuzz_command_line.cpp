// Any words as the program's arguments, a line each: never a crash; a mistake is told in words, and what is accepted
// can be run.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <variant>

#include "command_text.hpp"
#include "reach.hpp"
#include "stream/run.hpp"

namespace {

using namespace rotconv;

fuzz::Reach reach{
    // clang-format off
        "conversion", "rates", "propagate", "survey", "compare", "identify", "sample", "text to print", "usage error",
        "VALUEs", "VALUEs that are compared", "VALUEs that are identified", "pairs by row", "pairs by key",
    // clang-format on
};

void require(bool holds) {
    if (!holds) {
        std::abort();
    }
}

void check(const stream::Options& options) {
    const stream::InputOptions& input = options.input;
    require(input.numbers.names.empty() == (input.take_count != nullptr));
    require(options.operation->width() > 0 && options.threads > 0);
    require(options.digits.significant >= 0 && options.digits.significant <= 100);
    require(options.digits.decimals >= -1 && options.digits.decimals <= 100);
    require(input.width == 0 || input.width >= input.numbers.names.size());
    if (options.pairing) {
        const stream::Pairing& pairing = *options.pairing;
        require(pairing.by_key == (input.numbers.kept == 1) && !pairing.reference.numbers.names.empty());
        reach.add(pairing.by_key ? "pairs by key" : "pairs by row");
    }
}

struct Check {
    const std::vector<std::string>& words;

    void operator()(const cli::RowsCommand& command) const {
        check(command.options);
        std::string name = "conversion";
        for (const char* other : {"rates", "propagate", "survey", "compare", "identify", "sample"}) {
            name = std::ranges::count(words, other) > 0 ? other : name;
        }
        reach.add(name);
        if (command.has_values) {
            reach.add(name == "compare"    ? "VALUEs that are compared"
                      : name == "identify" ? "VALUEs that are identified"
                                           : "VALUEs");
            stream::run(*command.source, nullptr, command.options, [](const stream::Event&) {});
        }
    }
    void operator()(const std::string& text) const {
        require(text.ends_with('\n'));
        reach.add("text to print");
    }
    void operator()(const cli::Usage& error) const {
        // Texts from outside are shown without what steers a terminal or looks like a line of the program's own.
        const std::string message = error.what();
        require(!message.empty());
        for (std::size_t i = 0; i < message.size(); ++i) {
            const auto c = static_cast<unsigned char>(message[i]);
            require(c == '\n' ? message.compare(i, 3, "\n  ") == 0 : c >= 0x20U && c != 0x7fU);
        }
        reach.add("usage error");
    }
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto words = fuzz::words_of(text, '\n');
    const Check check_command{words};
    try {
        std::visit(check_command, fuzz::command_of(words));
    } catch (const cli::Usage& error) {
        check_command(error);
    }
    return 0;
}
