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

/// A face with all faces that touch it. The face's limit surface depends on the vertices of these
/// faces alone.
struct face_ring {
    /// Indices of the vertices in the level of subdivision, each once. The face's own vertices come
    /// first.
    std::vector<int> vertices;
    /// A key made of all facts, besides places, on which the limit surface depends. Rings that
    /// differ only in places have equal keys.
    std::vector<int> shape;
    /// Sizes and corners of the faces; corners are indices in `vertices`.
    std::vector<int> face_sizes, corners;
    std::vector<int> crease_vertices, point_vertices;
    std::vector<float> crease_sharpness, point_sharpness;

    /// Collects the ring of a face of this level. Expects: the face has four corners.
    face_ring(const OpenSubdiv::Far::TopologyLevel& level, int face);
};

/// A bicubic patch in place of the limit surface over an irregular face, and a bound of their
/// distance at the same parameters.
struct cap {
    std::array<net, 3> bezier{}; ///< control points of the patch, for x, y and z
    double error = 0;
};

/// Makes caps (docs/NUMERICS.md, section 29). Results that depend only on a ring's `shape` are kept
/// for later rings.
class cap_shapes {
public:
    explicit cap_shapes(OpenSubdiv::Sdc::Options options);
    cap_shapes(const cap_shapes&) = delete;
    cap_shapes& operator=(const cap_shapes&) = delete;
    ~cap_shapes();

    /// Makes the cap of a ring's face. `places` are those of ring.vertices, in the same order.
    cap of(const face_ring& ring, const std::vector<place>& places);

private:
    struct weights;

    OpenSubdiv::Sdc::Options options_;
    std::map<std::vector<int>, std::unique_ptr<weights>> kept_;
};

} // namespace l3d_limit

#endif
