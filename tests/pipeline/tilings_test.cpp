// SPDX-License-Identifier: MIT
// Patches and faces that tile a plane: anti-aliased pictures show no seam between them. Of tiles
// that are coloured alike, no pixel differs from their colour. Of tiles of two greys, none shows
// anything but a mixture of these.
#include "hard_edged.h"
#include "../dice/scene.h"
#include "words_of.h"

#include "pipeline/pipeline_afd.h"
#include "pipeline/polygons/pipeline_zbuffer.h"
#include "raster/rasterizer_factory.h"
#include "reference/random_numbers.h"
#include "reference/random_patches.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

using reference::random_numbers;
using vector = l3d_vector<double, 3>;

constexpr l3d_size size{40, 32};

/// Control points are off their places by so many cells; those of the border lie up to 1/2 farther
/// out. Below 1/4 no tiling folds: steps along a side are at least 1 - 2/4, and those across it at
/// most 2/4. A tilted plane needs some of that.
constexpr double unfolded = 0.2;

/// A plane in front of a camera: 1 / w is linear in the picture.
struct plane {
    double middle, along_x, along_y;

    explicit plane(random_numbers& random)
        : middle(1 / random.of_any_size(1, 100)), along_x(middle * random.between(-0.4, 0.4)),
          along_y(middle * random.between(-0.4, 0.4)) {}

    reference::vec3 at(const reference::camera_frame& frame, double x, double y) const {
        const double part = along_x * (x / size.width - 0.5) + along_y * (y / size.height - 0.5);
        return frame.unproject(x, y, 1 / (middle + part));
    }
    /// Towards the light, such that all of the plane has this level.
    vector light(const reference::camera_frame& frame, int level) const {
        const auto point = [&](double x, double y) -> vector {
            const reference::vec3 p = at(frame, x, y);
            return {p.x, p.y, p.z};
        };
        const vector origin = point(0, 0), side = point(size.width, 0) - origin;
        const vector cross = l3d_cross<double>(side, point(0, size.height) - origin);
        vector normal = cross * (1 / l3d_length(cross));
        const vector eye{static_cast<double>(frame.eye[0]), static_cast<double>(frame.eye[1]),
                         static_cast<double>(frame.eye[2])};
        if (l3d_dot(normal, eye - origin) < 0)
            normal = normal * -1.0;
        const double cosine = (level - 25.5) / 229.5;
        return normal * cosine + side * (std::sqrt(1 - cosine * cosine) / l3d_length(side));
    }
};

/// One of a thousand cameras.
reference::camera any_camera(random_numbers& random) {
    reference::camera eye;
    eye.eye = {random.between(-5, 5), random.between(-5, 5), random.between(1, 5)};
    eye.up = {random.between(-0.3, 0.3), 1, 0.1};
    eye.fov_degrees = random.of_any_size(5, 90);
    eye.near = 0.01;
    return eye;
}

/// The levels that a tiling's tiles have, and what is behind them.
struct greys {
    int least, most;
    l3d_background ground;

    explicit greys(random_numbers& random, bool are_alike)
        : least(30 + static_cast<int>(random.below(120))),
          most(are_alike ? least : least + 2 + static_cast<int>(random.below(100))),
          ground(l3d_background::color(random.below(2) == 0 ? 0 : 0xffffff)) {}

    l3d_material any(random_numbers& random) const {
        const int level = random.below(2) == 0 ? least : most;
        return {.color = static_cast<std::uint32_t>(level) * 0x010101U};
    }
    /// Where the light comes from, so that white is shown as the darker one if tiles are alike:
    /// then they have no colours of their own.
    vector light(const plane& flat, const reference::camera_frame& frame) const {
        return flat.light(frame, least == most ? least : 255);
    }
    /// How many pixels of a picture show something else.
    int differing(const l3d_pixels& picture) const {
        const auto words = words_of(picture);
        return static_cast<int>(std::ranges::count_if(words, [&](std::uint32_t word) {
            const int level = static_cast<int>(word & 255);
            return level < least || level > most;
        }));
    }
};

/// Patches over the whole window, bent in their plane, so that parameters run unevenly. They do not
/// fold: where they do, normals vanish, and no picture knows the level there.
int differing_in_tiling_of_patches(int n, bool are_alike) {
    random_numbers random(static_cast<std::uint64_t>(n));
    const reference::camera eye = any_camera(random);
    const reference::camera_frame frame(eye, {size.width, size.height});
    const plane flat(random);
    auto patches =
        reference::random_tiling(random.next(), 1 + static_cast<int>(random.below(8)),
                                 random.between(0, unfolded), 0, eye, {size.width, size.height});
    for (reference::patch& each : patches)
        for (reference::vec3& p : each.points) {
            const auto seen = frame.project({p.x, p.y, p.z});
            p = flat.at(frame, static_cast<double>(seen.x / seen.w),
                        static_cast<double>(seen.y / seen.w));
        }
    const greys colors(random, are_alike);
    std::vector<l3d_material> materials;
    for (std::size_t i = 0; i < patches.size(); ++i)
        materials.push_back(are_alike ? l3d_material() : colors.any(random));
    const dice_tests::scene s(patches, eye, size);
    l3d_patch_scene world;
    if (random.below(2) == 0)
        world.add(s.model.painted(materials), s.placement);
    else // models that do not know of each other meet like patches of one
        for (std::size_t i = 0; i < patches.size(); ++i)
            world.add(dice_tests::scene({patches[i]}, eye, size).model.painted(materials[i]),
                      s.placement);
    constexpr std::array shades{l3d_shade::flat, l3d_shade::gouraud, l3d_shade::lambert};
    l3d_afd_settings settings = hard_edged();
    settings.antialias = true;
    settings.background = colors.ground;
    settings.shade = shades[random.below(shades.size())];
    settings.tolerance = random.of_any_size(0.02, 1);
    settings.light = colors.light(flat, frame);
    l3d_pipeline_afd pipeline(l3d_memory_canvas(size), world, s.camera, settings);
    pipeline.draw_event();
    return colors.differing(pipeline.screen().pixels());
}

/// The same faces, each with corners of its own.
l3d_polygon_mesh without_common_corners(const l3d_polygon_mesh& from) {
    l3d_polygon_mesh result;
    for (std::size_t f = 0; f < from.faces(); ++f) {
        for (const std::uint32_t corner : from.face(f)) {
            result.corners.push_back(static_cast<std::uint32_t>(result.vertices.size()));
            result.vertices.push_back(from.vertices[corner]);
        }
        result.end_face();
    }
    return result;
}

/// Triangles, quads and strips over the whole window, some of them slivers.
int differing_in_tiling_of_faces(int n, bool are_alike) {
    random_numbers random(static_cast<std::uint64_t>(n));
    const reference::camera eye = any_camera(random);
    const reference::camera_frame frame(eye, {size.width, size.height});
    const plane flat(random);
    const auto columns = static_cast<std::uint32_t>(1 + random.below(30)),
               rows = static_cast<std::uint32_t>(1 + random.below(30));
    // Cells of the grid do not turn over: corners jitter by less than half a cell.
    const double jitter = random.between(0, 0.49), beyond = 3;
    l3d_polygon_mesh mesh;
    for (std::uint32_t row = 0; row <= rows; ++row)
        for (std::uint32_t column = 0; column <= columns; ++column) {
            const auto at = [&](std::uint32_t i, std::uint32_t of, int pixels) {
                const bool is_border = i == 0 || i == of;
                const double place = i + (is_border ? 0 : random.between(-jitter, jitter));
                return -beyond + (pixels + 2 * beyond) * place / of;
            };
            const double x = at(column, columns, size.width), y = at(row, rows, size.height);
            const reference::vec3 p = flat.at(frame, x, y);
            mesh.vertices.push_back({p.x, p.y, p.z});
        }
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t a = row * (columns + 1) + column, b = a + 1, d = b + columns,
                                c = d + 1;
            if (random.below(2) == 0) {
                mesh.add_face({{a, b, c, d}});
            } else {
                mesh.add_face({{a, b, c}});
                mesh.add_face({{a, c, d}});
            }
        }
    if (random.below(2) == 0)
        mesh = without_common_corners(mesh);
    const greys colors(random, are_alike);
    for (std::size_t i = 0; i < mesh.faces() && !are_alike; ++i)
        mesh.face_colors.push_back(colors.any(random).color);
    l3d_polygon_settings settings = hard_edged_polygons();
    settings.antialias = true;
    settings.cull = false;
    settings.background = colors.ground;
    settings.shade = random.below(2) == 0 ? l3d_shade::flat : l3d_shade::gouraud;
    settings.light = colors.light(flat, frame);
    const dice_tests::scene s({}, eye, size);
    l3d_pipeline_zbuffer pipeline(l3d_memory_canvas(size), l3d_polygon_model(mesh), s.camera,
                                  settings, l3d_rasterizer_factory_sw());
    pipeline.draw_event();
    return colors.differing(pipeline.screen().pixels());
}

/// Draws tilings until there are so many.
template <class Draw> void expect_no_seams(int tilings, Draw draw) {
    for (const bool are_alike : {true, false}) {
        int wrong = 0, pixels = 0;
        for (int n = 0; n < tilings; ++n) {
            const int here = draw(n, are_alike);
            EXPECT_EQ(here, 0) << "tiling " << n << (are_alike ? " of one grey" : " of two greys");
            wrong += here > 0;
            pixels += here;
        }
        std::printf(
            "%d tilings of %s, %d x %d pixels: %d of them show %d pixels of other colours\n",
            tilings, are_alike ? "one grey" : "two greys", size.width, size.height, wrong, pixels);
    }
}

TEST(tilings, of_patches_show_no_seams) {
    expect_no_seams(thorough ? 300 : 50, differing_in_tiling_of_patches);
}

TEST(tilings, of_faces_show_no_seams) {
    expect_no_seams(thorough ? 500 : 50, differing_in_tiling_of_faces);
}

/// A minute.
TEST(tilings, DISABLED_ten_thousand_of_patches_show_no_seams) {
    expect_no_seams(10'000, differing_in_tiling_of_patches);
}

TEST(tilings, DISABLED_ten_thousand_of_faces_show_no_seams) {
    expect_no_seams(10'000, differing_in_tiling_of_faces);
}

} // namespace
