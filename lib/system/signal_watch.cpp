// SPDX-License-Identifier: MIT
// l3d_signal_watch: the handler, and what it may touch.
#include "system/signal_watch.h"

#include <cassert>
#include <cstddef>

namespace {

constexpr std::array<int, 2> watched{SIGINT, SIGTERM};

/// The signal noted, or 0. A handler can reach nothing but such a variable.
volatile std::sig_atomic_t noted = 0;

extern "C" void note_signal(int signal) {
    noted = signal;
}

} // namespace

l3d_signal_watch::l3d_signal_watch() {
    assert(noted == 0);
    struct sigaction action {};
    action.sa_handler = note_signal;
    // No SA_RESTART: a signal has to end the wait for events.
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < watched.size(); ++i) {
        sigaction(watched[i], nullptr, &before_[i]);
        if (before_[i].sa_handler != SIG_IGN)
            sigaction(watched[i], &action, nullptr);
    }
}

l3d_signal_watch::~l3d_signal_watch() {
    for (std::size_t i = 0; i < watched.size(); ++i)
        sigaction(watched[i], &before_[i], nullptr);
    const int signal = noted;
    noted = 0;
    if (signal != 0)
        raise(signal);
}

bool l3d_signal_watch::caught() const {
    return noted != 0;
}
