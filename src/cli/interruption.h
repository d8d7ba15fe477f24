#pragma once
// Ctrl-C and its like, noted instead of obeyed, so that a run can end with whole files.

#include <signal.h>

#include <array>

namespace glibra::cli {

/// While it lives, SIGINT, SIGTERM and SIGHUP are only noted, except those that the process was started to
/// ignore (nohup). One at a time.
class Interruption {
  public:
    Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;
    ~Interruption();

    /// The signal that came, or 0.
    [[nodiscard]] int signal() const;
    /// Ends the process by the signal that came, so that a shell sees what it expects; else nothing.
    void obey() const;

  private:
    static constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, 3> before_{};
};

}  // namespace glibra::cli
