#include "value_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <rotconv/spec.hpp>

#include "../core/text.hpp"
#include "../stream/fmt.hpp"
#include "../stream/number_text.hpp"
#include "messages.hpp"
#include "option_set.hpp"

namespace rotconv::cli {
namespace {

// Words that mean something in a text, with blanks around each.
constexpr std::string_view headings = " rotation orientation attitude in is at the ";
constexpr std::string_view declarations = " decl local const pers e6pos frame pos robtarget auto var float double int "
                                          "quatf quatd matrix4d matrix3d float3 double3 ";
constexpr std::string_view container_words =
    " array asarray matrix vector tensor list tuple point rotation transform pose float double int p ";
constexpr std::string_view skipped_keys = " dtype device layout requires_grad grad_fn frame_id child_frame_id ";
constexpr std::string_view skipped_in_xml = " name type class frame relative_to ";
constexpr std::string_view degrees_words = " deg degree degrees \u00B0 ";
constexpr std::string_view radians_words = " rad radian radians ";
constexpr std::string_view length_words = " mm cm m in ";

bool is_in(std::string_view list, std::string_view word) {
    return !word.empty() && list.find(fmt::format(" {} ", word)) != std::string_view::npos;
}

/// deg, rad, m, or empty.
std::string_view unit_of_word(std::string_view word) {
    const std::string text = lower(word);
    return is_in(degrees_words, text)   ? "deg"
           : is_in(radians_words, text) ? "rad"
           : is_in(length_words, text)  ? "m"
                                        : "";
}

/// Letters, digits, _, dots and joined colons, from a letter or _ on.
bool is_name(std::string_view word) {
    return !word.empty() && (is_alphanumeric(word[0]) || word[0] == '_') && (word[0] < '0' || word[0] > '9') &&
           std::ranges::all_of(word, [](char c) { return is_alphanumeric(c) || c == '_' || c == '.' || c == ':'; });
}

/// What is left without digits and the letters of a type behind them: Matrix3d, Vector4f, Matrix3x3.
std::string_view without_type(std::string_view word) {
    while (word.size() > 1 && (word.back() == 'd' || word.back() == 'f' || word.back() == 'i') &&
           word[word.size() - 2] >= '0' && word[word.size() - 2] <= '9') {
        word.remove_suffix(1);
    }
    const auto is_size = [](char c) { return (c >= '0' && c <= '9') || c == 'x' || c == 'X'; };
    while (word.size() > 1 && is_size(word.back()) && word.find_first_of("0123456789") != std::string_view::npos) {
        word.remove_suffix(1);
    }
    return word;
}

/// The last part of a dotted or :: name.
std::string_view last_part(std::string_view word) { return word.substr(word.find_last_of(".:") + 1); }

bool is_convention(std::string_view word) {
    const auto in = [word](const auto& list) { return std::ranges::count(list, word) > 0; };
    return word == "xyzw" || word == "wxyz" || word == "rpy" || word == "ypr" || in(messages::all_sequences()) ||
           in(mapped(all_modifiers, [](Modifier modifier) { return name_of(modifier); })) ||
           named_representation(word).has_value();
}

enum class TokenKind : std::uint8_t { number, word, open, close, separator, line, is, mark, end };

struct Token {
    TokenKind kind = TokenKind::end;
    std::string_view text{};   ///< of a bracket one character, or < and the name of an element
    std::string_view suffix{}; ///< of a number
    bool is_joined = false;    ///< no blank before it
    std::size_t indent = 0;    ///< of its line
    bool begins_line = false;
};

// NOLINTBEGIN(misc-no-recursion): brackets and labels stand in each other, at most `deepest` of them.

/// Parts a text into tokens.
class Lexer {
public:
    explicit Lexer(std::string_view text) : text_(text) {}

    std::vector<Token> tokens() {
        while (at_ < text_.size()) {
            next();
        }
        return std::move(tokens_);
    }

private:
    static constexpr std::string_view separators = ",; \t\r\n[](){}<>\"'=|";

    void add(TokenKind kind, std::size_t size, std::string_view suffix = {}) {
        const bool begins = is_new_line_;
        if (kind != TokenKind::line) {
            indent_ = begins && !after_dash_ ? at_ - line_begin_ : indent_;
            after_dash_ = begins && text_.substr(at_, size) == "-"; // of a list: its label begins the line
            is_new_line_ = after_dash_;
        }
        tokens_.push_back({kind, text_.substr(at_, size), suffix, at_ == end_of_last_, indent_, begins});
        at_ += size + suffix.size();
        end_of_last_ = at_;
    }

    void next() {
        const char c = text_[at_];
        const std::string_view rest = text_.substr(at_);
        if (c == ' ' || c == '\t' || c == '\r') {
            ++at_;
        } else if (c == '\n') {
            add(TokenKind::line, 1);
            is_new_line_ = true;
            line_begin_ = at_;
        } else if (c == ',' || c == ';') {
            add(TokenKind::separator, 1);
        } else if (rest.starts_with("---") || rest.starts_with("...")) {
            add(TokenKind::mark, 3);
        } else if (c == '|') {
            add(TokenKind::mark, 1);
        } else if (rest.starts_with("/>")) {
            add(TokenKind::close, 2);
        } else if (rest.starts_with("</")) {
            add(TokenKind::close, std::min(rest.find('>'), rest.size() - 1) + 1);
        } else if (c == '<' && rest.size() > 1 && is_name(rest.substr(1, 1))) {
            add(TokenKind::open, std::min(rest.find_first_of(" \t\r\n/>(<", 1), rest.size()));
        } else if (std::string_view("[({<").find(c) != std::string_view::npos) {
            add(TokenKind::open, 1);
        } else if (std::string_view("])}>").find(c) != std::string_view::npos) {
            add(TokenKind::close, 1);
        } else if (c == '=' || rest.starts_with(":=")) {
            add(TokenKind::is, c == '=' ? 1 : 2);
        } else if (c == ':') {
            add(TokenKind::is, 1);
        } else if (c == '"' || c == '\'') {
            quote(c, rest);
        } else {
            word(rest);
        }
    }

    void quote(char c, std::string_view rest) {
        if (c == open_quote_) {
            open_quote_ = '\0';
            add(TokenKind::close, 1);
            return;
        }
        const bool after_number = !tokens_.empty() && end_of_last_ == at_ && tokens_.back().kind == TokenKind::number;
        const std::size_t end = rest.find(c, 1);
        if (after_number || end == std::string_view::npos || open_quote_ != '\0') {
            const std::size_t before = text_.substr(0, at_).find_last_of(" \t\n,;") + 1;
            throw Usage("argument: {} is not understood: {}", quoted(text_.substr(before, at_ + 1 - before)),
                        after_number ? "minutes and seconds of arc are not read, write decimal degrees"
                                     : "a quote has no partner");
        }
        if (const std::string_view inside = rest.substr(1, end - 1); !holds_number(inside)) {
            ++at_;
            end_of_last_ += end_of_last_ + 1 == at_ ? 1 : 0;
            add(TokenKind::word, inside.size());
            ++at_;
            ++end_of_last_;
            return;
        }
        open_quote_ = c;
        add(TokenKind::open, 1);
    }

    void word(std::string_view rest) {
        std::size_t size = 0;
        for (; size < rest.size() && separators.find(rest[size]) == std::string_view::npos; ++size) {
            const bool is_within = size > 0 && size + 1 < rest.size();
            const bool is_scope = rest.substr(size).starts_with("::");
            if (rest[size] == ':' &&
                !(is_within && (is_scope || rest[size - 1] == ':' ||
                                (std::isalpha(static_cast<unsigned char>(rest[size - 1])) != 0 &&
                                 std::isalpha(static_cast<unsigned char>(rest[size + 1])) != 0)))) {
                break;
            }
        }
        const std::string_view whole = rest.substr(0, std::max<std::size_t>(size, 1));
        if (stream::is_number(whole)) {
            add(TokenKind::number, whole.size());
            return;
        }
        for (const std::string_view suffix : {"degrees", "degree", "deg", "\u00B0", "radians", "radian", "rad", "mm",
                                              "cm", "m", "in", "f", "F", "i", "j", "k"}) {
            if (whole.ends_with(suffix) && stream::is_number(whole.substr(0, whole.size() - suffix.size()))) {
                add(TokenKind::number, whole.size() - suffix.size(), suffix);
                return;
            }
        }
        const std::size_t sign = whole.find_first_of("+-", 1); // of the sum of a quaternion
        if (sign != std::string_view::npos && std::string_view("ijk").find(whole.back()) != std::string_view::npos) {
            const std::size_t exponent =
                (whole[sign - 1] == 'e' || whole[sign - 1] == 'E') ? whole.find_first_of("+-", sign + 1) : sign;
            const std::string_view first = whole.substr(0, exponent);
            if (exponent < whole.size() &&
                (stream::is_number(first) || stream::is_number(first.substr(0, first.size() - 1)))) {
                word(first);
                return;
            }
        }
        add(TokenKind::word, whole.size());
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t end_of_last_ = std::string_view::npos;
    std::size_t line_begin_ = 0;
    std::size_t indent_ = 0;
    bool is_new_line_ = true;
    bool after_dash_ = false;
    char open_quote_ = '\0';
    std::vector<Token> tokens_;
};

/// Reads tokens by the grammar.
class Parser {
public:
    explicit Parser(std::string_view text) : text_(text), tokens_(Lexer(text).tokens()) { read_.groups.emplace_back(); }

    ValueText read() {
        while (peek().kind != TokenKind::end) {
            items(0, no_block);
            take(); // a bracket that closes nothing
        }
        return std::move(read_);
    }

private:
    static constexpr std::size_t most_numbers = 1000;
    static constexpr std::size_t deepest = 200; ///< brackets and labels in each other

    /// Lines that belong to a label above them.
    struct Block {
        std::size_t least = 0; ///< their indent
        bool is_flat = false;  ///< that of the label too: they end at the next label
        bool is_one = true;
    };
    static constexpr Block no_block{0, false, false};

    [[nodiscard]] const Token& peek(std::size_t ahead = 0) const {
        static const Token end;
        return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead] : end;
    }
    const Token& take() {
        const Token& taken = peek();
        ++at_;
        return taken;
    }
    [[noreturn]] void refuse(const Token& token, std::string_view why = {}) const {
        const auto begin = static_cast<std::size_t>(token.text.data() - text_.data());
        std::size_t end = std::min(text_.find_first_of(" \t\r\n,;", begin + token.text.size()), text_.size());
        end = std::max(end, begin + token.text.size());
        const std::string word(text_.substr(begin, end - begin));
        const auto digit = std::min(token.text.find_first_not_of("+-."), token.text.size());
        const bool is_number = digit < token.text.size() && token.text[digit] >= '0' && token.text[digit] <= '9';
        const bool any_before = !read_.numbers.empty();
        const bool any_after =
            std::any_of(tokens_.begin() + static_cast<std::ptrdiff_t>(std::min(at_ + 1, tokens_.size())), tokens_.end(),
                        [](const Token& each) { return each.kind == TokenKind::number; });
        const std::string mended = messages::mend(token.text);
        throw Usage("argument: {}: {}{}",
                    is_number ? "not a number"
                              : fmt::format("not understood {} the numbers", any_before && any_after ? "between"
                                                                             : any_before            ? "after"
                                                                                                     : "before"),
                    quoted(word),
                    !why.empty()                   ? fmt::format("; {}", why)
                    : !mended.empty() || is_number ? mended
                                                   : "; VALUEs are numbers with labels, units and brackets");
    }

    void items(std::size_t group, const Block& block) {
        for (;;) {
            const Token& token = peek();
            const bool begins = block.is_one && token.begins_line && token.kind != TokenKind::line;
            const bool is_label = block.is_flat && token.kind == TokenKind::word && token.text != "-";
            if (token.kind == TokenKind::end || token.kind == TokenKind::close ||
                (begins && (token.indent < block.least || is_label))) {
                return;
            }
            item(group, block);
        }
    }

    void item(std::size_t group, const Block& block) {
        const Token& token = peek();
        if (depth_ == deepest) {
            refuse(token, "brackets stand too deep in each other");
        }
        ++depth_;
        read_item(token, group, block);
        --depth_;
    }

    void read_item(const Token& token, std::size_t group, const Block& block) {
        switch (token.kind) {
        case TokenKind::number: number(group, {}); return;
        case TokenKind::open: bracket(group, true); return;
        case TokenKind::word: word(group, block); return;
        case TokenKind::separator:
            if (separators_++ > 0 && token.text == ",") { // nothing stands between two commas
                read_.numbers.push_back({.group = group, .bracket = brackets_});
            }
            has_gap_ = true;
            take();
            return;
        case TokenKind::line:
            has_gap_ = true;
            take();
            return;
        case TokenKind::mark: take(); return;
        default: refuse(token);
        }
    }

    void number(std::size_t group, std::string_view label) {
        const Token& token = take();
        if (read_.numbers.size() == most_numbers) {
            refuse(token, fmt::format("more than {} numbers are not one attitude", most_numbers));
        }
        ValueNumber& made = read_.numbers.emplace_back();
        made.text = token.text;
        made.label = label;
        made.group = group;
        made.bracket = brackets_;
        made.is_joined = !std::exchange(has_gap_, false) && label.empty();
        separators_ = 0;
        if (token.suffix == "i" || token.suffix == "j" || token.suffix == "k") {
            made.component = token.suffix[0];
        } else if (!unit_of_word(token.suffix).empty()) {
            made.unit = unit_of_word(token.suffix);
        }
        if (const auto after = unit_of_word(peek().kind == TokenKind::word ? peek().text : "");
            !after.empty() && peek(1).kind != TokenKind::is) {
            made.unit = after;
            take();
        } else if (sums_.find(peek().text) != std::string_view::npos && peek().kind == TokenKind::word &&
                   peek(1).kind == TokenKind::number &&
                   (peek(1).suffix.empty() ? made.component != '\0'
                                           : std::string_view("ijk").find(peek(1).suffix) != std::string_view::npos)) {
            const bool is_negative = take().text == "-";
            const std::size_t at = read_.numbers.size();
            number(group, {});
            std::string& text = read_.numbers[at].text;
            text = !is_negative ? text : text[0] == '-' ? text.substr(1) : "-" + text;
        }
    }

    /// A bracket and what stands in it, of the group. `is_alone`: no container stands before it.
    void bracket(std::size_t group, bool is_alone) {
        const Token open = take();
        const std::string element(open.text.substr(1));
        const bool is_xml = !element.empty();
        const std::size_t outer = group;
        const std::string ending = fmt::format("</{}", element);
        const bool has_content =
            is_xml &&
            text_.find(ending, static_cast<std::size_t>(open.text.data() - text_.data())) != std::string_view::npos;
        if (is_xml && is_alone && (has_content || !is_container(element) || named_representation(element))) {
            group = new_group(group, element);
        }
        ++brackets_;
        has_gap_ = true;
        separators_ = 0;
        const bool was_xml = std::exchange(in_xml_, is_xml);
        const std::size_t first = read_.numbers.size();
        for (;;) {
            items(group, no_block);
            if (peek().kind == TokenKind::end) {
                break;
            }
            const Token close = take();
            if (!(is_xml && has_content && close.text == ">")) {
                break; // the end of a start tag goes on with the content
            }
        }
        in_xml_ = was_xml;
        if (is_xml && read_.numbers.size() == first) {
            refuse(open);
        }
        if (is_xml && group != outer) {
            collapse(group, first, element);
        }
        ++brackets_;
        has_gap_ = true;
        separators_ = 0;
        const Token& after = peek();
        if (after.is_joined && (after.kind == TokenKind::word || after.kind == TokenKind::number ||
                                (after.kind == TokenKind::is && after.text == ":="))) {
            refuse(after);
        }
    }

    std::size_t new_group(std::size_t parent, std::string_view label, std::string_view unit = {}) {
        read_.groups.push_back({std::string(label), parent, std::string(unit)});
        return read_.groups.size() - 1;
    }

    static bool is_container(std::string_view word) {
        const std::string last = lower(without_type(last_part(word)));
        return is_in(container_words, last) || named_representation(last_part(word)).has_value();
    }
    static bool is_size(std::string_view word) { return word == "3x3" || word == "4x4" || word == "3" || word == "4"; }

    /// Brackets that hold only units and words of convention: (xyzw), (radian), [deg], (w,x,y,z).
    [[nodiscard]] std::size_t remark_size() const {
        std::size_t size = 1;
        std::string letters;
        for (; peek(size).kind == TokenKind::word || peek(size).kind == TokenKind::separator; ++size) {
            const std::string_view text = peek(size).text;
            letters += peek(size).kind == TokenKind::word ? text : "";
            if (peek(size).kind == TokenKind::word && text.size() > 1 && unit_of_word(text).empty() &&
                !is_convention(text)) {
                return 0;
            }
        }
        const bool has_meaning = letters == "wxyz" || letters == "xyzw" || size == 2;
        return peek().kind == TokenKind::open && peek(size).kind == TokenKind::close && size > 1 && has_meaning
                   ? size + 1
                   : 0;
    }
    /// Takes one, and adds its words to the group.
    std::string take_remark(std::size_t group) {
        std::string unit;
        std::string letters;
        for (std::size_t i = remark_size(); i > 0; --i) {
            const Token& token = take();
            if (token.kind == TokenKind::word && token.text.size() == 1 && unit_of_word(token.text).empty()) {
                letters += token.text;
            } else if (token.kind == TokenKind::word) {
                const std::string_view found = unit_of_word(token.text);
                unit = found.empty() ? unit : found;
                if (found.empty()) {
                    read_.words.push_back({std::string(token.text), group});
                }
            }
        }
        if (!letters.empty()) {
            read_.words.push_back({letters, group});
        }
        return unit;
    }

    void word(std::size_t group, const Block& block) {
        const Token token = peek();
        std::string_view text = token.text;
        if (text == "-" && token.begins_line && !peek(1).is_joined &&
            (peek(1).kind == TokenKind::word ||
             (block.is_one && (peek(1).kind == TokenKind::number || peek(1).kind == TokenKind::open)))) {
            take(); // of a list
            return;
        }
        if (!is_name(text) && text != "\u00B0" && !is_size(text)) {
            refuse(token);
        }
        take();
        const std::string low = lower(text);
        const bool after_in = std::exchange(after_in_, low == "in"); // tf_echo's "in Quaternion [" is x y z w
        // A label, perhaps with its unit in brackets.
        const std::size_t remark = peek().kind == TokenKind::open ? remark_size() : 0;
        if (peek().kind == TokenKind::is || (remark > 0 && peek(remark).kind == TokenKind::is)) {
            key(group, token, block);
            return;
        }
        if (remark > 0 && (is_container(text) || is_in(headings, low))) { // Quaternion (xyzw) [...]
            const std::size_t own = named_representation(text) ? new_group(group, text) : group;
            read_.groups[own].unit = take_remark(own);
            if (peek().kind == TokenKind::open) {
                bracket(own, false);
            }
            return;
        }
        if (is_size(text)) {
            return;
        }
        if (peek().kind == TokenKind::open && peek().text[0] != '<') {
            if (!is_container(text) && !is_in(headings, low)) {
                refuse(token);
            }
            const auto named = named_representation(last_part(text));
            const std::size_t own = named ? new_group(group, last_part(text)) : group;
            if (lower(last_part(text)).starts_with("from_quat") || (after_in && named == RepresentationId::quat)) {
                read_.words.push_back({"xyzw", own});
            }
            bracket(own, false);
            return;
        }
        if (peek().kind == TokenKind::word &&
            (is_container(text) || is_in(declarations, low) || is_in(headings, low)) &&
            unit_of_word(peek().text).empty()) {
            if (const auto named = named_representation(last_part(text)); named && low != "matrix" && low != "p") {
                read_.words.push_back({std::string(last_part(text)), group});
            }
            return; // Eigen::Quaterniond q(, DECL E6POS, in Quaternion
        }
        if (const auto unit = unit_of_word(text); !unit.empty() && !(peek().kind == TokenKind::number)) {
            if (unit == "m") {
                refuse(token);
            }
            if (read_.numbers.empty()) {
                read_.words.push_back({std::string(unit), group});
            }
            for (ValueNumber& each : read_.numbers) { // degrees after all of them
                if (!each.unit.empty() && each.unit != unit && each.unit != "m") {
                    refuse(token);
                }
                each.unit = each.unit.empty() ? unit : each.unit;
            }
            return;
        }
        if (is_in(headings, low) || is_in(declarations, low)) {
            return;
        }
        if (is_convention(text)) {
            read_.words.push_back({std::string(text), group});
            return;
        }
        if (peek().kind == TokenKind::number && !peek().is_joined) { // roll 0.1
            number(group, text);
            return;
        }
        refuse(token);
    }

    /// A label with its value, or a key whose value is no number.
    void key(std::size_t group, const Token& label, const Block& block) {
        std::string low = lower(label.text);
        low.erase(0, low.find_first_not_of('_'));
        const std::size_t words = read_.words.size();
        const std::string unit = peek().kind == TokenKind::open ? take_remark(group) : "";
        while (peek().kind == TokenKind::is) {
            take();
        }
        const Token value = peek();
        if (is_in(skipped_keys, low) || (in_xml_ && is_in(skipped_in_xml, low))) {
            skip_value();
            return;
        }
        if (value.kind == TokenKind::word && (low == "scalar_first" || low == "degrees")) {
            const bool is_true = lower(value.text) == "true";
            if (!is_true && lower(value.text) != "false") {
                refuse(value);
            }
            take();
            if (low == "scalar_first") { // wins over a name's order
                std::erase_if(read_.words,
                              [group](const ValueWord& each) { return each.group == group && each.text == "xyzw"; });
            }
            read_.words.push_back({low == "degrees" ? (is_true ? "deg" : "rad") : (is_true ? "wxyz" : "xyzw"), group});
            return;
        }
        if (value.kind == TokenKind::word && (low == "order" || low == "seq") &&
            (value.text.size() == 3 || value.text == "xyzw" || value.text == "wxyz")) {
            take();
            read_.words.push_back({std::string(value.text), group, low == "order" && value.text.size() == 3});
            return;
        }
        if (value.kind == TokenKind::word && is_in(" true false yes no none null ", lower(value.text))) {
            refuse(label);
        }
        const std::size_t own = new_group(group, label.text, unit);
        for (std::size_t i = words; i < read_.words.size(); ++i) {
            read_.words[i].group = own;
        }
        const std::size_t first = read_.numbers.size();
        has_gap_ = true;
        // The rest of the line, up to the next label; all of it where labels come at once.
        const bool is_of_labels = is_next_label();
        while (peek().kind != TokenKind::line && peek().kind != TokenKind::end && peek().kind != TokenKind::close &&
               (is_of_labels || !is_next_label())) {
            const TokenKind kind = peek().kind;
            const std::size_t before = read_.numbers.size();
            item(own, block);
            if (!is_of_labels &&
                (kind == TokenKind::open || (kind == TokenKind::word && read_.numbers.size() > before + 1))) {
                break;
            }
        }
        if (label.begins_line && peek().kind == TokenKind::line) { // a block, or lines of numbers
            std::size_t ahead = 0;
            while (peek(ahead).kind == TokenKind::line) {
                ++ahead;
            }
            const Token& next = peek(ahead);
            const bool is_deeper = next.indent > label.indent;
            const bool is_flat = read_.numbers.size() == first && next.indent == label.indent &&
                                 (next.text == "-" || next.kind == TokenKind::number || next.kind == TokenKind::open);
            if (next.kind != TokenKind::end && (is_deeper || is_flat)) {
                items(own, {label.indent + (is_deeper ? 1 : 0), is_flat});
            }
        }
        if (read_.numbers.size() == first) {
            refuse(label);
        }
        collapse(own, first, label.text);
    }

    /// A group of one number is that number with its label.
    void collapse(std::size_t own, std::size_t first, std::string_view label) {
        if (read_.numbers.size() != first + 1 || !read_.numbers[first].label.empty() ||
            read_.numbers[first].group != own) {
            return;
        }
        const std::size_t group = read_.groups[own].parent;
        ValueNumber& only = read_.numbers[first];
        only.label = label;
        only.group = group;
        only.unit = only.unit.empty() ? read_.groups[own].unit : only.unit;
        only.is_joined = false;
        for (ValueWord& each : read_.words) {
            each.group = each.group == own ? group : each.group;
        }
    }

    /// Whether a label follows: a word before : or =, or before a blank and a number.
    [[nodiscard]] bool is_next_label() const {
        std::size_t ahead = peek().kind == TokenKind::separator || peek().text == "|" ? 1 : 0;
        if (peek(ahead).kind != TokenKind::word || !is_name(peek(ahead).text)) {
            return false;
        }
        ++ahead;
        if (peek(ahead).kind == TokenKind::open && peek(ahead + 1).kind == TokenKind::word &&
            peek(ahead + 2).kind == TokenKind::close) {
            ahead += 3; // its unit
        }
        const std::string_view text = peek(ahead - 1).text;
        return peek(ahead).kind == TokenKind::is || (peek(ahead).kind == TokenKind::number && !is_convention(text) &&
                                                     unit_of_word(text).empty() && !is_in(headings, lower(text)));
    }

    void skip_value() {
        const Token value = take();
        if (value.kind == TokenKind::number || value.kind == TokenKind::end || value.kind == TokenKind::separator) {
            refuse(value);
        }
        if (value.kind == TokenKind::open) {
            for (std::size_t depth = 1; depth > 0 && peek().kind != TokenKind::end;) {
                const TokenKind kind = take().kind;
                depth += kind == TokenKind::open ? 1 : 0;
                depth -= kind == TokenKind::close ? 1 : 0;
            }
        }
    }

    static constexpr std::string_view sums_ = "+-";

    std::string_view text_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    std::size_t brackets_ = 0;
    std::size_t separators_ = 0; ///< since the last number
    bool has_gap_ = true;
    bool in_xml_ = false;
    bool after_in_ = false;
    std::size_t depth_ = 0;
    ValueText read_;
};

// NOLINTEND(misc-no-recursion)

} // namespace

ValueText parse_values(std::string_view text) { return Parser(text).read(); }

std::optional<RepresentationId> named_representation(std::string_view word) {
    static constexpr std::array<std::pair<std::string_view, RepresentationId>, 9> others{
        {{"q", RepresentationId::quat},
         {"R", RepresentationId::dcm},
         {"rotmat", RepresentationId::dcm},
         {"rvec", RepresentationId::rotvec},
         {"rotationvector", RepresentationId::rotvec},
         {"prv", RepresentationId::rotvec},
         {"aa", RepresentationId::axis_angle},
         {"axisangle", RepresentationId::axis_angle},
         {"crp", RepresentationId::cayley}}};
    if (const auto* const found = std::ranges::find(others, word, [](const auto& each) { return each.first; });
        found != others.end()) {
        return found->second;
    }
    std::string text = lower(word);
    for (const std::string_view prefix : {"from_", "unit"}) {
        text.erase(0, text.starts_with(prefix) ? prefix.size() : 0);
    }
    text = without_marks(text);
    for (const std::string& each :
         {text, std::string(without_type(text)),
          text.substr(0, text.size() - (text.ends_with('d') || text.ends_with('f') ? 1 : 0))}) {
        for (const RepresentationId id : all_representations) {
            const Representation& entry = representation(id);
            const auto names = messages::names_of(entry);
            if (std::ranges::any_of(names, [&](std::string_view name) { return without_marks(name) == each; })) {
                return id;
            }
        }
        if (const auto* const found = std::ranges::find(others, each, [](const auto& other) { return other.first; });
            found != others.end() && each.size() > 1) {
            return found->second;
        }
    }
    return std::nullopt;
}

std::vector<std::string> parts_of_label(std::string_view label) {
    std::vector<std::string> parts(1);
    for (std::size_t i = 0; i < label.size(); ++i) {
        const bool is_upper = std::isupper(static_cast<unsigned char>(label[i])) != 0;
        const bool was_lower = i > 0 && std::islower(static_cast<unsigned char>(label[i - 1])) != 0;
        const bool is_mark = std::string_view("_.: \t").find(label[i]) != std::string_view::npos;
        if ((is_mark || (is_upper && was_lower)) && !parts.back().empty()) {
            parts.emplace_back();
        }
        if (!is_mark) {
            parts.back() += lower(label.substr(i, 1));
        }
    }
    return parts;
}

bool holds_number(std::string_view word) {
    constexpr std::string_view ends = ",; \t\r\n[](){}<>\"':=";
    for (std::size_t at = word.find_first_not_of(ends); at != std::string_view::npos;) {
        const std::size_t end = std::min(word.find_first_of(ends, at), word.size());
        if (stream::is_number(word.substr(at, end - at))) {
            return true;
        }
        at = word.find_first_not_of(ends, end);
    }
    return false;
}

} // namespace rotconv::cli
