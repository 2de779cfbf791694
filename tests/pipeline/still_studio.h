// SPDX-License-Identifier: MIT
// Scenes of models that may be moved, and a pipeline that tests may steer.
#ifndef L3D_TESTS_PIPELINE_STILL_STUDIO_H
#define L3D_TESTS_PIPELINE_STILL_STUDIO_H

#include "hard_edged.h"
#include "scene/teapot_studio.h"
#include "pipeline/pipeline_afd.h"
#include "raster/rasterizer_factory.h"
#include "sizable_screen.h"
#include "words_of.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace still_tests {

using dice_tests::teapot_model;
using pipeline_tests::sizable_screen;

inline constexpr l3d_size odd{203, 149};

/// From where the Utah teapot is usually seen.
inline l3d_camera before_the_teapot() {
    return {.eye = {3.2, 3.6, 7.4}, .target = {0.2, 1.3, 0.0}};
}

class tester final : public l3d_pipeline_afd {
public:
    tester(l3d_patch_scene scene, const l3d_camera& camera, const l3d_afd_settings& settings,
           std::shared_ptr<const l3d_rasterizer_factory> factory =
               std::make_shared<l3d_rasterizer_factory_sw>(),
           l3d_size size = odd)
        : l3d_pipeline_afd({std::make_unique<sizable_screen>(size), std::move(factory)},
                           std::move(scene), camera, settings) {}

    using l3d_pipeline_afd::pixels;

    int text_at = 0; ///< where a line is drawn on top; 0: nowhere

    void resize(l3d_size size) {
        dynamic_cast<sizable_screen&>(screen()).resize(size);
        resize_event(size);
    }

    std::vector<std::uint32_t> words() { return words_of(screen().pixels()); }

private:
    void draw_overlay() override {
        if (text_at > 0)
            rasterizer().draw_line(text_at, 3, 150, 100, 0x00123456);
    }
};

using random_numbers = std::mt19937_64;

inline double unit(random_numbers& random) {
    return std::uniform_real_distribution<double>(-1, 1)(random);
}

/// Patches of any form around the origin.
inline l3d_patch_model wild_model(random_numbers& random, int patches) {
    std::vector<l3d_patch_model::patch> result(static_cast<std::size_t>(patches));
    for (auto& patch : result) {
        const l3d_vector<double, 3> at(unit(random), unit(random), unit(random));
        for (auto& point : patch.points)
            point = at + l3d_vector<double, 3>(unit(random), unit(random), unit(random)) * 0.6;
    }
    return l3d_patch_model(std::move(result));
}

/// Models, an eye, and settings.
struct studio {
    explicit studio(std::uint64_t seed)
        : random(seed), models{wild_model(random, 1), wild_model(random, 7), teapot_model()} {
        camera.eye = {1.5 + unit(random), 2 * unit(random), 9 + unit(random)};
        camera.target = {0.2, -0.1, 0.3};
        camera.fov = 25 + 20 * (1 + unit(random));
        const int count = 1 + static_cast<int>(random() % 12);
        for (int i = 0; i < count; ++i)
            scene.add(any_model(), any_place());
        settings.tolerance = std::vector{0.1, 0.25, 0.5, 2.0, 11.0}[random() % 5];
        settings.shade = std::vector{l3d_shade::lambert, l3d_shade::lambert, l3d_shade::gouraud,
                                     l3d_shade::flat, l3d_shade::normals}[random() % 5];
    }

    const l3d_patch_model& any_model() { return models[random() % models.size()]; }

    /// Mostly in the picture, some beside it, behind the eye or across the near plane.
    l3d_matrix<double> any_place() {
        l3d_matrix<double> m =
            l3d_translation<double>(5 * unit(random), 4 * unit(random), 9 * unit(random)) *
            l3d_rotation<double>({unit(random), unit(random), 1.1}, 172 * unit(random));
        const double size = std::exp2(2 * unit(random) - 2);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                m(row, column) *= size;
        return m;
    }

    /// Moves some instances: a little, or anywhere.
    void move(tester& program) {
        const std::size_t count = program.scene().instances().size();
        const std::size_t moves = 1 + random() % std::min<std::size_t>(count, 3);
        for (std::size_t i = 0; i < moves; ++i) {
            const std::size_t index = random() % count;
            const l3d_matrix<double> old = program.scene().instances()[index].placement();
            if (random() % 4 == 0)
                program.scene().place(index, any_model(), any_place());
            else
                program.scene().place(
                    index,
                    l3d_translation<double>(0.1 * unit(random), 0.1 * unit(random), 0.0) * old);
        }
    }

    random_numbers random;
    std::vector<l3d_patch_model> models;
    l3d_patch_scene scene;
    l3d_camera camera;
    l3d_afd_settings settings = hard_edged();
};

} // namespace still_tests

#endif
