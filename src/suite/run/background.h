#pragma once
// Work that runs beside the thread with the GL context.

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace glibra::suite {

/// Does jobs in order on a thread of its own. If a job throws, the jobs after it are done all the same, and
/// the next call of wait() or finish() throws the first exception.
class Background {
  public:
    Background() : thread_([this] { run(); }) {}
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;
    ~Background() { join(); }

    /// Adds a job and returns its number. Blocks while too many jobs wait, or while they hold too many bytes;
    /// `bytes` is what this one holds.
    std::uint64_t add(std::function<void()> job, std::size_t bytes = 0) {
        constexpr std::size_t kMostJobs = 16, kMostBytes = std::size_t{64} << 20U;
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] {
            return waiting_.empty() || (waiting_.size() < kMostJobs && bytes_ + bytes <= kMostBytes);
        });
        waiting_.push_back({std::move(job), bytes});
        bytes_ += bytes;
        changed_.notify_all();
        return ++added_;
    }
    /// Blocks until that job is done.
    void wait(std::uint64_t number) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return done_ >= number; });
        rethrow();
    }
    /// Blocks until all jobs are done.
    void wait() { wait(added_); }
    /// Does what is left and ends the thread. No job can be added afterwards.
    void finish() {
        join();
        rethrow();
    }

  private:
    struct Job {
        std::function<void()> work;
        std::size_t bytes = 0;
    };

    void join() {
        {
            const std::scoped_lock lock(mutex_);
            closed_ = true;
            changed_.notify_all();
        }
        if (thread_.joinable()) thread_.join();
    }

    void rethrow() {
        if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    }

    void run() {
        while (true) {
            Job job;
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [this] { return !waiting_.empty() || closed_; });
                if (waiting_.empty()) return;
                job = std::move(waiting_.front());
                waiting_.pop_front();
                bytes_ -= job.bytes;
                changed_.notify_all();
            }
            std::exception_ptr failure;
            try {
                job.work();
            } catch (...) {
                failure = std::current_exception();
            }
            const std::scoped_lock lock(mutex_);
            if (!failure_) failure_ = failure;
            ++done_;
            changed_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> waiting_;
    std::size_t bytes_ = 0;  ///< held by the jobs that wait
    std::uint64_t added_ = 0, done_ = 0;
    std::exception_ptr failure_;  ///< the first that no caller has received yet
    bool closed_ = false;
    std::thread thread_;
};

}  // namespace glibra::suite
