// SPDX-License-Identifier: MIT
// l3d_isocurve_plotter: a surface as curves so close that no pixel is left between them.
#ifndef L3D_COMPARE_PLOTTERS_ISOCURVE_PLOTTER_H
#define L3D_COMPARE_PLOTTERS_ISOCURVE_PLOTTER_H

#include "geom/patch_part.h"
#include "dice/normal_columns.h"
#include "compare/plotters/plot_task.h"

/// Draws curves of constant u so close that no pixel is left between them. Adaptive forward
/// differences in T walk each curve. Steps longer than the spacing are halved before they are
/// taken, and steps shorter than half of it are doubled.
///
/// Where two curves may be farther apart than the spacing, and only there, a third curve is drawn
/// between them. Parts of the patch that are narrow enough get no further curve, so most curves end
/// early. The spacing is half a pixel, unless told otherwise, in the larger of both coordinates.
/// Then a patch without folds leaves no pixel out. A pixel gets the depth and normal of the point
/// that fell into it, which may be half a pixel from its centre. So there is no bound, and outlines
/// are up to a pixel fat.
/// Cost:    some 30 points a pixel and layer.
/// Source:  Lien, Shantz, Pratt, Adaptive Forward Differencing for Rendering Curves and Surfaces,
///          SIGGRAPH 1987. Curves that end early are those of Elber, Cohen, Adaptive Isocurves
///          Based Rendering for Freeform Surfaces, TOG 15, 1996.
template <class T> class l3d_isocurve_plotter {
public:
    /// Sets the number of points and curves along a pixel. With one, pixels may be left out.
    /// Expects: >= 1.
    explicit l3d_isocurve_plotter(int points_a_pixel = 2) : spacing_(1.0 / points_a_pixel) {}

    /// Draws a patch's pixels. Expects: l3d_needs_no_clipping(net, of.view).
    void plot(const l3d_image_patch& net, const l3d_plot_task& of);

private:
    /// A part of the patch between two curves that have been drawn.
    using stripe = l3d_patch_part;

    void fill(const stripe& between, const l3d_plot_task& of);
    void draw_curve(const l3d_image_curve& curve, double u, double v0, double v1,
                    const l3d_plot_task& of);
    void put(const l3d_image_point& h, double v, const l3d_plot_task& of);

    double spacing_; ///< in pixels
    l3d_normal_columns normals_;
};

#endif
