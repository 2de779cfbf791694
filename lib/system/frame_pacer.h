// SPDX-License-Identifier: MIT
// l3d_frame_pacer: tells when the next frame is due.
#ifndef L3D_SYSTEM_FRAME_PACER_H
#define L3D_SYSTEM_FRAME_PACER_H

#include <algorithm>
#include <chrono>

/// Tells when the next frame is due. Deadlines lie on a fixed grid of times, so that one late frame
/// does not make all others late. A deadline that was missed is dropped.
class l3d_frame_pacer {
public:
    using clock = std::chrono::steady_clock;

    /// Takes the rate of frames. The first frame is due at `start`.
    /// Units:   frames per second; 0: no limit.
    l3d_frame_pacer(double fps, clock::time_point start)
        : period_(fps > 0 ? seconds(std::min(1 / fps, longest_period)) : clock::duration::zero()),
          due_(start) {}

    clock::time_point due() const { return due_; }

    /// Notes that a frame was done at `now`. Without a limit of the rate, the next frame is due at
    /// once. But if this frame drew nothing (`idle`), the next frame is due in 1/60 s, since
    /// waiting must not take a whole processor.
    void frame_done(clock::time_point now, bool idle) {
        if (period_ == clock::duration::zero()) {
            due_ = idle ? now + seconds(1.0 / 60) : now;
            return;
        }
        due_ += period_;
        if (due_ < now)
            due_ += ((now - due_) / period_ + 1) * period_;
    }

private:
    /// The longest time between frames: one hour. 1 / fps may be anything, and the clock counts
    /// nanoseconds in 64 bits.
    static constexpr double longest_period = 3600;

    static clock::duration seconds(double count) {
        return std::chrono::duration_cast<clock::duration>(std::chrono::duration<double>(count));
    }

    clock::duration period_;
    clock::time_point due_;
};

#endif
