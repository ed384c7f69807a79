#include "pair_reader.hpp"

#include <algorithm>
#include <utility>

namespace rotconv::stream {
namespace {

/// The smallest number of rows that is worth handing on as a job, and the largest.
constexpr std::size_t enough_rows = 256;
constexpr std::size_t most_pairs = 2048;
/// The largest number of texts that a job with few rows may hold: the rows between them may have been left out.
constexpr std::size_t most_texts = 8;
/// The largest numbers of lines and of bytes between a row and the next row whose key must be known.
constexpr std::size_t most_lines_ahead = 4096;
constexpr std::size_t most_bytes_ahead = std::size_t{1} << 20U;

} // namespace

void PairReader::Stream::take_block(Job& job) {
    ended = !blocks.read(job);
    reader.expect(blocks.width());
    auto& [bytes, block_text, first_line] = job.block;
    if (const std::size_t size = block_text.size(); size > 0) {
        auto text = std::make_shared<Buffer>();
        if (2 * size < bytes.capacity()) { // it may wait, and should not hold much memory that is empty
            append(*text, block_text);
        } else {
            bytes.resize(static_cast<std::size_t>(block_text.data() - bytes.data()) + size);
            *text = std::move(bytes);
        }
        unread = {text->data() + text->size() - size, size};
        texts.push_back(std::move(text));
        line = first_line;
    }
    block_text = {};
}

void PairReader::Stream::take_line() {
    Waiting& next = waiting.emplace_back();
    next.number = line++;
    taken.numbers.clear();
    taken.kept.clear();
    taken.fields.clear();
    Row row;
    const bool is_read = reader.take(unread, row, taken);
    next.line = row.line;
    next.passes = row.passes;
    next.ends_text = unread.empty();
    bytes_waiting += next.line.text.size();
    if (next.passes) {
        return;
    }
    next.may_be_paired = !by_key || (!taken.kept.empty() && take_key(next));
    if (next.may_be_paired) {
        pairable.push_back(&next);
    }
    if (is_read) {
        std::ranges::copy(taken.numbers, next.numbers.begin());
    }
    if (!is_read || !next.may_be_paired) {
        taken.error.place = {next.number, side};
        next.error = std::make_unique<RowError>(std::exchange(taken.error, {}));
    }
}

bool PairReader::Stream::take_key(Waiting& row) {
    row.kept = taken.kept[0];
    if (options->width > 0) {
        row.kept.key = reader.key_of(number_text(row.kept.number));
    }
    const auto& [key, error] = row.kept.key;
    if (error == KeyError::none && (!range || key > range->last)) {
        range = {range ? range->first : key, key};
        return true;
    }
    taken.error = {.what = error == KeyError::none           ? RowError::What::key_order
                           : error == KeyError::not_a_number ? RowError::What::not_a_number
                                                             : RowError::What::key,
                   .text = options->width > 0 ? number_text(row.kept.number) : std::string(row.kept.text),
                   .key = error};
    return false;
}

PairReader::At PairReader::Stream::look(std::size_t ahead) {
    while (pairable.size() <= ahead) {
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

void PairReader::Stream::drop_row() {
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
    row.may_be_paired = false;
    dispose_row();
}

void PairReader::Stream::dispose_row() {
    if (by_key) {
        disposed = pairable.front()->key();
    }
    pairable.pop_front();
}

void PairReader::Stream::drop_line() {
    bytes_waiting -= waiting.front().line.text.size();
    if (waiting.front().ends_text) {
        texts.pop_front();
        held -= std::min<std::size_t>(held, 1);
    }
    waiting.pop_front();
}

void PairReader::Stream::hold(PairBlock& pairs) {
    for (; held < texts.size(); ++held) {
        pairs.texts.push_back(texts[held]);
    }
}

PairReader::PairReader(Source& source, Source& reference, const Options& options, std::size_t block_size)
    : pairing_(&*options.pairing), writes_partners_(options.writes_partners()),
      rows_(Side::stream, source, options, block_size), references_(Side::reference, reference, options, block_size) {}

bool PairReader::read(Job& job) {
    rows_.held = references_.held = 0;
    for (Waiting& row : references_.waiting) {
        row.place = Waiting::nowhere;
    }
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
                                      : act(job, match(row, reference));
        const std::size_t rows = job.pairs.read.rows.size();
        const bool holds_much = rows >= enough_rows || (rows > 0 && job.pairs.texts.size() >= most_texts);
        if (rows >= most_pairs || (dry_ != nullptr && holds_much)) {
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
        while (!stream->waiting.empty() && !stream->waiting.front().may_be_paired) {
            Waiting& first = stream->waiting.front();
            if (is_own || first.error) {
                pairs.read.rows.push_back(is_own ? Row(first.line, first.number) : Row());
                pairs.read.pairs.emplace_back();
                pairs.read.rows.back().passes = first.passes;
                if (first.error) {
                    pairs.read.fail(std::move(*first.error));
                }
                stream->hold(pairs);
            }
            pairs.bytes += first.line.text.size() + 1;
            stream->drop_line();
        }
    }
}

void PairReader::pair(Job& job, bool is_between) {
    const Waiting& own = *rows_.pairable.front();
    Waiting& other = *references_.pairable.front();
    Waiting& later = is_between ? *references_.pairable[1] : other;
    if (pairing_->looks_for_key && !pairing_->by_key && rows_.options->width == 0 && references_.options->width == 0) {
        if (!stats_.any_pair) {
            likely_key_.emplace(std::array{rows_.layout(), references_.layout()});
        }
        likely_key_->add({own.line.text, other.line.text});
    }
    stats_.any_pair = true;
    ReadRows& read = job.pairs.read;
    read.rows.emplace_back(own.line, own.number);
    Pair& pair = read.pairs.emplace_back(Pair{{other.line.text, other.number}, {later.line.text, later.number}, {}});
    if (writes_partners_) {
        pair.fields =
            fmt::format("{0}{1}{0}{2}{0}{3}{4}", rows_.layout()->delimiter.text(), other.number, other.kept.written(),
                        own.key() < other.key() ? "-" : "", distance(own.key(), other.key()).text());
    }
    const Waiting* const wrong = own.error ? &own : other.error ? &other : &later;
    if (wrong->error) {
        RowError error = *wrong->error;
        error.place = {own.number};
        error.cause = {wrong == &own ? 0 : wrong->number, Side::reference};
        read.fail(std::move(error));
    } else {
        add_numbers(read, later);
    }
    job.pairs.bytes += own.line.text.size() + other.line.text.size() + later.line.text.size();
    rows_.hold(job.pairs);
    references_.hold(job.pairs);
    rows_.drop_row();
    if (!pairing_->interpolates) {
        references_.drop_row();
    }
}

void PairReader::add_numbers(ReadRows& read, Waiting& later) {
    const Waiting& own = *rows_.pairable.front();
    Waiting& other = *references_.pairable.front();
    const auto add = [](Numbers& to, const Waiting& row, const Stream& stream) {
        const std::size_t count = stream.layout()->count - stream.options->numbers.kept;
        to.append(row.numbers.data(), row.numbers.data() + count);
        return to.size() / count - 1; // its place
    };
    const auto place_of = [&](Waiting& row) {
        row.place = row.place == Waiting::nowhere ? add(read.neighbours, row, references_) : row.place;
        return row.place;
    };
    read.rows.back().index = read.lines.size();
    read.lines.push_back(own.number);
    read.reference_lines.push_back(other.number);
    add(read.numbers, own, rows_);
    if (!pairing_->interpolates) {
        add(read.numbers, other, references_);
    } else {
        const std::size_t earlier = place_of(other);
        read.between.push_back(
            {earlier, place_of(later), distance(own.key(), other.key()), distance(later.key(), other.key())});
    }
    if (pairing_->by_key) {
        read.kept.insert(read.kept.end(), {own.kept, other.kept});
    }
}

void PairReader::drop_alone(Output& output) {
    if (pairing_->by_key && !pairing_->interpolates) {
        const Key& key = rows_.pairable.front()->key();
        if (!references_.pairable.empty()) {
            compare_distance(distance(references_.pairable.front()->key(), key));
        }
        if (references_.disposed) {
            compare_distance(distance(key, *references_.disposed));
        }
    }
    if (pairing_->needs_partner) {
        rows_.fail_row();
    } else {
        output.unpaired[0].add({1, rows_.waiting.front().number});
        ++output.rows;
        rows_.drop_row();
    }
}

void PairReader::compare_distance(KeyDistance found) {
    stats_.nearest = std::min(stats_.nearest.value_or(found), found);
}

PairReader::Match PairReader::match(At row, At reference) {
    if (row == At::end || reference == At::end) {
        return row == At::end ? Match::reference_alone : Match::row_alone;
    }
    if (!pairing_->by_key || rows_.pairable.front()->key() == references_.pairable.front()->key()) {
        return Match::pair;
    }
    return pairing_->interpolates ? match_between() : match_nearest();
}

PairReader::At PairReader::look_ahead(Stream& stream) {
    const At next = stream.look(1);
    if (next == At::too_far) {
        error_ = StreamError{.what = StreamError::What::far_key, .place = {stream.waiting.front().number, stream.side}};
    }
    return next;
}

PairReader::Match PairReader::match_nearest() {
    const bool is_before = rows_.pairable.front()->key() < references_.pairable.front()->key();
    Stream& low = is_before ? rows_ : references_;
    const Stream& high = is_before ? references_ : rows_;
    const Match low_alone = is_before ? Match::row_alone : Match::reference_alone;
    const KeyDistance apart = distance(low.pairable.front()->key(), high.pairable.front()->key());
    const bool has_other =
        high.disposed && distance(low.pairable.front()->key(), *high.disposed) <= apart; // no farther away
    if (apart > pairing_->within || has_other) {
        return low_alone;
    }
    switch (look_ahead(low)) {
    case At::dry: return is_before ? Match::row_unknown : Match::reference_unknown;
    case At::too_far: return Match::ended;
    case At::row:
        return distance(low.pairable[1]->key(), high.pairable.front()->key()) < apart ? low_alone : Match::pair;
    case At::end: break;
    }
    return Match::pair;
}

PairReader::Match PairReader::match_between() {
    const Key& key = rows_.pairable.front()->key();
    if (key < references_.pairable.front()->key()) {
        return Match::row_alone;
    }
    switch (look_ahead(references_)) {
    case At::dry: return Match::reference_unknown;
    case At::too_far: return Match::ended;
    case At::end: error_ = reference_error(); return error_ ? Match::ended : Match::row_alone; // it was not read
    case At::row: break;
    }
    if (references_.pairable[1]->key() <= key) {
        return Match::reference_alone;
    }
    const KeyDistance apart = distance(references_.pairable[1]->key(), references_.pairable.front()->key());
    if (apart > pairing_->within) {
        compare_distance(apart);
        return Match::row_alone;
    }
    return Match::pair_between;
}

PairReader::Stream* PairReader::act(Job& job, Match match) {
    switch (match) {
    case Match::pair: pair(job, false); break;
    case Match::pair_between: pair(job, true); break;
    case Match::row_alone: drop_alone(job.output); break;
    case Match::reference_alone:
        if (!pairing_->interpolates) {
            job.output.unpaired[1].add({1, references_.waiting.front().number});
        }
        references_.drop_row();
        break;
    case Match::row_unknown: return &rows_;
    case Match::reference_unknown: return &references_;
    case Match::ended: break;
    }
    return nullptr;
}

PairingStats PairReader::keys() const {
    PairingStats stats = stats_;
    stats.ranges = {rows_.range, references_.range};
    stats.likely = likely_key_ ? likely_key_->found() : std::nullopt;
    return stats;
}

std::optional<StreamError> PairReader::error() const {
    if (error_) {
        return error_;
    }
    const bool is_done = rows_.ended && rows_.unread.empty() && rows_.pairable.empty();
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
