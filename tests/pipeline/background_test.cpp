// SPDX-License-Identifier: MIT
// Backgrounds: what empty pixels show, what edges mix with, and what transparency means.
#include "hard_edged.h"
#include "../dice/scene.h"
#include "level_difference.h"
#include "scene/teapot_studio.h"
#include "words_of.h"

#include "pipeline/pipeline_afd.h"
#include "raster/depth_buffer.h"
#include "pipeline/polygons/pipeline_zbuffer.h"
#include "pipeline/zsort/pipeline_zsort.h"
#include "pipeline/polygons/polygon_model.h"
#include "raster/rasterizer_factory.h"
#include "raster/color/srgb_light.h"
#include "reference/box_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

namespace {

constexpr l3d_size size{131, 97};
constexpr l3d_background white = l3d_background::color(0x00ffffff);
constexpr l3d_background odd{0x00204060, 0x00e01002};

using words = std::vector<std::uint32_t>;

l3d_camera camera() {
    l3d_camera result;
    result.eye = {3.2, 3.6, 7.4};
    result.target = {0.2, 1.3, 0.0};
    return result;
}

l3d_afd_settings settings_with(const l3d_background& background, bool antialias) {
    l3d_afd_settings result = hard_edged();
    result.background = background;
    result.antialias = antialias;
    return result;
}

struct drawn {
    words picture;
    std::vector<bool> is_empty;
};

drawn teapot(l3d_afd_settings settings) {
    settings.depth = true;
    l3d_patch_scene scene;
    scene.add(l3d_patch_model::teapot());
    l3d_pipeline_afd pipeline(l3d_memory_canvas(size), scene, camera(), settings);
    pipeline.draw_event();
    drawn result{words_of(pipeline.screen().pixels()), {}};
    for (int y = 0; y < size.height; ++y)
        for (const float inv_w : pipeline.depth().row(y))
            result.is_empty.push_back(inv_w == 0);
    return result;
}

std::uint32_t word_at(const l3d_background& background, std::size_t pixel) {
    return background.word(static_cast<int>(pixel / size.width), size.height);
}

double light(std::uint32_t word, int shift) {
    return l3d_light_of_level(word >> shift & 255);
}

TEST(background, goes_linearly_from_the_first_row_to_the_last) {
    const l3d_background b{0x00102030, 0x00f02010};
    EXPECT_EQ(b.word(0, 5), 0x00102030u);
    EXPECT_EQ(b.word(1, 5), 0x00482028u);
    EXPECT_EQ(b.word(2, 5), 0x00802020u);
    EXPECT_EQ(b.word(4, 5), 0x00f02010u);
    EXPECT_EQ(b.word(0, 1), 0x00102030u);
    EXPECT_EQ(l3d_background().word(3, 9), 0u);
    EXPECT_EQ(l3d_background::none().word(3, 9), l3d_pixels::transparent);
    EXPECT_TRUE(l3d_background().is_grey());
    EXPECT_FALSE(b.is_grey());
}

TEST(background, is_seen_where_nothing_is_and_nowhere_else) {
    for (const l3d_shade shade : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat,
                                  l3d_shade::normals, l3d_shade::error}) {
        l3d_afd_settings settings = settings_with(odd, false);
        settings.shade = shade;
        const drawn on_odd = teapot(settings);
        settings.background = {};
        const drawn on_black = teapot(settings);
        long empty = 0;
        for (std::size_t i = 0; i < on_odd.picture.size(); ++i) {
            empty += on_odd.is_empty[i];
            ASSERT_EQ(on_odd.picture[i], on_odd.is_empty[i] ? word_at(odd, i) : on_black.picture[i])
                << i;
        }
        EXPECT_GT(empty, 1000);
    }
}

/// The share of a pixel that is seen of its surfaces, and their light: the picture on black holds
/// their product. So light on any other background is known. What is found to be an edge depends
/// on the levels beside it: where several edges meet, a few pixels are refined on one of them only.
TEST(background, is_mixed_into_edges_in_linear_light) {
    const words black = teapot(settings_with({}, true)).picture;
    const words none = teapot(settings_with(l3d_background::none(), true)).picture;
    for (const l3d_background& background : {white, odd}) {
        const words picture = teapot(settings_with(background, true)).picture;
        int partly = 0, off = 0;
        for (std::size_t i = 0; i < picture.size(); ++i) {
            const double empty = (none[i] >> 24) / 255.0;
            partly += empty > 0 && empty < 1;
            for (const int shift : {0, 8, 16}) {
                const double of_surface = light(black[i], shift);
                const double expected =
                    l3d_level_of_light(of_surface + empty * light(word_at(background, i), shift));
                off += std::abs((picture[i] >> shift & 255) - expected) > 2.5;
            }
        }
        EXPECT_GT(partly, 150);
        EXPECT_LE(off, 3 * partly / 50) << "of three channels each";
    }
}

TEST(background, that_is_none_leaves_straight_colours_and_exact_coverage) {
    for (const bool antialias : {false, true}) {
        const words none = teapot(settings_with(l3d_background::none(), antialias)).picture;
        const words black = teapot(settings_with({}, antialias)).picture;
        for (std::size_t i = 0; i < none.size(); ++i) {
            const std::uint32_t empty = none[i] >> 24;
            if (!antialias) {
                ASSERT_TRUE(empty == 0 || none[i] == l3d_pixels::transparent) << i;
            }
            if (empty == 0) {
                ASSERT_EQ(none[i], black[i]) << i;
            }
            // Over black, the straight colour times its coverage is what black shows.
            const double over = l3d_level_of_light((255 - empty) / 255.0 * light(none[i], 0));
            ASSERT_NEAR(black[i] & 255, over, 7) << i << ", transparent " << empty;
        }
    }
}

/// The middle of a side that is not parallel to the axes: coverage has a known mean.
TEST(background, shares_a_straight_edge_by_area) {
    std::array<l3d_vector<double, 3>, 16> points;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            points[static_cast<std::size_t>(4 * row + column)] = {
                20.0 * column / 3, 20.0 * row / 3 - 10 + 2.0 * column, 0.0};
    l3d_patch_model::patch flat;
    std::ranges::copy(points, flat.points.begin());
    l3d_patch_scene scene;
    scene.add(l3d_patch_model({flat}));
    l3d_camera eye;
    eye.eye = {0.0, 0.0, 10.0};
    eye.target = {0.0, 0.0, 0.0};
    l3d_afd_settings settings = settings_with(l3d_background::none(), true);
    l3d_pipeline_afd pipeline(l3d_memory_canvas(size), scene, eye, settings);
    pipeline.draw_event();
    // Its left side is the vertical through the middle of the picture, which is a pixel's middle.
    const int middle = size.width / 2;
    for (int y = 30; y < 60; ++y) {
        const auto row = pipeline.screen().pixels().row(y);
        EXPECT_EQ(row[static_cast<std::size_t>(middle - 1)], l3d_pixels::transparent);
        EXPECT_NEAR(row[static_cast<std::size_t>(middle)] >> 24, 127.5, 1);
        EXPECT_EQ(row[static_cast<std::size_t>(middle + 1)] >> 24, 0u);
    }
}

TEST(background, does_not_depend_on_threads_or_on_frames_before) {
    for (const bool antialias : {false, true}) {
        l3d_afd_settings settings = settings_with(odd, antialias);
        const words one = teapot(settings).picture;
        settings.threads = 3;
        EXPECT_EQ(teapot(settings).picture, one);

        l3d_patch_scene scene;
        scene.add(l3d_patch_model::teapot());
        l3d_pipeline_afd pipeline(l3d_memory_canvas(size), scene, camera(),
                                  settings_with(white, antialias));
        pipeline.draw_event();
        pipeline.camera().eye[0] += 0.5;
        pipeline.draw_event();
        pipeline.settings().background = odd;
        pipeline.camera() = camera();
        pipeline.draw_event();
        EXPECT_EQ(words_of(pipeline.screen().pixels()), one);
    }
}

TEST(background, is_behind_lines_too) {
    for (const bool antialias : {false, true}) {
        l3d_afd_settings settings = settings_with(odd, antialias);
        settings.wireframe = true;
        const words lines = teapot(settings).picture;
        settings.background = {};
        const words on_black = teapot(settings).picture;
        settings.background = l3d_background::none();
        const words on_none = teapot(settings).picture;
        int lit = 0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            ASSERT_EQ(on_black[i] == 0, lines[i] == word_at(odd, i)) << i;
            ASSERT_EQ(on_black[i] == 0, on_none[i] == l3d_pixels::transparent) << i;
            // Of one colour, whatever it covers.
            if (on_black[i] != 0) {
                ASSERT_EQ(on_none[i] & 0x00ffffff, 0x0080d0ffu) << i;
                // On black, the blue of 255 is what is covered.
                ASSERT_NEAR(255 - (on_none[i] >> 24), on_black[i] & 255, 3) << i;
            }
            lit += on_black[i] != 0;
        }
        EXPECT_GT(lit, 500);
    }
}

/// The exact pictures on black and on white: light on any other background lies between theirs, in
/// proportion.
class exact_on_any {
public:
    explicit exact_on_any(const dice_tests::scene& s)
        : on_black_(s.patches, s.eye, s.picture(), reference::project_light),
          on_white_(s.patches, s.eye, s.picture(), reference::project_light, {.background = 255}) {}

    double level(std::size_t pixel, std::uint32_t background) const {
        const double dark = l3d_light_of_level(on_black_.pixels()[pixel].level);
        const double bright = l3d_light_of_level(on_white_.pixels()[pixel].level);
        return l3d_level_of_light(dark + (bright - dark) * l3d_light_of_level(background));
    }
    /// Where black and white say of light how unsure it is: levels on black are the steepest.
    double unsure(std::size_t pixel) const {
        return on_black_.pixels()[pixel].unsure + on_white_.pixels()[pixel].unsure;
    }
    bool is_empty(std::size_t pixel) const {
        return on_black_.pixels()[pixel].covered == 0 && !on_black_.pixels()[pixel].edge;
    }

private:
    reference::box_image on_black_, on_white_;
};

/// Each row has another colour, and each channel goes another way.
TEST(background, is_known_to_the_map_of_errors) {
    constexpr l3d_size small{40, 30};
    constexpr l3d_background colors{0x00301030, 0x0010f0f0};
    const dice_tests::scene s = dice_tests::teapot(reference::project_view("full"), small);
    const exact_on_any exact(s);
    l3d_patch_scene scene;
    scene.add(s.model, s.placement);
    for (const bool antialias : {true, false}) {
        l3d_afd_settings settings = settings_with(colors, antialias);
        settings.error_map = true;
        settings.light = {reference::project_light.x, reference::project_light.y,
                          reference::project_light.z};
        l3d_pipeline_afd pipeline(l3d_memory_canvas(small), scene, s.camera, settings);
        pipeline.draw_event();
        ASSERT_NE(pipeline.error_map(), nullptr);
        const words picture = words_of(pipeline.screen().pixels());
        int certain = 0, loose = 0;
        for (std::size_t i = 0; i < picture.size(); ++i) {
            const std::uint32_t ground =
                colors.word(static_cast<int>(i) / small.width, small.height);
            const double bound = static_cast<double>(pipeline.error_map()->levels()[i]);
            double off = 0;
            for (const int shift : {0, 8, 16}) {
                const double level = exact.level(i, ground >> shift & 255);
                off = std::max(off, std::abs((picture[i] >> shift & 255) - level));
            }
            EXPECT_LE(off, bound + exact.unsure(i))
                << i % small.width << ", " << i / small.width << ", antialias " << antialias;
            certain += exact.is_empty(i) && picture[i] == ground && bound < 0.01;
            loose += bound > off + 40;
        }
        EXPECT_GT(certain, 400) << "the background in the corners";
        EXPECT_LT(loose, 20) << "bounds are of this background, not of any";
        pipeline.settings().background = l3d_background::none();
        pipeline.redraw();
        pipeline.draw_event();
        EXPECT_EQ(pipeline.error_map(), nullptr) << "there is no exact picture";
    }
}

/// The pixels that a pipeline of polygons leaves empty on black are those that show a background.
template <class Pipeline, class... More>
void expect_behind(l3d_polygon_settings settings, const More&... more) {
    const auto picture = [&](const l3d_background& background) {
        settings.background = background;
        l3d_polygon_model model(l3d_tessellated(l3d_patch_model::teapot(), 8).mesh, false);
        Pipeline pipeline(l3d_memory_canvas(size), model, camera(), settings, more...);
        pipeline.draw_event();
        return words_of(pipeline.screen().pixels());
    };
    const words on_black = picture({}), on_odd = picture(odd),
                on_none = picture(l3d_background::none());
    long empty = 0;
    for (std::size_t i = 0; i < on_black.size(); ++i) {
        if (on_black[i] == 0) {
            ASSERT_LE(level_difference(on_odd[i], word_at(odd, i)), settings.antialias ? 4 : 0)
                << i;
            ASSERT_GE(on_none[i] >> 24, settings.antialias ? 250u : 255u) << i;
            ++empty;
        } else if (!settings.antialias) {
            ASSERT_EQ(on_odd[i], on_black[i]) << i;
            ASSERT_EQ(on_none[i], on_black[i]) << i;
        }
    }
    EXPECT_GT(empty, 1000);
}

TEST(background, is_behind_polygons_of_every_pipeline_and_style) {
    for (const l3d_polygon_style style :
         {l3d_polygon_style::solid, l3d_polygon_style::wireframe, l3d_polygon_style::hidden_lines})
        for (const bool antialias : {false, true}) {
            l3d_polygon_settings settings = hard_edged_polygons();
            settings.style = style;
            settings.antialias = antialias;
            expect_behind<l3d_pipeline_zbuffer>(settings, l3d_rasterizer_factory_sw());
            expect_behind<l3d_pipeline_zsort>(settings);
        }
}

} // namespace
