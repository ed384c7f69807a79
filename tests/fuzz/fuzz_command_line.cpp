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

fuzz::Reach reach{"conversion",
                  "rates",
                  "propagate",
                  "survey",
                  "compare",
                  "identify",
                  "text to print",
                  "usage error",
                  "VALUEs",
                  "VALUEs that are compared",
                  "VALUEs that are identified",
                  "pairs by row",
                  "pairs by key"};

void require(bool holds) {
    if (!holds) {
        std::abort();
    }
}

void check(const stream::Options& options) {
    require(options.operation.inputs > 0 && !options.operation.names.empty() && options.threads > 0);
    require(options.digits.significant >= 0 && options.digits.significant <= 100);
    require(options.digits.decimals >= -1 && options.digits.decimals <= 100);
    require(options.width == 0 || options.width >= options.operation.inputs);
    if (options.pairing) {
        const stream::Pairing& pairing = *options.pairing;
        require(pairing.by_key == (options.operation.kept == 1) && pairing.reference.operation.inputs > 0);
        require(pairing.within >= stream::Decimal());
        reach.add(pairing.by_key ? "pairs by key" : "pairs by row");
    }
}

void run_values(const cli::RowsCommand& command, std::string_view name) {
    if (command.has_values) {
        reach.add(name);
        stream::NullSink nowhere;
        stream::TextSource values(command.values);
        stream::run(values, nowhere, command.options, [](const stream::Event&) {});
    }
}

struct Check {
    const std::vector<std::string>& words;

    void operator()(const cli::RowsCommand& command) const {
        check(command.options);
        const bool is_named = std::ranges::count(words, "rates") > 0;
        reach.add(command.options.operation.in_order ? "propagate" : is_named ? "rates" : "conversion");
        run_values(command, "VALUEs");
    }
    void operator()(const cli::SurveyCommand& command) const {
        require(command.condition >= 0.0);
        reach.add("survey");
    }
    void operator()(const cli::CompareCommand& command) const {
        require(!command.within || *command.within >= 0.0);
        check(command.rows.options);
        reach.add("compare");
        run_values(command.rows, "VALUEs that are compared");
    }
    void operator()(const cli::IdentifyCommand& command) const {
        require(command.settings.within >= 0.0);
        reach.add("identify");
        const std::size_t count = command.layout.count;
        require(count > 0 || !command.rows.has_values);
        if (count > 0) {
            check(command.rows.options);
            Identification identification(count, command.layout.known, command.name, command.settings);
            cli::RowsCommand rows = command.rows;
            rows.options.operation = stream::identification_operation(command.layout, &identification);
            run_values(rows, "VALUEs that are identified");
        }
    }
    void operator()(const cli::PrintCommand& command) const {
        require(command.text.ends_with('\n'));
        reach.add("text to print");
    }
    void operator()(const cli::UsageError& error) const {
        // RawOptions from outside are shown without what steers a terminal or looks like a line of the program's own.
        require(!error.message.empty());
        for (std::size_t i = 0; i < error.message.size(); ++i) {
            const auto c = static_cast<unsigned char>(error.message[i]);
            require(c == '\n' ? error.message.compare(i, 3, "\n  ") == 0 : c >= 0x20U && c != 0x7fU);
        }
        reach.add("usage error");
    }
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto words = fuzz::words_of(text, '\n');
    std::visit(Check{words}, fuzz::command_of(words));
    return 0;
}
