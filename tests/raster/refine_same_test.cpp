// SPDX-License-Identifier: MIT
// Anti-aliasing: the same bits however the work is divided, and no seams.
#include "raster/parallel/simd_target.h"
#include "surface_scene.h"

#include <gtest/gtest.h>

#include <utility>

namespace {

constexpr std::array modes{l3d_shade::lambert, l3d_shade::flat, l3d_shade::normals,
                           l3d_shade::levels};

l3d_shading antialiased(l3d_shade mode) {
    l3d_shading shading = scene_shading(mode);
    shading.antialias = true;
    return shading;
}

/// The grid's sides as the part's border.
void add_border(l3d_surface_part& part) {
    const l3d_micro_grid& grid = part.grid;
    const auto add = [&](std::pair<int, int> from, std::pair<int, int> to, int row, int column,
                         int side) {
        const l3d_micro_vertex a = grid.vertex(from.first, from.second),
                               b = grid.vertex(to.first, to.second);
        part.border.push_back(
            {a.x, a.y, b.x, b.y, a.inv_w, b.inv_w, a.normal[0], row, column, side});
    };
    const int rows = grid.rows - 1, columns = grid.columns - 1;
    for (int c = 0; c < columns; ++c) {
        add({0, c}, {0, c + 1}, 0, c, 0);
        add({rows, c + 1}, {rows, c}, rows - 1, c, 2);
    }
    for (int r = 0; r < rows; ++r) {
        add({r, columns}, {r + 1, columns}, r, columns - 1, 1);
        add({r + 1, 0}, {r, 0}, r, 0, 3);
    }
}

/// Every second sheet tells its border.
surface_parts scene_of(unsigned n, l3d_size size, int sheets) {
    surface_parts scene = random_scene(scene_seed + n, size, sheets);
    for (std::size_t i = 0; i < scene.size(); i += 2)
        if (scene[i].grid.rows > 1 && scene[i].grid.columns > 1)
            add_border(scene[i]);
    return scene;
}

void draw(surface_picture& picture, const surface_parts& scene, l3d_shade mode) {
    picture.rasterizer.begin(picture.pixels(), nullptr, antialiased(mode));
    picture.rasterizer.draw(pointers(scene));
    picture.rasterizer.finish();
}

TEST(RefineSame, WhateverTheThreadsAndBands) {
    for (const l3d_shade mode : modes)
        for (unsigned n = 0; n < 4; ++n) {
            const surface_parts scene = scene_of(n, scene_size, 20);
            surface_picture one(scene_size.width, scene_size.height, 1);
            draw(one, scene, mode);
            ASSERT_GT(one.rasterizer.counts().refined, 1000);
            EXPECT_TRUE(one.guards_intact());
            for (const int threads : {2, 3, 8}) {
                surface_picture other(scene_size.width, scene_size.height, threads);
                draw(other, scene, mode);
                EXPECT_EQ(one.words, other.words) << threads << " threads, seed " << n;
            }
            for (const int rows : {8, 24, 136}) {
                surface_picture other(scene_size.width, scene_size.height, 2, {rows});
                draw(other, scene, mode);
                EXPECT_EQ(one.words, other.words) << rows << " rows, seed " << n;
            }
        }
}

/// Its bright outlines, on either side of where bands end, reach into the dark pixels beside them.
TEST(RefineSame, WhereverBandsEndBesideSteepLight) {
    for (int n = 0; n < 20; ++n) {
        const surface_parts scene{tube(0.02 * n, 1.5 + 0.05 * n, 1.5)};
        surface_picture one(64, 48, 1, {48});
        draw(one, scene, l3d_shade::levels);
        surface_picture other(64, 48, 1, {8});
        draw(other, scene, l3d_shade::levels);
        EXPECT_EQ(one.words, other.words) << n;
    }
}

TEST(RefineSame, WhateverTheInstructions) {
    for (const l3d_shade mode : modes)
        for (unsigned n = 0; n < 4; ++n) {
            const surface_parts scene = scene_of(n, scene_size, 20);
            surface_picture best(scene_size.width, scene_size.height, 2);
            draw(best, scene, mode);
            for (const std::string& name : l3d_simd_targets()) {
                ASSERT_TRUE(l3d_set_simd_target(name));
                surface_picture other(scene_size.width, scene_size.height, 2);
                draw(other, scene, mode);
                EXPECT_EQ(best.words, other.words) << name << ", seed " << n;
            }
            l3d_set_simd_target("");
        }
}

TEST(RefineSame, PartsAreTheBitsOfTheWhole) {
    random_polygons random(scene_seed, scene_size);
    for (const l3d_shade mode : modes)
        for (unsigned n = 0; n < 4; ++n) {
            const surface_parts scene = scene_of(n, scene_size, 12);
            surface_picture whole(scene_size.width, scene_size.height, 2);
            draw(whole, scene, mode);
            for (int k = 0; k < 12; ++k) {
                const int left = random.number(0, scene_size.width - 1);
                const int top = random.number(0, scene_size.height - 1);
                const l3d_pixel_box box{left, top, random.number(left + 1, scene_size.width),
                                        random.number(top + 1, scene_size.height)};
                surface_picture part(scene_size.width, scene_size.height, 2);
                part.rasterizer.begin_part(part.pixels(), nullptr, antialiased(mode), box);
                part.rasterizer.draw(pointers(scene));
                part.rasterizer.finish();
                for (int y = 0; y < scene_size.height; ++y)
                    for (int x = 0; x < scene_size.width; ++x) {
                        const bool inside =
                            x >= box.left && x < box.right && y >= box.top && y < box.bottom;
                        ASSERT_EQ(part.word(x, y),
                                  inside ? whole.word(x, y) : surface_picture::noise)
                            << x << ", " << y << ", seed " << n;
                    }
            }
        }
}

TEST(RefineSame, TilingsHaveNoSeams) {
    constexpr l3d_size size{24, 20};
    random_polygons random(scene_seed, size);
    surface_picture picture(size.width, size.height, 1);
    for (unsigned n = 0; n < 10000; ++n) {
        // A convex quad, and a point in it: as it is, in four triangles, and as a grid of 2 x 2.
        const auto corner = [&](int x, int y) {
            return l3d_micro_vertex{256 * x + random.number(-600, 600),
                                    256 * y + random.number(-600, 600),
                                    0.5f,
                                    {0, 0, 1}};
        };
        const std::array v{corner(4, 4), corner(20, 4), corner(20, 16), corner(4, 16)};
        const l3d_micro_vertex middle = corner(12, 10);
        surface_parts parts(1);
        if (n % 2 == 0) {
            for (std::size_t i = 0; i < 4; ++i)
                parts[0].triangles.add(v[i], v[(i + 1) % 4], middle);
        } else {
            for (std::size_t i = 0; i < 4; ++i)
                parts.push_back(part_of(reference::corners{v[i], v[(i + 1) % 4], middle}));
        }
        draw(picture, parts, l3d_shade::flat);
        // No pixel that lies inside of the quad shows anything but its level.
        const std::uint32_t level = picture.word(12, 10);
        const auto inside = [&](int x, int y) {
            for (std::size_t i = 0; i < 4; ++i) {
                const auto &a = v[i], &b = v[(i + 1) % 4];
                for (const int dx : {0, 256})
                    for (const int dy : {0, 256}) {
                        const std::int64_t px = 256 * x + dx - a.x, py = 256 * y + dy - a.y;
                        if (std::int64_t{b.x - a.x} * py - std::int64_t{b.y - a.y} * px < 0)
                            return false;
                    }
            }
            return true;
        };
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                if (inside(x, y)) {
                    ASSERT_EQ(picture.word(x, y), level) << n << ": " << x << ", " << y;
                }
    }
}

} // namespace
