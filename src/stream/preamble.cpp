#include "preamble.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "row_writer.hpp"

namespace rotconv::stream {

Preamble::Preamble(const InputOptions& options, const Options* written)
    : options_(&options), written_(written),
      header_done_(options.header == HeaderMode::no || options.header == HeaderMode::add) {
    layout_.appends = written != nullptr && written->append;
    layout_.is_whole = options.columns.empty();
    if (!options.columns.has_names()) {
        layout_.select(options.columns.positions(), options.numbers.names.size(), options.numbers.kept);
    }
}

bool Preamble::read(std::string_view& text, std::size_t& line, Output& output) {
    if (!has_row_ && options_->width > 0 && !text.empty()) {
        has_row_ = true;
        set_layout(nullptr, line, output);
    }
    while (!has_row_ && !text.empty()) {
        std::string_view after = text;
        const Line current = next_line(after);
        const std::string_view whole = text.substr(0, text.size() - after.size());
        bool is_data = options_->is_row(current.text);
        if (is_data) {
            std::erase_if(layout_.notes, [](const Note& note) { return note.kind == Note::Kind::comments; });
            only_comments_ = false;
        } else if (only_comments_ && layout_.notes.empty() && !is_blank(current.text)) {
            add_notes({.comment = current.text}, line);
        }
        if (!header_done_) {
            hold(whole);
            is_data = is_data && find_header(false, output);
            limit(output);
        } else if (!is_data) {
            pass(whole, output);
        }
        if (is_data) {
            set_layout(&current, line, output);
        }
        if (error_) {
            text = {};
        } else if (is_data) {
            has_row_ = true;
        } else {
            text = after;
            ++line;
        }
    }
    return has_row_;
}

void Preamble::finish(Output& output, bool at_end) {
    if (has_row_) {
        return;
    }
    if (at_end && !header_done_) {
        find_header(true, output);
    }
    release(held_.size(), output);
    if (at_end && header_line_ > 0) {
        add_notes({.only_header = true}, header_line_);
    }
    if (at_end && !error_) {
        set_layout(nullptr, 0, output);
    }
}

void Preamble::hold(std::string_view line) {
    const std::size_t begin = held_.size();
    held_.append(line);
    if (const std::string_view text = line.substr(0, line.find_last_not_of("\r\n") + 1); is_blank(text)) {
        blank_ += line.size();
    } else if (options_->is_comment(text)) {
        blank_ = 0;
        comment_begin_ = begin;
        comment_end_ = held_.size();
    }
}

std::vector<Line> Preamble::held_lines() const {
    std::vector<Line> lines;
    for (std::string_view text = held_; !text.empty();) {
        if (const Line line = next_line(text); !is_blank(line.text)) {
            lines.push_back(line);
        }
    }
    return lines;
}

std::size_t Preamble::number_of(const Line& line) const {
    return held_line_ + static_cast<std::size_t>(std::count(held_.data(), line.text.data(), '\n'));
}

bool Preamble::find_header(bool is_end, Output& output) {
    const std::vector<Line> lines = held_lines();
    const std::optional<Beginning> beginning = decide(lines, *options_, is_end);
    if (!beginning) {
        return false;
    }
    if (beginning->error) {
        error_ = beginning->error;
        error_->place.line = number_of(beginning->error_line);
    }
    if (!beginning->positions.empty()) {
        layout_.select(beginning->positions, options_->numbers.names.size(), options_->numbers.kept);
    }
    if (beginning->is_data) { // the row is converted, not copied
        held_.resize(held_.size() - lines.back().text.size() - lines.back().end.size());
    }
    if (beginning->header) {
        const HeaderLine& header = *beginning->header;
        const auto begin = static_cast<std::size_t>(header.line.text.data() - held_.data());
        header_line_ = number_of(header.line);
        if (const auto names = header.names_at(layout_.positions); names && names->size() == layout_.count) {
            read_by(*names);
            add_notes({.names = *names, .header = header.names()}, header_line_);
        }
        if (error_) {
            held_.clear();
            return false;
        }
        pass(std::string_view(held_).substr(0, begin), output);
        keep_names(header);
        if (is_written()) {
            write_header(output.bytes, *written_, layout_, header);
        }
        layout_.names = header.names();
        layout_.header = {header.width(), header_line_};
        held_.erase(0, begin + header.line.text.size() + header.line.end.size());
    }
    if (!error_) {
        header_done_ = true;
        release(held_.size(), output);
    }
    return beginning->is_data && !error_;
}

void Preamble::pass(std::string_view text, Output& output) const {
    if (is_written()) {
        append(output.bytes, text);
    }
}

void Preamble::release(std::size_t bytes, Output& output) {
    const std::string_view released = std::string_view(held_).substr(0, bytes);
    pass(released, output);
    held_line_ += static_cast<std::size_t>(std::ranges::count(released, '\n'));
    held_.erase(0, bytes);
    comment_begin_ -= std::min(comment_begin_, bytes);
    comment_end_ -= std::min(comment_end_, bytes);
    blank_ = std::min(blank_, held_.size());
}

void Preamble::limit(Output& output) {
    constexpr std::size_t most_held = std::size_t{64} << 10U;
    constexpr std::size_t most_blank = std::size_t{1} << 20U;
    const auto is_too_much = [this](std::size_t size) { return size - blank_ > most_held || blank_ > most_blank; };
    if (header_done_ || error_ || !is_too_much(held_.size() - (comment_end_ - comment_begin_))) {
        return;
    }
    if (options_->columns.has_names()) {
        find_header(true, output);
    }
    if (!header_done_ && !error_) {
        release(is_too_much(held_.size() - comment_end_) ? held_.size() : comment_begin_, output);
    }
}

void Preamble::add_notes(const Said& said, std::size_t line) {
    if (!options_->notes_of) {
        return;
    }
    for (Note& note : options_->notes_of(said)) {
        note.place.line = line;
        layout_.notes.push_back(std::move(note));
    }
}

void Preamble::read_by(const std::vector<std::string>& names) {
    if (!options_->order_of) {
        return;
    }
    std::vector<std::size_t> fields = options_->order_of(names).places;
    if (!std::ranges::is_sorted(fields)) {
        std::ranges::transform(fields, fields.begin(), [this](std::size_t at) { return layout_.position(at); });
        layout_.select(std::move(fields), layout_.count, options_->numbers.kept);
    }
}

void Preamble::keep_names(const HeaderLine& header) {
    if (written_ == nullptr || !written_->operation->keeps_names) {
        return;
    }
    const std::size_t count = written_->operation->names.size();
    for (std::size_t i = layout_.count - count; i < layout_.count; ++i) {
        const std::size_t at = layout_.position(i);
        layout_.kept_names.emplace_back(at < header.fields.size() ? trimmed(header.fields[at]) : "");
    }
    if (written_->format == Format::json) {
        const auto keys = result_keys(*written_, layout_, header.delimiter);
        if (std::set(keys.begin(), keys.end()).size() < keys.size()) {
            layout_.kept_names.clear(); // a key must not occur twice
        }
    }
}

void Preamble::set_layout(const Line* row, std::size_t number, Output& output) {
    const std::size_t known = options_->width > 0 ? options_->width : options_->columns.empty() ? layout_.count : 0;
    layout_.delimiter =
        options_->delimiter.value_or(row != nullptr ? Delimiter::of_row(row->text) : Delimiter::character(','));
    layout_.field_count = row != nullptr ? HeaderLine(*row, layout_.delimiter).fields.size() : known;
    layout_.line_end = row == nullptr || row->end.empty() ? "\n" : std::string(row->end);
    if (row != nullptr && options_->take_count) {
        const auto taken = options_->take_count(layout_.field_count);
        if (const auto* wrong = std::get_if<std::string>(&taken)) {
            error_ = StreamError{.what = StreamError::What::count,
                                 .place = {number},
                                 .column = {.text = std::string(row->text)},
                                 .wrong = *wrong};
            return;
        }
        layout_.select({}, std::get<std::size_t>(taken), options_->numbers.kept);
    }
    if (written_ == nullptr || !written_->writes_rows || layout_.field_count == 0) {
        return;
    }
    if (is_written() && options_->header == HeaderMode::add) {
        write_added_header(output.bytes, *written_, layout_);
    }
    if (written_->format == Format::json) {
        layout_.keys = JsonKeys(layout_.names, result_keys(*written_, layout_, layout_.delimiter),
                                [this](std::size_t at) { return !layout_.replaces(at); });
    }
}

} // namespace rotconv::stream
