// SPDX-License-Identifier: MIT
// The processor time that this process has taken.
#ifndef L3D_TESTS_PROCESSOR_TIME_H
#define L3D_TESTS_PROCESSOR_TIME_H

#include <sys/resource.h>

/// Seconds that the processors have spent on this process, in it and in the system for it.
inline double processor_seconds() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

#endif
