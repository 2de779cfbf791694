// SPDX-License-Identifier: MIT
// l3d_edge_lines: makes lines of sides of patches, and of borders of their trimmed regions.
#include "scene/drawing/edge_lines.h"

#include "geom/trims/trim_region.h"
#include "scene/sides/patch_neighbours.h"
#include "scene/sides/shared_edges.h"

#include <array>
#include <cstddef>

namespace {

using patch = l3d_patch_model::patch;
using vector = l3d_patch_model::vector;

/// Edges are black, as in drawings.
constexpr l3d_color edge_color = 0;

/// A cubic near the curve on a patch over a straight line of parameters. It has that curve's ends
/// and tangents at the ends.
l3d_space_curve above(const patch& of, const l3d_trim_place& from, const l3d_trim_place& to) {
    const double u0 = from[0], v0 = from[1], u1 = to[0], v1 = to[1];
    const auto slope = [&](double u, double v) {
        return (of.derivative_u(u, v) * (u1 - u0) + of.derivative_v(u, v) * (v1 - v0)) * (1.0 / 3);
    };
    const vector a = of.evaluate(u0, v0), b = of.evaluate(u1, v1);
    return l3d_space_curve(l3d_nurbs_curve(l3d_bspline_direction::clamped(3, 4),
                                           {a, a + slope(u0, v0), b - slope(u1, v1), b}),
                           edge_color);
}

/// Whether a line of parameters lies on a side of a patch. Lines along sides are found in another
/// way.
bool is_on_side(const l3d_trim_place& a, const l3d_trim_place& b) {
    for (const std::size_t k : {0U, 1U})
        if (a[k] == b[k] && (a[k] == 0 || a[k] == 1))
            return true;
    return false;
}

} // namespace

std::vector<l3d_space_curve> l3d_edge_lines(const l3d_patch_model& model) {
    std::vector<l3d_space_curve> result;
    for (const l3d_shared_edge& edge : model.edges())
        result.emplace_back(edge.curve, edge_color);
    if (!result.empty())
        return result;
    const l3d_patch_neighbours neighbours(model);
    for (std::size_t i = 0; i < model.patches().size(); ++i) {
        const patch& of = model.patches()[i];
        const l3d_trim_region* const region = model.trim(i);
        for (std::size_t side = 0; side < 4; ++side) {
            if ((neighbours.outlines(i) >> side & 1) == 0)
                continue;
            // v = 0, u = 1, v = 1, u = 0
            const std::size_t along = side % 2, across = 1 - along;
            const double at = side == 1 || side == 2 ? 1 : 0;
            using stretches = std::vector<std::array<double, 2>>;
            for (const auto& [from, to] :
                 region != nullptr ? region->stretches(across, at) : stretches{{0, 1}}) {
                l3d_trim_place a, b;
                a[across] = b[across] = at;
                a[along] = from;
                b[along] = to;
                result.push_back(above(of, a, b));
            }
        }
        if (region == nullptr)
            continue;
        for (const l3d_trim_polygon& polygon : region->polygons)
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                const l3d_trim_place& a = polygon[k];
                const l3d_trim_place& b = polygon[k + 1 < polygon.size() ? k + 1 : 0];
                if (!is_on_side(a, b))
                    result.push_back(above(of, a, b));
            }
    }
    return result;
}
