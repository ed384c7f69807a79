#include "gathered_rows.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

namespace rotconv::stream {
namespace {

/// The row of a pair, with what stands behind it in the text of its block.
std::string_view with_room(std::string_view row) noexcept { return {row.data(), row.size() + RowReader::room_behind}; }

} // namespace

GatheredRows::GatheredRows(const Options& options, const Layout& layout, const Layout* reference_layout)
    : options_(&options), layout_(&layout), readers_{RowReader(options.input, layout)} {
    if (reference_layout != nullptr) {
        readers_.emplace_back(options.pairing->reference, *reference_layout);
    }
}

void GatheredRows::expect(const std::array<RowWidth, 2>& widths) noexcept {
    for (std::size_t side = 0; side < readers_.size(); ++side) {
        readers_[side].expect(widths.at(side));
    }
}

void GatheredRows::clear() noexcept {
    rows_.clear();
    parts_.clear();
    errors_.clear();
    lines_.clear();
    reference_lines_.clear();
}

void GatheredRows::gather(std::string_view& text, std::size_t& line, std::size_t most_rows, std::size_t most_bytes) {
    clear();
    const std::size_t width = options_->input.width;
    const std::size_t size = text.size();
    while (!text.empty() && rows_.size() < most_rows && size - text.size() < most_bytes) {
        const auto scanned = options_->input.is_comment(text) ? std::nullopt : readers_[0].scan(text, parts_);
        if (scanned) {
            Row& row = rows_.emplace_back(scanned->line, line++);
            row.numbers = scanned->numbers;
            row.index = lines_.size();
            lines_.push_back(row.number);
            text.remove_prefix(row.line.text.size() + row.line.end.size());
            continue;
        }
        Row& row = rows_.emplace_back(next_row(text, width), line++);
        row.passes = width == 0 && !options_->input.is_row(row.line.text);
        if (!row.passes) {
            read(row);
        }
        if (row.error != Row::no_error && options_->on_error == OnError::stop) {
            return;
        }
    }
}

void GatheredRows::add(const Row& pair, const std::vector<RowError>& errors_of_pairs) {
    Row& row = rows_.emplace_back(pair);
    if (row.error != Row::no_error) {
        errors_.push_back(errors_of_pairs[row.error]);
        row.error = errors_.size() - 1;
    } else if (!row.passes) {
        read(row);
    }
}

void GatheredRows::gather_numbers(std::string_view& doubles, std::size_t& line, std::size_t most_rows) {
    const std::size_t rows = std::min(most_rows, doubles.size() / (layout_->count * sizeof(double)));
    parts_.numbers.resize(rows * layout_->count);
    const std::size_t size = parts_.numbers.size() * sizeof(double);
    std::memcpy(parts_.numbers.data(), doubles.data(), size);
    doubles.remove_prefix(size);
    lines_.resize(rows);
    std::iota(lines_.begin(), lines_.end(), line);
    line += rows;
}

const char* GatheredRows::drop_from(std::size_t index) {
    const auto first =
        std::ranges::find_if(rows_, [index](const Row& row) { return row.has_numbers() && row.index == index; });
    const char* const begin = first->line.text.data();
    rows_.erase(first, rows_.end());
    return begin;
}

void GatheredRows::read(Row& row) {
    const std::size_t first_number = parts_.numbers.size();
    const std::size_t first_kept = parts_.kept.size();
    const std::size_t first_key = parts_.keys.size();
    row.index = lines_.size();
    row.first_field = parts_.fields.size();
    const bool is_pair = row.partner.number > 0; // a single row is scanned by gather()
    const auto scanned = is_pair ? readers_[0].scan(with_room(row.line.text), parts_) : std::nullopt;
    row.numbers = scanned ? scanned->numbers : std::string_view();
    const bool is_own_read = scanned || readers_[0].read(row.line.text, parts_);
    row.field_count = parts_.fields.size() - row.first_field;
    parts_.error.place = {row.number};
    if (is_own_read && (!is_pair || read_partner(row))) {
        lines_.push_back(row.number);
        if (is_pair) {
            reference_lines_.push_back(row.partner.number);
        }
        return;
    }
    parts_.numbers.resize(first_number);
    parts_.kept.resize(first_kept);
    parts_.keys.resize(first_key);
    row.error = errors_.size();
    errors_.push_back(std::move(parts_.error));
}

bool GatheredRows::read_partner(const Row& row) {
    if (!read(row.partner)) {
        return false;
    }
    if (!options_->pairing->interpolates) {
        return true;
    }
    const std::size_t kept = parts_.kept.size();
    const std::size_t keys = parts_.keys.size();
    if (!read(row.later)) {
        return false;
    }
    parts_.numbers.push_back(row.fraction);
    parts_.kept.resize(kept); // without the later key
    parts_.keys.resize(keys);
    return true;
}

bool GatheredRows::read(const Partner& partner) {
    const RowReader& reader = readers_[1];
    const bool is_read = reader.scan(with_room(partner.text), parts_) || reader.read(partner.text, parts_);
    parts_.error.place = {partner.number, Side::reference};
    return is_read;
}

std::span<const double> GatheredRows::numbers_of(const Row& row) const noexcept {
    const std::size_t size = parts_.numbers.size() / lines_.size();
    return std::span<const double>(parts_.numbers).subspan(row.index * size, size);
}

void GatheredRows::split(Row& row) {
    if (options_->input.width > 0) {
        split_doubles(row);
    } else if (row.field_count == 0) {
        row.first_field = parts_.fields.size();
        static_cast<void>(layout_->delimiter.split(row.line.text, parts_.fields));
        row.field_count = parts_.fields.size() - row.first_field;
    }
}

void GatheredRows::split_doubles(Row& row) {
    const std::string_view bytes = row.line.text;
    constexpr std::size_t room = 40; // for a number and the delimiter, so that the text never moves
    const std::size_t width = options_->input.width;
    parts_.fields.clear();
    row.first_field = 0;
    row.field_count = width;
    made_.clear();
    made_.reserve(room * (width + 1));
    for (std::size_t i = 0; i < width; ++i) {
        const std::string_view field = bytes.substr(i * sizeof(double), sizeof(double));
        if (options_->format == Format::f64) {
            parts_.fields.push_back(field);
            continue;
        }
        if (i > 0) {
            made_.push_back(layout_->delimiter.text());
        }
        double number = 0.0;
        std::memcpy(&number, field.data(), sizeof(double));
        const std::size_t begin = made_.size();
        append_number(made_, number, {});
        parts_.fields.emplace_back(made_.data() + begin, made_.size() - begin);
    }
    if (options_->format != Format::f64) {
        row.line.text = {made_.data(), made_.size()};
    }
}

void GatheredRows::move_to(AnsweredRows& batch) {
    batch.numbers = std::move(parts_.numbers);
    batch.lines = std::move(lines_);
    batch.reference_lines = std::move(reference_lines_);
    batch.kept = std::move(parts_.kept);
    batch.keys = std::move(parts_.keys);
}

} // namespace rotconv::stream
