// SPDX-License-Identifier: MIT
// l3d_patch_neighbours: compares normals of sides that meet.
#include "scene/sides/patch_neighbours.h"
#include "geom/normal_net.h"
#include "scene/sides/halved_sides.h"
#include "scene/sides/side_pairs.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace {

using vector = l3d_patch_model::vector;
using pairs = l3d_side_pairs;

/// The number of places of a side at which normals are compared. Normals along a side are of degree
/// 5, so some five places would be enough to compare two patches. Here are twice as many.
constexpr int places = 11;

/// The least angle of a kink: two degrees, or eight shade levels of Lambert's grey, 229.5 n.l. At a
/// smaller kink, nobody sees which of the two patches a pixel shows.
constexpr double least_angle = 8 / 229.5;

vector unit(const vector& n) {
    const double length = l3d_length(n);
    return length > 0 ? n * (1 / length) : vector(0.0);
}

vector normal_at(const l3d_patch_model& model, std::size_t patch, std::size_t side, double t) {
    const auto [u, v] = pairs::place_on(side, t);
    return unit(model.normals(patch).evaluate(u, v));
}

bool same_direction(const vector& a, const vector& b) {
    const vector c = l3d_cross(a, b);
    return l3d_dot(a, b) > 0 && l3d_length(c) < least_angle;
}

/// Whether the surface is smooth across a side. If both patches walk the side in the same
/// direction, their normals are opposite.
bool is_smooth(const l3d_patch_model& model, std::size_t patch, std::size_t side,
               const pairs::beyond& next) {
    const double turn = next.turns ? -1 : 1;
    for (int i = 0; i < places; ++i) {
        const double t = static_cast<double>(i) / (places - 1);
        const double along = next.turns ? t : 1 - t;
        const vector there =
            normal_at(model, next.patch, next.side,
                      next.is == pairs::kind::half ? (next.part + along) / 2 : along);
        if (!same_direction(normal_at(model, patch, side, t), there * turn))
            return false;
    }
    return true;
}

bool is_smooth_point(const l3d_patch_model& model, std::size_t patch, std::size_t side) {
    const vector first = normal_at(model, patch, side, 0);
    for (int i = 1; i < places; ++i)
        if (!same_direction(first,
                            normal_at(model, patch, side, static_cast<double>(i) / (places - 1))))
            return false;
    return true;
}

} // namespace

l3d_patch_neighbours::l3d_patch_neighbours(const l3d_patch_model& model) {
    const auto patches = model.patches();
    const l3d_side_pairs beyond(model);
    outlines_.resize(patches.size());
    for (std::size_t i = 0; i < patches.size(); ++i)
        for (std::size_t side = 0; side < pairs::sides; ++side) {
            const pairs::beyond& next = beyond.at(i, side);
            if (next.is == pairs::kind::halved)
                continue; // its halves are compared instead
            const bool smooth = ((next.is == pairs::kind::paired || next.is == pairs::kind::half) &&
                                 is_smooth(model, i, side, next)) ||
                                (next.is == pairs::kind::point && is_smooth_point(model, i, side));
            if (!smooth)
                outlines_[i] = static_cast<unsigned char>(outlines_[i] | (1U << side));
        }
    for (const l3d_halved_side& halved : model.halved_sides())
        for (const l3d_halved_side::place& half : halved.beyond)
            if (outlines_[half.patch] >> half.side & 1)
                outlines_[halved.of.patch] =
                    static_cast<unsigned char>(outlines_[halved.of.patch] | 1U << halved.of.side);
    find_touching(patches);
}

void l3d_patch_neighbours::find_touching(std::span<const l3d_patch_model::patch> patches) {
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
