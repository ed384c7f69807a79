#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../../stream/numbers/number_text.hpp"
#include "../grammar/column_names.hpp"
#include "answers.hpp"
#include "messages.hpp"

namespace rotconv::cli::messages {
namespace {

/// A multiple of pi, such as -pi/2, 2*pi/3 and np.pi, as a number; other texts as they are.
std::string without_pi(const std::string& text) {
    const auto at = lower(text).find("pi");
    double before = 1.0;
    double after = 1.0;
    const auto is_factor = [](std::string_view part, double& number) {
        return part.empty() || stream::read_number(part, number) == stream::NumberError::none;
    };
    if (at == std::string::npos) {
        return text;
    }
    std::string first = text.substr(0, at);
    for (const std::string_view library : {"np.", "math.", "M_", "*"}) {
        first.resize(first.size() - (first.ends_with(library) ? library.size() : 0));
    }
    const bool is_bare = first == "-" || first == "+";
    const std::string last = text.substr(at + 2);
    const bool has_last = last.size() > 1 && (last[0] == '/' || last[0] == '*');
    if (!is_factor(is_bare ? first + "1" : first, before) || (!last.empty() && !has_last) ||
        !is_factor(has_last ? last.substr(1) : last, after)) {
        return text;
    }
    constexpr long double pi = 3.14159265358979323846264338327950288L;
    return fmt::to_string(static_cast<double>(last.starts_with('/') ? pi * before / after : pi * before * after));
}

} // namespace

std::vector<Mend> with_numbers_for_pi(const OptionSet& options) {
    Mend mend;
    for (std::size_t at = options.begin; at < options.words.size(); ++at) {
        const std::string& word = options.words[at];
        const bool is_argument = std::ranges::any_of(options.all(), [at](const Option* option) {
            return option->given() && option->takes_argument() && option->place.word == at;
        });
        if (is_argument) {
            continue;
        }
        std::string made;
        for (std::size_t i = 0; i < word.size();) {
            const std::size_t end = std::min(word.find_first_of(" ,;[](){}:=", i), word.size());
            made += end > i ? without_pi(word.substr(i, end - i)) : word.substr(i, 1);
            i = std::max(end, i + 1);
        }
        if (made != word) {
            mend.edits.push_back({{at}, 1, {made}});
        }
    }
    return Mend::unless_empty(mend);
}

MendGroups meant_by_values(const OptionSet& options, const stream::RowNumbers& numbers) {
    const std::size_t expected = numbers.names.size();
    const auto& values = options.values;
    const auto words_without = [text = joined(values, " ")](std::string_view separators) {
        std::string words = text;
        std::ranges::replace_if(
            words, [separators](char c) { return separators.find(c) != std::string_view::npos; }, ' ');
        return words_in(words);
    };
    MendGroups mends;
    if (values.size() > 1 && values[0].find(',') != std::string::npos) { // a row of several words
        mends.push_back({options.with_values({joined(values, ",")})});
    }
    auto points = words_without(";");
    std::ranges::for_each(points, [](std::string& word) { std::ranges::replace(word, ',', '.'); });
    if (points.size() == expected && std::ranges::all_of(points, stream::is_number)) { // decimal commas
        mends.push_back({options.with_values(points)});
    }
    const auto texts = words_without(",;[](){}p");
    const bool is_alone = numbers.attitude && numbers.attitude->size() == expected;
    if (!is_alone || texts.size() < expected + 3 || !std::ranges::all_of(texts, stream::is_number)) {
        return mends;
    }
    if (numbers.attitude->name == RepresentationId::dcm) {
        mends.push_back({{{{{Edit::at_end}, 0, {"--columns", "1-3,5-7,9-11"}}}}});
        return mends;
    }
    const bool is_pose_of_ur = lower(values[0]).starts_with("p[") && texts.size() == 6;
    const bool is_quat = numbers.attitude->name == RepresentationId::quat;
    const auto places = is_pose_of_ur && !is_quat ? std::vector<std::size_t>{3}
                                                  : rotation_places({texts.begin(), texts.end()}, *numbers.attitude);
    if (places.size() == 1) {
        const auto begin = texts.begin() + static_cast<std::ptrdiff_t>(places[0]);
        const std::vector<std::string> found(begin, begin + static_cast<std::ptrdiff_t>(expected));
        mends.push_back({options.with_values(found)});
        if (has_open_order(*numbers.attitude) && options.has("--from")) {
            mends.back().push_back(options.with_values(found));
            mends.back().back().edits.push_back(OptionSet::setting(*options.find("--from"), "quat:xyzw"));
        }
    }
    return mends;
}

} // namespace rotconv::cli::messages
