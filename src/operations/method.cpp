#include <algorithm>

#include "operations.hpp"

namespace rotconv::operations {

Operation method(const MethodConversion& conversion, bool all, bool continuous) {
    const auto function = [conversion, all, angles = std::vector<double>()](const auto& rows, auto out, auto& reports,
                                                                            auto /*rest*/) mutable {
        conversion.run(rows.numbers, out, angles, reports, all);
    };
    auto made =
        std::make_shared<RowsAtOnce>(function, attitude_numbers(conversion.from()), conversion.to(), continuous);
    if (all) {
        const auto methods = conversion.names();
        made->results_of_row = methods.size();
        made->text = stream::TextColumn{"method", made->names.size(), {methods.begin(), methods.end()}};
        const bool is_taken = std::ranges::find(made->names, "angle") != made->names.end(); // axis-angle has one
        made->names.emplace_back(is_taken ? "method_angle" : "angle");
    }
    return made;
}

} // namespace rotconv::operations
