// SPDX-License-Identifier: MIT
// The report of error against run time: the cost of accuracy with each method.
#ifndef L3D_APPS_TEAPOT_AFD_ERROR_REPORT_H
#define L3D_APPS_TEAPOT_AFD_ERROR_REPORT_H

#include <l3d/camera.h>
#include <l3d/patch_model.h>
#include <l3d/pixels.h>

#include <string>

struct error_report_scope {
    /// The project's five models are measured in three views each, not the given one.
    bool project_models = false;
    /// Pictures are small, and there are fewer models, settings and frames.
    bool quick = false;
};

/// Measures all methods and arithmetics in each view, and cubic curves besides. Writes numbers into
/// a folder (.csv, .json), and pictures of where the error sits (.png). report_pages.py makes pages
/// and diagrams of the numbers: report.md, report.html, .svg and .png. Tells its progress on
/// stderr, and how to call that script.
///
/// A stopped report goes on where it was if it is begun again with the same folder.
///
/// Errors: l3d_error(failure) that names a file that cannot be written, or tells how many rows
///         could not be measured. Then all others are written.
void write_error_report(const std::string& folder, const l3d_patch_model& model,
                        const l3d_camera& camera, l3d_size size, const error_report_scope& scope);

#endif
