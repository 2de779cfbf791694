// SPDX-License-Identifier: MIT
// l3d_path: outlines of lines and curves, to be filled or stroked; sampled curves, strokes.
#ifndef L3D_RASTER_PATHS_PATH_H
#define L3D_RASTER_PATHS_PATH_H

#include "base/public.h"
#include "geom/bezier_patch.h"
#include "raster/placement_2d.h"
#include "raster/rasterizer_2d.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

/// A plane curve as a cubic in homogeneous coordinates: a point is (x / w, y / w).
///
/// Lines, quadratics, cubics, rational curves and arcs of ellipses all have this form exactly.
/// Units:   x / w and y / w in pixels.
/// Expects: weights above 0.
using l3d_curve_2d = l3d_bezier_curve<double, 3>;

/// The largest distance of a drawn curve from the exact one, in pixels. If the curves in a pixel
/// are two pixels long together, these errors and rounding to 8 bits change the pixel's coverage by
/// less than 1 / 255. See NUMERICS.md, section 20.
inline constexpr double l3d_flat_enough = 1.0 / 1024;

/// A path: outlines that begin with move_to, and continue with lines and curves.
///
/// When a path is filled, every outline counts as closed. A line or curve that follows no outline
/// begins a new outline at (0, 0).
/// Units:   pixels, as in l3d_rasterizer_2d: pixel (x, y) is sampled at (x, y), y down.
/// Lives:   a value; it owns its points.
/// Cost:    the memory of its points. Adding allocates if there are more points than ever before.
class L3D_PUBLIC l3d_path {
public:
    /// The kind of a piece. Each kind's comment tells how many points a piece adds.
    enum class kind : std::uint8_t {
        move,  ///< 1 point: the beginning of an outline
        line,  ///< 1 point: the line's end
        curve, ///< 3 points with weights: two control points and the curve's end
        close  ///< 0 points: a line back to the outline's beginning
    };

    /// Begins a new outline at a point.
    void move_to(l3d_point_2d to);
    /// Adds a straight line.
    void line_to(l3d_point_2d to);
    /// Adds a quadratic Bezier curve.
    void quadratic_to(l3d_point_2d control, l3d_point_2d to);
    /// Adds a cubic Bezier curve.
    void cubic_to(l3d_point_2d first, l3d_point_2d second, l3d_point_2d to);
    /// Adds a rational cubic. Its first point, the present end of the outline, has weight 1.
    /// Expects: weights between 1e-6 and 1e6.
    void rational_to(const std::array<l3d_point_2d, 3>& points,
                     const std::array<double, 3>& weights);
    /// Adds an arc of an ellipse, after a straight line to the arc's beginning. If no outline is
    /// open, an outline begins there, without this line.
    ///
    /// The arc's points are center + R(turn) (radii.x cos a, radii.y sin a), for a from begin to
    /// begin + sweep. The arc is exact: a rational curve for each quarter or less.
    /// Units:   degrees, clockwise as y points down.
    /// Expects: |sweep| at most 60 000.
    void arc_to(l3d_point_2d center, l3d_point_2d radii, double turn, double begin, double sweep);
    /// Closes the outline by a straight line to its beginning, and joins its ends.
    void close();

    /// Adds a full circle as an outline of its own.
    void add_circle(l3d_point_2d center, double radius);
    /// Adds the squares of whole pixels as an outline of its own. Filling it colours exactly these
    /// pixels. Adds nothing if the box is empty.
    void add_box(const l3d_pixel_box& box);
    /// Adds a polygon as an outline of its own. Adds nothing if it has no corner.
    void add_polygon(l3d_outline_2d corners);

    /// Adds the outlines of another path, with its points moved by a placement. The curves' weights
    /// stay, so curves are turned, stretched or slanted exactly.
    void add(const l3d_path& other, const l3d_placement_2d& place = {});

    /// Removes all outlines; the memory stays.
    void clear();
    /// Whether the path has no pieces.
    bool empty() const { return kinds_.empty(); }
    /// Whether all coordinates are numbers.
    bool is_number() const;

    /// Calls visit.move(point), visit.line(point), visit.curve(l3d_curve_2d) and visit.close() for
    /// the pieces in order. Coordinates beyond +-2^30 are clamped to this limit. If the visitor has
    /// a function lines(std::span<const l3d_point_2d>), that function gets the ends of many lines
    /// at once.
    template <class Visitor> void visit(Visitor& visitor) const;

private:
    static constexpr double most = 1 << 30;
    static l3d_point_2d within_reach(l3d_point_2d p) {
        return {std::clamp(p.x, -most, most), std::clamp(p.y, -most, most)};
    }
    bool all_within_reach() const {
        // As whole numbers, the bits of |x| keep their order, and NaN comes last. So the highest
        // bit of each difference tells whether x is beyond, and lanes only have to join these bits.
        constexpr auto limit = std::bit_cast<std::uint64_t>(most);
        const auto rest = [](double x) {
            return limit - std::bit_cast<std::uint64_t>(std::abs(x));
        };
        std::uint64_t beyond = 0;
        for (const l3d_point_2d& p : points_)
            beyond |= rest(p.x) | rest(p.y);
        return beyond >> 63 == 0;
    }
    static l3d_curve_2d::point weighted(l3d_point_2d p, double weight) {
        return {p.x * weight, p.y * weight, weight};
    }
    void begin_if_needed();

    std::vector<kind> kinds_;
    std::vector<l3d_point_2d> points_;
    std::vector<double> weights_; ///< the weights of curves, three for each curve
    l3d_point_2d first_{}, last_{};
    bool open_ = false; ///< whether an outline was begun and not closed
};

template <class Visitor> void l3d_path::visit(Visitor& visitor) const {
    constexpr bool takes_lines = requires {
        visitor.lines(std::span<const l3d_point_2d>());
    };
    bool many = false;
    if constexpr (takes_lines)
        many = all_within_reach();
    const l3d_point_2d* point = points_.data();
    const double* weight = weights_.data();
    l3d_point_2d last{};
    const auto go = [&](std::span<const l3d_point_2d> to) {
        if constexpr (takes_lines)
            visitor.lines(to);
        else
            visitor.line(to.front());
        last = to.back();
    };
    for (auto k = kinds_.begin(); k != kinds_.end(); ++k) {
        if (*k == kind::close) {
            visitor.close();
        } else if (*k == kind::curve) {
            visitor.curve(
                l3d_curve_2d{{weighted(last, 1), weighted(within_reach(point[0]), weight[0]),
                              weighted(within_reach(point[1]), weight[1]),
                              weighted(within_reach(point[2]), weight[2])}});
            weight += 3;
            last = within_reach(point[2]);
            point += 3;
        } else if (*k == kind::move) {
            last = within_reach(*point++);
            visitor.move(last);
        } else if (many) {
            const auto end = std::find_if(k, kinds_.end(), [](kind c) { return c != kind::line; });
            go({point, static_cast<std::size_t>(end - k)});
            point += end - k;
            k = end - 1;
        } else {
            const l3d_point_2d to = within_reach(*point++);
            go({&to, 1});
        }
    }
}

/// Evenly spaced points of a circle: the corners of a regular polygon with `resolution` sides. The
/// first corner is the rightmost one, and the next ones go towards larger y. The first corner is
/// not repeated at the end.
/// Expects: resolution >= 1.
inline std::vector<l3d_point_2d> l3d_sampled_circle(l3d_point_2d center, double radius,
                                                    int resolution) {
    std::vector<l3d_point_2d> result;
    for (int i = 0; i < resolution; ++i) {
        const double angle = 2 * std::numbers::pi * i / resolution;
        result.push_back(
            {center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
    }
    return result;
}

/// Points of a quadratic Bezier curve at t = 0, 1 / (n - 1), ..., 1, where n is `resolution`.
/// Expects: resolution >= 2.
inline std::vector<l3d_point_2d> l3d_sampled_quadratic(l3d_point_2d from, l3d_point_2d control,
                                                       l3d_point_2d to, int resolution) {
    std::vector<l3d_point_2d> result;
    for (int i = 0; i < resolution; ++i) {
        const double t = static_cast<double>(i) / (resolution - 1), s = 1 - t;
        result.push_back({s * s * from.x + 2 * s * t * control.x + t * t * to.x,
                          s * s * from.y + 2 * s * t * control.y + t * t * to.y});
    }
    return result;
}

/// The shape of the ends of open outlines and dashes.
enum class L3D_PUBLIC l3d_cap {
    butt,  ///< the stroke is cut off at the outline's end
    round, ///< the stroke goes on by half a disc beyond the end
    square ///< the stroke goes on by half a square beyond the end
};

/// The shape of a corner where two pieces of an outline meet.
enum class L3D_PUBLIC l3d_join {
    miter, ///< both outer sides are extended until they meet; beyond the miter limit, as bevel
    round, ///< the corner is covered by a disc around it
    bevel  ///< a straight line joins the ends of both outer sides
};

/// The pen that strokes a path.
struct L3D_PUBLIC l3d_stroke {
    double width = 1;                ///< the pen's width in pixels; more than 2^30 counts as 2^30
    l3d_cap cap = l3d_cap::butt;     ///< the shape of the ends of outlines and dashes
    l3d_join join = l3d_join::miter; ///< the shape of corners
    /// The longest miter, from the inner to the outer corner, in multiples of the pen's width.
    double miter_limit = 4;
    /// Lengths of a dash, a gap, a dash and so on, repeated; empty: no gaps. With an odd number of
    /// lengths, dashes and gaps change places in each repetition.
    /// Units: pixels along the path.
    std::vector<double> dashes{};
    /// The distance into the pattern of dashes at which an outline begins, in pixels.
    double dash_begin = 0;
};

/// The outline of the area that a pen covers along a path. Fill it with l3d_winding::nonzero.
///
/// Curves become chords within l3d_flat_enough. Chords of a curve meet in round joins, so the
/// border of the covered area along the curve is within twice l3d_flat_enough. Ends of curves, and
/// ends of dashes on curves, are square to the curve.
///
/// A corner that turns very little has one point on either side, whatever the join. The reason is
/// that a disc's arc at this corner is within l3d_flat_enough of its chord. Round joins at other
/// corners, and round caps, become chords that enclose the same area as their arcs. These chords
/// change the area of no pixel by more than l3d_flat_enough.
///
/// An outline of a single point shows a round or a square cap. A very short outline is complete
/// even where its lines turn by half a turn. If a closed outline begins within a dash, its first
/// and last dash are joined. A dash of length 0 shows a cap as a single point does, and a square
/// cap is turned along the path.
/// Expects: numbers; width at least 0; lengths of dashes at least 0, with a sum of 1e-3 or more.
///          Otherwise the result is empty.
/// Cost:    linear in chords and dashes, of which there are at most 10^6. If a path would have
///          more, chords and dashes outside of a picture of the largest size are left out first.
L3D_PUBLIC l3d_path l3d_stroked(const l3d_path& path, const l3d_stroke& pen);

#endif
