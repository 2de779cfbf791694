// SPDX-License-Identifier: MIT
// The surface rasterizer in bands: like its slow twin, whatever the bands, threads and order.
#include "allocations.h"
#include "raster/simd_target.h"
#include "surface_fixture.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <limits>

namespace {

constexpr unsigned seed = 20070301;
constexpr std::array<float, 3> light{0.48f, 0.60f, 0.64f};
constexpr l3d_size odd{203, 131};
constexpr std::array all_modes{l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat,
                               l3d_shade::normals, l3d_shade::error};

using parts = std::vector<l3d_surface_part>;

std::vector<const l3d_surface_part*> pointers(const parts& all) {
    std::vector<const l3d_surface_part*> result;
    for (const l3d_surface_part& part : all)
        result.push_back(&part);
    return result;
}

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

/// Sheets over, through and beside each other, with triangles strewn in.
parts random_scene(unsigned scene_seed, l3d_size size, int sheets) {
    random_polygons random(scene_seed, size);
    parts all;
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

void draw_frame(surface_picture& picture, const parts& scene, l3d_shade mode) {
    picture.begin({mode, light, {-0.4f, 0.3f, -1}, {0.004f, 0, 0}, {0, -0.004f, 0}});
    picture.rasterizer.draw(pointers(scene));
    picture.rasterizer.finish();
}

void expect_same(surface_picture& a, surface_picture& b) {
    EXPECT_EQ(a.words, b.words);
    for (int y = 0; y < a.size.height; ++y)
        for (int x = 0; x < a.size.width; ++x)
            ASSERT_EQ(a.inv_w(x, y), b.inv_w(x, y)) << x << ", " << y;
}

int level_difference(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (int shift = 0; shift < 32; shift += 8)
        most = std::max(most, std::abs(int(a >> shift & 255) - int(b >> shift & 255)));
    return most;
}

TEST(SurfaceBands, DrawWhatTheSlowTwinDraws) {
    surface_picture slow(odd.width, odd.height), fast(odd.width, odd.height, 2, {16});
    for (const l3d_shade mode : all_modes)
        for (unsigned n = 0; n < 20; ++n) {
            const parts scene = random_scene(seed + n, odd, 25);
            draw_frame(slow, scene, mode);
            draw_frame(fast, scene, mode);
            ASSERT_TRUE(fast.guards_intact());
            const l3d_surface_counts &of_slow = slow.rasterizer.counts(),
                                     &of_fast = fast.rasterizer.counts();
            EXPECT_EQ(of_fast.quads, of_slow.quads);
            EXPECT_EQ(of_fast.covered, of_slow.covered);
            EXPECT_LE(of_fast.samples, of_slow.samples);
            int other = 0;
            for (int y = 0; y < odd.height; ++y)
                for (int x = 0; x < odd.width; ++x) {
                    ASSERT_NEAR(fast.inv_w(x, y), slow.inv_w(x, y), 1e-5) << x << ", " << y;
                    other += level_difference(fast.word(x, y), slow.word(x, y)) > 1;
                }
            // Where two sheets meet, a difference in the last bits decides which is seen.
            EXPECT_LE(other, odd.width * odd.height / 1000)
                << "mode " << int(mode) << ", seed " << seed + n;
        }
}

TEST(SurfaceBands, PictureDoesNotDependOnThemNorOnThreads) {
    // Else oneTBB has no more threads than the machine has cores.
    const tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::normals})
        for (unsigned n = 0; n < 4; ++n) {
            const parts scene = random_scene(seed + n, odd, 30);
            surface_picture one(odd.width, odd.height, 1);
            draw_frame(one, scene, mode);
            const l3d_surface_counts of_one = one.rasterizer.counts();
            for (const int threads : {2, 3, 8}) {
                surface_picture other(odd.width, odd.height, threads);
                draw_frame(other, scene, mode);
                expect_same(one, other);
                EXPECT_EQ(other.rasterizer.counts().samples, of_one.samples) << threads;
                EXPECT_EQ(other.rasterizer.counts().written, of_one.written) << threads;
                EXPECT_EQ(other.rasterizer.counts().covered, of_one.covered) << threads;
            }
            for (int rows = 8; rows < odd.height + 16; rows += 8) {
                surface_picture other(odd.width, odd.height, 2, {rows});
                draw_frame(other, scene, mode);
                expect_same(one, other);
                EXPECT_EQ(other.rasterizer.counts().written, of_one.written) << rows;
                EXPECT_EQ(other.rasterizer.counts().covered, of_one.covered) << rows;
            }
        }
}

TEST(SurfaceBands, PictureDoesNotDependOnTheInstructions) {
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat})
        for (unsigned n = 0; n < 4; ++n) {
            const parts scene = random_scene(seed + n, odd, 60);
            surface_picture best(odd.width, odd.height, 2);
            draw_frame(best, scene, mode);
            const l3d_surface_counts of_best = best.rasterizer.counts();
            for (const std::string& name : l3d_simd_targets()) {
                ASSERT_TRUE(l3d_set_simd_target(name));
                surface_picture other(odd.width, odd.height, 2);
                draw_frame(other, scene, mode);
                SCOPED_TRACE(name);
                expect_same(best, other);
                EXPECT_EQ(other.rasterizer.counts().samples, of_best.samples);
                EXPECT_EQ(other.rasterizer.counts().written, of_best.written);
                EXPECT_EQ(other.rasterizer.counts().covered, of_best.covered);
                EXPECT_TRUE(other.guards_intact());
            }
            l3d_set_simd_target("");
        }
}

TEST(SurfaceBands, LeavingOutWhatIsHiddenLosesNothing) {
    std::int64_t with = 0, without = 0;
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::error})
        for (unsigned n = 0; n < 10; ++n) {
            const parts scene = random_scene(seed + n, odd, 150);
            surface_picture all(odd.width, odd.height, 1, {.rows = 32, .leave_out_hidden = false});
            surface_picture seen(odd.width, odd.height, 1, {.rows = 32, .leave_out_hidden = true});
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

TEST(SurfaceBands, WhatIsHiddenNeedNotBeDrawn) {
    int hidden = 0;
    for (unsigned n = 0; n < 20; ++n) {
        parts scene = random_scene(seed + n, odd, 120);
        for (l3d_surface_part& part : scene)
            if (n % 2)
                part.triangles.clear(); // these reach far
        const std::vector<const l3d_surface_part*> all = pointers(scene);
        surface_picture whole(odd.width, odd.height, 1), culled(odd.width, odd.height, 2);
        whole.begin(l3d_shade::lambert, light);
        culled.begin(l3d_shade::lambert, light);
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

TEST(SurfaceBands, HiddenIsWhatIsNoNearerThanAllOfItsTiles) {
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

TEST(SurfaceBands, NearestComesFirst) {
    parts pile; // farthest first, one per cent apart, of whole tiles
    for (int i = 0; i < 20; ++i)
        pile.push_back(rectangle(16, 8, 160, 104, 0.5f * (1 + 0.01f * float(i))));
    surface_picture picture(odd.width, odd.height, 2);
    draw_frame(picture, pile, l3d_shade::error);
    EXPECT_EQ(picture.rasterizer.counts().samples, 144 * 96) << "of one only";
    EXPECT_EQ(picture.rasterizer.counts().written, picture.rasterizer.counts().samples);
    EXPECT_EQ(picture.rasterizer.counts().quads, 20);
}

TEST(SurfaceBands, NeedNoDepthBuffer) {
    for (const l3d_shade mode : all_modes) {
        const parts scene = random_scene(seed, odd, 40);
        surface_picture with(odd.width, odd.height, 2), without(odd.width, odd.height, 2);
        draw_frame(with, scene, mode);
        for (int frame = 0; frame < 2; ++frame) { // the second must not see the first
            without.rasterizer.begin(
                without.pixels(), nullptr,
                {mode, light, {-0.4f, 0.3f, -1}, {0.004f, 0, 0}, {0, -0.004f, 0}});
            without.rasterizer.draw(pointers(scene));
            without.rasterizer.finish();
            EXPECT_EQ(without.words, with.words);
            EXPECT_EQ(without.rasterizer.counts().covered, with.rasterizer.counts().covered);
            EXPECT_EQ(without.rasterizer.counts().written, with.rasterizer.counts().written);
        }
        EXPECT_EQ(without.inv_w(0, 0), 1e30f);
    }
}

TEST(SurfaceBands, UntouchedPicturesAreEmptiedWhereSomethingWas) {
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::error}) {
        surface_picture fresh(odd.width, odd.height, 2), kept(odd.width, odd.height, 2);
        std::vector<std::uint32_t> other_words(fresh.words);
        l3d_pixels other = kept.pixels();
        other.words = other_words.data();
        random_polygons random(seed, odd);
        bool untouched = false;
        for (unsigned n = 0; n < 60; ++n) {
            const parts scene = random_scene(seed + n, odd, random.number(0, 6));
            const bool to_other = n % 7 == 5, has_depth = n % 3 == 0, draws = n % 11 != 4;
            const l3d_pixels target = to_other ? other : kept.pixels();
            kept.rasterizer.begin(target, has_depth ? &kept.depth : nullptr, {mode, light},
                                  untouched);
            fresh.begin(mode, light);
            if (draws) {
                kept.rasterizer.draw(pointers(scene));
                fresh.rasterizer.draw(pointers(scene));
            }
            fresh.rasterizer.finish();
            if (n % 13 != 9) // else the frame is given up, and the next one must not rely on it
                kept.rasterizer.finish();
            untouched = true;
            if (n % 13 == 9)
                continue;
            EXPECT_EQ(to_other ? other_words : kept.words, fresh.words) << n;
            EXPECT_EQ(kept.rasterizer.counts().covered, fresh.rasterizer.counts().covered) << n;
            if (has_depth) {
                EXPECT_EQ(l3d_covered(kept.depth), fresh.rasterizer.counts().covered) << n;
            }
            if (n % 5 == 2) { // a text is drawn on top
                std::ranges::fill(kept.words, surface_picture::noise);
                for (int y = 0; y < odd.height; ++y)
                    std::fill_n(kept.words.data() + y * target.stride + odd.width,
                                surface_picture::gap, surface_picture::guard);
                untouched = false;
            }
        }
    }
}

TEST(SurfaceBands, WithoutPartsThePictureIsEmpty) {
    for (const bool draws : {false, true})
        for (const bool has_depth : {false, true}) {
            surface_picture picture(odd.width, odd.height, 2);
            picture.rasterizer.begin(picture.pixels(), has_depth ? &picture.depth : nullptr, {});
            if (draws)
                picture.rasterizer.draw({});
            picture.rasterizer.finish();
            for (int y = 0; y < odd.height; ++y)
                for (int x = 0; x < odd.width; ++x) {
                    ASSERT_EQ(picture.word(x, y), 0u);
                    ASSERT_EQ(picture.inv_w(x, y), has_depth ? 0 : 1e30f);
                }
            EXPECT_TRUE(picture.guards_intact());
            EXPECT_EQ(picture.rasterizer.counts().covered, 0);
        }
}

TEST(SurfaceBands, PicturesOfAnySizeAreDrawn) {
    for (const l3d_size size : {l3d_size{1, 1}, l3d_size{7, 300}, l3d_size{15, 8}, l3d_size{16, 9},
                                l3d_size{17, 1}, l3d_size{3000, 9}, l3d_size{0, 0}}) {
        surface_picture slow(size.width, size.height), fast(size.width, size.height, 2);
        const parts scene = random_scene(seed, size, 40);
        draw_frame(slow, scene, l3d_shade::lambert);
        draw_frame(fast, scene, l3d_shade::lambert);
        EXPECT_TRUE(fast.guards_intact());
        EXPECT_EQ(fast.rasterizer.counts().covered, slow.rasterizer.counts().covered);
        EXPECT_EQ(fast.rasterizer.counts().quads, slow.rasterizer.counts().quads);
    }
}

TEST(SurfaceBands, OneObjectServesFramesOfAnySize) {
    l3d_workers workers(2);
    l3d_surface_rasterizer_sw one(workers);
    for (const l3d_size size : {l3d_size{211, 97}, l3d_size{30, 200}, l3d_size{301, 107}}) {
        surface_picture fresh(size.width, size.height, 2), again(size.width, size.height);
        const parts scene = random_scene(seed, size, 20);
        draw_frame(fresh, scene, l3d_shade::lambert);
        one.begin(again.pixels(), nullptr,
                  {l3d_shade::lambert, light, {-0.4f, 0.3f, -1}, {0.004f, 0, 0}, {0, -0.004f, 0}});
        one.draw(pointers(scene));
        one.finish();
        EXPECT_EQ(again.words, fresh.words);
    }
}

TEST(SurfaceBands, AllocateNothingOnceWarm) {
    for (const int threads : {1, 3}) {
        surface_picture picture(odd.width, odd.height, threads);
        const parts scene = random_scene(seed, odd, 40);
        const std::vector<const l3d_surface_part*> all = pointers(scene);
        const auto draw = [&](l3d_depth_buffer* depth) {
            picture.rasterizer.begin(picture.pixels(), depth, {l3d_shade::lambert, light});
            picture.rasterizer.draw(all);
            picture.rasterizer.finish();
        };
        // Which worker gets which band is chance, and each has work space of its own.
        for (int frame = 0; frame < 20; ++frame)
            draw(frame % 2 ? &picture.depth : nullptr);
        const long before = allocations;
        for (int frame = 0; frame < 20; ++frame)
            draw(frame % 2 ? &picture.depth : nullptr);
        EXPECT_EQ(allocations, before) << threads;
    }
}

TEST(SurfaceBands, NumbersOfAnyKindInNormalsAreNoFault) {
    surface_picture picture(odd.width, odd.height, 2);
    parts scene = random_scene(seed, odd, 10);
    for (l3d_surface_part& part : scene)
        for (std::size_t i = 0; i < part.grid.normal[0].size(); i += 3) {
            part.grid.normal[0][i] = std::numeric_limits<float>::quiet_NaN();
            part.grid.normal[1][i] = std::numeric_limits<float>::infinity();
        }
    for (const l3d_shade mode : all_modes) {
        draw_frame(picture, scene, mode);
        EXPECT_GT(picture.rasterizer.counts().written, 1000);
        EXPECT_TRUE(picture.guards_intact());
    }
}

} // namespace
