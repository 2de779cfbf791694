// SPDX-License-Identifier: MIT
// l3d_scene_culling: instances, then their patches, nearest first.
#include "pipeline/scene_culling.h"

#include "pipeline/scene_culling_p.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using l3d_detail::culled_boxes;

/// Patches of the first batch; each further one may be twice as large as the one before. What is
/// nearest hides most; a frame of 10^5 patches has 11 batches.
constexpr std::size_t first_batch = 64;

/// Of a box whose farthest w is more than so many times its nearest, no one asks whether it is
/// hidden: there the error of a walked w, up to 1e-5 of the farthest, could be over 2^-12 of the
/// nearest.
constexpr double most_depth_ratio = 16;

/// Whether a box (pixels from the picture's corner) holds no pixel centre k + 1/2, even when
/// snapping moves its points by half a sub-pixel.
bool holds_no_centre(const l3d_image_box& box) {
    constexpr double slack = 1.0 / l3d_subpixel_one;
    const auto none = [](double low, double high) {
        return std::floor(high + slack - 0.5) < std::ceil(low - slack - 0.5);
    };
    return none(box.left, box.right) || none(box.top, box.bottom);
}

l3d_image_box box_of(const culled_boxes& boxes, std::size_t i) {
    return {boxes.left[i], boxes.top[i], boxes.right[i], boxes.bottom[i]};
}

/// The count of those that are left out for the same reason as box i; null if it may be seen.
std::int64_t* reason_to_leave_out(const culled_boxes& boxes, std::size_t i,
                                  const l3d_dice_view& view, l3d_cull_counts& counts) {
    if (boxes.most[i] <= view.near)
        return &counts.behind;
    if (boxes.least[i] >= view.far)
        return &counts.beyond;
    if (boxes.inside[i] < 0)
        return &counts.offscreen;
    const l3d_image_box box = box_of(boxes, i), window = view.window();
    if (boxes.least[i] > view.near &&
        holds_no_centre({box.left - window.left, box.top - window.top, box.right - window.left,
                         box.bottom - window.top}))
        return &counts.subpixel;
    return nullptr;
}

/// A float not below 1 / distance of what is drawn at w >= `least`, if its w is off by `error`
/// and 2^-12 of itself at the most. The float's rounding is within the latter, too.
float inv_w_above(double least, double error, double depth_scale) {
    return static_cast<float>(depth_scale / ((least - error) * (1 - 0x1p-12)));
}

l3d_subpixel_box subpixels(const l3d_image_box& box, const l3d_dice_view& view) {
    const auto rounded = [](double pixels, std::int32_t centre) {
        return static_cast<std::int32_t>(std::floor(pixels * l3d_subpixel_one)) + centre;
    };
    return {rounded(box.left, view.centre_x()), rounded(box.top, view.centre_y()),
            rounded(box.right, view.centre_x()) + 1, rounded(box.bottom, view.centre_y()) + 1};
}

} // namespace

bool l3d_scene_culling::is_later(const ticket& a, const ticket& b) {
    return a.nearest_w != b.nearest_w ? a.nearest_w > b.nearest_w : a.at > b.at;
}

/// Calls add(box, extent) for each box that may be seen, else add.left_out(box, count).
template <class Add>
void l3d_scene_culling::look_at(const l3d_box_lanes& boxes, const l3d_matrix<double>& to_image,
                                Add add) {
    // What a walk adds to the error of w: 2^-19 is more than the 1.2e-6 of 32.32 numbers.
    const double error_w = view_.error_w + 0x1p-19;
    // A vertex is off by at most a quarter of the tolerance (or is evaluated), and by snapping.
    const l3d_image_box margin = view_.margin();
    const double vertex_error = view_.tolerance / 4 + 1.0 / l3d_subpixel_one;
    culled_boxes culled;
    for (std::size_t first = 0; first < boxes.count(); first += l3d_box_lanes::lanes) {
        l3d_detail::cull_boxes(boxes, first, to_image, view_, culled);
        const std::size_t here = std::min(l3d_box_lanes::lanes, boxes.count() - first);
        for (std::size_t i = 0; i < here; ++i) {
            std::int64_t* const reason =
                view_.keep_all ? nullptr : reason_to_leave_out(culled, i, view_, counts_);
            extent where{
                std::max(view_.near, culled.least[i]), std::numeric_limits<float>::infinity(), {}};
            if (reason == nullptr && !view_.keep_all &&
                culled.least[i] > view_.near + 2 * error_w &&
                culled.most[i] < most_depth_ratio * culled.least[i]) {
                where.inv_w = inv_w_above(culled.least[i], error_w, view_.depth_scale);
                where.box =
                    subpixels(box_of(culled, i).grown(vertex_error).intersected(margin), view_);
            }
            add(first + i, where, reason);
        }
    }
}

void l3d_scene_culling::begin(const l3d_patch_scene& scene, const l3d_matrix<double>& to_image,
                              const l3d_dice_view& view) {
    scene_ = &scene;
    to_image_ = to_image;
    view_ = view;
    counts_ = {};
    instances_.clear();
    instance_line_.clear();
    patches_.clear();
    patch_line_.clear();
    matrices_.clear();
    batch_size_ = 0;
    left_ = scene.patch_count();
    look_at(scene.boxes(), to_image, [&](std::size_t i, const extent& where, std::int64_t* reason) {
        if (reason != nullptr) {
            const auto patches =
                static_cast<std::int64_t>(scene.instances()[i].model().patches().size());
            *reason += patches;
            left_ -= patches;
            return;
        }
        instance_line_.push_back({where.nearest_w, static_cast<std::uint32_t>(instances_.size())});
        instances_.push_back({where, static_cast<std::uint32_t>(i)});
    });
    std::sort(instance_line_.begin(), instance_line_.end(), is_later);
}

/// Puts the patches of the nearest instance into the line, unless all are hidden.
void l3d_scene_culling::open_next_instance(hidden_call hidden, const void* context) {
    const seen_instance& next = instances_[instance_line_.back().at];
    instance_line_.pop_back();
    const l3d_patch_instance& instance = scene_->instances()[next.index];
    if (hidden != nullptr && std::isfinite(next.where.inv_w) &&
        hidden(context, next.where.box, next.where.inv_w)) {
        const auto patches = static_cast<std::int64_t>(instance.model().patches().size());
        counts_.hidden += patches;
        left_ -= patches;
        return;
    }
    const auto matrix = static_cast<std::uint32_t>(matrices_.size());
    matrices_.push_back(to_image_ * instance.placement());
    look_at(
        instance.model().boxes(), matrices_.back(),
        [&](std::size_t i, extent where, std::int64_t* reason) {
            if (reason != nullptr) {
                ++*reason;
                --left_;
                return;
            }
            // By rounding a patch may seem nearer than its instance; then order would suffer.
            where.nearest_w = std::max(where.nearest_w, next.where.nearest_w);
            patch_line_.push_back({where.nearest_w, static_cast<std::uint32_t>(patches_.size())});
            std::push_heap(patch_line_.begin(), patch_line_.end(), is_later);
            patches_.push_back({where, next.index, static_cast<std::uint32_t>(i), matrix});
        });
}

std::span<const l3d_placed_patch> l3d_scene_culling::next_batch(hidden_call hidden,
                                                                const void* context) {
    if (batch_size_ == 0)
        hidden = nullptr; // Nothing has been drawn.
    batch_size_ = batch_size_ == 0 ? first_batch : 2 * batch_size_;
    // A rest that is not larger than this batch goes with it.
    const bool all = left_ <= static_cast<std::int64_t>(2 * batch_size_);
    batch_.clear();
    while (all || batch_.size() < batch_size_) {
        if (!instance_line_.empty() && (patch_line_.empty() || instance_line_.back().nearest_w <=
                                                                   patch_line_.front().nearest_w)) {
            open_next_instance(hidden, context);
            continue;
        }
        if (patch_line_.empty())
            break;
        const seen_patch& p = patches_[patch_line_.front().at];
        std::pop_heap(patch_line_.begin(), patch_line_.end(), is_later);
        patch_line_.pop_back();
        --left_;
        if (hidden != nullptr && std::isfinite(p.where.inv_w) &&
            hidden(context, p.where.box, p.where.inv_w))
            ++counts_.hidden;
        else
            batch_.push_back({p.instance, p.patch, p.matrix, p.where.nearest_w});
    }
    return batch_;
}
