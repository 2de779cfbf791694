// SPDX-License-Identifier: MIT
// l3d_method_tessellation: makes the polygon model, draws its frame, and bounds the error.
#include "compare/method_tessellation.h"

#include "dice/drawn_error.h"
#include "dice/error_color.h"
#include "scene/placed_net.h"
#include "scene/culling/visibility.h"
#include "compare/method_patches.h"
#include "pipeline/polygons/polygon_model.h"
#include "pipeline/stopwatch_p.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace {

using l3d_detail::stopwatch;
using vector = l3d_polygon_mesh::vector;

/// Moves a point (w = 1) or a direction (w = 0) by an affine matrix.
vector moved(const l3d_matrix<double>& by, const vector& v, double w) {
    const l3d_vector<double, 4> h = by * l3d_vector<double, 4>(v[0], v[1], v[2], w);
    return {h[0], h[1], h[2]};
}

l3d_patch_mesh mesh_of(const l3d_patch_scene& scene, int n) {
    l3d_patch_mesh all;
    for (const l3d_patch_instance& instance : scene.instances()) {
        const l3d_patch_model& model = instance.model();
        l3d_patch_mesh one =
            l3d_tessellated(instance.material() ? model.painted(*instance.material()) : model, n);
        for (vector& v : one.mesh.vertices)
            v = moved(instance.placement(), v, 1);
        for (vector& normal : one.mesh.vertex_normals)
            normal = moved(instance.normal_matrix(), normal, 0);
        for (const std::size_t end : one.face_ends)
            all.face_ends.push_back(all.mesh.faces() + end);
        all.mesh.append(one.mesh);
    }
    return all;
}

/// The number of each instance's first patch among all patches of the scene.
std::vector<std::size_t> first_patches_of(const l3d_patch_scene& scene) {
    std::vector<std::size_t> firsts;
    std::size_t first = 0;
    for (const l3d_patch_instance& instance : scene.instances()) {
        firsts.push_back(first);
        first += instance.model().patches().size();
    }
    return firsts;
}

/// The camera with the planes that the frame has, in its own units.
l3d_camera camera_of(const l3d_method_frame& frame) {
    l3d_camera camera = frame.camera;
    camera.near_z = frame.view.near / frame.view.depth_scale;
    camera.far_z = frame.view.far / frame.view.depth_scale;
    return camera;
}

} // namespace

double l3d_tessellation_bound(const l3d_image_patch& net, const l3d_dice_view& view, int n) {
    const l3d_depth_range depth = l3d_depth_range_of(net.points);
    const double depth_error = l3d_depth_bounds_of(net).triangle_error(n, n);
    l3d_vertex_accuracy accuracy;
    accuracy.w_low = std::max(depth.least, view.near - depth_error);
    if (!(accuracy.w_low > 0))
        return std::numeric_limits<double>::infinity();
    l3d_image_box seen = view.margin();
    accuracy.reach = l3d_guard_band;
    if (depth.least > view.near) {
        const l3d_image_box hull = l3d_image_box_of(net.points);
        seen = hull.intersected(seen);
        accuracy.reach = std::min(hull.reach(), l3d_guard_band);
    }
    if (seen.empty())
        return 0;
    // Points of patches are evaluated in fewer operations than the view's errors allow for cuts.
    accuracy.error_xy = view.error_xy;
    accuracy.error_w = view.error_w;
    accuracy.seen_reach = seen.reach();
    accuracy.snap_error = l3d_snap_error<double>(accuracy.reach);
    return l3d_second_bounds_of(net, seen, accuracy.w_low).triangle_error(n, n) +
           accuracy.drawn_error(l3d_vertex_accuracy::in_front + depth_error / accuracy.w_low);
}

/// Counts patches by the same proofs and the same bound as all methods do. A patch that is left out
/// here still has its polygons, each of which is left out by itself. In mode `error` each patch is
/// a part in its bound's colour.
void l3d_method_tessellation::count_patches(const l3d_method_frame& frame) {
    const auto nothing_is_hidden = [](const l3d_subpixel_box&, float) { return false; };
    counts_ = {};
    culling_.begin(frame.scene, frame.to_image, frame.view);
    for (auto batch = culling_.next(nothing_is_hidden); !batch.empty();
         batch = culling_.next(nothing_is_hidden))
        for (const l3d_placed_patch& placed : batch) {
            const l3d_patch_model& model = frame.scene.instances()[placed.instance].model();
            const l3d_image_patch net =
                l3d_placed_net(culling_.matrix(placed), model.patches()[placed.patch]);
            if (l3d_left_out(net, frame.view, counts_))
                continue;
            ++counts_.drawn;
            ++counts_.pieces;
            counts_.clipped += !l3d_needs_no_clipping(net, frame.view);
            const double bound = l3d_tessellation_bound(net, frame.view, n_);
            counts_.bound_px = std::max(counts_.bound_px, bound);
            if (frame.shading.mode == l3d_shade::error)
                polygons_.set_error_color(first_patches_[placed.instance] + placed.patch,
                                          l3d_error_color(bound, frame.view.tolerance));
        }
    counts_.add(culling_.counts());
    counts_.samples = static_cast<std::int64_t>(model_.mesh().vertices.size());
}

void l3d_method_tessellation::do_draw(const l3d_method_frame& frame, l3d_stage_times& times) {
    const stopwatch placing;
    if (!made_of_.holds(frame.scene)) {
        l3d_patch_mesh made = mesh_of(frame.scene, n_);
        model_ = l3d_polygon_model(std::move(made.mesh));
        face_ends_ = std::move(made.face_ends);
        first_patches_ = first_patches_of(frame.scene);
        made_of_.remember(frame.scene);
    }
    const l3d_polygon_view view(camera_of(frame), frame.view.size, l3d_identity<double>());
    constexpr bool cull = false; // surfaces are two-sided
    const auto ends = frame.shading.mode == l3d_shade::error ? std::span(face_ends_)
                                                             : std::span<const std::size_t>();
    polygons_.make(model_, view,
                   {.cull = cull,
                    .smooth = frame.shading.mode != l3d_shade::flat,
                    .antialias = frame.shading.antialias},
                   workers_, ends);
    count_patches(frame);
    times.dice += placing.milliseconds();

    const stopwatch filling;
    if (frame.wants_depth)
        frame.depth.resize(frame.view.size);
    surface_->count_pixels(frame.counts_pixels);
    surface_->use_materials(model_.materials());
    surface_->begin(frame.target, frame.wants_depth ? &frame.depth : nullptr, frame.shading,
                    frame.untouched);
    surface_->draw(polygons_.parts());
    surface_->finish();
    times.raster += filling.milliseconds();
}
