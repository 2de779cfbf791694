// SPDX-License-Identifier: MIT
// mesh_dicer: patches with colours at their corners as triangles.
#ifndef L3D_RASTER_PATHS_MESH_DICER_P_H
#define L3D_RASTER_PATHS_MESH_DICER_P_H

#include "raster/paths/gradient.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace l3d_detail {

/// A corner of a triangle of a mesh; its colour is not rounded.
struct mesh_corner {
    l3d_point_2d at;
    std::array<double, 3> color; ///< red, green, blue; 0 to 255
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

    /// Calls triangle(std::array<mesh_corner, 3>) in the order of the standard: what has the larger
    /// v comes later and stays; with one v, what has the larger u.
    template <class Triangle> void visit(const l3d_mesh_patch& patch, const Triangle& triangle) {
        set_row(patch, 0);
        for (int v = 1; v <= steps_; ++v) {
            above_.swap(below_);
            set_row(patch, v);
            for (std::size_t u = 1; u < below_.size(); ++u) {
                triangle(std::array{above_[u - 1], above_[u], below_[u]});
                triangle(std::array{above_[u - 1], below_[u], below_[u - 1]});
            }
        }
    }

private:
    void set_row(const l3d_mesh_patch& patch, int v);

    int steps_ = 1;
    std::vector<mesh_corner> above_, below_;
};

} // namespace l3d_detail

#endif
