// SPDX-License-Identifier: MIT
// quad_cut: how a quad turns, and the triangles that a folded or skew one is filled as.
#ifndef L3D_RASTER_SURFACES_QUAD_CUT_P_H
#define L3D_RASTER_SURFACES_QUAD_CUT_P_H

#include "raster/shapes/attribute_plane_p.h"
#include "raster/surface_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace l3d_detail {

inline scan_point position(const l3d_micro_vertex& vertex) {
    return {vertex.x, vertex.y};
}

/// Twice the area of a triangle in the picture, positive if its corners turn to the right in the
/// picture.
inline std::int64_t twice_area(const l3d_micro_vertex& a, const l3d_micro_vertex& b,
                               const l3d_micro_vertex& c) {
    return cross(position(b) - position(a), position(c) - position(a));
}

/// The corners of a quad in a grid: p00 p10 p11 p01.
using quad_corners = std::array<l3d_micro_vertex, 4>;

/// The corners of a quad, given by the index of its first corner.
inline quad_corners corners_of(const l3d_micro_grid& grid, std::size_t p00) {
    const std::size_t p01 = p00 + static_cast<std::size_t>(grid.pitch);
    return {grid.vertex(p00), grid.vertex(p00 + 1), grid.vertex(p01 + 1), grid.vertex(p01)};
}

/// Turns the light at a polygon's corners to the side that the picture shows. Before the call, the
/// light belongs to the side to which dS/du x dS/dv points. area2, twice the area, is positive if
/// the polygon turns to the right in the picture. Then dS/du, dS/dv and the line of sight are
/// right-handed, as the picture's right, down and forward are, so the normal points away from the
/// eye.
template <std::size_t Corners>
void show_side(std::array<l3d_micro_vertex, Corners>& polygon, std::int64_t area2) {
    if (area2 > 0)
        for (l3d_micro_vertex& corner : polygon)
            for (float& number : corner.normal)
                number = -number;
}

/// The turns of a quad, which tell whether it is convex or folded. The turn at a corner is twice
/// the area of the triangle of this corner and its neighbours, positive where the quad turns to the
/// right.
class quad_turns {
public:
    explicit quad_turns(const std::array<scan_point, 4>& v) {
        for (std::size_t i = 0; i < at_.size(); ++i)
            at_[i] = cross(v[i] - v[(i + 3) % 4], v[(i + 1) % 4] - v[i]);
    }
    explicit quad_turns(const quad_corners& v)
        : quad_turns({position(v[0]), position(v[1]), position(v[2]), position(v[3])}) {}

    std::int64_t area2() const { return at_[0] + at_[2]; }

    /// Whether all corners are on one line, so that the quad covers nothing.
    bool level() const { return !left() && !right(); }
    bool folded() const { return left() && right(); }

    /// Whether the middles of the diagonals are far apart, so that a plane does not suit the
    /// corners' numbers. The plane exceeds these numbers by skew / area2 / 4 of their range. In
    /// quads that are not skew, this is at most an eighth of the range.
    bool skew() const {
        const std::int64_t skew = std::abs(at_[0] - at_[2]) + std::abs(at_[1] - at_[3]);
        return 2 * skew > std::abs(area2());
    }

    /// Twice the area of the triangle between a side and the crossing of the two sides beside it; 0
    /// if these two sides do not cross. The turns at the corners tell where on the next side the
    /// crossing lies.
    double crossed(std::size_t side) const {
        const auto at = [&](std::size_t i) { return static_cast<double>(at_[(side + i) % 4]); };
        if (at(0) * at(3) >= 0 || at(1) * at(2) >= 0)
            return 0;
        return std::abs(at(1)) * std::abs(at(0)) / (std::abs(at(0)) + std::abs(at(3)));
    }

    /// The corner, 0 or 1, from which a diagonal cuts the quad best, so that the smaller half is as
    /// large as possible.
    std::size_t diagonal() const {
        const auto smaller = [this](std::size_t i) {
            return std::min(std::abs(at_[i]), std::abs(at_[i + 2]));
        };
        return smaller(0) > smaller(1) ? 1 : 0;
    }

private:
    bool left() const { return *std::ranges::min_element(at_) < 0; }
    bool right() const { return *std::ranges::max_element(at_) > 0; }

    std::array<std::int64_t, 4> at_;
};

/// The point around which a folded quad is filled: the mean of the quad's corners before
/// projection. The point's w is the corners' mean w. Its place and normal are the corners' means,
/// weighted by w. In a parallel projection all weights are equal, and the point's depth is the mean
/// depth.
inline l3d_micro_vertex projective_centre(const quad_corners& corners, bool parallel) {
    double sum = 0, x = 0, y = 0, depth = 0;
    std::array<double, 3> normal{};
    for (const l3d_micro_vertex& corner : corners) {
        const double w = parallel ? 1 : 1 / double(corner.inv_w);
        sum += w;
        depth += double(corner.inv_w);
        x += w * corner.x;
        y += w * corner.y;
        for (std::size_t axis = 0; axis < normal.size(); ++axis)
            normal[axis] += w * double(corner.normal[axis]);
    }
    const auto mean = [sum](double total) { return static_cast<float>(total / sum); };
    return {static_cast<std::int32_t>(std::lrint(x / sum)),
            static_cast<std::int32_t>(std::lrint(y / sum)),
            static_cast<float>(parallel ? depth / 4 : 4 / sum),
            {mean(normal[0]), mean(normal[1]), mean(normal[2])}};
}

/// Whether a folded quad's triangle between a side and the centre turns to the right.
inline bool piece_turns_right(const quad_corners& v, const l3d_micro_vertex& centre,
                              std::size_t side) {
    return twice_area(v[side], v[(side + 1) % v.size()], centre) > 0;
}

/// Finds which side of the surface each triangle around the centre of a folded quad shows.
///
/// A triangle that is turned over shows its back, as at a contour. The exception is a single turned
/// triangle. Then the other three triangles go once around the centre and cover the turned one
/// again, except for a rest. The rest lies between the turned triangle's outer side and the
/// crossing of the quad's two sides beside this side. Rounded corners, as beside a pole, make such
/// triangles, too. So the turned triangle shows the same side as the others if the rest is less
/// than half of it, or the two sides do not cross.
class folded_sides {
public:
    folded_sides(const quad_corners& v, const quad_turns& turns, const l3d_micro_vertex& centre) {
        std::int64_t all = 0;
        for (std::size_t i = 0; i < v.size(); ++i) {
            area2_[i] = twice_area(v[i], v[(i + 1) % v.size()], centre);
            all += area2_[i];
        }
        std::size_t turned = v.size(), others = 0;
        for (std::size_t i = 0; i < v.size(); ++i) {
            if ((area2_[i] > 0) == (all > 0))
                others += area2_[i] != 0;
            else
                turned = i;
        }
        if (turned < v.size() && others == v.size() - 1 &&
            2 * turns.crossed(turned) < std::abs(static_cast<double>(area2_[turned])))
            area2_[turned] = all;
    }

    /// The argument of show_side for a triangle: twice an area, positive if the side that the
    /// triangle shows turns to the right.
    std::int64_t area2(std::size_t triangle) const { return area2_[triangle]; }

private:
    std::array<std::int64_t, 4> area2_{};
};

/// Calls add(triangle, area2) for the four triangles around the centre of a folded quad. `area2` is
/// the argument of show_side, and tells which side of the surface the triangle shows.
template <class Add>
void cut_folded(const quad_corners& v, bool parallel, const quad_turns& turns, const Add& add) {
    const l3d_micro_vertex centre = projective_centre(v, parallel);
    const folded_sides sides(v, turns, centre);
    for (std::size_t i = 0; i < v.size(); ++i)
        add(std::array{v[i], v[(i + 1) % v.size()], centre}, sides.area2(i));
}

/// The bends of a quad's sides and diagonals in mode l3d_shade::levels: the level in the middle of
/// a side or diagonal, less the mean of the levels at its ends. In the middle of the quad's
/// parameters, the level is the corners' mean, plus the mean bend of each pair of opposite sides.
struct quad_bends {
    float ab, ad, bc, dc, ac, bd;

    explicit quad_bends(const quad_corners& v)
        : ab(v[0].normal[1]), ad(v[0].normal[2]), bc(v[1].normal[2]), dc(v[3].normal[1]) {
        const float unlike =
            0.25f * (v[0].normal[0] - v[1].normal[0] + v[2].normal[0] - v[3].normal[0]);
        ac = both() - unlike;
        bd = both() + unlike;
    }

    float both() const { return 0.5f * (ab + dc + ad + bc); }
};

/// Cuts a folded quad as cut_folded does, in mode l3d_shade::levels. The bend of half a diagonal is
/// a quarter of the diagonal's bend.
template <class Add>
void cut_folded_levels(const quad_corners& v, bool parallel, const quad_turns& turns,
                       const Add& add) {
    const quad_bends bends(v);
    const std::array<float, 4> sides{bends.ab, bends.bc, bends.dc, bends.ad};
    const std::array<float, 4> to_centre{0.25f * bends.ac, 0.25f * bends.bd, 0.25f * bends.ac,
                                         0.25f * bends.bd};
    std::size_t side = 0;
    cut_folded(v, parallel, turns, [&](std::array<l3d_micro_vertex, 3> piece, std::int64_t area2) {
        auto& [from, to, centre] = piece;
        from.normal[1] = sides[side];
        from.normal[2] = to_centre[side];
        to.normal[1] = 0;
        to.normal[2] = to_centre[(side + 1) % 4];
        centre.normal[0] += bends.both();
        centre.normal[1] = centre.normal[2] = 0;
        ++side;
        add(piece, area2);
    });
}

/// Cuts a quad, and calls add(triangle, area2) for each triangle. A folded quad is cut by
/// cut_folded, any other quad along its diagonal().
template <class Add>
void cut_quad(const quad_corners& v, bool parallel, const quad_turns& turns, const Add& add) {
    if (turns.folded())
        return cut_folded(v, parallel, turns, add);
    const std::size_t first = turns.diagonal();
    add(std::array{v[first], v[first + 1], v[first + 2]}, turns.area2());
    add(std::array{v[first], v[first + 2], v[(first + 3) % 4]}, turns.area2());
}

} // namespace l3d_detail

#endif
