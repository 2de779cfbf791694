// SPDX-License-Identifier: MIT
// l3d_trim_triangles: makes triangles of a trimmed region in a box. Also visits the boxes of a grid
// with their parts of a region.
#ifndef L3D_GEOM_TRIM_TRIANGLES_H
#define L3D_GEOM_TRIM_TRIANGLES_H

#include "geom/trims/trapezoids.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

/// Makes triangles of a region in a box, and notes what the neighbours of the box need to know.
///
/// Lives: a user keeps one object for many boxes, to reuse its memory.
class l3d_trim_triangles {
public:
    using stretch = std::array<double, 2>;

    /// Makes the triangles of a region. Expects: the region lies in the box.
    void cut(const l3d_trim_region& region, const l3d_trim_box& box);

    /// The triangles, which meet without T-junctions. They turn counterclockwise if u runs to the
    /// right and v upwards. On a side of the box, there may be corners that the neighbour beyond
    /// this side lacks. At these corners, rounding may open a gap to the straight side. Triangles
    /// without area fill such gaps.
    std::span<const std::array<l3d_trim_place, 3>> triangles() const { return triangles_; }

    /// The parts of the box's sides that the region reaches. Shape: the sides are in the order low
    /// v, high v, low u, high u; the parts of each are in rising order.
    const std::array<std::vector<stretch>, 4>& sides() const { return sides_; }

    /// A side of a triangle on the region's border. If u runs to the right and v upwards, the
    /// triangle is on the left of the side.
    struct border_side {
        l3d_trim_place from, to;
        std::size_t triangle;
        l3d_trim_use use; ///< the edge that the side follows, if any
    };
    /// The region's border within the box, in the order of the triangles.
    std::span<const border_side> border() const { return border_; }
    /// The parts of the border that follow edges, also on the box's sides. Parts on the box's sides
    /// have no triangle of their own beside them.
    std::span<const border_side> followed() const { return followed_; }

private:
    /// A trapezoid's low or high side, if that side lies within the box and not on its border.
    struct level_side {
        double v, from, to;
        bool is_high;
        std::size_t triangle;
    };

    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /// A trapezoid with two corners on its low side and two on its high side. The two corners of a
    /// side may coincide.
    struct layer {
        std::array<l3d_trim_place, 2> low, high; ///< the left and the right corner
        std::array<l3d_trim_use, 2> use; ///< edges that the left and the right side follow, upwards
        /// The polygons' sides on the left and on the right, as in l3d_trapezoid.
        std::array<std::size_t, 2> side;
        /// The layer above that shares the whole upper side of this one.
        std::size_t next = none;
        bool goes_on = false; ///< whether this layer is `next` of the layer below

        bool is_wide_below() const { return low[0] != low[1]; }
        bool is_wide_above() const { return high[0] != high[1]; }
    };
    /// A corner of a stack of layers, and its indices in the left and the right border. An index is
    /// `none` in a border on which the corner does not lie.
    struct chain_corner {
        l3d_trim_place at;
        std::array<std::size_t, 2> place;
    };
    /// One border of a stack of layers: its corners, upwards, and the edges that its sides follow.
    struct chain {
        std::vector<l3d_trim_place> corners;
        std::vector<l3d_trim_use> uses;
    };

    void stack_layers();
    void take_layers(std::size_t first);
    void join_corners();
    void add_corners(const chain_corner& a, const chain_corner& b, const chain_corner& c);
    void note_side(const chain_corner& a, const chain_corner& b);
    l3d_trim_use level_use(double v, double from, double to) const;
    void take(const l3d_trapezoid& one);
    void close_sides();
    void find_followed();
    void find_level_border();

    const l3d_trim_region* region_ = nullptr; ///< the region that is cut; valid during cut()
    l3d_trim_box box_;
    l3d_trapezoids trapezoids_;
    std::vector<std::array<l3d_trim_place, 3>> triangles_;
    std::array<std::vector<stretch>, 4> sides_;
    std::vector<border_side> border_, followed_;
    std::vector<level_side> level_sides_;
    std::vector<layer> layers_;
    std::vector<std::size_t>
        begins_; ///< layers that are wide below, from left to right and upwards
    std::array<chain, 2>
        chains_; ///< the left and the right border of the stack that is being triangulated
    std::vector<chain_corner> corners_, waiting_;
};

/// A block of quads of a grid: rows [row, end_row) and columns [column, end_column).
struct l3d_trim_block {
    std::size_t row, end_row, column, end_column;
};

/// Visits the border of a block that a region fills, where the border follows edges. Calls
/// visit(use, from, to) for each side of a quad on the border: `use` is the edge, `from` and `to`
/// are the side's ends.
template <class Visit>
void l3d_for_followed_sides(const l3d_trim_region& region, std::span<const double> u,
                            std::span<const double> v, const l3d_trim_block& of,
                            const Visit& visit) {
    for (const l3d_trim_polygon& polygon : region.polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const l3d_trim_corner& a = polygon[i];
            const l3d_trim_corner& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
            if (a.side.edge == l3d_no_edge)
                continue;
            const std::size_t along = a[1] == b[1] ? 0 : 1;
            const auto at = along == 0 ? u.subspan(of.column, of.end_column - of.column + 1)
                                       : v.subspan(of.row, of.end_row - of.row + 1);
            const auto corner = [&](std::size_t k) {
                l3d_trim_place result = a;
                result[along] = at[k];
                return result;
            };
            const auto t = [&](std::size_t k) {
                return a.side.at((at[k] - a[along]) / (b[along] - a[along]));
            };
            for (std::size_t k = 0; k + 1 < at.size(); ++k)
                visit(l3d_trim_use{a.side.edge, t(k), t(k + 1)}, corner(k), corner(k + 1));
        }
}

/// Halves a region along a grid's lines until each part is simple. Calls visit(block, nullptr) for
/// a block of quads outside the region. Calls visit(block, region) for a block of quads inside, or
/// for a single quad that the border crosses. For a block inside, `region` is the whole block.
/// Expects: the region lies in the block.
template <class Visit>
void l3d_for_trimmed_blocks(const l3d_trim_region& region, std::span<const double> u,
                            std::span<const double> v, const l3d_trim_block& of,
                            const Visit& visit) {
    if (region.is_empty())
        return visit(of, nullptr);
    const std::size_t rows = of.end_row - of.row, columns = of.end_column - of.column;
    if ((rows == 1 && columns == 1) ||
        region.is_all_of({{u[of.column], v[of.row]}, {u[of.end_column], v[of.end_row]}}))
        return visit(of, &region);
    l3d_trim_block low = of, high = of;
    const bool along_u = columns >= rows;
    if (along_u)
        low.end_column = high.column = of.column + columns / 2;
    else
        low.end_row = high.row = of.row + rows / 2;
    const auto halves = along_u ? region.halves(0, u[high.column]) : region.halves(1, v[high.row]);
    l3d_for_trimmed_blocks(halves[0], u, v, low, visit);
    l3d_for_trimmed_blocks(halves[1], u, v, high, visit);
}

#endif
