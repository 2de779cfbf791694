// SPDX-License-Identifier: MIT
// surface_scene: sheets, triangles, and how frames of them are drawn and compared.
#include "surface_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

/// A sheet of waves, which folds over itself here and there.
l3d_micro_grid waves(random_polygons& random, l3d_size size) {
    l3d_micro_grid grid;
    grid.resize(random.number(2, 40), random.number(2, 40));
    const float x0 = random.real(-0.4f, 1.1f) * float(size.width), x1 = random.real(20, 140);
    const float y0 = random.real(-0.4f, 1.1f) * float(size.height), y1 = random.real(20, 140);
    const float turn = random.real(-3, 3), wave = random.real(0, 9), phase = random.real(0, 6);
    const float inv_w = random.real(0.2f, 1.0f);
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const float u = float(column) / float(grid.columns - 1) - 0.5f;
            const float v = float(row) / float(grid.rows - 1) - 0.5f;
            const float bend = std::sin(phase + 5 * u + 3 * v);
            const float x = u * x1 + wave * bend, y = v * y1 + wave * std::cos(phase + 4 * v);
            l3d_micro_vertex vertex;
            vertex.x = int(256 * (x0 + x * std::cos(turn) - y * std::sin(turn)));
            vertex.y = int(256 * (y0 + x * std::sin(turn) + y * std::cos(turn)));
            vertex.inv_w = inv_w * (1 + 0.05f * bend + 0.1f * u - 0.08f * v);
            const float slope = 0.4f * bend, length = std::sqrt(1 + slope * slope + v * v);
            vertex.normal[0] = slope / length;
            vertex.normal[1] = v / length;
            vertex.normal[2] = 1 / length;
            surface_picture::set(grid, row, column, vertex);
        }
    return grid;
}

/// Cuts into up to four blocks of some size, or none.
l3d_block_starts cuts(random_polygons& random, int quads) {
    l3d_block_starts starts;
    starts.blocks = random.number(1, l3d_block_starts::most_blocks);
    for (int i = 1; i < starts.blocks; ++i)
        starts.first[std::size_t(i)] = quads * i / starts.blocks;
    starts.first[std::size_t(starts.blocks)] = quads;
    return starts;
}

} // namespace

std::vector<const l3d_surface_part*> pointers(const surface_parts& all) {
    std::vector<const l3d_surface_part*> result;
    for (const l3d_surface_part& part : all)
        result.push_back(&part);
    return result;
}

surface_parts random_scene(unsigned seed, l3d_size size, int sheets) {
    random_polygons random(seed, size);
    surface_parts all;
    for (int i = 0; i < sheets; ++i) {
        l3d_surface_part& part = all.emplace_back();
        part.error_color = 0x00010203u * static_cast<std::uint32_t>(i + 1);
        if (i % 7 != 3) {
            part.grid = waves(random, size);
            part.block_rows = cuts(random, part.grid.rows - 1);
            part.block_columns = cuts(random, part.grid.columns - 1);
        }
        for (int k = random.number(0, 40); k > 0; --k) {
            const int x = random.number(-3000, 256 * size.width + 3000);
            const int y = random.number(-3000, 256 * size.height + 3000);
            std::array<l3d_micro_vertex, 3> v;
            for (l3d_micro_vertex& corner : v)
                corner = {x + random.number(-2500, 2500),
                          y + random.number(-2500, 2500),
                          random.real(0.2f, 1.1f),
                          {0.6f, 0, 0.8f}};
            part.triangles.add(v[0], v[1], v[2]);
        }
    }
    return all;
}

l3d_surface_part tube(double direction, double radius, double light) {
    constexpr int columns = 51, rows = 12;
    constexpr double half_turn = 3.14159265358979, length = 90, level = 229.5;
    const double along_x = std::cos(direction), along_y = std::sin(direction);
    l3d_micro_grid grid;
    grid.resize(columns, rows + 1);
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column < columns; ++column) {
            // Round by more than a half, so that the borders lie behind.
            const double angle = 0.6 * half_turn * (2.0 * column / (columns - 1) - 1);
            const double aside = radius * std::sin(angle), along = length * (row - rows / 2) / rows;
            const auto place = [](double pixels) {
                return static_cast<std::int32_t>(std::lround(256 * pixels));
            };
            surface_picture::set(grid, row, column,
                                 {place(32 + along * along_x - aside * along_y),
                                  place(24 + along * along_y + aside * along_x),
                                  static_cast<float>(1 / (100 - radius * std::cos(angle))),
                                  {static_cast<float>(level * std::cos(angle - light)), 0, 0}});
        }
    return part_of(grid);
}

l3d_shading scene_shading(l3d_shade mode) {
    return {mode, scene_light, {-0.4f, 0.3f, -1}, {0.004f, 0, 0}, {0, -0.004f, 0}};
}

void draw_frame(surface_picture& picture, const surface_parts& scene, l3d_shade mode) {
    picture.begin(scene_shading(mode));
    picture.rasterizer.draw(pointers(scene));
    picture.rasterizer.finish();
}

void expect_same(surface_picture& a, surface_picture& b) {
    EXPECT_EQ(a.words, b.words);
    for (int y = 0; y < a.size.height; ++y)
        for (int x = 0; x < a.size.width; ++x)
            ASSERT_EQ(a.inv_w(x, y), b.inv_w(x, y)) << x << ", " << y;
}
