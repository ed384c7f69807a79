#include "operations.hpp"

namespace rotconv::operations {

stream::RowNumbers rates_numbers(const Spec& spec, const RateSettings& settings) {
    return {.names = joined(names_of(spec), settings.inverse ? names_of(spec, "_rate") : velocity_names(false)),
            .attitude = spec};
}

Operation rates(const Spec& spec, const RateSettings& settings) {
    return std::make_shared<RowsAtOnce>(function_of(Rates(spec, settings)),
                                        settings.inverse ? velocity_names(settings.degrees) : names_of(spec, "_rate"));
}

} // namespace rotconv::operations
