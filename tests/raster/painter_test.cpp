// SPDX-License-Identifier: MIT
// The painter against one that paints over what is there, pixel by pixel.
#include "raster/lines/line_cover_p.h"
#include "raster/parallel/simd_target.h"
#include "raster/shapes/piece_pixels_p.h"
#include "raster/zsort/painter.h"
#include "surface_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace l3d_detail;

constexpr l3d_size size{150, 90};

struct scene {
    std::vector<l3d_painter_triangle> triangles;
    std::vector<l3d_painter_piece> pieces;
    std::vector<l3d_painter_cut> cuts;
    std::vector<l3d_material> materials; ///< of each triangle its own colour
};

/// Small and large triangles, and some that planes of others cut.
scene random_scene(unsigned seed, int reach) {
    constexpr std::uint32_t count = 2500; // several parts
    random_polygons random(seed, size);
    scene all;
    for (std::uint32_t i = 0; i < count; ++i) {
        const int x = random.number(-512, 256 * size.width + 512);
        const int y = random.number(-512, 256 * size.height + 512);
        const int extent = i % 8 == 0 ? 8 * reach : reach;
        l3d_painter_triangle next;
        next.material = i;
        for (l3d_micro_vertex& corner : next.v)
            corner = {x + random.number(-extent, extent),
                      y + random.number(-extent, extent),
                      random.real(0.05f, 2.0f),
                      {random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)}};
        next.sides = i % 8;
        all.materials.push_back({.color = i + 1});
        all.triangles.push_back(next);
        all.pieces.push_back({.triangle = i});
        for (std::uint32_t c = 1; i >= 40 && c <= i % 16 / 13; ++c) {
            const auto last = static_cast<std::uint32_t>(all.cuts.size());
            all.cuts.push_back({i - 8 * c, i % 3 == 0, all.pieces.back().cut});
            all.pieces.back().cut = last;
        }
    }
    return all;
}

class picture {
public:
    l3d_pixels pixels() { return {words_.data(), size.width, size.height, size.width}; }
    const std::vector<std::uint32_t>& words() const { return words_; }

private:
    std::vector<std::uint32_t> words_ =
        std::vector<std::uint32_t>(std::size_t(size.width) * std::size_t(size.height));
};

/// Ambient light alone: a pixel shows its triangle's own colour.
l3d_shading own_colors() {
    l3d_shading shading;
    shading.lighting.ambient = {1, 1, 1};
    shading.lighting.color = {};
    return shading;
}

/// Fills what cuts leave of a piece.
void paint_over(l3d_pixels to, const scene& of, const l3d_painter_piece& piece,
                std::span<const plane_cut> cuts, std::uint32_t color) {
    scan_polygon scan;
    scan.set_rows({0, size.height});
    visit_rows(scan, of.triangles[piece.triangle].v, cuts, size.width,
               [&](std::int32_t row, std::int32_t, columns span) {
                   std::fill_n(to.row(row).begin() + span.begin, span.end - span.begin, color);
                   return true;
               });
}

std::vector<plane_cut> cuts_of(const scene& of, const l3d_painter_piece& piece) {
    std::vector<plane_cut> cuts;
    add_cuts(piece, of.triangles, of.cuts, cuts);
    return cuts;
}

TEST(Painter, ShowsWhatIsPaintedLastWithAnyInstructionsAndThreads) {
    for (const int reach : {60, 900}) {
        const scene of = random_scene(static_cast<unsigned>(reach), reach);
        ASSERT_GT(of.cuts.size(), 100u);
        picture slow;
        for (const l3d_painter_piece& piece : of.pieces)
            paint_over(slow.pixels(), of, piece, cuts_of(of, piece),
                       of.materials[piece.triangle].color);
        for (const std::string& target : l3d_simd_targets()) {
            ASSERT_TRUE(l3d_set_simd_target(target));
            for (const int threads : {1, 5}) {
                l3d_workers workers(threads);
                l3d_painter painter(workers);
                picture fast;
                painter.paint(fast.pixels(), own_colors(), of.materials, of.triangles, of.pieces,
                              of.cuts);
                EXPECT_EQ(fast.words(), slow.words()) << target << ", " << threads << " threads";
            }
            ASSERT_TRUE(l3d_set_simd_target(""));
        }
    }
}

TEST(Painter, HidesTheSidesOfWhatIsPaintedBefore) {
    constexpr std::uint32_t line_color = 0x80c0ff;
    for (const bool smooth : {false, true}) {
        const scene of = random_scene(7, 300);
        picture slow, fast;
        const l3d_pixels to = slow.pixels();
        std::int64_t sides = 0;
        for (const l3d_painter_piece& piece : of.pieces) {
            const std::vector<plane_cut> cuts = cuts_of(of, piece);
            paint_over(to, of, piece, cuts, 0);
            visit_sides(of.triangles[piece.triangle], cuts, size, smooth,
                        [&](int x, int y, int c, double) {
                            cover_pixel(to.row(y)[static_cast<std::size_t>(x)], c);
                            ++sides;
                        });
        }
        l3d_shading shading;
        shading.background = {0x102030, 0x405060};
        color_cover(to, {0, size.height}, shading, line_color, {});
        l3d_workers workers(2);
        l3d_painter painter(workers);
        painter.paint_lines(fast.pixels(), shading, of.triangles, of.pieces, of.cuts,
                            {line_color, smooth});
        EXPECT_GT(sides, 5000);
        EXPECT_EQ(fast.words(), slow.words()) << smooth;
    }
}

} // namespace
