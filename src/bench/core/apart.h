#pragma once
// Runs work in a process in which no graphics driver has been loaded yet. Drivers read their settings from
// the environment once, so comparing two settings takes two processes.

#include <optional>
#include <string>

namespace glibra::bench {

class Apart {
  public:
    /// Forks a process that waits for requests. If this process has more than one thread or has already
    /// loaded a driver, nothing is forked and run() never gives an answer: in the fork, a driver's locks
    /// would stay locked forever.
    Apart();
    Apart(const Apart&) = delete;
    Apart& operator=(const Apart&) = delete;
    ~Apart();

    using Work = std::string (*)(const std::string& request);
    /// The answer of `work` to the request; each request gets a new process. Empty if that process crashed or
    /// could not be started.
    std::optional<std::string> run(Work work, const std::string& request);
    /// Why the last run() gave no answer: "ended by signal 11 (Segmentation fault)", "ended with status 1";
    /// empty if it gave one or if there is no process.
    [[nodiscard]] const std::string& failure() const { return failure_; }
    /// False if run() never gives an answer.
    [[nodiscard]] bool isThere() const { return process_ > 0; }

  private:
    int requests_ = -1, answers_ = -1;  ///< ends of two pipes; -1: there is no process
    int process_ = -1;
    std::string failure_;
};

}  // namespace glibra::bench
