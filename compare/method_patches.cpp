// SPDX-License-Identifier: MIT
// l3d_method_patches: culls patches, and clips for methods that do not clip.
#include "compare/method_patches.h"

#include "dice/error_color.h"
#include "scene/placed_net.h"
#include "scene/culling/visibility.h"

bool l3d_needs_no_clipping(const l3d_image_patch& net, const l3d_dice_view& view) {
    const l3d_depth_range depth = l3d_depth_range_of(net.points);
    return depth.least > view.near && depth.most < view.far &&
           l3d_image_box_of(net.points).reach() < l3d_guard_band;
}

std::span<const l3d_surface_part* const>
l3d_method_patches::dice_each(const l3d_method_frame& frame, const dice_call& dice) {
    for (worker_space& space : each_worker_)
        space.counts = {};
    const auto nothing_is_hidden = [](const l3d_subpixel_box&, float) { return false; };
    culling_.begin(frame.scene, frame.to_image, frame.view);
    parts_.clear();
    std::size_t used = 0; // slots, over all batches
    for (auto batch = culling_.next(nothing_is_hidden); !batch.empty();
         batch = culling_.next(nothing_is_hidden)) {
        if (slots_.size() < used + batch.size())
            slots_.resize(used + batch.size());
        workers_.for_each(static_cast<int>(batch.size()), [&](int item, int worker) {
            const auto i = static_cast<std::size_t>(item);
            slots_[used + i].clear();
            dice_one(frame, batch[i], dice, worker, slots_[used + i]);
        });
        used += batch.size();
    }
    for (const l3d_piece_pool& slot : std::span(slots_).first(used))
        for (const l3d_diced_piece& piece : slot.used())
            parts_.push_back(&piece.part);
    counts_ = culling_.counts();
    for (const worker_space& space : each_worker_)
        counts_.add(space.counts);
    return parts_;
}

void l3d_method_patches::dice_one(const l3d_method_frame& frame, const l3d_placed_patch& placed,
                                  const dice_call& dice, int worker, l3d_piece_pool& out) {
    worker_space& space = each_worker_[static_cast<std::size_t>(worker)];
    const l3d_patch_instance& instance = frame.scene.instances()[placed.instance];
    const l3d_patch_model& model = instance.model();
    const std::uint32_t material = frame.scene.material_of(placed.instance, placed.patch);
    const l3d_method_patch patch{
        l3d_placed_net(culling_.matrix(placed), model.patches()[placed.patch]),
        instance.turns_normals()
            ? l3d_placed_normals(instance.normal_matrix(), model.normals(placed.patch))
            : model.normals(placed.patch),
        frame.materials.empty() ? l3d_material().color : frame.materials[material].color,
        material,
        placed,
        &model.patches()[placed.patch],
        &culling_.matrix(placed)};
    if (l3d_left_out(patch.net, frame.view, space.counts))
        return;
    if (l3d_needs_no_clipping(patch.net, frame.view)) {
        ++space.counts.drawn;
        dice(patch, frame.view, worker, out, space.counts);
    } else {
        space.edges.build(patch.net, frame.view);
        space.clipping.dice(patch.net, patch.normals, frame.view, space.edges, out, space.counts);
    }
    for (l3d_diced_piece& piece : out.used()) {
        piece.part.error_color = l3d_error_color(piece.bound, frame.view.tolerance);
        piece.part.material = material;
    }
}

void l3d_fill_parts(l3d_surface_rasterizer& surface, const l3d_method_frame& frame,
                    std::span<const l3d_surface_part* const> parts, l3d_stage_times& times) {
    const l3d_detail::stopwatch filling;
    if (frame.wants_depth)
        frame.depth.resize(frame.view.size);
    surface.count_pixels(frame.counts_pixels);
    surface.use_materials(frame.materials);
    surface.begin(frame.target, frame.wants_depth ? &frame.depth : nullptr, frame.shading,
                  frame.untouched);
    surface.draw(parts);
    surface.finish();
    times.raster += filling.milliseconds();
}
