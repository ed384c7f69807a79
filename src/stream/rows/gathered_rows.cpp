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

void GatheredRows::gather(std::string_view& text, std::size_t& line, std::size_t most_rows, std::size_t most_bytes) {
    read_.clear();
    const std::size_t width = options_->input.width;
    const std::size_t size = text.size();
    while (!text.empty() && read_.rows.size() < most_rows && size - text.size() < most_bytes) {
        const bool is_comment = width == 0 && options_->input.is_comment(text);
        const auto scanned = is_comment ? std::nullopt : readers_[0].scan(text, read_.parts);
        if (scanned) {
            Row& row = read_.rows.emplace_back(scanned->line, line++);
            row.numbers = scanned->numbers;
            row.index = read_.parts.lines.size();
            read_.parts.lines.push_back(row.number);
            text.remove_prefix(row.line.text.size() + row.line.end.size());
            continue;
        }
        Row& row = read_.rows.emplace_back(next_line(text), line++);
        row.passes = !options_->input.is_row(row.line.text);
        if (!row.passes) {
            read_last();
        }
        if (row.error != nullptr && options_->on_error == OnError::stop) {
            return;
        }
    }
}

void GatheredRows::gather_numbers(std::string_view& doubles, std::size_t& line, std::size_t most_rows) {
    read_.clear();
    read_.parts.lines.resize(std::min(most_rows, doubles.size() / (layout_->count * sizeof(double))));
    std::iota(read_.parts.lines.begin(), read_.parts.lines.end(), line);
    line += read_.parts.lines.size();
    read_.parts.numbers.resize(read_.parts.lines.size() * layout_->count);
    const std::size_t size = read_.parts.numbers.size() * sizeof(double);
    std::memcpy(read_.parts.numbers.data(), doubles.data(), size);
    doubles.remove_prefix(size);
}

void GatheredRows::add_rows(std::string_view doubles) {
    for (const std::size_t number : read_.parts.lines) {
        Row& row = read_.rows.emplace_back(next_row(doubles, options_->input.width), number);
        row.numbers = row.line.text;
        row.index = read_.rows.size() - 1;
    }
}

const char* GatheredRows::drop_from(std::size_t index) {
    const auto first =
        std::ranges::find_if(read_.rows, [index](const Row& row) { return row.has_numbers() && row.index == index; });
    const char* const begin = first->line.text.data();
    read_.rows.erase(first, read_.rows.end());
    return begin;
}

void GatheredRows::read_last() {
    Row& row = read_.rows.back();
    RowParts& parts = read_.parts;
    const std::size_t first_number = parts.numbers.size();
    row.index = read_.parts.lines.size();
    row.first_field = parts.fields.size();
    const bool is_read = readers_[0].read(row.line.text, parts);
    row.field_count = parts.fields.size() - row.first_field;
    if (is_read) {
        read_.parts.lines.push_back(row.number);
    } else {
        parts.numbers.resize(first_number);
        parts.error.place = {row.number};
        read_.fail(std::exchange(parts.error, {}));
    }
}

const Pair& GatheredRows::pair_of(const Row& row) const noexcept {
    static const Pair none;
    return read_.pairs.empty() ? none : read_.pairs[static_cast<std::size_t>(&row - read_.rows.data())];
}

RowError GatheredRows::error_of(const Row& row, const RowReport& report, std::string_view given) const {
    if (row.error != nullptr) {
        return *row.error;
    }
    if (options_->pairing && report.error == Error::past_half_turn) { // between neighbours half a turn apart
        return {.place = {row.number},
                .what = RowError::What::no_partner,
                .text = std::string(given),
                .error = report.error};
    }
    const Pair& pair = pair_of(row);
    const bool is_partner = report.at_fault > 0 && pair.partner.number > 0;
    const Partner& at = report.at_fault == 2 ? pair.later : pair.partner;
    return {.place = {row.number},
            .cause = {is_partner ? at.number : 0, Side::reference},
            .what = RowError::What::attitude,
            .text = is_partner ? readers_[1].selected_text(at.text) : readers_[0].selected_text(given),
            .error = report.error,
            .defect = report.defect,
            .norm = report.error == Error::defect ? norm_of(row, report) : 0.0};
}

double GatheredRows::norm_of(const Row& row, const RowReport& report) const {
    if (report.at_fault > 0 && !options_->pairing) {
        return 0.0; // the second attitude of a row
    }
    const RowNumbers& read = report.at_fault > 0 ? options_->pairing->reference.numbers : options_->input.numbers;
    if (!read.attitude || read.attitude->name != RepresentationId::quat) {
        return 0.0;
    }
    std::span<const double> q = read_.parts.numbers;
    q = q.subspan(row.index * (q.size() / read_.parts.lines.size())); // with the partner's
    if (report.at_fault > 0 && options_->pairing->interpolates) {
        const InterpolatedPair& between = read_.parts.between[row.index];
        q = std::span<const double>(read_.parts.neighbours)
                .subspan(4 * (report.at_fault == 2 ? between.later : between.earlier));
    } else if (report.at_fault > 0) {
        q = q.subspan(layout_->count - read.kept);
    }
    q = q.first(4);
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
        row.first_field = read_.parts.fields.size();
        static_cast<void>(layout_->delimiter.split(row.line.text, read_.parts.fields));
        row.field_count = read_.parts.fields.size() - row.first_field;
    }
}

void GatheredRows::split_doubles(Row& row) {
    const std::string_view bytes = row.line.text;
    constexpr std::size_t room = 40; // for a number and the delimiter, so that the text never moves
    const std::size_t width = options_->input.width;
    read_.parts.fields.clear();
    row.first_field = 0;
    row.field_count = width;
    made_.clear();
    made_.reserve(room * (width + 1));
    for (std::size_t i = 0; i < width; ++i) {
        const std::string_view field = bytes.substr(i * sizeof(double), sizeof(double));
        if (options_->format == Format::f64) {
            read_.parts.fields.push_back(field);
            continue;
        }
        if (i > 0) {
            made_.push_back(layout_->delimiter.text());
        }
        double number = 0.0;
        std::memcpy(&number, field.data(), sizeof(double));
        const std::size_t begin = made_.size();
        append_number(made_, number, {});
        read_.parts.fields.emplace_back(made_.data() + begin, made_.size() - begin);
    }
    if (options_->format != Format::f64) {
        row.line.text = {made_.data(), made_.size()};
    }
}

} // namespace rotconv::stream
