#include "row_blocks.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <variant>

#include "row_writer.hpp"

namespace rotconv::stream {
namespace {

/// How much is looked at before lines are judged as if nothing followed.
constexpr std::size_t most_lines = 100; ///< neither blank nor comments
constexpr std::size_t most_held = std::size_t{64} << 10U;
constexpr std::size_t most_behind = std::size_t{128} << 10U; ///< bytes of blank lines, and of comments below a line

} // namespace

RowBlocks::RowBlocks(Source& source, const InputOptions& options, const Options* written, std::size_t block_size)
    : blocks_(source, options.width * sizeof(double), block_size), options_(&options), written_(written) {
    layout_.appends = written != nullptr && written->append;
    layout_.is_whole = options.columns.empty() && !options.are_chosen;
    if (!options.columns.has_names()) {
        layout_.select(options.columns.positions(), options.numbers.names.size(), options.numbers.kept);
    }
}

bool RowBlocks::read(Job& job) {
    const bool goes_on = blocks_.read(job.block);
    if (!has_row_ && !error_) {
        find_rows(job.block, !goes_on && !blocks_.error(), job.output);
    }
    return goes_on && !error();
}

void RowBlocks::find_rows(IoBlock& block, bool is_end, Output& output) {
    if (options_->width > 0) {
        has_row_ = !block.text.empty();
        if (has_row_) {
            set_layout(nullptr, block.first_line, output);
        }
        return;
    }
    const std::string_view text = block.text;
    while (!has_row_ && !error_) {
        auto beginning = hold(block.text, output);
        if (!beginning && is_end && !read_as_one(block, output)) {
            beginning = decide(looked_at_lines(), *options_, true);
        }
        if (!beginning) {
            return;
        }
        const std::size_t taken = text.size() - block.text.size();
        const std::string_view rows = start(*beginning, block.first_line, output);
        if (error_) {
            block.text = {};
        } else if (!has_row_) {
            is_settled_ = true;
        } else if (rows.size() <= taken) {
            block.text = text.substr(taken - rows.size());
        } else { // some came before this block
            Buffer bytes;
            append(bytes, rows);
            append(bytes, block.text);
            block.bytes = std::move(bytes);
            block.text = {block.bytes.data(), block.bytes.size()};
        }
        held_line_ += count_of('\n', std::exchange(held_, {}));
        if (block.text.empty()) {
            return;
        }
    }
}

std::optional<Beginning> RowBlocks::hold(std::string_view& text, Output& output) {
    while (!text.empty()) {
        const std::string_view from = text;
        const Line line = next_line(text);
        const bool is_row = options_->is_row(line.text);
        if (is_row) {
            ++looked_at_;
            std::erase_if(layout_.notes, [](const Note& note) { return note.kind == Note::Kind::comments; });
        } else if (is_settled_) {
            pass(from.substr(0, from.size() - text.size()), output);
            ++held_line_;
            continue;
        } else if (!is_blank(line.text)) {
            last_comment_ = held_.size();
            if (looked_at_ == 0 && layout_.notes.empty()) {
                add_notes({.comment = line.text}, held_line_ + count_of('\n', held_));
            }
        }
        const bool is_full =
            looked_at_ > 1 && (held_.size() > most_held || (looked_at_ >= most_lines && !options_->read_text));
        const bool is_late = looked_at_ > most_lines && !is_full; // the whole may be one attitude
        held_.append(from.substr(0, from.size() - text.size()));
        if (is_row && is_settled_) {
            return Beginning{
                .row = HeaderLine(held_lines()[0], options_->delimiter.value_or(Delimiter::of_row(line.text)))};
        }
        const bool may_be_header = is_row || (looked_at_ == 0 && !is_blank(line.text));
        behind_ = may_be_header ? 0 : behind_ + from.size() - text.size();
        const bool is_long = behind_ > most_behind;
        if ((is_row && !is_late) || is_long) {
            if (auto found = decide(looked_at_lines(), *options_, is_full || !is_row)) {
                return found;
            }
            behind_ = 0;
        }
        if (looked_at_ == 0 && (is_long || held_.size() > most_held)) { // only the last comment may be the header
            const std::size_t size = last_comment_ && !is_long ? *last_comment_ : held_.size();
            pass(std::string_view(held_).substr(0, size), output);
            held_line_ += count_of('\n', std::string_view(held_).substr(0, size));
            held_.erase(0, size);
            last_comment_ = last_comment_ && !is_long ? std::optional<std::size_t>(0) : std::nullopt;
        }
    }
    return std::nullopt;
}

std::vector<Line> RowBlocks::held_lines() const {
    std::vector<Line> lines;
    for (std::string_view text = held_; !text.empty();) {
        lines.push_back(next_line(text));
    }
    return lines;
}

std::vector<Line> RowBlocks::looked_at_lines() const {
    auto lines = held_lines();
    std::size_t rows = 0;
    const auto end = std::ranges::find_if(
        lines, [&](const Line& line) { return options_->is_row(line.text) && ++rows > most_lines; });
    lines.erase(end, lines.end());
    return lines;
}

std::size_t RowBlocks::number_of(const Line& line) const {
    return held_line_ + static_cast<std::size_t>(std::count(held_.data(), line.text.data(), '\n'));
}

std::string_view RowBlocks::start(const Beginning& beginning, std::size_t& first_line, Output& output) {
    const std::string_view held = held_;
    if (beginning.error) {
        error_ = beginning.error;
        error_->place.line = number_of(beginning.error_line);
        return {};
    }
    const auto until = [held](const Line& line) {
        return held.substr(0, static_cast<std::size_t>(line.text.data() - held.data()));
    };
    if (!beginning.positions.empty()) {
        layout_.is_whole = false;
        layout_.select(beginning.positions, options_->numbers.names.size(), options_->numbers.kept);
    }
    const auto lines = held_lines();
    const std::string_view before = beginning.rows < lines.size() ? until(lines[beginning.rows]) : held;
    const std::string_view passed = beginning.header ? until(beginning.header->line) : before;
    tell_passed(passed);
    pass(passed, output);
    if (beginning.header) {
        start_below(*beginning.header, beginning.units ? &*beginning.units : nullptr, output);
        const std::size_t end = passed.size() + beginning.header->line.text.size() + beginning.header->line.end.size();
        pass(beginning.units ? until(beginning.units->line).substr(end) : before.substr(end), output);
    }
    if (beginning.row) {
        const std::size_t number = number_of(beginning.row->line);
        width_ = layout_.is_whole ? RowWidth() : RowWidth{beginning.row->width(), number};
        if (beginning.choice) {
            layout_.notes.push_back(*beginning.choice);
            layout_.notes.back().place.line = number;
        }
        has_row_ = true;
        set_layout(&*beginning.row, number, output);
    } else {
        pass(held.substr(before.size()), output);
        return {};
    }
    first_line = held_line_ + count_of('\n', before);
    return held.substr(before.size());
}

void RowBlocks::start_below(const HeaderLine& header, const HeaderLine* units, Output& output) {
    header_line_ = number_of(header.line);
    if (const auto names = header.names_at(layout_.positions); names && names->size() == layout_.count) {
        HeaderFacts said{.names = *names, .header = header.names()};
        for (std::size_t i = 0; units != nullptr && i < layout_.count; ++i) {
            if (const std::size_t at = layout_.position(i); at < units->fields.size()) {
                said.units.push_back(units->name(at));
            }
        }
        if (options_->order_of) {
            auto fields = options_->order_of(*names);
            if (!std::ranges::is_sorted(fields)) {
                std::ranges::transform(fields, fields.begin(), [this](std::size_t at) { return layout_.position(at); });
                layout_.select(std::move(fields), layout_.count, options_->numbers.kept);
            }
        }
        add_notes(said, header_line_);
    }
    keep_names(header);
    if (is_written()) {
        write_header(output.bytes, *written_, layout_, header);
        if (units != nullptr) {
            write_units(output.bytes, *written_, layout_, *units);
        }
    }
    layout_.names = header.names();
    layout_.header = {header.width(), header_line_};
}

bool RowBlocks::read_as_one(IoBlock& block, Output& output) {
    auto read = options_->read_text && looked_at_ > 0 ? options_->read_text(held_) : std::nullopt;
    if (!read) {
        return false;
    }
    std::ranges::move(read->second, std::back_inserter(layout_.notes));
    block.bytes.clear();
    append(block.bytes, read->first);
    block.text = {block.bytes.data(), block.bytes.size()};
    block.first_line = 1;
    has_row_ = true;
    std::string_view text = held_;
    const HeaderLine row({block.text, next_line(text).end},
                         options_->delimiter.value_or(Delimiter::of_row(block.text)));
    set_layout(&row, 1, output);
    held_.clear();
    return true;
}

void RowBlocks::finish(Output& output, bool at_end) {
    if (has_row_) {
        return;
    }
    pass(std::exchange(held_, {}), output);
    if (at_end && header_line_ > 0) {
        add_notes({.only_header = true}, header_line_);
    }
    if (at_end && !error_) {
        set_layout(nullptr, 0, output);
    }
}

void RowBlocks::pass(std::string_view text, Output& output) const {
    if (is_written()) {
        append(output.bytes, text);
    }
}

void RowBlocks::tell_passed(std::string_view text) {
    HeaderFacts said;
    std::size_t first = 0;
    for (std::size_t line = held_line_; !text.empty(); ++line) {
        const std::string_view next = next_line(text).text;
        if (options_->is_row(next) && said.passed++ == 0) {
            said.comment = next;
            first = line;
        }
    }
    if (said.passed > 0) {
        add_notes(said, first);
    }
}

void RowBlocks::add_notes(const HeaderFacts& said, std::size_t line) {
    if (!options_->notes_of) {
        return;
    }
    for (Note& note : options_->notes_of(said)) {
        note.place.line = line;
        layout_.notes.push_back(std::move(note));
    }
}

void RowBlocks::keep_names(const HeaderLine& header) {
    if (written_ == nullptr || !written_->operation->keeps_names) {
        return;
    }
    const std::size_t count = written_->operation->width();
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

void RowBlocks::set_layout(const HeaderLine* row, std::size_t number, Output& output) {
    const std::size_t known = options_->width > 0 ? options_->width : options_->columns.empty() ? layout_.count : 0;
    layout_.delimiter = row != nullptr ? row->delimiter : options_->delimiter.value_or(Delimiter::character(','));
    layout_.field_count = row != nullptr ? row->fields.size() : known;
    layout_.line_end = row == nullptr || row->line.end.empty() ? "\n" : std::string(row->line.end);
    if (row != nullptr && options_->take_count) {
        const auto taken = options_->take_count(layout_.field_count);
        if (const auto* wrong = std::get_if<std::string>(&taken)) {
            error_ = StreamError{.what = StreamError::What::count,
                                 .place = {number},
                                 .column = {.text = std::string(row->line.text)},
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
