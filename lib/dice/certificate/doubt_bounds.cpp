// SPDX-License-Identifier: MIT
// l3d_doubt_bounds: bounds a piece's picture, facing, light and depth by its control points.
#include "dice/certificate/doubt_bounds.h"

#include "dice/certificate/doubt_cosines_p.h"

#include <algorithm>
#include <cmath>

namespace {

using vector = l3d_normal_polynomial::vector;

using l3d_detail::infinite, l3d_detail::line_of, l3d_detail::put, l3d_detail::rounding;
using l3d_detail::plane, l3d_detail::seen_normals, l3d_detail::cosines;

struct place {
    double x = 0, y = 0;
};

place projected(const l3d_image_point& p) {
    return {p[0] / p[2], p[1] / p[2]};
}

/// The linear functions of a piece's parameters that are near to x and y in the picture, and a
/// bound of their error.
struct linear_picture {
    plane x, y;
    double off = 0; ///< largest distance of the piece's picture from these planes, in pixels

    /// Bounds the distance of the picture from the linear function with value X. The distance is
    /// the sum B_i (x_i - X w_i) over w. With d_i = x_i - X_i w_i, and as sum B_i X_i = X, the sum
    /// equals sum B_i d_i + sum B_i (X_i - X) (w_i - w_mean).
    linear_picture(const l3d_image_patch& net, double least_w, double most_w)
        : linear_picture(projected(net.at(0, 0)), projected(net.at(0, 3)), projected(net.at(3, 0)),
                         projected(net.at(3, 3))) {
        double most = 0;
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column) {
                const l3d_image_point& p = net.at(row, column);
                const double u = column / 3.0 - 0.5, v = row / 3.0 - 0.5;
                const double off_x = p[0] - x.at(u, v) * p[2], off_y = p[1] - y.at(u, v) * p[2];
                most = std::max(most, off_x * off_x + off_y * off_y);
            }
        const double widest = std::hypot(x.range(), y.range());
        off = (std::sqrt(most) + widest * (most_w - least_w) / 2) / least_w;
    }

private:
    linear_picture(place a, place b, place c, place d)
        : x(a.x, b.x, c.x, d.x), y(a.y, b.y, c.y, d.y) {}
};

/// Bounds of f = n.(S - E) over a piece, and of the normals' length, for normals n at points S and
/// the eye E. Where f is 0, the surface folds over in the picture.
struct facing_range {
    double least = -infinite, most = infinite, longest = 0;
    double smallest() const { return std::max(least, -most); }
};

/// Bounds f = n.(S - E) over a piece. With the middle C of the piece's points, f is n.(C - E) +
/// n.(S - C). Along the normals' axis, S - C is nearly nothing.
facing_range facing_of(const l3d_doubt_piece& p, const seen_normals& normals,
                       const l3d_doubt_view& view) {
    const auto& [of_x, of_y, of_w] = view.world_of_image;
    l3d_bezier_patch<double, 3> seen;
    for (std::size_t i = 0; i < seen.points.size(); ++i) {
        const l3d_image_point& q = p.net.points[i];
        seen.points[i] = of_x * q[0] + of_y * q[1] + of_w * q[2];
    }
    const double point_off =
        (l3d_length(of_x) + l3d_length(of_y)) * p.of->error_xy + l3d_length(of_w) * p.of->error_w;
    const auto [low, high] = seen.bounds();
    const vector middle = (low + high) * 0.5;
    double along = 0, reach = 0;
    for (const vector& s : seen.points) {
        const vector from_middle = s - middle;
        along = std::max(along, std::abs(l3d_dot(normals.axis, from_middle)));
        reach = std::max(reach, l3d_dot(from_middle, from_middle));
    }
    reach = std::sqrt(reach);
    facing_range result{infinite, -infinite, normals.longest + p.of->normal_off};
    for (const vector& n : p.normals.points) {
        const double f = l3d_dot(n, middle);
        result.least = std::min(result.least, f);
        result.most = std::max(result.most, f);
    }
    const double distance = l3d_length(middle) + reach;
    const double off = normals.most_along * along + normals.most_across * reach +
                       result.longest * (point_off + rounding * distance) +
                       (p.of->normal_off + p.of->turned * result.longest) * distance;
    result.least -= off;
    result.most += off;
    return result;
}

/// The range of parameters that a box covers in the linear picture of a piece, as the range's
/// middle and how far it reaches from the middle.
struct parameter_box {
    double u, v, reach_u, reach_v;

    parameter_box(const l3d_doubt_bounds& b, const l3d_image_box& box) {
        const double x = (box.left + box.right) / 2 - b.at_x;
        const double y = (box.top + box.bottom) / 2 - b.at_y;
        const double reach_x = box.width() / 2, reach_y = box.height() / 2;
        const auto& to = b.parameters;
        u = to[0] * x + to[1] * y;
        v = to[2] * x + to[3] * y;
        reach_u = std::abs(to[0]) * reach_x + std::abs(to[1]) * reach_y;
        reach_v = std::abs(to[2]) * reach_x + std::abs(to[3]) * reach_y;
    }
};

/// Bounds the relative difference of w between the drawn and the exact surface.
///
/// A drawn point lies on a plane that is off by d pixels along the piece's normal, and its place is
/// off by b pixels. On that plane 1 / w is n.ray(X) / (n.Q + d). So w differs by the part (b + d)
/// |n| |ray'| w / (n.Q). Dicing chooses steps so that this part is never more than an eighth.
double w_margin_of(const l3d_doubt_view& view, const facing_range& facing, double most_w) {
    constexpr double most = 0.25;
    const double a_pixel =
        std::max(l3d_length(view.world_of_image[0]), l3d_length(view.world_of_image[1])) * most_w;
    const double part =
        facing.longest * a_pixel * (view.bound_px + view.depth_bound_px) / facing.smallest();
    return part >= 0 && part < most / 2 ? part / (1 - part) : most;
}

void put_parameters(l3d_doubt_bounds& b, const linear_picture& picture) {
    const double det = picture.x.in_u * picture.y.in_v - picture.x.in_v * picture.y.in_u;
    b.parameters = {picture.y.in_v / det, -picture.x.in_v / det, -picture.y.in_u / det,
                    picture.x.in_u / det};
    b.u_off = std::hypot(b.parameters[0], b.parameters[1]) * b.picture_off + rounding;
    b.v_off = std::hypot(b.parameters[2], b.parameters[3]) * b.picture_off + rounding;
    if (!(b.u_off + b.v_off < infinite)) {
        b.parameters = {};
        b.u_off = b.v_off = infinite;
    }
}

void put_levels(l3d_doubt_bounds& b, const cosines& c) {
    if (b.facing == 0) {
        const double most = l3d_cosine_level * std::max(c.most, -c.least);
        return put(b.level, -l3d_cosine_level, most, {.off = infinite});
    }
    const double sign = b.facing > 0 ? -l3d_cosine_level : l3d_cosine_level;
    const plane line = c.line.times(sign);
    put(b.level, std::min(sign * c.least, sign * c.most), std::max(sign * c.least, sign * c.most),
        b.u_off < infinite ? line_of(line, l3d_cosine_level * c.off, b)
                           : l3d_doubt_line{.off = infinite});
}

void put_w(l3d_doubt_bounds& b, const l3d_image_patch& net, double error_w) {
    const plane line(net.at(0, 0)[2], net.at(0, 3)[2], net.at(3, 0)[2], net.at(3, 3)[2]);
    double off = 0;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            off = std::max(off, std::abs(net.at(row, column)[2] -
                                         line.at(column / 3.0 - 0.5, row / 3.0 - 0.5)));
    off += error_w + rounding * b.w.most;
    put(b.w, b.w.least, b.w.most,
        b.u_off < infinite ? line_of(line, off, b) : l3d_doubt_line{.off = infinite});
}

} // namespace

/// Tells whether the piece may reach a box. At each place, the piece's parameters differ from the
/// linear picture's parameters by at most u_off and v_off. The piece misses a box that lies farther
/// than this difference beyond one of the piece's four sides.
bool l3d_doubt_bounds::touches(const l3d_image_box& other) const {
    if (box.intersected(other).empty())
        return false;
    if (!(u_off + v_off < infinite))
        return true;
    const parameter_box p(*this, other);
    return std::abs(p.u) <= 0.5 + u_off + p.reach_u && std::abs(p.v) <= 0.5 + v_off + p.reach_v;
}

bool l3d_doubt_bounds::may_end_in(const l3d_image_box& other) const {
    if (may_end || open_sides == 0)
        return may_end;
    if (!(u_off + v_off < infinite))
        return true;
    const parameter_box p(*this, other);
    const auto reaches = [&](unsigned side, double at, double off) {
        return (open_sides >> side & 1) != 0 && std::abs(at) <= off;
    };
    return reaches(0, p.v + 0.5, v_off + p.reach_v) || reaches(1, p.u - 0.5, u_off + p.reach_u) ||
           reaches(2, p.v - 0.5, v_off + p.reach_v) || reaches(3, p.u + 0.5, u_off + p.reach_u);
}

std::array<double, 2> l3d_doubt_bounds::range(const l3d_doubt_line& of,
                                              const l3d_image_box& in) const {
    const l3d_image_box part = box.intersected(in);
    const double middle =
        of.at((part.left + part.right) / 2 - at_x, (part.top + part.bottom) / 2 - at_y);
    double off = of.off;
    if (of.along_x != 0 || of.along_y != 0)
        off += (std::abs(of.along_x) * part.width() + std::abs(of.along_y) * part.height()) / 2;
    return {std::max(of.least, middle - off), std::min(of.most, middle + off)};
}

l3d_doubt_bounds l3d_bounds_of(const l3d_doubt_piece& piece, const l3d_doubt_view& view) {
    l3d_doubt_bounds b;
    const l3d_doubt_patch& of = *piece.of;
    const l3d_depth_range& w = piece.net.w();
    b.w.least = w.least - of.error_w;
    b.w.most = w.most + of.error_w;
    b.may_end = piece.there == l3d_doubt_piece::left::part || !(b.w.least > of.near) ||
                !(b.w.most < view.view.far);
    if (!(b.w.least > 0)) {
        b.box = {-infinite, -infinite, infinite, infinite};
        b.w_margin = 1;
        b.u_off = b.v_off = infinite;
        put(b.level, -l3d_cosine_level, l3d_cosine_level, {.off = infinite});
        put(b.w, 0, b.w.most, {.off = infinite});
        return b;
    }
    const l3d_image_box& hull = piece.net.box();
    const double pad = l3d_vertex_error(of.error_xy, of.error_w, hull.reach(), w.least) +
                       rounding * (view.view.size.width + view.view.size.height + hull.reach());
    const double x = view.view.size.width / 2.0, y = view.view.size.height / 2.0;
    b.box = l3d_image_box{hull.left + x, hull.top + y, hull.right + x, hull.bottom + y}.grown(pad);
    for (std::size_t side = 0; side < l3d_side_pairs::sides; ++side)
        if (of.sides->at(of.patch, side).is == l3d_side_pairs::kind::open && piece.reaches(side))
            b.open_sides |= 1U << side;
    const seen_normals normals(piece.normals.points);
    const facing_range facing = facing_of(piece, normals, view);
    b.facing = facing.least > 0 ? 1 : facing.most < 0 ? -1 : 0;
    b.may_be_missing = of.one_sided && b.facing * of.back >= 0;
    b.w_margin = w_margin_of(view, facing, b.w.most);
    const linear_picture picture(piece.net, w.least, w.most);
    b.point_off = pad;
    b.picture_off = picture.off + pad;
    b.at_x = picture.x.middle + x;
    b.at_y = picture.y.middle + y;
    put_parameters(b, picture);
    if (of.lighting)
        l3d_detail::put_lamps(b, piece, normals, view);
    else
        put_levels(b, cosines(piece, normals, view.light));
    put_w(b, piece.net, of.error_w);
    return b;
}
