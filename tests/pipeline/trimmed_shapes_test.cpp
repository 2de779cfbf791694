// SPDX-License-Identifier: MIT
// Trimmed surfaces against shapes in closed form: a plate with holes, and a sphere that a cylinder
// or a plane cuts.
#include "effort.h"
#include "hard_edged.h"
#include "random_views.h"

#include "base/error.h"
#include "geom/nurbs_surface.h"
#include "pipeline/pipeline_afd.h"
#include "pipeline/polygons/polygon_model.h"
#include "pipeline/surface_method.h"
#include "raster/color/srgb_light.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using vector = l3d_vector<double, 3>;

/// A straight loop through these parameters.
l3d_trim_loop polyline(const std::vector<std::array<double, 2>>& points) {
    l3d_trim_loop result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto &a = points[i], &b = points[(i + 1) % points.size()];
        result.push_back({{{a[0], a[1], 1}, {b[0], b[1], 1}}});
    }
    return result;
}

l3d_trim_loop border_of(const l3d_nurbs_surface& s) {
    const auto &u = s.u(), &v = s.v();
    return polyline({{u.from, v.from}, {u.to, v.from}, {u.to, v.to}, {u.from, v.to}});
}

/// What a ray first meets: how far away, and which side of what; 0 is nothing.
struct sight {
    double distance = 0;
    int what = 0;
};

/// A trimmed model, and the same in closed form.
struct shape {
    l3d_patch_model model;
    std::function<sight(const vector& from, const vector& ray)> first;
    /// Whether some part, a hole or what lies between two, is so small that it may be within
    /// `reach` of the place that a ray meets, with none of the rays around meeting it.
    std::function<bool(const vector& at, double reach)> is_fine = [](auto&&...) { return false; };
    vector middle{0.0, 0.0, 0.0};
    double radius = 1;
};

struct round_hole {
    double x, y, radius;
};

/// A plate in the plane z = 0 from (0, 0) to (4, 3), with holes, and an island in one of them.
shape plate(bool is_curved) {
    std::vector<round_hole> holes{{2.0, 1.5, 0.8}, {2.0, 1.5, 0.5}, {0.5, 0.5, 0.25}};
    for (int i = 0; i < 6; ++i)
        holes.push_back({0.4 + 0.62 * i, 2.7, 0.05 + 0.03 * i});
    holes.push_back({4.0, 0.7, 0.4}); // across the border
    std::vector<l3d_nurbs_surface> surfaces;
    // One patch, or 2 x 3 of a degree that is not 3.
    const auto u = l3d_bspline_direction::clamped(is_curved ? 2 : 1, is_curved ? 4 : 2);
    const auto v = l3d_bspline_direction::clamped(is_curved ? 4 : 1, is_curved ? 7 : 2);
    const auto greville = [](const l3d_bspline_direction& d, std::size_t i) {
        double sum = 0;
        for (std::size_t k = 1; k <= static_cast<std::size_t>(d.degree); ++k)
            sum += d.knots[i + k];
        return sum / d.degree;
    };
    std::vector<vector> points;
    for (std::size_t j = 0; j < v.points(); ++j)
        for (std::size_t i = 0; i < u.points(); ++i)
            points.push_back({4 * greville(u, i), 3 * greville(v, j), 0.0});
    const l3d_nurbs_surface whole(u, v, points);
    std::vector<l3d_trim_loop> loops{border_of(whole)};
    for (const round_hole& hole : holes) {
        const l3d_nurbs_curve circle = l3d_nurbs_curve::circle(hole.radius);
        std::vector<vector> moved;
        for (const vector& p : circle.points())
            moved.push_back({(hole.x + p[0]) / 4, (hole.y + p[1]) / 3, 0.0});
        loops.push_back(
            l3d_trim_loop_of(std::array{l3d_nurbs_curve(circle.along(), moved, circle.weights())}));
    }
    surfaces.push_back(whole.trimmed(loops));
    shape result{.model = l3d_patch_model::from_surfaces(surfaces), .first = {}};
    result.first = [holes](const vector& from, const vector& ray) -> sight {
        const double t = -from[2] / ray[2];
        const vector at = from + ray * t;
        const bool is_beside = at[0] < 0 || at[0] > 4 || at[1] < 0 || at[1] > 3;
        bool is_there = true;
        for (const round_hole& hole : holes)
            is_there = is_there != (std::hypot(at[0] - hole.x, at[1] - hole.y) < hole.radius);
        return t > 0 && is_there && !is_beside ? sight{t, 1} : sight{};
    };
    result.is_fine = [holes](const vector& at, double reach) {
        return std::ranges::any_of(holes, [&](const round_hole& hole) {
            return hole.radius < 2 * reach &&
                   std::hypot(at[0] - hole.x, at[1] - hole.y) < 3 * reach;
        });
    };
    result.middle = {2.0, 1.5, 0.0};
    result.radius = 2.5;
    return result;
}

/// A sphere's parameters at a place, found by halving along u and v: both turn one way.
std::array<double, 2> parameters_of(const l3d_nurbs_surface& sphere, const vector& p) {
    const auto angle = [](const vector& q) {
        const double a = std::atan2(q[2], q[0]);
        return a < 0 ? a + 2 * std::numbers::pi : a;
    };
    const auto &du = sphere.u(), &dv = sphere.v();
    const double middle = (dv.from + dv.to) / 2;
    double low = dv.from, high = dv.to;
    const bool rises = sphere.evaluate(du.from, high)[1] > sphere.evaluate(du.from, low)[1];
    for (int i = 0; i < 60; ++i) {
        const double at = (low + high) / 2;
        ((sphere.evaluate(du.from, at)[1] < p[1]) == rises ? low : high) = at;
    }
    const double v = low;
    low = du.from;
    high = du.to;
    const double span = high - low;
    const bool turns = angle(sphere.evaluate(low + span / 4, middle)) <
                       angle(sphere.evaluate(low + span / 2, middle));
    for (int i = 0; i < 60; ++i) {
        const double at = (low + high) / 2;
        ((angle(sphere.evaluate(at, middle)) < angle(p)) == turns ? low : high) = at;
    }
    return {low, v};
}

/// A sphere without what lies in a cylinder, or beyond a plane.
shape cut_sphere(bool by_plane) {
    const l3d_nurbs_surface sphere = l3d_sphere_surfaces().at(0);
    // Far from the poles and from the seam, where z = 0 and x > 0.
    const vector axis = l3d_normalized(vector{-0.8, 0.3, by_plane ? 0.1 : 0.4});
    const vector a = l3d_normalized(l3d_cross(axis, vector{0.0, 1.0, 0.0}));
    const vector b = l3d_cross(axis, a);
    constexpr double radius = 0.35, height = 0.9;
    const vector beside = a * 0.2 + b * 0.1;
    std::vector<l3d_trim_loop> loops{border_of(sphere)};
    for (const double side : {1.0, -1.0}) {
        std::vector<std::array<double, 2>> points;
        constexpr int corners = 4096; // chords are off by 3e-7 of a radius
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * i / corners;
            const vector round = a * std::cos(angle) + b * std::sin(angle);
            const vector across =
                by_plane ? round * std::sqrt(1 - height * height) : beside + round * radius;
            const double along = side * std::sqrt(1 - l3d_dot(across, across));
            points.push_back(parameters_of(sphere, across + axis * along));
        }
        if (side > 0)
            loops.push_back(polyline(points));
    }
    const l3d_nurbs_surface trimmed = sphere.trimmed(loops);
    shape result{.model = l3d_patch_model::from_surfaces(std::span(&trimmed, 1)), .first = {}};
    result.first = [=](const vector& from, const vector& ray) -> sight {
        const double q = l3d_dot(ray, ray), m = l3d_dot(from, ray) / q;
        const double square = m * m - (l3d_dot(from, from) - 1) / q;
        if (!(square > 0))
            return {};
        for (const double sign : {-1.0, 1.0}) {
            const double t = -m + sign * std::sqrt(square);
            const vector at = from + ray * t;
            const double along = l3d_dot(at, axis);
            const vector off = at - axis * along - beside;
            const bool is_cut =
                by_plane ? along > height : along > 0 && l3d_dot(off, off) < radius * radius;
            if (t > 0 && !is_cut)
                return {t, sign < 0 ? 1 : 2};
        }
        return {};
    };
    return result;
}

l3d_camera random_camera(const shape& of, double zoom, std::mt19937& random) {
    return random_view(of.middle, of.radius, zoom, random);
}

struct judged {
    std::int64_t all = 0, drawn = 0, wrong = 0, far = 0;
};

void judge(const shape& of, const camera_rays& rays, const l3d_pipeline_afd& pipeline,
           judged& sum) {
    const l3d_frame_report report = pipeline.report();
    ASSERT_TRUE(std::isfinite(report.dice.bound_px));
    const double reach = report.dice.bound_px + 0.01;
    const std::vector<float> distances = pipeline.distances();
    const double near = rays.camera.near_z;
    const auto first = [&](const vector& ray) {
        sight result = of.first(rays.camera.eye + ray * near, ray);
        result.distance += near;
        return result;
    };
    for (int y = 0; y < rays.size.height; ++y)
        for (int x = 0; x < rays.size.width; ++x) {
            const vector& eye = rays.camera.eye;
            const vector ray = rays.at(x + 0.5, y + 0.5);
            const sight here = first(ray);
            bool is_clear = true;
            double farthest = 0;
            for (int k = 0; k < 16 && is_clear; ++k) {
                const double angle = k * std::numbers::pi / 8;
                const vector beside =
                    rays.at(x + 0.5 + reach * std::cos(angle), y + 0.5 + reach * std::sin(angle));
                const sight other = first(beside);
                is_clear = other.what == here.what;
                const double t = here.what != 0 ? here.distance : -eye[2] / ray[2];
                farthest = std::max(farthest, l3d_length(beside * (-eye[2] / beside[2]) - ray * t));
            }
            if (!is_clear || of.is_fine(eye + ray * (-eye[2] / ray[2]), farthest))
                continue;
            ++sum.all;
            const double drawn =
                static_cast<double>(distances[static_cast<std::size_t>(y * rays.size.width + x)]);
            const bool is_drawn = std::isfinite(drawn);
            sum.wrong += is_drawn != (here.what != 0);
            if (!is_drawn || here.what == 0)
                continue;
            ++sum.drawn;
            const sight behind = of.first(eye + ray * (here.distance * (1 + 1e-9)), ray);
            sum.far += behind.what != 0 && std::abs(drawn - here.distance) >
                                               std::abs(drawn - here.distance - behind.distance);
        }
}

void judge_views(const char* name, const shape& of, int views) {
    std::mt19937 random(54);
    judged sum;
    double most = 0;
    for (int i = 0; i < views; ++i) {
        const double zoom = std::pow(10, -0.5 + 2.0 * i / views);
        l3d_camera camera = random_camera(of, zoom, random);
        if (i % 5 == 0) // the near plane cuts the shape
            camera.near_z = 0.99 * l3d_length(camera.target - camera.eye);
        const camera_rays rays(camera, {96, 72});
        l3d_afd_settings settings = hard_edged();
        settings.tolerance = i % 2 == 0 ? 0.25 : 0.05;
        settings.depth = true;
        settings.threads = 1;
        settings.most_samples = 1 << 20; // patches that reach far past the eye need many
        l3d_pipeline_afd pipeline(l3d_memory_canvas(rays.size), of.model, rays.camera, settings);
        pipeline.draw_event();
        most = std::max(most, pipeline.report().dice.bound_px / settings.tolerance);
        const judged before = sum;
        judge(of, rays, pipeline, sum);
        if (sum.wrong > before.wrong || sum.far > before.far)
            std::printf("%s, view %d, zoom %g: %ld wrong, %ld far, bound %g\n", name, i, zoom,
                        static_cast<long>(sum.wrong - before.wrong),
                        static_cast<long>(sum.far - before.far), pipeline.report().dice.bound_px);
    }
    std::printf("%s: %ld pixels judged, %ld drawn; bounds up to %.2f tolerances\n", name,
                static_cast<long>(sum.all), static_cast<long>(sum.drawn), most);
    EXPECT_GT(sum.drawn, 1000 * views);
    EXPECT_LE(most, 1);
    EXPECT_EQ(sum.wrong, 0);
    EXPECT_EQ(sum.far, 0);
}

const int views = thorough ? 500 : 50;

TEST(trimmed_shapes, a_plate_with_holes_and_an_island) {
    judge_views("plate", plate(false), views);
}

TEST(trimmed_shapes, a_plate_of_several_pieces) {
    judge_views("plate of pieces", plate(true), views);
}

TEST(trimmed_shapes, a_sphere_cut_by_a_cylinder) {
    judge_views("sphere and cylinder", cut_sphere(false), views);
}

TEST(trimmed_shapes, a_sphere_cut_by_a_plane) {
    judge_views("sphere and plane", cut_sphere(true), views);
}

TEST(trimmed_shapes, are_picked_where_they_are) {
    const shape of = plate(true);
    std::mt19937 random(55);
    int picked = 0;
    for (int i = 0; i < 20; ++i) {
        const camera_rays rays(random_camera(of, 1, random), {160, 120});
        for (int k = 0; k < 20; ++k) {
            const double x = 8.0 * k + 0.5, y = 6.0 * k + 0.3;
            const sight there = of.first(rays.camera.eye, rays.at(x, y));
            bool is_clear = true; // the picked patches are a thousandth of the plate off
            for (int j = 0; j < 8; ++j) {
                const double angle = j * std::numbers::pi / 4;
                const vector beside = rays.at(x + 0.5 * std::cos(angle), y + 0.5 * std::sin(angle));
                is_clear = is_clear && of.first(rays.camera.eye, beside).what == there.what;
            }
            if (!is_clear)
                continue;
            ++picked;
            const auto pick =
                l3d_pick_at(of.model, {.camera = rays.camera, .size = rays.size}, x, y);
            ASSERT_EQ(pick.has_value(), there.what != 0) << x << ' ' << y;
            if (pick) {
                EXPECT_NEAR(pick->depth, there.distance, 1e-6 * there.distance);
            }
        }
    }
    EXPECT_GT(picked, 250);
}

TEST(trimmed_shapes, are_refused_by_name_where_whole_ones_would_be_drawn) {
    const shape of = plate(false);
    std::mt19937 random(56);
    l3d_afd_settings settings = hard_edged();
    settings.method = l3d_method_factory(
        "cubes", [](const auto&, l3d_workers&) { return std::unique_ptr<l3d_surface_method>(); });
    try {
        const l3d_pipeline_afd pipeline(l3d_memory_canvas({160, 120}), of.model,
                                        random_camera(of, 1, random), settings);
        ADD_FAILURE();
    } catch (const l3d_error& error) {
        EXPECT_STREQ(error.what(), "trimmed surfaces: cubes draws whole ones alone");
    }
    EXPECT_THROW(l3d_tessellated(of.model, 4), l3d_error);
}

/// The least and the largest level that a pixel's square may have on the mean, by rays in closed
/// form. Squares of a 32nd of the pixel are as bright as their corners, if all corners show one
/// surface. Others may show anything that surfaces do.
std::array<double, 2>
exact_levels(const shape& of, const camera_rays& rays, int x, int y,
             const std::function<double(const sight&, const vector&)>& light) {
    constexpr int parts = 32, corners = parts + 1;
    std::array<sight, std::size_t{corners} * corners> seen;
    std::array<double, seen.size()> lights{};
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const vector ray = rays.at(x + static_cast<double>(i % corners) / parts,
                                   y + static_cast<double>(i / corners) / parts);
        seen[i] = of.first(rays.camera.eye, ray);
        if (seen[i].what != 0)
            lights[i] = light(seen[i], rays.camera.eye + ray * seen[i].distance);
    }
    double least = 0, most = 0;
    for (std::size_t i = 0; i + corners + 1 < seen.size(); ++i) {
        if (i % corners == parts)
            continue;
        const std::array<std::size_t, 4> square{i, i + 1, i + corners, i + corners + 1};
        const bool is_one = std::ranges::all_of(
            square, [&](std::size_t k) { return seen[k].what == seen[i].what; });
        double low = is_one ? 1 : 0, high = is_one ? 0 : 1;
        for (const std::size_t k : square) {
            low = std::min(low, lights[k]);
            high = std::max(high, lights[k]);
        }
        least += low / (parts * parts);
        most += high / (parts * parts);
    }
    return {l3d_level_of_light(least), l3d_level_of_light(most)};
}

/// No pixel is farther off than the map of doubt says, and the map says little away from borders.
void judge_doubts(const char* name, const shape& of, bool is_flat) {
    std::mt19937 random(58);
    int wrong = 0, large = 0, all = 0, shown = 0;
    for (int i = 0; i < (thorough ? 12 : 4); ++i) {
        const camera_rays rays(random_camera(of, i % 2 == 0 ? 0.7 : 3, random), {48, 36});
        const vector lamp = l3d_normalized(rays.camera.eye - rays.camera.target);
        l3d_afd_settings settings = hard_edged();
        settings.antialias = i % 4 >= 2;
        settings.error_map = true;
        settings.light = {lamp[0], lamp[1], lamp[2]};
        l3d_pipeline_afd pipeline(l3d_memory_canvas(rays.size), of.model, rays.camera, settings);
        pipeline.draw_event();
        ASSERT_NE(pipeline.error_map(), nullptr);
        const auto light = [&](const sight& there, const vector& at) {
            const vector out = is_flat ? vector{0.0, 0.0, rays.camera.eye[2] > 0 ? 1.0 : -1.0}
                                       : at * (there.what == 1 ? 1.0 : -1.0);
            return l3d_light_of_level(25.5 + 229.5 * std::max(0.0, l3d_dot(out, lamp)));
        };
        for (int y = 0; y < rays.size.height; ++y)
            for (int x = 0; x < rays.size.width; ++x) {
                const auto [least, most] = exact_levels(of, rays, x, y, light);
                const double drawn = pipeline.screen().pixels().row(y)[x] & 0xff;
                const double bound = double{pipeline.error_map()->at(x, y)};
                if (drawn > most + bound + 0.02 || drawn < least - bound - 0.02)
                    if (++wrong <= 5)
                        std::printf("%s, view %d: (%d, %d): drawn %.0f, exact %.2f to %.2f, "
                                    "bound %.2f\n",
                                    name, i, x, y, drawn, least, most, bound);
                ++all;
                shown += most > 0;
                large += most - least < 1 && bound > 3;
            }
    }
    std::printf("%s: %d pixels, %d of surfaces, %d beside borders with large bounds\n", name, all,
                shown, large);
    EXPECT_EQ(wrong, 0) << name;
    EXPECT_GT(shown, all / 5) << name;
    EXPECT_LT(large, all / 50) << name;
}

TEST(trimmed_shapes, have_a_map_of_doubt_of_a_plate) {
    judge_doubts("plate", plate(true), true);
}

TEST(trimmed_shapes, have_a_map_of_doubt_of_cut_spheres) {
    judge_doubts("sphere and cylinder", cut_sphere(false), false);
    judge_doubts("sphere and plane", cut_sphere(true), false);
}

/// The mean light of a picture whose edges are smooth, against the same with 16 x 16 times the
/// pixels.
TEST(trimmed_shapes, have_smooth_edges) {
    const shape of = plate(true);
    std::mt19937 random(57);
    for (int i = 0; i < 10; ++i) {
        const l3d_camera camera = random_camera(of, 1, random);
        const auto drawn = [&](int times, bool smooth) {
            l3d_afd_settings settings = hard_edged();
            settings.antialias = smooth;
            settings.tolerance = 0.03 * times;
            settings.shade = l3d_shade::flat;
            settings.light = {0.0, 0.0, camera.eye[2] > 0 ? 1.0 : -1.0};
            l3d_pipeline_afd pipeline(l3d_memory_canvas({80 * times, 60 * times}), of.model, camera,
                                      settings);
            pipeline.draw_event();
            const l3d_pixels pixels = pipeline.screen().pixels();
            std::vector<double> light(80 * 60);
            for (int y = 0; y < 60 * times; ++y)
                for (int x = 0; x < 80 * times; ++x)
                    light[static_cast<std::size_t>(y / times * 80 + x / times)] +=
                        l3d_light_of_level(pixels.row(y)[x] & 0xff) / (times * times);
            return light;
        };
        const auto smooth = drawn(1, true), fine = drawn(16, false);
        double brightest = 0, worst = 0;
        for (const double light : fine)
            brightest = std::max(brightest, light);
        for (std::size_t k = 0; k < fine.size(); ++k)
            worst = std::max(worst, std::abs(fine[k] - smooth[k]) / brightest);
        // Two borders in a pixel that are off by 0.03 pixels hide 0.06 of it in each picture. Of
        // upright ones 16 columns count 1/16, and 64 samples less.
        EXPECT_LT(worst, 0.06 + 0.06 + 1.0 / 16) << i;
    }
}

} // namespace
