// SPDX-License-Identifier: MIT
// cap_shapes: a bicubic patch in place of the limit surface over an irregular face, with its error.
#ifndef L3D_PLUGINS_SUBDIVISION_CAP_SHAPES_H
#define L3D_PLUGINS_SUBDIVISION_CAP_SHAPES_H

#include "bspline_bezier.h"

#include <opensubdiv/far/topologyLevel.h>
#include <opensubdiv/sdc/options.h>

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <vector>

namespace l3d_limit {

using place = std::array<double, 3>;

/// A face with all faces that touch it: its limit surface depends on these vertices alone.
struct face_ring {
    std::vector<int> vertices; ///< indices in the level, each once; those of the face first
    /// All other facts on which the surface depends. They are equal for rings that differ only in
    /// places.
    std::vector<int> shape;
    std::vector<int> face_sizes, corners; ///< the faces, in the ring's own numbers
    std::vector<int> crease_vertices, point_vertices;
    std::vector<float> crease_sharpness, point_sharpness;

    /// Expects: a face of four corners.
    face_ring(const OpenSubdiv::Far::TopologyLevel& level, int face);
};

/// A cap, and a bound of its distance from the limit surface at the same parameters.
struct cap {
    std::array<net, 3> bezier{}; ///< its control points, for x, y and z
    double error = 0;
};

/// Makes caps (docs/NUMERICS.md, section 29). Results that depend on the ring's shape alone are
/// kept.
class cap_shapes {
public:
    explicit cap_shapes(OpenSubdiv::Sdc::Options options);
    cap_shapes(const cap_shapes&) = delete;
    cap_shapes& operator=(const cap_shapes&) = delete;
    ~cap_shapes();

    /// Shape: `places` of the ring's vertices, in their order.
    cap of(const face_ring& ring, const std::vector<place>& places);

private:
    struct weights;

    OpenSubdiv::Sdc::Options options_;
    std::map<std::vector<int>, std::unique_ptr<weights>> kept_;
};

} // namespace l3d_limit

#endif
