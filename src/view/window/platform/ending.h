#pragma once
// Requests of the system to end the program: Ctrl+C in the terminal, logout, shutdown.

#include <functional>
#include <thread>

namespace glibra::view {

/// While the object lives, SIGINT, SIGTERM and SIGHUP do not end the program but are reported. The second one
/// ends it, in case that it does not come to that. There is one object at a time.
class EndingSignals {
  public:
    /// `wake` is called on another thread when a signal comes.
    explicit EndingSignals(std::function<void()> wake);
    EndingSignals(const EndingSignals&) = delete;
    EndingSignals& operator=(const EndingSignals&) = delete;
    ~EndingSignals();

    /// The signal that has come; 0: none.
    [[nodiscard]] static int received();

  private:
    std::function<void()> wake_;
    std::thread thread_;
};

}  // namespace glibra::view
