// SPDX-License-Identifier: MIT
// l3d_strip_error: measures distances of drawn corners, which bound those of all points between
// them.
#include "dice/edges/shared_polylines.h"

#include "dice/snap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using place = l3d_vector<double, 3>;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// The point on the segment `from` `to` that is nearest to p.
place nearest_to(const place& p, const place& from, const place& to) {
    const place way = to - from;
    const double square = l3d_dot(way, way);
    return square > 0 ? from + way * std::clamp(l3d_dot(p - from, way) / square, 0.0, 1.0) : from;
}

/// Coordinates of places relative to a straight line: one along it, and two across it.
class line_frame {
public:
    line_frame(const place& from, const place& to) : from_(from), length_(l3d_length(to - from)) {
        if (length_ > 0)
            axes_[0] = (to - from) / length_;
        const bool is_along_z = std::abs(axes_[0][2]) > 0.5;
        const place other = is_along_z ? place{1.0, 0.0, 0.0} : place{0.0, 0.0, 1.0};
        axes_[1] = l3d_normalized(l3d_cross<double>(axes_[0], other));
        axes_[2] = l3d_cross<double>(axes_[0], axes_[1]);
    }

    double length() const { return length_; }
    place of(const place& p) const {
        const place way = p - from_;
        return {l3d_dot(way, axes_[0]), l3d_dot(way, axes_[1]), l3d_dot(way, axes_[2])};
    }

private:
    place from_;
    double length_;
    place axes_[3] = {{1.0, 0.0, 0.0}, {}, {}};
};

/// A strip, and the polyline's chords beside it. The chords begin or end at the polyline's points
/// `first` to `last`, and the last chord ends at `end`.
struct strip {
    const l3d_shared_polyline& line;
    std::size_t first, last, end;
    const l3d_clip_vertex &a, &b;
};

/// Finds the sides of the visible region beyond which a corner lies. The result has a bit for each
/// side.
unsigned sides_beyond(const l3d_clip_vertex& v, const l3d_image_box& window,
                      const l3d_dice_view& view) {
    const double x = v.h[0], y = v.h[1], w = v.h[2];
    return unsigned{x < window.left * w} | unsigned{x > window.right * w} << 1 |
           unsigned{y < window.top * w} << 2 | unsigned{y > window.bottom * w} << 3 |
           unsigned{w <= view.near} << 4 | unsigned{w >= view.far} << 5;
}

/// Whether all of a strip lies beyond one side of the visible region.
bool is_unseen(const strip& of, const l3d_dice_view& view) {
    const l3d_image_box window = view.window();
    unsigned beyond = sides_beyond(of.a, window, view);
    if (beyond != 0)
        beyond &= sides_beyond(of.b, window, view);
    for (std::size_t i = of.first; i <= of.last && beyond != 0; ++i)
        beyond &= sides_beyond(of.line.points[i], window, view);
    return beyond != 0;
}

/// Bounds how far points of a strip are from the polyline, in the picture or in space (NUMERICS,
/// section 27, Distances of strips).
///
/// The triangle before an inner point of the polyline is near the first chord. The other triangles
/// are near a part of the polyline. This part runs from the polyline's place nearest to a to its
/// place nearest to b. For each point of these triangles, the part of the polyline has a point that
/// is as far along the line between the two places. Across this line, the two points differ by no
/// more than corners do.
double width_of(const strip& of, const l3d_strip_corner& a, const l3d_strip_corner& b,
                place l3d_strip_corner::*in) {
    const auto point = [&](std::size_t i) -> const place& { return of.line.corners[i].*in; };
    const bool has_inner = of.last > of.first;
    const place begin = point(of.first);
    const place from = nearest_to(a.*in, begin, point(has_inner ? of.first + 1 : of.end));
    const place to = nearest_to(b.*in, has_inner ? point(of.last) : begin, point(of.end));
    const double first_off = l3d_length(a.*in - from);
    if (!has_inner)
        return std::max(first_off, l3d_length(b.*in - to));
    const line_frame along(from, to);
    double beyond = 0;
    place least{0.0, 0.0, 0.0}, most{0.0, 0.0, 0.0};
    const auto take = [&](const place& p) {
        beyond = std::max({beyond, -p[0], p[0] - along.length()});
        least = {0.0, std::min(least[1], p[1]), std::min(least[2], p[2])};
        most = {0.0, std::max(most[1], p[1]), std::max(most[2], p[2])};
    };
    for (std::size_t i = of.first + 1; i <= of.last; ++i)
        take(along.of(point(i)));
    take(along.of(a.*in));
    take(along.of(b.*in));
    return std::max(first_off, l3d_length(most - least + place{beyond, 0.0, 0.0}));
}

} // namespace

l3d_strip_corner::l3d_strip_corner(const l3d_clip_vertex& at, const l3d_dice_view& view) {
    constexpr double one = l3d_subpixel_one;
    const l3d_micro_vertex& drawn = at.dice.vertex;
    const double w = at.drawable ? view.w_at(drawn.inv_w) : at.h[2];
    picture = at.drawable
                  ? place{(drawn.x - view.centre_x()) / one, (drawn.y - view.centre_y()) / one, 0.0}
                  : place{at.h[0] / w, at.h[1] / w, 0.0};
    space = {picture[0] * w, picture[1] * w, view.focal * w};
}

l3d_drawn_distance l3d_strip_error(const l3d_shared_polyline& line, std::size_t first,
                                   std::size_t last, const l3d_clip_vertex& a,
                                   const l3d_clip_vertex& b, const l3d_dice_view& view) {
    const bool goes_on =
        last + 1 < line.points.size() && std::isfinite(line.chords[last + 1].places);
    const strip of{line, first, last, goes_on ? last + 1 : last, a, b};
    if (is_unseen(of, view))
        return {};
    l3d_drawn_distance result;
    double nearest = std::min({a.h[2], b.h[2], line.points[first].h[2]});
    for (std::size_t i = first + 1; i <= of.end; ++i) {
        result.add(line.chords[i]);
        nearest = std::min(nearest, line.points[i].h[2]);
    }
    if (nearest <= l3d_measured_near(view) || !std::isfinite(result.places))
        return {infinite, infinite};
    const l3d_strip_corner at_a(a, view), at_b(b, view);
    const double snap = l3d_snap_error<double>(view.window().reach());
    result.places += width_of(of, at_a, at_b, &l3d_strip_corner::picture) + snap;
    if (view.focal == 0)
        return result;
    const double width = width_of(of, at_a, at_b, &l3d_strip_corner::space) / nearest;
    result.depth = width + (result.depth + snap + view.depth_rounding()) * (1 + width / view.focal);
    return result;
}
