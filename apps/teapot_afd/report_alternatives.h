// SPDX-License-Identifier: MIT
// The report's part on the competitors of forward differencing: scan lines, cells, smoke, and
// micropolygons that are kept.
#ifndef L3D_APPS_TEAPOT_AFD_REPORT_ALTERNATIVES_H
#define L3D_APPS_TEAPOT_AFD_REPORT_ALTERNATIVES_H

#include <l3d/pixels.h>

#include <string>

/// Compares the scan line methods of Whitted and Blinn. Writes scan_lines.csv: how many iterations
/// the methods take, and how many iterations fail. Writes scan_folds.png: folded patches as three
/// methods draw them, with wrong pixels marked.
/// Errors:  here and in the functions below, l3d_error(failure) that names the file.
void write_scan_line_table(const std::string& folder, l3d_size size);

/// Writes cells.csv: the steps and times of paths through cells, along rays and along curves.
void write_cell_table(const std::string& folder, l3d_size size, bool quick);

/// Writes smoke.png, a picture of a jet plane of polygons in a cloud of cells, and smoke.csv, the
/// picture's cost.
void write_smoke(const std::string& folder, bool quick);

/// Writes kept.csv: over three flights, compares micropolygons that are diced in each frame with
/// micropolygons that are kept.
void write_kept_table(const std::string& folder, l3d_size size, bool quick);

#endif
