// SPDX-License-Identifier: MIT
// l3d_frame_pacer: tells when the next frame is due.
#ifndef L3D_SYSTEM_FRAME_PACER_H
#define L3D_SYSTEM_FRAME_PACER_H

#include <algorithm>
#include <chrono>

/// Sets deadlines on a fixed grid of times, so that one late frame does not make all others late. A
/// deadline that was missed is dropped, not caught up with.
class l3d_frame_pacer {
public:
    using clock = std::chrono::steady_clock;

    /// Takes the rate of frames, of which the first is due at `start`.
    /// Units:   frames per second; 0: no limit.
    l3d_frame_pacer(double fps, clock::time_point start)
        : period_(fps > 0 ? seconds(std::min(1 / fps, longest_period)) : clock::duration::zero()),
          due_(start) {}

    clock::time_point due() const { return due_; }

    /// Notes a frame that is done at `now`. Without a limit, the next frame is due at once. It is
    /// due in 1/60 s if this frame drew nothing (`idle`): waiting must not cost a whole processor.
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
