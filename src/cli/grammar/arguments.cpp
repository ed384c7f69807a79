#include "arguments.hpp"

#include <cmath>
#include <variant>

#include <rotconv/rates.hpp>

#include "../../operations/operations.hpp"
#include "../../stream/beginning/delimiter.hpp"
#include "../../stream/numbers/number_text.hpp"
#include "values.hpp"

namespace rotconv::cli {
namespace {

[[noreturn]] void refuse(const Option& option, const GivenNumbers& read, stream::RowError error,
                         double tolerance = 0.0) {
    error.text = read.row;
    throw Usage("{}: {}{}", option.name(),
                messages::explain(error, messages::subject_of({.attitude = read.spec}, tolerance)),
                messages::fix_hint(error));
}

Spec spec_of(const Option& option, const std::string& text, bool degrees) {
    if (text.empty()) {
        throw MissingSpec("{} SPEC is missing", option.name());
    }
    const auto parsed = parse_spec(text);
    if (const auto* error = std::get_if<SpecError>(&parsed)) {
        if (std::ranges::all_of(split(text, ','), messages::is_spec)) {
            throw Usage("{} {}: it takes one SPEC here", option.name(), quoted(text));
        }
        throw messages::no_such_spec(option, text, *error);
    }
    const Spec& spec = std::get<Spec>(parsed);
    return degrees ? spec.in_degrees() : spec;
}

} // namespace

double number_of(const Option& option, double default_value, std::string_view must,
                 const std::function<bool(double)>& holds) {
    double value = default_value;
    const std::string& text = option.text();
    if (option.given() && (stream::read_number(text, value) != stream::NumberError::none || !holds(value))) {
        throw Usage("{} {} must be a {}", option.name(), quoted(text), must);
    }
    return value;
}

double amount_of(const Option& option, double default_value, bool infinite) {
    return number_of(option, default_value,
                     infinite ? "number that is not negative" : "finite number that is not negative",
                     [infinite](double value) { return value >= 0.0 && (infinite || !std::isinf(value)); });
}

std::size_t count_of(const Option& option, std::size_t most, std::size_t least, std::size_t default_value) {
    return static_cast<std::size_t>(
        number_of(option, static_cast<double>(default_value), fmt::format("whole number from {} to {}", least, most),
                  [least, most](double value) {
                      return value == std::floor(value) && value >= static_cast<double>(least) &&
                             value <= static_cast<double>(most);
                  }));
}

int time_power_of(const Option& option) { return one_of("time unit", option, time_units); }

double GivenAngle::in(const AngleUnitName& other) const noexcept {
    if (!unit || unit->text == other.text) {
        return value;
    }
    const double radians = unit->text == "deg" ? value * radians_per_degree : value / unit->per_radian;
    return radians * other.per_radian;
}

GivenAngle given_angle(const Option& option, const std::string& text, bool degrees) {
    static constexpr std::array<AngleUnitName, 3> units{{{"mrad", 1000.0}, {}, in_degrees}};
    const auto* unit = std::ranges::find_if(units, [&](const auto& each) { return text.ends_with(each.text); });
    const bool has_unit = unit != units.end();
    const std::string number = text.substr(0, text.size() - (has_unit ? unit->text.size() : 0));
    double value = 0.0;
    if (stream::trimmed(number) != number || stream::read_number(number, value) != stream::NumberError::none ||
        !(value >= 0.0)) {
        throw Usage("{} {} must be an angle that is not negative, such as 0.3deg, 5mrad or 0.1rad", option.name(),
                    quoted(text));
    }
    if (!has_unit && !degrees && value != 0.0) {
        std::vector<Mend> mends;
        for (const char* const each : {"deg", "rad"}) {
            std::string argument = option.texts.back(); // perhaps with a percentage
            argument.insert(std::min(number.size(), argument.size()), each);
            mends.push_back({{{option.place, 1, {argument}}}});
        }
        throw Usage("{0} {1}: {1}deg or {1}rad?", option.name(), number).with(std::move(mends));
    }
    const AngleUnitName own = has_unit ? *unit : in_degrees;
    return has_unit || degrees ? GivenAngle{fmt::format("{} {}", number, own.text), value, own} : GivenAngle{number};
}

double angle_of(const Option& option, bool degrees, double default_value) {
    const double angle = option.given() ? given_angle(option, option.text(), degrees).in({}) : default_value;
    if (std::isinf(angle)) {
        throw Usage("{} {} must be a finite angle", option.name(), quoted(option.text()));
    }
    return angle;
}

Spec spec_of(const Option& option, bool degrees) { return spec_of(option, option.text(), degrees); }

std::vector<Spec> specs_of(const Option& option, bool degrees) {
    std::vector<Spec> specs;
    std::vector<std::string> names;
    for (const std::string_view text : split(option.text(), ',')) {
        if (text.empty() && option.given()) {
            throw Usage("{} {}: a SPEC of this list is empty", option.name(), quoted(option.text()));
        }
        specs.push_back(spec_of(option, std::string(text), degrees));
        for (const std::string& name : operations::names_of(specs.back())) {
            if (std::ranges::count(names, name) > 0) {
                throw Usage("{} {}: two of these have a column {}", option.name(), quoted(option.text()), quoted(name));
            }
            names.push_back(name);
        }
    }
    return specs;
}

void require_rates(const Option& option, const Spec& spec) {
    if (!has_rates(spec.name)) {
        throw Usage("{} {}: its axis has no rate at the identity, but rotvec has one", option.name(),
                    representation(spec.name).text);
    }
}

GivenNumbers numbers_of(const Option& option, bool degrees) {
    constexpr std::size_t longest_spec = 100;
    const std::string& text = option.text();
    std::size_t colon = text.rfind(':'); // of those before numbers, the last that ends a SPEC; or the blank that does
    const std::size_t end = std::min(text.find_first_of(" \t"), longest_spec);
    const auto is_spec_before = [&text](std::size_t at) {
        return at < text.size() && std::holds_alternative<Spec>(parse_spec(text.substr(0, at)));
    };
    for (std::size_t at = text.find(':'); at < end; at = text.find(':', at + 1)) {
        colon = is_spec_before(at) ? at : colon;
    }
    colon = is_spec_before(end) ? end : colon;
    if (colon == std::string::npos) {
        throw Usage("{} needs 'SPEC: NUMBERS' in one argument, such as 'quat: 1 0 0 0', not {}", option.name(),
                    quoted(text));
    }
    GivenNumbers read{spec_of(option, text.substr(0, colon), degrees),
                      stream::trimmed(std::string_view(text).substr(colon + 1))};
    Values values;
    try {
        values = values_of({std::string(read.row)}, std::nullopt, operations::attitude_numbers(read.spec),
                           text.substr(0, colon), false);
    } catch (const Usage& error) {
        throw Usage("{}: {}", option.name(), std::string_view(error.what()).substr(argument_error.size()));
    }
    read.notes = std::move(values.notes);
    const auto fields = values.fields();
    if (fields.size() != read.spec.size()) {
        throw Usage("{}: {} has {} numbers, not {}: {}", option.name(), representation(read.spec.name).text,
                    read.spec.size(), fields.size(), quoted(read.row));
    }
    for (const std::string_view field : fields) {
        const auto error = stream::read_number(field, read.numbers.emplace_back());
        if (error != stream::NumberError::none) {
            using What = stream::RowError::What;
            refuse(option, read,
                   {.what = error == stream::NumberError::too_large ? What::too_large : What::not_a_number});
        }
    }
    return read;
}

FixedRotation attitude_of(const Option& option, bool degrees, double tolerance) {
    if (!option.given()) {
        return {};
    }
    const GivenNumbers read = numbers_of(option, degrees);
    std::array<double, 4> q{};
    std::vector<RowReport> reports;
    Conversion(read.spec, Spec{}, {.tolerance = tolerance}).run(read.numbers, q, reports);
    if (!reports.empty() && reports.front().error != Error::none) {
        refuse(option, read, {.error = reports.front().error, .defect = reports.front().defect}, tolerance);
    }
    return FixedRotation::of_numbers(read.spec, read.numbers);
}

std::array<AxesChange, 2> axes_of(const Option& reference_axes, const Option& body_axes) {
    const std::array<const Option*, 2> options{&reference_axes, &body_axes};
    std::array<AxesChange, 2> changes;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto parsed = parse_axes(options.at(i)->given() ? options.at(i)->text() : "xyz:xyz");
        if (const auto* error = std::get_if<AxesError>(&parsed)) {
            throw Usage("{} {}", options.at(i)->name(),
                        message(AxesError{error->what, shortened(error->text), error->triple}));
        }
        changes.at(i) = std::get<AxesChange>(parsed);
    }
    if (changes[0].changes_hand() != changes[1].changes_hand()) {
        const std::size_t changing = changes[0].changes_hand() ? 0 : 1;
        const std::string& text = options.at(changing)->text();
        const auto colon = text.find(':');
        throw Usage("{0} {1} changes hand, because {2} is left-handed; so must {3}, such as {3} {1}",
                    options.at(changing)->name(), text,
                    quoted(changes.at(changing).from_left_handed ? text.substr(0, colon) : text.substr(colon + 1)),
                    options.at(1 - changing)->name());
    }
    return changes;
}

} // namespace rotconv::cli
