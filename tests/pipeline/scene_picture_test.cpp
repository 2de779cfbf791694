// SPDX-License-Identifier: MIT
// Pictures of scenes: nothing that would be seen is left out, and placed models look placed.
#include "hard_edged.h"
#include "pipeline/pipeline_afd.h"
#include "scene/teapot_studio.h"
#include "raster/rasterizer_factory.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

using dice_tests::oblique_camera;
using dice_tests::teapot_model;

constexpr l3d_size odd{317, 241};

struct picture {
    std::vector<std::uint32_t> words;
    l3d_frame_report report;
};

picture drawn(const l3d_patch_scene& scene, const l3d_afd_settings& settings) {
    l3d_pipeline_afd pipeline(l3d_memory_canvas(odd), scene, oblique_camera(), settings);
    pipeline.draw_event();
    picture result{{}, pipeline.report()};
    for (int y = 0; y < odd.height; ++y) {
        const auto row = pipeline.screen().pixels().row(y);
        result.words.insert(result.words.end(), row.begin(), row.end());
    }
    return result;
}

struct difference {
    int pixels = 0;  ///< that differ by more than a grey level
    int filled = 0;  ///< of the first picture
    int largest = 0; ///< difference of grey levels
};

difference between(const picture& a, const picture& b) {
    difference result;
    for (std::size_t i = 0; i < a.words.size(); ++i) {
        const int levels =
            std::abs(static_cast<int>(a.words[i] & 255) - static_cast<int>(b.words[i] & 255));
        result.pixels += levels > 1;
        result.filled += a.words[i] != 0;
        result.largest = std::max(result.largest, levels);
    }
    return result;
}

l3d_matrix<double> slanted(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    l3d_matrix<double> m = l3d_identity<double>();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            m(row, column) += 0.7 * unit(random);
        m(row, 3) = unit(random);
    }
    return m;
}

/// Teapots in the picture, around it and behind the eye, most of them behind each other. None is so
/// near that it crosses the near plane: what is clipped there is diced otherwise if all is kept.
l3d_patch_scene crowd(const l3d_patch_model& model, int count) {
    std::mt19937_64 random(90125);
    std::uniform_real_distribution<double> unit(-1, 1);
    const l3d_camera camera = oblique_camera();
    const l3d_camera::frame axes = camera.axes();
    l3d_patch_scene scene;
    for (int i = 0; i < count; ++i) {
        const double w = i % 8 == 0 ? 20 * unit(random) - 30 : 40 * unit(random) + 70;
        const auto p = camera.eye + axes.forward * w + axes.right * (0.6 * w * unit(random)) +
                       axes.up * (0.45 * w * unit(random));
        scene.add(model, l3d_translation<double>(p[0], p[1], p[2]) * slanted(random));
    }
    return scene;
}

TEST(scene_picture, is_the_same_with_and_without_what_is_left_out) {
    const l3d_patch_model model = teapot_model();
    const l3d_patch_scene scene = crowd(model, 600);
    l3d_afd_settings settings = hard_edged();
    settings.tolerance = 0.1;
    settings.shade = l3d_shade::gouraud; // of which nothing is left out that changes a level
    const picture quick = drawn(scene, settings);
    settings.keep = l3d_kept_work::all();
    const picture whole = drawn(scene, settings);
    const l3d_dice_counts& counts = quick.report.dice;
    EXPECT_GT(counts.hidden, 2000);
    EXPECT_GT(counts.drawn, 1000);
    EXPECT_GT(counts.offscreen, 1000);
    EXPECT_GT(counts.behind, 500);
    EXPECT_EQ(whole.report.dice.drawn, scene.patch_count());
    const difference d = between(whole, quick);
    std::printf("%d of %d pixels differ, %ld of %ld patches drawn, %ld hidden\n", d.pixels,
                d.filled, static_cast<long>(counts.drawn), static_cast<long>(scene.patch_count()),
                static_cast<long>(counts.hidden));
    EXPECT_EQ(d.pixels, 0);
    EXPECT_EQ(whole.words, quick.words);
}

TEST(scene_picture, has_the_same_bits_from_any_number_of_threads) {
    const l3d_patch_model model = teapot_model();
    const l3d_patch_scene scene = crowd(model, 300);
    l3d_afd_settings settings = hard_edged();
    const picture one = drawn(scene, settings);
    for (const int threads : {2, 5}) {
        settings.threads = threads;
        const picture many = drawn(scene, settings);
        EXPECT_EQ(many.words, one.words) << threads;
        EXPECT_EQ(many.report.dice.drawn, one.report.dice.drawn);
        EXPECT_EQ(many.report.dice.hidden, one.report.dice.hidden);
    }
}

TEST(scene_picture, of_a_placed_model_is_that_of_a_model_made_there) {
    const l3d_patch_model model = teapot_model();
    std::mt19937_64 random(41);
    for (int i = 0; i < 8; ++i) {
        l3d_matrix<double> placement = slanted(random);
        if (i % 2 == 0) // inside out
            for (int row = 0; row < 3; ++row)
                placement(row, 0) = -placement(row, 0);
        std::vector<l3d_patch_model::patch> patches(model.patches().begin(), model.patches().end());
        for (auto& patch : patches)
            for (auto& p : patch.points) {
                const auto h = placement * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
                p = {h[0], h[1], h[2]};
            }
        const l3d_patch_model made_there(std::move(patches));
        l3d_patch_scene scene;
        scene.add(model, placement);
        for (const l3d_shade shade : {l3d_shade::lambert, l3d_shade::normals}) {
            l3d_afd_settings settings = hard_edged();
            settings.shade = shade;
            const difference d = between(drawn(made_there, settings), drawn(scene, settings));
            EXPECT_GT(d.filled, 1000);
            // How the placed one bends is told from bounds of the model's own bends, so it has
            // other steps; these move a pixel's centre across an outline, within the tolerance.
            EXPECT_LE(d.pixels, 1 + d.filled / 40) << "placement " << i;
        }
    }
}

} // namespace
