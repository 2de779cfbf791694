// SPDX-License-Identifier: MIT
// l3d_pick_at: meets patches with a ray in the ray's coordinates, and describes the hit.
#include "scene/patch_scene.h"

#include "base/formatted_p.h"
#include "base/printable_p.h"
#include "geom/transform.h"
#include "geom/trims/trim_region.h"
#include "scene/picks/ray_search.h"
#include "scene/picks/surface_jet.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <limits>
#include <string_view>
#include <vector>

namespace {

using vector = l3d_camera::vector;
using patch_3 = l3d_patch_model::patch;
using l3d_detail::formatted;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The rounding of a point's coordinate in eye_ray::seen, as a part of the sum of the magnitudes of
/// all terms. The axes are good to 24 roundings, products and sums add 8, and placing the model
/// adds 8. Halving adds 6, as halves become smaller, and evaluating 12. Twice their sum is more
/// than enough.
constexpr double ray_rounding = 128 * 0x1p-53;
/// The rounding of a coordinate in the world, as a part of the same sum of magnitudes.
constexpr double world_rounding = 16 * 0x1p-53;

/// The ray through a place of a picture. The class maps points to two coordinates that are 0 on the
/// ray, and to depth.
class eye_ray {
public:
    eye_ray(const l3d_pick_view& view, double x, double y)
        : eye_(view.camera.eye), axes_(view.camera.axes()) {
        const double right = x - view.size.width / 2.0, up = view.size.height / 2.0 - y;
        if (view.camera.is_parallel()) {
            const double scale = view.camera.scale_at_target(view.size);
            eye_ += axes_.right * (right / scale) + axes_.up * (up / scale);
        } else {
            const double focal = view.camera.focal_length(view.size);
            right_ = right / focal;
            up_ = up / focal;
        }
    }

    /// The place of the ray at a depth.
    vector at(double depth) const { return eye_ + direction() * depth; }

    l3d_ray_net::point seen(const vector& world) const {
        const vector arm = world - eye_;
        const double depth = l3d_dot(axes_.forward, arm);
        return {l3d_dot(axes_.right, arm) - right_ * depth, l3d_dot(axes_.up, arm) - up_ * depth,
                depth};
    }

    /// Bound of the rounding of seen() for a point with the l3d_patch_instance::reach() `reach`.
    double rounding(double reach) const {
        const double eye = std::max({std::abs(eye_[0]), std::abs(eye_[1]), std::abs(eye_[2])});
        return ray_rounding * 3 * (reach + eye) * slant();
    }

    /// A bound of the length of a step, from its parts across the ray and along the depth.
    double length(double across, double depth) const { return across + depth * slant(); }

    vector direction() const { return axes_.forward + axes_.right * right_ + axes_.up * up_; }

private:
    double slant() const { return 1 + std::abs(right_) + std::abs(up_); }

    vector eye_; ///< where the ray begins; in a parallel projection, not the camera's eye
    l3d_camera::frame axes_;
    double right_ = 0, up_ = 0;
};

patch_3 placed(const patch_3& patch, const l3d_patch_instance& instance) {
    patch_3 result = patch;
    const l3d_matrix<double>& m = instance.placement();
    if (m == l3d_identity<double>())
        return result;
    for (vector& point : result.points)
        point = l3d_transformed(m, l3d_point<double>(point)).from_origin;
    return result;
}

/// A patch's instance, and its index in that instance's model.
struct place_in_scene {
    std::size_t instance, patch;
};

void describe_surface(l3d_pick& pick, const l3d_surface_jet& jet, const vector& ray) {
    pick.normal_error = pick.gaussian_error = pick.mean_error = infinite;
    if (!jet.normal)
        return;
    const vector normal = l3d_middle(*jet.normal);
    const double side = l3d_dot(normal, ray) > 0 ? -1 : 1;
    pick.normal = normal * side;
    pick.normal_error = l3d_radius(*jet.normal);
    pick.gaussian = jet.gaussian.middle();
    pick.gaussian_error = jet.gaussian.radius();
    pick.mean = jet.mean.middle() * side;
    pick.mean_error = jet.mean.radius();
}

void add_line(std::string& text, const char* name, std::initializer_list<double> values,
              double error) {
    text += name;
    for (const double value : values)
        text += formatted(" %.15g", value);
    text += formatted(" +- %.2g\n", error);
}

std::string part_of(const l3d_patch_model& model, std::size_t patch) {
    return std::string(model.parts().name_of(model.piece_of(patch)));
}

/// The depths of a ray between which surfaces are drawn; nothing if the section cuts off the whole
/// ray.
std::optional<std::pair<double, double>> depths_drawn(const l3d_pick_view& view,
                                                      const eye_ray& ray) {
    const bool is_parallel = view.camera.is_parallel(); // near and far cut nothing then
    double near = is_parallel ? -infinite : view.camera.near_z;
    double far = is_parallel ? infinite : view.camera.far_z;
    if (view.section) {
        const double side = view.section->side_of_point(l3d_point<double>(ray.at(0)));
        const double growth = l3d_dot(view.section->normal, ray.direction());
        if (growth == 0 && side < 0)
            return std::nullopt;
        if (growth != 0)
            (growth > 0 ? near : far) =
                growth > 0 ? std::max(near, -side / growth) : std::min(far, -side / growth);
    }
    return std::pair(near, far);
}

/// Describes the place of a patch that a ray hits. `patch` is the patch in the world.
l3d_pick pick_of(const l3d_ray_hit& hit, const eye_ray& ray, const l3d_patch_scene& scene,
                 const place_in_scene& where, const patch_3& patch) {
    const l3d_patch_instance& instance = scene.instances()[where.instance];
    const double rounding = world_rounding * instance.reach();
    const l3d_surface_jet jet(patch, hit.u, hit.v, hit.u_error, hit.v_error, rounding);
    l3d_pick pick{.instance = where.instance,
                  .patch = where.patch,
                  .part = part_of(instance.model(), where.patch),
                  .u = hit.u,
                  .v = hit.v,
                  .u_error = hit.u_error,
                  .v_error = hit.v_error,
                  .point = l3d_middle(jet.point),
                  .point_error = l3d_radius(jet.point),
                  .depth = hit.depth,
                  .is_proven = hit.is_proven};
    if (!hit.is_proven) {
        pick.point = ray.at(hit.depth);
        pick.point_error = ray.length(hit.width, hit.depth_width) + rounding;
    }
    describe_surface(pick, jet, ray.direction());
    return pick;
}

} // namespace

std::optional<l3d_pick> l3d_pick_at(const l3d_patch_scene& scene, const l3d_pick_view& view,
                                    double x, double y) {
    const eye_ray ray(view, x, y);
    std::vector<place_in_scene> places;
    const auto world_patch = [&](std::size_t number) {
        const l3d_patch_instance& instance = scene.instances()[places[number].instance];
        return placed(instance.model().patches()[places[number].patch], instance);
    };
    const auto shows_front = [&](const l3d_ray_hit& hit) {
        const patch_3 patch = world_patch(hit.patch);
        const vector normal =
            l3d_cross(patch.derivative_u(hit.u, hit.v), patch.derivative_v(hit.u, hit.v));
        const l3d_patch_instance& instance = scene.instances()[places[hit.patch].instance];
        const bool mirrored = l3d_determinant(instance.placement()) < 0;
        return (l3d_dot(normal, ray.direction()) < 0) != mirrored;
    };
    const auto depths = depths_drawn(view, ray);
    if (!depths)
        return std::nullopt;
    const auto is_there = [&](const l3d_ray_hit& hit) {
        const auto& [instance, patch] = places[hit.patch];
        const l3d_trim_region* const region = scene.instances()[instance].model().trim(patch);
        return region == nullptr || region->contains({hit.u, hit.v});
    };
    l3d_ray_search search(depths->first, depths->second, [&](const l3d_ray_hit& hit) {
        return is_there(hit) && (!view.one_sided || shows_front(hit));
    });
    for (std::size_t i = 0; i < scene.instances().size(); ++i) {
        const l3d_patch_instance& instance = scene.instances()[i];
        if (instance.opacity() == 0) // it is invisible
            continue;
        const double error = ray.rounding(instance.reach());
        for (std::size_t p = 0; p < instance.model().patches().size(); ++p) {
            l3d_ray_net net = placed(instance.model().patches()[p], instance);
            for (vector& point : net.points)
                point = ray.seen(point);
            search.add(places.size(), net, error);
            places.push_back({i, p});
        }
    }
    const auto hit = search.nearest();
    if (!hit)
        return std::nullopt;
    return pick_of(*hit, ray, scene, places[hit->patch], world_patch(hit->patch));
}

std::string l3d_pick::text() const {
    std::string result = "patch " + std::to_string(patch) + "\n";
    if (!part.empty())
        result += "part " + l3d_detail::printable(part) + "\n";
    if (instance > 0)
        result = "instance " + std::to_string(instance) + "\n" + result;
    add_line(result, "u", {u}, u_error);
    add_line(result, "v", {v}, v_error);
    add_line(result, "point", {point[0], point[1], point[2]}, point_error);
    add_line(result, "depth", {depth}, point_error);
    add_line(result, "normal", {normal[0], normal[1], normal[2]}, normal_error);
    add_line(result, "gaussian-curvature", {gaussian}, gaussian_error);
    add_line(result, "mean-curvature", {mean}, mean_error);
    result += is_proven ? "proven yes\n" : "proven no, an outline or a corner is too near\n";
    return result;
}

std::string l3d_pick::line() const {
    const std::string name = part.empty() ? "" : l3d_detail::printable(part) + ", ";
    return name + formatted("patch %zu (%.4f, %.4f) at %.4g, %.4g, %.4g +- %.1g", patch, u, v,
                            point[0], point[1], point[2], point_error);
}
