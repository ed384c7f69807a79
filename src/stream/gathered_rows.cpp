#include "gathered_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

namespace rotconv::stream {

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
        const bool is_comment = width == 0 && options_->input.is_comment(text);
        const auto scanned = is_comment ? std::nullopt : readers_[0].scan(text, parts_);
        if (scanned) {
            Row& row = rows_.emplace_back(scanned->line, line++);
            row.numbers = scanned->numbers;
            row.index = lines_.size();
            lines_.push_back(row.number);
            text.remove_prefix(row.line.text.size() + row.line.end.size());
            continue;
        }
        Row& row = rows_.emplace_back(next_line(text), line++);
        row.passes = !options_->input.is_row(row.line.text);
        if (!row.passes) {
            take(row);
        }
        if (row.error != nullptr && options_->on_error == OnError::stop) {
            return;
        }
    }
}

void GatheredRows::add(const Row& pair) {
    if (Row& row = rows_.emplace_back(pair); row.has_numbers()) {
        take(row);
    }
}

void GatheredRows::gather_numbers(std::string_view& doubles, std::size_t& line, std::size_t most_rows) {
    clear();
    lines_.resize(std::min(most_rows, doubles.size() / (layout_->count * sizeof(double))));
    std::iota(lines_.begin(), lines_.end(), line);
    line += lines_.size();
    parts_.numbers.resize(lines_.size() * layout_->count);
    const std::size_t size = parts_.numbers.size() * sizeof(double);
    std::memcpy(parts_.numbers.data(), doubles.data(), size);
    doubles.remove_prefix(size);
}

void GatheredRows::add_rows(std::string_view doubles) {
    for (const std::size_t number : lines_) {
        Row& row = rows_.emplace_back(next_row(doubles, options_->input.width), number);
        row.numbers = row.line.text;
        row.index = rows_.size() - 1;
    }
}

const char* GatheredRows::drop_from(std::size_t index) {
    const auto first =
        std::ranges::find_if(rows_, [index](const Row& row) { return row.has_numbers() && row.index == index; });
    const char* const begin = first->line.text.data();
    rows_.erase(first, rows_.end());
    return begin;
}

void GatheredRows::take(Row& row) {
    const std::size_t first_number = parts_.numbers.size();
    const std::size_t first_kept = parts_.kept.size();
    const std::size_t first_key = parts_.keys.size();
    row.index = lines_.size();
    row.first_field = parts_.fields.size();
    const bool is_pair = row.partner.number > 0;
    const bool is_own_read = take_line(row.line.text, Side::stream, is_pair);
    row.field_count = parts_.fields.size() - row.first_field;
    if (is_own_read && (!is_pair || take_partner(row))) {
        lines_.push_back(row.number);
        if (is_pair) {
            reference_lines_.push_back(row.partner.number);
        }
        return;
    }
    parts_.numbers.resize(first_number);
    parts_.kept.resize(first_kept);
    parts_.keys.resize(first_key);
    parts_.error.place = {row.number};
    row.error = &errors_.emplace_back(std::exchange(parts_.error, {}));
}

bool GatheredRows::take_partner(const Row& row) {
    const auto take = [this](const Partner& partner) {
        const bool is_read = take_line(partner.text, Side::reference, true);
        parts_.error.cause = {is_read ? 0 : partner.number, Side::reference};
        return is_read;
    };
    if (!take(row.partner)) {
        return false;
    }
    if (!options_->pairing->interpolates) {
        return true;
    }
    const std::size_t kept = parts_.kept.size();
    const std::size_t keys = parts_.keys.size();
    if (!take(row.later)) {
        return false;
    }
    parts_.numbers.push_back(row.fraction);
    parts_.kept.resize(kept); // without the later key
    parts_.keys.resize(keys);
    return true;
}

bool GatheredRows::take_line(std::string_view text, Side side, bool of_pair) {
    const RowReader& reader = readers_[index_of(side)];
    const bool is_scanned = of_pair && reader.scan({text.data(), text.size() + RowReader::room_behind}, parts_);
    return is_scanned || reader.read(text, parts_); // gather() has scanned a line that is not of a pair
}

RowError GatheredRows::error_of(const Row& row, const RowReport& report, std::string_view given) const {
    if (row.error != nullptr) {
        return *row.error;
    }
    if (row.fraction > 0.0 && report.error == Error::past_half_turn) {
        return {.place = {row.number},
                .what = RowError::What::no_partner,
                .text = std::string(given),
                .error = report.error};
    }
    const bool is_partner = report.of_reference && row.partner.number > 0;
    const Partner& at = report.of_later ? row.later : row.partner;
    return {.place = {row.number},
            .cause = {is_partner ? at.number : 0, Side::reference},
            .what = RowError::What::attitude,
            .text =
                is_partner ? reader(Side::reference).selected_text(at.text) : reader(Side::stream).selected_text(given),
            .error = report.error,
            .defect = report.defect,
            .norm = report.error == Error::defect ? norm_of(row, report) : 0.0};
}

double GatheredRows::norm_of(const Row& row, const RowReport& report) const {
    if (report.of_reference && row.partner.number == 0) {
        return 0.0; // the second attitude of a row
    }
    const RowNumbers& read = report.of_reference ? options_->pairing->reference.numbers : options_->input.numbers;
    if (!read.attitude || read.attitude->name != RepresentationId::quat) {
        return 0.0;
    }
    const PairColumns columns{.first_size = layout_->count - read.kept, .second_size = 4};
    const std::size_t first = report.of_later ? columns.later() : report.of_reference ? columns.first_size : 0;
    const std::size_t size = parts_.numbers.size() / lines_.size(); // with the partner's
    const auto q = std::span<const double>(parts_.numbers).subspan(row.index * size + first, 4);
    const double largest = std::abs(std::ranges::max(q, {}, [](double number) { return std::abs(number); }));
    double squares = 0.0; // scaled, so that they neither overflow nor underflow
    for (const double number : q) {
        squares += (number / largest) * (number / largest);
    }
    return largest * std::sqrt(squares);
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
