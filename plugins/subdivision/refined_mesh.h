// SPDX-License-Identifier: MIT
// refined_mesh: a cage that Far has subdivided around its irregular vertices.
#ifndef L3D_PLUGINS_SUBDIVISION_REFINED_MESH_H
#define L3D_PLUGINS_SUBDIVISION_REFINED_MESH_H

#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTable.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyRefiner.h>
#include <opensubdiv/sdc/options.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace l3d_limit {

/// The faces of a cage, with its sharp edges and vertices. The places of vertices are stored
/// elsewhere.
struct mesh_topology {
    int vertices = 0;
    std::vector<int> face_sizes, corners;
    std::vector<int> crease_vertices; ///< two vertices for each crease
    std::vector<float> crease_sharpness;
    std::vector<int> point_vertices;
    std::vector<float> point_sharpness;
    std::vector<int> holes;
};

/// A face that is not subdivided further, and becomes one patch.
struct leaf {
    int base_face; ///< the cage's face that the leaf is a part of
    /// Index of the leaf's quad among the quads of all faces. A face of 4 corners is one quad; any
    /// other face has one quad for each corner.
    int quad;
    int level, face; ///< the leaf's level, and its index among the level's faces
    /// The part of the quad that the leaf covers. The quad's parameters run from 0 to 1.
    double u, v, size;
    bool is_regular;
    unsigned boundary; ///< sides without neighbours, as side_bits, if the leaf is regular
    OpenSubdiv::Far::PatchTable::PatchHandle handle;
};

/// A cage that was subdivided around its irregular vertices. Its leaves cover the whole surface,
/// face by face.
class refined_mesh {
public:
    /// Subdivides a cage to a depth of `levels`. `only` lists the faces to subdivide; if it is
    /// empty, all faces are.
    /// Expects: the cage is a manifold; 0 <= levels <= 10.
    refined_mesh(const mesh_topology& mesh, OpenSubdiv::Sdc::Options options, int levels,
                 std::span<const int> only = {});

    const OpenSubdiv::Far::TopologyRefiner& refiner() const { return *refiner_; }
    const std::vector<leaf>& leaves() const { return leaves_; }
    /// The index of a level's first vertex among the vertices of all levels.
    int first_of(int level) const { return first_[static_cast<std::size_t>(level)]; }

    /// The vertices of all levels, computed from the cage's vertices. `Point` has the operations
    /// that OpenSubdiv's Far needs.
    template <class Point> std::vector<Point> refined(const std::vector<Point>& cage) const {
        std::vector<Point> result = cage;
        result.resize(static_cast<std::size_t>(refiner_->GetNumVerticesTotal()), cage.front());
        const OpenSubdiv::Far::PrimvarRefinerReal<double> by(*refiner_);
        for (int level = 1; level < refiner_->GetNumLevels(); ++level) {
            Point* const from = result.data() + first_of(level - 1);
            Point* const to = result.data() + first_of(level);
            by.Interpolate(level, from, to);
        }
        return result;
    }

    /// The 16 B-spline control points of a leaf. The index along u changes fastest. Points beyond a
    /// boundary are undefined.
    /// Expects: the leaf is regular; `points` are the result of refined().
    template <class Point>
    std::array<Point, 16> control_points(const std::vector<Point>& points, const leaf& of) const {
        const auto indices = patches_->GetPatchVertices(of.handle);
        std::array<Point, 16> result;
        for (int k = 0; k < 16; ++k)
            result[static_cast<std::size_t>(k)] = points[static_cast<std::size_t>(indices[k])];
        return result;
    }

    /// The twenty points of Far's Gregory patch for a leaf.
    /// Expects: the leaf is not regular; `points` are the result of refined().
    template <class Point>
    std::array<Point, 20> gregory_points(const std::vector<Point>& points, const leaf& of) const {
        const auto indices = patches_->GetPatchVertices(of.handle);
        const auto* const stencils = patches_->GetLocalPointStencilTable<double>();
        std::array<Point, 20> result;
        for (int k = 0; k < 20; ++k) {
            Point& to = result[static_cast<std::size_t>(k)];
            to = points.front();
            const int local = indices[k] - refiner_->GetNumVerticesTotal();
            if (local < 0) {
                to = points[static_cast<std::size_t>(indices[k])];
                continue;
            }
            to.Clear();
            const auto stencil = stencils->GetStencil(local);
            for (int i = 0; i < stencil.GetSize(); ++i)
                to.AddWithWeight(points[static_cast<std::size_t>(stencil.GetVertexIndices()[i])],
                                 stencil.GetWeights()[i]);
        }
        return result;
    }

    /// The vertices of all faces that touch a leaf's face, as indices among the vertices of all
    /// levels.
    std::vector<int> ring_of(const leaf& of) const;

private:
    void add_leaves(leaf of, const OpenSubdiv::Far::PatchMap& map);

    std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> refiner_;
    std::unique_ptr<OpenSubdiv::Far::PatchTable> patches_;
    std::vector<int> first_;
    std::vector<leaf> leaves_;
};

} // namespace l3d_limit

#endif
