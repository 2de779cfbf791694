// SPDX-License-Identifier: MIT
// l3d_scene_culling: finds the patches of a scene that have to be drawn, nearest first.
#ifndef L3D_SCENE_SCENE_CULLING_H
#define L3D_SCENE_SCENE_CULLING_H

#include "geom/matrix.h"
#include "scene/counts.h"
#include "scene/dice_view.h"
#include "scene/patch_scene.h"
#include "raster/surface_rasterizer.h"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace l3d_detail {
struct culled_boxes;
struct placing_terms;
} // namespace l3d_detail

/// A patch of an instance that may be seen.
struct l3d_placed_patch {
    std::uint32_t instance = 0; ///< the instance's index in the scene
    std::uint32_t patch = 0;    ///< the patch's index in the instance's model
    std::uint32_t matrix = 0;   ///< index of the instance's matrix in l3d_scene_culling
    /// The least w of the patch's box, or the near plane's w if that is larger, in the view's
    /// units. In a parallel projection, w is counted from a value below which nothing lies.
    float nearest_w = 0;
    std::int32_t middle = 0; ///< picture row of the middle of the patch's box; 0 if unknown
};

/// Hands out the visible patches of a scene in batches, nearest first.
///
/// Whole instances are looked at first, by their boxes. So the patches of an instance that is not
/// seen cost nothing. Instances that may be seen are opened in turn, nearest first: then the boxes
/// of their patches are looked at. A box proves less than a control net. So some patches are handed
/// out although their nets would prove that they are unseen.
/// Lives: kept from frame to frame for its memory; borrows the scene for a frame.
/// Cost:  measured by tests/bench/scaling_bench.cpp; no allocation once the largest frame has been
///        seen.
class l3d_scene_culling {
public:
    /// Starts a frame.
    ///
    /// Shape:   to_image takes the world to (x, y, -, w) in the view's units.
    /// Expects: the scene is not changed during the frame.
    void begin(const l3d_patch_scene& scene, const l3d_matrix<double>& to_image,
               const l3d_dice_view& view) {
        begin(scene, to_image, view, l3d_whole(view.size));
    }

    /// Starts a frame of which only a part of the picture is wanted. Patches that touch no pixel of
    /// the part are left out.
    void begin(const l3d_patch_scene& scene, const l3d_matrix<double>& to_image,
               const l3d_dice_view& view, const l3d_pixel_box& part);

    /// Hands out the next batch of patches, the batch's nearest patch first. The result is empty if
    /// no patches are left.
    ///
    /// A batch takes the nearest patches of the open instances. So a patch may be farther than some
    /// patches of the next batch, by the depth of its instance at most. Batches grow, since the
    /// nearest patches hide most and each batch has a fixed cost.
    ///
    /// `hidden(box, inv_w)` tells whether a thing in a box and no nearer than inv_w (1 / distance
    /// along the view axis) would change no pixel. `hidden` is called from the second batch on, so
    /// the caller draws each batch before the next.
    /// Lives: until the next call.
    template <std::predicate<const l3d_subpixel_box&, float> Hidden>
    std::span<const l3d_placed_patch> next(const Hidden& hidden) {
        return next_batch(
            [](const void* context, const l3d_subpixel_box& box, float inv_w) -> bool {
                return (*static_cast<const Hidden*>(context))(box, inv_w);
            },
            std::addressof(hidden));
    }

    /// Whether next() has nothing more to hand out.
    bool is_done() const { return left_ == 0; }

    /// The matrix from the model of a patch to the picture: to_image times the instance's
    /// placement.
    const l3d_matrix<double>& matrix(const l3d_placed_patch& p) const {
        return matrices_[p.matrix];
    }

    /// The counts of patches left out in this frame until now.
    const l3d_dice_counts& counts() const { return counts_; }

private:
    using hidden_call = bool (*)(const void*, const l3d_subpixel_box&, float);

    /// The place of a thing in the picture.
    struct extent {
        float nearest_w;
        float inv_w; ///< the argument of `hidden`; infinite where `hidden` is not to be asked
        l3d_subpixel_box box;
    };
    struct seen_instance {
        extent where;
        std::uint32_t index;
    };
    struct seen_patch {
        extent where;
        std::uint32_t instance, patch, matrix;
    };
    /// An entry of a queue, which an integer sort puts in order. The upper bits are those of
    /// nearest_w, since floats from 0 up are in the order of their bits. The lower bits are an
    /// index in instances_ or patches_.
    using ticket = std::uint64_t;

    static ticket ticket_of(const extent& where, std::size_t at);
    extent extent_of(const l3d_detail::culled_boxes& boxes, std::size_t i) const;
    template <class Followed, class See, class LeaveOut>
    void look_at(const l3d_box_lanes& boxes, const l3d_matrix<double>& to_image,
                 const l3d_detail::placing_terms& terms, Followed followed, See see,
                 LeaveOut leave_out);
    void leave_out(const l3d_patch_instance& instance, std::int64_t& count);
    void open_next_instance(hidden_call hidden, const void* context);
    void sort_nearest(std::size_t count);
    void take_from_line(std::size_t count, hidden_call hidden, const void* context);
    std::span<const l3d_placed_patch> next_batch(hidden_call hidden, const void* context);

    const l3d_patch_scene* scene_ = nullptr;
    l3d_matrix<double> to_image_;
    l3d_dice_view view_;
    l3d_image_box margin_; ///< l3d_dice_view::margin of the wanted part of the picture
    bool is_part_ = false;
    l3d_dice_counts counts_;

    std::vector<seen_instance> instances_;
    std::vector<ticket> instance_line_; ///< tickets of unopened instances, the farthest first
    std::vector<seen_patch> patches_;   ///< patches of the instances that were opened
    std::vector<ticket> patch_line_;
    /// The number of tickets at the end of patch_line_ that are sorted, the nearest last.
    std::size_t sorted_ = 0;
    std::vector<l3d_matrix<double>> matrices_;
    std::vector<l3d_placed_patch> batch_;
    std::int64_t left_ = 0; ///< the number of patches not yet handed out or left out
    std::size_t batch_size_ = 0;
};

#endif
