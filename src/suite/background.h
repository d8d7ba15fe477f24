#pragma once
// Work beside the thread with the GL context.

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace glibra::suite {

/// Does jobs in order on a thread of its own. At most two wait, so that pictures in memory stay few.
class Background {
  public:
    Background() : thread_([this] { run(); }) {}
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;
    ~Background() { finish(); }

    void add(std::function<void()> job) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return waiting_.size() < 2; });
        waiting_.push_back(std::move(job));
        changed_.notify_all();
    }
    /// Until all that was added is done.
    void wait() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return waiting_.empty() && !isAtWork_; });
    }
    void finish() {
        {
            const std::scoped_lock lock(mutex_);
            closed_ = true;
            changed_.notify_all();
        }
        if (thread_.joinable()) thread_.join();
    }

  private:
    void run() {
        while (true) {
            std::function<void()> job;
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [this] { return !waiting_.empty() || closed_; });
                if (waiting_.empty()) return;
                job = std::move(waiting_.front());
                waiting_.pop_front();
                isAtWork_ = true;
                changed_.notify_all();
            }
            job();
            const std::scoped_lock lock(mutex_);
            isAtWork_ = false;
            changed_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::function<void()>> waiting_;
    bool isAtWork_ = false;
    bool closed_ = false;
    std::thread thread_;
};

}  // namespace glibra::suite
