// SPDX-License-Identifier: MIT
// Curved models against spheres, cylinders, cones and tori in closed form: no code of the library.
// Closed surfaces without a closed form have no hole.
#include "effort.h"
#include "hard_edged.h"
#include "words_of.h"

#include "geom/nurbs_surface.h"
#include "pipeline/pipeline_afd.h"
#include "raster/rasterizer_factory.h"
#include "scene/levels/level_choice.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using real = long double;
using place = std::array<real, 3>;

place operator+(const place& a, const place& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
place operator*(const place& a, real s) {
    return {a[0] * s, a[1] * s, a[2] * s};
}
real dot(const place& a, const place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
place place_of(const l3d_vector<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// The signed distance of a place from a shape, in its half plane (r, y).
real half_plane_distance(const std::string& shape, real r, real y) {
    if (shape == "sphere")
        return std::hypot(r, y) - 1;
    if (shape == "torus")
        return std::hypot(r - 1, y) - 0.4L;
    if (shape == "cylinder") {
        const real beside = r - 1, above = std::abs(y) - 1;
        return beside > 0 && above > 0 ? std::hypot(beside, above) : std::max(beside, above);
    }
    // A cone: its base y = -1, and the side from (1, -1) to the tip (0, 1).
    const auto from_segment = [&](real ax, real ay, real bx, real by) {
        const real dx = bx - ax, dy = by - ay;
        const real t =
            std::clamp(((r - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), real{0}, real{1});
        return std::hypot(r - ax - t * dx, y - ay - t * dy);
    };
    const real apart = std::min(from_segment(0, -1, 1, -1), from_segment(1, -1, 0, 1));
    return y > -1 && 2 * r + y < 1 ? -apart : apart;
}

real distance_of(const std::string& shape, const place& p) {
    return half_plane_distance(shape, std::hypot(p[0], p[2]), p[1]);
}

place normal_of(const std::string& shape, const place& p) {
    constexpr real h = 1e-6L;
    place n{};
    for (std::size_t k = 0; k < 3; ++k) {
        place more = p, less = p;
        more[k] += h;
        less[k] -= h;
        n[k] = distance_of(shape, more) - distance_of(shape, less);
    }
    return n * (1 / std::sqrt(dot(n, n)));
}

/// The first t > 0 where a t^2 + 2 b t + c = 0 and `is_on` holds; negative if there is none.
template <class IsOn> real first_root(real a, real b, real c, const IsOn& is_on) {
    const real q = -b - std::copysign(std::sqrt(b * b - a * c), b);
    real first = -1;
    for (const real t : {q / a, c / q})
        if (t > 0 && is_on(t) && (first < 0 || t < first))
            first = t;
    return first;
}

/// The distance is a step that no ray can meet the shape in.
real hit_by_steps(const std::string& shape, const place& from, const place& ray) {
    const real length = std::sqrt(dot(ray, ray));
    real t = 0;
    for (int step = 0; step < 4000; ++step) {
        const real d = distance_of(shape, from + ray * t);
        if (d < 1e-16L)
            return t;
        t += d / length;
        if (t * length > 1e3L)
            return -1;
    }
    return -1; // along the surface: beside an outline
}

/// Where a ray first meets a shape, as a factor of its direction; negative if it does not.
real first_hit(const std::string& shape, const place& from, const place& ray) {
    if (shape == "torus")
        return hit_by_steps(shape, from, ray);
    if (shape == "sphere")
        return first_root(dot(ray, ray), dot(from, ray), dot(from, from) - 1,
                          [](real) { return true; });
    const place flat_from{from[0], 0, from[2]}, flat_ray{ray[0], 0, ray[2]};
    const auto is_beside = [&](real t) { return std::abs(from[1] + t * ray[1]) <= 1; };
    const auto is_in_disc = [&](real t) {
        const place at = flat_from + flat_ray * t;
        return dot(at, at) <= 1;
    };
    const real rr = dot(flat_ray, flat_ray), fr = dot(flat_from, flat_ray);
    const real ff = dot(flat_from, flat_from), below_tip = 1 - from[1];
    const bool is_cone = shape == "cone"; // 2 r = 1 - y
    const real side = is_cone ? first_root(4 * rr - ray[1] * ray[1], 4 * fr + below_tip * ray[1],
                                           4 * ff - below_tip * below_tip, is_beside)
                              : first_root(rr, fr, ff - 1, is_beside);
    real first = side;
    for (const real y : {real{-1}, real{1}}) {
        const real t = (y - from[1]) / ray[1];
        if (t > 0 && (y < 0 || !is_cone) && is_in_disc(t) && (first < 0 || t < first))
            first = t;
    }
    return first;
}

struct view {
    l3d_camera camera;
    l3d_size size{96, 72};
    place right{}, down{}, ahead{}, eye{};
    real focal = 1;

    explicit view(const l3d_camera& of) : camera(of) {
        const auto axes = of.axes();
        right = place_of(axes.right);
        down = place_of(axes.up) * -1;
        ahead = place_of(axes.forward);
        eye = place_of(of.eye);
        focal = of.focal_length(size);
    }
    place ray(real x, real y) const {
        return ahead + right * ((x - size.width / 2.0L) / focal) +
               down * ((y - size.height / 2.0L) / focal);
    }
};

/// Cameras at all sides. Half of them come near, half of them have a long lens.
l3d_camera random_camera(const std::string& shape, double zoom, bool is_near,
                         std::mt19937& random) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> any(-1, 1);
    l3d_vector<double, 3> away{normal(random), normal(random), normal(random)};
    away = l3d_normalized(away);
    l3d_camera camera;
    // A place of the surface from large zooms on, for there is nothing else to see.
    l3d_vector<double, 3> target{0.0, 0.0, 0.0};
    if (zoom > 1) {
        const real t = first_hit(shape, place_of(away * 4.0), place_of(away * -1.0));
        if (t > 0)
            target = away * static_cast<double>(4 - t);
    }
    camera.target = target;
    camera.up = std::abs(away[1]) < 0.9 ? l3d_vector<double, 3>{0.0, 1.0, 0.0}
                                        : l3d_vector<double, 3>{1.0, 0.0, 0.0};
    const double distance = is_near || zoom < 1 ? 4 / zoom : 4;
    camera.eye =
        target +
        (away + l3d_vector<double, 3>{any(random), any(random), any(random)} * 0.3) * distance;
    camera.near_z = distance / 100;
    if (!is_near && zoom > 1)
        camera.fov = camera.fov / zoom;
    return camera;
}

struct sums {
    std::int64_t judged = 0, drawn = 0, covered = 0, mapped = 0, holes = 0, far = 0, shades = 0,
                 unproven = 0, unbounded = 0;
    real worst_depth = 0, worst_shade = 0, worst_map = 0; ///< of their bounds
    std::vector<real> maps;                               ///< bounds of the map of doubt
};

/// What is seen around a place of the picture, at eight places of a circle.
struct surroundings {
    bool is_inside = true; ///< all of them show the shape, or none does
    real turn = 0;         ///< the most that their normals differ from the middle's

    surroundings(const std::string& shape, const view& v, real x, real y, real radius, real hit,
                 const place& n) {
        for (int k = 0; k < 8; ++k) {
            const real angle = k * std::numbers::pi_v<real> / 4;
            const place ray = v.ray(x + radius * std::cos(angle), y + radius * std::sin(angle));
            const real other = first_hit(shape, v.eye, ray);
            is_inside = is_inside && (other > 0) == (hit > 0);
            if (hit <= 0 || other <= 0)
                continue;
            const place d = normal_of(shape, v.eye + ray * other) + n * -1;
            turn = std::max(turn, std::sqrt(dot(d, d)));
        }
    }
    bool is_smooth() const { return is_inside && turn < 0.2L; }
};

void judge(const std::string& shape, const view& v, l3d_pipeline_afd& pipeline, sums& sum) {
    const l3d_frame_report report = pipeline.report();
    const real bound = report.dice.bound_px, depth_bound = report.dice.depth_bound_px;
    if (!std::isfinite(report.dice.bound_px)) {
        ++sum.unbounded; // the eye is so near that a coarse piece crosses the near plane
        return;
    }
    const auto words = words_of(pipeline.screen().pixels());
    const place light = place_of(l3d_normalized(pipeline.settings().light));
    for (int y = 0; y < v.size.height; ++y)
        for (int x = 0; x < v.size.width; ++x) {
            const place ray = v.ray(x + 0.5L, y + 0.5L);
            const real hit = first_hit(shape, v.eye, ray);
            // What is within the bound of an outline or of a crease is not judged: there, the rays
            // around it meet nothing, or a plane that is another one.
            const place n = hit > 0 ? normal_of(shape, v.eye + ray * hit) : place{};
            const surroundings near(shape, v, x + 0.5L, y + 0.5L, bound + 0.05L, hit, n);
            const real slope = hit > 0 ? -dot(n, ray) / std::sqrt(dot(ray, ray)) : 1;
            if (!near.is_smooth() || slope <= 0.05L)
                continue;
            ++sum.judged;
            const real inv_w =
                static_cast<real>(pipeline.depth().row(y)[static_cast<std::size_t>(x)]);
            if (hit > 0 && hit < static_cast<real>(v.camera.near_z))
                continue;
            sum.holes += (inv_w > 0) != (hit > 0);
            if (!(inv_w > 0) || !(hit > 0))
                continue;
            ++sum.drawn;
            // Of the place, what is across the surface; the surface bends within the bound.
            const real off =
                std::abs(distance_of(shape, v.eye + ray * (1 / inv_w))) * v.focal / hit;
            const real bent = near.turn * (bound + depth_bound) / slope;
            const real allowed = depth_bound + bent;
            sum.worst_depth = std::max(sum.worst_depth, off / allowed);
            sum.far += off > allowed;
            const real level = 25.5L + 229.5L * std::max(real{0}, dot(n, light));
            const real drawn = words[static_cast<std::size_t>(y * v.size.width + x)] & 0xff;
            const real shade_off = std::abs(drawn - level);
            // The frame's bound of shade leaves out quads whose normals are not proven, wherever
            // they are. The map of doubt has a bound of each pixel, for the mean of its square.
            if (report.dice.unproven_quads == 0) {
                ++sum.covered;
                const real most = report.dice.shade_bound + 229.5L * near.turn;
                sum.worst_shade = std::max(sum.worst_shade, shade_off / most);
                sum.shades += shade_off > most;
            }
            const surroundings square(shape, v, x + 0.5L, y + 0.5L, std::numbers::sqrt2_v<real> / 2,
                                      hit, n);
            if (square.is_smooth()) {
                ++sum.mapped;
                sum.maps.push_back(pipeline.error_map()->at(x, y));
                const real most = sum.maps.back() + 229.5L * square.turn;
                sum.worst_map = std::max(sum.worst_map, shade_off / most);
                sum.shades += shade_off > most;
            }
        }
    sum.unproven += report.dice.unproven_quads;
}

class exact_shapes : public testing::TestWithParam<const char*> {
protected:
    static void draw(int views);
};

void exact_shapes::draw(int views) {
    const std::string shape = GetParam();
    std::mt19937 random(52);
    const l3d_patch_model model = l3d_patch_model::from_surfaces(*l3d_exact_shape(shape));
    EXPECT_EQ(model.orientation(), shape == "torus" ? 0 : 1);
    sums sum;
    for (int i = 0; i < views; ++i) {
        const double zoom = std::pow(10, -3 + 9.0 * i / (views - 1));
        const view v(random_camera(shape, zoom, i % 2 == 0, random));
        ASSERT_EQ(v.camera.complaint(), "");
        for (const double tolerance : {0.25, 0.05}) {
            l3d_afd_settings settings = hard_edged();
            settings.tolerance = tolerance;
            settings.depth = settings.error_map = true;
            settings.threads = 1;
            l3d_pipeline_afd pipeline(l3d_memory_canvas(v.size), model, v.camera, settings);
            pipeline.draw_event();
            const sums before = sum;
            judge(shape, v, pipeline, sum);
            if (sum.holes > before.holes || sum.far > before.far || sum.shades > before.shades)
                std::printf("%s, zoom %g, %s, tolerance %g: %ld holes, %ld far, %ld shades, "
                            "%ld unproven; bounds %g %g %g\n",
                            shape.c_str(), zoom, i % 2 == 0 ? "near" : "lens", tolerance,
                            static_cast<long>(sum.holes - before.holes),
                            static_cast<long>(sum.far - before.far),
                            static_cast<long>(sum.shades - before.shades),
                            static_cast<long>(sum.unproven - before.unproven),
                            pipeline.report().dice.bound_px, pipeline.report().dice.depth_bound_px,
                            pipeline.report().dice.shade_bound);
        }
    }
    std::ranges::nth_element(sum.maps, sum.maps.begin() + std::ssize(sum.maps) / 2);
    std::printf("%s: %ld pixels judged, %ld drawn; depth at most %.2Lf of what is allowed; shade "
                "judged by its bound in %ld, at most %.2Lf, and by the map of doubt in %ld, at "
                "most %.2Lf; that has a median of %.2Lf levels; %ld quads unproven; %ld frames "
                "without a bound\n",
                shape.c_str(), static_cast<long>(sum.judged), static_cast<long>(sum.drawn),
                sum.worst_depth, static_cast<long>(sum.covered), sum.worst_shade,
                static_cast<long>(sum.mapped), sum.worst_map, sum.maps[sum.maps.size() / 2],
                static_cast<long>(sum.unproven), static_cast<long>(sum.unbounded));
    EXPECT_GT(sum.drawn, 100 * views);
    EXPECT_GT(10 * sum.mapped, 9 * sum.drawn);
    // One of five views is a millionth of the radius away: its two frames may have no bound.
    EXPECT_LE(5 * sum.unbounded, 2 * views);
    EXPECT_EQ(sum.holes, 0);
    EXPECT_EQ(sum.far, 0);
    EXPECT_EQ(sum.shades, 0);
}

/// Knots that close: periodic, or clamped with creases, whose knots are there as often as the
/// degree says. Control points are `different` ones in turn.
struct closed_direction {
    l3d_bspline_direction knots;
    std::size_t different;
};

closed_direction random_closed(std::mt19937& random) {
    const int degree = 1 + static_cast<int>(random() % 5);
    const auto n = static_cast<std::size_t>(degree);
    const std::size_t spans = 4;
    if (random() % 2 == 0)
        return {l3d_bspline_direction::periodic(degree, spans + n), spans};
    l3d_bspline_direction d{degree, {0}, 0, static_cast<double>(spans)};
    for (std::size_t i = 0; i <= spans; ++i)
        d.knots.insert(d.knots.end(), n, static_cast<double>(i));
    d.knots.push_back(d.to);
    return {d, spans * n};
}

/// A ring of a tube that is neither round nor straight.
l3d_nurbs_surface random_ring(std::mt19937& random) {
    std::uniform_real_distribution<double> any(-1, 1);
    const closed_direction u = random_closed(random), v = random_closed(random);
    std::vector<l3d_vector<double, 3>> points(u.different * v.different);
    std::vector<double> weights;
    for (std::size_t i = 0; i < points.size(); ++i) {
        constexpr double turn = 2 * std::numbers::pi;
        const double a = turn * static_cast<double>(i % u.different) / double(u.different);
        const double b = turn * static_cast<double>(i / u.different) / double(v.different);
        const double tube = 1 + 0.2 * any(random), r = 4 + tube * std::cos(b);
        points[i] = {r * std::cos(a), tube * std::sin(b), r * std::sin(a)};
        weights.push_back(std::exp(0.5 * any(random)));
    }
    std::vector<l3d_vector<double, 3>> all;
    std::vector<double> all_weights;
    for (std::size_t row = 0; row < v.knots.points(); ++row)
        for (std::size_t column = 0; column < u.knots.points(); ++column) {
            const std::size_t i = row % v.different * u.different + column % u.different;
            all.push_back(points[i]);
            all_weights.push_back(weights[i]);
        }
    return {u.knots, v.knots, all, all_weights};
}

/// The middle of the tube at a part of the way around the ring.
l3d_vector<double, 3> middle_of(const l3d_nurbs_surface& ring, double part) {
    constexpr int places = 24;
    l3d_vector<double, 3> sum(0.0);
    for (int i = 0; i < places; ++i)
        sum += ring.evaluate(ring.u().from + part * (ring.u().to - ring.u().from),
                             ring.v().from + i * (ring.v().to - ring.v().from) / places);
    return sum / double(places);
}

} // namespace

TEST(curved_seams, of_closed_surfaces_seen_from_inside_leave_no_pixel_uncovered) {
    std::mt19937 random(5203);
    for (int trial = 0; trial < (thorough ? 4 : 1); ++trial) {
        const l3d_nurbs_surface ring = random_ring(random);
        const l3d_patch_model model = l3d_patch_model::from_surfaces(std::array{ring});
        for (const double part : {0.0, 0.3}) {
            l3d_camera camera;
            camera.eye = middle_of(ring, part);
            camera.target = middle_of(ring, part + 0.05);
            camera.fov = 80;
            camera.near_z = 0.05;
            l3d_afd_settings settings = hard_edged();
            settings.depth = true;
            settings.threads = 1;
            settings.tolerance = trial % 2 == 0 ? 0.25 : 4;
            l3d_pipeline_afd pipeline(l3d_memory_canvas({160, 120}), model, camera, settings);
            pipeline.draw_event();
            constexpr float nothing = std::numeric_limits<float>::infinity();
            EXPECT_EQ(std::ranges::count(pipeline.distances(), nothing), 0)
                << trial << ", " << part;
        }
    }
}

TEST(curved_bounds, of_a_frame_are_those_of_its_patches_and_how_far_these_are_off) {
    const l3d_patch_model model = l3d_patch_model::from_surfaces(*l3d_exact_shape("sphere"));
    const view v(l3d_camera{.eye = {1.0, 2.0, 3.0}, .target = {0.0, 0.0, 0.0}});
    l3d_afd_settings settings = hard_edged();
    l3d_pipeline_afd curved(l3d_memory_canvas(v.size), model, v.camera, settings);
    curved.draw_event();
    const l3d_frame_report report = curved.report();
    EXPECT_GT(report.curved_px, 0);
    const auto drawn = curved.scene().instances()[0].model().patches();
    std::string why;
    const auto patches = l3d_patch_model::checked({drawn.begin(), drawn.end()}, "patches", why);
    ASSERT_TRUE(patches) << why;
    settings.tolerance *= 1 - l3d_curved_share;
    l3d_pipeline_afd plain(l3d_memory_canvas(v.size), *patches, v.camera, settings);
    plain.draw_event();
    EXPECT_EQ(report.dice.bound_px, plain.report().dice.bound_px + report.curved_px);
    // Depth is bounded along the sphere's own normals, not along those of the patches.
    EXPECT_NEAR(report.dice.depth_bound_px, plain.report().dice.depth_bound_px + report.curved_px,
                0.001);
    EXPECT_EQ(plain.report().curved_px, 0);
}

TEST(curved_bounds, leave_doubt_at_outlines_alone) {
    const l3d_patch_model model = l3d_patch_model::from_surfaces(*l3d_exact_shape("sphere"));
    const l3d_camera camera{.eye = {1.0, 2.0, 3.0}, .target = {0.0, 0.0, 0.0}};
    const l3d_size size{240, 180};
    l3d_afd_settings settings;
    settings.error_map = true;
    l3d_pipeline_afd pipeline(l3d_memory_canvas(size), model, camera, settings);
    pipeline.draw_event();
    int doubted = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            doubted += pipeline.error_map()->at(x, y) > 1 ? 1 : 0;
    // The sphere's outline is some 300 pixels long; a band of three pixels is 900.
    EXPECT_LE(doubted, 1500);
}

TEST_P(exact_shapes, are_drawn_within_their_bounds_at_any_zoom) {
    draw(5);
}

TEST_P(exact_shapes, DISABLED_are_drawn_within_their_bounds_in_50_views) {
    draw(50);
}

INSTANTIATE_TEST_SUITE_P(shapes, exact_shapes,
                         testing::Values("sphere", "cylinder", "cone", "torus"));
