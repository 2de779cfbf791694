// SPDX-License-Identifier: MIT
// Sections: pictures of patches that a plane cuts open, against picks of the same pixels.
#include "effort.h"
#include "hard_edged.h"

#include "pipeline/pipeline_afd.h"
#include "geom/nurbs_surface.h"
#include "geom/plane.h"
#include "scene/camera.h"
#include "scene/patch_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace {

constexpr l3d_size size{60, 45};

struct cut_view {
    std::string name;
    l3d_patch_model model;
    l3d_plane<double> plane;
};

l3d_plane<double> through(const l3d_vector<double, 3>& place, const l3d_vector<double, 3>& normal) {
    return l3d_plane<double>::through(l3d_point<double>(place), normal);
}

std::vector<cut_view> cut_views() {
    const auto shape = [](const char* name) {
        return l3d_patch_model::from_surfaces(*l3d_exact_shape(name));
    };
    return {{"teapot", l3d_patch_model::teapot(), through({0.1, 1.3, 0.2}, {-1.0, 0.3, -0.4})},
            {"teapot across", l3d_patch_model::teapot(), through({0, 1.5, 0}, {0.0, -1.0, 0.0})},
            {"sphere", shape("sphere"), through({0.1, 0.2, 0.3}, {-0.2, -0.5, -1.0})},
            {"torus", shape("torus"), through({0, 0, 0}, {-1.0, 0.0, 0.0})},
            {"cylinder", shape("cylinder"), through({0, 0, 0.2}, {0.0, 0.1, -1.0})}};
}

/// Compares pixels that are not near any border: all places around them show the same, or nothing.
void expect_picks(const cut_view& of, bool parallel) {
    SCOPED_TRACE(of.name + (parallel ? ", parallel" : ""));
    l3d_camera camera{.eye = {3.2, 3.6, 7.4}};
    camera.projection = parallel ? l3d_projection::parallel : l3d_projection::perspective;
    l3d_afd_settings settings = hard_edged();
    settings.depth = true;
    settings.section = of.plane;
    l3d_pipeline_afd program(l3d_memory_canvas(size), of.model, camera, settings);
    program.frame_all();
    program.draw_event();
    const std::vector<float> distances = program.distances();
    const double pixel = 1 / program.camera().scale_at_target(size);
    // Picks on all corners, sides and middles of pixels.
    const int columns = 2 * size.width + 1, rows = 2 * size.height + 1;
    std::vector<std::optional<l3d_pick>> picks;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            picks.push_back(program.pick(column / 2.0, row / 2.0));
    int judged = 0, seen = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const auto at = [&](int column, int row) -> const std::optional<l3d_pick>& {
                return picks[static_cast<std::size_t>(row * columns + column)];
            };
            const std::optional<l3d_pick>& middle = at(2 * x + 1, 2 * y + 1);
            bool is_plain = true;
            for (int column = 2 * x; column <= 2 * x + 2; ++column)
                for (int row = 2 * y; row <= 2 * y + 2; ++row) {
                    const std::optional<l3d_pick>& each = at(column, row);
                    is_plain = is_plain && each.has_value() == middle.has_value() &&
                               (!each || std::abs(each->depth - middle->depth) < 4 * pixel);
                }
            if (!is_plain)
                continue;
            ++judged;
            seen += middle.has_value();
            const float drawn = distances[static_cast<std::size_t>(y * size.width + x)];
            if (middle)
                EXPECT_NEAR(drawn, middle->depth, 2 * pixel) << x << ", " << y;
            else
                EXPECT_FALSE(std::isfinite(drawn)) << x << ", " << y;
        }
    EXPECT_GT(judged, size.width * size.height / 2);
    EXPECT_GT(seen, 200);
}

TEST(section, shows_what_picks_find_behind_the_plane) {
    bool parallel = false;
    for (const cut_view& view : cut_views()) {
        expect_picks(view, parallel = !parallel);
        if (thorough)
            expect_picks(view, !parallel);
    }
}

/// Half of a sphere covers half of it seen along the plane; picks are on the side that is kept.
TEST(section, keeps_the_front_of_the_plane) {
    const auto sphere = l3d_patch_model::from_surfaces(*l3d_exact_shape("sphere"));
    const auto covered = [&](const std::optional<l3d_plane<double>>& plane) {
        l3d_afd_settings settings = hard_edged();
        settings.depth = true;
        settings.section = plane;
        l3d_pipeline_afd program(l3d_memory_canvas(size), sphere, {.eye = {0.0, 0.0, 5.0}},
                                 settings);
        program.draw_event();
        return std::ranges::count_if(program.distances(), [](float d) { return std::isfinite(d); });
    };
    const auto whole = static_cast<double>(covered(std::nullopt));
    EXPECT_NEAR(static_cast<double>(covered(through({0, 0, 0}, {1.0, 0.0, 0.0}))), whole / 2,
                whole / 100);
    EXPECT_EQ(covered(through({2.0, 0, 0}, {1.0, 0.0, 0.0})), 0);
    EXPECT_EQ(covered(through({-2.0, 0, 0}, {1.0, 0.0, 0.0})), whole);
}

/// The bound of the picture is as good as without the section.
TEST(section, keeps_the_bound) {
    l3d_afd_settings settings = hard_edged();
    settings.section = through({0.5, 1.3, 0.5}, {-1.0, 0.0, -1.0}); // not through a pole
    l3d_pipeline_afd program(l3d_memory_canvas({320, 240}), l3d_patch_model::teapot(),
                             {.eye = {3.2, 3.6, 7.4}, .target = {0.2, 1.3, 0.0}}, settings);
    program.draw_event();
    EXPECT_LE(program.report().dice.bound_px, settings.tolerance);
    EXPECT_EQ(program.report().dice.coarse, 0);
}

TEST(section, refuses_what_it_cannot_draw) {
    l3d_afd_settings settings = hard_edged();
    const l3d_camera camera{.eye = {3.2, 3.6, 7.4}};
    settings.section = l3d_plane<double>{{0.0, 0.0, 0.0}, 1};
    EXPECT_EQ(l3d_afd_complaint(camera, size, settings),
              "section: the plane has no unit normal, or no place");
    settings.section = through({0, 0, 0}, {1.0, 0.0, 0.0});
    EXPECT_EQ(l3d_afd_complaint(camera, size, settings), "");
    settings.outlines = settings.error_map = true;
    l3d_pipeline_afd program(l3d_memory_canvas(size), l3d_patch_model::teapot(), camera, settings);
    program.draw_event();
    EXPECT_EQ(program.outlines(), nullptr);
    EXPECT_EQ(program.error_map(), nullptr);
}

} // namespace
