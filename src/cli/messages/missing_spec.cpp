#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <rotconv/spec.hpp>

#include "../../core/projects.hpp"
#include "../../operations/operations.hpp"
#include "../../stream/beginning/header_line.hpp"
#include "../../stream/bytes/file.hpp"
#include "../../stream/numbers/number_text.hpp"
#include "../../stream/rows/row_blocks.hpp"
#include "../grammar/column_names.hpp"
#include "../grammar/values.hpp"
#include "answers.hpp"
#include "messages.hpp"

namespace rotconv::cli {
namespace {

/// The SPECs of rows whose width is that of no representation.
// NOLINTNEXTLINE(cert-err58-cpp): without memory nothing works
const std::vector<std::string> any_quaternion{"quat", "quat:xyzw"};

std::vector<double> numbers_in(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return std::string_view(",;[](){}\t\n").find(c) != std::string_view::npos; }, ' ');
    std::vector<double> numbers;
    for (const std::string& word : words_in(text)) {
        double number = 0.0;
        if (stream::read_number(word, number) == stream::NumberError::none) {
            numbers.push_back(number);
        }
    }
    return numbers;
}

constexpr auto possible_specs =
    std::to_array<std::string_view>({"quat", "quat:xyzw", "rpy", "rotvec", "axis-angle", "dcm", "dcm:passive", "6d",
                                     "5d", "euler:ZYX", "cayley", "mrp"});

/// The SPECs that have as many numbers, which `said` names with their orders; all where none has.
std::vector<std::string> specs_of_numbers(const std::vector<double>& numbers, std::string& said) {
    constexpr double most_radians = 6.3;
    const bool is_large = std::ranges::any_of(numbers, [](double number) { return std::abs(number) > most_radians; });
    std::vector<std::string> specs;
    std::vector<std::string> told;
    for (const std::string_view text : possible_specs) {
        Spec spec = *messages::spec_of(text);
        if (spec.size() == numbers.size()) {
            spec = is_large ? spec.in_degrees() : spec;
            specs.push_back(spec.text());
            told.push_back(fmt::format("{} ({})", spec.text(), fmt::join(operations::names_of(spec), " ")));
        }
    }
    said += told.empty() ? "" : fmt::format("; {} are {}", counted(numbers.size(), "number"), joined(told, ", "));
    return specs.empty() ? std::vector<std::string>(possible_specs.begin(), possible_specs.end()) : specs;
}

/// The SPECs of rotconv's own whose numbers have the labels of VALUEs.
std::vector<std::string> specs_of_labels(const std::string& values) {
    std::vector<std::string> specs;
    if (values.find_first_of("=:") == std::string::npos) {
        return specs;
    }
    for (const std::string_view name : possible_specs) {
        const Spec spec = *messages::spec_of(name);
        bool means_other = false;
        if (attitude_in(values, operations::attitude_numbers(spec), name, means_other)) {
            const bool has_own_name = values.find(operations::names_of(spec)[0]) != std::string::npos; // rx of rotvec
            specs.insert(has_own_name ? specs.begin() : specs.end(), spec.text());
        }
    }
    return specs;
}

/// The SPECs that a file's names or numbers are; `said` names its columns.
std::vector<std::string> specs_of_file(const std::string& name, const std::string& bytes, std::string& said) {
    if (bytes.empty()) {
        return {};
    }
    static constexpr std::array<const char*, 4> known{"quat", "dcm", "rpy", "euler:bunge"};
    const auto fits = [](const char* spec, const std::vector<std::string>& names) {
        const auto set = find_names(*messages::spec_of(spec), names);
        return set && (set->decides || spec == known[0]); // q0 q1 q2 q3
    };
    stream::InputOptions input;
    input.columns_of = [&fits](const std::vector<std::string>& names) {
        return stream::ChosenColumns{
            .are_known = std::ranges::any_of(known, [&](const char* spec) { return fits(spec, names); })};
    };
    stream::TextSource source(bytes);
    stream::RowBlocks blocks(source, input, nullptr, stream::IoBlockReader::largest_block);
    stream::Job job;
    while (!blocks.has_row() && blocks.read(job)) {
    }
    const stream::Line line = blocks.has_row() ? stream::next_line(job.block.text) : stream::Line();
    const stream::HeaderLine row(line, stream::Delimiter::of_row(line.text));
    if (2 * std::ranges::count_if(row.fields, stream::is_number) <= std::ranges::ssize(row.fields)) {
        const std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
        const std::string_view begin = std::string_view(bytes).substr(first, 2);
        const bool is_json = begin.starts_with('{') || (begin.size() == 2 && begin[0] == '[' && begin[1] < 'A');
        said += fmt::format("; {} {}", name, is_json ? "looks like JSON" : "does not begin with a row of numbers");
        return {possible_specs.begin(), possible_specs.end()}; // the whole may be one attitude
    }
    const std::vector<std::string>& header = blocks.layout(stream::Side::stream)->names;
    const auto names = header.empty() ? std::vector<std::string>(row.fields.begin(), row.fields.end()) : header;
    said += fmt::format("; {} has {}: {}", name, counted(row.fields.size(), "column"), numbered(names));
    std::vector<std::string> specs;
    for (const char* spec : known) {
        if (fits(spec, names)) {
            specs.emplace_back(spec);
        }
    }
    if (specs.empty() && header.empty()) { // a matrix may be of several lines
        const std::size_t size = row.fields.size();
        specs = size == 3                               ? std::vector<std::string>{"dcm", "rpy", "rotvec"}
                : size == 4                             ? std::vector<std::string>{"quat", "quat:xyzw", "dcm"}
                : size == 9 || size == 12 || size == 16 ? std::vector<std::string>{"dcm"}
                                                        : any_quaternion;
    }
    return specs;
}

} // namespace

Usage missing_spec(const CommandOptions& options, const MissingSpec& error) {
    const Option* const from = options.find("--from");
    const std::string& given = options.file();
    const std::string path = given.empty() && options.values.empty() ? stream::File::name_of_input() : given;
    const bool is_identify = options.command_name() == "identify" && !from->given();
    bool lacks_from = is_identify || std::string_view(error.what()).starts_with("--from");
    std::vector<std::string> specs;
    std::string said = error.what();
    said += is_identify ? ": identify needs rows that also have the attitude in a known convention" : "";
    if (!lacks_from) {
        const std::string& own = from != nullptr ? from->text() : "";
        const auto spec = messages::spec_of(own);
        const bool is_quat = spec && spec->name == RepresentationId::quat;
        specs = options.has("--by") ? std::vector<std::string>{own}
                : is_quat           ? std::vector<std::string>{"rpy:deg", "dcm"}
                                    : std::vector<std::string>{"quat"};
    } else if (!options.values.empty()) {
        const std::string values = joined(options.values, " ");
        const auto by_count = specs_of_numbers(numbers_in(values), said);
        specs = specs_of_labels(values);
        std::ranges::copy_if(by_count, std::back_inserter(specs),
                             [&specs](const std::string& each) { return std::ranges::count(specs, each) == 0; });
    } else if (const auto bytes = path.empty() ? std::optional(stream::File::lines_of_pipe()) : first_bytes(path)) {
        specs = specs_of_file(path.empty() ? "the input" : quoted(path), *bytes, said);
        const auto dot = path.rfind('.');
        const Project* const project = dot == std::string::npos ? nullptr : find_project(path.substr(dot + 1));
        if (project != nullptr && project->is_spec() && specs.size() != 1) { // scan.ctf
            specs = {std::string(project->text)};
        }
    }
    const bool has_known = is_identify && specs == any_quaternion; // rows are wide enough for a known attitude
    if (has_known) {
        specs = {"quat"};
        lacks_from = false;
    }
    std::string of_reference; // as its names say
    if (options.files.size() == 2 && options.has("--within") && options.missing("--to") != nullptr) {
        std::string ignored;
        const auto own = specs_of_file("", first_bytes(options.files[1]).value_or(""), ignored);
        of_reference = own.size() == 1 ? own[0] : "";
    }
    auto mends = messages::with_specs_of_words(options, options.value_words);
    mends = mends.empty() ? messages::with_specs_of_others(options) : mends;
    for (const std::string& spec : mends.empty() ? specs : std::vector<std::string>()) {
        const std::size_t place = lacks_from || from == nullptr ? options.begin : from->place.word + 1;
        mends.push_back({{{{place}, 0, {lacks_from ? "-f" : "-t", spec}}}});
        if (!of_reference.empty() && of_reference != spec) {
            mends.back().edits.push_back({{Edit::at_end}, 0, {"-t", of_reference}});
        }
        if (is_identify && !has_known) { // how the numbers are read is what is asked
            mends.back().edits.push_back({{options.begin - 1}});
        }
    }
    if (!lacks_from && !is_identify && options.command_name() == "identify") { // what is known is -t
        mends.push_back({{{{from->place.word - 1}, 1, {"-t"}}}});
    }
    Usage usage = Usage(said).with(std::move(mends), said == error.what() ? "; see rotconv --help" : "");
    usage.guesses_spec = lacks_from;
    return usage;
}

} // namespace rotconv::cli
