#pragma once
// The progress of a run of many shots: a bar that is rewritten on a terminal, or a plain line from time to
// time in a log.

#include <chrono>
#include <cstddef>
#include <string>

namespace glibra::cli {

class SuiteProgress {
  public:
    /// `terminal` says whether standard error is a terminal.
    SuiteProgress(std::size_t total, bool terminal);

    /// Counts a shot that is done.
    void add(bool failed);
    /// Shows the name of the shot that is being drawn.
    void begins(const std::string& name);
    /// Prints a line, or several, above the bar. The text is safe for a terminal: see commands.h.
    void print(const std::string& line);
    /// Removes the bar.
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

/// Returns "0:07", "12:30" or "1:02:03"; seconds are rounded up.
std::string readableTime(double seconds);

// What a report says about the run that it comes from.

/// The command line of this process, or empty if the system does not provide it.
std::string commandLine();

/// "2026-01-31T12:00:00Z"
std::string utcNow();

}  // namespace glibra::cli
