// SPDX-License-Identifier: MIT
// l3d_subdivide: no gap in pictures, what faces hand on, and what is no cage.
#include "hard_edged.h"
#include "subdivision/cages.h"

#include "geom/subdivision.h"
#include "pipeline/pipeline_afd.h"
#include "raster/rasterizer_factory.h"
#include "scene/sides/halved_sides.h"
#include "scene/sides/side_pairs.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>

namespace subdivision_tests {
namespace {

l3d_model_file subdivided(l3d_model_file model, const l3d_subdivision& how = {}) {
    std::string why;
    EXPECT_TRUE(l3d_subdivide(model, how, "cage", why)) << why;
    return model;
}

l3d_patch_model model_of(const l3d_model_file& file) {
    std::string why;
    const auto model = l3d_patch_model::from_file(file, "cage", why);
    EXPECT_TRUE(model) << why;
    return *model;
}

std::string complaint(l3d_model_file model) {
    std::string why;
    const l3d_model_file before = model;
    EXPECT_FALSE(l3d_subdivide(model, {}, "cage.obj", why));
    EXPECT_TRUE(model == before);
    EXPECT_EQ(why.find('\n'), why.npos);
    return why;
}

TEST(subdivide, makes_closed_surfaces_of_closed_cages) {
    for (const named_cage& cage : all_cages()) {
        const l3d_patch_model model = model_of(subdivided(cage.model));
        const l3d_side_pairs sides(model);
        std::size_t open = 0;
        for (std::size_t i = 0; i < model.patches().size(); ++i)
            for (std::size_t side = 0; side < l3d_side_pairs::sides; ++side)
                open += sides.at(i, side).is == l3d_side_pairs::kind::open;
        EXPECT_EQ(open == 0, cage.is_closed) << cage.name << ": " << open;
    }
    EXPECT_EQ(model_of(subdivided(cube())).orientation(), 1);
}

TEST(subdivide, leaves_no_pixel_uncovered_in_20_views_from_inside) {
    std::mt19937 random(5403);
    std::uniform_real_distribution<double> part(-1, 1);
    std::vector<l3d_patch_model> models;
    for (const named_cage& cage : all_cages())
        if (cage.is_closed && cage.name != "torus")
            models.push_back(model_of(subdivided(cage.model)));
    for (int view = 0; view < 20; ++view)
        for (const l3d_patch_model& model : models) {
            l3d_camera camera;
            camera.eye = {0.1 * part(random), 0.1 * part(random), 0.1 * part(random)};
            camera.target =
                camera.eye + l3d_camera::vector{part(random), part(random), part(random)};
            camera.up = {part(random), part(random), 2.0};
            camera.fov = 10 + 50 * (1 + part(random));
            camera.near_z = 0.01;
            l3d_afd_settings settings = hard_edged();
            settings.depth = true;
            settings.threads = 1;
            settings.tolerance = view % 4 == 0 ? 4 : 0.25;
            l3d_pipeline_afd pipeline(l3d_memory_canvas({160, 120}), model, camera, settings);
            pipeline.draw_event();
            constexpr float nothing = std::numeric_limits<float>::infinity();
            EXPECT_EQ(std::ranges::count(pipeline.distances(), nothing), 0)
                << "view " << view << ", " << &model - models.data();
        }
}

TEST(subdivide, tells_pictures_of_the_error) {
    const l3d_model_file file = subdivided(cube());
    const l3d_patch_model model = model_of(file);
    ASSERT_EQ(file.patch_errors.size(), model.patches().size());
    double most = 0;
    std::size_t caps = 0;
    for (std::size_t i = 0; i < file.patch_errors.size(); ++i) {
        const auto& [places, is_of_points] = file.patch_errors[i];
        EXPECT_EQ(model.surface_error(i), places);
        EXPECT_EQ(model.has_normal_error(i), is_of_points);
        EXPECT_GT(places, 0);
        EXPECT_LT(places, is_of_points ? 1e-11 : 0x1p-13 * 2 * std::sqrt(3.0));
        most = std::max(most, places);
        caps += !is_of_points;
    }
    EXPECT_EQ(caps, 8U * 3U); // the faces around each corner
    EXPECT_EQ(model.surface_error(), most);
    EXPECT_LT(model.normal_error(), 1e-8);
    l3d_camera camera;
    camera.eye = {0.0, 0.0, 5.0};
    const l3d_size size{160, 120};
    l3d_pipeline_afd pipeline(l3d_memory_canvas(size), model, camera, hard_edged());
    pipeline.draw_event();
    // Half a unit of the model is nearer than 4 units.
    const double least = camera.focal_length(size) * most / 5;
    EXPECT_GT(pipeline.report().curved_px, least);
    EXPECT_LT(pipeline.report().curved_px, 2 * least);
    EXPECT_EQ(file.notes.back().substr(0, 18), "cage: subdivided: ");
}

/// Only caps are without proof of their shades, in the report and in the map of doubt.
TEST(subdivide, leaves_shades_of_caps_alone_without_proof) {
    const l3d_patch_model model = model_of(subdivided(cube()));
    l3d_afd_settings settings = hard_edged();
    settings.error_map = true;
    // How many pixels of the cube are in doubt, by more than `levels`, in percent.
    const auto in_doubt = [&](const l3d_camera& camera, l3d_size size, double levels) {
        l3d_pipeline_afd pipeline(l3d_memory_canvas(size), model, camera, settings);
        pipeline.draw_event();
        const l3d_frame_report& report = pipeline.report();
        EXPECT_LT(report.dice.shade_bound, 3);
        EXPECT_LE(report.dice.unproven_quads, report.surface.quads);
        EXPECT_GT(report.dice.unproven_quads, 12); // the caps that are seen, and not the others
        int shown = 0, doubted = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                shown += (pipeline.screen().pixels().row(y)[x] & 0xff) > 0;
                doubted += pipeline.error_map()->at(x, y) > levels;
            }
        EXPECT_GT(shown, 500);
        return 100 * doubted / shown;
    };
    l3d_camera camera;
    camera.eye = {1.0, 1.5, 4.0};
    EXPECT_LT(in_doubt(camera, {160, 120}, 2), 25);
    // From near by, one cap is a good part of the picture.
    std::size_t cap = 0;
    while (model.has_normal_error(cap))
        ++cap;
    camera.target = model.patches()[cap].evaluate(0.5, 0.5);
    camera.eye = camera.target * 3.0;
    camera.fov = 0.1;
    EXPECT_GT(in_doubt(camera, {40, 30}, 64), 10);
}

TEST(subdivide, hands_on_materials_colours_and_parts) {
    l3d_model_file model = cube();
    model.mesh.materials = {"red", "blue"};
    model.mesh.looks.resize(2);
    model.mesh.looks[0].color = 0xff0000;
    model.mesh.looks[1].color = 0x0000ff;
    model.mesh.face_materials = {0, 1, 0, 0, 0, 0};
    model.mesh.parts = {{"lid", 0}, {"rest", 1}};
    const l3d_model_file made = subdivided(model);
    ASSERT_EQ(made.patch_materials.size(), made.patches.size());
    EXPECT_EQ(made.patch_materials.front(), 0U);
    EXPECT_EQ(made.patch_materials[made.patches.size() / 4], 1U);
    ASSERT_EQ(made.patch_parts.size(), 2U);
    EXPECT_EQ(made.patch_parts[1].first, made.patches.size() / 6);
    model.mesh.face_materials.clear();
    model.mesh.materials.clear();
    model.mesh.looks.clear();
    model.mesh.face_colors = {1, 2, 3, 4, 5, 6};
    const l3d_model_file colored = subdivided(model);
    EXPECT_EQ(colored.mesh.looks[colored.patch_materials.back()].color, 6U);
}

TEST(subdivide, makes_creases_of_tags_and_angles) {
    l3d_subdivision sharp;
    sharp.crease_angle = 80;
    const l3d_model_file box = subdivided(cube(), sharp);
    for (const auto& patch : box.patches) {
        // With all edges sharp it stays a cube.
        double reach = 0;
        for (const auto& p : patch.points)
            reach = std::max({reach, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
        EXPECT_NEAR(reach, 1, 1e-12);
    }
    l3d_model_file tagged = cube();
    tagged.tags.creases = {{0, 6, 10.0F}};
    EXPECT_NE(subdivided(tagged).notes[0].find("1 crease of tags"), std::string::npos);
}

TEST(subdivide, refuses_what_is_no_cage) {
    EXPECT_EQ(complaint({}), "cage.obj: holds no polygons to subdivide");
    l3d_model_file third = cube();
    third.mesh.vertices.push_back({0.0, 3.0, 0.0});
    third.mesh.add_face(std::vector<std::uint32_t>{2, 3, 8});
    EXPECT_NE(complaint(third).find("polygon 7 is the third at the edge of vertices 3 and 4"),
              std::string::npos);
    l3d_model_file turned = cube();
    std::swap(turned.mesh.corners[20], turned.mesh.corners[22]);
    EXPECT_NE(complaint(turned).find("turn opposite ways at the edge of vertices"),
              std::string::npos);
    l3d_model_file twice = cube();
    twice.mesh.corners[5] = twice.mesh.corners[4];
    EXPECT_NE(complaint(twice).find("polygon 2 has vertex 5 twice"), std::string::npos);
    l3d_model_file touching = cube();
    touching.mesh.vertices.push_back({3.0, 3.0, 1.0});
    touching.mesh.vertices.push_back({3.0, 2.0, 1.0});
    touching.mesh.add_face(std::vector<std::uint32_t>{6, 9, 8});
    EXPECT_NE(complaint(touching).find("polygons meet in vertex 7 alone"), std::string::npos);
}

} // namespace
} // namespace subdivision_tests
