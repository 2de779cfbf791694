// SPDX-License-Identifier: MIT
// l3d_blinn_plotter: Blinn's scan lines, on which every pixel is a Newton iteration.
#ifndef L3D_COMPARE_PLOTTERS_BLINN_PLOTTER_H
#define L3D_COMPARE_PLOTTERS_BLINN_PLOTTER_H

#include "compare/plotters/plot_task.h"
#include "compare/plotters/scan_edges.h"
#include "compare/plotters/silhouette.h"

#include <cstddef>
#include <vector>

/// Scans a whole patch, without cutting it, line by line from top to bottom. Its borders and
/// silhouettes are tracked: each point on a line starts Newton's iteration for the next line.
/// Silhouettes begin where they cross a border, and at the highest, lowest and saddle points of the
/// patch.
///
/// On a line, the borders and silhouettes of the front pair up from left to right. Those of the
/// back pair up in the same way. Within a pair, each pixel is solved in two variables, from the
/// pixel before it.
///
/// Failures are counted, and their pixels are left out. An iteration fails if it does not come to
/// rest on the right side of the surface, and an edge fails if it has no partner. Folds whose
/// silhouettes begin in a cusp are not found, since y has no extremum or saddle there. The paper
/// proposes no remedy, so there is none here.
/// Source: J. F. Blinn in Lane, Carpenter, Whitted, Blinn, Scan Line Methods for Displaying
///         Parametrically Defined Surfaces, CACM 23, 1980.
class l3d_blinn_plotter {
public:
    /// Draws a patch's pixels. Expects: l3d_needs_no_clipping(net, of.view).
    void plot(const l3d_image_patch& net, const l3d_plot_task& of);

    /// The effort of all iterations since the plotter was made.
    const l3d_scan_effort& effort() const { return effort_; }

private:
    /// A border, and its crossing with the line before.
    struct border {
        l3d_scan_edge edge;
        double t;
        bool is_new = true, is_lost = false;
    };
    /// A silhouette on the line before, and its step from line to line.
    struct silhouette {
        l3d_scan_root at;
        double du = 0, dv = 0;
        bool is_lost = false;
    };
    /// A place where one or two silhouettes begin.
    struct beginning {
        double y;
        l3d_scan_root at;
        bool is_level; ///< not at a border, but at a point where y is level
    };

    void find_beginnings(const l3d_scan_piece& piece, const l3d_plot_task& of);
    void begin_at(const beginning& from, const l3d_scan_piece& piece, double y,
                  const l3d_plot_task& of);
    void add_silhouette(const l3d_scan_piece& piece, double y, l3d_scan_root start,
                        const l3d_plot_task& of);
    void meet_borders(const l3d_scan_piece& piece, double y, const l3d_plot_task& of);
    void meet_silhouettes(const l3d_scan_piece& piece, double y, const l3d_plot_task& of);
    void scan_side(const l3d_scan_piece& piece, int row, bool front, const l3d_plot_task& of);
    void scan_span(const l3d_scan_piece& piece, int row, bool front, const l3d_scan_crossing& left,
                   const l3d_scan_crossing& right, const l3d_plot_task& of);
    void fail(const l3d_plot_task& of, int rounds);

    double accuracy_ = 0; ///< the error within which an iteration rests, in pixels
    std::vector<l3d_scan_edge> edges_;
    std::vector<border> borders_;
    std::vector<beginning> beginnings_;
    std::size_t begun_ = 0; ///< number of beginnings used
    std::vector<silhouette> silhouettes_;
    std::vector<l3d_scan_crossing> crossings_[2]; ///< for the back, for the front
    l3d_scan_effort effort_;
};

#endif
