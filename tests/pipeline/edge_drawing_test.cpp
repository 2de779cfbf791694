// SPDX-License-Identifier: MIT
// Line drawings of solids whose faces meet along edges: each edge is one line.
#include "solids.h"

#include "scene/line_drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr l3d_size size{640, 480};

struct drawn {
    std::map<l3d_line_kind, double> length; ///< in pixels
    double edges = 0;                       ///< length of all edges in the picture
    double bound = 0;
};

drawn lines_of(const solid& of, bool joints) {
    const l3d_patch_scene scene(l3d_patch_model::from_surfaces(of.faces, of.edges));
    const l3d_camera camera =
        l3d_framed({.eye = of.middle + solid::vector{3.0, 2.0, 7.0}, .target = of.middle}, size,
                   l3d_reach_of(scene));
    const l3d_line_drawing drawing = l3d_draw_lines(scene, camera, size, {.joints = joints});
    drawn result;
    result.bound = drawing.bound;
    for (const l3d_drawn_line& line : drawing.lines)
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
            result.length[line.kind] += std::hypot(line.points[i + 1].x - line.points[i].x,
                                                   line.points[i + 1].y - line.points[i].y);
    const auto image = camera.image_matrix(size);
    for (const l3d_model_edge& edge : of.edges) {
        constexpr int steps = 4000;
        double x = 0, y = 0;
        for (int i = 0; i <= steps; ++i) {
            const l3d_bspline_direction& along = edge.curve.along();
            const auto p = edge.curve.evaluate(along.from + (along.to - along.from) * i / steps);
            const auto q = image * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
            if (i > 0)
                result.edges += std::hypot(q[0] / q[3] - x, q[1] / q[3] - y);
            x = q[0] / q[3], y = q[1] / q[3];
        }
    }
    return result;
}

TEST(edge_drawing, draws_each_edge_once) {
    const std::vector<std::pair<std::string, solid>> bodies{{"plate", holed_plate(3)},
                                                            {"flange", flange(6)},
                                                            {"fillet", filleted_cylinders()},
                                                            {"ball", drilled_ball(64, -0.4)},
                                                            {"cap", capped_ball()}};
    for (const auto& [name, body] : bodies) {
        drawn with = lines_of(body, true), without = lines_of(body, false);
        EXPECT_LE(with.bound, 1.5 * l3d_line_settings().tolerance)
            << name; // edges are off the ball
        EXPECT_NEAR(with.length[l3d_line_kind::crease] + with.length[l3d_line_kind::joint],
                    with.edges, 2e-3 * with.edges)
            << name;
        EXPECT_EQ(with.length[l3d_line_kind::border], 0) << name; // bodies are closed
        EXPECT_EQ(without.length[l3d_line_kind::joint], 0) << name;
        EXPECT_EQ(without.length[l3d_line_kind::crease], with.length[l3d_line_kind::crease])
            << name;
        EXPECT_EQ(without.length[l3d_line_kind::contour], with.length[l3d_line_kind::contour])
            << name;
    }
}

TEST(edge_drawing, a_fillet_meets_its_faces_smoothly) {
    // The rims are two circles, and the fillet's ends and all seams are joints.
    drawn all = lines_of(filleted_cylinders(), true);
    EXPECT_GT(all.length[l3d_line_kind::joint], 0.3 * all.edges);
    EXPECT_GT(all.length[l3d_line_kind::crease], 0.3 * all.edges);
}

} // namespace
