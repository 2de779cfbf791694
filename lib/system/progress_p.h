// SPDX-License-Identifier: MIT
// progress: shows the progress of a long run without a window on one line of a terminal.
#ifndef L3D_SYSTEM_PROGRESS_P_H
#define L3D_SYSTEM_PROGRESS_P_H

#include <chrono>
#include <ostream>
#include <string>

namespace l3d_detail {

/// Shows at a terminal how many frames of a long run without a window are done. It writes "program:
/// frame 120 of 5000" over the same line once a second, and erases the line at the end. For a run
/// of less than a second it writes nothing.
///
/// Lives:   borrows the stream.
class progress {
public:
    using clock = std::chrono::steady_clock;

    /// Starts a run of `frames` frames. `is_shown` says whether the stream is a terminal; if not,
    /// nothing is written.
    progress(std::ostream& out, bool is_shown, std::string program, int frames,
             clock::time_point start)
        : out_(out), is_shown_(is_shown), program_(std::move(program)), frames_(frames),
          next_(start + period) {}
    progress(const progress&) = delete;
    progress& operator=(const progress&) = delete;
    ~progress() {
        if (is_written_)
            out_ << erase << std::flush;
    }

    /// Notes that so many frames of the run are done at the time `now`.
    void done(int frames, clock::time_point now) {
        if (!is_shown_ || now < next_)
            return;
        out_ << erase << program_ << ": frame " << frames << " of " << frames_ << std::flush;
        is_written_ = true;
        next_ = now + period;
    }

private:
    static constexpr std::chrono::seconds period{1};
    /// Goes to the line's start and erases the line.
    static constexpr const char* erase = "\r\x1b[K";

    std::ostream& out_;
    bool is_shown_;
    std::string program_;
    int frames_;
    clock::time_point next_; ///< the time from which the line may be written again
    bool is_written_ = false;
};

} // namespace l3d_detail

#endif
