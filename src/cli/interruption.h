#pragma once
// Remembers Ctrl-C and similar signals, so that a run can end with whole files.

#include <signal.h>

#include <array>

namespace glibra::cli {

/// While an object exists, SIGINT, SIGTERM and SIGHUP are only remembered, except those that the process was
/// started to ignore (nohup). Only one object may exist at a time.
class Interruption {
  public:
    Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;
    ~Interruption();

    /// The signal that arrived, or 0.
    [[nodiscard]] int signal() const;
    /// Ends the process by the signal that arrived, so that a shell sees the usual status. Does nothing
    /// without a signal.
    void obey() const;

  private:
    static constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, 3> before_{};
};

}  // namespace glibra::cli
