#include "operations.hpp"

namespace rotconv::operations {
namespace {

class AddToSurvey final : public stream::RowOperation {
public:
    AddToSurvey(const Spec& from, const ConversionSettings& settings, Survey& survey)
        : conversion_(from, Spec{}, settings), survey_(&survey) {
        names = names_of(Spec{});
        in_order = true;
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override { return std::make_unique<AddToSurvey>(*this); }

    void run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        conversion_.run(rows.numbers, out, reports);
        auto report = reports.begin();
        for (std::size_t i = 0; i < rows.lines.size(); ++i) {
            const bool is_reported = report != reports.end() && report->row == i;
            if (is_reported && (report++)->error != Error::none) {
                continue;
            }
            const auto q = out.subspan(4 * i, 4);
            survey_->add(Rotation::from_components(q[0], q[1], q[2], q[3]), rows.lines[i]);
        }
    }

private:
    Conversion conversion_;
    Survey* survey_;
};

} // namespace

Operation survey(const Spec& from, const ConversionSettings& settings, Survey& survey) {
    return std::make_shared<AddToSurvey>(from, settings, survey);
}

} // namespace rotconv::operations
