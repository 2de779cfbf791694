// SPDX-License-Identifier: MIT
// l3d_patch_sides: sides that meet their like.
#include "scene/patch_sides.h"
#include "geom/normal_net.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace {

using vector = l3d_patch_model::vector;
using curve = l3d_patch_model::patch::curve;
using numbers = std::array<double, 12>;

/// Normals are compared at so many places of a side. A shared side's normals are of degree 5, so
/// five places would do for curves that are the same. These are twice as many.
constexpr int places = 11;

/// Eight levels of Lambert's grey, 229.5 n.l, two degrees: beside a smaller kink nobody sees which
/// of both patches a pixel shows.
constexpr double least_angle = 8 / 229.5;

/// The sides in the order in which one walks round the patch.
std::array<curve, 4> sides_of(const l3d_patch_model::patch& p) {
    return {p.row(0), p.column(3), p.row(3).reversed(), p.column(0).reversed()};
}

/// The parameters at t of a side.
std::array<double, 2> place_on(std::size_t side, double t) {
    switch (side) {
    case 0:
        return {t, 0};
    case 1:
        return {1, t};
    case 2:
        return {1 - t, 1};
    default:
        return {0, 1 - t};
    }
}

numbers numbers_of(const curve& c) {
    numbers result;
    for (std::size_t i = 0; i < 4; ++i)
        for (int k = 0; k < 3; ++k) // no -0, which is 0
            result[3 * i + static_cast<std::size_t>(k)] = c.points[i][k] + 0.0;
    return result;
}

bool is_point(const curve& c) {
    return std::all_of(c.points.begin(), c.points.end(),
                       [&](const vector& q) { return q == c.points[0]; });
}

struct side_of {
    std::size_t patch, side;
    bool forward; ///< walked in the direction that is the first in order
};

vector unit(const vector& n) {
    const double length = l3d_length(n);
    return length > 0 ? n * (1 / length) : vector(0.0);
}

vector normal_at(const l3d_patch_model& model, const side_of& s, double t) {
    const auto [u, v] = place_on(s.side, s.forward ? t : 1 - t);
    return unit(model.normals(s.patch).evaluate(u, v));
}

bool same_direction(const vector& a, const vector& b) {
    const vector c = l3d_cross(a, b);
    return l3d_dot(a, b) > 0 && l3d_length(c) < least_angle;
}

/// Neighbours that walk their side in the same direction have opposite normals.
bool is_smooth(const l3d_patch_model& model, const side_of& a, const side_of& b) {
    const double turn = a.forward == b.forward ? -1 : 1;
    for (int i = 0; i < places; ++i) {
        const double t = static_cast<double>(i) / (places - 1);
        if (!same_direction(normal_at(model, a, t), normal_at(model, b, t) * turn))
            return false;
    }
    return true;
}

bool is_smooth_point(const l3d_patch_model& model, const side_of& at) {
    for (int i = 1; i < places; ++i)
        if (!same_direction(normal_at(model, at, 0),
                            normal_at(model, at, static_cast<double>(i) / (places - 1))))
            return false;
    return true;
}

} // namespace

l3d_patch_sides::l3d_patch_sides(const l3d_patch_model& model) {
    const auto patches = model.patches();
    outlines_.resize(patches.size());
    std::map<numbers, std::vector<side_of>> by_place;
    const auto mark = [&](const side_of& s) {
        outlines_[s.patch] = static_cast<unsigned char>(outlines_[s.patch] | (1U << s.side));
    };
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const auto sides = sides_of(patches[i]);
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const numbers there = numbers_of(sides[k]), back = numbers_of(sides[k].reversed());
            const side_of here{i, k, there <= back};
            if (!is_point(sides[k]))
                by_place[std::min(there, back)].push_back(here);
            else if (!is_smooth_point(model, here))
                mark(here);
        }
    }
    for (const auto& [place, sides] : by_place)
        if (sides.size() != 2 || !is_smooth(model, sides[0], sides[1]))
            std::for_each(sides.begin(), sides.end(), mark);
    find_touching(patches);
}

void l3d_patch_sides::find_touching(std::span<const l3d_patch_model::patch> patches) {
    std::map<std::array<double, 3>, std::vector<std::uint32_t>> at_corner;
    const auto for_corners = [&](std::size_t i, const auto& visit) {
        for (const int corner : {0, 3, 12, 15}) {
            const vector& p = patches[i].points[static_cast<std::size_t>(corner)];
            visit(at_corner[{p[0] + 0.0, p[1] + 0.0, p[2] + 0.0}]);
        }
    };
    for (std::size_t i = 0; i < patches.size(); ++i)
        for_corners(i, [&](auto& list) { list.push_back(static_cast<std::uint32_t>(i)); });
    touching_.resize(patches.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        std::vector<std::uint32_t>& all = touching_[i];
        for_corners(i, [&](auto& list) { all.insert(all.end(), list.begin(), list.end()); });
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
    }
}
