// SPDX-License-Identifier: MIT
// The suite's results for readers.
#ifndef L3D_TESTS_STABILITY_TABLE_H
#define L3D_TESTS_STABILITY_TABLE_H

#include "suite.h"

#include <cstdio>
#include <string>

namespace stability {

/// Comma-separated values, named after this build's l3d_real: every named case with its stiffness,
/// plane curves, walks, and the facts of the run. stability_pages.py makes a page of them.
/// Errors: std::runtime_error that names the file.
void write_files(const std::string& folder, const suite_result& result);

/// A line for each named case and arithmetic, with all that is known of it.
void write_cases(std::FILE* to, const suite_result& result);

/// Lines `ok NAME` and `not ok NAME: why`, as tests/lint/summary.awk reads them.
void write_lines(std::FILE* to, const suite_result& result);

} // namespace stability

#endif
