// SPDX-License-Identifier: MIT
// mesh_dicer: dices patches with colours at their corners into triangles.
#ifndef L3D_RASTER_PATHS_MESH_DICER_P_H
#define L3D_RASTER_PATHS_MESH_DICER_P_H

#include "raster/paths/gradient.h"
#include "raster/paths/mesh_steps_p.h"

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace l3d_detail {

/// A corner of a mesh's triangle. Its colour is not rounded.
struct mesh_corner {
    l3d_point_2d at;
    std::array<double, 3> color; ///< red, green, blue, from 0 to 255
};

/// A row of corners of a patch's cells, with an array for each coordinate and channel.
/// Shape:   `size` corners, and `room` more that lanes may read past the last.
struct mesh_row {
    static constexpr std::size_t room = mesh_knots::room;

    std::size_t size = 0;
    std::vector<double> x, y;
    std::array<std::vector<double>, 3> color;

    void resize(std::size_t count);
    mesh_corner corner(std::size_t i) const {
        return {{x[i], y[i]}, {color[0][i], color[1][i], color[2][i]}};
    }
};

/// A curve of a patch at one v: its control points along u, and the colours at its ends.
struct mesh_curve {
    std::array<double, 4> x, y;
    std::array<std::array<double, 3>, 2> ends;
};

/// A cell of a patch, between two steps along u and two along v.
struct mesh_cell {
    std::array<mesh_corner, 4> corners; ///< corners at the cell's (0, 0), (1, 0), (0, 1), (1, 1)
    bool rises;                         ///< whether the cell's diagonal goes from (0, 1) to (1, 0)

    /// The corners of the cell's two triangles, the triangle above the diagonal first. The first
    /// and the last corner of each triangle are on the diagonal.
    std::array<std::array<std::size_t, 3>, 2> triangles() const {
        if (rises)
            return {{{2, 0, 1}, {1, 3, 2}}};
        return {{{0, 1, 3}, {3, 2, 0}}};
    }
};

/// A strip of cells between two rows of corners. The strip's triangles are in the order in which
/// the PDF standard paints them.
struct mesh_strip {
    const mesh_row &above, &below;
    const std::vector<double>& rises; ///< whether each cell's diagonal rises, 1 or 0

    std::size_t cells() const { return above.size - 1; }
    mesh_cell cell(std::size_t i) const {
        return {{above.corner(i), above.corner(i + 1), below.corner(i), below.corner(i + 1)},
                rises[i] != 0};
    }
};

/// Dices the patches of a mesh so that neighbours meet without cracks.
///
/// The points of a border depend only on its four control points and its steps, and not on its
/// direction. For this, the parameters i / n and (n - i) / n are each rounded once, and terms are
/// added in pairs.
/// Lives:   no longer than the patches.
class mesh_dicer {
public:
    mesh_dicer(std::span<const l3d_mesh_patch> patches, mesh_colors colors)
        : patches_(patches), dicings_(dicings_of(patches, colors)) {}

    /// The parameters u and v of the corners in the patch that is being visited.
    const mesh_knots& along() const { return along_; }
    const mesh_knots& down() const { return down_; }

    /// Calls shade(mesh_strip) for the strips of each patch with finite numbers. The order is that
    /// of the PDF standard: larger v come later and cover smaller v. At equal v, larger u come
    /// later and cover smaller u.
    template <class Shade> void visit(const Shade& shade) {
        for (std::size_t i = 0; i < patches_.size(); ++i) {
            if (!is_finite(patches_[i]))
                continue;
            begin(i);
            set_row(patches_[i], 0);
            for (std::size_t v = 1; v < down_.size; ++v) {
                std::swap(above_, below_);
                set_row(patches_[i], v);
                if (v == 1 || down_.quarter[v] != down_.quarter[v - 1])
                    set_diagonals(dicings_[i], down_.quarter[v]);
                shade(mesh_strip{above_, below_, rises_});
            }
        }
    }

private:
    void begin(std::size_t patch);
    void set_diagonals(const mesh_dicing& dicing, std::size_t row_of_quarters);
    void set_row(const l3d_mesh_patch& patch, std::size_t v);

    std::span<const l3d_mesh_patch> patches_;
    std::vector<mesh_dicing> dicings_;
    mesh_knots along_, down_;
    /// For each cell of a strip, whether its diagonal rises; the vector has room for more lanes, as
    /// mesh_row has.
    std::vector<double> rises_;
    mesh_row above_, below_;
};

} // namespace l3d_detail

#endif
