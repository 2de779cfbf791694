// SPDX-License-Identifier: MIT
// A scene that the dicer and the exact reference both see, and dicing it in any number type.
#ifndef L3D_TESTS_DICE_SCENE_H
#define L3D_TESTS_DICE_SCENE_H

#include "scene/camera_shading.h"
#include "dice/frame_dicer.h"
#include "scene/image_transform.h"
#include "scene/placed_net.h"
#include "reference/views.h"
#include "effort.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace dice_tests {

using fixed = l3d_fixed<std::int64_t, 32>;

/// The slow twin in number type T; T itself stands for the product.
template <class T> struct slow {};

/// The product's number types, and these with the slow twins, as they are tested in this build:
/// float has fixed beside it, and the builds of double and fixed have the twins. `make matrix`
/// makes all three builds.
#if defined(L3D_REAL_FLOAT)
using product_types = ::testing::Types<float, fixed>;
using number_types = product_types;
#elif defined(L3D_REAL_DOUBLE)
using product_types = ::testing::Types<double>;
using number_types = ::testing::Types<double, slow<float>>;
#else
using product_types = ::testing::Types<fixed>;
using number_types = ::testing::Types<fixed, slow<fixed>>;
#endif

template <class T> struct way_of {
    using real = T;
    static constexpr l3d_dice_way way = l3d_dice_way::lanes;
};
template <class T> struct way_of<slow<T>> {
    using real = T;
    static constexpr l3d_dice_way way = l3d_dice_way::general;
};

template <class T> constexpr const char* name_of() {
    using real = typename way_of<T>::real;
    if (way_of<T>::way == l3d_dice_way::general)
        return std::is_same_v<real, float> ? "slow_float" : "slow_fixed";
    return std::is_same_v<T, float> ? "float" : std::is_same_v<T, double> ? "double" : "fixed";
}

struct type_names {
    template <class T> static std::string GetName(int) { return name_of<T>(); }
};

/// A slanting view, and the size of a picture that no block or tile divides.
inline constexpr reference::camera oblique{
    {2.5, 3.1, 6.3}, {0.4, 0.2, -0.3}, {0.1, 1, 0.05}, 41, 0.2};
inline constexpr l3d_size odd{317, 241};

/// Patches, a camera and a picture size, for the library and for the reference.
struct scene {
    scene(std::vector<reference::patch> surfaces, const reference::camera& view, l3d_size of);

    /// The same picture of a model that is placed there.
    scene(const std::vector<reference::patch>& of_model, const l3d_matrix<double>& placement,
          const reference::camera& view, l3d_size of);

    std::vector<reference::patch> patches;
    reference::camera eye;
    l3d_size size;
    l3d_patch_model model;
    l3d_matrix<double> placement = l3d_identity<double>(); ///< of the model
    l3d_camera camera;
    std::int64_t most_samples = std::int64_t{1} << 40; ///< as if there were no budget
    double shade_tolerance = 0; ///< 0: not lit while diced, else with levels by project_light

    reference::picture_size picture() const { return {size.width, size.height}; }
};

/// The teapot as one of the project's views shows it.
scene teapot(const reference::view& view, l3d_size size);

/// A dicer and what it keeps from frame to frame.
template <class T> class scene_dicer {
public:
    /// Dices a whole scene, nearest patches first; calls sink(i, pieces, frame_bound) with the
    /// pieces of patch i.
    template <class Sink>
    l3d_dice_counts dice(const scene& s, double tolerance, Sink sink,
                         l3d_culling_switches keep = {}, bool one_sided = false) {
        world_.clear();
        world_.add(s.model, s.placement);
        const l3d_image_transform to_image(s.camera, s.size, world_);
        l3d_dice_view view = to_image.view(tolerance);
        view.keep = keep;
        view.one_sided = one_sided;
        view.most_samples = s.most_samples;
        if (s.shade_tolerance > 0)
            light(s, view);
        culling_.begin(world_, to_image.matrix(), view);
        dicer_.begin(view);
        const auto nothing_is_hidden = [](const l3d_subpixel_box&, float) { return false; };
        for (auto batch = culling_.next(nothing_is_hidden); !batch.empty();
             batch = culling_.next(nothing_is_hidden)) {
            dicer_.dice(world_, culling_, batch);
            for (std::size_t i = 0; i < batch.size(); ++i)
                sink(batch[i].patch, dicer_.pieces(i), dicer_.counts().bound_px);
        }
        l3d_dice_counts counts = dicer_.counts();
        counts.offscreen += culling_.counts().offscreen;
        counts.behind += culling_.counts().behind;
        counts.beyond += culling_.counts().beyond;
        counts.subpixel += culling_.counts().subpixel;
        return counts;
    }

private:
    static void light(const scene& s, l3d_dice_view& view) {
        const auto& [x, y, z] = reference::project_light;
        view.shade_tolerance = s.shade_tolerance;
        l3d_lit_while_diced(
            view, l3d_camera_shading(s.camera, s.size, l3d_shade::lambert, {x, y, z}), true);
    }

    l3d_workers workers_{1};
    l3d_patch_scene world_;
    l3d_scene_culling culling_;
    l3d_frame_dicer<typename way_of<T>::real> dicer_{workers_, way_of<T>::way, true};
};

using diced = std::span<const l3d_diced_piece>;

/// Hands every patch's pieces to sink.draw(pieces, frame_bound).
template <class T, class Sink>
l3d_dice_counts dice(const scene& s, double tolerance, Sink& sink, l3d_culling_switches keep = {}) {
    return scene_dicer<T>().dice(
        s, tolerance, [&](std::size_t, diced pieces, double bound) { sink.draw(pieces, bound); },
        keep);
}

} // namespace dice_tests

#endif
