#include <utility>

#include "operations.hpp"

namespace rotconv::operations {

Operation method(const MethodConversion& conversion, bool continuous) {
    const auto function = [conversion, angles = std::vector<double>()](const auto& rows, auto out, auto& reports,
                                                                       auto /*rest*/) mutable {
        conversion.run(rows.numbers, out, angles, reports);
    };
    return std::make_shared<RowsAtOnce>(function, attitude_numbers(conversion.from()), conversion.to(), continuous);
}

Operation all_methods(const MethodConversion& conversion, std::shared_ptr<MethodAnswers> answers) {
    const auto function = [conversion, answers = std::move(answers)](const auto& rows, auto /*out*/, auto& reports,
                                                                     auto /*rest*/) {
        answers->numbers.resize(rows.lines.size() * conversion.names().size() * conversion.to().size());
        conversion.run(rows.numbers, answers->numbers, answers->angles, reports);
    };
    return std::make_shared<RowsAtOnce>(function, attitude_numbers(conversion.from()), conversion.to(), false);
}

} // namespace rotconv::operations
