// SPDX-License-Identifier: MIT
// Bounds image errors by second differences of control nets.
#include "geom/step_bound.h"

#include <cmath>

namespace {

using point = l3d_image_point;

point second_difference(const point& a, const point& b, const point& c) {
    return a - b * 2.0 + c;
}

/// The size in the image of a difference D of homogeneous points: the largest |D (x, y) - X0 D w| /
/// w_low over places X0 in the disc around a box.
class seen_in {
public:
    seen_in(const l3d_image_box& box, double w_low)
        : x_((box.left + box.right) / 2), y_((box.top + box.bottom) / 2),
          radius_(std::hypot(box.width(), box.height()) / 2), scale_(1 / w_low) {}

    double operator()(const point& d) const {
        const double dx = d[0] - x_ * d[2], dy = d[1] - y_ * d[2];
        return (std::sqrt(dx * dx + dy * dy) + radius_ * std::abs(d[2])) * scale_;
    }

private:
    double x_, y_, radius_, scale_;
};

struct depth_alone {
    double operator()(const point& d) const { return std::abs(d[2]); }
};

template <class Norm> l3d_second_bounds bounds_of(const l3d_image_patch& patch, Norm norm) {
    l3d_second_bounds result;
    for (int line = 0; line < 4; ++line)
        for (int i = 0; i < 2; ++i) {
            const point uu =
                second_difference(patch.at(line, i), patch.at(line, i + 1), patch.at(line, i + 2));
            const point vv =
                second_difference(patch.at(i, line), patch.at(i + 1, line), patch.at(i + 2, line));
            result.uu = std::max(result.uu, 6 * norm(uu));
            result.vv = std::max(result.vv, 6 * norm(vv));
        }
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
            const point uv = (patch.at(r, c) - patch.at(r, c + 1)) -
                             (patch.at(r + 1, c) - patch.at(r + 1, c + 1));
            result.uv = std::max(result.uv, 9 * norm(uv));
        }
    return result;
}

template <class Norm> double bound_of(const l3d_image_curve& curve, Norm norm) {
    const auto& p = curve.points;
    return 6 * std::max(norm(second_difference(p[0], p[1], p[2])),
                        norm(second_difference(p[1], p[2], p[3])));
}

} // namespace

l3d_depth_range l3d_depth_range_of(std::span<const point> net) {
    l3d_depth_range range{net[0][2], net[0][2]};
    for (const point& p : net) {
        range.least = std::min(range.least, p[2]);
        range.most = std::max(range.most, p[2]);
    }
    return range;
}

l3d_image_box l3d_image_box_of(std::span<const point> net) {
    const double x = net[0][0] / net[0][2], y = net[0][1] / net[0][2];
    l3d_image_box box{x, y, x, y};
    for (const point& p : net) {
        const double px = p[0] / p[2], py = p[1] / p[2];
        box.left = std::min(box.left, px);
        box.right = std::max(box.right, px);
        box.top = std::min(box.top, py);
        box.bottom = std::max(box.bottom, py);
    }
    return box;
}

bool l3d_outside(std::span<const point> net, const l3d_image_box& box, double near, double far) {
    bool left = true, right = true, above = true, below = true;
    bool behind = true, beyond = true;
    for (const point& p : net) {
        left = left && p[0] < box.left * p[2];
        right = right && p[0] > box.right * p[2];
        above = above && p[1] < box.top * p[2];
        below = below && p[1] > box.bottom * p[2];
        behind = behind && p[2] <= near;
        beyond = beyond && p[2] >= far;
        // Most nets have their first point in the picture, which ends the test at once.
        if (!(left || right || above || below || behind || beyond))
            return false;
    }
    return true;
}

std::array<double, 2> l3d_image_gaps_of(const l3d_image_patch& net) {
    std::array<l3d_vector<double, 2>, 16> p;
    for (std::size_t i = 0; i < 16; ++i)
        p[i] = {net.points[i][0] / net.points[i][2], net.points[i][1] / net.points[i][2]};
    std::array<double, 2> gaps{};
    const auto take = [&](std::size_t direction, std::size_t i, std::size_t j) {
        gaps[direction] =
            std::max({gaps[direction], std::abs(p[i][0] - p[j][0]), std::abs(p[i][1] - p[j][1])});
    };
    for (std::size_t line = 0; line < 4; ++line)
        for (std::size_t i = 0; i < 3; ++i) {
            take(0, 4 * line + i, 4 * line + i + 1);
            take(1, 4 * i + line, 4 * i + 4 + line);
        }
    return gaps;
}

l3d_second_bounds l3d_second_bounds_of(const l3d_image_patch& patch, const l3d_image_box& visible,
                                       double w_low) {
    return bounds_of(patch, seen_in(visible, w_low));
}

l3d_mixed_bounds l3d_mixed_bounds_of(const l3d_image_patch& patch, const l3d_image_box& visible,
                                     double w_low) {
    const seen_in norm(visible, w_low);
    const auto along_u = [&](int row, int i) {
        return second_difference(patch.at(row, i), patch.at(row, i + 1), patch.at(row, i + 2));
    };
    const auto along_v = [&](int i, int column) {
        return second_difference(patch.at(i, column), patch.at(i + 1, column),
                                 patch.at(i + 2, column));
    };
    l3d_mixed_bounds result;
    for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 3; ++k) {
            result.uuv = std::max(result.uuv, 18 * norm(along_u(k + 1, i) - along_u(k, i)));
            result.uvv = std::max(result.uvv, 18 * norm(along_v(i, k + 1) - along_v(i, k)));
            if (k < 2)
                result.uuvv = std::max(result.uuvv,
                                       36 * norm(second_difference(along_u(k, i), along_u(k + 1, i),
                                                                   along_u(k + 2, i))));
        }
    return result;
}

double l3d_second_bound_of(const l3d_image_curve& curve, const l3d_image_box& visible,
                           double w_low) {
    return bound_of(curve, seen_in(visible, w_low));
}

double l3d_space_bound_of(const l3d_image_curve& curve, double focal, double w_low) {
    const auto in_space = [&](const point& d) { return point{d[0], d[1], focal * d[2]}; };
    const auto& p = curve.points;
    const point chord = in_space(p[3] - p[0]);
    const double length = l3d_length(chord);
    // Each tangent is a sum of the control polygon's sides with weights that are not negative.
    double sine = length > 0 ? 0 : 1;
    for (std::size_t i = 0; i < 3 && sine < 1; ++i) {
        const point side = in_space(p[i + 1] - p[i]);
        if (!(l3d_dot(side, chord) > 0))
            sine = l3d_length(side) > 0 ? 1 : sine;
        else
            sine = std::max(sine, l3d_length(l3d_cross(side, chord)) / (l3d_length(side) * length));
    }
    double largest = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const point bend = in_space(second_difference(p[i], p[i + 1], p[i + 2]));
        const double across = length > 0 ? l3d_length(l3d_cross(bend, chord)) / length : 0;
        largest = std::max(largest, std::min(across + sine * l3d_length(bend), l3d_length(bend)));
    }
    return 6 * largest / w_low;
}

l3d_second_bounds l3d_depth_bounds_of(const l3d_image_patch& patch) {
    return bounds_of(patch, depth_alone{});
}

double l3d_depth_bound_of(const l3d_image_curve& curve) {
    return bound_of(curve, depth_alone{});
}

l3d_image_curve l3d_balanced(const l3d_image_curve& f, int n) {
    if (n == 1)
        return f;
    const auto& p = f.points;
    const double moved = l3d_balance / (static_cast<double>(n) * n);
    const point first = second_difference(p[0], p[1], p[2]) * (6 * moved);
    const point last = second_difference(p[1], p[2], p[3]) * (6 * moved);
    l3d_image_curve result = f;
    for (std::size_t i = 0; i < 4; ++i) // f'' is linear in t
        result.points[i] -= first + (last - first) * (static_cast<double>(i) / 3);
    return result;
}

double l3d_vertex_error(double e_xy, double e_w, double reach, double w_least) {
    constexpr double root_two = 1.4142135623730951;
    return root_two * (e_xy + reach * e_w) / (w_least - e_w);
}
