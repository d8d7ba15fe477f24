#pragma once
// How far a run of many shots is: a bar that is rewritten on a terminal, plain lines now and then in a log.

#include <chrono>
#include <cstddef>
#include <string>

namespace glibra::cli {

class SuiteProgress {
  public:
    /// `terminal`: standard error is one.
    SuiteProgress(std::size_t total, bool terminal);

    /// A shot is done.
    void add(bool failed);
    /// What is being drawn.
    void begins(const std::string& name);
    /// A line for the reader, above the bar.
    void tell(const std::string& line);
    /// Takes the bar away.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;
    void show(bool now);
    [[nodiscard]] std::string figures(Clock::time_point now) const;

    std::size_t total_, done_ = 0, failed_ = 0;
    bool terminal_;
    std::string current_;
    Clock::time_point start_, shown_;
};

/// "0:07", "12:30", "1:02:03"; seconds are rounded up.
std::string readableTime(double seconds);

}  // namespace glibra::cli
