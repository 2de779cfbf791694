// SPDX-License-Identifier: MIT
// An end to every nasty patch.
#include "nasty.h"
#include "scene.h"

#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace dice_tests {
namespace {

template <class T> class dicer_cost : public ::testing::Test {};
TYPED_TEST_SUITE(dicer_cost, number_types, type_names);

/// Checks that vertices are in the rasterizer's range, and forgets them.
class range_sink {
public:
    bool in_range = true;

    void draw(diced pieces, double) {
        for (const l3d_diced_piece& piece : pieces) {
            const l3d_micro_grid& grid = piece.part.grid;
            for (int r = 0; r < grid.rows; ++r)
                for (int c = 0; c < grid.columns; ++c)
                    check(grid.vertex(r, c));
            for (std::size_t i = 0; i < piece.part.triangles.count; ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    check(piece.part.triangles.vertex(i, k));
        }
    }

private:
    void check(const l3d_micro_vertex& v) {
        constexpr std::int32_t most = 1 << 23;
        in_range = in_range && v.x >= -most && v.x <= most && v.y >= -most && v.y <= most &&
                   v.inv_w > 0 && std::isfinite(v.inv_w);
    }
};

TYPED_TEST(dicer_cost, nasty_patches_come_to_an_end) {
    const std::uint64_t seeds = thorough ? 3 : 1;
    std::int64_t most_pieces = 0, most_samples = 0;
    std::size_t worst = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const auto patches = hopeless_patches(seed, oblique, {odd.width, odd.height});
        for (std::size_t i = 0; i < patches.size(); ++i)
            for (const double tolerance : {1.0, 0.05}) {
                const scene s({patches[i]}, oblique, odd);
                range_sink sink;
                const l3d_dice_counts counts = dice<TypeParam>(s, tolerance, sink);
                EXPECT_TRUE(sink.in_range) << "seed " << seed << " patch " << i;
                EXPECT_FALSE(std::isnan(counts.bound_px)) << "seed " << seed << " patch " << i;
                EXPECT_GE(counts.bound_px, 0) << "seed " << seed << " patch " << i;
                // Of all these, only the one with a single control point far out is hopeless.
                if (i != 2) {
                    EXPECT_LE(counts.pieces, 200) << "seed " << seed << " patch " << i;
                }
                if (counts.samples > most_samples) {
                    most_samples = counts.samples;
                    worst = i;
                }
                most_pieces = std::max(most_pieces, counts.pieces);
            }
    }
    EXPECT_LE(most_pieces, 4097);
    EXPECT_LE(most_samples, 12'000'000);
    std::printf("%-6s nasty patches: at most %ld pieces, %ld samples (patch %zu)\n",
                name_of<TypeParam>(), static_cast<long>(most_pieces),
                static_cast<long>(most_samples), worst);
}

} // namespace
} // namespace dice_tests
