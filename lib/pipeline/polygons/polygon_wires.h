// SPDX-License-Identifier: MIT
// l3d_polygon_wires: the sides of a model's faces as lines, nothing hidden.
#ifndef L3D_PIPELINE_POLYGONS_POLYGON_WIRES_H
#define L3D_PIPELINE_POLYGONS_POLYGON_WIRES_H

#include "pipeline/polygons/polygon_model.h"
#include "pipeline/polygons/polygon_view.h"
#include "pipeline/wire_p.h"

#include <cstdint>
#include <span>
#include <vector>

/// Finds the lines of a frame.
///
/// Cost:    keeps its memory: 33 bytes per vertex, 16 per line.
class l3d_polygon_wires {
public:
    /// One line for each side of a face that is not culled. It is cut where it reaches behind the
    /// near plane, beyond the far one, or out of the guard band. A side of two faces is there
    /// twice.
    /// Lives:   the lines until the next call.
    std::span<const l3d_detail::wire> make(const l3d_polygon_model& model,
                                           const l3d_polygon_view& view, bool cull);

private:
    struct place {
        double x, y, w;
        std::uint8_t outside; ///< a bit for each plane that it is beyond
    };
    std::vector<place> places_;
    std::vector<l3d_detail::wire> lines_;
};

#endif
