// SPDX-License-Identifier: MIT
// l3d_polygon_wires: the sides of a model's faces as lines, nothing hidden.
#ifndef L3D_PIPELINE_POLYGONS_POLYGON_WIRES_H
#define L3D_PIPELINE_POLYGONS_POLYGON_WIRES_H

#include "pipeline/polygons/polygon_model.h"
#include "pipeline/polygons/polygon_view.h"
#include "pipeline/polygons/triangle_neighbours_p.h"
#include "pipeline/wire_p.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Finds the lines of a wireframe: the sides of a model's faces.
///
/// Cost: memory, which is kept for the next frame: 40 bytes per vertex, 13 per triangle, 24 per
///       line.
class l3d_polygon_wires {
public:
    /// Makes one line for each side of the faces that are not culled. Lines are cut where they
    /// reach behind the near plane, beyond the far plane, or out of the guard band. A side that two
    /// faces share becomes one line, since a smooth line that is drawn twice looks thicker.
    /// Lives:   the lines live until the next call.
    std::span<const l3d_detail::wire> make(const l3d_polygon_model& model,
                                           const l3d_polygon_view& view, bool cull);

private:
    bool is_of_one_before(const l3d_polygon_model& model, std::size_t triangle,
                          std::size_t side) const;

    struct place {
        double x, y, d, w;
        std::uint8_t outside; ///< bit k is set if the vertex is beyond clipping plane k
    };
    std::vector<place> places_;
    std::vector<std::uint8_t> seen_; ///< for each triangle: 1 if the triangle is not culled
    l3d_detail::triangle_neighbours neighbours_;
    std::vector<l3d_detail::wire> lines_;
};

#endif
