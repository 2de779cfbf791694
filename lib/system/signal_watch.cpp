// SPDX-License-Identifier: MIT
// l3d_signal_watch: handles signals, by the few variables that a handler may touch.
#include "system/signal_watch.h"

#include <atomic>
#include <cassert>
#include <cerrno>
#include <cstddef>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace {

/// The watched signals. They come from the keys Ctrl+C and Ctrl+\, from a request to end, and from
/// a terminal that is closed.
constexpr std::array watched{SIGINT, SIGQUIT, SIGTERM, SIGHUP};

/// `noted` is the signal that came last, or 0. `bell` is the writing end of a pipe that wakes a
/// loop. They are global atomic variables, since a signal handler may only touch such variables.
std::atomic<int> noted = 0, bell = -1;
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void note_signal(int signal) {
    const int error = errno;
    noted = signal;
    // If the pipe is full, its reader has been woken already.
    static_cast<void>(!write(bell, "!", 1));
    errno = error;
}

/// While an object of this class lives, threads that are started get no signals. So signals go to
/// the thread that waits for events.
class signals_held {
public:
    signals_held() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    signals_held(const signals_held&) = delete;
    signals_held& operator=(const signals_held&) = delete;
    ~signals_held() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

private:
    sigset_t before_{};
};

} // namespace

/// Waits for a signal, and then five seconds for the end of the watch. If the watch lasts longer,
/// this function raises the signal again, which ends the process.
void l3d_signal_watch::end_what_takes_too_long() const {
    constexpr int patience = 5000; // milliseconds: a large picture is written in two seconds
    std::array<pollfd, 2> news{pollfd{waker_, POLLIN, 0}, pollfd{over_, POLLIN, 0}};
    while (poll(news.data(), news.size(), -1) < 0) {
    }
    pollfd over{over_, POLLIN, 0};
    if (news[1].revents == 0 && poll(&over, 1, patience) == 0)
        kill(getpid(), noted);
}

l3d_signal_watch::l3d_signal_watch() {
    assert(noted == 0);
    // A pipe keeps the news of a signal. Without it, a signal between a look at caught() and the
    // sleep would be missed.
    std::array<int, 2> ends{-1, -1};
    if (pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) == 0) {
        waker_ = ends[0];
        bell = ends[1];
    }
    struct sigaction action {};
    action.sa_handler = note_signal;
    // SA_RESTART is not set, since a signal has to end the wait for events.
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    over_ = eventfd(0, EFD_CLOEXEC);
    if (waker_ >= 0 && over_ >= 0) {
        try {
            const signals_held held;
            guard_ = std::thread([this] { end_what_takes_too_long(); });
        } catch (const std::system_error&) {
            // Without that thread, a second signal is needed to end a long wait.
        }
    }
    for (std::size_t i = 0; i < watched.size(); ++i) {
        sigaction(watched[i], nullptr, &before_[i]);
        if (before_[i].sa_handler != SIG_IGN)
            sigaction(watched[i], &action, nullptr);
    }
}

l3d_signal_watch::~l3d_signal_watch() {
    for (std::size_t i = 0; i < watched.size(); ++i)
        sigaction(watched[i], &before_[i], nullptr);
    if (guard_.joinable()) {
        eventfd_write(over_, 1);
        guard_.join();
    }
    if (over_ >= 0)
        close(over_);
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
