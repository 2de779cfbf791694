// SPDX-License-Identifier: MIT
// The report's part on the competitors of forward differencing: scan lines, cells, smoke, and
// micropolygons that are kept.
#ifndef L3D_APPS_TEAPOT_AFD_REPORT_ALTERNATIVES_H
#define L3D_APPS_TEAPOT_AFD_REPORT_ALTERNATIVES_H

#include <l3d/pixels.h>

#include <string>

/// Compares Whitted's and Blinn's scan lines. Writes how many iterations they take, and how many
/// fail: scan_lines.csv. Also writes folded patches as three methods draw them, with wrong pixels
/// marked: scan_folds.png.
/// Errors:  here and below, l3d_error(failure) that names the file.
void write_scan_line_table(const std::string& folder, l3d_size size);

/// Writes the steps and times of paths of cells, along rays and along curves: cells.csv.
void write_cell_table(const std::string& folder, l3d_size size, bool quick);

/// Writes a picture of a jet of polygons in a cloud of cells, smoke.png, and its cost, smoke.csv.
void write_smoke(const std::string& folder, bool quick);

/// Compares micropolygons diced in each frame with kept ones, over three flights: kept.csv.
void write_kept_table(const std::string& folder, l3d_size size, bool quick);

#endif
