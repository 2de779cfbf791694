// SPDX-License-Identifier: MIT
// l3d_whitted_plotter: Whitted's scan lines between curved edges.
#ifndef L3D_COMPARE_PLOTTERS_WHITTED_PLOTTER_H
#define L3D_COMPARE_PLOTTERS_WHITTED_PLOTTER_H

#include "compare/plotters/plot_task.h"
#include "compare/plotters/scan_edges.h"
#include "compare/plotters/silhouette.h"
#include "geom/patch_part.h"

#include <array>
#include <vector>

/// Draws a patch as polygons with curved edges. The patch is cut into pieces whose depth is nearly
/// a plane's. The edges of a piece are its borders. A silhouette that runs through the piece is an
/// edge, too: a cubic joins its two ends with their directions. On each scan line, Newton's
/// iteration finds the edges from where the line before met them. Between two edges, depth and
/// normal are interpolated.
///
/// A failure is an iteration that does not come to rest, an edge without partner, or a piece that
/// keeps a third end of a silhouette after all cuts. A silhouette that meets no border of its piece
/// is not found, and not counted.
/// Source: T. Whitted, A Scan Line Algorithm for Computer Display of Curved Surfaces, SIGGRAPH
///         1978; Lane, Carpenter, Whitted, Blinn, CACM 23, 1980.
class l3d_whitted_plotter {
public:
    /// Draws a patch's pixels. Expects: l3d_needs_no_clipping(net, of.view).
    void plot(const l3d_image_patch& net, const l3d_plot_task& of);

    /// The effort of all iterations since the plotter was made.
    const l3d_scan_effort& effort() const { return effort_; }

private:
    using piece = l3d_patch_part;
    /// An edge on one side of a piece, and its crossing with the line before.
    struct tracked {
        l3d_scan_edge edge;
        double t;
        bool is_new = true;
    };
    /// The crossing of a line with an edge, and the values from which the line is interpolated.
    struct end {
        double x, inv_w;
        std::array<float, 3> normal;
    };

    void divide(const piece& p, const l3d_plot_task& of);
    void cut(const piece& p, const l3d_plot_task& of);
    bool is_nearly_flat(const piece& p, const l3d_plot_task& of) const;
    void add_borders(const piece& p, const l3d_scan_piece& powers,
                     const std::vector<l3d_border_turn>& turns);
    void add_silhouette(const l3d_scan_piece& powers, const std::vector<l3d_border_turn>& turns);
    void scan(const piece& p, std::vector<tracked>& edges, const l3d_plot_task& of);
    void meet(const piece& p, std::vector<tracked>& edges, double y, const l3d_plot_task& of);
    static void fill(int row, const end& left, const end& right, const l3d_plot_task& of);
    void fail(const l3d_plot_task& of, int rounds);

    double accuracy_ = 0; ///< the error within which an iteration rests, in pixels
    std::vector<l3d_scan_edge> found_;
    std::vector<tracked> edges_[2]; ///< for the back, for the front
    std::vector<end> ends_;
    l3d_scan_effort effort_;
};

#endif
