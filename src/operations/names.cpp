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

std::vector<std::string> joined(std::vector<std::string> names, const std::vector<std::string>& others) {
    names.insert(names.end(), others.begin(), others.end());
    return names;
}

std::span<const double> KeyRemover::operator()(std::span<const double> rows, std::size_t n, std::size_t m) {
    room_.clear();
    for (auto at = rows.begin(); at != rows.end();) {
        for (const std::size_t size : {n, m}) {
            room_.insert(room_.end(), at + 1, at + 1 + static_cast<std::ptrdiff_t>(size));
            at += 1 + static_cast<std::ptrdiff_t>(size);
        }
    }
    return room_;
}

} // namespace rotconv::operations
