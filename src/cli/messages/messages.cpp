#include "messages.hpp"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <tuple>

#include "../../core/projects.hpp"
#include "../../core/representations/codec.hpp"
#include "../../stream/bytes/io_block.hpp"
#include "../../stream/pairs/key.hpp"

namespace rotconv::cli::messages {
namespace {

/// What to write instead of a text that is not read as a key.
std::string_view fix_hint(stream::KeyError error) {
    using enum stream::KeyError;
    switch (error) {
    case none:
    case not_a_number: break;
    case too_large: return "keys are below 1e20 in size";
    case not_a_time: return "a time is like 2026-11-22T13:00:00.5Z: in UTC, with a decimal point, no leap second";
    case blank:
        return R"(a time is written as 2026-11-22T13:00: sed -e 's,\(-[0-9]*\)[ /][ /]*\([0-9]*:\),\1T\2,' -e t )"
               R"(-e 's,[0-9]\{4\}-[0-9-]*,&T00:00,' FILE | rotconv ...)";
    case has_unit: return "such times are in seconds: leave out --time-unit";
    }
    return {};
}

/// A row of blanks that begins with a date and a time of day, which are two fields.
bool has_blank_in_time(std::string_view row) {
    const std::size_t blank = row.find(' ');
    const std::size_t colon = row.find(':');
    return colon != std::string_view::npos && row.find_first_not_of(" /0123456789", blank) == colon &&
           stream::read_key(row.substr(0, blank)).error == stream::KeyError::blank;
}

/// What the figure of a diagnostic is, and what the diagnostic means.
struct DiagnosticWords {
    std::string_view figure, meaning;
};
DiagnosticWords words_for(DiagnosticKind kind) {
    using enum DiagnosticKind;
    switch (kind) {
    case normalized: return {"defect", "the numbers were not exactly those of a rotation"};
    case axis_length: return {"defect", "the axis is not of length 1; its angle comes last: nx ny nz angle"};
    case large_angle:
        return {"angle",
                "angles and velocities are read in radians; if these are degrees: -d, or append :deg to the SPEC"};
    case gimbal_lock:
        return {"margin", "only the sum or difference of the outer angles is defined; the third is set to 0"};
    case near_gimbal_lock: return {"condition", "the outer angles are ill-conditioned, the attitude is not"};
    case half_turn: return {"margin", "the axis and its opposite give the same attitude; the sign is a convention"};
    case infinite: return {"margin", "a half-turn has no finite Cayley vector"};
    case identity_axis: return {"margin", "every axis gives the same attitude; (1, 0, 0) is a convention"};
    case method_error: return {"angle", "the method's answer is off by more than 1e-6 rad"};
    case coarse_step:
        return {"estimate", "the error of a step may exceed 1e-3 rad; --substeps or a finer sampling helps"};
    case beyond: return {"angle", "the attitudes differ by more than --within"};
    }
    return {};
}

/// A size to two digits, such as 1.4e18.
std::string rough(double size) {
    std::string text = fmt::format("{:.2g}", size);
    const std::size_t power = text.find("e+");
    return power == std::string::npos ? text : text.erase(power + 1, text[power + 2] == '0' ? 2 : 1);
}

std::string width_of(const stream::RowError& error) {
    return fmt::format("{} where line {} has {}", counted(error.found, "field"), error.first_line, error.expected);
}

std::string why(const stream::RowError& error, const Subject& subject) {
    const Representation& entry = representation(subject.representation);
    switch (error.what) {
    case stream::RowError::What::not_a_number: return "not a number";
    case stream::RowError::What::too_large: return "too large for a double";
    case stream::RowError::What::wrong_count:
        return fmt::format("{} where {} has {}{}", counted(error.found, "field"), subject.text, error.expected,
                           error.found <= error.expected ? "" : " (select with --columns)");
    case stream::RowError::What::missing_column:
        return fmt::format("no column {}, the row has {}", error.expected, error.found);
    case stream::RowError::What::other_width:
        return width_of(error) + " (--on-error skip leaves such rows out, --ragged takes them)";
    case stream::RowError::What::key_order: return "the key does not increase";
    case stream::RowError::What::no_partner:
        return fmt::format("no partner in REFERENCE{}", error.error == Error::past_half_turn
                                                            ? ", whose attitudes around the key lie half a turn apart"
                                                            : "");
    case stream::RowError::What::open_quote: return "a quote is left open";
    case stream::RowError::What::key:
        return error.key == stream::KeyError::too_large ? "too large for a key" : "not a supported time";
    case stream::RowError::What::attitude: break;
    }
    switch (error.error) {
    case Error::rank_deficient:
        return subject.representation == RepresentationId::dcm ? "the matrix is nearly of rank one"
                                                               : "the two columns do not span a plane";
    case Error::singular:
        return fmt::format("{} has no rates at {}{}", entry.text, codec_of(entry.name).singular_attitude,
                           subject.has_steps ? ", and a step came too near to it (--substeps)" : "");
    case Error::coarse_step:
        return fmt::format("the body may turn by more in one step than {} can follow (--substeps; --time-unit)",
                           entry.text);
    case Error::defect:
        return fmt::format("defect {} is above the tolerance {} (--tolerance){}", error.defect, subject.tolerance,
                           error.norm > 0.0 ? fmt::format(", its norm is {:.12g}", error.norm) : "");
    default: return std::string(message(error.error));
    }
}

/// What to do about it.
std::string after_text(const stream::RowError& error) {
    using What = stream::RowError::What;
    if (error.what == What::key && error.place.is_in_reference() && error.key == stream::KeyError::has_unit) {
        return "; such times are in seconds: --reference-time-unit s";
    }
    if (error.what == What::not_a_number && error.first_line > 0) {
        return "; " + width_of(error);
    }
    const bool has_blank = error.what == What::wrong_count && has_blank_in_time(error.text);
    const auto key = has_blank ? stream::KeyError::blank : error.key;
    return error.what == What::key || has_blank ? fmt::format("; {}", fix_hint(key)) : "";
}

} // namespace

Subject subject_of(const stream::RowNumbers& numbers, double tolerance) {
    const auto& [first, second] = std::tie(numbers.attitude, numbers.second);
    if (!first) {
        return {.tolerance = tolerance};
    }
    const std::string_view name = representation(first->name).text;
    return {!second                           ? std::string(name)
            : first->text() == second->text() ? fmt::format("{} twice", name)
                                              : fmt::format("{} with {}", name, representation(second->name).text),
            first->name, tolerance};
}

std::vector<std::string_view> names_of(const Representation& entry) {
    auto names = filtered(entry.aliases, [](std::string_view alias) { return !alias.empty(); });
    names.insert(names.begin(), entry.text);
    return names;
}

std::vector<std::string_view> all_names() {
    std::vector<std::string_view> names;
    for (const Representation& entry : mapped(all_representations, representation)) {
        std::ranges::copy(names_of(entry), std::back_inserter(names));
    }
    std::ranges::copy(mapped(filtered(projects(), &Project::is_spec), &Project::text), std::back_inserter(names));
    return names;
}

std::vector<std::string_view> all_presets() { return mapped(presets(), &Project::text); }

std::vector<std::string> all_sequences() { return mapped(EulerSequence::all(), &EulerSequence::text); }

std::vector<std::string_view> words_of(const ModifierSet& modifiers) {
    const auto set = filtered(all_modifiers, [&modifiers](Modifier modifier) { return modifiers.has(modifier); });
    return mapped(set, [](Modifier modifier) { return name_of(modifier); });
}

std::string explain(const stream::RowError& error, const Subject& subject) {
    return fmt::format("{}: {}{}", why(error, subject), quoted(error.text), after_text(error));
}

std::string explain(const stream::StreamError& error, const Subject& subject) {
    using What = stream::StreamError::What;
    switch (error.what) {
    case What::read: return fmt::format("cannot be read: {}", std::generic_category().message(error.error_number));
    case What::write: return fmt::format("cannot be written: {}", std::generic_category().message(error.error_number));
    case What::partial_row: return fmt::format("the row that begins at byte {} is not whole", error.offset);
    case What::line_too_long:
        return fmt::format("the line is longer than {} MiB", stream::IoBlockReader::longest_line >> 20U);
    case What::json: return "the input looks like JSON";
    case What::far_key: return "the row cannot be paired: too many comments and failed rows stand before the next key";
    case What::count: return fmt::format("{}: {}", error.wrong, quoted(error.column.text));
    case What::columns: return explain(error.column, subject.text);
    }
    return {};
}

std::string explain(const stream::ColumnError& error, std::string_view subject) {
    using What = stream::ColumnError::What;
    switch (error.what) {
    case What::not_an_item:
        return fmt::format("{} is neither an index from 1, nor a range such as 5-8, nor a name", quoted(error.text));
    case What::wrong_count:
        return fmt::format("{} selects {} where {} has {}", quoted(error.text), counted(error.count, "column"), subject,
                           counted(error.wanted, "number"));
    case What::twice: return fmt::format("column {} is selected twice", quoted(error.text));
    case What::missing:
        return fmt::format("not a header: the row lacks the selected columns {} (it has {}){}: {}",
                           quoted_list(error.lacking), quoted_list(error.present),
                           error.header.empty() ? "" : "; the columns are " + numbered(error.header),
                           quoted(error.text));
    case What::other_width:
        return fmt::format("the header has {} and this row {}: {}; select by index", counted(error.count, "name"),
                           counted(error.fields, "field"), quoted(error.text));
    case What::none:
        return fmt::format("{} where {} has {} (select with --columns){}: {}", counted(error.fields, "field"), subject,
                           error.wanted, error.header.empty() ? "" : "; the columns are " + numbered(error.header),
                           quoted(error.text));
    case What::ambiguous:
        return fmt::format("more than one column is called {}: {}; select by index", quoted(error.text),
                           fmt::join(error.indices, " and "));
    }
    return {};
}

std::string few_keys_met(const stream::PairingStats& keys, const stream::Pairing& pairing) {
    const std::string within = pairing.within.text();
    const std::string_view few = keys.any_pair ? "fewer than half of FILE's keys are" : "no key of FILE is";
    std::string text = pairing.interpolates ? fmt::format("{} between two of REFERENCE at most {} apart", few, within)
                       : keys.any_pair      ? fmt::format("fewer than half of FILE's keys match within {}", within)
                                            : fmt::format("{} within {} of one of REFERENCE", few, within);
    std::string mend;
    if (keys.nearest && *keys.nearest > pairing.within) {
        text += fmt::format("; the nearest {}are {} apart", keys.any_pair ? "others " : "", keys.nearest->text());
        mend = ": --key-within";
    }
    if (!keys.ranges[0] || !keys.ranges[1]) {
        return text + mend;
    }
    const auto& [own, reference] = std::pair(*keys.ranges[0], *keys.ranges[1]);
    const auto size_of = [](const stream::PairingStats::Range& range) {
        return std::max(std::abs(range.first.rounded()), std::abs(range.last.rounded()));
    };
    const auto span_of = [&size_of](const stream::PairingStats::Range& range) {
        return range.first < range.last ? distance(range.first, range.last).rounded() : size_of(range);
    };
    const double span = span_of(own);
    const double other = span_of(reference);
    if (std::min(span, other) > 0.0 && std::max(span, other) >= 900.0 * std::min(span, other)) { // other units
        return text + fmt::format("; FILE's go to {}, REFERENCE's to {}: --time-unit", rough(size_of(own)),
                                  rough(size_of(reference)));
    }
    text += mend;
    if (own.last < reference.first || reference.last < own.first) {
        text += fmt::format("; all of FILE's are {} REFERENCE's: --key-offset",
                            own.last < reference.first ? "before" : "after");
    }
    return text;
}

std::string_view meaning(const stream::Diagnostic& diagnostic) { return words_for(diagnostic.kind).meaning; }

std::string describe(const stream::Diagnostic& diagnostic) {
    return fmt::format("{}: {} {:.3g}{}{}; {}", name_of(diagnostic.kind), words_for(diagnostic.kind).figure,
                       diagnostic.figure, diagnostic.unit.empty() ? "" : " ", diagnostic.unit, meaning(diagnostic));
}

} // namespace rotconv::cli::messages
