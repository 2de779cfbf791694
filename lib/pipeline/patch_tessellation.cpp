// SPDX-License-Identifier: MIT
// l3d_tessellated: points once each, then faces.
#include "pipeline/patch_tessellation.h"

#include "geom/bezier_curve.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <map>
#include <vector>

namespace {

using patch = l3d_patch_model::patch;
using point = l3d_polygon_mesh::vector;
using curve = l3d_bezier_curve<double, 3>;

std::array<double, 3> numbers(const point& p) {
    return {p[0], p[1], p[2]};
}

/// Whether a curve is to be evaluated from its other end, so that both patches do it alike.
bool runs_backwards(const curve& c) {
    for (std::size_t i = 0; i < 2; ++i) {
        const auto from = numbers(c.points[i]), to = numbers(c.points[3 - i]);
        if (from != to)
            return to < from;
    }
    return false;
}

/// The point i / n along a boundary.
point boundary_point(curve c, int i, int n) {
    if (runs_backwards(c)) {
        std::ranges::reverse(c.points);
        i = n - i;
    }
    return c.evaluate(static_cast<double>(i) / n);
}

point surface_point(const patch& p, int column, int row, int n) {
    if (row == 0 || row == n)
        return boundary_point(p.row(row == 0 ? 0 : 3), column, n);
    if (column == 0 || column == n)
        return boundary_point(p.column(column == 0 ? 0 : 3), row, n);
    return p.evaluate(static_cast<double>(column) / n, static_cast<double>(row) / n);
}

} // namespace

l3d_polygon_mesh l3d_tessellated(const l3d_patch_model& model, int n) {
    assert(n >= 1);
    l3d_polygon_mesh mesh;
    std::map<std::array<double, 3>, std::uint32_t> known;
    const auto side = static_cast<std::size_t>(n) + 1;
    std::vector<std::uint32_t> grid(side * side);
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && c != a)
            mesh.add_face({{a, b, c}});
    };
    for (const patch& p : model.patches()) {
        for (int row = 0; row <= n; ++row)
            for (int column = 0; column <= n; ++column) {
                const point at = surface_point(p, column, row, n);
                const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
                const auto [found, is_new] = known.try_emplace(numbers(at), next);
                if (is_new)
                    mesh.vertices.push_back(at);
                grid[static_cast<std::size_t>(row) * side + static_cast<std::size_t>(column)] =
                    found->second;
            }
        for (std::size_t row = 0; row + 1 < side; ++row)
            for (std::size_t column = 0; column + 1 < side; ++column) {
                const std::uint32_t* const at = &grid[row * side + column];
                add(at[0], at[1], at[side + 1]);
                add(at[0], at[side + 1], at[side]);
            }
    }
    return mesh;
}
