// SPDX-License-Identifier: MIT
// The report of error against run time: what accuracy costs with each method.
#ifndef L3D_APPS_TEAPOT_AFD_ERROR_REPORT_H
#define L3D_APPS_TEAPOT_AFD_ERROR_REPORT_H

#include <l3d/camera.h>
#include <l3d/patch_model.h>
#include <l3d/pixels.h>

#include <string>

struct error_report_scope {
    bool project_views = false; ///< full, closeup and top, instead of one camera
    bool quick = false;         ///< small pictures, fewer settings, shorter times
};

/// Measures all methods and arithmetics in each view, and cubic curves besides. Writes three kinds
/// of files into a folder. They are tables (.md, .csv, .json), diagrams (.svg, .png; by gnuplot, if
/// it is there), and pictures of where the error sits (.png). Says on stderr what it is doing.
///
/// Errors: l3d_error(failure) that names what cannot be written.
void write_error_report(const std::string& folder, const l3d_patch_model& model,
                        const l3d_camera& camera, l3d_size size, const error_report_scope& scope);

#endif
