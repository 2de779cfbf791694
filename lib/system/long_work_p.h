// SPDX-License-Identifier: MIT
// long_work: tells on a terminal what a program is busy with before it shows anything.
#ifndef L3D_SYSTEM_LONG_WORK_P_H
#define L3D_SYSTEM_LONG_WORK_P_H

#include "base/printable_p.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <ostream>
#include <stop_token>
#include <string>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

namespace l3d_detail {

/// Tells at a terminal that long work goes on. While the object lives, it writes "reading a.obj",
/// then "reading a.obj, 1 s" and so on over the same line. At the end it erases the line. For work
/// of less than half a second it writes nothing.
///
/// The work itself need not call this object, since a thread of the object counts the seconds. If
/// the system gives no thread, nothing is written.
/// Lives:   borrows the stream. Nobody else may write to the stream meanwhile.
class long_work {
public:
    /// Starts telling of the work `what`. `is_shown` says whether the stream is a terminal; if not,
    /// nothing is written.
    /// Units:   `first` and `period`: milliseconds until the first line, and from each line to the
    ///          next.
    long_work(std::ostream& out, bool is_shown, std::string what,
              std::chrono::milliseconds first = std::chrono::milliseconds(500),
              std::chrono::milliseconds period = std::chrono::seconds(1))
        : out_(out), what_(std::move(what)) {
        try {
            if (is_shown)
                teller_ = std::jthread([this, first, period](const std::stop_token& ends) {
                    tell(ends, first, period);
                });
        } catch (const std::system_error&) { // the work goes on without it
        }
    }
    long_work(const long_work&) = delete;
    long_work& operator=(const long_work&) = delete;
    ~long_work() = default; // ends the thread

    /// Sets the share of the work that is done, from 0 to 1. From now on, lines tell the share as a
    /// percentage.
    void set_share(double share) { share_ = share; }

private:
    void tell(const std::stop_token& ends, std::chrono::milliseconds first,
              std::chrono::milliseconds period) {
        constexpr const char* erase = "\r\x1b[K"; // to the line's start, and all after it
        std::mutex mutex;
        std::condition_variable_any done;
        std::unique_lock lock(mutex);
        const auto is_over = [&](std::chrono::milliseconds time) {
            done.wait_for(lock, ends, time, [] { return false; });
            return ends.stop_requested();
        };
        int seconds = 0;
        for (auto time = first; !is_over(time); time = period) {
            out_ << erase << what_;
            if (seconds > 0)
                out_ << ", " << seconds << " s";
            if (const double share = share_; share >= 0)
                out_ << ", " << static_cast<int>(100 * share) << " %";
            out_ << std::flush;
            ++seconds;
        }
        if (seconds > 0)
            out_ << erase << std::flush;
    }

    std::ostream& out_;
    std::string what_;
    std::atomic<double> share_ = -1; ///< share of the work that is done; negative if it is unknown
    std::jthread teller_;
};

/// Tells on the standard error of work on a file, as long as the result lives. `doing` names the
/// work, such as "reading".
inline long_work tell_work(const std::string& doing, const std::string& file) {
    return {std::cerr, isatty(STDERR_FILENO) != 0, doing + ' ' + printable(file)};
}

} // namespace l3d_detail

#endif
