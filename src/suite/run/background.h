#pragma once
// Work beside the thread with the GL context.

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace glibra::suite {

/// Does jobs in order on a thread of its own.
class Background {
  public:
    Background() : thread_([this] { run(); }) {}
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;
    ~Background() { finish(); }

    /// Waits while there are too many jobs, or while those that wait hold too many bytes. Gives the job's
    /// number.
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
    /// Until that job is done.
    void wait(std::uint64_t number) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return done_ >= number; });
    }
    /// Until all that was added is done.
    void wait() { wait(added_); }
    void finish() {
        {
            const std::scoped_lock lock(mutex_);
            closed_ = true;
            changed_.notify_all();
        }
        if (thread_.joinable()) thread_.join();
    }

  private:
    struct Job {
        std::function<void()> work;
        std::size_t bytes = 0;
    };

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
            job.work();
            const std::scoped_lock lock(mutex_);
            ++done_;
            changed_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> waiting_;
    std::size_t bytes_ = 0;  ///< of the jobs that wait
    std::uint64_t added_ = 0, done_ = 0;
    bool closed_ = false;
    std::thread thread_;
};

}  // namespace glibra::suite
