// SPDX-License-Identifier: MIT
// Levels and bends in lanes against the slow twin, which solves each quad's own map in each pixel.
#include "raster/surfaces/surface_rasterizer_scalar.h"
#include "raster/surfaces/surface_rasterizer_sw.h"
#include "tool_2d/image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>

namespace {

constexpr l3d_size size{64, 48};

/// A picture of one part, and what was counted.
struct drawn {
    l3d_image picture{size, size.width};
    l3d_surface_counts counts;

    drawn(l3d_surface_rasterizer& rasterizer, const l3d_surface_part& part) {
        const l3d_shading shading{.mode = l3d_shade::levels, .ray = {0, 0, 0}};
        rasterizer.begin(picture.pixels(), nullptr, shading);
        const l3d_surface_part* const parts[] = {&part};
        rasterizer.draw(parts);
        rasterizer.finish();
        counts = rasterizer.counts();
    }
};

struct numbers {
    std::mt19937_64 engine{20261122};

    float between(float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(engine);
    }
    std::int32_t place(float pixels) { return static_cast<std::int32_t>(256 * pixels); }
};

/// A quad of sides up to 12 pixels whose corners are off a parallelogram by up to `off` of that.
l3d_surface_part quad(numbers& random, float off) {
    l3d_surface_part part;
    part.grid.resize(2, 2);
    part.block_rows.first[1] = part.block_columns.first[1] = 1;
    const float ux = random.between(4, 12), uy = random.between(-2, 2);
    const float vx = random.between(-2, 2), vy = random.between(4, 12);
    const float w = random.between(0.5F, 2);
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column) {
            const std::size_t at = part.grid.index(row, column);
            const auto r = static_cast<float>(row), c = static_cast<float>(column);
            part.grid.x[at] = random.place(20 + c * ux + r * vx + 12 * random.between(-off, off));
            part.grid.y[at] = random.place(15 + c * uy + r * vy + 12 * random.between(-off, off));
            part.grid.inv_w[at] = w * random.between(1, 1 + off / 20);
            part.grid.normal[0][at] = random.between(20, 200);
            part.grid.normal[1][at] = random.between(-6, 6);
            part.grid.normal[2][at] = random.between(-6, 6);
        }
    return part;
}

l3d_surface_part triangle(numbers& random) {
    l3d_surface_part part;
    std::array<l3d_micro_vertex, 3> v;
    for (l3d_micro_vertex& corner : v)
        corner = {random.place(random.between(10, 30)),
                  random.place(random.between(10, 30)),
                  1,
                  {random.between(20, 200), random.between(-6, 6), random.between(-6, 6)}};
    v[1].normal[1] = v[2].normal[1] = v[2].normal[2] = 0;
    part.triangles.add(v[0], v[1], v[2]);
    return part;
}

/// The largest difference of levels; both cover the same pixels.
int largest_difference(drawn& a, drawn& b) {
    int most = 0;
    for (int y = 0; y < size.height; ++y)
        for (std::size_t x = 0; x < std::size_t{size.width}; ++x) {
            const std::uint32_t of_a = a.picture.pixels().row(y)[x];
            const std::uint32_t of_b = b.picture.pixels().row(y)[x];
            EXPECT_EQ(of_a == 0, of_b == 0);
            most = std::max(most,
                            std::abs(static_cast<int>(of_a & 255) - static_cast<int>(of_b & 255)));
        }
    return most;
}

TEST(fill_levels, of_quads_are_those_of_the_slow_twin_within_what_is_counted) {
    l3d_workers workers(1);
    l3d_surface_rasterizer_sw fast(workers);
    l3d_surface_rasterizer_scalar slow;
    numbers random;
    std::int64_t tight = 0;
    for (int i = 0; i < 4000; ++i) {
        const l3d_surface_part part = quad(random, i % 2 == 0 ? 0.01F : 0.1F);
        drawn a(fast, part), b(slow, part);
        // The twin leaves out of opposite sides' bends what they differ by: half of that, at most.
        const auto& n = part.grid.normal;
        const float unlike = std::abs(n[1][part.grid.index(0, 0)] - n[1][part.grid.index(1, 0)]) +
                             std::abs(n[2][part.grid.index(0, 0)] - n[2][part.grid.index(0, 1)]);
        if (a.counts.unproven_levels + b.counts.unproven_levels > 0)
            continue;
        ++tight;
        ASSERT_LE(largest_difference(a, b),
                  1 + a.counts.level_error + b.counts.level_error + static_cast<double>(unlike) / 2)
            << i;
    }
    EXPECT_GT(tight, 300);
}

TEST(fill_levels, of_triangles_are_those_of_the_slow_twin) {
    l3d_workers workers(1);
    l3d_surface_rasterizer_sw fast(workers);
    l3d_surface_rasterizer_scalar slow;
    numbers random;
    for (int i = 0; i < 4000; ++i) {
        const l3d_surface_part part = triangle(random);
        drawn a(fast, part), b(slow, part);
        ASSERT_LE(largest_difference(a, b), 1) << i;
    }
}

} // namespace
