// SPDX-License-Identifier: MIT
// A scene that the dicer and the exact reference both see, and dicing it in any number type.
#ifndef L3D_TESTS_PIPELINE_SCENE_H
#define L3D_TESTS_PIPELINE_SCENE_H

#include "pipeline/image_transform.h"
#include "pipeline/patch_dicer.h"
#include "pipeline/visibility.h"
#include "reference/views.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pipeline_tests {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

using fixed = l3d_fixed<std::int64_t, 32>;
using number_types = ::testing::Types<float, double, fixed>;

template <class T> constexpr const char* name_of() {
    return std::is_same_v<T, float> ? "float" : std::is_same_v<T, double> ? "double" : "fixed";
}

/// Patches, a camera and a picture size, for the library and for the reference.
struct scene {
    scene(std::vector<reference::patch> surfaces, const reference::camera& view, l3d_size of);

    std::vector<reference::patch> patches;
    reference::camera eye;
    l3d_size size;
    l3d_patch_model model;
    l3d_camera camera;

    reference::picture_size picture() const { return {size.width, size.height}; }
};

/// The teapot as one of the project's views shows it.
scene teapot(const reference::view& view, l3d_size size);

/// A dicer and what it keeps from patch to patch.
template <class T> class scene_dicer {
public:
    /// Dices a whole scene; calls sink(i, pieces, frame_bound) with the pieces of patch i. The
    /// bound is that of the frame so far.
    template <class Sink>
    l3d_dice_counts dice(const scene& s, double tolerance, Sink sink, bool keep_all = false) {
        const l3d_image_transform to_image(s.camera, s.size, s.model);
        l3d_dice_view view = to_image.view(tolerance);
        view.keep_all = keep_all;
        l3d_dice_counts counts;
        for (std::size_t i = 0; i < s.patches.size(); ++i) {
            const l3d_image_patch net = to_image(s.model.patches()[i]);
            pieces_.clear();
            if (keep_all || !l3d_left_out(net, view, counts)) {
                edges_.build(net, view);
                dicer_.dice(net, s.model.normals(i), view, edges_, pieces_, counts);
            }
            sink(i, pieces_.used(), counts.bound_px);
        }
        return counts;
    }

private:
    l3d_patch_dicer<T> dicer_;
    l3d_edge_polylines edges_;
    l3d_diced_pieces pieces_ = l3d_diced_pieces::with_parameters();
};

using diced = std::span<const l3d_diced_piece>;

/// Hands every patch's pieces to sink.draw(pieces, frame_bound).
template <class T, class Sink>
l3d_dice_counts dice(const scene& s, double tolerance, Sink& sink, bool keep_all = false) {
    return scene_dicer<T>().dice(
        s, tolerance, [&](std::size_t, diced pieces, double bound) { sink.draw(pieces, bound); },
        keep_all);
}

} // namespace pipeline_tests

#endif
