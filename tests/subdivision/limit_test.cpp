// SPDX-License-Identifier: MIT
// Patches of subdivision surfaces against OpenSubdiv's own evaluation of the limit surface.
#include "subdivision/cages.h"

#include "plugins/subdivision/limit_patches.h"

#include <gtest/gtest.h>

#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace subdivision_tests {
namespace {

namespace far = OpenSubdiv::Far;
using l3d_limit::limit_patches;
using l3d_limit::mesh_topology;
using l3d_limit::place;

mesh_topology topology_of(const l3d_model_file& model) {
    mesh_topology result;
    result.vertices = static_cast<int>(model.mesh.vertices.size());
    for (std::size_t i = 0; i < model.mesh.faces(); ++i) {
        const auto face = model.mesh.face(i);
        result.face_sizes.push_back(static_cast<int>(face.size()));
        result.corners.insert(result.corners.end(), face.begin(), face.end());
    }
    for (const auto& crease : model.tags.creases) {
        result.crease_vertices.push_back(static_cast<int>(crease.from));
        result.crease_vertices.push_back(static_cast<int>(crease.to));
        result.crease_sharpness.push_back(crease.sharpness);
    }
    for (const auto& corner : model.tags.corners) {
        result.point_vertices.push_back(static_cast<int>(corner.vertex));
        result.point_sharpness.push_back(corner.sharpness);
    }
    return result;
}

OpenSubdiv::Sdc::Options options_of(const l3d_model_file& model) {
    using options = OpenSubdiv::Sdc::Options;
    options result;
    result.SetVtxBoundaryInterpolation(model.tags.keeps_corners.value_or(true)
                                           ? options::VTX_BOUNDARY_EDGE_AND_CORNER
                                           : options::VTX_BOUNDARY_EDGE_ONLY);
    return result;
}

struct point {
    place at{};
    void Clear() { at = {}; }
    void AddWithWeight(const point& other, double by) {
        for (std::size_t k = 0; k < 3; ++k)
            at[k] += by * other.at[k];
    }
};

std::vector<place> places_of(const l3d_model_file& model) {
    std::vector<place> result;
    for (const auto& v : model.mesh.vertices)
        result.push_back({v[0], v[1], v[2]});
    return result;
}

std::unique_ptr<far::TopologyRefiner> refiner_of(const mesh_topology& mesh,
                                                 OpenSubdiv::Sdc::Options options) {
    far::TopologyDescriptor d;
    d.numVertices = mesh.vertices;
    d.numFaces = static_cast<int>(mesh.face_sizes.size());
    d.numVertsPerFace = mesh.face_sizes.data();
    d.vertIndicesPerFace = mesh.corners.data();
    d.numCreases = static_cast<int>(mesh.crease_sharpness.size());
    d.creaseVertexIndexPairs = mesh.crease_vertices.data();
    d.creaseWeights = mesh.crease_sharpness.data();
    d.numCorners = static_cast<int>(mesh.point_sharpness.size());
    d.cornerVertexIndices = mesh.point_vertices.data();
    d.cornerWeights = mesh.point_sharpness.data();
    using factory = far::TopologyRefinerFactory<far::TopologyDescriptor>;
    return std::unique_ptr<far::TopologyRefiner>(
        factory::Create(d, factory::Options(OpenSubdiv::Sdc::SCHEME_CATMARK, options)));
}

/// The vertices of all levels.
std::vector<point> points_of(const far::TopologyRefiner& refiner,
                             const std::vector<place>& places) {
    std::vector<point> result(static_cast<std::size_t>(refiner.GetNumVerticesTotal()));
    for (std::size_t i = 0; i < places.size(); ++i)
        result[i].at = places[i];
    const far::PrimvarRefinerReal<double> by(refiner);
    point* from = result.data();
    for (int level = 1; level < refiner.GetNumLevels(); ++level) {
        point* const to = from + refiner.GetLevel(level - 1).GetNumVertices();
        by.Interpolate(level, from, to);
        from = to;
    }
    return result;
}

/// A model's cage with all of its faces subdivided four times. Its limit surface is the model's.
struct fine_cage {
    static constexpr int levels = 4;

    OpenSubdiv::Sdc::Options options;
    std::unique_ptr<far::TopologyRefiner> refiner;
    mesh_topology mesh;
    std::vector<place> places;

    explicit fine_cage(const l3d_model_file& model);

    /// Replaces a place of a quad of the model by the same of a face of this cage.
    void descend(int& quad, double& u, double& v) const;
};

fine_cage::fine_cage(const l3d_model_file& model)
    : options(options_of(model)), refiner(refiner_of(topology_of(model), options)) {
    far::TopologyRefiner::UniformOptions how(levels);
    how.fullTopologyInLastLevel = true;
    refiner->RefineUniform(how);
    const far::TopologyLevel& last = refiner->GetLevel(levels);
    mesh.vertices = last.GetNumVertices();
    for (int face = 0; face < last.GetNumFaces(); ++face) {
        const auto corners = last.GetFaceVertices(face);
        mesh.face_sizes.push_back(corners.size());
        mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
    }
    for (int edge = 0; edge < last.GetNumEdges(); ++edge)
        if (last.GetEdgeSharpness(edge) > 0 && !last.IsEdgeBoundary(edge)) {
            const auto ends = last.GetEdgeVertices(edge);
            mesh.crease_vertices.insert(mesh.crease_vertices.end(), ends.begin(), ends.end());
            mesh.crease_sharpness.push_back(last.GetEdgeSharpness(edge));
        }
    for (int vertex = 0; vertex < mesh.vertices; ++vertex)
        if (last.GetVertexSharpness(vertex) > 0) {
            mesh.point_vertices.push_back(vertex);
            mesh.point_sharpness.push_back(last.GetVertexSharpness(vertex));
        }
    const std::vector<point> all = points_of(*refiner, places_of(model));
    for (auto p = all.end() - mesh.vertices; p != all.end(); ++p)
        places.push_back(p->at);
}

void fine_cage::descend(int& quad, double& u, double& v) const {
    // A face of n corners is n quads, its faces at level 1, unless n is four.
    int level = 0, face = 0;
    for (;; ++face) {
        const int corners = refiner->GetLevel(0).GetFaceVertices(face).size();
        const int quads = corners == 4 ? 1 : corners;
        if (quad < quads) {
            if (corners != 4)
                face = refiner->GetLevel(level++).GetFaceChildFaces(face)[quad];
            break;
        }
        quad -= quads;
    }
    // The four parts of a quad have its directions, and lie in the order of its corners.
    for (; level < levels; ++level) {
        const bool high_u = u >= 0.5, high_v = v >= 0.5;
        const int part = high_v ? (high_u ? 2 : 3) : high_u ? 1 : 0;
        face = refiner->GetLevel(level).GetFaceChildFaces(face)[part];
        u = 2 * u - (high_u ? 1 : 0);
        v = 2 * v - (high_v ? 1 : 0);
    }
    quad = face;
}

/// The limit surface by a table of patches after ten subdivisions, with none of the plug-in's code.
class far_surface {
public:
    far_surface(const mesh_topology& mesh, const std::vector<place>& places,
                OpenSubdiv::Sdc::Options options)
        : refiner_(refiner_of(mesh, options)) {
        far::PatchTableFactory::Options how(10);
        how.useInfSharpPatch = true;
        how.generateLegacySharpCornerPatches = false;
        how.SetPatchPrecision<double>();
        refiner_->RefineAdaptive(how.GetRefineAdaptiveOptions());
        patches_.reset(far::PatchTableFactory::Create(*refiner_, how));
        map_ = std::make_unique<far::PatchMap>(*patches_);
        points_ = points_of(*refiner_, places);
    }

    /// The surface at (u, v) of a quad, if it is one of the exact patches there.
    bool evaluate(int quad, double u, double v, place& at) const {
        const auto* const found = map_->FindPatch(quad, u, v);
        if (!found ||
            patches_->GetPatchDescriptor(*found).GetType() != far::PatchDescriptor::REGULAR)
            return false;
        double weights[16];
        patches_->EvaluateBasis(*found, u, v, weights);
        const auto vertices = patches_->GetPatchVertices(*found);
        at = {};
        for (int i = 0; i < 16; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                at[k] += weights[i] * points_[static_cast<std::size_t>(vertices[i])].at[k];
        return true;
    }

private:
    std::unique_ptr<far::TopologyRefiner> refiner_;
    std::unique_ptr<far::PatchTable> patches_;
    std::unique_ptr<far::PatchMap> map_;
    std::vector<point> points_;
};

double value_of(const l3d_limit::net& p, double u, double v) {
    const double a = 1 - u, b = 1 - v;
    const double in_u[4] = {a * a * a, 3 * a * a * u, 3 * a * u * u, u * u * u};
    const double in_v[4] = {b * b * b, 3 * b * b * v, 3 * b * v * v, v * v * v};
    double sum = 0;
    for (std::size_t i = 0; i < 16; ++i)
        sum += in_v[i / 4] * in_u[i % 4] * p[i];
    return sum;
}

limit_patches patches_of(const l3d_model_file& model, double wanted) {
    return {topology_of(model), places_of(model), options_of(model), wanted, 1 << 17};
}

/// The distance of a place of a patch from another place.
double distance_at(const limit_patches& of, std::size_t patch, double s, double t,
                   const place& from) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double off = value_of(of.patches[patch][k], s, t) - from[k];
        sum += off * off;
    }
    return std::sqrt(sum);
}

/// The largest distance at random places: half of them anywhere, half in patches that are not
/// exact.
double farthest(const l3d_model_file& model, const limit_patches& of, int places,
                std::mt19937& random) {
    const far_surface limit(topology_of(model), places_of(model), options_of(model));
    std::vector<std::size_t> caps;
    for (std::size_t i = 0; i < of.leaves.size(); ++i)
        if (!of.leaves[i].is_regular)
            caps.push_back(i);
    std::uniform_real_distribution<double> part(0, 1);
    double most = 0;
    for (int i = 0; i < places; ++i) {
        const bool in_cap = i % 2 == 0 && !caps.empty();
        const std::size_t count = in_cap ? caps.size() : of.leaves.size();
        const std::size_t drawn = random() % count;
        const std::size_t which = in_cap ? caps[drawn] : drawn;
        const auto& leaf = of.leaves[which];
        const double s = part(random), t = part(random);
        place exact{};
        if (!limit.evaluate(leaf.quad, leaf.u + leaf.size * s, leaf.v + leaf.size * t, exact))
            continue;
        most = std::max(most, distance_at(of, which, s, t, exact));
    }
    return most;
}

TEST(limit_patches, are_within_their_bound_of_the_limit_surface_at_100000_places) {
    std::mt19937 random(5401);
    const auto cages = all_cages();
    const int places = 100000 / static_cast<int>(cages.size()) + 1;
    for (const named_cage& cage : cages)
        for (const double wanted : {0.03, 0.001}) {
            const limit_patches made = patches_of(cage.model, wanted);
            // Far's own evaluation is exact nowhere in caps of its deepest level.
            const bool is_deepest = made.levels == 10;
            EXPECT_TRUE(made.error <= wanted || is_deepest) << cage.name << ": " << made.error;
            EXPECT_LT(made.error, std::max(wanted, 0.002)) << cage.name;
            const double most = farthest(cage.model, made, places / 2 + 1, random);
            EXPECT_LE(most, made.error) << cage.name;
            // A bound ten times as large as what is seen would be of little use.
            EXPECT_TRUE(made.caps == 0 || is_deepest || most > made.error / 10)
                << cage.name << ": " << most;
        }
}

/// The largest distance at random places of caps of the deepest level.
double farthest_in_deepest_caps(const l3d_model_file& model, const limit_patches& of, int places,
                                std::mt19937& random, int& judged) {
    const fine_cage fine(model);
    const far_surface limit(fine.mesh, fine.places, fine.options);
    std::vector<std::size_t> caps;
    for (std::size_t i = 0; i < of.leaves.size(); ++i)
        if (!of.leaves[i].is_regular && of.leaves[i].level == 10)
            caps.push_back(i);
    std::uniform_real_distribution<double> part(0, 1);
    double most = 0;
    for (int i = 0; i < places && !caps.empty(); ++i) {
        const std::size_t which = caps[random() % caps.size()];
        const auto& leaf = of.leaves[which];
        const double s = part(random), t = part(random);
        int quad = leaf.quad;
        double u = leaf.u + leaf.size * s, v = leaf.v + leaf.size * t;
        fine.descend(quad, u, v);
        place exact{};
        if (!limit.evaluate(quad, u, v, exact))
            continue;
        ++judged;
        most = std::max(most, distance_at(of, which, s, t, exact));
    }
    return most;
}

TEST(limit_patches, of_the_deepest_level_are_within_their_bound_of_the_limit_surface) {
    std::mt19937 random(5403);
    int judged = 0;
    for (const named_cage& cage : all_cages()) {
        const limit_patches made = patches_of(cage.model, 1e-12);
        if (made.levels < 10)
            continue;
        const double most = farthest_in_deepest_caps(cage.model, made, 4000, random, judged);
        EXPECT_LE(most, made.error) << cage.name;
    }
    EXPECT_GT(judged, 40000);
}

TEST(limit_patches, are_all_exact_where_all_is_regular) {
    const limit_patches made = patches_of(torus_of_quads(), 0.1);
    EXPECT_EQ(made.caps, 0U);
    EXPECT_EQ(made.patches.size(), 96U);
    EXPECT_LT(made.error, 1e-11);
}

TEST(limit_patches, that_may_not_become_more_say_the_error_that_is_left) {
    const l3d_model_file model = cube();
    const limit_patches few(topology_of(model), places_of(model), options_of(model), 1e-6, 100);
    EXPECT_LE(few.patches.size(), 100U);
    EXPECT_GT(few.error, 1e-3);
    std::mt19937 random(5402);
    EXPECT_LE(farthest(model, few, 2000, random), few.error);
}

} // namespace
} // namespace subdivision_tests
