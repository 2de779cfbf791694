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

/// The faces of a cage with its sharp edges and vertices; places are stored elsewhere.
struct mesh_topology {
    int vertices = 0;
    std::vector<int> face_sizes, corners;
    std::vector<int> crease_vertices; ///< two vertices for each crease
    std::vector<float> crease_sharpness;
    std::vector<int> point_vertices;
    std::vector<float> point_sharpness;
    std::vector<int> holes;
};

/// A face that is not subdivided further: one patch.
struct leaf {
    int base_face;   ///< the cage's face that it is a part of
    int quad;        ///< its index among all quads. A face of n corners has n, or 1 if n is 4.
    int level, face; ///< the level, and the index among its faces
    /// The part of the quad that the leaf covers. The quad's parameters run from 0 to 1.
    double u, v, size;
    bool is_regular;
    unsigned boundary; ///< sides without neighbours, as side_bits, if it is regular
    OpenSubdiv::Far::PatchTable::PatchHandle handle;
};

/// A cage after adaptive subdivision. Its leaves cover the whole surface, face by face.
class refined_mesh {
public:
    /// Expects: a manifold; 0 <= levels <= 10. Only these faces are subdivided, or all if there are
    ///          none.
    refined_mesh(const mesh_topology& mesh, OpenSubdiv::Sdc::Options options, int levels,
                 std::span<const int> only = {});

    const OpenSubdiv::Far::TopologyRefiner& refiner() const { return *refiner_; }
    const std::vector<leaf>& leaves() const { return leaves_; }
    /// The index of the first vertex of a level among those of all levels.
    int first_of(int level) const { return first_[static_cast<std::size_t>(level)]; }

    /// The vertices of all levels. Point has the operations that Far needs.
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

    /// The 16 control points of a leaf, u fastest. Those beyond a boundary are undefined.
    /// Expects: it is regular; the result of refined().
    template <class Point>
    std::array<Point, 16> control_points(const std::vector<Point>& points, const leaf& of) const {
        const auto indices = patches_->GetPatchVertices(of.handle);
        std::array<Point, 16> result;
        for (int k = 0; k < 16; ++k)
            result[static_cast<std::size_t>(k)] = points[static_cast<std::size_t>(indices[k])];
        return result;
    }

    /// The twenty points of Far's Gregory patch for a leaf. Expects: it is not regular.
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

    /// The vertices of all faces that touch a leaf's, as indices among those of all levels.
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
