// SPDX-License-Identifier: MIT
// What programs draw and colour themselves: overlays of every pipeline, and shades of their own.
#include "hard_edged.h"
#include "geom/polygon_shapes.h"
#include "geom/teapot.h"
#include "pipeline/any_model.h"
#include "pipeline/pipeline_afd_viewer.h"
#include "pipeline/polygons/pipeline_zbuffer.h"
#include "pipeline/zsort/pipeline_zsort.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

namespace {

constexpr l3d_size size{320, 240};
constexpr std::uint32_t own_color = 0x0012fe34;
const l3d_camera camera{.eye = {3.2, 3.6, 7.4}, .target = {0.2, 1.3, 0.0}};

/// Paints over all of the picture.
template <class Pipeline> class painted final : public Pipeline {
public:
    using Pipeline::Pipeline;

    std::int64_t own_pixels() {
        this->draw_event();
        std::int64_t count = 0;
        for (int y = 0; y < size.height; ++y)
            count += std::ranges::count(this->screen().pixels().row(y), own_color);
        return count;
    }

private:
    void draw_overlay() override { this->rasterizer().draw_box(l3d_whole(size), own_color); }
};

/// The panels of help lie on what a program draws.
template <class Pipeline> void expect_below_panels(Pipeline&& pipeline, int key) {
    EXPECT_EQ(pipeline.own_pixels(), l3d_whole(size).area());
    pipeline.key_event(key);
    EXPECT_LT(pipeline.own_pixels(), l3d_whole(size).area() * 9 / 10);
}

TEST(own_drawing, lies_on_the_picture_and_below_the_panels_of_every_pipeline) {
    const l3d_polygon_model torus(l3d_torus_mesh(12, 8, 1.7, 0.7));
    expect_below_panels(painted<l3d_pipeline_afd_viewer>(l3d_memory_canvas(size),
                                                         l3d_patch_model::teapot(), camera,
                                                         hard_edged()),
                        'h');
    expect_below_panels(painted<l3d_pipeline_zbuffer>(l3d_memory_canvas(size), torus, camera,
                                                      hard_edged_polygons()),
                        'h');
    expect_below_panels(
        painted<l3d_pipeline_zsort>(l3d_memory_canvas(size), torus, camera, hard_edged_polygons()),
        'h');
}

/// A panel that panels of polygons keep clear of.
class labelled final : public l3d_pipeline_zbuffer {
public:
    using l3d_pipeline_zbuffer::l3d_pipeline_zbuffer;

private:
    l3d_standing_panel standing_panel() override {
        l3d_standing_panel standing{.corner = l3d_corner::top_left};
        standing.panel.add("a torus");
        return standing;
    }
};

TEST(own_drawing, a_standing_panel_of_polygons_stays_where_it_is_when_a_status_comes) {
    labelled pipeline(l3d_memory_canvas(size), l3d_polygon_model(l3d_torus_mesh(12, 8, 1.7, 0.7)),
                      camera, {});
    const auto corner = [&] {
        pipeline.draw_event();
        std::vector<std::uint32_t> words;
        for (int y = 0; y < 30; ++y)
            words.insert(words.end(), pipeline.screen().pixels().row(y).begin(),
                         pipeline.screen().pixels().row(y).begin() + 70);
        return words;
    };
    const auto before = corner();
    pipeline.key_event('o');
    EXPECT_EQ(corner(), before);
}

TEST(usual_settings, are_those_of_the_programs) {
    const l3d_afd_settings patches;
    const l3d_polygon_settings polygons;
    EXPECT_TRUE(patches.antialias && polygons.antialias);
    EXPECT_EQ(patches.background, l3d_background::gradient());
    EXPECT_EQ(polygons.background, l3d_background::gradient());
    EXPECT_EQ(patches.threads, l3d_usual_threads());
    EXPECT_EQ(polygons.threads, l3d_usual_threads());
    EXPECT_EQ(polygons.shade, l3d_shade::lambert);
    std::string why;
    EXPECT_EQ(l3d_memory_canvas(size).font.name(), l3d_font::of_system(why).name());
}

/// Tells places by colours: eight bits of each coordinate, from -4 to 4.
std::uint32_t word_of(const l3d_vector<double, 3>& point) {
    std::uint32_t word = 0;
    for (int k = 0; k < 3; ++k)
        word = word << 8 | static_cast<std::uint32_t>(std::clamp((point[k] + 4) * 32, 0.0, 255.0));
    return word;
}

void color_by_place(std::span<const l3d_seen_place> places, std::span<std::uint32_t> words) {
    for (std::size_t i = 0; i < places.size(); ++i)
        words[i] = word_of(places[i].point);
}

TEST(own_shade, gets_the_exact_point_of_each_pixel) {
    l3d_afd_settings settings = hard_edged();
    settings.shade = l3d_shade::own;
    settings.own.colors = color_by_place;
    l3d_pipeline_afd pipeline(l3d_memory_canvas(size), l3d_patch_model::teapot(), camera, settings);
    pipeline.draw_event();
    int tested = 0;
    for (int y = 3; y < size.height; y += 7)
        for (int x = 3; x < size.width; x += 7) {
            const auto pick = pipeline.pick(x + 0.5, y + 0.5);
            const std::uint32_t word = pipeline.screen().pixels().row(y)[std::size_t(x)];
            if (!pick || word == 0)
                continue;
            ++tested;
            for (int k = 0, shift = 16; k < 3; ++k, shift -= 8)
                EXPECT_NEAR(word >> shift & 255, (pick->point[k] + 4) * 32, 1.1) << x << ' ' << y;
        }
    EXPECT_GT(tested, 200);
    EXPECT_TRUE(std::isinf(pipeline.report().dice.shade_bound));
    pipeline.settings().own.error = 0.5;
    pipeline.redraw();
    pipeline.draw_event();
    EXPECT_EQ(pipeline.report().dice.shade_bound, 0.5);
}

TEST(own_shade, gets_unit_normals_turned_to_the_eye_materials_and_the_light_of_lambert) {
    l3d_afd_settings settings = hard_edged();
    settings.shade = l3d_shade::own;
    settings.own.colors = [](std::span<const l3d_seen_place> places,
                             std::span<std::uint32_t> words) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const l3d_seen_place& p = places[i];
            const bool is_unit = std::abs(l3d_length(p.normal) - 1) < 1e-9;
            const bool is_front = l3d_dot(p.normal, camera.eye - p.point) >= 0;
            const auto level = static_cast<std::uint32_t>(255 * p.light + 0.5);
            words[i] = is_unit && is_front && p.material.color == 0xffffff ? level * 0x010101 : 255;
        }
    };
    const auto level_at = [&](l3d_shade shade) {
        settings.shade = shade;
        l3d_pipeline_afd pipeline(l3d_memory_canvas(size), l3d_patch_model::teapot(), camera,
                                  settings);
        pipeline.draw_event();
        std::vector<int> levels;
        for (int y = 0; y < size.height; ++y)
            for (const std::uint32_t word : pipeline.screen().pixels().row(y))
                levels.push_back((word & 255) == (word >> 16 & 255) ? int(word & 255) : -1);
        return levels;
    };
    const auto own = level_at(l3d_shade::own), lambert = level_at(l3d_shade::lambert);
    EXPECT_EQ(std::ranges::count(own, -1), 0);
    int far = 0;
    for (std::size_t i = 0; i < own.size(); ++i)
        far += std::abs(own[i] - lambert[i]) > 4;
    EXPECT_LT(far, 120); // at outlines, another side of a fold may be lit
}

TEST(own_shade, is_the_same_for_any_number_of_threads_and_mixed_at_edges) {
    l3d_afd_settings settings;
    settings.shade = l3d_shade::own;
    settings.own.colors = color_by_place;
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 3}) {
        settings.threads = threads;
        l3d_pipeline_afd pipeline(l3d_memory_canvas(size), l3d_patch_model::teapot(), camera,
                                  settings);
        pipeline.draw_event();
        EXPECT_GT(pipeline.report().surface.refined, 0);
        hashes.push_back(pipeline.report().hash);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(own_shade, without_a_function_is_refused) {
    l3d_afd_settings settings;
    settings.shade = l3d_shade::own;
    EXPECT_EQ(l3d_afd_complaint(camera, size, settings),
              "own: shade 'own' needs a function that gives colours");
}

TEST(any_model, says_what_a_file_holds) {
    const auto folder = std::filesystem::temp_directory_path() / "l3d_any_model_test";
    std::filesystem::create_directories(folder);
    const auto file = [&](const char* name, std::string_view text) {
        std::ofstream(folder / name) << text;
        return (folder / name).string();
    };
    const auto patches = l3d_load_any_model(file("a.bpt", l3d_teapot_bpt()));
    ASSERT_TRUE(std::holds_alternative<l3d_patch_model>(patches));
    EXPECT_EQ(std::get<l3d_patch_model>(patches).patches().size(), 28U);
    std::vector<std::string> notes;
    const auto polygons = l3d_load_any_model(
        file("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl none\nmtllib none.mtl\n"),
        &notes);
    ASSERT_TRUE(std::holds_alternative<l3d_polygon_model>(polygons));
    EXPECT_EQ(std::get<l3d_polygon_model>(polygons).mesh().faces(), 1U);
    EXPECT_FALSE(notes.empty());
    EXPECT_THROW(static_cast<void>(l3d_load_any_model(file("c.obj", "v 0 0 0\n"))), l3d_error);
    std::visit(
        []<class Model>(const Model& model) {
            l3d_pipeline_for<Model> pipeline(l3d_memory_canvas(size), model, camera, {});
            pipeline.frame_all();
            pipeline.draw_event();
            EXPECT_EQ(pipeline.why_empty(), "");
        },
        polygons);
    std::filesystem::remove_all(folder);
}

TEST(any_model, tells_of_lines_that_are_lost_among_polygons) {
    const auto folder = std::filesystem::temp_directory_path() / "l3d_lost_lines_test";
    std::filesystem::create_directories(folder);
    const std::string name = (folder / "a.obj").string();
    const auto notes_of = [&](const std::string& more) {
        std::ofstream(name) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nl 1 2\n" << more;
        std::vector<std::string> notes;
        static_cast<void>(l3d_load_any_model(name, &notes));
        return notes;
    };
    const std::string face = "f 1 2 3\n", lost = name + ": lines and curves are not drawn: they ";
    const std::string surface = "cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1\n"
                                "parm v 0 1\nend\n";
    EXPECT_EQ(notes_of(face), std::vector{lost + "are only beside surfaces"});
    EXPECT_EQ(notes_of(face + surface),
              std::vector{lost + "are only beside surfaces that do not become polygons"});
    EXPECT_TRUE(notes_of(surface).empty());
    std::filesystem::remove_all(folder);
}

} // namespace
