// SPDX-License-Identifier: MIT
// l3d_signal_watch: lets SIGINT, SIGQUIT, SIGTERM and SIGHUP end a loop in good order.
#ifndef L3D_SYSTEM_SIGNAL_WATCH_H
#define L3D_SYSTEM_SIGNAL_WATCH_H

#include <array>
#include <csignal>
#include <thread>

/// Lets the signals SIGINT, SIGQUIT, SIGTERM and SIGHUP end a loop in good order. While a watch
/// lives, the first signal of each kind is only noted. A second signal of the same kind acts as
/// without a watch, for a program that hangs. When the watch is destroyed, it restores the signals'
/// old actions and raises the noted signal. So the parent process sees that this signal ended the
/// program. A signal that was ignored (as by nohup) stays ignored.
///
/// After a signal, the program has five seconds to end in good order. Afterwards the signal acts as
/// a second signal would, whatever the program does. Unfinished files do no harm, since files have
/// no names before they are complete.
///
/// Signal handlers belong to the whole process: they are the library's only state that belongs to
/// the process.
/// Expects: at most one watch at a time.
class l3d_signal_watch {
public:
    l3d_signal_watch();
    l3d_signal_watch(const l3d_signal_watch&) = delete;
    l3d_signal_watch& operator=(const l3d_signal_watch&) = delete;
    ~l3d_signal_watch();

    /// Whether one of the signals came during the watch.
    bool caught() const;

    /// A file descriptor that becomes readable when one of the signals comes, so that a loop can
    /// sleep until then. It is -1 if the system has no more descriptors.
    /// Lives:   as long as the watch.
    int waker() const { return waker_; }

private:
    void end_what_takes_too_long() const;

    int waker_ = -1;
    int over_ = -1; ///< file descriptor that becomes readable at the watch's end
    std::thread guard_;
    std::array<struct sigaction, 4> before_{};
};

#endif
