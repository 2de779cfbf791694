// SPDX-License-Identifier: MIT
// Frames that draw only what changed: the same bits as frames drawn whole, and no more work.
#include "pipeline/pipeline_afd.h"

#include "geom/teapot.h"
#include "raster/rasterizer_factory_sw.h"
#include "raster/surface_rasterizer_scalar.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr l3d_size odd{203, 149};

std::unique_ptr<l3d_screen> memory_screen(l3d_size size) {
    l3d_screen_request request;
    request.size = size;
    l3d_service refusal;
    return l3d_screen_factory_memory().create(request, refusal);
}

/// The slow twin fills the surfaces.
class scalar_factory final : public l3d_rasterizer_factory {
    std::unique_ptr<l3d_rasterizer_2d_imp> do_create_2d(l3d_pixels target) const override {
        return l3d_rasterizer_factory_sw().create_2d(target);
    }
    std::unique_ptr<l3d_surface_rasterizer> do_create_surface(l3d_workers&) const override {
        return std::make_unique<l3d_surface_rasterizer_scalar>();
    }
};

class tester final : public l3d_pipeline_afd {
public:
    tester(l3d_patch_scene scene, const l3d_camera& camera, const l3d_afd_settings& settings,
           const l3d_rasterizer_factory& factory = l3d_rasterizer_factory_sw(), l3d_size size = odd)
        : l3d_pipeline_afd(memory_screen(size), factory, std::move(scene), camera, settings) {}

    using l3d_pipeline_afd::camera;
    using l3d_pipeline_afd::pixels;
    using l3d_pipeline_afd::redraw;
    using l3d_pipeline_afd::settings;
    using l3d_pipeline_afd::world;

    int text_at = 0; ///< where a line is drawn on top; 0: nowhere

    std::vector<std::uint32_t> words() {
        std::vector<std::uint32_t> result;
        for (int y = 0; y < screen().pixels().height; ++y) {
            const auto row = screen().pixels().row(y);
            result.insert(result.end(), row.begin(), row.end());
        }
        return result;
    }

private:
    void draw_overlay() override {
        if (text_at > 0)
            rasterizer().draw_line(text_at, 3, 150, 100, 0x00123456);
    }
};

l3d_patch_model teapot_model() {
    std::string why;
    return *l3d_patch_model::from_bpt(l3d_teapot_bpt(), "teapot", why);
}

using random_numbers = std::mt19937_64;

double unit(random_numbers& random) {
    return std::uniform_real_distribution<double>(-1, 1)(random);
}

/// Patches of any form around the origin.
l3d_patch_model wild_model(random_numbers& random, int patches) {
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
            l3d_rotation<double>({unit(random), unit(random), 1.1}, 3 * unit(random));
        const double size = std::exp2(2 * unit(random) - 2);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                m(row, column) *= size;
        return m;
    }

    /// Moves some instances: a little, or anywhere.
    void move(tester& program) {
        const std::size_t count = program.world().instances().size();
        const std::size_t moves = 1 + random() % std::min<std::size_t>(count, 3);
        for (std::size_t i = 0; i < moves; ++i) {
            const std::size_t index = random() % count;
            const l3d_matrix<double> old = program.world().instances()[index].placement();
            if (random() % 4 == 0)
                program.world().place(index, any_model(), any_place());
            else
                program.world().place(
                    index,
                    l3d_translation<double>(0.1 * unit(random), 0.1 * unit(random), 0.0) * old);
        }
    }

    random_numbers random;
    std::vector<l3d_patch_model> models;
    l3d_patch_scene scene;
    l3d_camera camera;
    l3d_afd_settings settings;
};

struct tally {
    int frames = 0, parts = 0, still = 0;
};

/// Frames in which instances are placed anew, each beside the same frame drawn whole.
template <class Factory> tally compare(std::uint64_t seed, int frames, int threads) {
    studio s(seed);
    s.settings.threads = threads;
    tester program(s.scene, s.camera, s.settings, Factory());
    tally result;
    program.draw_event();
    for (int frame = 0; frame < frames; ++frame) {
        s.move(program);
        program.draw_event();
        const std::int64_t kept = program.report().pixels_kept;
        ++result.frames;
        result.parts += kept > 0 && kept < odd.width * odd.height;
        result.still += kept == odd.width * odd.height;
        tester fresh(program.world(), s.camera, s.settings, Factory());
        fresh.draw_event();
        EXPECT_EQ(fresh.report().pixels_kept, 0);
        const auto a = program.words(), b = fresh.words();
        int off = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            off += a[i] != b[i];
        EXPECT_EQ(off, 0) << "seed " << seed << ", frame " << frame << ", "
                          << static_cast<int>(s.settings.shade) << " tol " << s.settings.tolerance;
        // Fewer are one batch: then a frame drawn whole dices no patch that it need not.
        if (fresh.report().patches <= 128) {
            EXPECT_GE(program.report().dice.bound_px, fresh.report().dice.bound_px);
        }
    }
    return result;
}

TEST(still_picture, is_the_same_bits_as_drawn_whole) {
    for (const int threads : {1, 2}) {
        tally all;
        for (std::uint64_t seed = 0; seed < 400; ++seed) {
            const tally t = compare<l3d_rasterizer_factory_sw>(seed, 8, threads);
            all.frames += t.frames;
            all.parts += t.parts;
            all.still += t.still;
        }
        std::printf("%d frames: %d drew a part, %d nothing\n", all.frames, all.parts, all.still);
        EXPECT_GT(all.parts, all.frames / 2);
    }
}

TEST(still_picture, is_the_same_bits_by_the_slow_twin) {
    for (std::uint64_t seed = 0; seed < 60; ++seed)
        compare<scalar_factory>(seed, 6, 1);
}

} // namespace
