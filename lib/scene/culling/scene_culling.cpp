// SPDX-License-Identifier: MIT
// l3d_scene_culling: takes instances, then their patches, nearest first.
#include "scene/culling/scene_culling.h"

#include "scene/culling/scene_culling_p.h"
#include "scene/sides/shared_edges.h"
#include "scene/culling/visibility.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

namespace {

using l3d_detail::culled_boxes;

/// The numbers of patches in the first batch, and in the largest batches. Batches double in size
/// until they have largest_batch patches. The nearest patches hide most, so the first batches are
/// small. Each batch costs some 0.1 ms by itself. This is little beside 1024 patches, which take at
/// least 1 ms to dice.
constexpr std::size_t first_batch = 64, largest_batch = 1024;

/// Largest ratio of the farthest to the nearest w of a box that is tested for being hidden. Above
/// this ratio, the error of a walked w, up to 1e-5 of the farthest w, could be over 2^-12 of the
/// nearest w.
constexpr double most_depth_ratio = 16;

l3d_image_box box_of(const culled_boxes& boxes, std::size_t i) {
    return {boxes.left[i], boxes.top[i], boxes.right[i], boxes.bottom[i]};
}

/// Finds the reason why box i is left out. Returns the counter for this reason; null if the box may
/// be seen.
std::int64_t* reason_to_leave_out(const culled_boxes& boxes, std::size_t i,
                                  const l3d_dice_view& view, l3d_dice_counts& counts) {
    return l3d_reason_to_leave_out(
        {boxes.least[i], boxes.most[i]}, view, [&] { return boxes.inside[i] < 0; },
        [&] {
            return boxes.least[i] > boxes.near[i] && l3d_holds_no_centre(box_of(boxes, i), view);
        },
        counts);
}

bool is_hidden(const auto& where, bool (*hidden)(const void*, const l3d_subpixel_box&, float),
               const void* context) {
    return hidden != nullptr && std::isfinite(where.inv_w) &&
           hidden(context, where.box, where.inv_w);
}

/// Bound of the error of a balanced vertex's w, for a net with w from `least` to `most`.
///
/// The vertex errs by l3d_balance h^2 f''. h <= 1/8, as a strip is a quarter of the net and has two
/// steps or more. f'' <= 6 * 2 (most - least). Errors along u and along v add up to 0.0322 (most -
/// least). Their common effect is below 0.001 (most - least).
double balance_of_w(double least, double most) {
    return (most - least) / 30;
}

/// Upper bound of the depth at w >= `least`, rounding included. w may be too large by `error`, and
/// by another 2^-12 of w.
float inv_w_above(double least, double error, const l3d_dice_view& view) {
    if (view.is_parallel())
        return view.depth_at(least - error) * (1 + 0x1p-12F);
    return static_cast<float>(view.depth_scale / ((least - error) * (1 - 0x1p-12)));
}

/// A box of the picture in sub-pixels, rounded outwards. Expects: the box lies within the margin.
l3d_subpixel_box subpixels(const l3d_image_box& box, const l3d_dice_view& view) {
    // A cast rounds down, except left of or above the window, where there is no pixel to miss.
    const l3d_image_box window = view.window();
    const auto place = [](double pixels, double from) {
        return static_cast<std::int32_t>((pixels - from) * l3d_subpixel_one);
    };
    return {place(box.left, window.left), place(box.top, window.top),
            place(box.right, window.left) + 1, place(box.bottom, window.top) + 1};
}

std::size_t place_of(std::uint64_t ticket) {
    return ticket & 0xffffffff;
}

} // namespace

l3d_image_box l3d_detail::drawn_box_of(const culled_boxes& boxes, std::size_t i,
                                       const l3d_dice_view& view) {
    const l3d_image_box exact = box_of(boxes, i);
    const double transformed =
        l3d_vertex_error(view.error_xy * boxes.share[i], view.error_w * boxes.share[i],
                         exact.reach(), boxes.least[i]);
    const double vertex_error = transformed + view.walk_allowance() + 1.0 / l3d_subpixel_one;
    return view.drawn_box(exact).grown(vertex_error);
}

l3d_scene_culling::ticket l3d_scene_culling::ticket_of(const extent& where, std::size_t at) {
    return ticket{std::bit_cast<std::uint32_t>(where.nearest_w)} << 32 | at;
}

/// Finds the place of box i: the w by which it is sorted, and the box in the picture and the depth
/// that `hidden` needs.
l3d_scene_culling::extent l3d_scene_culling::extent_of(const culled_boxes& boxes,
                                                       std::size_t i) const {
    // In a parallel projection all w are nearly alike, so a float holds the difference from a base.
    const double from = view_.is_parallel() ? view_.w_middle * (1 - 2 * l3d_parallel_part) : 0.0;
    extent where{static_cast<float>(std::max(view_.near, boxes.least[i]) - from),
                 std::numeric_limits<float>::infinity(),
                 {}};
    const double error_w = view_.error_w * boxes.share[i];
    if (boxes.least[i] <= boxes.near[i] + 2 * error_w ||
        boxes.most[i] > most_depth_ratio * boxes.least[i] || view_.keep.hidden)
        return where;
    const double balance =
        l3d_is_small(box_of(boxes, i)) ? 0 : balance_of_w(boxes.least[i], boxes.most[i]);
    const l3d_image_box seen = drawn_box_of(boxes, i, view_).intersected(view_.margin());
    if (seen.empty()) // then it is never hidden
        return where;
    where.inv_w = inv_w_above(boxes.least[i], error_w + balance, view_);
    where.box = subpixels(seen, view_);
    return where;
}

/// Calls see(box, extent) for each box that may be seen, and leave_out(box, count of the reason)
/// for the other boxes. If only a part of the picture is drawn, all boxes that are left out count
/// as unchanged.
///
/// A `followed` box has patches whose trims follow edges. The strips along these edges reach beyond
/// the patches, into places beside neighbours. So the box' place in the picture is the only reason
/// to leave the box out.
template <class Followed, class See, class LeaveOut>
void l3d_scene_culling::look_at(const l3d_box_lanes& boxes, const l3d_matrix<double>& to_image,
                                const l3d_detail::placing_terms& terms, Followed followed, See see,
                                LeaveOut leave_out) {
    culled_boxes culled;
    l3d_dice_view with_all = view_;
    with_all.keep.centreless = true;
    for (std::size_t first = 0; first < boxes.count(); first += l3d_box_lanes::lanes) {
        l3d_detail::cull_boxes(boxes, first, {to_image, terms, view_, margin_}, culled);
        const std::size_t here = std::min(l3d_box_lanes::lanes, boxes.count() - first);
        for (std::size_t i = 0; i < here; ++i) {
            const bool is_followed = followed(first + i);
            std::int64_t* const reason =
                reason_to_leave_out(culled, i, is_followed ? with_all : view_, counts_);
            if (reason == nullptr) {
                extent where = extent_of(culled, i);
                if (is_followed)
                    where.inv_w = std::numeric_limits<float>::infinity();
                see(first + i, where);
            } else
                leave_out(first + i, is_part_ ? counts_.unchanged : *reason);
        }
    }
}

void l3d_scene_culling::begin(const l3d_patch_scene& scene, const l3d_matrix<double>& to_image,
                              const l3d_dice_view& view, const l3d_pixel_box& part) {
    scene_ = &scene;
    to_image_ = to_image;
    view_ = view.unlifted();
    margin_ = view.margin(view.window(part));
    if (std::ranges::any_of(scene.instances(),
                            [](const l3d_patch_instance& i) { return !i.model().edges().empty(); }))
        margin_ = margin_.grown(l3d_longest_shared_chord);
    is_part_ = part != l3d_whole(view.size);
    counts_ = {};
    instances_.clear();
    instance_line_.clear();
    patches_.clear();
    patch_line_.clear();
    matrices_.clear();
    batch_size_ = 0;
    left_ = scene.patch_count();
    look_at(
        scene.boxes(), to_image, {}, [](std::size_t) { return false; },
        [&](std::size_t i, const extent& where) {
            instance_line_.push_back(ticket_of(where, instances_.size()));
            instances_.push_back({where, static_cast<std::uint32_t>(i)});
        },
        [&](std::size_t i, std::int64_t& count) { leave_out(scene.instances()[i], count); });
    std::sort(instance_line_.begin(), instance_line_.end(), std::greater{});
}

void l3d_scene_culling::leave_out(const l3d_patch_instance& instance, std::int64_t& count) {
    const auto patches = static_cast<std::int64_t>(instance.model().patches().size());
    count += patches;
    left_ -= patches;
}

/// Puts the patches of the nearest instance into the waiting line, unless the instance is hidden.
void l3d_scene_culling::open_next_instance(hidden_call hidden, const void* context) {
    const seen_instance& next = instances_[place_of(instance_line_.back())];
    instance_line_.pop_back();
    const l3d_patch_instance& instance = scene_->instances()[next.index];
    if (is_hidden(next.where, hidden, context))
        return leave_out(instance, counts_.hidden);
    const auto matrix = static_cast<std::uint32_t>(matrices_.size());
    matrices_.push_back(to_image_ * instance.placement());
    sorted_ = 0;
    look_at(
        instance.model().boxes(), matrices_.back(), {instance.terms(), instance.shift()},
        [&](std::size_t i) { return instance.model().follows_edges(i); },
        [&](std::size_t i, const extent& where) {
            patch_line_.push_back(ticket_of(where, patches_.size()));
            patches_.push_back({where, next.index, static_cast<std::uint32_t>(i), matrix});
        },
        [&](std::size_t, std::int64_t& count) {
            ++count;
            --left_;
        });
}

/// Sorts the nearest patches of the waiting line to its end, the nearest last. A long line is
/// sorted an eighth at a time. So each patch is looked at up to eight times, and sorted once.
void l3d_scene_culling::sort_nearest(std::size_t count) {
    if (sorted_ >= count)
        return;
    sorted_ = std::min(std::max(count, patch_line_.size() / 8), patch_line_.size());
    const auto nearest = patch_line_.end() - static_cast<std::ptrdiff_t>(sorted_);
    if (nearest != patch_line_.begin())
        std::nth_element(patch_line_.begin(), nearest, patch_line_.end(), std::greater{});
    std::sort(nearest, patch_line_.end(), std::greater{});
}

/// Moves the `count` nearest patches from the waiting line to the batch, except for hidden patches.
/// Expects: the line has at least `count` patches.
void l3d_scene_culling::take_from_line(std::size_t count, hidden_call hidden, const void* context) {
    sort_nearest(count);
    for (std::size_t i = 0; i < count; ++i) {
        const seen_patch& p = patches_[place_of(patch_line_.back())];
        patch_line_.pop_back();
        if (is_hidden(p.where, hidden, context))
            ++counts_.hidden;
        else
            batch_.push_back({p.instance, p.patch, p.matrix, p.where.nearest_w,
                              (p.where.box.top + p.where.box.bottom) / 2 / l3d_subpixel_one});
    }
    sorted_ -= count;
    left_ -= static_cast<std::int64_t>(count);
}

std::span<const l3d_placed_patch> l3d_scene_culling::next_batch(hidden_call hidden,
                                                                const void* context) {
    if (batch_size_ == 0)
        hidden = nullptr; // nothing drawn yet hides them
    batch_size_ = std::clamp(2 * batch_size_, first_batch, largest_batch);
    batch_.clear();
    while (left_ > 0 && batch_.size() < batch_size_) {
        // If at most two batches of this size are left, this batch takes all.
        const std::size_t wanted = left_ <= static_cast<std::int64_t>(2 * batch_size_)
                                       ? 2 * batch_size_
                                       : batch_size_ - batch_.size();
        while (!instance_line_.empty() && patch_line_.size() < wanted)
            open_next_instance(hidden, context);
        take_from_line(std::min(wanted, patch_line_.size()), hidden, context);
    }
    return batch_;
}
