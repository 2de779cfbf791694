// SPDX-License-Identifier: MIT
// Thousands of random scenes, made to break things: no pixel is farther off than its bound.
#include "hard_edged.h"
#include "../scene/bodies.h"
#include "certified_picture.h"

#include "raster/parallel/workers.h"
#include "reference/random_numbers.h"
#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

using dice_tests::scene;
using pipeline_tests::certified;
using pipeline_tests::certified_sum;
using reference::random_numbers;

constexpr l3d_size size{20, 16};
constexpr reference::picture_size picture_size{size.width, size.height};

enum class scene_kind {
    moderate,
    thin,
    folded,
    coincident,
    stiff,
    crossing, ///< sheets through each other
    tiny,     ///< bodies of a few pixels, whose patches are smaller than one
    tiling,
    body
};
constexpr std::array names{"moderate", "thin", "folded", "coincident", "stiff",
                           "crossing", "tiny", "tiling", "body"};

reference::camera any_camera(random_numbers& random, double distance) {
    reference::camera eye;
    eye.eye = {distance * random.between(-1, 1), distance * random.between(-1, 1),
               distance * random.between(0.5, 1)};
    eye.up = {random.between(-0.3, 0.3), 1, random.between(-0.3, 0.3)};
    eye.fov_degrees = random.of_any_size(5, 100);
    return eye;
}

/// A sheet that covers the window, bent at random. `farther` is the logarithm of a distance.
reference::patch sheet(random_numbers& random, const reference::camera& eye, double bend,
                       double slope) {
    const reference::camera_frame frame(eye, picture_size);
    const double across = slope * random.between(-1, 1), down = slope * random.between(-1, 1);
    reference::patch result;
    for (std::size_t k = 0; k < result.points.size(); ++k) {
        const double u = static_cast<double>(k % 4) - 1.5, v = static_cast<double>(k / 4) - 1.5;
        const double farther = across * u + down * v + bend * random.between(-1, 1);
        result.points[k] = frame.unproject(
            size.width * (0.5 + 0.4 * u + random.between(-0.1, 0.1)),
            size.height * (0.5 + 0.4 * v + random.between(-0.1, 0.1)), 5 * std::exp(farther));
    }
    return result;
}

/// Bodies that are a tenth of a pixel to six pixels wide.
scene tiny_scene(random_numbers& random) {
    const auto body = static_cast<dice_tests::body_kind>(random.below(4));
    reference::camera eye = any_camera(random, 10);
    const double distance = std::hypot(eye.eye.x, eye.eye.y, eye.eye.z);
    const double width = random.of_any_size(0.1, 6); // of a radius of 1
    eye.fov_degrees = 45;
    const double now = size.height / (2 * std::tan(3.14159265 / 8) * distance);
    const double scale = now / width;
    eye.eye = {eye.eye.x * scale, eye.eye.y * scale, eye.eye.z * scale};
    eye.near = 0.01 * distance * scale;
    eye.target = {random.between(-0.3, 0.3), random.between(-0.3, 0.3), 0};
    return {dice_tests::random_body(random, body), eye, size};
}

scene random_scene(random_numbers& random, scene_kind kind) {
    if (kind == scene_kind::tiny)
        return tiny_scene(random);
    const reference::camera eye = any_camera(random, 6);
    const std::uint64_t seed = random.next();
    if (kind == scene_kind::body)
        return {
            dice_tests::random_body(random, static_cast<dice_tests::body_kind>(random.below(4))),
            eye, size};
    if (kind == scene_kind::tiling)
        return {reference::random_tiling(seed, 1 + static_cast<int>(random.below(4)),
                                         random.of_any_size(0.1, 2), random.between(0, 1), eye,
                                         picture_size),
                eye, size};
    if (kind == scene_kind::crossing) {
        const double bend = random.of_any_size(0.001, 0.3), slope = random.of_any_size(0.001, 0.5);
        return {{sheet(random, eye, bend, slope), sheet(random, eye, bend, slope)}, eye, size};
    }
    return {reference::random_patches(seed, static_cast<reference::patch_kind>(kind),
                                      1 + static_cast<int>(random.below(4)), eye, picture_size),
            eye, size};
}

/// A scene with a light, a background and a tolerance at random. The exact picture has a camera of
/// its own.
certified_sum judged(random_numbers& random, const scene& s, const reference::camera& eye) {
    const reference::vec3 light{random.between(-1, 1), random.between(-1, 1),
                                random.between(0.1, 1)};
    const int ground = static_cast<int>(random.below(4)) * 85;
    l3d_afd_settings settings = hard_edged();
    settings.antialias = true;
    settings.tolerance = random.of_any_size(0.02, 1);
    settings.light = {light.x, light.y, light.z};
    settings.background = l3d_background::color(static_cast<std::uint32_t>(ground) * 0x010101U);
    const reference::box_image exact(s.patches, eye, s.picture(), light,
                                     {.background = static_cast<double>(ground)});
    certified_sum result;
    result.add(certified(s, settings), exact);
    return result;
}

certified_sum judged(random_numbers& random, const scene& s) {
    return judged(random, s, s.eye);
}

/// Scene number n of a kind: the same on every machine, and by itself. The exact renderer gives up
/// where a ray touches a surface along a curve; that is not for or against the picture.
certified_sum judged(int n) {
    const std::size_t kind = static_cast<std::size_t>(n) % names.size();
    random_numbers random(static_cast<std::uint64_t>(n));
    const scene s = random_scene(random, static_cast<scene_kind>(kind));
    certified_sum result;
    try {
        result = judged(random, s);
    } catch (const std::runtime_error& error) {
        result.unjudged = 1;
        result.where = error.what();
    }
    if (result.exceptions + result.unjudged > 0)
        result.where = "scene " + std::to_string(n) + ", " + names[kind] + ' ' + result.where;
    return result;
}

void expect_within_bounds(int first, int scenes) {
    // Scenes do not depend on each other, and the exact pictures take most of the time.
    l3d_workers workers(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
    std::vector<certified_sum> each(static_cast<std::size_t>(scenes));
    workers.for_each(scenes,
                     [&](int n, int) { each[static_cast<std::size_t>(n)] = judged(first + n); });
    certified_sum all;
    std::array<certified_sum, names.size()> of_kind;
    for (std::size_t n = 0; n < each.size(); ++n) {
        of_kind[(static_cast<std::size_t>(first) + n) % names.size()].add(each[n]);
        all.add(each[n]);
    }
    for (std::size_t k = 0; k < names.size(); ++k)
        of_kind[k].print(names[k]);
    all.print(std::to_string(scenes) + " scenes");
    EXPECT_EQ(all.exceptions, 0) << all.where;
    EXPECT_LE(all.unjudged, scenes / 500) << all.where;
    EXPECT_GT(all.edges, all.pixels / 20);
    EXPECT_LT(all.vacuous, all.shown / 4);
}

TEST(certified_scenes, random_ones_are_within_their_bounds) {
    expect_within_bounds(0, thorough ? 72 : 18);
}

/// Normals vanish along such folds, and whatever is drawn there, the map must doubt it.
TEST(certified_scenes, that_fold_in_their_own_plane_are_within_their_bounds) {
    certified_sum all;
    for (std::uint64_t seed = 0; seed < (thorough ? 10 : 2); ++seed) {
        random_numbers random(seed);
        const reference::camera eye = any_camera(random, 6);
        const double fold = random.between(0.4, 1.5);
        all.add(
            judged(random, {reference::random_tiling(random.next(), 3, fold, 0, eye, picture_size),
                            eye, size}));
    }
    all.print("folds in a plane");
    EXPECT_EQ(all.exceptions, 0) << all.where;
}

/// A camera that sees nearly the same as a parallel one: a millionth of a scene's depth moves a
/// place by some 10^-5 of a pixel here.
reference::camera far_twin(reference::camera eye) {
    constexpr double times = 1e6, half = 3.14159265358979324 / 360;
    const auto away = [](double from, double to) { return to + times * (from - to); };
    const double arm =
        std::hypot(eye.eye.x - eye.target.x, eye.eye.y - eye.target.y, eye.eye.z - eye.target.z);
    eye.eye = {away(eye.eye.x, eye.target.x), away(eye.eye.y, eye.target.y),
               away(eye.eye.z, eye.target.z)};
    eye.fov_degrees = std::atan(std::tan(eye.fov_degrees * half) / times) / half;
    eye.near = times * arm / 2;
    eye.parallel = false;
    return eye;
}

TEST(certified_scenes, in_parallel_projection_are_within_their_bounds) {
    certified_sum all;
    for (std::uint64_t seed = 0; seed < (thorough ? 20 : 4); ++seed) {
        random_numbers random(seed);
        reference::camera eye = any_camera(random, 6);
        eye.parallel = true;
        const auto patches = [&]() -> std::vector<reference::patch> {
            if (seed % 2 == 0)
                return dice_tests::random_body(random,
                                               static_cast<dice_tests::body_kind>(random.below(4)));
            const double bend = random.of_any_size(0.001, 0.3);
            return {sheet(random, eye, bend, 0.2), sheet(random, eye, bend, 0.2)};
        }();
        SCOPED_TRACE(seed);
        all.add(judged(random, {patches, eye, size}, far_twin(eye)));
    }
    all.print("parallel projections");
    EXPECT_EQ(all.exceptions, 0) << all.where;
    EXPECT_GT(all.edges, all.pixels / 50);
}

/// Half an hour on one core.
TEST(certified_scenes, DISABLED_ten_thousand_random_ones_are_within_their_bounds) {
    for (int first = 1'000; first < 11'000; first += 500)
        expect_within_bounds(first, 500);
}

} // namespace
