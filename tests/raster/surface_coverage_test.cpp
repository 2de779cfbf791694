// SPDX-License-Identifier: MIT
// Which pixels the surface rasterizer covers: against its slow twin, and without gaps over meshes.
#include "surface_fixture.h"

#include <gtest/gtest.h>

#include <string>

namespace {

constexpr unsigned seed = 20060701;

std::string described(const reference::corners& v) {
    std::string text;
    for (const l3d_micro_vertex& c : v)
        text += "(" + std::to_string(c.x) + ", " + std::to_string(c.y) + ") ";
    return text;
}

/// The rasterizer and its mode; the product's lanes are for mode `lambert` alone.
struct drawer {
    const char* name;
    bool product;
    l3d_shade mode;
};

class surface_coverage : public testing::TestWithParam<drawer> {
protected:
    surface_picture make(int width, int height) const {
        return GetParam().product ? surface_picture(width, height, 1)
                                  : surface_picture(width, height);
    }
    static bool shows_hit(std::uint32_t word) { // the darkest grey is 26
        return GetParam().mode == l3d_shade::error ? word == 0x123456 : word >= 0x1a1a1a;
    }
};

INSTANTIATE_TEST_SUITE_P(By, surface_coverage,
                         testing::Values(drawer{"scalar", false, l3d_shade::error},
                                         drawer{"bands", true, l3d_shade::error},
                                         drawer{"lanes", true, l3d_shade::lambert}),
                         [](const auto& drawer) { return std::string(drawer.param.name); });

TEST_P(surface_coverage, IsTheTwinsForRandomPolygons) {
    RecordProperty("seed", static_cast<int>(seed));
    surface_picture picture = make(23, 17);
    random_polygons random(seed, picture.size);
    std::int64_t covered = 0, folded = 0;
    for (int n = 0; n < 100000; ++n) {
        const reference::corners v = with_unit_normals(random.next());
        const std::vector<reference::corners> pieces = reference::pieces(v);
        folded += pieces.size() == 4;
        picture.begin(GetParam().mode);
        picture.draw(v, 0x123456);

        std::int64_t samples = 0;
        for (int y = 0; y < picture.size.height; ++y)
            for (int x = 0; x < picture.size.width; ++x) {
                int hits = 0;
                for (const reference::corners& piece : pieces)
                    hits += reference::covers(piece, x, y);
                samples += hits;
                covered += hits > 0;
                const std::uint32_t word = picture.word(x, y);
                ASSERT_TRUE(hits > 0 ? shows_hit(word) && picture.inv_w(x, y) > 0
                                     : word == 0 && picture.inv_w(x, y) == 0)
                    << "seed " << seed << ", polygon " << n << ": " << described(v) << "at " << x
                    << ", " << y;
            }
        ASSERT_EQ(picture.rasterizer.counts().samples, samples) << described(v);
        ASSERT_EQ(picture.rasterizer.counts().quads, 1);
        ASSERT_EQ(picture.rasterizer.counts().covered, l3d_covered(picture.depth));
    }
    EXPECT_TRUE(picture.guards_intact());
    EXPECT_GT(covered, 1000000); // the polygons did meet the picture
    EXPECT_GT(folded, 10000);
}

/// A grid over the picture and beyond; inner points moved by up to `jitter`, edges of the grid
/// kept.
l3d_micro_grid jittered(random_polygons& random, l3d_size size, int cell, int jitter, int snap) {
    l3d_micro_grid grid;
    grid.resize(256 * size.width / cell + 3, 256 * size.height / cell + 3);
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const bool inner =
                row > 0 && column > 0 && row + 1 < grid.rows && column + 1 < grid.columns;
            const int reach = inner ? jitter : 0;
            l3d_micro_vertex v;
            v.x = ((column - 1) * cell + 77 + random.number(-reach, reach)) / snap * snap;
            v.y = ((row - 1) * cell + 41 + random.number(-reach, reach)) / snap * snap;
            v.inv_w = random.real(0.1f, 1.0f);
            surface_picture::set(grid, row, column, v);
        }
    return grid;
}

TEST_P(surface_coverage, OfAMeshWithoutFoldsIsEachPixelOnce) {
    surface_picture picture = make(61, 43);
    random_polygons random(seed + 1, picture.size);
    for (int n = 0; n < 300; ++n) {
        const int cell = random.number(150, 3000);
        const int snap = n % 2 ? 1 : 16; // 16: many edges through pixel centres
        picture.begin(GetParam().mode);
        picture.draw(jittered(random, picture.size, cell, cell / 4 - snap, snap));
        const l3d_surface_counts& counts = picture.rasterizer.counts();
        ASSERT_EQ(counts.samples, picture.size.width * picture.size.height)
            << "seed " << seed + 1 << ", mesh " << n;
        ASSERT_EQ(counts.written, counts.samples) << "seed " << seed + 1 << ", mesh " << n;
    }
}

TEST_P(surface_coverage, OfAFoldedMeshHasNoHole) {
    surface_picture picture = make(61, 43);
    random_polygons random(seed + 2, picture.size);
    for (int n = 0; n < 300; ++n) {
        const int cell = random.number(150, 3000);
        picture.begin(GetParam().mode);
        picture.draw(jittered(random, picture.size, cell, 2 * cell, n % 2 ? 1 : 128));
        for (int y = 0; y < picture.size.height; ++y)
            for (int x = 0; x < picture.size.width; ++x)
                ASSERT_GT(picture.inv_w(x, y), 0.0f)
                    << "seed " << seed + 2 << ", mesh " << n << " at " << x << ", " << y;
    }
}

TEST_P(surface_coverage, OfAGridWithoutCellsIsNothing) {
    surface_picture picture = make(19, 5);
    picture.begin(GetParam().mode);
    l3d_micro_grid grid;
    picture.draw(grid);
    grid.resize(7, 1);
    picture.draw(grid);
    EXPECT_EQ(picture.rasterizer.counts().quads, 0);
    EXPECT_EQ(picture.rasterizer.counts().samples, 0);
}

} // namespace
