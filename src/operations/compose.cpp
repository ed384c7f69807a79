#include "between.hpp"
#include "operations.hpp"

namespace rotconv::operations {

stream::RowNumbers pair_numbers(const Spec& first, const Spec& second, const PairedRows& rows) {
    stream::RowNumbers numbers = attitude_numbers(first, rows.by_key);
    if (!rows.paired) {
        numbers.names = concatenated(numbers.names, names_of(second));
        numbers.second = second;
    }
    return numbers;
}

Operation compose(const Composition& composition, const PairedRows& rows, bool continuous) {
    const Spec& first = composition.first();
    const Spec& to = composition.to();
    const RowFunction between = function_of(Composition(first, Spec{}, to, composition.settings()));
    return std::make_shared<RowsAtOnce>(of_pairs({function_of(composition), to.size()}, {between, to.size()},
                                                 rows.columns(first, composition.second()), composition.second(),
                                                 composition.settings()),
                                        pair_numbers(first, composition.second(), rows), to, continuous);
} // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): the functions free what they hold

} // namespace rotconv::operations
