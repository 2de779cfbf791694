// SPDX-License-Identifier: MIT
// The suite's results for readers.
#ifndef L3D_TESTS_STABILITY_TABLE_H
#define L3D_TESTS_STABILITY_TABLE_H

#include "suite.h"

#include <cstdio>

namespace stability {

/// Markdown: what was run, on what and when, the worst, and every named case.
void write_table(std::FILE* to, const suite_result& result);

/// A line for each named case and arithmetic, with all that is known of it.
void write_cases(std::FILE* to, const suite_result& result);

/// Lines `ok NAME` and `not ok NAME: why`, as tests/lint/summary.awk reads them.
void write_lines(std::FILE* to, const suite_result& result);

} // namespace stability

#endif
