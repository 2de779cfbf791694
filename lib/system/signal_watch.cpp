// SPDX-License-Identifier: MIT
// l3d_signal_watch: the handler, and what it may touch.
#include "system/signal_watch.h"

#include <cassert>
#include <cerrno>
#include <cstddef>

#include <fcntl.h>
#include <unistd.h>

namespace {

/// Keys, a request to end, and a terminal that is closed.
constexpr std::array watched{SIGINT, SIGQUIT, SIGTERM, SIGHUP};

/// The signal noted, or 0, and the end of a pipe that takes the news to a sleeper. A handler can
/// reach nothing but such variables.
volatile std::sig_atomic_t noted = 0;
volatile std::sig_atomic_t bell = -1;

extern "C" void note_signal(int signal) {
    const int error = errno;
    noted = signal;
    // A pipe that is full has been heard of.
    static_cast<void>(!write(bell, "!", 1));
    errno = error;
}

} // namespace

l3d_signal_watch::l3d_signal_watch() {
    assert(noted == 0);
    // Between a look at caught() and the sleep a signal would else go unheard.
    std::array<int, 2> ends{-1, -1};
    if (pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) == 0) {
        waker_ = ends[0];
        bell = ends[1];
    }
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
    if (waker_ >= 0) {
        close(waker_);
        close(bell);
        bell = -1;
    }
    if (signal != 0)
        raise(signal);
}

bool l3d_signal_watch::caught() const {
    return noted != 0;
}
