// SPDX-License-Identifier: MIT
// l3d_scanline_plotter: patches scan line by scan line, every pixel by Newton's iteration.
#ifndef L3D_COMPARE_PLOTTERS_SCANLINE_PLOTTER_H
#define L3D_COMPARE_PLOTTERS_SCANLINE_PLOTTER_H

#include "geom/patch_part.h"
#include "compare/plotters/scan_edges.h"
#include "compare/plotters/plot_task.h"

#include <vector>

/// Draws a patch scan line by scan line. The patch is cut into pieces whose image is one to one, so
/// no silhouette runs through them. Pieces with a silhouette are cut down to a pixel's size. The
/// borders of a piece are cut into stretches that rise or fall from end to end, so that each has
/// one point on a scan line. A guarded Newton's iteration finds these points, and they pair up into
/// spans. Along a span, the parameters of each pixel start the iteration of the next. In pieces of
/// a pixel's size around silhouettes, the iteration is started from several places instead.
///
/// The iteration stops within an eighth of the tolerance. A pixel of a span for which it does not
/// converge is left out and counted as a failure; so there is no bound.
/// Cost:   0.1 us an iteration, of which a pixel takes two or three.
/// Source: Lane, Carpenter, Whitted, Blinn, Scan Line Methods for Displaying Parametrically Defined
/// Surfaces, CACM 23, 1980.
class l3d_scanline_plotter {
public:
    /// Draws a patch's pixels. Expects: l3d_needs_no_clipping(net, of.view).
    void plot(const l3d_image_patch& net, const l3d_plot_task& of);

private:
    using piece = l3d_patch_part;

    void divide(const piece& p, const l3d_plot_task& of);
    void scan(const piece& p, const l3d_image_box& hull, const l3d_plot_task& of);
    void scan_span(const piece& p, const l3d_scan_piece& powers, int row,
                   const l3d_scan_crossing& left, const l3d_scan_crossing& right,
                   const l3d_plot_task& of);
    void try_pixels(const piece& p, const l3d_image_box& hull, const l3d_plot_task& of);
    static void put(const piece& p, int column, int row, const l3d_scan_root& root,
                    const l3d_plot_task& of);

    double accuracy_ = 0; ///< the error within which the iteration stops, in pixels
    std::vector<l3d_scan_edge> edges_;
    std::vector<l3d_scan_crossing> crossings_;
};

#endif
