#include "operations.hpp"

namespace rotconv::operations {

Operation rates(const Spec& spec, const RateSettings& settings) {
    const auto of_numbers = names_of(spec, "_rate");
    const auto& taken = settings.inverse ? of_numbers : velocity_names(false);
    const auto& made = settings.inverse ? velocity_names(settings.degrees) : of_numbers;
    const stream::RowNumbers numbers{.names = concatenated(names_of(spec), taken), .attitude = spec};
    return std::make_shared<RowsAtOnce>(function_of(Rates(spec, settings)), numbers, made);
}

} // namespace rotconv::operations
