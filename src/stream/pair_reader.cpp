#include "pair_reader.hpp"

#include <compare>
#include <cstring>
#include <utility>

#include "fmt.hpp"

namespace rotconv::stream {
namespace {

/// Rows of a job that is worth handing on, and the most.
constexpr std::size_t enough_rows = 256;
constexpr std::size_t most_rows = 2048;
/// Texts that a job with few rows may hold: the rows between them may have been left out.
constexpr std::size_t most_texts = 8;
/// Lines, and bytes of them, past which the row ahead is not looked for.
constexpr std::size_t most_lines_ahead = 4096;
constexpr std::size_t most_bytes_ahead = std::size_t{1} << 20U;

} // namespace

PairReader::Side::Side(Source& source, const InputOptions& given, const Options* written, bool with_keys,
                       std::size_t block_size)
    : options(&given), by_key(with_keys), blocks(source, given, written, block_size) {}

void PairReader::Side::read_block(Output& output) {
    for (; !texts.empty() && (waiting.empty() || texts_gone < waiting.front().text); ++texts_gone) {
        texts.pop_front();
    }
    const auto block = std::make_shared<IoBlock>();
    ended = !blocks.read(*block, rest, line, output);
    if (block->text.empty()) {
        return;
    }
    if (2 * block->text.size() < block->bytes.size()) { // it may wait with thousands of others
        const auto first = static_cast<std::size_t>(rest.data() - block->text.data());
        Buffer bytes;
        append(bytes, block->text);
        block->bytes = std::move(bytes);
        block->text = {block->bytes.data(), block->bytes.size()};
        rest = rest.empty() ? rest : block->text.substr(first);
    }
    texts.push_back(block);
}

void PairReader::Side::take_line() {
    Waiting next{.line = {}, .number = line++, .text = texts_gone + texts.size() - 1};
    if (options->width > 0) {
        const std::size_t size = options->width * sizeof(double);
        next.line.text = rest.substr(0, size);
        rest.remove_prefix(size);
    } else {
        next.line = next_line(rest);
        next.passed = is_blank(next.line.text) || is_comment(next.line.text);
    }
    if (!next.passed && by_key) {
        find_key(next);
    }
    rows_waiting += !next.passed && !next.error ? 1U : 0U;
    bytes_waiting += next.line.text.size();
    waiting.push_back(std::move(next));
}

void PairReader::Side::find_key(Waiting& row) {
    using What = RowError::What;
    const std::size_t position = blocks.layout().positions.front();
    std::string text;
    if (options->width > 0) {
        double number = 0.0;
        std::memcpy(&number, row.line.text.data() + position * sizeof(double), sizeof(double));
        text = fmt::format("{}", number);
    } else {
        fields.clear();
        if (!blocks.layout().delimiter.split(row.line.text, fields)) {
            row.error = RowError{.line = row.number, .what = What::open_quote, .text = std::string(row.line.text)};
            return;
        }
        if (position >= fields.size()) {
            row.error = RowError{.line = row.number,
                                 .what = What::missing_column,
                                 .text = std::string(row.line.text),
                                 .found = fields.size(),
                                 .expected = position + 1};
            return;
        }
        text = blocks.layout().delimiter.text_of(fields[position]);
    }
    auto key = Decimal::parse(text);
    if (!key) {
        row.error = RowError{.line = row.number, .what = What::not_a_number, .text = text};
    } else if (newest && *key <= *newest) {
        row.error = RowError{.line = row.number, .what = What::key_order, .text = text};
    } else {
        newest = row.key = *std::move(key);
    }
}

PairReader::At PairReader::Side::look(std::size_t ahead) {
    while (rows_waiting <= ahead) {
        if (ahead > 0 && (waiting.size() > most_lines_ahead || bytes_waiting > most_bytes_ahead)) {
            return At::end;
        }
        if (rest.empty()) {
            return ended ? At::end : At::dry;
        }
        take_line();
    }
    return At::row;
}

const Decimal& PairReader::Side::next_key() const {
    auto next = waiting.begin() + 1;
    while (next->passed || next->error) {
        ++next;
    }
    return next->key;
}

void PairReader::Side::drop_row(bool is_paired) {
    Waiting& first = waiting.front();
    if (!is_paired && unpaired.rows++ == 0) {
        unpaired.first_line = first.number;
    }
    disposed = std::move(first.key);
    drop_line();
    --rows_waiting;
}

void PairReader::Side::drop_line() {
    bytes_waiting -= waiting.front().line.text.size();
    waiting.pop_front();
}

PairReader::PairReader(Source& source, Source& reference, const Options& options, std::size_t block_size)
    : pairing_(&*options.pairing), rows_(source, options.input, &options, pairing_->by_key, block_size),
      references_(reference, pairing_->reference, nullptr, pairing_->by_key, block_size) {}

bool PairReader::read(Job& job) {
    keep_texts(job);
    for (bool has_read = false;;) {
        const At row = rows_.look(0);
        const At reference = references_.look(0);
        const bool rows_failed = row == At::end && rows_.error();
        hand_on_alone(job, row != At::dry && !rows_failed);
        if (rows_failed || (reference == At::end && row != At::dry && (row == At::end || references_.error()))) {
            return false;
        }
        Side* const dry = row == At::dry ? &rows_ : reference == At::dry ? &references_ : match(job, row, reference);
        const std::size_t rows = job.pairs.rows.size();
        dry_ = dry;
        const bool holds_much = rows >= enough_rows || (rows > 0 && job.pairs.texts.size() >= most_texts);
        if (rows >= most_rows || (dry != nullptr && holds_much)) {
            return true;
        }
        if (dry != nullptr) {
            if ((has_read || rows > 0) && !dry->blocks.is_ready()) {
                return true;
            }
            fill(*dry, job);
            has_read = true;
        }
    }
}

void PairReader::fill(Side& side, Job& job) {
    Output nowhere;
    side.read_block(&side == &rows_ ? job.output : nowhere);
    if (job.pairs.rows.empty()) {
        keep_texts(job);
    } else if (!side.texts.empty()) {
        job.pairs.texts.push_back(side.texts.back());
    }
}

void PairReader::keep_texts(Job& job) const {
    job.pairs.texts.clear();
    for (const Side* side : {&rows_, &references_}) {
        job.pairs.texts.insert(job.pairs.texts.end(), side->texts.begin(), side->texts.end());
    }
}

void PairReader::hand_on_alone(Job& job, bool of_both) {
    PairBlock& pairs = job.pairs;
    for (Side* side : {&rows_, &references_}) {
        if (side == &references_ && !of_both) {
            return;
        }
        auto& waiting = side->waiting;
        while (!waiting.empty() && (waiting.front().passed || waiting.front().error)) {
            Waiting& first = waiting.front();
            const bool of_reference = side == &references_;
            if (first.error) {
                first.error->of_reference = of_reference;
                pairs.rows.push_back({.row = of_reference ? Line{} : first.line,
                                      .number = of_reference ? 0 : first.number,
                                      .error = pairs.errors.size()});
                pairs.errors.push_back(*std::move(first.error));
            } else if (!of_reference) {
                pairs.rows.push_back({.row = first.line, .number = first.number, .passed = true});
            }
            pairs.bytes += first.line.text.size() + 1;
            side->drop_line();
        }
    }
}

void PairReader::pair(Job& job) {
    const Waiting& row = rows_.row();
    const Waiting& reference = references_.row();
    job.pairs.rows.push_back(
        {.row = row.line, .number = row.number, .reference = reference.line, .reference_number = reference.number});
    job.pairs.bytes += row.line.text.size() + reference.line.text.size();
    rows_.drop_row(true);
    references_.drop_row(true);
}

PairReader::Side* PairReader::match(Job& job, At row, At reference) {
    if (row == At::end || reference == At::end) {
        (row == At::end ? references_ : rows_).drop_row(false);
        return nullptr;
    }
    const auto order = rows_.row().key <=> references_.row().key;
    if (!pairing_->by_key || std::is_eq(order)) {
        pair(job);
        return nullptr;
    }
    Side& low = std::is_lt(order) ? rows_ : references_;
    Side& high = std::is_lt(order) ? references_ : rows_;
    const Decimal& low_key = low.row().key;
    const Decimal& high_key = high.row().key;
    const Decimal apart = high_key - low_key;
    if (apart > pairing_->within || (high.disposed && low_key - *high.disposed <= apart)) {
        low.drop_row(false);
        return nullptr;
    }
    const At next = low.look(1); // may be nearer to the high one
    if (next == At::dry) {
        return &low;
    }
    if (next == At::row && (low.next_key() <= high_key || low.next_key() - high_key < apart)) {
        low.drop_row(false);
    } else {
        pair(job);
    }
    return nullptr;
}

void PairReader::finish(Output& output) { rows_.blocks.finish(output, !error()); }

std::optional<StreamError> PairReader::error() const {
    auto found = rows_.is_done() ? rows_.error() : std::nullopt; // else it lies behind what was worked on
    if (!found) {
        found = references_.error();
        if (found) {
            found->of_reference = true;
        }
    }
    return found;
}

} // namespace rotconv::stream
