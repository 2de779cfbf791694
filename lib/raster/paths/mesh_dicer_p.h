// SPDX-License-Identifier: MIT
// mesh_dicer: patches with colours at their corners as triangles.
#ifndef L3D_RASTER_PATHS_MESH_DICER_P_H
#define L3D_RASTER_PATHS_MESH_DICER_P_H

#include "raster/paths/gradient.h"

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace l3d_detail {

/// A corner of a triangle of a mesh; its colour is not rounded.
struct mesh_corner {
    l3d_point_2d at;
    std::array<double, 3> color; ///< red, green, blue; 0 to 255
};

/// A row of corners. Shape: `size` of them, and room for so many more that lanes may read past the
/// last.
struct mesh_row {
    static constexpr std::size_t room = 8;

    std::size_t size = 0;
    std::vector<double> x, y;
    std::array<std::vector<double>, 3> color;

    void resize(std::size_t count);
    mesh_corner corner(std::size_t i) const {
        return {{x[i], y[i]}, {color[0][i], color[1][i], color[2][i]}};
    }
};

/// The triangles between two rows, in the order of the standard. Each step has two, that above the
/// diagonal first.
struct mesh_strip {
    const mesh_row &above, &below;

    std::size_t triangles() const { return 2 * (above.size - 1); }
    std::array<mesh_corner, 3> triangle(std::size_t i) const {
        const std::size_t u = i / 2 + 1;
        if (i % 2 == 0)
            return {above.corner(u - 1), above.corner(u), below.corner(u)};
        return {above.corner(u - 1), below.corner(u), below.corner(u - 1)};
    }
};

/// Whether all coordinates are finite numbers.
bool is_finite(const l3d_mesh_patch& patch);

/// Dices all patches of a mesh into as many steps, so that neighbours meet without cracks.
///
/// A border depends on its four control points alone, and on no direction: i / n and (n - i) / n
/// are both rounded once, and terms are added in pairs.
class mesh_dicer {
public:
    explicit mesh_dicer(std::span<const l3d_mesh_patch> patches);

    /// Steps along each side of each patch.
    int steps() const { return steps_; }

    /// Calls shade(mesh_strip) in the order of the standard: what has the larger v comes later and
    /// stays; with one v, what has the larger u.
    template <class Shade> void visit(const l3d_mesh_patch& patch, const Shade& shade) {
        set_row(patch, 0);
        for (int v = 1; v <= steps_; ++v) {
            std::swap(above_, below_);
            set_row(patch, v);
            shade(mesh_strip{above_, below_});
        }
    }

private:
    void set_row(const l3d_mesh_patch& patch, int v);

    int steps_ = 1;
    std::vector<std::array<double, 4>> weights_; ///< of control points, at each step
    mesh_row above_, below_;
};

} // namespace l3d_detail

#endif
