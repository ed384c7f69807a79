#include <cmath>
#include <span>
#include <utility>

#include "../stream/numbers/fmt.hpp"
#include "between.hpp"
#include "operations.hpp"

// The operations that are a function of the core, and the names of their numbers.
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

Operation operation_of(RowFunction function, stream::RowNumbers input, std::vector<std::string> names) {
    auto made = std::make_shared<stream::RowOperation>();
    made->input = std::move(input);
    made->parts = {{.names = std::move(names), .function = std::move(function)}};
    return made;
}

Operation operation_of(RowFunction function, stream::RowNumbers input, const Spec& to, bool continuous) {
    Operation made = operation_of(std::move(function), std::move(input), names_of(to));
    made->parts[0].attitude = to;
    if (auto numbers = std::make_shared<ContinuousNumbers>(to); continuous && numbers->have_choice()) {
        made->parts[0].follows = std::move(numbers);
    }
    return made;
}

Operation several(const std::vector<Operation>& operations) {
    Operation all = operations.front();
    for (const Operation& more : std::span(operations).subspan(1)) {
        all->parts.push_back(more->parts.front());
    }
    return all;
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

namespace {

/// See ResultPart::again.
auto again_by(const auto& core) {
    return [core](const stream::NumberRows& rows, std::size_t row, std::span<double> numbers, std::span<double> rest) {
        const std::size_t size = rows.numbers.size() / rows.lines.size();
        core.again(std::span(rows.numbers).subspan(row * size, size), numbers, rest);
    };
}

} // namespace

Operation convert(const Conversion& conversion, bool continuous) {
    auto made = operation_of(function_of(conversion), attitude_numbers(conversion.from()), conversion.to(), continuous);
    made->parts[0].again = again_by(conversion);
    return made;
}

Operation compose(const Composition& composition, const PairedRows& rows, bool continuous) {
    const Spec& first = composition.first();
    const Spec& to = composition.to();
    const Spec& second = composition.second();
    const Composition between = composition.interpolating();
    auto made = operation_of(of_pairs(function_of(composition), function_of(between), rows, first.size(), second,
                                      composition.settings(), true),
                             pair_numbers(attitude_numbers(first), rows, second), to, continuous);
    made->parts[0].again = again_by(composition);
    if (rows.interpolates) {
        made->parts[0].again = [=](const stream::NumberRows& pairs, std::size_t row, std::span<double> numbers,
                                   std::span<double> rest) {
            std::vector<double> all;
            append_pair(pairs, row, first.size(), second.size(), all);
            (is_at_row(pairs, row, second.size()) ? composition : between).again(all, numbers, rest);
        };
    }
    return made;
} // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): the functions free what they hold

Operation rotate(const VectorRotation& rotation) {
    const std::vector<std::string> vector{"x", "y", "z"};
    const stream::RowNumbers numbers{.names = concatenated(names_of(rotation.from()), vector),
                                     .attitude = rotation.from()};
    auto made = operation_of(function_of(rotation), numbers, vector);
    made->keeps_names = true;
    return made;
}

Operation rates(const Spec& spec, const RateSettings& settings) {
    const auto of_numbers = names_of(spec, "_rate");
    const auto& taken = settings.inverse ? of_numbers : velocity_names(false);
    const auto& made = settings.inverse ? velocity_names(settings.degrees) : of_numbers;
    const stream::RowNumbers numbers{.names = concatenated(names_of(spec), taken), .attitude = spec};
    return operation_of(function_of(Rates(spec, settings)), numbers, made);
}

Operation sample(const Spec& spec, const SampleSettings& settings) {
    const auto function = [sampler = Sampler(spec, settings)](const auto& rows, auto out, auto& reports,
                                                              auto /*rest*/) mutable {
        reports.clear();
        sampler.run(rows.numbers, out);
        return rows.lines.size();
    };
    return operation_of(function, {.names = {"index"}}, spec, false);
}

Operation identify(const IdentificationRows& rows, std::shared_ptr<Identification> identification) {
    const auto function = [identification = std::move(identification)](const auto& numbers, auto /*out*/, auto& reports,
                                                                       auto /*rest*/) {
        identification->add(numbers.numbers, numbers.lines, reports);
        return numbers.lines.size();
    };
    stream::RowNumbers numbers;
    for (std::size_t i = 0; i < rows.count; ++i) {
        numbers.names.push_back(fmt::format("n{}", i + 1));
    }
    const bool is_known_beside = rows.paired || rows.count == 0; // or not yet known
    auto made =
        operation_of(function, pair_numbers(std::move(numbers), {is_known_beside, rows.by_key}, rows.known), {"angle"});
    made->in_order = true;
    return made;
}

Operation method(const MethodConversion& conversion, bool continuous) {
    const auto function = [conversion, angles = std::vector<double>()](const auto& rows, auto out, auto& reports,
                                                                       auto /*rest*/) mutable {
        conversion.run(rows.numbers, out, angles, reports);
        return rows.lines.size();
    };
    return operation_of(function, attitude_numbers(conversion.from()), conversion.to(), continuous);
}

Operation all_methods(const std::vector<MethodConversion>& methods, std::shared_ptr<MethodAnswers> answers) {
    const auto function = [methods, answers = std::move(answers)](const auto& rows, auto out, auto& reports,
                                                                  auto /*rest*/) {
        reports.clear();
        for (const MethodConversion& method : methods) {
            std::vector<double> angles;
            std::vector<RowReport> found;
            method.run(rows.numbers, out, angles, found);
            answers->numbers.insert(answers->numbers.end(), out.begin(), out.end());
            answers->angles.insert(answers->angles.end(), angles.begin(), angles.end());
            for (const RowReport& report : found) { // all have the same of rotconv's own conversion
                RowReport& worst = stream::report_of(report.row, reports);
                worst = worst.deviation > report.deviation || std::isnan(worst.deviation) ? worst : report;
            }
        }
        return rows.lines.size();
    };
    return operation_of(function, attitude_numbers(methods.front().from()), methods.front().to(), false);
}

} // namespace rotconv::operations
