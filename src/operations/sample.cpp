#include <algorithm>
#include <iterator>

#include "operations.hpp"

namespace rotconv::operations {

Operation sample(const Spec& spec, const SampleSettings& settings, bool with_kinds) {
    const auto function = [sampler = Sampler(spec, settings)](const auto& rows, auto out, auto& reports,
                                                              auto /*rest*/) mutable {
        reports.clear();
        sampler.run(rows.numbers, out);
    };
    auto made = std::make_shared<RowsAtOnce>(function, stream::RowNumbers{.names = {"index"}}, spec, false);
    if (with_kinds) {
        made->text = stream::TextColumn{.name = "kind"};
        std::ranges::transform(settings.kinds, std::back_inserter(made->text->texts),
                               [](SampleKind kind) { return std::string(name_of(kind)); });
    }
    return made;
}

} // namespace rotconv::operations
