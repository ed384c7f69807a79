#include "options.hpp"

#include <array>
#include <cmath>
#include <span>
#include <variant>

#include <rotconv/rates.hpp>

#include "../stream/delimiter.hpp"
#include "../stream/fmt.hpp"
#include "../stream/number_text.hpp"

namespace rotconv::cli {

Spec spec_of(std::string_view option, const std::string& text, bool degrees) {
    if (text.empty()) {
        throw MissingSpec(fmt::format("{} SPEC is missing; see rotconv --help", option));
    }
    const auto parsed = parse_spec(text);
    if (const auto* error = std::get_if<SpecError>(&parsed)) {
        throw Usage(fmt::format("{} {}: {}", option, quoted(text), messages::explain(*error)));
    }
    const Spec& spec = std::get<Spec>(parsed);
    return degrees ? spec.in_degrees() : spec;
}

void require_rates(std::string_view option, const Spec& spec) {
    if (!has_rates(spec.name)) {
        throw Usage(fmt::format("{} {}: its axis has no rate at the identity; rotvec has", option,
                                representation(spec.name).text));
    }
}

FixedRotation attitude_of(std::string_view option, const std::string& text, bool degrees, double tolerance) {
    const auto colon = text.rfind(':');
    if (colon == std::string::npos) {
        throw Usage(fmt::format("{} {} is not SPEC: NUMBERS, such as 'quat: 1 0 0 0'", option, quoted(text)));
    }
    const Spec spec = spec_of(option, text.substr(0, colon), degrees);
    const std::string_view row = stream::trimmed(std::string_view(text).substr(colon + 1));
    stream::RowError error;
    error.text = row;
    const auto refuse = [&](stream::RowError::What what) {
        error.what = what;
        throw Usage(fmt::format("{}: {}", option, messages::explain(error, messages::subject_of(spec, tolerance))));
    };
    std::vector<std::string_view> fields;
    stream::Delimiter::of_row(row).split(row, fields);
    if (fields.size() != spec.size()) {
        throw Usage(fmt::format("{}: {} has {} numbers, not {}: {}", option, representation(spec.name).text,
                                spec.size(), fields.size(), quoted(row)));
    }
    std::array<double, 9> numbers{};
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto number_error = stream::read_number(fields[i], numbers.at(i));
        if (number_error != stream::NumberError::none) {
            refuse(number_error == stream::NumberError::too_large ? stream::RowError::What::too_large
                                                                  : stream::RowError::What::not_a_number);
        }
    }
    std::array<double, 4> q{};
    std::vector<RowReport> reports;
    Conversion(spec, Spec{}, {.tolerance = tolerance}).run(std::span(numbers).first(spec.size()), q, reports);
    if (!reports.empty() && reports.front().error != Error::none) {
        error.error = reports.front().error;
        error.defect = reports.front().defect;
        refuse(stream::RowError::What::attitude);
    }
    return FixedRotation::of_numbers(spec, std::span(numbers).first(spec.size()));
}

double amount_of(std::string_view option, const std::string& text, double default_value, bool infinite) {
    if (text.empty()) {
        return default_value;
    }
    double value = 0.0;
    if (stream::read_number(text, value) != stream::NumberError::none || !(value >= 0.0) ||
        (std::isinf(value) && !infinite)) {
        throw Usage(fmt::format("{} {} must be a {}number that is not negative", option, quoted(text),
                                infinite ? "" : "finite "));
    }
    return value;
}

int count_of(std::string_view option, const std::string& text, int most, int least) {
    if (text.empty()) {
        return 0;
    }
    double value = 0.0;
    if (stream::read_number(text, value) != stream::NumberError::none || value != std::floor(value) || value < least ||
        value > most) {
        throw Usage(fmt::format("{} {} must be a whole number from {} to {}", option, quoted(text), least, most));
    }
    return static_cast<int>(value);
}

Frame frame_of(const std::string& text) {
    return choose<Frame>("frame", text, {{"body", Frame::body}, {"reference", Frame::reference}});
}

int time_power_of(const std::string& text) {
    return choose<int>("time unit", text, {{"s", 0}, {"ms", -3}, {"us", -6}, {"ns", -9}});
}

} // namespace rotconv::cli
