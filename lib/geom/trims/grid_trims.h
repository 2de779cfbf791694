// SPDX-License-Identifier: MIT
// l3d_grid_trims: finds which quads of a grid a trimmed region leaves, and cuts those on its
// border.
#ifndef L3D_GEOM_GRID_TRIMS_H
#define L3D_GEOM_GRID_TRIMS_H

#include "geom/trims/trim_triangles.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Sorts the quads of a grid by a trimmed region. A quad lies inside, lies outside, or is cut. The
/// border passes through a cut quad, and triangles fill the part of the quad that is inside. The
/// result depends on the region and the grid's lines alone, so frames that dice a patch alike can
/// share it.
///
/// Shape: parts are in the order in which halving meets them. Corners, triangles and sides of parts
///        are ranges of this object's arrays.
/// Lives: a user keeps one object for many grids, to reuse its memory.
class l3d_grid_trims {
public:
    using stretch = std::array<double, 2>;

    /// A range of indices into one of the arrays.
    struct range {
        std::uint32_t begin = 0, end = 0;

        bool is_empty() const { return begin == end; }
    };
    /// A corner in a cut quad: its place, and its coordinates from 0 to 1 along the quad's u and v.
    struct corner {
        l3d_trim_place at{};
        std::array<double, 2> part{};
    };
    /// A side between two corners of a cut quad, and the triangle beside the side. `from` and `to`
    /// are indices into the quad's corners.
    struct corner_side {
        std::uint32_t from, to, triangle;
        l3d_trim_use use;
    };
    /// A side of a quad that lies inside the region. The side is on the region's border, and
    /// follows an edge of the model.
    struct grid_side {
        /// The grid's lines at the side's beginning and at its end.
        std::uint32_t row, column, end_row, end_column;
        std::uint32_t quad_row, quad_column; ///< the quad beside this side
        l3d_trim_place from, to;
        l3d_trim_use use;
    };
    /// A block of quads that lie inside the region, or one quad that is cut.
    struct part {
        l3d_trim_block of;
        bool is_whole = false;
        range grid_sides{};           ///< sides that follow edges, if the block is whole
        range corners{}, triangles{}; ///< corners and triangles, if the quad is cut
        range border{};               ///< sides on the region's border, if the quad is cut
        range followed{};             ///< sides on the border that follow edges, if the quad is cut
        range inner{};                ///< sides at which a cut quad meets other quads
    };

    /// The memory in which make() works, which a user keeps for many grids.
    struct workshop {
        l3d_trim_triangles quad;            ///< the quad that is cut
        std::vector<l3d_trim_place> places; ///< the corners of the quad's triangles, in order
        /// The parts of the quad's sides at which the quad meets other quads of the grid.
        std::vector<std::array<l3d_trim_place, 2>> inner;
    };
    /// Sorts and cuts the quads of a grid whose lines have these values of u and v.
    void make(const l3d_trim_region& region, std::span<const double> u, std::span<const double> v,
              workshop& in);
    /// Whether the last make() was for a grid with these lines.
    bool is_for(std::span<const double> u, std::span<const double> v) const;

    std::span<const part> parts() const { return parts_; }
    std::span<const corner> corners(range of) const { return some(corners_, of); }
    /// Triangles, as indices into the corners of their quad.
    std::span<const std::array<std::uint32_t, 3>> triangles(range of) const {
        return some(triangles_, of);
    }
    std::span<const corner_side> sides(range of) const { return some(sides_, of); }
    std::span<const grid_side> grid_sides(range of) const { return some(grid_sides_, of); }

    /// The quads that lie outside the region or are cut, row by row. Shape: row, column.
    std::span<const std::array<std::uint32_t, 2>> cut() const { return cut_; }
    /// The stretches of the grid's sides that the region reaches, side after side in the order of
    /// l3d_trim_triangles::sides().
    const std::array<std::vector<stretch>, 4>& kept() const { return kept_; }

private:
    template <class T> static std::span<const T> some(const std::vector<T>& all, range of) {
        return std::span(all).subspan(of.begin, of.end - of.begin);
    }
    void leave_out(const l3d_trim_block& of);
    void keep_all(const l3d_trim_region& region, const l3d_trim_block& of);
    void cut_quad(const l3d_trim_region& region, const l3d_trim_block& of, workshop& in);

    std::vector<double> u_, v_;
    std::vector<part> parts_;
    std::vector<corner> corners_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<corner_side> sides_;
    std::vector<grid_side> grid_sides_;
    std::vector<std::array<std::uint32_t, 2>> cut_;
    /// Stretches of the sides, in the order of l3d_trim_triangles.
    std::array<std::vector<stretch>, 4> kept_;
};

#endif
