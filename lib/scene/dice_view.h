// SPDX-License-Identifier: MIT
// l3d_dice_view: the data about the picture that dicing needs.
#ifndef L3D_SCENE_DICE_VIEW_H
#define L3D_SCENE_DICE_VIEW_H

#include "geom/step_bound.h"
#include "raster/surface_part.h"
#include "raster/surface_rasterizer.h"
#include "scene/counts.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

struct l3d_shared_polyline;
struct l3d_trim_region;

/// The plane that cuts a scene open, in homogeneous image space. Points h with a positive distance
/// normal.h + d are drawn. Without a plane, all numbers are 0.
struct l3d_image_section {
    l3d_image_point normal{0.0, 0.0, 0.0};
    double d = 0;

    bool is_on() const { return normal != l3d_image_point{0.0, 0.0, 0.0}; }
    double distance(const l3d_image_point& h) const { return l3d_dot(normal, h) + d; }
    /// Whether the plane cuts off the whole convex hull of these points.
    bool cuts_off(std::span<const l3d_image_point> net) const {
        return is_on() && std::ranges::all_of(net, [&](const auto& h) { return distance(h) <= 0; });
    }
    /// Whether the plane cuts off nothing of the convex hull of these points.
    bool leaves(std::span<const l3d_image_point> net) const {
        return !is_on() || std::ranges::all_of(net, [&](const auto& h) { return distance(h) > 0; });
    }

    friend bool operator==(const l3d_image_section&, const l3d_image_section&) = default;
};

/// Whether a net is small: less than 24 pixels wide and high. Small nets are not divided into
/// strips to bound their errors. A quarter of a small net is a few quads, so strips would cost more
/// than they save.
inline bool l3d_is_small(const l3d_image_box& hull) {
    return hull.width() < 24 && hull.height() < 24;
}

/// Whether two points are farther apart in the picture than `pixels`. `along` is 0 for x, 1 for y.
/// This quick test takes no division, and decides for most patches.
/// Expects: both points in front of the eye.
inline bool l3d_far_apart(const l3d_image_point& a, const l3d_image_point& b, int along,
                          double pixels) {
    return std::abs(a[along] * b[2] - b[along] * a[2]) > pixels * a[2] * b[2];
}

/// The default budget of samples in a frame for patches that have to be cut or clipped. Two samples
/// a pixel are more than any picture shows, and 2^16 samples take a millisecond or two. The number
/// of quads grows with 1 / tolerance. At 0.05 px, the teapot has a quad for every two pixels that
/// it covers, so finer tolerances get more samples. A pixel gets at most 2^20 samples, lest the
/// inverse of a tiny tolerance be infinite. Patches that are neither cut nor clipped are always
/// done, in at most 129 x 129 samples.
/// Units: samples that are walked, see l3d_dice_budget; tolerance in pixels.
constexpr std::int64_t l3d_usual_samples(l3d_size size, double tolerance) {
    const double a_pixel = std::clamp(2 * (0.05 / tolerance), 2.0, 0x1p20);
    return (std::int64_t{1} << 16) +
           static_cast<std::int64_t>(a_pixel * static_cast<double>(size.width) * size.height);
}

/// The largest error a that outlines may have in pictures with smooth edges. With a tolerance of b
/// pixels, the bound of outlines is 1 / (1 / a + 1 / b). This bound is a twelfth of a pixel at the
/// usual tolerance of a quarter. Measured outlines have a root mean square error of a sixth of this
/// bound. The coverage of a pixel by 64 samples errs by 0.73 / 64 of a pixel, which is nearly as
/// much.
/// Units: pixels.
inline constexpr double l3d_widest_outline = 0.125;

/// The accuracy of a parallel projection, which is drawn in perspective from a far eye. Half of the
/// scene's depth is at most this part of the eye's distance. Places in the picture are off by the
/// same part of their distance from the picture's middle: 2^-9 pixels in a picture 4096 wide.
/// Errors of the transform include this distance.
inline constexpr double l3d_parallel_part = 0x1p-20;

/// The view for which patches are diced: the picture, its planes, and the accuracy asked for. The
/// view is made once a frame; l3d_frame_dicer sets a few members for each patch.
///
/// Units: pixels from the picture's centre; near, far and depths in the image transform's scaled w.
struct l3d_dice_view {
    l3d_size size;
    double near = 0, far = std::numeric_limits<double>::infinity();
    double tolerance = 0.25;

    /// The length in pixels of a unit at distance 1. If it is not 0, errors of depth are kept
    /// within the tolerance, too. If it is 0, only errors of places in the picture are kept within
    /// the tolerance.
    double focal = 0;
    double shade_tolerance = 2; ///< largest error of shade levels, of 255, if focal is not 0
    double depth_scale = 1;     ///< the quotient of scaled w and distance along the view axis

    /// The w of the camera's target in a parallel projection; 0 in perspective. In a parallel
    /// projection, all w differ from w_middle by at most l3d_parallel_part * w_middle, and depths
    /// are linear in w.
    double w_middle = 0;

    double error_xy = 0; ///< error of x and y of a transformed control point
    double error_w = 0;

    /// Bound of the sum of the magnitudes of all terms that add up to a point's coordinates. Terms
    /// of the eye's place are included. Rounding errors are in proportion to this sum. 0 says that
    /// it is unknown; of_share() then cannot reduce errors.
    double terms = 0;
    double eye_terms = 0; ///< the part of `terms` that comes from the eye's place
    /// The w of the camera's near plane. Errors of w may push the plane farther away, to `near`. 0
    /// stands for the same w as `near`.
    double camera_near = 0;
    l3d_culling_switches keep;
    std::int64_t most_samples = 0; ///< the frame's budget of samples; 0: l3d_usual_samples
    bool one_sided = false;        ///< whether the side opposite to dS/du x dS/dv is not shown
    l3d_image_section section;     ///< the plane that cuts the scene open

    /// A bit for each block in which the diced patch may fold over, as seen from the eye. The bit's
    /// number is 4 * row + column, with columns along u.
    unsigned folds = 0;
    /// The part of the diced patch that its trims leave; null if they leave all of the patch.
    const l3d_trim_region* trim = nullptr;
    /// The polylines of the edges that the diced patch's trims follow; null if the trims follow
    /// none.
    const std::vector<l3d_shared_polyline>* edges = nullptr;
    /// How far strips along these edges may reach beyond the patch. Units: pixels.
    double edge_reach = 0;

    /// How vertices are lit. In mode `levels`, vertices get shade levels. Otherwise they get unit
    /// normals, which are turned to the eye if the shading has an eye.
    l3d_shading shading{.ray = {0, 0, 0}};

    bool makes_levels() const { return shading.mode == l3d_shade::levels; }

    friend bool operator==(const l3d_dice_view&, const l3d_dice_view&) = default;

    bool is_parallel() const { return w_middle > 0; }

    /// The depth of a place at w_middle in a parallel projection. Depths fall linearly with w, from
    /// 1.25 at the nearest place to 1 at the farthest.
    static constexpr double middle_depth = 1.125;
    double depth_slope() const { return -0.125 / (l3d_parallel_part * w_middle); }

    /// The depth that is stored for a drawn vertex: 1 / distance in perspective, linear in w in a
    /// parallel projection.
    float depth_at(double w) const {
        if (is_parallel())
            return static_cast<float>(middle_depth + depth_slope() * (w - w_middle));
        return static_cast<float>(1 / w) * static_cast<float>(depth_scale);
    }

    /// The w of a place with this stored depth.
    double w_at(float depth) const {
        if (is_parallel())
            return w_middle + (double{depth} - middle_depth) / depth_slope();
        return depth_scale / static_cast<double>(depth);
    }

    /// The error along the line of sight that comes from storing depths in floats. Making and
    /// scaling a depth, both slopes of a polygon and the steps along the slopes err by some 2^-24
    /// of the depth each.
    /// Units: pixels at the place's own depth.
    double depth_rounding() const {
        constexpr double roundings = 6 * 0x1p-24;
        return focal * roundings *
               (is_parallel() ? 1.25 / std::abs(depth_slope() * w_middle) : 1.0);
    }

    /// The factor by which budgets of errors are smaller where outlines may be. This factor exceeds
    /// 1 with smooth edges, which show outlines more exactly.
    double finer_outlines() const {
        return shading.antialias ? 1 + tolerance / l3d_widest_outline : 1;
    }

    std::int64_t budget() const {
        return most_samples > 0 ? most_samples : l3d_usual_samples(size, tolerance);
    }

    /// The same view with the camera's near plane, which errors of w have not pushed away.
    l3d_dice_view unlifted() const {
        l3d_dice_view result = *this;
        if (camera_near > 0)
            result.near = camera_near;
        return result;
    }

    /// The share of the view's errors that a point has. The magnitudes of the point's terms add up
    /// to `reach`.
    double share_of(double reach) const {
        return terms > 0 ? std::min((reach + eye_terms) / terms, 1.0) : 1.0;
    }

    /// The near plane for points that have this share of the errors. This plane keeps w above 32
    /// errors of w. Smaller w, and quotients by them, have too few certain digits.
    double near_of(double share) const {
        return std::max(camera_near > 0 ? camera_near : near, 32 * (share * error_w));
    }

    /// The same view for points that have this share of the errors.
    l3d_dice_view of_share(double share) const {
        l3d_dice_view result = *this;
        result.take_share(*this, share);
        return result;
    }

    /// Becomes whole.of_share(share). Expects: all else equals `whole`.
    void take_share(const l3d_dice_view& whole, double share) {
        near = whole.near_of(share);
        error_xy = whole.error_xy * share;
        error_w = whole.error_w * share;
        terms = whole.terms * share;
    }

    /// The largest chord error that is allowed if rounding of vertices already takes
    /// `vertex_error`. At least a quarter of the tolerance is left for chords, even if the bound
    /// then exceeds the tolerance. The budget is never less than a 16th of a sub-pixel, which moves
    /// hardly any vertex.
    double chord_budget(double vertex_error) const {
        constexpr double finest = 1.0 / (16 * l3d_subpixel_one);
        return std::max({tolerance - vertex_error, tolerance / 4, finest});
    }

    /// The farthest that balanced vertices (l3d_balance) may lie beside the surface. They move by
    /// at most the largest chord budget.
    double most_moved() const { return chord_budget(0); }

    /// The largest error that walking, by forward differences, may add to a vertex. Where walking
    /// would add more, the vertex is evaluated. Balanced chords along edges take up to 1 / (16
    /// l3d_balance) = 0.73 of half their budget. With an eighth for walking, the sum is within the
    /// tolerance while all other errors take less than a half.
    double walk_allowance() const { return tolerance / 8; }

    /// The walk allowance for vertices that are off by `exact` when they are evaluated. Chords get
    /// what this allowance and `exact` leave of the tolerance. So the allowance is at most an
    /// eighth of what `exact` leaves. The allowance is zero where chords would get less than a
    /// quarter of the tolerance.
    double walk_allowance(double exact) const {
        const double left = tolerance - exact;
        return std::max(0.0, std::min(left / 8, left - tolerance / 4));
    }

    /// The least exact w of the drawn part of a net whose least w is `least`. Steps are chosen so
    /// that the exact w is over half of a chord's w where the chord is in front of the near plane.
    double drawn_w(double least) const { return std::max(least, near / 2); }

    /// The largest allowed difference of a chord's w from the exact w, for a net whose least w is
    /// `least`. For a net in front of the near plane it is an eighth of `least`, which
    /// l3d_vertex_accuracy counts on. For other nets it is half of `near`.
    double depth_budget(double least) const { return least > near ? least / 8 : near / 2; }

    /// The largest extent in w of a net that is drawn as a point. It is an eighth of the net's
    /// distance, or in a parallel projection an eighth of the scene's depth.
    double depth_of_point(double least) const {
        return is_parallel() ? l3d_parallel_part * w_middle / 4 : depth_budget(least);
    }

    /// The box of the drawn points of a net whose exact points are in `hull`. Vertices of nets that
    /// are not small may lie beside the hull.
    l3d_image_box drawn_box(const l3d_image_box& hull) const {
        return l3d_is_small(hull) ? hull : hull.grown(most_moved());
    }

    l3d_image_box window() const {
        return {-size.width / 2.0, -size.height / 2.0, size.width / 2.0, size.height / 2.0};
    }

    /// The window's box around a part of the picture, in pixels from the picture's centre.
    l3d_image_box window(const l3d_pixel_box& part) const {
        const double x = -size.width / 2.0, y = -size.height / 2.0;
        return {x + part.left, y + part.top, x + part.right, y + part.bottom};
    }

    /// The window, grown by a pixel and by the distance that vertices may be moved. A thing outside
    /// of the margin touches no pixel centre, however its vertices are snapped to sub-pixels and
    /// balanced.
    l3d_image_box margin() const { return margin(window()); }

    /// The same margin around a part of the picture; strips along edges (edge_reach) are included.
    l3d_image_box margin(const l3d_image_box& part) const {
        return part.grown(1 + most_moved() + edge_reach);
    }

    /// Position of the picture's centre in 1/256 pixel; a half pixel is 128, so this is exact.
    std::int32_t centre_x() const { return size.width * (l3d_subpixel_one / 2); }
    std::int32_t centre_y() const { return size.height * (l3d_subpixel_one / 2); }
};

/// The farthest that a vertex may lie from the picture's centre, along x or y. Surfaces that reach
/// farther are clipped. The distance is the largest side of a picture, so the picture's borders are
/// at most half as far. 2^14 pixels are 2^22 sub-pixels: exact in a float, and half the
/// rasterizer's range. So the picture's centre, at most 2^13 pixels from its corner, still fits.
inline constexpr double l3d_guard_band = l3d_largest_side;

/// The largest number of steps in a strip. A piece or an edge that needs more steps is cut in
/// halves. Error bounds of the halves are tighter, and 32 steps keep a strip's round-off small in
/// every number type.
inline constexpr int l3d_most_steps_whole = 32;

#endif
