#include "between.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

class Convert final : public AttitudeOperation {
public:
    Convert(const Conversion& conversion, bool continuous)
        : AttitudeOperation(conversion.to(), continuous), conversion_(conversion) {}
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Convert>(*this); }

    std::size_t run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        conversion_.run(rows.numbers, out, reports, rest_of(out));
        return rows.lines.size();
    }

private:
    Conversion conversion_;
};

} // namespace

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

std::span<const double> without_keys(std::span<const double> rows, const stream::PairColumns& columns,
                                     std::vector<double>& room) {
    if (!columns.by_key) {
        return rows;
    }
    room.clear();
    for (; !rows.empty(); rows = rows.subspan(columns.width())) {
        append(room, rows.subspan(columns.first(), columns.first_size));
        append(room, rows.subspan(columns.second(), columns.second_size));
    }
    return room;
}

stream::RowNumbers attitude_numbers(const Spec& spec, bool with_key) {
    return {.names = with_key ? joined({"key"}, names_of(spec)) : names_of(spec),
            .attitude = spec,
            .kept = with_key ? std::size_t{1} : 0};
}

Operation convert(const Conversion& conversion, bool continuous) {
    return std::make_shared<Convert>(conversion, continuous);
}

} // namespace rotconv::operations
