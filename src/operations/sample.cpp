#include "operations.hpp"

namespace rotconv::operations {

Operation sample(const Spec& spec, const SampleSettings& settings) {
    const auto function = [sampler = Sampler(spec, settings)](const auto& rows, auto out, auto& reports,
                                                              auto /*rest*/) mutable {
        reports.clear();
        sampler.run(rows.numbers, out);
    };
    return std::make_shared<RowsAtOnce>(function, stream::RowNumbers{.names = {"index"}}, spec, false);
}

} // namespace rotconv::operations
