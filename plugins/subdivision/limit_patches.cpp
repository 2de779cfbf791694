// SPDX-License-Identifier: MIT
// limit_patches: makes as many levels as the error needs, then gives neighbours common sides and
// corners.
#include "limit_patches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace l3d_limit {

namespace far = OpenSubdiv::Far;

namespace {

/// The four control points of a patch's side.
using curve = std::array<place, 4>;

curve reversed(const curve& c) {
    return {c[3], c[2], c[1], c[0]};
}

std::pair<curve, curve> halves(const curve& c) {
    std::pair<curve, curve> result;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto both = halves_of(c[0][k], c[1][k], c[2][k], c[3][k]);
        for (std::size_t i = 0; i < 4; ++i) {
            result.first[i][k] = both[i];
            result.second[i][k] = both[i + 3];
        }
    }
    return result;
}

double distance(const place& a, const place& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A place with the operations that OpenSubdiv's Far needs.
struct point {
    place at{};

    void Clear() { at = {}; }
    void AddWithWeight(const point& other, double by) {
        for (std::size_t k = 0; k < 3; ++k)
            at[k] += by * other.at[k];
    }
};

/// The indices of each side's control points, in order around the patch.
constexpr std::size_t side_points[4][4] = {
    {0, 1, 2, 3}, {3, 7, 11, 15}, {15, 14, 13, 12}, {12, 8, 4, 0}};

place point_of(const std::array<net, 3>& of, std::size_t k) {
    return {of[0][k], of[1][k], of[2][k]};
}

/// Gives all patches that meet at a vertex or along an edge the same control points at this place,
/// bit for bit. These are the points of the coarsest patch. Where neighbours are half as large,
/// they are the points of the halves of its side.
class common_borders {
public:
    explicit common_borders(const refined_mesh& mesh) : mesh_(mesh) {
        for (int level = 0; level < mesh.refiner().GetNumLevels(); ++level) {
            edges_.emplace_back(
                static_cast<std::size_t>(mesh.refiner().GetLevel(level).GetNumEdges()));
            vertices_.emplace_back(
                static_cast<std::size_t>(mesh.refiner().GetLevel(level).GetNumVertices()));
        }
    }

    /// Replaces the control points on the sides of a leaf's patch by the points common to all
    /// patches there.
    /// Expects: unite() is called for coarser leaves before finer leaves, and in each level for
    ///          exact patches first. Returns the largest distance by which a control point was
    ///          moved.
    double unite(const leaf& of, std::array<net, 3>& patch) {
        const std::array<net, 3> before = patch;
        const auto put = [&](std::size_t k, const place& to) {
            for (std::size_t i = 0; i < 3; ++i)
                patch[i][k] = to[i];
        };
        const far::TopologyLevel& level = mesh_.refiner().GetLevel(of.level);
        const auto corners = level.GetFaceVertices(of.face);
        const auto edges = level.GetFaceEdges(of.face);
        for (int side = 0; side < 4; ++side) {
            const std::size_t at = side_points[side][0];
            put(at, vertex(of.level, corners[side], point_of(patch, at)));
        }
        for (int side = 0; side < 4; ++side) {
            const auto& at = side_points[side];
            curve own{};
            for (std::size_t k = 0; k < 4; ++k)
                own[k] = point_of(patch, at[k]);
            const curve common = edge(of.level, edges[side], corners[side], own);
            for (std::size_t k = 1; k < 3; ++k)
                put(at[k], common[k]);
        }
        double moved = 0;
        for (std::size_t k = 0; k < 16; ++k)
            moved = std::max(moved, distance(point_of(patch, k), point_of(before, k)));
        return moved;
    }

private:
    struct known_edge {
        int from = 0;
        curve points{};
    };

    std::optional<place>& known(int level, int vertex) {
        return vertices_[static_cast<std::size_t>(level)][static_cast<std::size_t>(vertex)];
    }
    bool has_finer(int level) const { return level + 1 < mesh_.refiner().GetNumLevels(); }

    /// The common place of a vertex of a level: the place known from an earlier patch, or else
    /// `own`. It stays the same at all finer levels.
    place vertex(int level, int which, const place& own) {
        if (known(level, which))
            return *known(level, which);
        while (which >= 0) {
            known(level, which) = own;
            which = has_finer(level) ? mesh_.refiner().GetLevel(level++).GetVertexChildVertex(which)
                                     : -1;
        }
        return own;
    }

    curve edge(int level, int which, int from, const curve& own) {
        std::optional<known_edge>& there =
            edges_[static_cast<std::size_t>(level)][static_cast<std::size_t>(which)];
        if (there)
            return there->from == from ? there->points : reversed(there->points);
        there = known_edge{from, own};
        if (!has_finer(level))
            return own;
        const far::TopologyLevel& at = mesh_.refiner().GetLevel(level);
        const auto ends = at.GetEdgeVertices(which);
        const auto children = at.GetEdgeChildEdges(which);
        const int middle = at.GetEdgeChildVertex(which);
        const auto [first, second] = halves(own);
        if (middle >= 0)
            vertex(level + 1, middle, second[0]);
        for (int k = 0; k < children.size(); ++k) {
            if (children[k] < 0)
                continue;
            const bool is_first = ends[k] == from;
            edge(level + 1, children[k], is_first ? at.GetVertexChildVertex(from) : middle,
                 is_first ? first : second);
        }
        return own;
    }

    const refined_mesh& mesh_;
    std::vector<std::vector<std::optional<known_edge>>> edges_;
    std::vector<std::vector<std::optional<place>>> vertices_;
};

/// The patches of all leaves, before common_borders changes their sides.
struct level_patches {
    std::vector<std::array<net, 3>> patches;
    std::vector<double> errors; ///< bound of each patch's error; 0 for exact patches
    double error = 0;
    std::size_t caps = 0;
};

level_patches patches_of(const refined_mesh& mesh, const std::vector<point>& points,
                         cap_shapes& shapes) {
    level_patches result;
    for (const leaf& one : mesh.leaves()) {
        std::array<net, 3>& to = result.patches.emplace_back();
        double& error = result.errors.emplace_back(0);
        if (one.is_regular) {
            const auto control = mesh.control_points(points, one);
            for (std::size_t k = 0; k < 3; ++k) {
                net p{};
                for (std::size_t i = 0; i < 16; ++i)
                    p[i] = control[i].at[k];
                reflect_at_boundaries(p, one.boundary);
                to[k] = bezier_of(p);
            }
            continue;
        }
        const face_ring ring(mesh.refiner().GetLevel(one.level), one.face);
        std::vector<place> places;
        for (const int vertex : ring.vertices)
            places.push_back(
                points[static_cast<std::size_t>(mesh.first_of(one.level) + vertex)].at);
        const cap made = shapes.of(ring, places);
        to = made.bezier;
        error = made.error;
        result.error = std::max(result.error, made.error);
        ++result.caps;
    }
    return result;
}

/// Bound of the rounding of patches' control points. A vertex is a sum of products with weights
/// that add up to 1. There is at most one product for each level and each vertex of a ring. With
/// fewer than 2^10 vertices in a ring, 10 levels and the 2^3 roundings of bezier_of, rounding is
/// less than 2^14 times half an ulp of the largest coordinate.
double rounding_of(const std::vector<place>& places) {
    double largest = 0;
    for (const place& p : places)
        for (const double coordinate : p)
            largest = std::max(largest, std::abs(coordinate));
    return 0x1p14 * 0x1p-53 * largest;
}

} // namespace

limit_patches::limit_patches(const mesh_topology& mesh, const std::vector<place>& places,
                             OpenSubdiv::Sdc::Options options, double wanted, std::size_t most) {
    cap_shapes shapes(options);
    std::vector<point> cage;
    for (const place& at : places)
        cage.push_back({at});
    std::unique_ptr<const refined_mesh> chosen;
    level_patches of_chosen;
    constexpr int most_levels = 10; // as many as Far makes
    for (int level = 1; level <= most_levels; ++level) {
        auto refined = std::make_unique<const refined_mesh>(mesh, options, level);
        if (chosen && refined->leaves().size() > most)
            break;
        of_chosen = patches_of(*refined, refined->refined(cage), shapes);
        chosen = std::move(refined);
        levels = level;
        if (of_chosen.caps == 0 || of_chosen.error <= wanted)
            break;
    }
    leaves = chosen->leaves();
    patches = std::move(of_chosen.patches);
    caps = of_chosen.caps;

    std::vector<std::size_t> order(leaves.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
        return std::pair(leaves[i].level, !leaves[i].is_regular);
    });
    common_borders borders(*chosen);
    errors = std::move(of_chosen.errors);
    for (const std::size_t i : order)
        errors[i] += borders.unite(leaves[i], patches[i]) + rounding_of(places);
    error = std::ranges::max(errors);
}

} // namespace l3d_limit
