// SPDX-License-Identifier: MIT
// peer_mesh: patch meshes put together, measured, and ordered for vertex caches.
#include "bench/peer_mesh.h"

#include "bench/mesh_thinning.h"
#include "bench/surface_error.h"
#include "geom/normal_net.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace {

/// A ring triangle's centre can err more than the boundary chord that it lies on.
constexpr double boundary_share = 0.92;

double grey_of(const mesh_wish& wish, std::size_t patch, const mesh_corner& corner) {
    auto normal = l3d_normalized(wish.model.normals(patch).evaluate(corner.u, corner.v));
    if (l3d_dot(normal, wish.camera.eye - corner.position) < 0)
        normal = normal * -1.0;
    return 0.1 + 0.9 * std::max(0.0, l3d_dot(normal, l3d_normalized(wish.light)));
}

/// Patches by the distance of their nearest control point.
std::vector<std::size_t> nearest_first(const mesh_wish& wish) {
    const seen_world world(wish.camera, wish.size);
    std::vector<double> nearest;
    for (const auto& patch : wish.model.patches()) {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& p : patch.points)
            least = std::min(least, world(p)[2]);
        nearest.push_back(least);
    }
    std::vector<std::size_t> order(nearest.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return nearest[i]; });
    return order;
}

/// Triangles in an order in which each shares vertices with those just before: fans around the
/// vertices of the fan before.
std::vector<patch_mesh::triangle> in_fans(const patch_mesh& mesh) {
    std::vector<std::vector<std::uint32_t>> star(mesh.corners.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (const std::uint32_t i : mesh.triangles[t])
            star[i].push_back(t);
    std::vector<bool> done(mesh.triangles.size()), seen(mesh.corners.size());
    std::vector<patch_mesh::triangle> order;
    for (std::uint32_t start = 0; start < star.size(); ++start) {
        std::vector<std::uint32_t> waiting{start}; // first come, first served: ring by ring
        for (std::size_t next = 0; next < waiting.size(); ++next)
            for (const std::uint32_t t : star[waiting[next]]) {
                if (done[t])
                    continue;
                done[t] = true;
                order.push_back(mesh.triangles[t]);
                for (const std::uint32_t i : mesh.triangles[t])
                    if (!seen[i]) {
                        seen[i] = true;
                        waiting.push_back(i);
                    }
            }
    }
    return order;
}

/// Appends a patch, vertices in the order of their first use.
void append(const mesh_wish& wish, std::size_t patch, const patch_mesh& part, peer_mesh& mesh) {
    constexpr std::uint32_t unused = ~0u;
    std::vector<std::uint32_t> place(part.corners.size(), unused);
    for (const auto& t : in_fans(part))
        for (const std::uint32_t i : t) {
            if (place[i] == unused) {
                place[i] = static_cast<std::uint32_t>(mesh.greys.size());
                const mesh_corner& c = part.corners[i];
                for (int k = 0; k < 3; ++k)
                    mesh.positions.push_back(static_cast<float>(c.position[k]));
                mesh.greys.push_back(static_cast<float>(grey_of(wish, patch, c)));
            }
            mesh.indices.push_back(place[i]);
        }
}

/// Puts together what `make` makes of each patch.
template <class Make>
peer_mesh assembled(const mesh_wish& wish, const char* kind, const seen_world& world, Make make) {
    peer_mesh mesh;
    mesh.kind = kind;
    surface_error error(wish.camera, wish.size);
    for (const std::size_t i : nearest_first(wish)) {
        const seen_patch patch(wish.model.patches()[i], world);
        patch_mesh part = make(patch, i);
        part.keep_visible(patch);
        for (const auto& t : part.triangles)
            part.each_sample(t, [&](const l3d_image_point& drawn, double u, double v) {
                error.add_point(patch.patch(), drawn, u, v);
            });
        append(wish, i, part, mesh);
    }
    mesh.error = error.largest();
    return mesh;
}

/// Grids that err by at most a tolerance, and the edges between them.
class grids {
public:
    grids(const mesh_wish& wish, const seen_world& world, double tolerance)
        : edges_(wish.model, world, boundary_share * tolerance), tolerance_(tolerance) {
        const std::size_t count = wish.model.patches().size();
        for (std::size_t i = 0; i < count; ++i)
            patches_.emplace_back(wish.model.patches()[i], world);
        for (std::size_t i = 0; i < count; ++i)
            makers_.emplace_back(patches_[i], i);
        // Errors of the two directions need not be worst in one place, nor point one way.
        scales_.assign(count, 2.0);
        for (bool again = true; again;) {
            again = false;
            for (std::size_t i = 0; i < count; ++i) {
                makers_[i].set_steps(tolerance, scales_[i]);
                while (makers_[i].improve(edges_, tolerance, scales_[i])) {
                    makers_[i].set_steps(tolerance, scales_[i]);
                    again = true; // the edges of its neighbours may be others now
                }
            }
        }
    }

    /// `finer` times as small an error.
    patch_mesh grid(std::size_t i, double finer = 1) {
        makers_[i].set_steps(tolerance_, scales_[i] / finer);
        return makers_[i].grid(edges_);
    }

private:
    shared_edges edges_;
    double tolerance_;
    std::vector<seen_patch> patches_;
    std::vector<grid_maker> makers_;
    std::vector<double> scales_;
};

} // namespace

peer_mesh adaptive_mesh(const mesh_wish& wish) {
    const seen_world world(wish.camera, wish.size);
    grids made(wish, world, wish.tolerance);
    return assembled(wish, "adaptive", world,
                     [&](const seen_patch&, std::size_t i) { return made.grid(i); });
}

peer_mesh thinned_mesh(const mesh_wish& wish) {
    constexpr double finest = 2.5; // the fewest triangles on the teapot; 1.8 has a twentieth more
    const seen_world world(wish.camera, wish.size);
    grids made(wish, world, wish.tolerance);
    return assembled(wish, "thinned", world, [&](const seen_patch& patch, std::size_t i) {
        // Beside coarse edges a finer grid can err more, and thinning mends no error; the grid as
        // it is errs nowhere too much.
        for (double finer = finest;; finer = std::max(1.0, 0.8 * finer)) {
            patch_mesh mesh = made.grid(i, finer);
            thin_out(mesh, patch, wish.tolerance);
            mesh.keep_visible(patch);
            if (finer == 1 || mesh.error(patch) <= wish.tolerance)
                return mesh;
        }
    });
}
