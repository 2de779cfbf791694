// SPDX-License-Identifier: MIT
// The measurements as tables.
#ifndef L3D_APPS_TEAPOT_AFD_REPORT_FILES_H
#define L3D_APPS_TEAPOT_AFD_REPORT_FILES_H

#include "curve_measure.h"
#include "frame_measure.h"

#include <string>
#include <vector>

/// How many steps an arithmetic bears with an error below a pixel.
struct step_limit {
    curve_numbers numbers;
    int in_1024 = 0, in_128k = 0; ///< with control points that many pixels apart
};

struct curve_results {
    int curves = 0;
    std::vector<growth_row> growth;
    std::vector<chord_row> chords;
    std::vector<step_row> steps;
    std::vector<step_limit> limits;
};

struct report_picture {
    std::string file, title;
};

struct report_contents {
    l3d_size size;
    bool quick = false;
    std::vector<frame_result> frames;
    curve_results curves;
    std::vector<report_picture> pictures;
};

/// Writes report.md, frames.csv, curves.csv and report.json.
/// Errors: l3d_error(failure) that names the file.
void write_report_files(const std::string& folder, const report_contents& report);

/// Writes a whole text file. Errors: l3d_error(failure) that names the file.
void write_text(const std::string& file, const std::string& text);

#endif
