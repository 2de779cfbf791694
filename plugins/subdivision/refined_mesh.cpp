// SPDX-License-Identifier: MIT
// refined_mesh: visits Far's refiner and its table of patches face by face.
#include "refined_mesh.h"

#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <stdexcept>

namespace l3d_limit {

namespace far = OpenSubdiv::Far;

refined_mesh::refined_mesh(const mesh_topology& mesh, OpenSubdiv::Sdc::Options options, int levels,
                           std::span<const int> only) {
    far::TopologyDescriptor description;
    description.numVertices = mesh.vertices;
    description.numFaces = static_cast<int>(mesh.face_sizes.size());
    description.numVertsPerFace = mesh.face_sizes.data();
    description.vertIndicesPerFace = mesh.corners.data();
    description.numCreases = static_cast<int>(mesh.crease_sharpness.size());
    description.creaseVertexIndexPairs = mesh.crease_vertices.data();
    description.creaseWeights = mesh.crease_sharpness.data();
    description.numCorners = static_cast<int>(mesh.point_sharpness.size());
    description.cornerVertexIndices = mesh.point_vertices.data();
    description.cornerWeights = mesh.point_sharpness.data();
    description.numHoles = static_cast<int>(mesh.holes.size());
    description.holeIndices = mesh.holes.data();
    using factory = far::TopologyRefinerFactory<far::TopologyDescriptor>;
    refiner_.reset(
        factory::Create(description, factory::Options(OpenSubdiv::Sdc::SCHEME_CATMARK, options)));
    if (!refiner_)
        throw std::runtime_error("OpenSubdiv does not take this mesh");

    far::PatchTableFactory::Options how(static_cast<unsigned>(levels));
    how.useInfSharpPatch = true;
    how.generateLegacySharpCornerPatches = false; // legacy patches are not the limit surface
    how.SetEndCapType(far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
    how.SetPatchPrecision<double>();
    const far::ConstIndexArray chosen(only.data(), static_cast<int>(only.size()));
    refiner_->RefineAdaptive(how.GetRefineAdaptiveOptions(), chosen);
    patches_.reset(far::PatchTableFactory::Create(*refiner_, how, chosen));

    first_.push_back(0);
    for (int level = 0; level < refiner_->GetNumLevels(); ++level)
        first_.push_back(first_.back() + refiner_->GetLevel(level).GetNumVertices());
    const far::PatchMap map(*patches_);
    const far::TopologyLevel& base = refiner_->GetLevel(0);
    int quad = 0;
    for (int face = 0; face < base.GetNumFaces(); ++face) {
        const int sides = base.GetFaceVertices(face).size();
        const bool is_wanted =
            !base.IsFaceHole(face) && (only.empty() || std::ranges::find(only, face) != only.end());
        if (is_wanted && sides == 4) {
            add_leaves({face, quad, 0, face, 0, 0, 1, false, 0, {}}, map);
        } else if (is_wanted && refiner_->GetNumLevels() > 1) {
            const auto children = base.GetFaceChildFaces(face);
            for (int k = 0; k < children.size(); ++k)
                add_leaves({face, quad + k, 1, children[k], 0, 0, 1, false, 0, {}}, map);
        }
        quad += sides == 4 ? 1 : sides;
    }
}

void refined_mesh::add_leaves(leaf of, const far::PatchMap& map) {
    const auto* const found = map.FindPatch(of.quad, of.u + of.size / 2, of.v + of.size / 2);
    if (!found)
        throw std::runtime_error("OpenSubdiv has no patch for a face");
    const far::PatchParam param = patches_->GetPatchParam(*found);
    if (param.GetDepth() > of.level) {
        const auto children = refiner_->GetLevel(of.level).GetFaceChildFaces(of.face);
        for (int k = 0; k < 4; ++k) {
            leaf child = of;
            ++child.level;
            child.face = children[k];
            child.size = of.size / 2;
            child.u = of.u + (k == 1 || k == 2 ? child.size : 0);
            child.v = of.v + (k >= 2 ? child.size : 0);
            add_leaves(child, map);
        }
        return;
    }
    of.handle = *found;
    of.is_regular = patches_->GetPatchDescriptor(*found).GetType() == far::PatchDescriptor::REGULAR;
    of.boundary = param.GetBoundary();
    leaves_.push_back(of);
}

std::vector<int> refined_mesh::ring_of(const leaf& of) const {
    const far::TopologyLevel& level = refiner_->GetLevel(of.level);
    std::vector<int> result;
    for (const int corner : level.GetFaceVertices(of.face))
        for (const int face : level.GetVertexFaces(corner))
            for (const int vertex : level.GetFaceVertices(face))
                result.push_back(first_of(of.level) + vertex);
    std::ranges::sort(result);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

} // namespace l3d_limit
