// SPDX-License-Identifier: MIT
// A picture with a surface rasterizer in front of it, and random polygons, for the tests.
#ifndef L3D_TESTS_RASTER_SURFACE_FIXTURE_H
#define L3D_TESTS_RASTER_SURFACE_FIXTURE_H

#include "raster/surfaces/surface_rasterizer_scalar.h"
#include "raster/surfaces/surface_rasterizer_sw.h"
#include "reference_fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

/// Three corners as a triangle, four as a grid of one cell.
inline l3d_surface_part part_of(const reference::corners& v, std::uint32_t error_color = 0);

/// A grid as one block.
inline l3d_surface_part part_of(const l3d_micro_grid& grid, std::uint32_t error_color = 0) {
    l3d_surface_part part;
    part.grid = grid;
    part.block_rows.first[1] = grid.rows - 1;
    part.block_columns.first[1] = grid.columns - 1;
    part.error_color = error_color;
    return part;
}

inline void draw_part(l3d_surface_rasterizer& rasterizer, const l3d_surface_part& part) {
    const l3d_surface_part* const parts[] = {&part};
    rasterizer.draw(parts);
}

/// A picture whose stride is larger than its width, with a guard behind every row, and noise where
/// nothing has been drawn.
struct surface_picture {
    static constexpr std::uint32_t guard = 0xdeadbeef, noise = 0x00abcdef;
    static constexpr int gap = 3;

    /// By the slow twin, which is held against what is exact.
    surface_picture(int width, int height)
        : size{width, height}, workers(1), bands(workers), rasterizer(scalar) {
        fill_memory();
    }

    /// By the product, which is held against the slow twin.
    surface_picture(int width, int height, int threads, l3d_band_settings settings = {})
        : size{width, height}, workers(threads), bands(workers, settings), rasterizer(bands) {
        fill_memory();
    }

    /// Looks along -z.
    void begin(l3d_shade mode, std::array<float, 3> light = {0, 0, 1}) {
        begin(l3d_shading{mode, light, {0, 0, -1}, {}, {}});
    }

    void begin(const l3d_shading& shading) { rasterizer.begin(pixels(), &depth, shading); }

    l3d_pixels pixels() { return {words.data(), size.width, size.height, size.width + gap}; }

    std::uint32_t word(int x, int y) { return pixels().row(y)[static_cast<std::size_t>(x)]; }
    float inv_w(int x, int y) { return depth.row(y)[static_cast<std::size_t>(x)]; }

    bool guards_intact() const {
        for (std::size_t i = 0; i < words.size(); ++i)
            if (i % static_cast<std::size_t>(size.width + gap) >=
                    static_cast<std::size_t>(size.width) &&
                words[i] != guard)
                return false;
        return true;
    }

    /// Draws one part, or three corners as a triangle, four as a grid of one cell, and finishes.
    void draw(const l3d_surface_part& part) {
        draw_part(rasterizer, part);
        rasterizer.finish();
    }
    void draw(const reference::corners& v, std::uint32_t error_color = 0) {
        draw(part_of(v, error_color));
    }
    void draw(const l3d_micro_grid& grid) { draw(part_of(grid)); }

    static void set(l3d_micro_grid& grid, int row, int column, const l3d_micro_vertex& v) {
        const std::size_t i = grid.index(row, column);
        grid.x[i] = v.x;
        grid.y[i] = v.y;
        grid.inv_w[i] = v.inv_w;
        for (std::size_t axis = 0; axis < 3; ++axis)
            grid.normal[axis][i] = v.normal[axis];
    }

    l3d_size size;
    std::vector<std::uint32_t> words;
    l3d_depth_buffer depth;
    l3d_workers workers;
    l3d_surface_rasterizer_sw bands;
    l3d_surface_rasterizer_scalar scalar;
    l3d_surface_rasterizer& rasterizer;

private:
    void fill_memory() {
        words.assign(std::size_t(size.width + gap) * std::size_t(size.height), guard);
        depth.resize(size);
        for (int y = 0; y < size.height; ++y) {
            std::ranges::fill(pixels().row(y), noise);
            std::ranges::fill(depth.row(y), 1e30f);
        }
    }
};

l3d_surface_part part_of(const reference::corners& v, std::uint32_t error_color) {
    l3d_surface_part part;
    part.error_color = error_color;
    if (v.size() == 3) {
        part.triangles.add(v[0], v[1], v[2]);
        return part;
    }
    l3d_micro_grid grid;
    grid.resize(2, 2);
    surface_picture::set(grid, 0, 0, v[0]);
    surface_picture::set(grid, 0, 1, v[1]);
    surface_picture::set(grid, 1, 1, v[2]);
    surface_picture::set(grid, 1, 0, v[3]);
    return part_of(grid, error_color);
}

/// What the rasterizers expect of a part's normals.
inline reference::corners with_unit_normals(reference::corners v) {
    for (l3d_micro_vertex& corner : v) {
        float& x = corner.normal[0];
        float &y = corner.normal[1], &z = corner.normal[2];
        const float length = std::sqrt(x * x + y * y + z * z);
        x /= length;
        y /= length;
        z /= length;
    }
    return v;
}

/// Random polygons of every awkward kind, near a picture of a given size.
class random_polygons {
public:
    random_polygons(unsigned seed, l3d_size size) : random_(seed), size_(size) {}

    int number(int least, int greatest) {
        return std::uniform_int_distribution<int>(least, greatest)(random_);
    }
    float real(float least, float greatest) {
        return std::uniform_real_distribution<float>(least, greatest)(random_);
    }

    reference::corners next() {
        reference::corners v(static_cast<std::size_t>(number(3, 4)));
        const int kind = number(0, 5);
        const int x = number(-512, 256 * size_.width + 512);
        const int y = number(-512, 256 * size_.height + 512);
        for (l3d_micro_vertex& corner : v) {
            corner = {x, y, real(0.05f, 2.0f), {real(-1, 1), real(-1, 1), real(-1, 1)}};
            place(corner, kind);
        }
        if (kind == degenerate)
            degrade(v);
        else if (number(0, 2) == 0 && kind != far)
            for (l3d_micro_vertex& corner : v) { // on pixel centres and corners: ties
                corner.x = corner.x / 128 * 128;
                corner.y = corner.y / 128 * 128;
            }
        return v;
    }

private:
    enum { tiny, small, sliver, large, far, degenerate };

    void place(l3d_micro_vertex& v, int kind) {
        const int reach = kind == tiny ? 300 : kind == large ? 60000 : 3000;
        if (kind == far) { // up to the ends of the range
            v.x = number(-(1 << 23), 1 << 23);
            v.y = number(-(1 << 23), 1 << 23);
        } else if (kind == sliver) {
            const int along = number(-8000, 8000);
            v.x += along + number(-2, 2);
            v.y += along * 3 / 7 + number(-40, 40);
        } else {
            v.x += number(-reach, reach);
            v.y += number(-reach, reach);
        }
    }

    /// Coincident or collinear corners.
    void degrade(reference::corners& v) {
        const std::size_t i = static_cast<std::size_t>(number(0, static_cast<int>(v.size()) - 1));
        const std::size_t next = (i + 1) % v.size(), after = (i + 2) % v.size();
        v[next].x = v[i].x;
        v[next].y = v[i].y;
        if (number(0, 1) == 0) {
            v[next].x = (v[i].x + v[after].x) / 2;
            v[next].y = (v[i].y + v[after].y) / 2;
        }
    }

    std::mt19937 random_;
    l3d_size size_;
};

#endif
