#include <algorithm>
#include <utility>

#include "between.hpp"
#include "operations.hpp"

namespace rotconv::operations {
namespace {

/// Copies rows of `width` numbers into columns of wider rows, from column `first` on.
void copy_columns(std::span<const double> from, std::size_t width, std::span<double> to, std::size_t first,
                  std::size_t to_width) {
    for (std::size_t row = 0; row < to.size() / to_width; ++row) {
        std::copy_n(from.data() + row * width, width, to.data() + row * to_width + first);
    }
}

class Several final : public stream::RowOperation {
public:
    explicit Several(std::vector<Operation> parts) {
        input = parts.front()->input;
        for (Operation& each : parts) {
            const std::size_t first = names.size();
            for (const Spec& to : each->attitudes) {
                add_attitude(*this, to);
            }
            in_order = in_order || each->in_order;
            is_continuous = is_continuous || each->is_continuous;
            parts_.push_back({.operation = std::move(each), .first = first});
        }
    }
    [[nodiscard]] std::unique_ptr<RowOperation> copy() const override {
        std::vector<Operation> parts;
        for (const Part& part : parts_) {
            parts.push_back(part.operation->copy());
        }
        return std::make_unique<Several>(std::move(parts));
    }

    std::size_t run(const stream::NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports) override {
        reports.clear();
        std::size_t answered = rows.lines.size(); // the same for all parts
        for (Part& part : parts_) {
            const std::size_t width = part.operation->names.size();
            part.out.resize(rows.lines.size() * width);
            answered = part.operation->run(rows, part.out, part.reports);
            copy_columns(part.out, width, out, part.first, names.size());
            merge(part.reports, static_cast<std::size_t>(&part - parts_.data()), reports);
        }
        first_step = parts_.front().operation->first_step;
        return answered;
    }
    void make_continuous(std::span<double> results, std::span<const RowReport> /*reports*/) override {
        for (Part& part : parts_) {
            if (part.operation->is_continuous) {
                const std::size_t width = part.operation->names.size();
                const auto own = std::span(part.out).first(results.size() / names.size() * width);
                part.operation->make_continuous(own, part.reports);
                copy_columns(own, width, results, part.first, names.size());
            }
        }
    }

private:
    struct Part {
        Operation operation;
        std::size_t first = 0; ///< its first column
        std::vector<double> out{};
        std::vector<RowReport> reports{};
    };

    /// Merges the reports of a part into those of the parts before.
    void merge(const std::vector<RowReport>& more, std::size_t part, std::vector<RowReport>& reports) const {
        for (const RowReport& report : more) {
            RowReport& merged = report_of(report.row, reports);
            RowReport both = merged.error != Error::none ? merged : report;
            if (!merged.parts.empty()) { // a part before has reported the row
                both.diagnostics |= merged.diagnostics;
                both.diagnostics |= report.diagnostics;
                both.sensitivity = {std::min(merged.sensitivity.margin, report.sensitivity.margin),
                                    std::max(merged.sensitivity.condition, report.sensitivity.condition)};
                both.deviation = std::max(merged.deviation, report.deviation);
            }
            both.parts = std::move(merged.parts);
            both.parts.resize(parts_.size());
            both.parts[part] = {report.diagnostics, report.sensitivity};
            merged = std::move(both);
        }
    }

    std::vector<Part> parts_;
};

} // namespace

Operation several(std::vector<Operation> parts) {
    return parts.size() == 1 ? std::move(parts.front()) : std::make_shared<Several>(std::move(parts));
}

} // namespace rotconv::operations
