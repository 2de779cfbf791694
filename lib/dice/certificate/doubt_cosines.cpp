// SPDX-License-Identifier: MIT
// cosines, put_lamps: bound cosines as quotients of polynomials.
#include "dice/certificate/doubt_cosines_p.h"

#include <algorithm>

namespace l3d_detail {
namespace {

using vector = l3d_normal_polynomial::vector;
constexpr std::size_t order = l3d_normal_polynomial::order;

/// The least cosine of normals with their common axis for which bounds are computed. If any normal
/// has a smaller cosine, only the bounds -1 and 1 are known.
constexpr double least_cosine = 1.0 / 16;

/// The half-way vector between lamp and eye, for all places of a piece. The vector is nearly a
/// linear function of the place.
struct half_way {
    vector middle{0.0, 0.0, 0.0}, along_x{0.0, 0.0, 0.0}, along_y{0.0, 0.0, 0.0};
    double reach = 2; ///< the vector's largest distance from `middle`
    double off = infinite;

    /// Finds the linear function that is near to the half-way vector, and its error.
    ///
    /// If a vector v changes by d, the unit vector v / |v| changes by at most p = |d| / |v|, with
    /// the least |v|. The unit vector is within 0.58 p^2 of a linear function (NUMERICS, The map of
    /// doubt). The vector e from the eye is linear in the place. So this error counts twice: for e
    /// / |e|, and for the half-way vector.
    half_way(const l3d_doubt_bounds& b, const l3d_doubt_view& view, const vector& light) {
        constexpr double bent = 0.58;
        const auto& [of_x, of_y, of_w] = view.world_of_image;
        const double x = view.view.size.width / 2.0, y = view.view.size.height / 2.0;
        const vector way = of_x * (b.at_x - x) + of_y * (b.at_y - y) + of_w;
        const double farthest =
            l3d_length(of_x) * std::max(b.at_x - b.box.left, b.box.right - b.at_x) +
            l3d_length(of_y) * std::max(b.at_y - b.box.top, b.box.bottom - b.at_y);
        const double distance = l3d_length(way);
        const double turned = farthest / (distance - farthest);
        if (!(distance > farthest) || !(turned < 1))
            return;
        const vector to_eye = way * (-1 / distance), sum = light + to_eye;
        const double length = l3d_length(sum);
        if (!(length > 2 * turned + rounding))
            return;
        middle = sum * (1 / length);
        const auto change = [&](const vector& step) {
            const vector of_eye = (step - to_eye * l3d_dot(to_eye, step)) * (-1 / distance);
            return (of_eye - middle * l3d_dot(middle, of_eye)) * (1 / length);
        };
        along_x = change(of_x);
        along_y = change(of_y);
        const double again = turned / (length - turned);
        reach = again;
        off = bent * (again * again + turned * turned / length) + rounding;
    }
};

/// How many levels the brightest channel changes at most for each unit of a cosine.
/// Shape: for n.l, then for n.h.
std::array<double, 2> gains(const l3d_doubt_patch& of, const l3d_doubt_lamp& lamp,
                            double most_facing) {
    double scattered = 0, mirrored = 0;
    for (std::size_t i = 0; i < of.color.size(); ++i) {
        scattered = std::max(scattered, of.color[i] * double{lamp.color[i]});
        mirrored = std::max(mirrored, of.highlight[i] * double{lamp.color[i]});
    }
    const double k = of.sharpness;
    return {l3d_cosine_level * scattered,
            255 * mirrored * k * std::pow(std::max(most_facing, 0.0), k - 1)};
}

/// The error of a line, or half of the line's range if half is less.
double off_of(const l3d_doubt_line& line) {
    return std::min(line.off, (line.most - line.least) / 2);
}

} // namespace

seen_normals::seen_normals(const std::array<vector, count>& normals) {
    for (const vector& n : normals)
        axis += n;
    const double length = l3d_length(axis);
    axis = length > 0 ? axis * (1 / length) : vector(0.0);
    double slope = 0; // slope, most_across and longest are squares in the loop
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const vector& n = normals[i];
        const double q = l3d_dot(n, axis), whole = l3d_dot(n, n);
        const vector across = n - axis * q;
        const double rest = l3d_dot(across, across);
        along[i] = q;
        most_along = std::max(most_along, std::abs(q));
        most_across = std::max(most_across, rest);
        longest = std::max(longest, whole);
        slope =
            std::max(slope, q > 0 && q * q > least_cosine * least_cosine * whole ? rest / (q * q)
                                                                                 : infinite);
    }
    most_across = std::sqrt(most_across);
    longest = std::sqrt(longest);
    most_slope = std::sqrt(slope);
}

/// Bounds n.l / |n| for normals n and a direction l. With n = q (a + r), where a is the normals'
/// axis and r is across it, the cosine is (a.l + r.l) / sqrt(1 + r.r). Here r.l is a quotient of
/// polynomials, which is bounded like a piece's picture. Normals are known to within
/// l3d_doubt_patch::normal_off.
cosines::cosines(const l3d_doubt_piece& piece, const seen_normals& seen, const vector& light) {
    if (!(seen.most_slope < infinite))
        return;
    const std::array<double, order* order>& q = seen.along;
    const double along = l3d_dot(seen.axis, light);
    const vector across = light - seen.axis * along;
    const auto [low_q, high_q] = std::minmax_element(q.begin(), q.end());
    const double least_q = *low_q, most_q = *high_q;
    const double turned = piece.of->turned,
                 known_to = 4 * piece.of->normal_off / least_q + rounding;
    if (!(known_to < least_cosine))
        return;
    const double rho = seen.most_slope + known_to;
    slope = rho + turned;
    std::array<double, order * order> t;
    double least_r = infinite, most_r = -infinite;
    for (std::size_t i = 0; i < t.size(); ++i) {
        t[i] = l3d_dot(piece.normals.points[i], across);
        const double r = t[i] / q[i];
        least_r = std::min(least_r, r);
        most_r = std::max(most_r, r);
    }
    constexpr std::size_t end = order - 1, last = order * end;
    const plane r(t[0] / q[0], t[end] / q[end], t[last] / q[last], t[last + end] / q[last + end]);
    double most_off = 0;
    for (std::size_t row = 0; row < order; ++row)
        for (std::size_t column = 0; column < order; ++column) {
            const std::size_t i = order * row + column;
            const double u = static_cast<double>(column) / end - 0.5;
            const double v = static_cast<double>(row) / end - 0.5;
            most_off = std::max(most_off, std::abs(t[i] - r.at(u, v) * q[i]));
        }
    const double r_off = (most_off + r.range() * (most_q - least_q) / 2) / least_q;
    const double shortest = 1 / std::sqrt(1 + rho * rho), middle = (1 + shortest) / 2;
    line.middle = (along + r.middle) * middle;
    line.in_u = r.in_u * middle;
    line.in_v = r.in_v * middle;
    const double largest = std::max(std::abs(along + least_r), std::abs(along + most_r));
    off = r_off + largest * (1 - middle) + known_to + turned;
    const auto scaled = [&](double value, bool is_least) {
        return value * ((value > 0) == is_least ? shortest : 1);
    };
    least = std::max(-1.0, scaled(along + least_r, true) - known_to - turned);
    most = std::min(1.0, scaled(along + most_r, false) + known_to + turned);
}

l3d_doubt_line line_of(const plane& of, double off, const l3d_doubt_bounds& b) {
    l3d_doubt_line result;
    result.middle = of.middle;
    result.along_x = of.in_u * b.parameters[0] + of.in_v * b.parameters[2];
    result.along_y = of.in_u * b.parameters[1] + of.in_v * b.parameters[3];
    result.off = off + std::hypot(result.along_x, result.along_y) * b.picture_off;
    return result;
}

void put(l3d_doubt_line& into, double least, double most, const l3d_doubt_line& line) {
    if (line.off < (most - least) / 2)
        into = line;
    else
        into = {0, 0, (least + most) / 2, 0, 0, (most - least) / 2};
    into.least = least;
    into.most = most;
}

/// Where the piece may show both sides, normals may be turned either way, so cosines of either sign
/// are possible.
void put_lamps(l3d_doubt_bounds& b, const l3d_doubt_piece& piece, const seen_normals& normals,
               const l3d_doubt_view& view) {
    const l3d_doubt_lighting& lighting = *piece.of->lighting;
    const double sign = b.facing > 0 ? -1 : 1;
    const auto put_line = [&](l3d_doubt_line& into, double least, double most,
                              const l3d_doubt_line& line) {
        if (b.facing == 0) {
            const double size = std::min(1.0, std::max(most, -least));
            return put(into, -size, size, {.off = infinite});
        }
        const double ends[] = {sign * least, sign * most};
        put(into, std::max(-1.0, std::min(ends[0], ends[1])),
            std::min(1.0, std::max(ends[0], ends[1])), line);
    };
    const bool has_places = b.u_off < infinite;
    double off = 0;
    b.lamps.resize(lighting.lamps.size());
    for (std::size_t i = 0; i < b.lamps.size(); ++i) {
        const l3d_doubt_lamp& lamp = lighting.lamps[i];
        const cosines lit(piece, normals, lamp.direction);
        const l3d_doubt_line nothing{.off = infinite};
        put_line(b.lamps[i].lit, lit.least, lit.most,
                 has_places ? line_of(lit.line.times(sign), lit.off, b) : nothing);
        const half_way way(b, view, lamp.direction);
        const cosines facing(piece, normals, way.middle);
        l3d_doubt_line line = nothing;
        if (has_places && way.off < infinite) {
            line = line_of(facing.line.times(sign), facing.off, b);
            const vector axis = normals.axis * sign;
            line.along_x += l3d_dot(axis, way.along_x);
            line.along_y += l3d_dot(axis, way.along_y);
            line.off += facing.slope * way.reach + way.off;
        }
        put_line(b.lamps[i].facing, facing.least - way.reach, facing.most + way.reach, line);
        const auto [of_lit, of_facing] = gains(*piece.of, lamp, b.lamps[i].facing.most);
        off += of_lit * off_of(b.lamps[i].lit) + of_facing * off_of(b.lamps[i].facing);
    }
    b.level = {.least = -l3d_cosine_level, .most = 255, .off = off};
}

} // namespace l3d_detail
