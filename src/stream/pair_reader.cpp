#include "pair_reader.hpp"

#include <algorithm>
#include <utility>

namespace rotconv::stream {
namespace {

/// The smallest number of rows that is worth handing on as a job, and the largest.
constexpr std::size_t enough_rows = 256;
constexpr std::size_t most_rows = 2048;
/// The largest number of texts that a job with few rows may hold: the rows between them may have been left out.
constexpr std::size_t most_texts = 8;
/// The largest numbers of lines and of bytes between a row and the next row whose key must be known.
constexpr std::size_t most_lines_ahead = 4096;
constexpr std::size_t most_bytes_ahead = std::size_t{1} << 20U;

} // namespace

void PairReader::Stream::take_block(Job& job) {
    ended = !blocks.read(job);
    auto& [bytes, block_text, first_line] = job.block;
    if (const std::size_t size = block_text.size(); size > 0) {
        auto text = std::make_shared<Buffer>();
        if (2 * size < bytes.capacity()) { // it may wait, and should not hold much memory that is empty
            append(*text, block_text);
        } else {
            bytes.resize(static_cast<std::size_t>(block_text.data() - bytes.data()) + size);
            *text = std::move(bytes);
        }
        const std::size_t end = text->size();
        text->resize(end + RowReader::room_behind);
        std::fill(text->begin() + end, text->end(), '\0'); // none of the input's bytes
        unread = {text->data() + end - size, size};
        texts.push_back(std::move(text));
        line = first_line;
    }
    block_text = {};
}

void PairReader::Stream::take_line() {
    Waiting& next = waiting.emplace_back();
    next.number = line++;
    next.line = next_row(unread, options->width);
    next.ends_text = unread.empty();
    next.passes = options->width == 0 && !options->is_row(next.line.text);
    if (!next.passes && by_key) {
        find_key(next);
    }
    rows_waiting += next.may_be_paired() ? 1U : 0U;
    bytes_waiting += next.line.text.size();
}

void PairReader::Stream::find_key(Waiting& row) {
    parts.clear();
    const auto key_text = reader.key(row.line.text, parts);
    const ReadKey key = key_text ? reader.key_of(*key_text) : ReadKey();
    if (key_text && key.error != KeyError::none) {
        const bool is_word = key.error == KeyError::not_a_number;
        parts.error = {
            .what = is_word ? RowError::What::not_a_number : RowError::What::key, .text = *key_text, .key = key.error};
    } else if (key_text && range && key.value <= range->last) {
        parts.error = {.what = RowError::What::key_order, .text = *key_text};
    } else if (key_text) {
        keys.push_back(key.value);
        range = {range ? range->first : key.value, key.value};
        return;
    }
    parts.error.place = {row.number, side};
    row.error = std::make_unique<RowError>(std::move(parts.error));
}

PairReader::At PairReader::Stream::look(std::size_t ahead) {
    while (rows_waiting <= ahead) {
        if (unread.empty()) {
            return ended ? At::end : At::dry;
        }
        if (ahead > 0 && (waiting.size() > most_lines_ahead || bytes_waiting > most_bytes_ahead)) {
            return At::too_far;
        }
        take_line();
    }
    return At::row;
}

void PairReader::Stream::drop_row(bool is_paired) {
    if (!is_paired) {
        unpaired.add({1, waiting.front().number});
    }
    dispose_row();
    drop_line();
}

void PairReader::Stream::fail_row() {
    Waiting& row = waiting.front();
    const std::string_view text = row.line.text;
    row.error = std::make_unique<RowError>(
        RowError{.place = {row.number, side},
                 .what = RowError::What::no_partner,
                 .text = options->width == 0 ? std::string(text) : reader.selected_text(text)});
    dispose_row();
}

void PairReader::Stream::dispose_row() {
    --rows_waiting;
    if (by_key) {
        disposed = keys.front();
        keys.pop_front();
    }
}

void PairReader::Stream::drop_line() {
    bytes_waiting -= waiting.front().line.text.size();
    if (waiting.front().ends_text) {
        texts.pop_front();
        held -= std::min<std::size_t>(held, 1);
    }
    waiting.pop_front();
}

void PairReader::Stream::hold(std::size_t count, PairBlock& pairs) {
    for (; held < count; ++held) {
        pairs.texts.push_back(texts[held]);
    }
}

PairReader::PairReader(Source& source, Source& reference, const Options& options, std::size_t block_size)
    : pairing_(&*options.pairing), rows_(Side::stream, source, options, block_size),
      references_(Side::reference, reference, options, block_size) {}

bool PairReader::read(Job& job) {
    rows_.held = references_.held = 0;
    for (bool has_read = false; !error_;) {
        const At row = rows_.look(0);
        const At reference = references_.look(0);
        const bool rows_failed = row == At::end && rows_.blocks.error();
        const bool waits = !rows_.waiting.empty() && !references_.is_settled();
        if (!waits) {
            hand_on_alone(job, row != At::dry && !rows_failed);
            if (rows_failed ||
                (reference == At::end && row != At::dry && (row == At::end || references_.blocks.error()))) {
                return false;
            }
        }
        dry_ = waits                  ? &references_
               : row == At::dry       ? &rows_
               : reference == At::dry ? &references_
                                      : match(job, row, reference);
        const std::size_t rows = job.pairs.rows.size();
        const bool holds_much = rows >= enough_rows || (rows > 0 && job.pairs.texts.size() >= most_texts);
        if (rows >= most_rows || (dry_ != nullptr && holds_much)) {
            return true;
        }
        if (dry_ != nullptr) {
            if ((has_read || rows > 0) && !dry_->blocks.is_ready()) {
                return true;
            }
            dry_->take_block(dry_ == &rows_ ? job : reference_job_);
            has_read = true;
        }
    }
    return false;
}

void PairReader::hand_on_alone(Job& job, bool of_both) {
    PairBlock& pairs = job.pairs;
    for (Stream* stream : {&rows_, &references_}) {
        const bool is_own = stream == &rows_;
        if (!is_own && !of_both) {
            return;
        }
        while (!stream->waiting.empty() && !stream->waiting.front().may_be_paired()) {
            Waiting& first = stream->waiting.front();
            if (is_own || first.error) {
                Row& row = pairs.rows.emplace_back(is_own ? Row(first.line, first.number) : Row());
                row.passes = first.passes;
                row.error = first.error.get();
                pairs.errors.push_back(std::move(first.error));
                stream->hold(1, pairs);
            }
            pairs.bytes += first.line.text.size() + 1;
            stream->drop_line();
        }
    }
}

void PairReader::pair(Job& job, bool is_between) {
    const Waiting& first = rows_.waiting.front();
    const Waiting& other = references_.waiting.front();
    if (pairing_->looks_for_key && !pairing_->by_key && rows_.options->width == 0 && references_.options->width == 0) {
        if (!any_pair_) {
            likely_key_.emplace(std::array{rows_.layout(), references_.layout()});
        }
        likely_key_->add({first.line.text, other.line.text});
    }
    any_pair_ = true;
    Row& row = job.pairs.rows.emplace_back(first.line, first.number);
    row.partner = row.later = {other.line.text, other.number};
    if (is_between) {
        const Waiting& later = *std::find_if(references_.waiting.begin() + 1, references_.waiting.end(),
                                             [](const Waiting& each) { return each.may_be_paired(); });
        row.later = {later.line.text, later.number};
        row.fraction =
            ratio(distance(rows_.keys[0], references_.keys[0]), distance(references_.keys[1], references_.keys[0]));
    }
    job.pairs.bytes += row.line.text.size() + row.partner.text.size() + row.later.text.size();
    rows_.hold(1, job.pairs);
    references_.hold(is_between ? references_.texts.size() : 1, job.pairs);
    rows_.drop_row(true);
    if (!pairing_->interpolates) {
        references_.drop_row(true);
    }
}

void PairReader::drop_alone(Stream& stream) {
    if (&stream == &rows_ && pairing_->by_key && !pairing_->interpolates) {
        if (!references_.keys.empty()) {
            compare_distance(distance(references_.keys[0], rows_.keys[0]));
        }
        if (references_.disposed) {
            compare_distance(distance(rows_.keys[0], *references_.disposed));
        }
    }
    if (&stream == &rows_ && pairing_->needs_partner) {
        stream.fail_row();
    } else {
        stream.drop_row(false);
    }
}

void PairReader::compare_distance(KeyDistance found) { nearest_ = std::min(nearest_.value_or(found), found); }

PairReader::Stream* PairReader::match(Job& job, At row, At reference) {
    const bool interpolates = pairing_->interpolates;
    if (row == At::end || reference == At::end) {
        if (row == At::end) {
            references_.drop_row(interpolates);
        } else {
            drop_alone(rows_);
        }
        return nullptr;
    }
    if (!pairing_->by_key || rows_.keys[0] == references_.keys[0]) {
        pair(job);
        return nullptr;
    }
    const bool is_before = rows_.keys[0] < references_.keys[0];
    Stream& low = is_before ? rows_ : references_;
    const Stream& high = is_before ? references_ : rows_;
    const KeyDistance apart = distance(low.keys[0], high.keys[0]);
    const bool has_other = high.disposed && distance(low.keys[0], *high.disposed) <= apart; // that is no farther away
    if (interpolates ? is_before : apart > pairing_->within || has_other) {
        drop_alone(low);
        return nullptr;
    }
    const At next = low.look(1);
    if (next == At::dry) {
        return &low;
    }
    if (next == At::too_far) {
        error_ = StreamError{.what = StreamError::What::far_key, .place = {low.waiting.front().number, low.side}};
    } else if (interpolates) {
        match_between(job, next);
    } else if (next == At::row && distance(low.keys[1], high.keys[0]) < apart) {
        drop_alone(low); // the next row is nearer
    } else {
        pair(job);
    }
    return nullptr;
}

void PairReader::match_between(Job& job, At next) {
    if (next == At::end) {
        error_ = reference_error(); // the next row may exist, and was not read
        if (!error_) {
            drop_alone(rows_);
        }
    } else if (references_.keys[1] <= rows_.keys[0]) {
        references_.drop_row(true);
    } else if (const auto apart = distance(references_.keys[1], references_.keys[0]); apart <= pairing_->within) {
        pair(job, true);
    } else {
        compare_distance(apart);
        drop_alone(rows_);
    }
}

KeysMet PairReader::keys() const {
    return {.ranges = {rows_.range, references_.range},
            .any_pair = any_pair_,
            .interpolates = pairing_->interpolates,
            .nearest = nearest_,
            .likely = likely_key_ ? likely_key_->found() : std::nullopt,
            .within = pairing_->within};
}

std::optional<StreamError> PairReader::error() const {
    if (error_) {
        return error_;
    }
    const bool is_done = rows_.ended && rows_.unread.empty() && rows_.rows_waiting == 0;
    const auto own = is_done ? rows_.blocks.error() : std::nullopt; // otherwise it lies after the paired rows
    return own ? own : reference_error();
}

std::optional<StreamError> PairReader::reference_error() const {
    auto found = references_.blocks.error();
    if (found) {
        found->place.side = Side::reference;
    }
    return found;
}

} // namespace rotconv::stream
