// SPDX-License-Identifier: MIT
// stopwatch: time since it was made.
#ifndef L3D_PIPELINE_STOPWATCH_P_H
#define L3D_PIPELINE_STOPWATCH_P_H

#include <chrono>

namespace l3d_detail {

class stopwatch {
public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(clock::now() - start_).count();
    }

private:
    using clock = std::chrono::steady_clock;
    clock::time_point start_ = clock::now();
};

} // namespace l3d_detail

#endif
