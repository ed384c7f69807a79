#include <rotconv/continuous.hpp>

#include "operations.hpp"

namespace rotconv::operations {
namespace {

class Convert final : public stream::RowOperation {
public:
    Convert(const Conversion& conversion, bool continuous)
        : conversion_(conversion), numbers_(std::make_shared<ContinuousNumbers>(conversion.to())) {
        names = names_of(conversion.to());
        attitude = conversion.to();
        is_continuous = continuous && numbers_->have_choice();
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<Convert>(*this); }

    void run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        rest_.resize(is_continuous ? out.size() : 0);
        conversion_.run(rows.numbers, out, reports, rest_);
    }
    void make_continuous(std::span<double> results, std::span<const RowReport> reports) override {
        numbers_->run(results, reports, rest_);
    }

private:
    Conversion conversion_;
    std::shared_ptr<ContinuousNumbers> numbers_; ///< of all threads
    std::vector<double> rest_;                   ///< what the exact numbers have beside the results
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

stream::RowNumbers attitude_numbers(const Spec& spec, bool with_key) {
    return {.names = with_key ? joined({"key"}, names_of(spec)) : names_of(spec),
            .attitude = spec,
            .kept = with_key ? std::size_t{1} : 0};
}

Operation convert(const Conversion& conversion, bool continuous) {
    return std::make_shared<Convert>(conversion, continuous);
}

} // namespace rotconv::operations
