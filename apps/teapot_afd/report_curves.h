// SPDX-License-Identifier: MIT
// The report's part on cubic curves.
#ifndef L3D_APPS_TEAPOT_AFD_REPORT_CURVES_H
#define L3D_APPS_TEAPOT_AFD_REPORT_CURVES_H

#include <string>

/// Measures forward differences of random cubics (curve_measure.h), and writes curves.csv,
/// limits.csv and steps.csv into a folder.
/// Errors: l3d_error(failure) that names the file.
void write_curve_tables(const std::string& folder, bool quick);

#endif
