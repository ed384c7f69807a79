#include "row_operation.hpp"

#include <algorithm>

namespace rotconv::stream {
namespace {

/// Merges the report of the part of that index, of `count`, into that of the parts before.
void merge(const RowReport& report, std::size_t part, std::size_t count, RowReport& merged) {
    RowReport both = merged.error != Error::none ? merged : report;
    if (!merged.parts.empty()) { // a part before has reported the row
        both.diagnostics |= merged.diagnostics;
        both.diagnostics |= report.diagnostics;
        both.sensitivity = {std::min(merged.sensitivity.margin, report.sensitivity.margin),
                            std::max(merged.sensitivity.condition, report.sensitivity.condition)};
        both.deviation = std::max(merged.deviation, report.deviation);
    }
    both.parts = std::move(merged.parts);
    both.parts.resize(count);
    both.parts[part] = {report.diagnostics, report.sensitivity};
    merged = std::move(both);
}

} // namespace

std::size_t RowOperation::width() const noexcept {
    std::size_t width = 0;
    for (const ResultPart& part : parts) {
        width += part.names.size();
    }
    return width;
}

std::vector<std::string> RowOperation::names() const {
    std::vector<std::string> names;
    for (const ResultPart& part : parts) {
        names.insert(names.end(), part.names.begin(), part.names.end());
    }
    return names;
}

bool RowOperation::is_continuous() const noexcept {
    return std::ranges::any_of(parts, [](const ResultPart& part) { return part.follows != nullptr; });
}

std::size_t RowOperation::run(const NumberRows& rows, std::span<double> out, std::vector<RowReport>& reports,
                              const Ordered& ordered) {
    const bool is_alone = parts.size() == 1;
    std::size_t answered = 0; // the same for all parts
    for (ResultPart& part : parts) {
        part.out.resize(is_alone ? 0 : rows.lines.size() * part.names.size());
        part.rest.resize(part.follows ? rows.lines.size() * part.names.size() : 0);
        answered = part.function(rows, is_alone ? out : part.out, is_alone ? reports : part.reports, part.rest);
    }
    const auto make_continuous = [&] {
        for (ResultPart& part : parts) {
            if (part.follows) {
                const std::span<double> numbers = is_alone ? out : part.out;
                ContinuousNumbers::Again again;
                if (part.again) {
                    again = [&](std::size_t row, std::span<double> canonical, std::span<double> rest) {
                        const std::size_t size = rows.numbers.size() / rows.lines.size();
                        part.again(std::span(rows.numbers).subspan(row * size, size), canonical, rest);
                    };
                }
                part.follows->run(numbers.first(answered * part.names.size()), is_alone ? reports : part.reports,
                                  part.rest, again);
            }
        }
    };
    if (is_continuous() && ordered) {
        ordered(make_continuous);
    } else {
        make_continuous();
    }
    if (is_alone) {
        return answered;
    }
    reports.clear();
    const std::size_t width = this->width();
    std::size_t first = 0; // column of the part
    for (ResultPart& part : parts) {
        const std::size_t size = part.names.size();
        for (std::size_t row = 0; row < answered; ++row) {
            std::copy_n(part.out.data() + row * size, size, out.data() + row * width + first);
        }
        first += size;
        for (const RowReport& report : part.reports) {
            merge(report, static_cast<std::size_t>(&part - parts.data()), parts.size(), report_of(report.row, reports));
        }
    }
    return answered;
}

RowReport& report_of(std::size_t row, std::vector<RowReport>& reports) {
    const auto place = std::ranges::lower_bound(reports, row, {}, &RowReport::row);
    return place != reports.end() && place->row == row ? *place : *reports.insert(place, {.row = row});
}

} // namespace rotconv::stream
