// SPDX-License-Identifier: MIT
// l3d_ticker: time as it passes, in the equal steps that a program counts in.
#ifndef L3D_PIPELINE_TICKER_H
#define L3D_PIPELINE_TICKER_H

#include "base/public.h"

#include <algorithm>
#include <cmath>

/// Turns seconds into whole steps. So a world that moves step by step moves as fast at any frame
/// rate. At 30 frames a second it makes two steps of a 60th each, at 300 one in every fifth frame.
class L3D_PUBLIC l3d_ticker {
public:
    /// Units:   steps per second. Expects: positive.
    explicit l3d_ticker(double per_second = 60) : per_second_(per_second) {}

    /// The number of steps due `seconds` after the last call; the rest is kept for the next call.
    ///
    /// At most a second's worth: a program that was stopped does not catch up with hours.
    int due(double seconds) {
        // A rounding error is no reason to put off a step. 1/60 s, as a double, times 60 is 1, but
        // a sum of many need not be whole. 2^-20 of a step exceeds the error of 2^30 steps, and
        // nobody sees it.
        constexpr double slack = 0x1p-20;
        steps_ = std::min(steps_ + std::max(seconds, 0.0) * per_second_, per_second_);
        const double whole = std::floor(steps_ + slack);
        steps_ -= whole;
        return static_cast<int>(whole);
    }

private:
    double per_second_;
    double steps_ = 0; ///< not yet handed out, may be less than 0 by the slack
};

#endif
