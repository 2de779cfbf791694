// SPDX-License-Identifier: MIT
// Work in a process of its own, for what is decided once in a process.
#ifndef L3D_TESTS_BENCH_CHILD_PROCESS_H
#define L3D_TESTS_BENCH_CHILD_PROCESS_H

#include <functional>
#include <map>
#include <string>
#include <vector>

/// The data that a child has of its own.
struct child_setting {
    std::map<std::string, std::string> environment;
    bool one_processor = false; ///< may run on no other than the one that it starts on
};

/// Runs `work` in a child of this process, and returns what it returned.
///
/// Expects: no threads in this process that hold locks.
/// Errors:  std::runtime_error if the child fails, after it has said why on stderr.
std::vector<double> in_child(const child_setting& setting,
                             const std::function<std::vector<double>()>& work);

#endif
