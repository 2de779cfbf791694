// SPDX-License-Identifier: MIT
// The report of error against run time: the cost of accuracy with each method.
#ifndef L3D_APPS_TEAPOT_AFD_ERROR_REPORT_H
#define L3D_APPS_TEAPOT_AFD_ERROR_REPORT_H

#include <l3d/camera.h>
#include <l3d/patch_model.h>
#include <l3d/pixels.h>

#include <string>

struct error_report_scope {
    /// Whether the models of report_models() are measured, in three views each, in place of the
    /// given model and view.
    bool project_models = false;
    /// Whether the report is short: small pictures of few models, settings and frames.
    bool quick = false;
};

/// Measures the error and the time of all methods and arithmetics in each view, and also of cubic
/// curves. Writes numbers (.csv, .json) and pictures of the errors' places (.png) into a folder.
/// The script report_pages.py makes pages and diagrams of the numbers: report.md, report.html, .svg
/// and .png. Stderr tells the progress, and how to call the script.
///
/// If a report was stopped, another call with the same folder goes on from the rows that are
/// measured already.
///
/// Errors:  l3d_error(failure) that names a file that cannot be written, or tells how many rows
///          could not be measured. If rows could not be measured, all other rows are written.
void write_error_report(const std::string& folder, const l3d_patch_model& model,
                        const l3d_camera& camera, l3d_size size, const error_report_scope& scope);

#endif
