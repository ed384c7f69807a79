#include "run.hpp"

#include <cerrno>

#include "lines.hpp"
#include "rows.hpp"

namespace rotconv::stream {
namespace {

/// Writes the block's bytes and then reports its events; false where the run is over.
bool hand_on(Sink& sink, const Output& output, const std::function<void(const Event&)>& report, Ending& ending) {
    if (const int error = sink.write({output.bytes.data(), output.bytes.size()}); error != 0) {
        ending.reader_left = error == EPIPE;
        if (!ending.reader_left) {
            ending.fault = StreamFault{StreamFault::What::write, 0, error, {}};
        }
        return false;
    }
    for (const Event& event : output.events) {
        report(event);
    }
    ending.stopped = output.stopped;
    return !output.stopped;
}

} // namespace

Ending run(Source& source, Sink& sink, const Options& options, const std::function<void(const Event&)>& report) {
    BlockReader reader(source);
    Preamble preamble(options);
    std::optional<RowTransformer> transformer;
    Output output;
    Ending ending;
    while (const auto block = reader.next()) {
        std::string_view rest = block->text;
        std::size_t line = block->first_line;
        output.clear();
        if (!transformer && preamble.read(rest, line, output)) {
            transformer.emplace(options, preamble.layout());
        }
        if (transformer) {
            transformer->transform(rest, line, output);
        }
        if (!hand_on(sink, output, report, ending)) {
            return ending;
        }
        if (preamble.fault()) {
            ending.fault = preamble.fault();
            return ending;
        }
    }
    output.clear();
    if (transformer) {
        transformer->finish(output);
    } else if (!reader.fault()) {
        preamble.finish(output);
    }
    if (!hand_on(sink, output, report, ending)) {
        return ending;
    }
    if (reader.fault() && !ending.fault) {
        ending.fault = reader.fault();
    }
    return ending;
}

} // namespace rotconv::stream
