#include "between.hpp"
#include "operations.hpp"

namespace rotconv::operations {

Operation compose(const Composition& composition, const PairedRows& rows, bool continuous) {
    const Spec& first = composition.first();
    const Spec& to = composition.to();
    const RowFunction between = function_of(Composition(first, Spec{}, to, composition.settings()));
    return std::make_shared<RowsAtOnce>(
        of_pairs(function_of(composition), between, rows.columns(first, composition.second()), composition.second(),
                 composition.settings()),
        pair_numbers(attitude_numbers(first), rows, composition.second()), to, continuous);
} // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): the functions free what they hold

} // namespace rotconv::operations
