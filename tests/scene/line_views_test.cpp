// SPDX-License-Identifier: MIT
// Line drawings in 12 views each, or 50: cylinder, cone and torus against closed forms of all their
// lines and of what hides them.
#include "effort.h"
#include "geom/nurbs_surface.h"
#include "scene/line_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace line_views_tests {
namespace {

using vector = l3d_camera::vector;

constexpr l3d_size size{640, 480};
constexpr double pi = std::numbers::pi;

/// A place of an exact line, and whether the body hides it.
struct exact_place {
    double x = 0, y = 0;
    bool is_hidden = false;
};
struct exact_line : std::vector<exact_place> {
    l3d_line_kind kind = l3d_line_kind::contour;
};

/// A camera, with what closed forms ask of it.
struct sight {
    l3d_camera camera;
    l3d_matrix<double> image = camera.image_matrix(size);

    /// The direction from a place to the eye, of any length.
    vector to_eye(const vector& p) const {
        constexpr double beyond = 40; // all of the bodies
        return camera.is_parallel() ? l3d_normalized(camera.eye - camera.target) * beyond
                                    : camera.eye - p;
    }
    exact_place seen(const vector& p, bool is_hidden) const {
        const auto q = image * l3d_vector<double, 4>(p[0], p[1], p[2], 1.0);
        return {size.width / 2.0 + q[0] / q[3], size.height / 2.0 + q[1] / q[3], is_hidden};
    }
};

constexpr int steps = 800;

/// The angles, one or two, at which a cos t + b sin t = c.
std::vector<double> angles(double a, double b, double c) {
    const double part = c / std::hypot(a, b);
    if (!(std::abs(part) <= 1))
        return {};
    return {std::atan2(b, a) - std::acos(part), std::atan2(b, a) + std::acos(part)};
}

/// A convex body of revolution between two levels, with a straight side. A rim is hidden where both
/// faces turn away.
std::vector<exact_line> straight_lines(const sight& from, double low_radius, double high_radius) {
    const auto at = [&](double y, double t) {
        const double radius = low_radius + (high_radius - low_radius) * (y + 1) / 2;
        return vector{radius * std::cos(t), y, radius * std::sin(t)};
    };
    const double slope = (low_radius - high_radius) / 2;
    const auto out = [&](double t) { return vector{std::cos(t), slope, std::sin(t)}; };
    // The normal is the same along the side, so a contour is straight: n (eye - p) = 0 at its foot.
    const bool flat = from.camera.is_parallel();
    const vector e = flat ? from.to_eye({}) : from.camera.eye;
    const std::vector<double> at_contours =
        angles(e[0], e[2], flat ? -slope * e[1] : low_radius - slope * (e[1] + 1));
    std::vector<exact_line> result;
    for (const double y : {-1.0, 1.0}) {
        if ((y < 0 ? low_radius : high_radius) == 0)
            continue;
        std::vector<double> turns;
        for (int i = 0; i <= steps; ++i)
            turns.push_back(2 * pi * i / steps);
        // Where a rim changes, it has a place on either side.
        for (const double t : at_contours)
            for (const double beside : {-1e-7, 1e-7})
                turns.push_back(t + beside - 2 * pi * std::floor(t / (2 * pi)));
        std::ranges::sort(turns);
        result.emplace_back().kind = l3d_line_kind::crease;
        for (const double t : turns) {
            const vector p = at(y, t), eye = from.to_eye(p);
            result.back().push_back(from.seen(p, y * eye[1] < 0 && l3d_dot(out(t), eye) < 0));
        }
    }
    for (const double t : at_contours) {
        exact_line& line = result.emplace_back();
        for (int i = 0; i <= steps / 8; ++i)
            line.push_back(from.seen(at(-1 + 16.0 * i / steps, t), false));
    }
    return result;
}

/// Whether a torus hides a place of its contour. Along the ray the body is where a polynomial of
/// degree 4 is negative, which has a double zero at the place: a parabola is left.
bool is_behind_torus(const vector& p, const vector& eye, double radius, double tube) {
    // |p + t eye|^2 + radius^2 - tube^2 = a t^2 + b t + c, and 4 radius^2 (x^2 + z^2) likewise.
    const double a = l3d_dot(eye, eye), b = 2 * l3d_dot(p, eye);
    const double c = l3d_dot(p, p) + radius * radius - tube * tube;
    const double four = 4 * radius * radius;
    const double d = four * (eye[0] * eye[0] + eye[2] * eye[2]);
    // t^4, t^3 and t^2; those of t and 1 vanish.
    const double x = a * a, y = 2 * a * b, z = b * b + 2 * a * c - d;
    const double middle = std::clamp(-y / (2 * x), 0.0, 1.0);
    return std::min({z, x + y + z, x * middle * middle + y * middle + z}) < 0;
}

/// The contours of the torus: n (p - eye) = 0 gives two angles around the tube for each angle
/// around the axis, and the other way round. Each way is dense where the other is not.
std::vector<exact_line> torus_lines(const sight& from) {
    constexpr double radius = 1, tube = 0.4;
    const bool flat = from.camera.is_parallel();
    const vector e = flat ? from.to_eye({}) : from.camera.eye;
    std::vector<exact_line> result;
    for (const bool around_axis : {true, false})
        for (const std::size_t side : {0U, 1U}) {
            result.emplace_back();
            for (int i = 0; i <= 2 * steps; ++i) {
                const double angle = pi * i / steps, c = std::cos(angle), s = std::sin(angle);
                const auto others =
                    around_axis
                        ? angles(e[0] * c + e[2] * s - (flat ? 0 : radius), e[1], flat ? 0 : tube)
                        : angles(e[0], e[2], flat ? -e[1] * s / c : radius + (tube - e[1] * s) / c);
                if (others.empty()) {
                    result.emplace_back();
                    continue;
                }
                const double turn = around_axis ? angle : others[side];
                const double phi = around_axis ? others[side] : angle;
                const double out = radius + tube * std::cos(phi);
                const vector p{out * std::cos(turn), tube * std::sin(phi), out * std::sin(turn)};
                result.back().push_back(
                    from.seen(p, is_behind_torus(p, from.to_eye(p), radius, tube)));
            }
        }
    std::erase_if(result, [](const exact_line& line) { return line.size() < 2; });
    return result;
}

double distance_to(double x, double y, double ax, double ay, double bx, double by) {
    const double dx = bx - ax, dy = by - ay, square = dx * dx + dy * dy;
    const double along = (x - ax) * dx + (y - ay) * dy;
    const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
    return std::hypot(x - ax - t * dx, y - ay - t * dy);
}

template <class Line> double distance_to(const Line& line, double x, double y) {
    double result = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const auto &a = line[i], &b = line[i + 1];
        if (std::min(std::abs(a.x - x), std::abs(a.y - y)) <
            result + std::abs(a.x - b.x) + std::abs(a.y - b.y))
            result = std::min(result, distance_to(x, y, a.x, a.y, b.x, b.y));
    }
    return result;
}

/// What was found in all views. Units: pixels.
struct judged {
    double off = 0;     ///< the farthest place of a drawn line from the exact ones
    double missing = 0; ///< the farthest exact place from the drawn lines
    double late = 0;    ///< the farthest exact place, from an exact change, that is drawn otherwise
    double bound = 0;
    int changes = 0;
};

double distance_to(const std::vector<exact_line>& lines, double x, double y) {
    double result = std::numeric_limits<double>::infinity();
    for (const exact_line& line : lines)
        result = std::min(result, distance_to(line, x, y));
    return result;
}

void judge(const std::vector<exact_line>& exact, const l3d_line_drawing& drawing, judged& sum) {
    sum.bound = std::max(sum.bound, drawing.bound);
    for (const l3d_drawn_line& line : drawing.lines) {
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
            const l3d_drawn_place &a = line.points[i], &b = line.points[i + 1];
            for (const double t : {0.0, 0.5})
                sum.off = std::max(
                    sum.off, distance_to(exact, a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t));
        }
    }
    for (const exact_line& line : exact) {
        std::vector<exact_place> changes;
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            if (line[i].is_hidden != line[i + 1].is_hidden)
                changes.push_back(line[i]);
        sum.changes += static_cast<int>(changes.size());
        for (std::size_t i = 0; i < line.size(); i += 3) {
            std::array<double, 2> off{1e9, 1e9};
            for (const l3d_drawn_line& drawn : drawing.lines) {
                if (drawn.kind != line.kind)
                    continue;
                double& to = off[drawn.is_seen ? 0 : 1];
                to = std::min(to, distance_to(drawn.points, line[i].x, line[i].y));
            }
            sum.missing = std::max(sum.missing, std::min(off[0], off[1]));
            if (off[line[i].is_hidden ? 1 : 0] <= drawing.bound)
                continue;
            double late = 1e9;
            for (const exact_place& change : changes)
                late = std::min(late, std::hypot(change.x - line[i].x, change.y - line[i].y));
            sum.late = std::max(sum.late, late);
        }
    }
}

void expect_all_in_place(const std::string& name,
                         const std::function<std::vector<exact_line>(const sight&)>& exact) {
    const l3d_patch_scene scene(l3d_patch_model::from_surfaces(*l3d_exact_shape(name)));
    std::mt19937 random(54);
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(random);
    };
    judged all;
    const int views = thorough ? 50 : 12;
    for (int i = 0; i < views; ++i) {
        const double turn = number(0, 2 * pi), rise = std::asin(number(-1, 1));
        const double far = number(3, 12);
        l3d_camera camera{.eye = {far * std::cos(rise) * std::cos(turn), far * std::sin(rise),
                                  far * std::cos(rise) * std::sin(turn)},
                          .target = {0.0, 0.0, 0.0}};
        if (i % 2 == 1)
            camera.projection = l3d_projection::parallel;
        camera = l3d_framed(camera, size, l3d_reach_of(scene));
        judge(exact({camera}), l3d_draw_lines(scene, camera, size), all);
    }
    EXPECT_LE(all.off, all.bound);
    EXPECT_LE(all.missing, all.bound);
    EXPECT_LE(all.late, 0.75); // the shortest stretch, as others take after their neighbours
    EXPECT_GT(all.changes, views);
    testing::Test::RecordProperty("late_px", std::to_string(all.late));
}

TEST(line_views, cylinder_has_all_its_lines) {
    expect_all_in_place("cylinder", [](const sight& s) { return straight_lines(s, 1, 1); });
}

TEST(line_views, cone_has_all_its_lines) {
    expect_all_in_place("cone", [](const sight& s) { return straight_lines(s, 1, 0); });
}

TEST(line_views, torus_has_all_its_lines) {
    expect_all_in_place("torus", torus_lines);
}

} // namespace
} // namespace line_views_tests
