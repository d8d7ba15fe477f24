#pragma once
// Requests to end the program: Ctrl+C in the terminal, logout, shutdown. Signals are the numbers of
// <csignal>.

#include <functional>
#include <memory>
#include <string>
#include <thread>

namespace glibra::system {

/// While an object exists, Ctrl+C and the like (SIGINT, SIGTERM and SIGHUP) are only remembered, except those
/// that the process was started to ignore (nohup), so that a run can end with whole files. Only one object
/// may exist at a time.
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
    struct State;
    std::unique_ptr<State> before_;
};

/// While the object lives, the same signals do not end the program but are reported. The second one ends it,
/// in case that it does not come to that. There is one object at a time.
class EndingSignals {
  public:
    /// `wake` is called on another thread when a signal comes.
    explicit EndingSignals(std::function<void()> wake);
    EndingSignals(const EndingSignals&) = delete;
    EndingSignals& operator=(const EndingSignals&) = delete;
    ~EndingSignals();

    /// The signal that has come; 0: none.
    [[nodiscard]] static int received();
    /// After the object: as Interruption::obey().
    static void obey();

  private:
    struct State;
    std::function<void()> wake_;
    std::unique_ptr<State> state_;
    std::thread thread_;
};

/// Why a signal ended a process: "segmentation fault"; "see signal(7)" or the like for rare ones.
const char* signalReason(int signal);
/// The system's own words for it.
std::string signalText(int signal);

}  // namespace glibra::system
