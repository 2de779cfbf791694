// SPDX-License-Identifier: MIT
// Line drawings: against closed forms of contours, and against picks for what is seen.
#include "scene/line_drawing.h"

#include "base/error.h"
#include "geom/nurbs_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace line_drawing_tests {
namespace {

using vector = l3d_camera::vector;
using places = std::vector<l3d_drawn_place>;

constexpr l3d_size size{640, 480};

l3d_patch_model shape(const std::string& name) {
    return l3d_patch_model::from_surfaces(*l3d_exact_shape(name));
}

struct view {
    vector eye;
    bool is_parallel = false;

    l3d_camera camera(const l3d_patch_scene& scene) const {
        l3d_camera result{.eye = eye, .target = {0.0, 0.0, 0.0}};
        if (eye[0] == 0 && eye[2] == 0)
            result.up = {0.0, 0.0, -1.0};
        if (is_parallel)
            result.projection = l3d_projection::parallel;
        return l3d_framed(result, size, l3d_reach_of(scene));
    }
};

const std::vector<view> views{{{3.0, 2.0, 7.0}},       {{-2.0, 0.5, 4.0}},
                              {{0.4, 5.0, 0.7}},       {{3.0, 2.0, 7.0}, true},
                              {{0.0, 0.0, 5.0}, true}, {{0.0, 5.0, 0.0}, true},
                              {{5.0, 0.0, 0.0}, true}, {{0.0, 0.0, 5.0}}};

/// The ray through a place of a picture.
struct ray {
    vector from, along;

    ray(const l3d_camera& camera, double x, double y) {
        constexpr double one = 1;
        from = camera.is_parallel() ? camera.place_at(x, y, 0, size) : camera.eye;
        along = l3d_normalized(camera.place_at(x, y, one, size) - from);
    }
};

/// The distance of a place from the line where a function of rays is zero, which must be smooth
/// there. Units: pixels.
double distance_from(const std::function<double(const ray&)>& function, const l3d_camera& camera,
                     const l3d_drawn_place& p) {
    const auto at = [&](double x, double y) { return function(ray(camera, x, y)); };
    constexpr double step = 0.01;
    const double by_x = (at(p.x + step, p.y) - at(p.x - step, p.y)) / (2 * step);
    const double by_y = (at(p.x, p.y + step) - at(p.x, p.y - step)) / (2 * step);
    return std::abs(at(p.x, p.y)) / std::hypot(by_x, by_y);
}

/// All vertices, and four places of each chord.
places places_of(const l3d_drawn_line& line) {
    places result;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
        for (int k = 0; k < 4; ++k) {
            const l3d_drawn_place &a = line.points[i], &b = line.points[i + 1];
            const double t = k / 4.0;
            result.push_back(
                {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.depth + (b.depth - a.depth) * t});
        }
    return result;
}

double length_of(const l3d_drawn_line& line) {
    double result = 0;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
        result += std::hypot(line.points[i + 1].x - line.points[i].x,
                             line.points[i + 1].y - line.points[i].y);
    return result;
}

/// Length of all seen lines.
double seen_length(const l3d_line_drawing& drawing) {
    double result = 0;
    for (const l3d_drawn_line& line : drawing.lines)
        result += line.is_seen ? length_of(line) : 0;
    return result;
}

double distance_from(const places& line, double x, double y) {
    double result = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double dx = line[i + 1].x - line[i].x, dy = line[i + 1].y - line[i].y;
        const double square = dx * dx + dy * dy;
        const double along = (x - line[i].x) * dx + (y - line[i].y) * dy;
        const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
        result = std::min(result, std::hypot(x - line[i].x - t * dx, y - line[i].y - t * dy));
    }
    return result;
}

l3d_drawn_place seen(const l3d_camera& camera, const vector& p) {
    const auto q = camera.image_matrix(size) * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
    return {size.width / 2.0 + q[0] / q[3], size.height / 2.0 + q[1] / q[3], camera.depth_of(p)};
}

/// Checks that lines of a kind are where a function of rays is zero.
void expect_zero(const std::string& name, l3d_line_kind kind,
                 const std::function<double(const ray&)>& function) {
    const l3d_patch_scene scene(shape(name));
    for (const view& v : views) {
        const l3d_camera camera = v.camera(scene);
        const l3d_line_drawing drawing = l3d_draw_lines(scene, camera, size);
        EXPECT_LE(drawing.bound, l3d_line_settings().tolerance);
        double most = 0;
        for (const l3d_drawn_line& line : drawing.lines)
            if (line.kind == kind)
                for (const l3d_drawn_place& p : places_of(line))
                    most = std::max(most, distance_from(function, camera, p));
        EXPECT_LE(most, drawing.bound) << name << " from " << v.eye[0] << ' ' << v.eye[1];
    }
}

TEST(line_drawing, contours_of_a_sphere_are_where_rays_touch_it) {
    expect_zero("sphere", l3d_line_kind::contour,
                [](const ray& r) { return l3d_length(l3d_cross(r.from, r.along)) - 1; });
}

TEST(line_drawing, contours_of_a_cylinder_are_where_rays_touch_it) {
    expect_zero("cylinder", l3d_line_kind::contour, [](const ray& r) {
        const double across = std::hypot(r.along[0], r.along[2]);
        return std::abs(r.from[0] * r.along[2] - r.from[2] * r.along[0]) / across - 1;
    });
}

TEST(line_drawing, contours_of_a_cone_are_where_rays_touch_it) {
    // x^2 + z^2 = ((1 - y) / 2)^2 along the ray is a t^2 + 2 b t + c.
    expect_zero("cone", l3d_line_kind::contour, [](const ray& r) {
        const double up = (1 - r.from[1]) / 2, rise = -r.along[1] / 2;
        const double a = r.along[0] * r.along[0] + r.along[2] * r.along[2] - rise * rise;
        const double b = r.from[0] * r.along[0] + r.from[2] * r.along[2] - up * rise;
        const double c = r.from[0] * r.from[0] + r.from[2] * r.from[2] - up * up;
        return b * b - a * c;
    });
}

/// The contour of the torus as dense lines, as far as it is there. n (P - E) = 0 gives two angles
/// around the tube for each angle around the axis, and the other way round. Each way is dense where
/// the other is not.
std::vector<places> contours_of_torus(const l3d_camera& camera) {
    constexpr double radius = 1, tube = 0.4;
    constexpr int steps = 20000;
    const bool flat = camera.is_parallel();
    const vector e = flat ? l3d_normalized(camera.target - camera.eye) : camera.eye;
    std::vector<places> result;
    for (const bool around_axis : {true, false})
        for (const int side : {-1, 1}) {
            result.emplace_back();
            for (int i = 0; i <= steps; ++i) {
                const double angle = 2 * std::numbers::pi * i / steps;
                const double c = std::cos(angle), s = std::sin(angle);
                // a cos(other) + b sin(other) = value
                double a = e[0], b = e[2],
                       value = flat ? -e[1] * s / c : radius + (tube - e[1] * s) / c;
                if (around_axis) {
                    a = flat ? e[0] * c + e[2] * s : radius - e[0] * c - e[2] * s;
                    b = flat ? e[1] : -e[1];
                    value = flat ? 0 : -tube;
                }
                const double cosine = value / std::hypot(a, b);
                if (!(std::abs(cosine) <= 1)) {
                    result.emplace_back();
                    continue;
                }
                const double other = std::atan2(b, a) + side * std::acos(cosine);
                const double turn = around_axis ? angle : other, phi = around_axis ? other : angle;
                const double out = radius + tube * std::cos(phi);
                result.back().push_back(seen(
                    camera, {out * std::cos(turn), tube * std::sin(phi), out * std::sin(turn)}));
            }
        }
    return result;
}

bool is_seen_by_picks(const l3d_patch_scene& scene, const l3d_camera& camera,
                      const l3d_drawn_place& p, double beside, double in_front) {
    for (int i = 0; i < 8; ++i) {
        const double turn = std::numbers::pi / 4 * i + 0.1;
        const auto pick = l3d_pick_at(scene, {camera, size}, p.x + beside * std::cos(turn),
                                      p.y + beside * std::sin(turn));
        if (!pick || pick->depth > p.depth - in_front)
            return true;
    }
    return false;
}

TEST(line_drawing, contours_of_a_torus_are_those_of_its_closed_form) {
    const l3d_patch_scene scene(shape("torus"));
    const std::vector<view> sides{{{3.0, 2.0, 7.0}},
                                  {{0.0, 0.3, 9.0}},
                                  {{0.1, 1.2, 9.0}, true},
                                  {{6.0, 1.9, 1.0}},
                                  {{0.0, 9.0, 0.0}, true}};
    for (const view& v : sides) {
        const l3d_camera camera = v.camera(scene);
        const l3d_line_drawing drawing = l3d_draw_lines(scene, camera, size);
        const std::vector<places> exact = contours_of_torus(camera);
        double most = 0;
        for (const l3d_drawn_line& line : drawing.lines)
            for (std::size_t i = 0; i < line.points.size(); i += 7) {
                double off = std::numeric_limits<double>::infinity();
                for (const places& one : exact)
                    off = std::min(off, distance_from(one, line.points[i].x, line.points[i].y));
                most = std::max(most, off);
            }
        EXPECT_LE(most, drawing.bound) << v.eye[1];
        // Every exact place is in the drawing, and seen ones are in seen lines.
        for (const places& one : exact)
            for (std::size_t i = 0; i < one.size(); i += 97) {
                double any = 1e9, in_seen = 1e9;
                for (const l3d_drawn_line& line : drawing.lines) {
                    const double off = distance_from(line.points, one[i].x, one[i].y);
                    any = std::min(any, off);
                    in_seen = std::min(in_seen, line.is_seen ? off : 1e9);
                }
                EXPECT_LE(any, drawing.bound) << v.eye[1] << ": " << one[i].x << ' ' << one[i].y;
                EXPECT_TRUE(in_seen <= 1 || !is_seen_by_picks(scene, camera, one[i], 0.5, 0.02))
                    << v.eye[1] << ": " << one[i].x << ' ' << one[i].y;
            }
    }
}

/// Compares what is seen with picks beside the lines, away from the ends of stretches.
void expect_as_picks(const l3d_patch_scene& scene, const std::vector<view>& from,
                     double least_share) {
    constexpr double margin = 6; // lines often end where they nearly touch what hides them
    int right = 0, all = 0;
    for (const view& v : from) {
        const l3d_camera camera = v.camera(scene);
        const double thick = l3d_length(scene.most() - scene.least()) / 400;
        for (const l3d_drawn_line& line : l3d_draw_lines(scene, camera, size).lines) {
            const double length = length_of(line);
            double along = 0, next = margin;
            for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
                const l3d_drawn_place &a = line.points[i], &b = line.points[i + 1];
                along += std::hypot(b.x - a.x, b.y - a.y);
                if (along < next || along > length - margin)
                    continue;
                next = along + 5;
                ++all;
                const bool seen_now = is_seen_by_picks(scene, camera, b, 0.25, thick);
                right += seen_now == line.is_seen ? 1 : 0;
            }
        }
    }
    EXPECT_GE(right, least_share * all) << right << " of " << all;
    EXPECT_GT(all, 50);
}

TEST(line_drawing, what_is_seen_agrees_with_picks) {
    for (const char* const name : {"sphere", "cylinder", "cone", "torus"})
        expect_as_picks(shape(name), {views.begin(), views.begin() + 4}, 1);
}

TEST(line_drawing, what_is_seen_of_the_teapot_agrees_with_picks) {
    expect_as_picks(l3d_patch_model::teapot(), {{{3.0, 2.0, 7.0}}, {{-5.0, 1.0, 2.0}, true}},
                    0.985); // the rest lies less than a hundredth of the teapot behind a surface
}

/// The flat patch with these corners.
l3d_patch_model::patch flat(const vector& a, const vector& b, const vector& c, const vector& d) {
    l3d_patch_model::patch result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            const vector low = a + (b - a) * (column / 3.0), high = c + (d - c) * (column / 3.0);
            result.at(row, column) = low + (high - low) * (row / 3.0);
        }
    return result;
}

l3d_patch_model cube() {
    std::vector<l3d_patch_model::patch> faces;
    for (int axis = 0; axis < 3; ++axis)
        for (const double end : {-1.0, 1.0}) {
            const auto corner = [&](double s, double t) {
                vector p;
                p[axis] = end;
                p[(axis + 1) % 3] = s * end;
                p[(axis + 2) % 3] = t;
                return p;
            };
            faces.push_back(flat(corner(-1, -1), corner(1, -1), corner(-1, 1), corner(1, 1)));
        }
    return l3d_patch_model(faces);
}

TEST(line_drawing, a_cube_shows_nine_of_its_twelve_edges) {
    const l3d_patch_scene scene(cube());
    const l3d_camera camera = view{{3.0, 2.0, 7.0}, true}.camera(scene);
    double hidden = 0, all = 0;
    const l3d_line_drawing drawing = l3d_draw_lines(scene, camera, size);
    for (const l3d_drawn_line& line : drawing.lines) {
        EXPECT_EQ(line.kind, l3d_line_kind::crease);
        all += length_of(line);
        hidden += line.is_seen ? 0 : length_of(line);
    }
    double wanted_all = 0, wanted_hidden = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const double s : {-1.0, 1.0})
            for (const double t : {-1.0, 1.0}) {
                vector a, b;
                a[axis] = -1, b[axis] = 1;
                a[(axis + 1) % 3] = b[(axis + 1) % 3] = s;
                a[(axis + 2) % 3] = b[(axis + 2) % 3] = t;
                const l3d_drawn_place p = seen(camera, a), q = seen(camera, b);
                const double length = std::hypot(p.x - q.x, p.y - q.y);
                wanted_all += length;
                wanted_hidden += s < 0 && t < 0 ? length : 0;
            }
    EXPECT_NEAR(all, wanted_all, 0.1);
    EXPECT_NEAR(hidden, wanted_hidden, 0.1);
    const l3d_line_drawing only_seen = l3d_draw_lines(scene, camera, size, {.hidden = false});
    EXPECT_NEAR(seen_length(only_seen), wanted_all - wanted_hidden, 0.1);
    EXPECT_TRUE(std::ranges::all_of(only_seen.lines, &l3d_drawn_line::is_seen));
}

TEST(line_drawing, a_side_that_meets_two_smaller_patches_is_no_border) {
    // A square of 1 beside two that are half as high, all in a plane.
    std::vector<l3d_patch_points> squares;
    for (const auto& [x, y, high] : {std::array{0.0, 0.0, 1.0}, {1.0, 0.0, 0.5}, {1.0, 0.5, 0.5}})
        squares.push_back(
            {1, 1, {{x, y, 0}, {x + 1, y, 0}, {x, y + high, 0}, {x + 1, y + high, 0}}});
    std::string why;
    const l3d_patch_scene scene(*l3d_patch_model::from_patches(squares, "squares", why));
    l3d_camera camera{.eye = {1.0, 0.5, 4.0}, .target = {1.0, 0.5, 0.0}};
    const l3d_line_drawing drawing = l3d_draw_lines(scene, camera, size, {});
    double most = 0, least = size.width;
    for (const l3d_drawn_line& line : drawing.lines) {
        EXPECT_EQ(line.kind, l3d_line_kind::border);
        for (const l3d_drawn_place& p : places_of(line)) {
            most = std::max(most, p.x);
            least = std::min(least, p.x);
            const bool is_at_seam = std::abs(p.x - size.width / 2.0) < 1;
            const double half = 0.5 * camera.focal_length(size) / 4;
            EXPECT_TRUE(!is_at_seam || std::abs(std::abs(p.y - size.height / 2.0) - half) < 1)
                << p.x << ", " << p.y;
        }
    }
    EXPECT_GT(most - least, 2 * 0.9 * camera.focal_length(size) / 4);
}

TEST(line_drawing, lines_join_over_pieces) {
    const l3d_patch_scene ball(shape("sphere"));
    for (const view& v : views) {
        const auto lines = l3d_draw_lines(ball, v.camera(ball), size).lines;
        ASSERT_EQ(lines.size(), 1U) << v.eye[0] << ' ' << v.eye[1];
        EXPECT_TRUE(lines[0].is_seen);
        EXPECT_EQ(lines[0].points.front(), lines[0].points.back());
        EXPECT_GE(lines[0].pieces.size(), 4U);
    }
    // Two contours, and two rims of which the farther halves are hidden, one of them or both.
    const l3d_patch_scene can(shape("cylinder"));
    EXPECT_EQ(l3d_draw_lines(can, views[0].camera(can), size).lines.size(), 6U);
}

TEST(line_drawing, a_line_changes_where_it_passes_through_a_surface) {
    // A strip along z passes through a square at z = 0; it leaves the square to the right.
    const l3d_patch_scene scene(l3d_patch_model(
        {flat({-1.0, -1.0, 0.0}, {1.0, -1.0, 0.0}, {-1.0, 1.0, 0.0}, {1.0, 1.0, 0.0}),
         flat({0.0, 0.0, -1.0}, {0.5, 0.0, -1.0}, {0.0, 0.0, 1.0}, {0.5, 0.0, 1.0})}));
    const l3d_camera camera = view{{1.0, 1.2, 5.0}}.camera(scene);
    const l3d_drawn_place through = seen(camera, {0.0, 0.0, 0.0});
    double nearest = 1e9;
    for (const l3d_drawn_line& line : l3d_draw_lines(scene, camera, size).lines)
        if (!line.is_seen)
            for (const l3d_drawn_place* const end : {&line.points.front(), &line.points.back()})
                nearest = std::min(nearest, std::hypot(end->x - through.x, end->y - through.y));
    EXPECT_LT(nearest, 0.5); // a quarter of a pixel of depth is not yet in front
}

TEST(line_drawing, contours_of_balls_that_pierce_each_other_change_where_they_enter) {
    // The left ball's contour is the circle of places whose direction is across the sight.
    constexpr double apart = 0.5;
    l3d_patch_scene scene;
    scene.add(shape("sphere"), l3d_translation<double>(-apart, 0, 0));
    scene.add(shape("sphere"), l3d_translation<double>(apart, 0, 0));
    for (const view& v : {view{{0.0, 0.0, 8.0}, true}, view{{3.0, 2.0, 7.0}, true}}) {
        const l3d_camera camera = v.camera(scene);
        const l3d_line_drawing drawing = l3d_draw_lines(scene, camera, size);
        const vector eye = l3d_normalized(camera.eye - camera.target);
        const vector across = l3d_normalized(l3d_cross(eye, vector{0.0, 1.0, 0.0}));
        const vector up = l3d_cross(across, eye);
        double late = 0;
        int hidden = 0;
        for (int i = 0; i < 1000; ++i) {
            const double angle = 2 * std::numbers::pi * i / 1000;
            const vector out = across * std::cos(angle) + up * std::sin(angle);
            // From the right ball's middle; the ray towards the eye has b and c of its square.
            const vector from = out - vector{2 * apart, 0.0, 0.0};
            const double b = l3d_dot(from, eye), c = l3d_dot(from, from) - 1;
            const bool is_hidden = c < 0 || (b < 0 && b * b > c);
            hidden += is_hidden ? 1 : 0;
            const l3d_drawn_place p = seen(camera, out - vector{apart, 0.0, 0.0});
            double off = 1e9;
            for (const l3d_drawn_line& line : drawing.lines)
                if (line.is_seen != is_hidden)
                    off = std::min(off, distance_from(line.points, p.x, p.y));
            late = std::max(late, off);
        }
        EXPECT_LE(late, 0.5) << v.eye[0];
        EXPECT_GT(hidden, 200);
        EXPECT_LT(hidden, 500);
    }
}

TEST(line_drawing, trims_are_borders_and_cut_contours) {
    l3d_patch_points piece{
        .degree_u = 1, .degree_v = 1, .points = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}}};
    const auto line = [](double a, double b, double c, double d) {
        return l3d_trim_curve{{{a, b, 1}, {c, d, 1}}};
    };
    piece.trims = {{line(0, 0, 1, 0), line(1, 0, 1, 1), line(1, 1, 0, 1), line(0, 1, 0, 0)},
                   {line(.25, .25, .75, .25), line(.75, .25, .5, .75), line(.5, .75, .25, .25)}};
    std::string why;
    const auto model = l3d_patch_model::from_patches(std::span(&piece, 1), "plate", why);
    ASSERT_TRUE(model) << why;
    const l3d_patch_scene scene(*model);
    const l3d_camera camera = view{{0.5, 0.4, 3.0}}.camera(scene);
    const l3d_line_drawing drawing = l3d_draw_lines(scene, camera, size);
    ASSERT_EQ(drawing.lines.size(), 2U); // both are closed
    double length = 0;
    for (const l3d_drawn_line& one : drawing.lines) {
        EXPECT_EQ(one.kind, l3d_line_kind::border);
        EXPECT_TRUE(one.is_seen);
        EXPECT_EQ(one.points.front(), one.points.back());
        length += length_of(one);
    }
    const auto from_to = [&](vector a, vector b) {
        const l3d_drawn_place p = seen(camera, a), q = seen(camera, b);
        return std::hypot(p.x - q.x, p.y - q.y);
    };
    const vector a{-0.5, -0.5, 0.0}, b{0.5, -0.5, 0.0}, c{0.0, 0.5, 0.0};
    const vector k{-1.0, -1.0, 0.0}, l{1.0, -1.0, 0.0}, m{1.0, 1.0, 0.0}, n{-1.0, 1.0, 0.0};
    EXPECT_NEAR(length,
                from_to(a, b) + from_to(b, c) + from_to(c, a) + from_to(k, l) + from_to(l, m) +
                    from_to(m, n) + from_to(n, k),
                0.05);
}

TEST(line_drawing, lengths_change_smoothly_while_the_teapot_turns) {
    const l3d_patch_scene scene(l3d_patch_model::teapot());
    l3d_camera camera = view{{3.0, 2.0, 7.0}}.camera(scene);
    double before = seen_length(l3d_draw_lines(scene, camera, size));
    for (int frame = 0; frame < 30; ++frame) {
        camera.orbit(0.5, 0);
        const double now = seen_length(l3d_draw_lines(scene, camera, size));
        EXPECT_LT(std::abs(now - before), 0.03 * before) << frame;
        before = now;
    }
}

TEST(line_drawing, nothing_behind_the_near_plane_is_drawn) {
    const l3d_patch_scene scene(shape("torus"));
    const l3d_camera inside{.eye = {1.0, 0.0, 0.0}, .target = {1.0, 0.0, 5.0}, .near_z = 0.01};
    for (const l3d_drawn_line& line : l3d_draw_lines(scene, inside, size).lines)
        for (const l3d_drawn_place& p : line.points) {
            EXPECT_GT(p.depth, 0.009);
            EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
        }
}

TEST(line_drawing, refuses_a_tolerance_beyond_the_limits) {
    const l3d_patch_scene scene(cube());
    for (const double tolerance : {0.0, 11.0, std::nan("")})
        EXPECT_THROW(l3d_draw_lines(scene, {}, size, {.tolerance = tolerance}), l3d_error);
    EXPECT_THROW(l3d_draw_lines(scene, {.up = {0.0, 0.0, 0.0}}, size, {}), l3d_error);
    EXPECT_TRUE(l3d_draw_lines(l3d_patch_scene(), {}, size).lines.empty());
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t result = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        ++result;
    return result;
}

TEST(line_drawing, an_svg_has_a_path_for_each_line) {
    const l3d_patch_scene scene(shape("cylinder"));
    const l3d_line_drawing drawing = l3d_draw_lines(scene, views[0].camera(scene), size);
    const std::string text = l3d_svg_of(drawing, {.title = "A & <B>"});
    EXPECT_EQ(count(text, "<path "), drawing.lines.size());
    EXPECT_EQ(count(text, "<title>A &amp; &lt;B&gt;</title>"), 1U);
    EXPECT_EQ(count(text, "width=\"640px\" height=\"480px\" viewBox=\"0 0 640 480\""), 1U);
    EXPECT_EQ(count(text, "stroke-dasharray"), 1U);
    const auto hidden = text.find("id=\"hidden\""), shown = text.find("id=\"seen\"");
    ASSERT_LT(hidden, shown); // seen lines are painted last
    EXPECT_EQ(count(text.substr(shown), "<path "), static_cast<std::size_t>(std::ranges::count_if(
                                                       drawing.lines, &l3d_drawn_line::is_seen)));
    EXPECT_EQ(count(l3d_svg_of(drawing), "<title>"), 0U);
}

} // namespace
} // namespace line_drawing_tests
