#include "run.hpp"

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "bytes/io_block.hpp"
#include "job.hpp"
#include "pairs/pair_reader.hpp"
#include "rows/row_blocks.hpp"
#include "rows/row_transformer.hpp"

namespace rotconv::stream {
namespace {

/// One reader could not feed more threads.
constexpr std::size_t most_threads = 16;
/// Blocks under way beside one for each thread, so that nobody has to wait for a slow one.
constexpr std::size_t spare_jobs = 2;
/// Bytes of all blocks of text under way; their output can be many times as long.
constexpr std::size_t most_under_way = 2 * IoBlockReader::largest_block;
/// Bytes under way from which on no block is added: lines are longer than blocks.
constexpr std::size_t too_long = 32 * IoBlockReader::largest_block;

std::size_t thread_limit(const Options& options) {
    return options.operation->in_order ? 1 : std::clamp<std::size_t>(options.threads, 1, most_threads);
}

/// Bytes of a block: the more threads, the fewer, except for doubles that remain doubles.
std::size_t block_size(const Options& options) {
    if (options.input.width > 0 && options.format == Format::f64) {
        return IoBlockReader::largest_block;
    }
    return std::min(IoBlockReader::largest_block, most_under_way / (thread_limit(options) + spare_jobs));
}

/// A run by threads that are all alike: each writes the oldest block if that is converted, otherwise it reads a block
/// and converts it. One thread reads at a time, and one writes, so that blocks leave in the order in which they came.
/// No thread waits for input while blocks are under way: a block that ends the run ends it at once.
class Run {
public:
    Run(JobReader& reader, Sink* sink, const Options& options, const std::function<void(const Event&)>& report)
        : reader_(&reader), sink_(sink), options_(&options), report_(&report), large_(block_size(options) / 2),
          most_(thread_limit(options)) {}

    RunResult operator()() {
        Transformer transformer;
        work(transformer, true);
        std::ranges::for_each(helpers_, &std::thread::join);
        if (exception_) {
            std::rethrow_exception(exception_);
        }
        if (!over_) {
            Output output;
            if (transformer) {
                transformer->finish(output);
            }
            reader_->finish(output, !reader_->error());
            if (!reader_->error()) {
                tell_notes(output, true);
            }
            if (hand_on(output)) {
                ending_.error = reader_->error();
            }
        }
        return ending_;
    }

private:
    using Lock = std::unique_lock<std::mutex>;
    using Transformer = std::optional<RowTransformer>; ///< nothing before a thread's first data row

    /// The work of each thread, until the end of the stream or of the run; an exception ends the run.
    void work(Transformer& transformer, bool is_first) try {
        Lock lock(mutex_);
        while (!over_ && !(all_read_ && jobs_.empty())) {
            if (can_write()) {
                write_oldest(lock);
            } else if (can_read()) {
                read_and_convert(lock, transformer, is_first);
            } else {
                changed_.wait(lock);
            }
        }
        changed_.notify_all();
    } catch (...) {
        const Lock lock(mutex_);
        exception_ = std::current_exception();
        over_ = true;
        changed_.notify_all();
        order_changed_.notify_all();
    }

    void add_thread() {
        if (helpers_.size() + 1 < most_) {
            try {
                helpers_.emplace_back([this] {
                    Transformer transformer;
                    work(transformer, false);
                });
            } catch (const std::system_error&) { // the system gives no more
                most_ = helpers_.size() + 1;
            }
        }
    }

    [[nodiscard]] bool can_write() const { return !writing_ && !jobs_.empty() && jobs_.front()->done; }
    [[nodiscard]] bool can_read() const {
        return !reading_ && !all_read_ && jobs_.size() < most_ + spare_jobs && under_way_ < too_long &&
               (jobs_.empty() || reader_->is_ready());
    }

    void write_oldest(Lock& lock) {
        writing_ = true;
        const Job& job = *jobs_.front();
        lock.unlock();
        const bool goes_on = hand_on(job.output);
        lock.lock();
        writing_ = false;
        over_ = over_ || !goes_on;
        if (over_) {
            order_changed_.notify_all();
        }
        under_way_ -= job.size();
        idle_.push_back(std::move(jobs_.front()));
        jobs_.pop_front();
        changed_.notify_one();
    }

    void read_and_convert(Lock& lock, Transformer& transformer, bool is_first) {
        reading_ = true;
        auto made = idle_job();
        Job& job = *made;
        lock.unlock();
        const bool goes_on = reader_->read(job);
        job.width = reader_->width();
        tell_notes(job.output, false);
        lock.lock();
        all_read_ = !goes_on;
        job.ran_in_order = !job.has_rows();
        jobs_.push_back(std::move(made));
        under_way_ += job.size();
        const bool shared = job.size() >= large_;
        if (shared) {
            reading_ = false;
            if (is_first) {
                add_thread();
            }
            changed_.notify_one();
        }
        lock.unlock();
        if (job.has_rows()) {
            convert(job, transformer);
        }
        lock.lock();
        job.done = true;
        if (!shared) {
            reading_ = false; // kept until now: a small block was not worth waking another thread to read on
        }
    }

    void convert(Job& job, Transformer& transformer) {
        if (!transformer) {
            transformer.emplace(*options_, *reader_->layout(Side::stream), reader_->layout(Side::reference));
        }
        transformer->expect(job.width);
        const auto ordered = [this, &job](const std::function<void()>& what) { return run_in_order(job, what); };
        if (job.pairs.read.rows.empty()) {
            transformer->transform(job.block.text, job.block.first_line, job.output, ordered);
        } else {
            transformer->transform(job.pairs.read, job.output, ordered);
        }
    }

    /// See Ordered. Jobs are read in their order and converted by the threads that have read them, so that the first
    /// job never waits for another.
    bool run_in_order(Job& job, const std::function<void()>& what) {
        Lock lock(mutex_);
        order_changed_.wait(lock, [this, &job] {
            const auto first = std::ranges::find(jobs_, false, [](const auto& each) { return each->ran_in_order; });
            return over_ || (first != jobs_.end() && first->get() == &job);
        });
        if (over_) {
            return false;
        }
        lock.unlock();
        what();
        lock.lock();
        job.ran_in_order = true;
        order_changed_.notify_all();
        return true;
    }

    [[nodiscard]] std::unique_ptr<Job> idle_job() {
        if (idle_.empty()) {
            return std::make_unique<Job>();
        }
        auto job = std::move(idle_.back());
        idle_.pop_back();
        job->pairs.clear();
        job->output.clear();
        job->done = false;
        return job;
    }

    /// Adds the notes on each stream once, when the stream has a row or is at its end.
    void tell_notes(Output& output, bool at_end) {
        for (const Side side : both_sides) {
            const Layout* const layout = reader_->layout(side);
            bool& told = told_.at(index_of(side));
            if (layout == nullptr || told || (layout->field_count == 0 && !at_end)) {
                continue;
            }
            told = true;
            for (Note note : layout->notes) {
                note.place.side = side;
                output.events.emplace_back(std::move(note));
            }
        }
    }

    /// Writes the bytes, adds the rows to the fold, and then reports the events. @return false if the run is over
    bool hand_on(const Output& output) {
        const std::string_view bytes(output.bytes.data(), output.bytes.size());
        if (const int error = bytes.empty() ? 0 : sink_->write(bytes); error != 0) {
            ending_.reader_left = error == EPIPE;
            if (!ending_.reader_left) {
                ending_.error = StreamError{.what = StreamError::What::write, .error_number = error};
            }
            return false;
        }
        for (const AnsweredRows& batch : output.batches) {
            options_->fold->add(batch);
        }
        std::ranges::for_each(output.events, *report_);
        ending_.rows += output.rows;
        ending_.answered += output.answered;
        for (const Side side : both_sides) {
            ending_.unpaired.at(index_of(side)).add(output.unpaired.at(index_of(side)));
        }
        ending_.stopped = output.stopped;
        return !output.stopped;
    }

    JobReader* reader_; ///< used by the thread that reads
    Sink* sink_;
    const Options* options_;
    const std::function<void(const Event&)>* report_;
    std::size_t large_;          ///< bytes of a block that is worth another thread
    RunResult ending_;           ///< used by the thread that writes
    std::array<bool, 2> told_{}; ///< notes by Side; used by the thread that reads

    std::mutex mutex_; ///< for all members that follow
    std::condition_variable changed_;
    std::condition_variable order_changed_;
    std::deque<std::unique_ptr<Job>> jobs_; ///< under way, in the order of the stream
    std::size_t under_way_ = 0;             ///< bytes of the jobs' lines
    std::vector<std::unique_ptr<Job>> idle_;
    std::vector<std::thread> helpers_; ///< all threads except the first
    std::size_t most_;                 ///< threads, with the first
    bool reading_ = false;
    bool writing_ = false;
    bool all_read_ = false;
    bool over_ = false; ///< nothing more is to be written
    std::exception_ptr exception_;
};

} // namespace

RunResult run(Source& source, Sink* sink, Options options, const std::function<void(const Event&)>& report,
              Source* reference) {
    options.writes_rows = options.writes_rows && sink != nullptr;
    std::unique_ptr<JobReader> reader;
    if (reference != nullptr) {
        reader = std::make_unique<PairReader>(source, *reference, options, block_size(options));
    } else {
        reader = std::make_unique<RowBlocks>(source, options.input, &options, block_size(options));
    }
    RunResult result = Run(*reader, sink, options, report)();
    result.keys = reader->keys();
    result.positions = reader->layout(Side::stream)->positions;
    return result;
}

} // namespace rotconv::stream
