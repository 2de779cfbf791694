// SPDX-License-Identifier: MIT
// A scene that the dicer and the exact reference both see, and dicing it in any number type.
#ifndef L3D_TESTS_PIPELINE_SCENE_H
#define L3D_TESTS_PIPELINE_SCENE_H

#include "pipeline/image_transform.h"
#include "pipeline/patch_dicer.h"
#include "reference/views.h"

#include <gtest/gtest.h>

#include <cstdint>
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

/// Dices a whole scene; calls before(i) ahead of patch i.
template <class T, class Before>
void dice(l3d_patch_dicer<T>& dicer, const scene& s, double tolerance, l3d_dice_sink& sink,
          Before before, bool keep_all = false) {
    const l3d_image_transform<typename l3d_patch_dicer<T>::wide> to_image(s.camera, s.size,
                                                                          s.model);
    l3d_dice_view view = to_image.view(tolerance);
    view.keep_all = keep_all;
    dicer.begin(view);
    for (std::size_t i = 0; i < s.patches.size(); ++i) {
        before(i);
        dicer.dice(to_image(s.model.patches()[i]), s.model.normals(i), sink);
    }
}

template <class T>
l3d_dice_counts dice(const scene& s, double tolerance, l3d_dice_sink& sink, bool keep_all = false) {
    l3d_patch_dicer<T> dicer;
    dice(
        dicer, s, tolerance, sink, [](std::size_t) {}, keep_all);
    return dicer.counts();
}

} // namespace pipeline_tests

#endif
