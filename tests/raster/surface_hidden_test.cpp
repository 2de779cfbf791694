// SPDX-License-Identifier: MIT
// The surface rasterizer leaves out polygons that nearer things hide: nothing is lost, and much is
// left out.
#include "surface_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace {

TEST(SurfaceHidden, LeavingOutWhatIsHiddenLosesNothing) {
    std::int64_t with = 0, without = 0;
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::error})
        for (unsigned n = 0; n < 10; ++n) {
            const surface_parts scene = random_scene(scene_seed + n, scene_size, 150);
            surface_picture all(scene_size.width, scene_size.height, 1,
                                {.rows = 32, .leave_out_hidden = false});
            surface_picture seen(scene_size.width, scene_size.height, 1,
                                 {.rows = 32, .leave_out_hidden = true});
            draw_frame(all, scene, mode);
            draw_frame(seen, scene, mode);
            expect_same(all, seen);
            EXPECT_EQ(seen.rasterizer.counts().written, all.rasterizer.counts().written);
            with += seen.rasterizer.counts().samples;
            without += all.rasterizer.counts().samples;
        }
    EXPECT_LT(with, without / 2); // there was something to leave out
}

/// The box of a part's grid, and its nearest vertex.
std::pair<l3d_subpixel_box, float> bounds(const l3d_surface_part& part) {
    constexpr std::int32_t far = 1 << 23;
    l3d_subpixel_box box{far, far, -far, -far};
    float nearest = 0;
    const auto add = [&](const l3d_micro_vertex& v) {
        box = {std::min(box.left, v.x), std::min(box.top, v.y), std::max(box.right, v.x),
               std::max(box.bottom, v.y)};
        nearest = std::max(nearest, v.inv_w);
    };
    for (int row = 0; row < part.grid.rows; ++row)
        for (int column = 0; column < part.grid.columns; ++column)
            add(part.grid.vertex(row, column));
    for (std::size_t i = 0; i < part.triangles.count; ++i)
        for (std::size_t corner = 0; corner < 3; ++corner)
            add(part.triangles.vertex(i, corner));
    return {box, nearest};
}

TEST(SurfaceHidden, WhatIsHiddenNeedNotBeDrawn) {
    int hidden = 0;
    for (unsigned n = 0; n < 20; ++n) {
        surface_parts scene = random_scene(scene_seed + n, scene_size, 120);
        for (l3d_surface_part& part : scene)
            if (n % 2)
                part.triangles.clear(); // these reach far
        const std::vector<const l3d_surface_part*> all = pointers(scene);
        surface_picture whole(scene_size.width, scene_size.height, 1),
            culled(scene_size.width, scene_size.height, 2);
        whole.begin(l3d_shade::lambert, scene_light);
        culled.begin(l3d_shade::lambert, scene_light);
        constexpr std::size_t batch = 30;
        for (std::size_t i = 0; i < all.size(); i += batch) {
            std::vector<const l3d_surface_part*> seen;
            for (std::size_t k = i; k < i + batch; ++k) {
                const auto [box, nearest] = bounds(*all[k]);
                if (culled.rasterizer.hidden(box, nearest))
                    ++hidden;
                else
                    seen.push_back(all[k]);
            }
            culled.rasterizer.draw(seen);
            whole.rasterizer.draw({all.data() + i, batch});
        }
        whole.rasterizer.finish();
        culled.rasterizer.finish();
        expect_same(whole, culled);
        EXPECT_EQ(culled.rasterizer.counts().covered, whole.rasterizer.counts().covered);
        EXPECT_EQ(culled.rasterizer.counts().covered, l3d_covered(culled.depth));
    }
    EXPECT_GT(hidden, 100);
}

/// A rectangle of whole pixels, facing the eye.
l3d_surface_part rectangle(int left, int top, int right, int bottom, float inv_w) {
    const auto at = [inv_w](int x, int y) {
        return l3d_micro_vertex{256 * x, 256 * y, inv_w, {0, 0, 1}};
    };
    return part_of({at(left, top), at(right, top), at(right, bottom), at(left, bottom)}, 0x123456);
}

TEST(SurfaceHidden, HiddenIsWhatIsNoNearerThanAllOfItsTiles) {
    surface_picture picture(203, 131, 2);
    const auto box = [](int left, int top, int right, int bottom) {
        return l3d_subpixel_box{256 * left, 256 * top, 256 * right, 256 * bottom};
    };
    picture.begin(l3d_shade::error);
    EXPECT_FALSE(picture.rasterizer.hidden(box(20, 20, 30, 30), 0.25f)) << "nothing drawn yet";
    draw_part(picture.rasterizer, rectangle(16, 8, 203, 131, 0.5f));
    EXPECT_TRUE(picture.rasterizer.hidden(box(20, 20, 30, 30), 0.5f)) << "of equals, the first";
    EXPECT_TRUE(picture.rasterizer.hidden(box(16, 8, 300, 200), 0.5f)) << "beyond the window";
    EXPECT_FALSE(picture.rasterizer.hidden(box(20, 20, 30, 30), std::nextafter(0.5f, 1.0f)));
    EXPECT_FALSE(picture.rasterizer.hidden(box(15, 20, 30, 30), 0.25f)) << "looks out on the left";
    EXPECT_FALSE(picture.rasterizer.hidden(box(20, 7, 30, 30), 0.25f)) << "looks out above";
    for (const auto& outside :
         {box(-30, 7, -20, 30), box(230, 7, 250, 30), box(9, -30, 90, -20), box(9, 150, 90, 170)})
        EXPECT_TRUE(picture.rasterizer.hidden(outside, 9)) << "outside the window";
    EXPECT_TRUE(picture.rasterizer.hidden({16 * 256 - 127, 5000, 6000, 6000}, 0.5f))
        << "the centre left of it is outside";
    EXPECT_FALSE(picture.rasterizer.hidden({16 * 256 - 128, 5000, 6000, 6000}, 0.5f));
    draw_part(picture.rasterizer, rectangle(16, 8, 48, 48, 0.75f));
    EXPECT_TRUE(picture.rasterizer.hidden(box(16, 8, 48, 48), 0.75f)) << "found anew";
    EXPECT_FALSE(picture.rasterizer.hidden(box(16, 8, 49, 48), 0.75f));
    picture.begin(l3d_shade::error);
    EXPECT_FALSE(picture.rasterizer.hidden(box(20, 20, 30, 30), 0.25f)) << "another frame";
    draw_part(picture.rasterizer, rectangle(0, 0, 10, 10, 0.75f));
    EXPECT_FALSE(picture.rasterizer.hidden(box(20, 20, 30, 30), 0.25f)) << "another frame";
}

/// Quads of 8 x 8 whole pixels, facing the eye, as one item.
l3d_surface_part tiled(int left, int top, int columns, int rows, float inv_w) {
    l3d_micro_grid grid;
    grid.resize(columns + 1, rows + 1);
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
            surface_picture::set(
                grid, row, column,
                {256 * (left + 8 * column), 256 * (top + 8 * row), inv_w, {0, 0, 1}});
    return part_of(grid);
}

TEST(SurfaceHidden, QuadsBehindOthersAreLeftOutOneByOne) {
    constexpr int wall = 68 * 68, beside = 80 * 68; // pixels; the rest is left of, or above them
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat})
        for (const bool leave_out : {false, true}) {
            surface_picture picture(scene_size.width, scene_size.height, 1,
                                    {.rows = 32, .leave_out_hidden = leave_out});
            picture.begin(mode);
            draw_part(picture.rasterizer, tiled(-12, -12, 10, 10, 0.5f));
            draw_part(picture.rasterizer, tiled(-12, -12, 20, 10, 0.25f));
            picture.rasterizer.finish();
            EXPECT_EQ(picture.rasterizer.counts().written, wall + beside);
            EXPECT_EQ(picture.rasterizer.counts().samples, wall + beside + (leave_out ? 0 : wall));
        }
}

TEST(SurfaceHidden, AQuadIsHiddenOnlyByAllOfItsBox) {
    for (const int hole : {0, 7, 8 * 4 + 3, 56, 63}) // a pixel of the box that nothing is in
        for (const float farther : {0.25f, 0.5f, std::nextafter(0.5f, 1.0f)}) {
            surface_parts wall;
            for (int i = 0; i < 64; ++i) {
                const int x = 40 + i % 8, y = 40 + i / 8;
                if (i != hole)
                    wall.push_back(rectangle(x, y, x + 1, y + 1, 0.5f));
            }
            surface_picture picture(scene_size.width, scene_size.height, 1);
            picture.begin(l3d_shade::gouraud);
            picture.rasterizer.draw(pointers(wall));
            draw_part(picture.rasterizer, tiled(40, 40, 1, 1, farther));
            picture.rasterizer.finish();
            EXPECT_EQ(picture.rasterizer.counts().written, farther > 0.5f ? 63 + 64 : 64) << hole;
            EXPECT_EQ(picture.rasterizer.counts().samples, 63 + 64) << hole;
            EXPECT_EQ(picture.inv_w(40 + hole % 8, 40 + hole / 8), farther) << hole;
        }
}

TEST(SurfaceHidden, NearestComesFirst) {
    surface_parts pile; // farthest first, one per cent apart, of whole tiles
    for (int i = 0; i < 20; ++i)
        pile.push_back(rectangle(16, 8, 160, 104, 0.5f * (1 + 0.01f * float(i))));
    surface_picture picture(scene_size.width, scene_size.height, 2);
    draw_frame(picture, pile, l3d_shade::error);
    EXPECT_EQ(picture.rasterizer.counts().samples, 144 * 96) << "of one only";
    EXPECT_EQ(picture.rasterizer.counts().written, picture.rasterizer.counts().samples);
    EXPECT_EQ(picture.rasterizer.counts().quads, 20);
}

} // namespace
