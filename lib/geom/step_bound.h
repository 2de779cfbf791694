// SPDX-License-Identifier: MIT
// Bounds on the image error of straight pieces of rational cubic curves and bicubic patches.
#ifndef L3D_GEOM_STEP_BOUND_H
#define L3D_GEOM_STEP_BOUND_H

#include "geom/bezier_patch.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>

/// A homogeneous image point (x, y, w). The pixel is (x / w, y / w), counted from the picture's
/// centre. w > 0 is the distance along the view axis (times a constant).
using l3d_image_point = l3d_vector<double, 3>;
using l3d_image_curve = l3d_bezier_curve<double, 3>;
using l3d_image_patch = l3d_bezier_patch<double, 3>;

/// An axis-aligned rectangle of the image. Units: pixels from the picture's centre.
struct l3d_image_box {
    double left = 0, top = 0, right = 0, bottom = 0;

    bool empty() const { return !(left <= right && top <= bottom); }
    double width() const { return right - left; }
    double height() const { return bottom - top; }

    l3d_image_box intersected(const l3d_image_box& other) const {
        return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
                std::min(bottom, other.bottom)};
    }

    l3d_image_box grown(double by) const { return {left - by, top - by, right + by, bottom + by}; }

    /// Largest |x| or |y| in the box.
    double reach() const { return std::max({-left, -top, right, bottom}); }
};

/// The least and the largest w of a net's control points, which bound w on its curve or patch.
struct l3d_depth_range {
    double least = 0, most = 0;
};
l3d_depth_range l3d_depth_range_of(std::span<const l3d_image_point> net);

/// The box of the projected control points, which holds the whole curve or patch.
/// Expects: every w > 0.
l3d_image_box l3d_image_box_of(std::span<const l3d_image_point> net);

/// Whether a net lies wholly beyond one side of `box`, or wholly at w <= near or w >= far. The
/// net's curve or patch then cannot be seen. The test is made on homogeneous half-spaces, so it
/// holds for points at and behind the eye too.
bool l3d_outside(std::span<const l3d_image_point> net, const l3d_image_box& box, double near,
                 double far = std::numeric_limits<double>::infinity());

/// A control net with its depth range and its box. Either is computed when it is first asked for,
/// and then kept.
/// Expects: the net's points do not change afterwards.
class l3d_image_net : public l3d_image_patch {
public:
    l3d_image_net() = default;
    l3d_image_net(const l3d_image_patch& net) : l3d_image_patch(net) {}

    const l3d_depth_range& w() const { return w_ ? *w_ : w_.emplace(l3d_depth_range_of(points)); }

    /// Expects: every w > 0.
    const l3d_image_box& box() const {
        return box_ ? *box_ : box_.emplace(l3d_image_box_of(points));
    }

private:
    mutable std::optional<l3d_depth_range> w_;
    mutable std::optional<l3d_image_box> box_;
};

/// Largest distances in the picture between neighbouring control points, along u and along v. A
/// distance is the larger of the differences in x and in y.
/// Expects: every w > 0.
/// Units: pixels.
std::array<double, 2> l3d_image_gaps_of(const l3d_image_patch& net);

/// Bounds of the second derivatives of a piece of a curve or patch as seen in the image. The
/// derivatives are taken by the piece's own parameters. The bounds limit the error of drawing the
/// piece in straight steps.
///
/// Instead of the surface, the interpolant L of homogeneous points is drawn, whose image X0 lies
/// inside `visible`. With S = (x, y, w) the exact point of the same parameters,
///     S / w - X0 = (x - X0 w) / w = ((x - Lx) - X0 (w - Lw)) / w,
/// and linear interpolation over a step h leaves |f - Lf| <= h^2 / 8 max |f''|. For a cubic, f'' is
/// 6 times a convex combination of second differences of control points (9 times for the mixed
/// derivative), so
///     uu = 6 max ( |D2 (x, y) - C D2 w| + r |D2 w| ) / w_low
/// with C, r the centre and half diagonal of `visible`, in which X0 lies.
/// Units:  pixels.
/// Source: the polynomial case is Filip, Magedson, Markot, Surface Algorithms using Bounds on
///         Derivatives, CAGD 3, 1986; the homogeneous form is derived above.
struct l3d_second_bounds {
    double uu = 0, uv = 0, vv = 0;

    /// A bound of the error of a convex micro-quad (a bilinear piece) with steps 1/nu by 1/nv. The
    /// bound also holds for a folded quad, which is drawn as four triangles around its centre. Let
    /// s and t run from 0 to 1 over the quad. On each triangle, s t differs from its linear
    /// interpolant by at most 1/16. The coefficient of s t is the mixed difference, at most uv /
    /// (nu nv).
    double quad_error(int nu, int nv) const {
        const double hu = 1.0 / nu, hv = 1.0 / nv;
        return (uu * hu * hu + vv * hv * hv) / 8 + uv * hu * hv / 16;
    }

    /// A bound of the error of two triangles that are drawn in place of the quad. On each of them,
    /// s t differs from its linear interpolant by at most 1/4.
    double triangle_error(int nu, int nv) const {
        const double hu = 1.0 / nu, hv = 1.0 / nv;
        return (uu * hu * hu + vv * hv * hv) / 8 + uv * hu * hv / 4;
    }
};

/// Bounds of mixed third and fourth derivatives as seen in the image. The bounds are derived like
/// l3d_second_bounds: 18 and 36 times the largest differences of the control points.
struct l3d_mixed_bounds {
    double uuv = 0, uvv = 0, uuvv = 0;
};
l3d_mixed_bounds l3d_mixed_bounds_of(const l3d_image_patch& patch, const l3d_image_box& visible,
                                     double w_low);

/// The bounds of a patch's second derivatives.
/// Expects: w_low > 0, a lower bound of w wherever something is drawn; `visible` not empty.
l3d_second_bounds l3d_second_bounds_of(const l3d_image_patch& patch, const l3d_image_box& visible,
                                       double w_low);

/// The bound of a curve's second derivative as seen in the image. A chord over a step 1/n errs by
/// at most result / (8 n^2).
double l3d_second_bound_of(const l3d_image_curve& curve, const l3d_image_box& visible,
                           double w_low);

/// The bound of a curve's second derivative in space, across the curve's own direction. A chord
/// over a step 1/n lies within result / (8 n^2) of the curve. The chord's distance along the normal
/// of any surface through the curve is no larger.
/// Units: pixels at w_low. `focal` is the number of pixels that a length of 1 has at distance 1.
double l3d_space_bound_of(const l3d_image_curve& curve, double focal, double w_low);

/// Bounds of the difference of w between a patch or curve and its interpolant, which is at most
/// (result.uu / nu^2 + result.vv / nv^2) / 8 + result.uv / (4 nu nv).
/// Units: those of w.
l3d_second_bounds l3d_depth_bounds_of(const l3d_image_patch& patch);
double l3d_depth_bound_of(const l3d_image_curve& curve);

/// How far balanced vertices lie off a curve f that is drawn in n >= 2 chords, in units of h^2 f''
/// with h = 1 / n. Vertices between the curve's ends move to its outer side, so chords err to both
/// sides.
///
/// Let y be this number. Where both ends of a chord are moved, it errs at s of its length by
///     h^2 f'' ( s (1 - s) / 2 - y ),   from -y to 1/8 - y times h^2 f''.
/// Where one end is not moved, as at the curve's ends, it errs by at most (1/2 - y)^2 / 2 times h^2
/// f''. (1/2 - y)^2 / 2 = y has the root (3 - sqrt 8) / 2: then neither error is larger than y.
/// Where f'' changes along the chord, |f - Lf| is at most a weighted sum of |f''| at both ends,
/// whose weights add up to no more than y.
inline constexpr double l3d_balance = 0.0857864376269049512;

/// The factor c in the bound of chord errors, c max |f''|, of a balanced curve in n steps. A single
/// step has no vertex to move, so its c is 1/8.
constexpr double l3d_balanced_error(int n) {
    return n == 1 ? 1.0 / 8 : l3d_balance / (static_cast<double>(n) * n);
}

/// The factor by which coordinates of balanced vertices may exceed those of the net, if each
/// quarter of the patch has at least two steps. Then h is at most 1/8. Vertices move by at most
/// l3d_balance / 64 times second derivatives, along u and along v, and by both. These derivatives
/// are at most 6 * 4 times the net's largest value. So the factor is at most 1.0322^2 < 1 + 1/15.
inline constexpr double l3d_balanced_reach = 1 + 1.0 / 15;

/// The curve f - (l3d_balance / n^2) f'', on which the balanced vertices lie; f itself for n = 1.
l3d_image_curve l3d_balanced(const l3d_image_curve& f, int n);

/// Bound of the image error of a vertex whose x and y err by e_xy each, and w by e_w. Each image
/// coordinate X errs by at most (e_xy + |X| e_w) / (w - e_w), so the vertex errs by at most sqrt(2)
/// times this bound.
/// Units:   reach: pixels, at least the largest |X|, as l3d_image_box::reach gives it.
/// Expects: e_w < w_least.
double l3d_vertex_error(double e_xy, double e_w, double reach, double w_least);

#endif
