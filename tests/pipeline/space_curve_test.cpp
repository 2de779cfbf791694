// SPDX-License-Identifier: MIT
// Curves in space: their width, and what hides them.
#include "hard_edged.h"

#include "base/error.h"
#include "geom/transform.h"
#include "pipeline/pipeline_afd.h"
#include "scene/patch_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace {

using vector = l3d_nurbs_curve::vector;
constexpr l3d_size size{320, 240};
constexpr std::uint32_t red = 0x00ff0000;

/// A pipeline whose lines' pixels are counted: nothing else is red.
class drawing final : public l3d_pipeline_afd {
public:
    explicit drawing(const l3d_patch_scene& scene, const l3d_camera& camera,
                     const l3d_afd_settings& settings = hard_edged())
        : l3d_pipeline_afd(l3d_memory_canvas(size), scene, camera, settings) {}

    std::vector<std::uint32_t> words() {
        draw_event();
        std::vector<std::uint32_t> result;
        for (int y = 0; y < size.height; ++y)
            result.insert(result.end(), screen().pixels().row(y).begin(),
                          screen().pixels().row(y).end());
        return result;
    }

    std::vector<bool> line_pixels() {
        std::vector<bool> result;
        for (const std::uint32_t word : words())
            result.push_back(word == red);
        return result;
    }

    /// Where a place is in the picture, and how far along the view axis.
    vector seen(const vector& p) {
        const auto q = camera().image_matrix(size) * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
        return {size.width / 2.0 + q[0] / q[3], size.height / 2.0 + q[1] / q[3],
                camera().depth_of(p)};
    }

    /// The size of a pixel at a distance.
    double pixel_at(double depth) {
        return camera().is_parallel() ? 1 / camera().scale_at_target(size)
                                      : depth / camera().focal_length(size);
    }
};

bool in_picture(const vector& at, double margin) {
    return at[0] >= margin && at[0] < size.width - margin && at[1] >= margin &&
           at[1] < size.height - margin;
}

const l3d_camera before{.eye = {0.0, 0.0, 10.0}};

/// A helix around the teapot, interpolating nothing: any curve of degree 5 will do.
l3d_nurbs_curve helix() {
    std::vector<vector> points;
    for (int i = 0; i <= 40; ++i) {
        const double angle = i * std::numbers::pi / 5;
        points.push_back({2.6 * std::cos(angle), i * 0.075, 2.6 * std::sin(angle)});
    }
    return {l3d_bspline_direction::clamped(5, points.size()), points};
}

void expect_hidden_behind_surfaces(l3d_projection projection) {
    drawing pipeline(l3d_patch_model::teapot(),
                     {.eye = {3.2, 3.6, 7.4}, .target = {0.2, 1.3, 0.0}, .projection = projection});
    const l3d_nurbs_curve curve = helix();
    pipeline.curves().emplace_back(curve, red, 3);
    const std::vector<bool> is_line = pipeline.line_pixels();
    // The least distance of the curve along the view axis within two pixels of each pixel.
    std::vector<double> nearest(is_line.size(), std::numeric_limits<double>::infinity());
    constexpr double sure = 0.1; // several pixels' worth of depth, but at the outline
    int seen_count = 0, hidden_count = 0;
    for (int i = 0; i <= 3000; ++i) {
        const vector at = pipeline.seen(curve.evaluate(i / 3000.0));
        if (!in_picture(at, 4))
            continue;
        const auto pick = pipeline.pick(at[0], at[1]);
        const double room = pick ? pick->depth - at[2] : 1;
        const int x = static_cast<int>(at[0]), y = static_cast<int>(at[1]);
        // The middle of a pixel decides. Beside an outline, another surface may be there.
        const double tolerance = pipeline.settings().tolerance;
        bool is_alike = true;
        for (const double dx : {-tolerance, 0.0, tolerance})
            for (const double dy : {-tolerance, 0.0, tolerance}) {
                const auto middle = pipeline.pick(x + 0.5 + dx, y + 0.5 + dy);
                is_alike = is_alike && !(middle && middle->depth - at[2] < sure);
            }
        if (room > sure && is_alike) {
            ++seen_count;
            EXPECT_TRUE(is_line[static_cast<std::size_t>(y * size.width + x)]) << x << ' ' << y;
        }
        hidden_count += room < -sure ? 1 : 0;
        for (int v = y - 2; v <= y + 2; ++v)
            for (int u = x - 2; u <= x + 2; ++u) {
                double& depth = nearest[static_cast<std::size_t>(v * size.width + u)];
                depth = std::min(depth, at[2]);
            }
    }
    EXPECT_GT(seen_count, 1200);
    EXPECT_GT(hidden_count, 500);
    for (std::size_t i = 0; i < is_line.size(); ++i) {
        const auto x = static_cast<double>(i % size.width), y = static_cast<double>(i / size.width);
        const auto depth = [&](double dx, double dy) {
            const auto pick = pipeline.pick(x + 0.5 + dx, y + 0.5 + dy);
            return pick ? pick->depth : 1e9;
        };
        if (!is_line[i])
            continue;
        // The line may be on the surface up to 2 pixels away; beside outlines that is far, but at
        // most as far as 8 pixels' sizes for each.
        const double here = depth(0, 0);
        const double rise = std::min(std::abs(depth(-1, 0) - here), std::abs(depth(1, 0) - here)) +
                            std::min(std::abs(depth(0, -1) - here), std::abs(depth(0, 1) - here));
        EXPECT_LT(nearest[i], here + 2.5 * std::min(rise, 8 * pipeline.pixel_at(here)) + sure)
            << x << ' ' << y;
    }
}

TEST(space_curve, is_seen_before_surfaces_and_hidden_behind_them) {
    for (const auto projection : {l3d_projection::perspective, l3d_projection::parallel})
        expect_hidden_behind_surfaces(projection);
}

TEST(space_curve, of_a_circle_covers_the_pixels_of_its_width) {
    drawing pipeline(l3d_patch_scene(), before);
    constexpr double width = 5, radius = 2;
    pipeline.curves().emplace_back(l3d_nurbs_curve::circle(radius), red, width);
    const std::vector<bool> is_line = pipeline.line_pixels();
    const double seen = radius * before.focal_length(size) / 10;
    const double tolerance = pipeline.settings().tolerance;
    std::size_t index = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const double from_circle = std::abs(
                std::hypot(x + 0.5 - size.width / 2.0, y + 0.5 - size.height / 2.0) - seen);
            const bool is_here = is_line[index++];
            if (std::abs(from_circle - width / 2) > tolerance) {
                EXPECT_EQ(is_here, from_circle < width / 2) << x << ' ' << y;
            }
        }
}

TEST(space_curve, on_a_surface_is_seen_whole) {
    // A bent patch, and the curve at v = 1/3 on it.
    l3d_patch_model::patch patch;
    for (std::size_t i = 0; i < 16; ++i) {
        const auto u = static_cast<double>(i % 4), v = static_cast<double>(i / 4);
        patch.points[i] = {u - 1.5, v - 1.5, (u == 1 ? 0.4 : 0) - (v == 2 ? 0.3 : 0)};
    }
    std::vector<vector> points;
    const double at = 1.0 / 3, b[4] = {8.0 / 27, 12.0 / 27, 6.0 / 27, 1.0 / 27};
    for (std::size_t u = 0; u < 4; ++u) {
        vector sum{0.0, 0.0, 0.0};
        for (std::size_t v = 0; v < 4; ++v)
            sum += patch.points[4 * v + u] * b[v];
        points.push_back(sum);
    }
    EXPECT_NEAR(points[0][1], 3 * at - 1.5, 1e-12);
    const l3d_nurbs_curve curve{l3d_bspline_direction::clamped(3, 4), points};
    for (const double height : {0.5, 2.0, 4.0})
        for (const double width : {1.0, 4.0, 9.0}) {
            const l3d_camera camera{.eye = {height, -height, 5.0}};
            drawing alone(l3d_patch_scene(), camera), on(l3d_patch_model({patch}), camera);
            alone.curves().emplace_back(curve, red, width);
            on.curves() = alone.curves();
            EXPECT_EQ(alone.line_pixels(), on.line_pixels()) << height << ' ' << width;
        }
}

TEST(space_curve, is_cut_off_at_the_near_plane) {
    drawing pipeline(l3d_patch_scene(), before);
    const auto to = [&](double z) {
        // The line passes the eye 1 below it: at the near plane it is far below the picture.
        pipeline.curves() = {l3d_space_curve(
            l3d_nurbs_curve::polyline({{0.0, -1.0, -20.0}, {0.0, -1.0, z}}), red, 3)};
        pipeline.redraw();
        return pipeline.line_pixels();
    };
    const auto before_it = to(9.5), behind_it = to(30);
    EXPECT_EQ(before_it, behind_it);
    EXPECT_GT(std::ranges::count(behind_it, true), 100);
    // A curve of degree 2 along the same line.
    pipeline.curves() = {
        l3d_space_curve({l3d_bspline_direction::clamped(2, 3),
                         {{0.0, -1.0, -20.0}, {0.0, -1.0, 5.0}, {0.0, -1.0, 30.0}}},
                        red, 3)};
    pipeline.redraw();
    EXPECT_EQ(pipeline.line_pixels(), behind_it);
}

TEST(space_curve, ends_in_the_picture_where_the_near_or_far_plane_cuts_it) {
    const auto drawn = [](double from, double to, double near, double far) {
        l3d_camera camera = before;
        camera.near_z = near;
        camera.far_z = far;
        drawing pipeline(l3d_patch_scene(), camera);
        pipeline.curves().emplace_back(
            l3d_nurbs_curve::polyline({{0.0, -1.0, from}, {0.0, -1.0, to}}), red, 3);
        return pipeline.line_pixels();
    };
    const auto short_line = drawn(-10, 4, 0.1, 1000);
    EXPECT_GT(std::ranges::count(short_line, true), 30);
    EXPECT_EQ(drawn(-50, 8, 6, 20), short_line);
    EXPECT_NE(drawn(-50, 8, 0.1, 20), short_line);
    EXPECT_NE(drawn(-50, 8, 6, 1000), short_line);
}

TEST(space_curve, fades_into_fog_and_is_smooth_if_edges_are) {
    l3d_afd_settings settings = hard_edged();
    settings.fog = {.from = 5, .to = 15, .color = 0x000000ff};
    const l3d_space_curve line(l3d_nurbs_curve::polyline({{-1.0, 0.02, 0.0}, {1.0, 0.02, 0.0}}),
                               red, 4);
    const std::size_t middle = (size.height / 2) * std::size_t{size.width} + size.width / 2;
    drawing foggy(l3d_patch_scene(), before, settings);
    foggy.curves().push_back(line);
    EXPECT_EQ(foggy.words()[middle], 0x007f0080U); // half of the way: 128 of 255

    settings = hard_edged();
    settings.antialias = true;
    drawing smooth(l3d_patch_scene(), before, settings);
    smooth.curves().push_back(line);
    double light = 0;
    const auto words = smooth.words();
    for (int y = 0; y < size.height; ++y)
        light += (words[static_cast<std::size_t>(y * size.width + size.width / 2)] >> 16) / 255.0;
    EXPECT_NEAR(light, 4, 0.02); // as much as the width says
}

TEST(space_curve, goes_when_it_is_taken_away_and_follows_its_placement) {
    l3d_afd_settings settings = hard_edged();
    drawing pipeline(l3d_patch_model::teapot(), before, settings);
    const auto bare = pipeline.words();
    const l3d_space_curve line(l3d_nurbs_curve::polyline({{-1.0, 1.0, 4.0}, {1.0, 1.0, 4.0}}), red);
    pipeline.curves().push_back(line);
    pipeline.redraw();
    const auto with = pipeline.words();
    EXPECT_NE(with, bare);
    pipeline.curves()[0] = line.placed(l3d_translation<double>(0, 0, -40));
    pipeline.redraw();
    EXPECT_EQ(std::ranges::count(pipeline.words(), red), 0); // behind the teapot
    pipeline.curves()[0] = line.placed(l3d_translation<double>(0, 0, 0));
    pipeline.redraw();
    EXPECT_EQ(pipeline.words(), with);
    pipeline.curves().clear();
    pipeline.redraw();
    EXPECT_EQ(pipeline.words(), bare);
    settings.wireframe = true; // lines hide nothing
    drawing wires(l3d_patch_model::teapot(), before, settings);
    wires.curves().push_back(line.placed(l3d_translation<double>(0, 0, -20)));
    EXPECT_GT(std::ranges::count(wires.words(), red), 5);
}

/// Lines of a model are those of its instances, wherever these are.
TEST(space_curve, of_a_model_is_drawn_where_the_model_is) {
    const l3d_space_curve line(l3d_nurbs_curve::polyline({{-1.0, 1.0, 4.0}, {1.0, 1.0, 4.0}}), red,
                               2);
    const l3d_patch_model model = l3d_patch_model::teapot().with_curves({line});
    const l3d_matrix<double> there = l3d_translation<double>(0.5, -1, 0);
    drawing of_model(model, before), of_pipeline(l3d_patch_model::teapot(), before);
    of_model.scene().place(0, there);
    of_pipeline.scene().place(0, there);
    of_pipeline.curves() = {line.placed(there)};
    const auto words = of_model.words();
    EXPECT_GT(std::ranges::count(words, red), 50);
    EXPECT_EQ(words, of_pipeline.words());
    EXPECT_TRUE(model.only(std::vector<std::size_t>{0}).curves().empty());
    EXPECT_EQ(model.without(std::vector<std::size_t>{0}).curves().size(), 1U);
}

TEST(space_curve, refuses_widths_and_placements_that_draw_nothing) {
    const l3d_nurbs_curve circle = l3d_nurbs_curve::circle(1);
    for (const double width : {0.0, -1.0, 1001.0, std::nan("")})
        EXPECT_THROW(l3d_space_curve(circle, red, width), l3d_error) << width;
    l3d_matrix<double> bad = l3d_identity<double>();
    bad(3, 0) = 1;
    EXPECT_THROW(l3d_space_curve(circle).placed(bad), l3d_error);
    bad = l3d_identity<double>();
    bad(0, 1) = std::nan("");
    EXPECT_THROW(l3d_space_curve(circle).placed(bad), l3d_error);
}

} // namespace
