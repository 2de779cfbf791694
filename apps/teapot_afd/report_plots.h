// SPDX-License-Identifier: MIT
// The measurements as diagrams.
#ifndef L3D_APPS_TEAPOT_AFD_REPORT_PLOTS_H
#define L3D_APPS_TEAPOT_AFD_REPORT_PLOTS_H

#include "report_files.h"

#include <string>

/// Writes data and scripts for gnuplot, and runs it, for .svg and .png; says so on stderr where it
/// is not there or fails.
///
/// Errors: l3d_error(failure) that names the file that cannot be written.
void draw_report_plots(const std::string& folder, const report_contents& report);

#endif
