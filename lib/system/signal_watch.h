// SPDX-License-Identifier: MIT
// l3d_signal_watch: lets SIGINT, SIGQUIT, SIGTERM and SIGHUP end a loop in good order.
#ifndef L3D_SYSTEM_SIGNAL_WATCH_H
#define L3D_SYSTEM_SIGNAL_WATCH_H

#include <array>
#include <csignal>
#include <thread>

/// While a watch lives, the first signal of each kind is only noted. A second one of the same kind
/// acts as it did before, for a program that hangs. When the watch dies, the signals' old actions
/// are restored, and the noted signal is raised: the parent process sees a death by that signal. A
/// signal that was ignored (as by nohup) stays ignored.
///
/// The watching program has five seconds to end in good order. After that the signal acts as a
/// second one would, whatever loop the program is in. Unfinished files do no harm, since files have
/// no names before they are complete.
///
/// Signal handlers are a property of the process: this is the library's only such state.
/// Expects: at most one at a time.
class l3d_signal_watch {
public:
    l3d_signal_watch();
    l3d_signal_watch(const l3d_signal_watch&) = delete;
    l3d_signal_watch& operator=(const l3d_signal_watch&) = delete;
    ~l3d_signal_watch();

    /// Whether one of the signals came.
    bool caught() const;

    /// A file that can be read once one of the signals came, so that a loop can sleep until then.
    /// It is -1 if the system has no more files.
    /// Lives:   as long as the watch.
    int waker() const { return waker_; }

private:
    void end_what_takes_too_long() const;

    int waker_ = -1;
    int over_ = -1; ///< readable when the watch is over
    std::thread guard_;
    std::array<struct sigaction, 4> before_{};
};

#endif
