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

stream::RowNumbers attitude_numbers(const Spec& spec, bool with_key) {
    return {.names = with_key ? concatenated({"key"}, names_of(spec)) : names_of(spec),
            .attitude = spec,
            .kept = with_key ? std::size_t{1} : 0};
}

Operation convert(const Conversion& conversion, bool continuous) {
    return std::make_shared<RowsAtOnce>(function_of(conversion), attitude_numbers(conversion.from()), conversion.to(),
                                        continuous);
}

} // namespace rotconv::operations
