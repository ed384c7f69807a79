#include "value_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "../../stream/numbers/number_text.hpp"
#include "../messages/messages.hpp"
#include "../option_set.hpp"

namespace rotconv::cli {
namespace {

constexpr std::string_view digits = "0123456789";

/// Letters, digits, _, dots and joined colons, from a letter or _ on; perhaps with its index, as in q[0].
bool is_name(std::string_view word) {
    word = word.substr(0, word.find('['));
    return !word.empty() && digits.find(word[0]) == std::string_view::npos && word[0] != '.' && word[0] != ':' &&
           std::ranges::all_of(word, [](char c) { return is_alphanumeric(c) || c == '_' || c == '.' || c == ':'; });
}

/// The last part of a dotted or :: name.
std::string_view last_part(std::string_view word) { return word.substr(word.find_last_of(".:") + 1); }

enum class TokenKind : std::uint8_t { number, word, open, close, separator, line, is, mark, quote, end };

struct Token {
    TokenKind kind = TokenKind::end;
    std::string_view text{};   ///< of a bracket one character, or < and the name of an element
    std::string_view suffix{}; ///< of a number
    bool is_joined = false;    ///< no blank before it
    bool begins_line = false;  ///< perhaps behind the dash of a list
    std::size_t indent = 0;    ///< of its line
};

// NOLINTBEGIN(misc-no-recursion): a text in quotes is looked at without them, at most two deep; brackets and labels
// stand in each other, at most `deepest` of them.

/// Separates a text into tokens.
class Lexer {
public:
    explicit Lexer(std::string_view text) : text_(text) {}

    std::vector<Token> tokens() {
        while (at_ < text_.size()) {
            next(text_.substr(at_), text_[at_]);
        }
        return std::move(tokens_);
    }

private:
    static constexpr std::string_view separators = ",; \t\r\n[](){}<>\"'=|";
    static constexpr auto npos = std::string_view::npos;

    void add(TokenKind kind, std::string_view text, std::size_t size, std::string_view suffix = {}) {
        const bool begins_line = tokens_.empty() || tokens_.back().kind == TokenKind::line ||
                                 (tokens_.back().begins_line && tokens_.back().text == "-");
        indent_ = begins_line ? at_ - line_begin_ : indent_;
        tokens_.push_back({kind, text, suffix, at_ == end_of_last_, begins_line, indent_});
        at_ += size;
        end_of_last_ = at_;
    }
    void add(TokenKind kind, std::size_t size) { add(kind, text_.substr(at_, size), size); }

    void next(std::string_view rest, char c) {
        const auto is_any = [c](std::string_view set) { return set.find(c) != std::string_view::npos; };
        const std::string_view three = rest.substr(0, 3);
        if (is_any(" \t\r")) {
            ++at_;
        } else if (c == '\n') {
            add(TokenKind::line, 1);
            line_begin_ = at_;
        } else if (is_any(",;")) {
            add(TokenKind::separator, 1);
        } else if (c == '|' ||
                   ((three == "---" || three == "...") && (rest.size() == 3 || separators.find(rest[3]) != npos))) {
            add(TokenKind::mark, c == '|' ? 1 : 3);
        } else if (rest.starts_with("</") || rest.starts_with("/>") || is_any("])}>")) {
            add(TokenKind::close, is_any("])}>") ? 1 : std::min(rest.find('>'), rest.size() - 1) + 1);
        } else if (is_any("[({<")) {
            const auto is_outside = [](char each) { // of the name of an element
                return !is_alphanumeric(each) && std::string_view("_.:-").find(each) == npos;
            };
            const auto end = std::find_if(rest.begin() + 1, rest.end(), is_outside) - rest.begin();
            add(TokenKind::open, c == '<' && is_name(rest.substr(1, 1)) ? static_cast<std::size_t>(end) : 1);
        } else if (is_any("=:")) {
            add(TokenKind::is, rest.starts_with(":=") ? 2 : 1);
        } else if (is_any("\"'")) {
            quote(rest);
        } else {
            word(rest);
        }
    }

    /// Quotes are brackets if there is a number between them; otherwise what is between them is one word.
    void quote(std::string_view rest) {
        const bool closes = rest[0] == open_quote_;
        const bool after_number = !tokens_.empty() && end_of_last_ == at_ && tokens_.back().kind == TokenKind::number;
        const std::size_t end = rest.find(rest[0], 1);
        if (closes) {
            open_quote_ = '\0';
            add(TokenKind::close, 1);
        } else if (after_number || end == std::string_view::npos || open_quote_ != '\0') {
            add(TokenKind::quote, 1);
        } else if (const std::string_view inside = rest.substr(1, end - 1); holds_number(inside)) {
            open_quote_ = rest[0];
            add(TokenKind::open, 1);
        } else {
            add(TokenKind::word, inside, end + 1);
        }
    }

    void word(std::string_view rest) {
        std::size_t size = 0;
        for (; size < rest.size() && separators.find(rest[size]) == std::string_view::npos; ++size) {
            if (rest[size] == ':' && !(rest.substr(size).starts_with("::") && is_name(rest.substr(size + 2, 1)))) {
                break;
            }
            size += rest[size] == ':' ? 1 : 0;
        }
        const std::string_view whole = rest.substr(0, size);
        const auto is_term = [](char end) { return end >= 'i' && end <= 'k'; };
        if (number(whole)) {
            return;
        }
        for (auto sign = whole.find_first_of("+-", 1); sign != std::string_view::npos;
             sign = whole.find_first_of("+-", sign + 1)) {
            const bool is_sum = is_term(whole[sign - 1]) || is_term(whole.back());
            if (is_sum && number(whole.substr(0, sign))) { // the rest comes next
                return;
            }
        }
        std::size_t end = size; // behind its indices, if it is a label: q[0]
        while (rest.substr(end).starts_with('[') && rest.find_first_not_of(digits, end + 1) == rest.find(']', end)) {
            end = rest.find(']', end) + 1;
        }
        const std::size_t after = std::min(rest.find_first_not_of(" \t", end), rest.size());
        add(TokenKind::word, rest.substr(after, 1) == ":" || rest.substr(after, 1) == "=" ? end : size);
    }

    /// Adds the word if it is a number, perhaps with its unit.
    bool number(std::string_view word) {
        static const std::string all =
            fmt::format("{}{}{}f F i j k", vocabulary::degrees, vocabulary::radians, vocabulary::length);
        static const auto suffixes = split(all, ' '); // of which the first is empty
        const auto text = [word](std::string_view suffix) { return word.substr(0, word.size() - suffix.size()); };
        const auto suffix = std::ranges::find_if(
            suffixes, [&](std::string_view each) { return word.ends_with(each) && stream::is_number(text(each)); });
        if (suffix == suffixes.end()) {
            return false;
        }
        add(TokenKind::number, text(*suffix), word.size(), *suffix);
        return true;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t end_of_last_ = std::string_view::npos;
    std::size_t line_begin_ = 0;
    std::size_t indent_ = 0;
    char open_quote_ = '\0';
    std::vector<Token> tokens_;
};

/// Reads tokens by the grammar.
class Parser {
public:
    explicit Parser(std::string_view text) : text_(text), tokens_(Lexer(text).tokens()) { read_.groups.emplace_back(); }

    ValueText read() {
        for (items(0); peek().kind != TokenKind::end; items(0)) {
            if (is_angle(peek().text)) {
                refuse(peek());
            }
            take(); // a bracket that closes nothing
        }
        return std::move(read_);
    }

private:
    static constexpr std::size_t most_numbers = 1000;
    static constexpr std::size_t deepest = 200; ///< brackets and labels in each other
    static constexpr std::size_t no_limit = std::string::npos;

    [[nodiscard]] const Token& peek(std::size_t ahead = 0) const {
        static const Token end;
        return at_ + ahead < std::min(limit_, tokens_.size()) ? tokens_[at_ + ahead] : end;
    }
    const Token& take() {
        const Token& taken = peek();
        brackets_ += taken.kind == TokenKind::open || taken.kind == TokenKind::close ? 1 : 0;
        at_ += taken.kind == TokenKind::end ? 0 : 1;
        return taken;
    }
    /// How many line ends come next.
    [[nodiscard]] std::size_t lines_ahead() const {
        std::size_t lines = 0;
        while (peek(lines).kind == TokenKind::line) {
            ++lines;
        }
        return lines;
    }
    /// The token before the next; none at the beginning.
    [[nodiscard]] const Token& last() const {
        static const Token none;
        return at_ > 0 ? tokens_[at_ - 1] : none;
    }
    [[nodiscard]] static bool is_unit(const Token& token) {
        return token.kind == TokenKind::word && !unit_of_word(token.text).empty();
    }
    [[nodiscard]] static bool is_convention(const Token& token) {
        return token.kind == TokenKind::word && !convention_in(last_part(token.text)).empty();
    }
    [[nodiscard]] static bool is_angle(std::string_view bracket) { // < > /> </name>
        return bracket.find_first_of("</>") == 0;
    }
    [[nodiscard]] std::size_t size() const { return read_.numbers.size(); }

    [[noreturn]] void refuse(const Token& token, std::string_view why = {}) const {
        auto begin = static_cast<std::size_t>(token.text.data() - text_.data());
        begin = token.kind == TokenKind::quote ? text_.find_last_of(" \t\r\n,;", begin) + 1 : begin;
        const std::size_t end = text_.find_first_of(" \t\r\n,;", begin + token.text.size());
        const auto has_number = [](const Token& each) { return each.kind == TokenKind::number; };
        const auto place = tokens_.begin() + (&token - tokens_.data());
        const bool any_before = std::any_of(tokens_.begin(), place, has_number);
        const bool any_after = std::any_of(place + 1, tokens_.end(), has_number);
        const std::string mended = why.empty() ? messages::fix_hint(token.text) : fmt::format("; {}", why);
        throw Usage("argument: not understood {} the numbers: {}{}",
                    any_before && any_after ? "between"
                    : any_before            ? "after"
                                            : "before",
                    quoted(text_.substr(begin, end - begin)),
                    mended.empty() ? "; VALUEs are numbers with labels, units and brackets" : mended);
    }

    void items(std::size_t group) {
        while (peek().kind != TokenKind::end && peek().kind != TokenKind::close) {
            item(group);
        }
    }

    void item(std::size_t group) {
        const Token& token = peek();
        if (depth_ == deepest) {
            refuse(token, "brackets stand too deep in each other");
        }
        ++depth_;
        switch (token.kind) {
        case TokenKind::number:
            if (!sum(group)) {
                number(group, {});
            }
            break;
        case TokenKind::open:
            if (!take_remark(group)) {
                bracket(group);
            }
            break;
        case TokenKind::word: word(group); break;
        case TokenKind::separator:
            if (token.text == "," && last().kind == TokenKind::separator) { // nothing stands between them
                read_.numbers.push_back({.group = group, .bracket = brackets_});
            }
            [[fallthrough]];
        case TokenKind::line:
        case TokenKind::mark: take(); break;
        case TokenKind::quote:
            refuse(token, last().kind == TokenKind::number && token.is_joined
                              ? "minutes and seconds of arc are not read, write decimal degrees"
                              : "a quote has no partner");
        default: refuse(token);
        }
        --depth_;
    }

    void number(std::size_t group, std::string_view label) {
        const bool is_joined = label.empty() && (last().kind == TokenKind::number || is_unit(last()));
        const bool after_comma = last().text == ",";
        const Token& token = take();
        if (size() == most_numbers) {
            refuse(token, fmt::format("more than {} numbers are not one attitude", most_numbers));
        }
        const std::string_view unit =
            unit_of_word(is_unit(peek()) && peek(1).kind != TokenKind::is ? take().text : token.suffix);
        read_.numbers.push_back(
            {std::string(token.text), std::string(label), std::string(unit), group, brackets_, is_joined, after_comma});
    }

    /// The terms of a quaternion's sum, which has i, j or k; those that are missing are 0.
    bool sum(std::size_t group) {
        std::array<std::string, 4> terms;
        std::size_t ahead = 0;
        for (bool has_letter = false;;) {
            const std::string_view sign = peek(ahead).text;
            const bool has_sign = ahead > 0 && peek(ahead).kind == TokenKind::word && (sign == "+" || sign == "-");
            const Token& term = peek(ahead + (has_sign ? 1 : 0));
            const std::size_t place =
                term.suffix.empty() ? 0 : std::string_view("ijk").find(term.suffix) + 1; // 0: none
            const bool is_signed = has_sign || term.text.starts_with('+') || term.text.starts_with('-');
            if (term.kind != TokenKind::number || (ahead > 0 && place == 0 && !(has_letter && is_signed))) {
                at_ += has_letter ? ahead : 0;
                for (std::size_t i = 0; has_letter && i < terms.size(); ++i) {
                    const std::string text = terms.at(i).empty() ? "0" : terms.at(i);
                    read_.numbers.push_back({text, std::string(1, "wxyz"[i]), {}, group, brackets_});
                }
                return has_letter;
            }
            if (!terms.at(place).empty()) {
                refuse(term, "two terms of the sum are of one kind");
            }
            const bool is_negative = (has_sign && sign == "-") != term.text.starts_with('-');
            terms.at(place) = term.text.substr(term.text.find_first_not_of("+-"));
            terms.at(place).insert(0, is_negative ? "-" : "");
            has_letter = has_letter || place > 0;
            ahead += has_sign ? 2 : 1;
        }
    }

    /// A bracket and what stands in it, and the unit behind it.
    void bracket(std::size_t group) {
        const bool is_factor = peek().is_joined && last().kind == TokenKind::number;
        const Token& open = take();
        const std::string element(open.text.substr(1));
        const bool has_content =
            !element.empty() && text_.find("</" + element, static_cast<std::size_t>(open.text.data() - text_.data())) !=
                                    std::string_view::npos;
        const bool is_label =
            has_content ||
            (!element.empty() && (!is(vocabulary::container, without_type(element)) || named_representation(element)));
        const std::size_t own = is_label ? new_group(group, element) : group;
        const std::size_t first = size();
        const bool was_xml = std::exchange(in_xml_, !element.empty());
        const std::size_t limit = std::exchange(limit_, no_limit);
        std::string_view closing;
        do { // the end of a start tag goes on with the content
            items(own);
            closing = take().text;
        } while (has_content && closing == ">");
        const bool is_other = is_angle(open.text) != is_angle(closing) ||
                              (closing.starts_with("</") && closing != fmt::format("</{}>", element));
        limit_ = limit;
        in_xml_ = was_xml;
        if (size() == first || is_factor || is_other) {
            refuse(open);
        }
        if (is_label) {
            collapse(own, first, element);
        }
        const Token& after = peek();
        if (after.is_joined &&
            (after.kind == TokenKind::word || after.kind == TokenKind::number || after.text == ":=")) {
            refuse(after);
        }
        if (is_unit(after) && is_convention(after) && peek(1).kind != TokenKind::is) {
            add_word(take().text, own);
        }
        take_remark(own);
    }

    std::size_t new_group(std::size_t parent, std::string_view label) {
        read_.groups.push_back({std::string(label), parent});
        return read_.groups.size() - 1;
    }
    void add_word(std::string_view word, std::size_t group) {
        const std::string meant = convention_in(word);
        read_.words.push_back({meant.empty() ? std::string(unit_of_word(word)) : meant, group});
    }

    /// The words in brackets at `at` that hold only a unit or a word of convention, (xyzw), (w, x, y, z), joined, and
    /// how many tokens they are with the brackets; 0: there is no such remark.
    [[nodiscard]] std::pair<std::string, std::size_t> remark(std::size_t at = 0) const {
        std::string letters;
        std::size_t size = at + 1;
        for (; peek(size).kind == TokenKind::word || peek(size).kind == TokenKind::separator; ++size) {
            letters += peek(size).kind == TokenKind::word ? peek(size).text : "";
        }
        const bool has_meaning = letters == "wxyz" || letters == "xyzw" ||
                                 (size == at + 2 && (is_unit(peek(at + 1)) || is_convention(peek(at + 1))));
        const bool is_remark = peek(at).kind == TokenKind::open && peek(size).kind == TokenKind::close && has_meaning;
        return {std::move(letters), is_remark ? size - at + 1 : 0};
    }
    [[nodiscard]] std::size_t remark_size(std::size_t at = 0) const { return remark(at).second; }
    bool take_remark(std::size_t group) {
        const auto [letters, size] = remark();
        for (std::size_t i = 0; i < size; ++i) {
            take();
        }
        if (size > 0) {
            add_word(letters, group);
        }
        return size > 0;
    }

    /// Whether a word stands before : or =, perhaps with its unit between, or before a blank and a number.
    [[nodiscard]] bool is_label(std::size_t at) const {
        const Token& token = peek(at);
        if (token.kind != TokenKind::word || !is_name(token.text)) {
            return false;
        }
        const Token& next = peek(at + 1);
        return peek(at + 1 + remark_size(at + 1)).kind == TokenKind::is ||
               (next.kind == TokenKind::number && !next.is_joined && !is_convention(token) &&
                !is(vocabulary::heading, token.text) &&
                !(named_representation(token.text) && peek(at + 2).kind == TokenKind::number)); // q 0.8 0 0 0.6
    }

    void word(std::size_t group) {
        const std::string_view before = last().text;
        const bool is_labelled = is_label(0);
        const Token& token = take();
        const std::string_view text = token.text;
        if (const TokenKind next = peek(lines_ahead()).kind; // of a list
            text == "-" && token.begins_line && !peek().is_joined &&
            (next == TokenKind::word ||
             (limit_ != no_limit && (next == TokenKind::number || next == TokenKind::open)))) {
            return;
        }
        if (!is_name(text) && !is_unit(token) && !is(vocabulary::heading, text)) {
            refuse(token);
        }
        const bool is_labelled_number = is_labelled && peek().kind == TokenKind::number;
        if ((is_labelled_number && sum(group)) || (!is_labelled && is_operation(text))) {
            refuse(token);
        }
        if (is_labelled) {
            is_labelled_number ? number(group, text) : label(group, token);
            return;
        }
        const auto named = named_representation(last_part(text));
        const bool has_columns = is(vocabulary::container_columns, without_type(text)) && lower(peek(1).text) != "rows";
        const bool is_container = named || has_columns || is(vocabulary::container, without_type(last_part(text)));
        const Token& next = peek(remark_size());
        const bool is_call = next.kind == TokenKind::open && remark_size() == 0 && next.text.size() == 1;
        if (next.kind == TokenKind::open && next.text.size() == 1 && (is_container || is(vocabulary::heading, text))) {
            const std::size_t own = named ? new_group(group, last_part(text)) : group; // Quaternion (xyzw) [...]
            if (is(vocabulary::container_xyzw, text) || is(vocabulary::container_xyzw, last_part(text)) ||
                (lower(before) == "in" && named == RepresentationId::quat)) { // tf2_echo's "in Quaternion ["
                add_word("xyzw", own);
            } else if (has_columns) {
                add_word("col", own);
            }
            take_remark(own);
            bracket(own);
        } else if (!is_call && is_convention(token)) {
            add_word(last_part(text), group);
        } else if (const TokenKind kind = peek().kind;
                   is_call || (!(named && (kind == TokenKind::number || kind == TokenKind::line)) && // R and its rows
                               !is(vocabulary::heading, text) &&
                               !(kind == TokenKind::word && !is_unit(peek()) &&
                                 (is_container || is(vocabulary::declaration, text))))) {
            refuse(token);
        }
    }

    /// Reads what stands behind a label.
    void label(std::size_t group, const Token& label) {
        const std::size_t own = new_group(group, label.text.substr(0, label.text.find('[')));
        take_remark(own);
        while (peek().kind == TokenKind::is) {
            take();
        }
        std::string name = lower(label.text);
        name.erase(0, name.find_first_not_of('_'));
        if (is_text(label, name) || is_convention(group, label, name)) {
            return;
        }
        const std::size_t first = size();
        const bool is_of_labels = is_label(0);
        const auto ends = [this, is_of_labels] { // the line, or where the next label begins
            const TokenKind kind = peek().kind;
            return kind == TokenKind::line || kind == TokenKind::end || kind == TokenKind::close ||
                   (!is_of_labels && is_label(kind == TokenKind::separator || kind == TokenKind::mark ? 1 : 0));
        };
        for (bool is_bracket = false; !is_bracket && !ends();) {
            const std::size_t most = size() + (peek().kind == TokenKind::open ? 0 : 1); // float64(1) is one of several
            item(own);
            is_bracket = !is_of_labels && last().kind == TokenKind::close && size() > most;
        }
        const std::size_t limit = std::exchange(limit_, std::min(limit_, end_of_block(label, size() == first)));
        items(own);
        limit_ = limit;
        if (size() == first) {
            refuse(label);
        }
        collapse(own, first, label.text);
    }

    /// The place behind a token, and behind what stands in it if it is a bracket.
    [[nodiscard]] std::size_t behind(std::size_t at) const {
        std::size_t depth = 0;
        do {
            depth += tokens_[at].kind == TokenKind::open ? 1 : 0;
            depth -= tokens_[at].kind == TokenKind::close ? 1 : 0;
        } while (++at < tokens_.size() && depth > 0);
        return at;
    }

    /// The end of the lines below a label that are deeper than its own, or that go on from it without a label.
    [[nodiscard]] std::size_t end_of_block(const Token& label, bool is_empty) const {
        std::size_t end = at_ + lines_ahead();
        const Token& next = peek(lines_ahead());
        const auto goes_on = [&](const Token& token) {
            return token.indent > label.indent ||
                   (is_empty && token.indent == label.indent && (token.text == "-" || token.kind != TokenKind::word));
        };
        if (end == at_ || next.kind == TokenKind::end || !(label.begins_line || is_empty) || !goes_on(next)) {
            return at_;
        }
        while (end < tokens_.size() && tokens_[end].kind != TokenKind::close &&
               (!tokens_[end].begins_line || tokens_[end].kind == TokenKind::line || goes_on(tokens_[end]))) {
            end = behind(end);
        }
        return end;
    }

    /// Takes what a label has that is not a number.
    bool is_text(const Token& label, std::string_view name) {
        if (!is(vocabulary::text_key, name) && !(in_xml_ && is(vocabulary::xml_key, name))) {
            return false;
        }
        const std::size_t end = end_of_block(label, true);
        const bool is_word = peek().kind == TokenKind::word;
        if (end == at_ && !is_word && peek().kind != TokenKind::open) {
            refuse(label);
        }
        at_ = end > at_ ? end : behind(at_);
        if (is_word && peek().kind == TokenKind::open && peek().is_joined) { // device(type='cuda', index=0)
            at_ = behind(at_);
        }
        return true;
    }

    /// Takes a word that says with its label how the numbers of the group are meant.
    bool is_convention(std::size_t group, const Token& label, std::string_view name) {
        const Token& value = peek();
        const bool is_truth = value.kind == TokenKind::word && is(vocabulary::truth, value.text);
        const bool is_order = name == "scalar_first";
        std::string_view word = value.text;
        if (is_truth && (is_order || name == "degrees")) {
            const bool is_true = lower(word) == "true";
            word = is_order ? (is_true ? "wxyz" : "xyzw") : (is_true ? "deg" : "rad");
            std::erase_if(read_.words, [&](const ValueWord& each) { // it wins over a name's order
                return is_order && each.group == group && each.text == "xyzw";
            });
        } else if (is_truth) {
            refuse(label);
        } else if ((name != "order" && name != "seq") || !is_convention(value)) {
            return false;
        } else if (name == "order" && EulerSequence::parse(word)) {
            refuse(value, "as an order this is about the body's axes in three.js, about fixed ones in Blender: write "
                          "a sequence alone, ZYX or zyx");
        }
        take();
        add_word(word, group);
        return true;
    }

    /// A group of one number is that number with its label.
    void collapse(std::size_t own, std::size_t first, std::string_view label) {
        ValueNumber& only = read_.numbers[first];
        if (size() != first + 1 || !only.label.empty() || only.group != own) {
            return;
        }
        only.label = label;
        only.group = read_.groups[own].parent;
        only.is_joined = false;
        const auto is_unit = [own](const ValueWord& each) {
            return each.group == own && !unit_of_word(each.text).empty();
        };
        if (const auto unit = std::ranges::find_if(read_.words, is_unit);
            only.unit.empty() && unit != read_.words.end()) {
            only.unit = unit->text;
            read_.words.erase(unit);
        }
        for (ValueWord& each : read_.words) {
            each.group = each.group == own ? only.group : each.group;
        }
    }

    std::string_view text_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    std::size_t limit_ = no_limit; ///< the end of the block
    std::size_t brackets_ = 0;
    std::size_t depth_ = 0;
    bool in_xml_ = false;
    ValueText read_;
};

// NOLINTEND(misc-no-recursion)

} // namespace

ValueText parse_values(std::string_view text) { return Parser(text).read(); }

// NOLINTNEXTLINE(misc-no-recursion): see Lexer
bool holds_number(std::string_view word) {
    const auto tokens = Lexer(word).tokens();
    return std::ranges::count(tokens, TokenKind::number, &Token::kind) > 0;
}

} // namespace rotconv::cli
