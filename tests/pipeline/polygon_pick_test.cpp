// SPDX-License-Identifier: MIT
// Picks of polygons, against rays and planes in long double.
#include "pipeline/polygons/polygon_view.h"

#include "geom/polygon_shapes.h"
#include "pipeline/polygons/polygon_model.h"
#include "reference/random_numbers.h"
#include "scene/teapot_studio.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace {

using reference::random_numbers;
using vector = l3d_camera::vector;
using wide = std::array<long double, 3>;

constexpr l3d_size size{157, 118};

wide operator-(const wide& a, const wide& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
wide cross(const wide& a, const wide& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
long double dot(const wide& a, const wide& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
wide widened(const vector& v) {
    return {v[0], v[1], v[2]};
}
wide unit(const wide& v) {
    const long double length = std::sqrt(dot(v, v));
    return {v[0] / length, v[1] / length, v[2] / length};
}

/// A ray of the exact camera.
struct ray {
    wide from, along;

    ray(const l3d_camera& camera, double x, double y, bool parallel) {
        const wide eye = widened(camera.eye), target = widened(camera.target);
        const wide forward = unit(target - eye);
        const wide right = unit(cross(forward, widened(camera.up))), up = cross(right, forward);
        const long double half = std::tan(static_cast<long double>(camera.fov) / 360 *
                                          3.14159265358979323846264338327950288L);
        const long double pixel = half * 2 / size.height;
        const long double a = (x - size.width / 2.0L) * pixel, b = (size.height / 2.0L - y) * pixel;
        const wide arm = target - eye;
        const long double distance = parallel ? std::sqrt(dot(arm, arm)) : 0;
        from = eye;
        along = forward;
        for (std::size_t i = 0; i < 3; ++i) {
            from[i] += distance * (a * right[i] + b * up[i]);
            along[i] += parallel ? 0 : a * right[i] + b * up[i];
        }
    }
};

/// The nearest triangle by Cramer's rule (Moeller, Trumbore), and the exact point.
struct exact_pick {
    std::size_t triangle = 0;
    long double depth = std::numeric_limits<long double>::infinity();
    long double edge = 1; ///< how near to a side: the least weight of all triangles that are met
    wide point{};
};

std::optional<exact_pick> exact(const l3d_polygon_model& model, const ray& r) {
    exact_pick best;
    long double edge = 1;
    for (std::size_t t = 0; t < model.triangles().size(); ++t) {
        const auto& corners = model.triangles()[t].corners;
        const auto at = [&](std::size_t i) { return widened(model.mesh().vertices[corners[i]]); };
        const wide a = at(1) - at(0), b = at(2) - at(0), p = cross(r.along, b), s = r.from - at(0);
        const long double determinant = dot(a, p);
        if (determinant == 0)
            continue;
        const wide q = cross(s, a);
        const long double u = dot(s, p) / determinant, v = dot(r.along, q) / determinant;
        const long double depth = dot(b, q) / determinant;
        edge = std::min({edge, std::abs(u), std::abs(v), std::abs(1 - u - v)});
        if (u < 0 || v < 0 || u + v > 1 || depth < 0.1L || depth >= best.depth)
            continue;
        best.triangle = t;
        best.depth = depth;
        for (std::size_t i = 0; i < 3; ++i)
            best.point[i] = r.from[i] + depth * r.along[i];
    }
    best.edge = edge;
    return std::isinf(best.depth) ? std::nullopt : std::optional(best);
}

double distance(const vector& a, const wide& b) {
    const wide d = widened(a) - b;
    return static_cast<double>(std::sqrt(dot(d, d)));
}

TEST(polygon_pick, names_the_part_and_passes_by_what_is_hidden) {
    const l3d_polygon_model all(l3d_tessellated(l3d_patch_model::teapot(), 7).mesh);
    const l3d_camera camera{
        .eye = {0.3, 9.0, 0.2}, .target = {0.3, 0.0, 0.2}, .up = {0.0, 0.0, 1.0}};
    const l3d_polygon_view view(camera, size, l3d_identity<double>());
    const double x = size.width / 2.0, y = size.height / 2.0;
    const auto lid = l3d_polygon_pick_at(all, view, false, x, y);
    ASSERT_TRUE(lid);
    EXPECT_EQ(lid->part, "lid");
    EXPECT_NE(lid->text().find("\npart lid\n"), std::string::npos) << lid->text();
    EXPECT_TRUE(lid->line().starts_with("lid, face ")) << lid->line();
    const std::array<std::size_t, 1> hidden{*all.parts().find("lid")};
    const auto none = l3d_polygon_pick_at(all.without(hidden), view, false, x, y);
    EXPECT_FALSE(none && none->part == "lid"); // the teapot has no bottom
}

TEST(polygon_pick, finds_face_and_weights_within_its_errors) {
    const l3d_polygon_model model(l3d_tessellated(l3d_patch_model::teapot(), 7).mesh);
    l3d_camera camera = dice_tests::oblique_camera();
    random_numbers random(5);
    for (const auto projection : {l3d_projection::perspective, l3d_projection::parallel}) {
        camera.projection = projection;
        const l3d_polygon_view view(camera, size, l3d_identity<double>());
        int picks = 0, nothing = 0;
        for (int i = 0; i < 400; ++i) {
            const double x = random.between(0, 157), y = random.between(0, 118);
            const auto pick = l3d_polygon_pick_at(model, view, false, x, y);
            const auto wanted = exact(model, ray(camera, x, y, view.is_parallel()));
            ASSERT_EQ(pick.has_value(), wanted.has_value()) << x << ' ' << y;
            if (!pick) {
                ++nothing;
                continue;
            }
            ++picks;
            EXPECT_LE(distance(pick->point, wanted->point), pick->point_error) << x << ' ' << y;
            EXPECT_LT(pick->point_error, 1e-7) << "of slivers seen from their edge";
            EXPECT_NEAR(pick->weights[0] + pick->weights[1] + pick->weights[2], 1, 1e-14);
            if (wanted->edge < 1e-9L)
                continue;
            const auto& triangle = model.triangles()[wanted->triangle];
            EXPECT_EQ(pick->corners, triangle.corners);
            EXPECT_EQ(pick->face, triangle.face);
            const auto& v = model.mesh().vertices;
            const wide a = widened(v[triangle.corners[0]]), b = widened(v[triangle.corners[1]]),
                       c = widened(v[triangle.corners[2]]), n = unit(cross(b - a, c - a));
            const wide minus{-n[0], -n[1], -n[2]};
            EXPECT_LE(std::min(distance(pick->normal, n), distance(pick->normal, minus)),
                      pick->normal_error);
            const auto area = [&](const wide& p, const wide& q) {
                const wide w = cross(p - wanted->point, q - wanted->point);
                return std::sqrt(dot(w, w));
            };
            const long double all = area(a, b) + area(b, c) + area(c, a);
            EXPECT_LE(std::abs(static_cast<double>(area(b, c) / all) - pick->weights[0]),
                      pick->weights_error + 1e-16);
        }
        EXPECT_GT(picks, 100);
        EXPECT_GT(nothing, 50);
    }
}

TEST(polygon_pick, a_side_that_triangles_share_has_no_gap) {
    const l3d_polygon_model model(l3d_tessellated(l3d_patch_model::teapot(), 7).mesh);
    const l3d_camera camera = dice_tests::oblique_camera();
    const l3d_polygon_view view(camera, size, l3d_identity<double>());
    random_numbers random(9);
    int picks = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto& triangle = model.triangles()[random.below(model.triangles().size())];
        const vector a = model.mesh().vertices[triangle.corners[0]];
        const vector b = model.mesh().vertices[triangle.corners[1]];
        const double t = random.between(0, 1);
        const vector p = a + (b - a) * t;
        const auto h = view.matrix() * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
        const auto pick = l3d_polygon_pick_at(model, view, false, size.width / 2.0 + h[0] / h[3],
                                              size.height / 2.0 + h[1] / h[3]);
        // What has only one triangle at a side, as rims do, may be missed beside it.
        if (!pick)
            continue;
        picks += std::abs(pick->depth - h[2]) < 1e-9;
        EXPECT_LT(pick->depth, h[2] + 1e-9);
    }
    EXPECT_GT(picks, 300);
}

TEST(polygon_pick, backs_are_not_met_unless_all_faces_are_drawn) {
    const l3d_polygon_model ball(l3d_sphere_mesh(40, 20));
    l3d_camera camera{.eye = {0.1, 0.2, 5.0}, .target = {0.0, 0.0, 0.0}};
    const auto depth = [&](bool culls) {
        const l3d_polygon_view view(camera, size, l3d_identity<double>());
        const auto pick = l3d_polygon_pick_at(ball, view, culls, 80, 60);
        return pick ? pick->depth : 0;
    };
    EXPECT_NEAR(depth(true), 4, 0.1);
    camera.near_z = 4.5;
    EXPECT_EQ(depth(true), 0);
    EXPECT_NEAR(depth(false), 6, 0.2);
}

TEST(polygon_pick, text_names_every_value_with_its_error) {
    const l3d_polygon_model model(l3d_tessellated(l3d_patch_model::teapot(), 4).mesh);
    const l3d_polygon_view view(dice_tests::oblique_camera(), size, l3d_identity<double>());
    const auto pick = l3d_polygon_pick_at(model, view, true, 64, 40);
    ASSERT_TRUE(pick);
    const std::string text = pick->text();
    for (const char* const name : {"face ", "\nvertices ", "\nweights ", "\npoint ", "\nnormal "})
        EXPECT_NE(text.find(name), std::string::npos) << name << " in\n" << text;
}

} // namespace
