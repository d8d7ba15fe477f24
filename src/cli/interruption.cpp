#include "cli/interruption.h"

#include <csignal>

namespace glibra::cli {
namespace {

// A signal handler can only reach a global.
volatile std::sig_atomic_t noted = 0;

}  // namespace

Interruption::Interruption() {
    noted = 0;
    struct sigaction note{};
    note.sa_handler = [](int signal) { noted = signal; };
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        ::sigaction(kSignals[i], nullptr, &before_[i]);
        if (before_[i].sa_handler != SIG_IGN) ::sigaction(kSignals[i], &note, nullptr);
    }
}

Interruption::~Interruption() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &before_[i], nullptr);
}

int Interruption::signal() const {
    return noted;
}

void Interruption::obey() const {
    if (noted == 0) return;
    struct sigaction plain{};
    plain.sa_handler = SIG_DFL;
    ::sigaction(noted, &plain, nullptr);
    ::raise(noted);
}

}  // namespace glibra::cli
