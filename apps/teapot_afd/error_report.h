// SPDX-License-Identifier: MIT
// The report of error against run time: the cost of accuracy with each method.
#ifndef L3D_APPS_TEAPOT_AFD_ERROR_REPORT_H
#define L3D_APPS_TEAPOT_AFD_ERROR_REPORT_H

#include <l3d/camera.h>
#include <l3d/patch_model.h>
#include <l3d/pixels.h>

#include <string>

struct error_report_scope {
    /// Whether the project's five models are measured, in three views each, in place of the given
    /// view.
    bool project_models = false;
    /// A short report: small pictures of few models, settings and frames.
    bool quick = false;
};

/// Measures all methods and arithmetics in each view, and also cubic curves. Writes numbers (.csv,
/// .json) and pictures of where the error sits (.png) into a folder. report_pages.py makes pages
/// and diagrams of the numbers: report.md, report.html, .svg and .png. Stderr tells the progress,
/// and how to call that script.
///
/// A report that was stopped goes on where it was if it is begun again with the same folder.
///
/// Errors:  l3d_error(failure) that names a file that cannot be written, or tells how many rows
///          could not be measured. In the latter case all other rows are written.
void write_error_report(const std::string& folder, const l3d_patch_model& model,
                        const l3d_camera& camera, l3d_size size, const error_report_scope& scope);

#endif
