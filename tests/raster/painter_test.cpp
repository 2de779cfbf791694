// SPDX-License-Identifier: MIT
// The painter's ways to the same picture: threads, orders, and what is known of pixels.
#include "raster/parallel/simd_target.h"
#include "raster/shapes/attribute_plane_p.h"
#include "raster/zsort/overdraw_p.h"
#include "raster/zsort/painter.h"
#include "raster/shapes/scan_polygon_p.h"
#include "surface_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace l3d_detail;

constexpr l3d_size size{150, 90};

struct scene {
    std::vector<l3d_painter_triangle> triangles;
    std::vector<l3d_painter_piece> pieces;
};

/// The bits of a triangle's pixels, if they are few and all in the picture.
l3d_painter_piece known(const std::array<l3d_micro_vertex, 3>& v, std::uint32_t number) {
    constexpr std::int32_t side = l3d_painter_piece::small_side;
    const auto [left, right] =
        std::minmax({first_centre(v[0].x), first_centre(v[1].x), first_centre(v[2].x)});
    const auto [top, bottom] =
        std::minmax({first_centre(v[0].y), first_centre(v[1].y), first_centre(v[2].y)});
    l3d_painter_piece piece{.triangle = number};
    if (left < 0 || top < 0 || right > size.width || bottom > size.height || right - left > side ||
        bottom - top > side)
        return piece;
    const std::array<scan_point, 3> points{{{v[0].x, v[0].y}, {v[1].x, v[1].y}, {v[2].x, v[2].y}}};
    const std::int64_t area2 = cross(points[1] - points[0], points[2] - points[0]);
    if (area2 == 0)
        return piece;
    scan_polygon scan;
    scan.set_rows({0, size.height});
    const scan_rows rows = scan.convert(std::span<const scan_point, 3>(points), area2 > 0);
    piece.left = left;
    piece.top = top;
    for (std::int32_t row = rows.top; row < rows.bottom; ++row)
        for (std::int32_t x = scan.first(row); x < scan.last(row); ++x)
            piece.cover |= std::uint64_t{1} << (side * (row - top) + x - left);
    return piece;
}

/// So many triangles that the pieces of a picture come in several lists, some larger than others.
scene random_scene(unsigned seed, int reach) {
    constexpr int count = 2500;
    random_polygons random(seed, size);
    scene all;
    for (std::uint32_t i = 0; i < count; ++i) {
        const int x = random.number(-512, 256 * size.width + 512);
        const int y = random.number(-512, 256 * size.height + 512);
        const int extent = i % 8 == 0 ? 8 * reach : reach;
        l3d_painter_triangle next;
        for (l3d_micro_vertex& corner : next.v)
            corner = {x + random.number(-extent, extent),
                      y + random.number(-extent, extent),
                      random.real(0.05f, 2.0f),
                      {random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)}};
        next.material = i % 3;
        all.triangles.push_back(next);
        all.pieces.push_back(known(next.v, i));
    }
    return all;
}

std::vector<std::uint32_t> painted(const scene& of, l3d_shade mode, int threads) {
    const l3d_shading shading{
        mode, {0.36f, 0.48f, 0.8f}, {-0.3f, 0.2f, -1}, {0.01f, 0, 0}, {0, -0.02f, 0.003f}};
    const std::vector<l3d_material> materials{
        {.color = 0xffffff}, {.color = 0x12cd80}, {.color = 0xfe0103}};
    std::vector<std::uint32_t> words(std::size_t(size.width) * std::size_t(size.height));
    l3d_workers workers(threads);
    l3d_painter painter(workers);
    painter.paint({words.data(), size.width, size.height, size.width}, shading, materials,
                  of.triangles, of.pieces, {});
    return words;
}

TEST(Painter, ShowsTheSameWhoeverPaintsAndWhateverIsKnown) {
    for (const int reach : {60, 900}) {
        const scene of = random_scene(static_cast<unsigned>(reach), reach);
        scene unknown = of;
        for (l3d_painter_piece& piece : unknown.pieces)
            piece = {.triangle = piece.triangle};
        EXPECT_NE(std::ranges::count(of.pieces, std::uint64_t{0}, &l3d_painter_piece::cover),
                  std::ssize(of.pieces));
        EXPECT_EQ(has_overdraw(of.triangles, of.pieces), reach == 900) << "both directions";
        for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat}) {
            const auto first = painted(unknown, mode, 1);
            for (const std::string& target : l3d_simd_targets()) {
                ASSERT_TRUE(l3d_set_simd_target(target));
                for (const int threads : {1, 2, 5})
                    for (const scene* next : {&of, static_cast<const scene*>(&unknown)})
                        EXPECT_EQ(painted(*next, mode, threads), first)
                            << target << ", " << threads << " threads, shade " << int(mode)
                            << ", known: " << (next == &of) << ", reach " << reach;
                ASSERT_TRUE(l3d_set_simd_target(""));
            }
        }
    }
}

/// From front to back each pixel is painted once, and shows what is painted last from back to
/// front. A triangle far outside of the picture makes the box around all so large that the painter
/// begins at the back.
TEST(Painter, ShowsTheSameFromEitherEnd) {
    const scene of = random_scene(5, 900);
    scene from_back = of;
    for (const std::int32_t far : {-scan_limit, scan_limit}) {
        l3d_painter_triangle next = of.triangles.front();
        for (l3d_micro_vertex& corner : next.v)
            corner.x = corner.y = far;
        next.v[0].x -= far < 0 ? -256 : 256;
        next.v[1].y -= far < 0 ? -256 : 256;
        from_back.pieces.insert(from_back.pieces.begin(), {.triangle = static_cast<std::uint32_t>(
                                                               from_back.triangles.size())});
        from_back.triangles.push_back(next);
    }
    ASSERT_TRUE(has_overdraw(of.triangles, of.pieces));
    ASSERT_FALSE(has_overdraw(from_back.triangles, from_back.pieces));
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat})
        for (const int threads : {1, 3})
            EXPECT_EQ(painted(of, mode, threads), painted(from_back, mode, threads)) << int(mode);
}

} // namespace
