#include "accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include "strata.hpp"

namespace accuracy {
namespace {

using rotconv::RepresentationId;
using rotconv::Spec;
using Rows = std::vector<std::vector<double>>;

/// As the table calls it: all Euler angles are one.
std::string name_in_table(RepresentationId name) {
    const auto& entry = rotconv::representation(name);
    return entry.has_gimbal_lock ? "euler" : std::string(entry.text);
}

std::vector<Spec> all_of(const std::string& name, rotconv::AngleUnit unit) {
    std::vector<Spec> specs;
    if (name == "euler") {
        for (const auto sequence : rotconv::EulerSequence::all()) {
            Spec made;
            made.name = RepresentationId::euler;
            made.sequence = sequence;
            specs.push_back(made);
        }
    } else {
        specs.push_back(spec(name));
    }
    if (unit == rotconv::AngleUnit::degrees) {
        std::ranges::transform(specs, specs.begin(), [](const Spec& s) { return s.in_degrees(); });
    }
    return specs;
}

} // namespace

const std::vector<Way>& ways() {
    static const std::vector<Way> table{
        {"quat", "quat", 1, 0.89},     {"quat", "dcm", 1.75, 1.4},         {"quat", "6d", 2.25, 1.9},
        {"quat", "5d", 5, 4.34},       {"quat", "rotvec", 2, 1.58},        {"quat", "axis-angle", 2, 1.64},
        {"quat", "cayley", 1, 1},      {"quat", "mrp", 1.25, 0.99},        {"quat", "euler", 5.5, 4.4},
        {"dcm", "quat", 5, 4.27},      {"6d", "quat", 4.25, 3.75},         {"5d", "quat", 5.25, 4.54},
        {"cayley", "quat", 1, 0.89},   {"mrp", "quat", 1.5, 1.31},         {"euler", "quat", 4, 3.41},
        {"rotvec", "quat", 2.5, 2.18}, {"axis-angle", "quat", 2.75, 2.36}, {"rotvec", "dcm", 2.5, 2.14},
    };
    return table;
}

std::vector<std::string> signed_sequences() {
    std::vector<std::string> texts;
    for (const auto sequence : rotconv::EulerSequence::all()) {
        for (unsigned signs = 0; signs < 8; ++signs) {
            std::string text;
            for (unsigned i = 0; i < 3; ++i) {
                text += (signs >> i & 1U) != 0 ? "-" : "";
                text += sequence.text()[i];
            }
            texts.push_back(text);
        }
    }
    return texts;
}

std::vector<std::string> all_specs() {
    std::vector<std::string> specs;
    for (const RepresentationId id : rotconv::all_representations) {
        const auto& entry = rotconv::representation(id);
        const std::string text(entry.text);
        for (const std::string& plain :
             entry.takes_sequence ? std::vector{text + ":ZYX", text + ":zxz", text + ":Z-Y-X"} : std::vector{text}) {
            specs.push_back(plain);
            for (const auto modifier : rotconv::all_modifiers) {
                if (entry.modifiers.has(modifier)) {
                    specs.push_back(plain + ':' + std::string(rotconv::name_of(modifier)));
                }
            }
        }
    }
    return specs;
}

std::vector<std::string> combined_specs() {
    std::vector<std::string> specs;
    for (const RepresentationId id : rotconv::all_representations) {
        const auto& entry = rotconv::representation(id);
        std::vector<std::string> texts{std::string(entry.text)};
        if (entry.takes_sequence) {
            texts.clear();
            for (const auto sequence : rotconv::EulerSequence::all()) {
                texts.push_back("euler:" + sequence.text());
            }
            for (const char* with_signs : {"Z-Y-X", "-z-y-x", "-XY-X", "z-x-z"}) {
                texts.push_back(std::string("euler:") + with_signs);
            }
        }
        for (const auto modifier : rotconv::all_modifiers) {
            const bool is_told = entry.modifiers.has(modifier) && modifier != rotconv::Modifier::wxyz;
            const std::size_t count = is_told ? texts.size() : 0;
            for (std::size_t i = 0; i < count; ++i) {
                texts.push_back(texts[i] + ':' + std::string(rotconv::name_of(modifier)));
            }
        }
        std::ranges::move(texts, std::back_inserter(specs));
    }
    return specs;
}

bool has_limits(RepresentationId name) { return std::ranges::count(ways(), name_in_table(name), &Way::to) != 0; }

double limit_from(const Spec& from) {
    return from.name == RepresentationId::quat ? 0.0
                                               : std::ranges::find(ways(), name_in_table(from.name), &Way::from)->limit;
}

double limit_to(const Spec& to) {
    const std::string name = name_in_table(to.name);
    return std::ranges::find_if(ways(), [&](const Way& way) { return way.from == "quat" && way.to == name; })->limit;
}

namespace {

Convert conversion_of(const Spec& from, const Spec& to, bool is_fast) {
    const rotconv::Conversion conversion(
        from, to, {.tolerance = std::numeric_limits<double>::infinity(), .lock_margin = 0.0, .fast = is_fast});
    return [conversion](std::span<const double> row) {
        std::vector<double> result(conversion.to().size());
        std::vector<rotconv::RowReport> reports;
        conversion.run(row, result, reports);
        return result;
    };
}

} // namespace

Convert own(const Spec& from, const Spec& to) { return conversion_of(from, to, false); }

Convert fast(const Spec& from, const Spec& to) { return conversion_of(from, to, true); }

Rows inputs(const Spec& from, const Spec& to, int size) {
    Rows all;
    for (auto& stratum : strata::strata_of(from, to, size)) {
        std::ranges::move(stratum.rows, std::back_inserter(all));
    }
    if (from.name == RepresentationId::cayley) {
        // Beyond what the closed form's squares hold; measured in the charts.
        std::erase_if(all, [](const auto& row) {
            return std::ranges::any_of(row, [](double v) { return std::fabs(v) > 1e150; });
        });
    }
    return all;
}

Worst worst_error(const Spec& from, const Spec& to, const Convert& convert, const Rows& rows) {
    Worst worst;
    for (const auto& row : rows) {
        const auto exact = oracle::attitude(from, row);
        const auto result = convert(row);
        const bool finite = std::ranges::all_of(result, [](double v) { return std::isfinite(v); });
        double error = std::numeric_limits<double>::infinity();
        if (finite) {
            error = oracle::error_in_eps(exact, oracle::attitude(to, result));
        } else if (to.name == RepresentationId::cayley &&
                   std::ranges::none_of(result, [](double v) { return std::isnan(v); })) {
            // an infinite vector says that this is a half-turn
            error = static_cast<double>(2 * abs(exact.w())) / oracle::eps;
        }
        if (!(error <= worst.error)) {
            worst = {std::isnan(error) ? std::numeric_limits<double>::infinity() : error,
                     from.text() + " to " + to.text() + ":" + text_of(row)};
        }
    }
    return worst;
}

Worst worst_of(const Way& way, int size, rotconv::AngleUnit unit) {
    Worst worst;
    const auto froms = all_of(way.from, unit);
    const auto tos = all_of(way.to, unit);
    const auto count = static_cast<int>(std::max(froms.size(), tos.size()));
    for (const Spec& from : froms) {
        for (const Spec& to : tos) {
            const Worst found = worst_error(from, to, fast(from, to), inputs(from, to, count > 1 ? size / 12 : size));
            if (found.error > worst.error) {
                worst = found;
            }
        }
    }
    return worst;
}

Spec spec(std::string_view text) { return std::get<Spec>(rotconv::parse_spec(text)); }

Converted converted(const Spec& from, const Spec& to, std::span<const double> rows,
                    const rotconv::ConversionSettings& settings) {
    const rotconv::Conversion conversion(from, to, settings);
    Converted result{std::vector<double>(rows.size() / from.size() * to.size()), {}};
    std::vector<rotconv::RowReport> reports;
    conversion.run(rows, result.numbers, reports);
    result.report = reports.empty() ? rotconv::RowReport{} : reports.front();
    return result;
}

std::string text_of(std::span<const double> row) {
    std::ostringstream text;
    text.precision(17);
    for (const double number : row) {
        text << ' ' << number;
    }
    return text.str();
}

std::string text_of(const char* path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<double> joined(std::vector<double> first, const std::vector<double>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

} // namespace accuracy
