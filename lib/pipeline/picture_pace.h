// SPDX-License-Identifier: MIT
// l3d_picture_pace: the rate of pictures, and the time that drawing one takes.
#ifndef L3D_PIPELINE_PICTURE_PACE_H
#define L3D_PIPELINE_PICTURE_PACE_H

#include "base/public.h"

#include <chrono>
#include <deque>
#include <functional>
#include <string>
#include <utility>

/// Measures the pictures of the last second: time and rate are means over the same pictures, by one
/// clock. So no picture seems to take longer than the time to the next.
///
/// A second without a picture counts as rest, and the rate begins anew with the next two pictures.
class L3D_PUBLIC l3d_picture_pace {
public:
    /// A clock that is never set back.
    using clock = std::chrono::steady_clock;
    /// Tells the time.
    using teller = std::function<clock::time_point()>;

    /// Measures with this clock.
    explicit l3d_picture_pace(teller now = clock::now) : now_(std::move(now)) {}

    /// Drawing begins, also of a picture that is not counted in the end.
    void begin();
    /// Drawing ends. Expects: begin() was called.
    void end();

    /// The time that drawing a picture takes. Units: milliseconds. 0 before the first end().
    double milliseconds() const;
    /// Pictures a second, from the first that counts to the last begin(). 0 at rest.
    double per_second() const;
    /// Both numbers, for people; at rest only the time, and "" before the first end().
    std::string text() const;

private:
    struct picture {
        clock::time_point begin, end;
    };

    teller now_;
    std::deque<picture> done_; ///< those that count
    clock::time_point begin_{};
    bool follows_ = false; ///< begin_ follows done_ without a rest
};

#endif
