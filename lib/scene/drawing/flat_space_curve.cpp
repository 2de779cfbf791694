// SPDX-License-Identifier: MIT
// flat_space_curve: cuts Bezier curves until their control points are near chords.
#include "scene/drawing/flat_space_curve_p.h"

#include "geom/transform.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace {

using l3d_detail::depth_chord;
using l3d_detail::depth_law;
using l3d_detail::depth_point;

/// A control point: x, y, their divisor, and the depth times the divisor. The pixel is the
/// picture's centre plus the quotients of the first two by the third.
using point = l3d_vector<double, 4>;
using bezier = std::vector<point>;

class flattener {
public:
    flattener(const l3d_camera& camera, l3d_size size, double width, double tolerance,
              const depth_law& law, const point& section)
        : section_(section), near_(camera.near_z), far_(camera.far_z), law_(law),
          centre_x_(size.width / 2.0), centre_y_(size.height / 2.0),
          margin_(width / 2 + 1), // beyond the reach of smooth edges, width / 2 + 1 / 2
          tolerance_(tolerance) {}

    void add(const bezier& of, int halvings) {
        for (int plane = 0; plane < planes; ++plane)
            if (std::ranges::all_of(of, [&](const point& p) { return inside(plane, p) < 0; }))
                return;
        constexpr int most_halvings = 16;
        if (of.size() == 2 || halvings == most_halvings || is_flat(of)) {
            add_chord(of.front(), of.back());
            return;
        }
        // De Casteljau's scheme at 1/2: the sides of the triangle are the halves.
        bezier low{of.front()}, high = of;
        for (std::size_t left = of.size() - 1; left > 0; --left) {
            for (std::size_t i = 0; i < left; ++i)
                high[i] = (high[i] + high[i + 1]) * 0.5;
            low.push_back(high.front());
        }
        add(low, halvings + 1);
        add(high, halvings + 1);
    }

    std::vector<depth_chord> take() { return std::move(chords_); }

private:
    static constexpr int planes = 7;

    /// A linear function of a control point that is not negative on the inner side of a plane. The
    /// planes are near and far, the sides of the picture with its margin, and the section.
    double inside(int plane, const point& p) const {
        if (plane < 2 && law_.step != 0)
            return 1;
        switch (plane) {
        case 0:
            return p[2] - near_ * p[3];
        case 1:
            return far_ * p[3] - p[2];
        case 2:
            return (centre_x_ + margin_) * p[2] + p[0];
        case 3:
            return (centre_x_ + margin_) * p[2] - p[0];
        case 4:
            return (centre_y_ + margin_) * p[2] + p[1];
        case 5:
            return (centre_y_ + margin_) * p[2] - p[1];
        default:
            return l3d_dot(section_, p);
        }
    }

    depth_point projected(const point& p) const {
        // In a parallel projection, surfaces have depths from 1 to 1.25. Points far behind all
        // surfaces would have depths of 0 and less. They get the least depth instead, which is
        // behind all surfaces, too.
        constexpr double least = 0x1p-20;
        const double depth = p[3] / p[2];
        return {centre_x_ + p[0] / p[2], centre_y_ + p[1] / p[2],
                law_.step != 0 ? std::max(depth, least) : depth};
    }

    bool is_flat(const bezier& of) const {
        if (std::ranges::any_of(of, [&](const point& p) { return inside(0, p) <= 0; }))
            return false;
        const depth_point a = projected(of.front()), b = projected(of.back());
        const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
        return std::ranges::all_of(of, [&](const point& p) {
            const depth_point c = projected(p);
            const double along = (c.x - a.x) * dx + (c.y - a.y) * dy;
            const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
            const double depth = a.depth + t * (b.depth - a.depth);
            return std::hypot(c.x - a.x - t * dx, c.y - a.y - t * dy) <= tolerance_ &&
                   std::abs(c.depth - depth) <= tolerance_ * law_.per_pixel(depth);
        });
    }

    void add_chord(const point& from, const point& to) {
        double first = 0, last = 1;
        for (int plane = 0; plane < planes; ++plane) {
            const double a = inside(plane, from), b = inside(plane, to);
            if (a < 0 && b < 0)
                return;
            if (a < 0)
                first = std::max(first, a / (a - b));
            else if (b < 0)
                last = std::min(last, a / (a - b));
        }
        if (first < last)
            chords_.push_back(
                {projected(from + (to - from) * first), projected(from + (to - from) * last)});
    }

    point section_;
    double near_, far_;
    depth_law law_;
    double centre_x_, centre_y_, margin_, tolerance_;
    std::vector<depth_chord> chords_;
};

/// The factors of a control point's four numbers in the point's distance from the section, times
/// its weight. Four rows map places of the world to these numbers: x, y and w of `image`, and
/// `depth`.
point seen_section(const l3d_plane<double>& section, const l3d_matrix<double>& image,
                   const point& depth) {
    l3d_matrix<double> rows = image;
    for (int i = 0; i < 4; ++i) {
        rows(2, i) = image(3, i);
        rows(3, i) = depth[i];
    }
    const auto to_world = l3d_inverted(rows);
    if (!to_world) // the camera is so far that no depths differ
        return {0.0, 0.0, 0.0, 0.0};
    return l3d_transposed(*to_world) *
           point{section.normal[0], section.normal[1], section.normal[2], section.d};
}

} // namespace

std::vector<depth_chord>
l3d_detail::flat_space_curve(const l3d_space_curve& curve, const l3d_camera& camera, l3d_size size,
                             double tolerance, const depth_law& law,
                             const std::optional<l3d_plane<double>>& section) {
    const l3d_matrix<double> to_image = camera.image_matrix(size) * curve.placement();
    // The row that gives a place's depth times the divisor. In a parallel projection, the depth is
    // linear in the place.
    const l3d_vector<double, 3> forward = camera.axes().forward;
    const double at_origin = law.base - law.step * l3d_dot(forward, camera.eye);
    const point at_depth = law.step == 0 ? point{0.0, 0.0, 0.0, 1.0}
                                         : point{law.step * forward[0], law.step * forward[1],
                                                 law.step * forward[2], at_origin};
    const point cut = section ? seen_section(*section, camera.image_matrix(size), at_depth)
                              : point{0.0, 0.0, 0.0, 0.0};
    flattener result(camera, size, curve.width(), tolerance, law, cut);
    for (const l3d_space_curve::bezier& span : curve.spans()) {
        bezier seen;
        for (const l3d_vector<double, 4>& p : span) {
            const l3d_vector<double, 4> q = to_image * p, at = curve.placement() * p;
            const double along = forward[0] * at[0] + forward[1] * at[1] + forward[2] * at[2];
            seen.push_back(
                {q[0], q[1], q[3], law.step == 0 ? p[3] : at_origin * p[3] + law.step * along});
        }
        result.add(seen, 0);
    }
    return result.take();
}
