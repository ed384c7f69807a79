#include "../core/representations/codec.hpp"
#include "operations.hpp"

namespace rotconv::operations {

std::vector<std::string> names_of(const Spec& spec, const std::string& ending) {
    const auto columns = spec.columns();
    std::vector<std::string> names;
    for (std::size_t i = 0; i < spec.size(); ++i) {
        names.push_back(std::string(columns.at(i)) + ending);
    }
    return names;
}

std::vector<std::string> velocity_names(bool degrees) {
    return degrees ? std::vector<std::string>{"wx_deg_s", "wy_deg_s", "wz_deg_s"}
                   : std::vector<std::string>{"wx", "wy", "wz"};
}

std::vector<std::string> concatenated(std::vector<std::string> names, const std::vector<std::string>& others) {
    names.insert(names.end(), others.begin(), others.end());
    return names;
}

void add_attitude(stream::RowOperation& operation, const Spec& to) {
    if (const auto ends = codec_of(to.name).open_ends) {
        const auto& [numbers, end, other] = ends(to);
        for (const std::size_t number : numbers) {
            operation.open_ends.push_back({operation.names.size() + number, end, other});
        }
    }
    operation.names = concatenated(operation.names, names_of(to));
    operation.attitudes.push_back(to);
}

stream::RowNumbers attitude_numbers(const Spec& spec) { return {.names = names_of(spec), .attitude = spec}; }

stream::RowNumbers pair_numbers(stream::RowNumbers numbers, const PairedRows& rows, const Spec& second) {
    if (rows.by_key) {
        numbers.names = concatenated({"key"}, numbers.names);
        numbers.kept = 1;
    }
    if (!rows.paired) {
        numbers.names = concatenated(numbers.names, names_of(second));
        numbers.second = second;
    }
    return numbers;
}

Operation convert(const Conversion& conversion, bool continuous) {
    return std::make_shared<RowsAtOnce>(function_of(conversion), attitude_numbers(conversion.from()), conversion.to(),
                                        continuous);
}

} // namespace rotconv::operations
