// SPDX-License-Identifier: MIT
// The surface rasterizer in bands: like its slow twin, whatever the bands, threads and order.
#include "allocations.h"
#include "raster/parallel/simd_target.h"
#include "effort.h"
#include "surface_scene.h"
#include "tool_2d/image.h"

#include <gtest/gtest.h>

#include <malloc.h>

#include <limits>

namespace {

constexpr std::array all_modes{l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat,
                               l3d_shade::normals, l3d_shade::error,   l3d_shade::levels};

int level_difference(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (int shift = 0; shift < 32; shift += 8)
        most = std::max(most, std::abs(int(a >> shift & 255) - int(b >> shift & 255)));
    return most;
}

TEST(SurfaceBands, DrawWhatTheSlowTwinDraws) {
    surface_picture slow(scene_size.width, scene_size.height),
        fast(scene_size.width, scene_size.height, 2, {16});
    for (const l3d_shade mode : all_modes)
        for (unsigned n = 0; n < 20; ++n) {
            const surface_parts scene = random_scene(scene_seed + n, scene_size, 25);
            draw_frame(slow, scene, mode);
            draw_frame(fast, scene, mode);
            ASSERT_TRUE(fast.guards_intact());
            const l3d_surface_counts &of_slow = slow.rasterizer.counts(),
                                     &of_fast = fast.rasterizer.counts();
            EXPECT_EQ(of_fast.quads, of_slow.quads);
            EXPECT_EQ(of_fast.covered, of_slow.covered);
            EXPECT_LE(of_fast.samples, of_slow.samples);
            int other = 0;
            for (int y = 0; y < scene_size.height; ++y)
                for (int x = 0; x < scene_size.width; ++x) {
                    ASSERT_NEAR(fast.inv_w(x, y), slow.inv_w(x, y), 1e-5) << x << ", " << y;
                    other += level_difference(fast.word(x, y), slow.word(x, y)) > 1;
                }
            // Where two sheets meet, a difference in the last bits decides which is seen.
            EXPECT_LE(other, scene_size.width * scene_size.height / 1000)
                << "mode " << int(mode) << ", seed " << scene_seed + n;
        }
}

std::size_t bytes_in_use() {
    const struct mallinfo2 all = mallinfo2();
    return all.uordblks + all.hblkhd;
}

TEST(SurfaceBands, GiveBackTheMemoryOfALargePicture) {
    if (sanitized)
        GTEST_SKIP() << "sanitizers have memory of their own";
    constexpr l3d_size large{4000, 3000}, small{40, 30};
    l3d_workers one(1);
    l3d_surface_rasterizer_sw rasterizer(one);
    const surface_parts scene = random_scene(scene_seed, small, 5);
    l3d_shading shading = scene_shading(l3d_shade::lambert);
    shading.antialias = true;
    const auto draw = [&](l3d_size size) {
        l3d_image picture(size);
        l3d_depth_buffer depth;
        depth.resize(size);
        for (l3d_depth_buffer* const kept : {&depth, static_cast<l3d_depth_buffer*>(nullptr)}) {
            rasterizer.begin(picture.pixels(), kept, shading);
            rasterizer.draw(pointers(scene));
            rasterizer.finish();
        }
    };
    draw(small);
    const std::size_t before = bytes_in_use();
    draw(large);
    EXPECT_GT(bytes_in_use(), before + (std::size_t{10} << 20));
    draw(small);
    EXPECT_LT(bytes_in_use(), before + (std::size_t{1} << 20));
}

TEST(SurfaceBands, PictureDoesNotDependOnThemNorOnThreads) {
    for (const l3d_shade mode :
         {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::normals, l3d_shade::levels})
        for (unsigned n = 0; n < 4; ++n) {
            const surface_parts scene = random_scene(scene_seed + n, scene_size, 30);
            surface_picture one(scene_size.width, scene_size.height, 1);
            draw_frame(one, scene, mode);
            const l3d_surface_counts of_one = one.rasterizer.counts();
            for (const int threads : {2, 3, 8}) {
                surface_picture other(scene_size.width, scene_size.height, threads);
                draw_frame(other, scene, mode);
                expect_same(one, other);
                EXPECT_EQ(other.rasterizer.counts().samples, of_one.samples) << threads;
                EXPECT_EQ(other.rasterizer.counts().written, of_one.written) << threads;
                EXPECT_EQ(other.rasterizer.counts().covered, of_one.covered) << threads;
            }
            for (int rows = 8; rows < scene_size.height + 16; rows += 8) {
                surface_picture other(scene_size.width, scene_size.height, 2, {rows});
                draw_frame(other, scene, mode);
                expect_same(one, other);
                EXPECT_EQ(other.rasterizer.counts().written, of_one.written) << rows;
                EXPECT_EQ(other.rasterizer.counts().covered, of_one.covered) << rows;
            }
        }
}

TEST(SurfaceBands, PictureDoesNotDependOnTheInstructions) {
    for (const l3d_shade mode :
         {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat, l3d_shade::levels})
        for (unsigned n = 0; n < 4; ++n) {
            const surface_parts scene = random_scene(scene_seed + n, scene_size, 60);
            surface_picture best(scene_size.width, scene_size.height, 2);
            draw_frame(best, scene, mode);
            const l3d_surface_counts of_best = best.rasterizer.counts();
            for (const std::string& name : l3d_simd_targets()) {
                ASSERT_TRUE(l3d_set_simd_target(name));
                surface_picture other(scene_size.width, scene_size.height, 2);
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

TEST(SurfaceBands, NeedNoDepthBuffer) {
    for (const l3d_shade mode : all_modes) {
        const surface_parts scene = random_scene(scene_seed, scene_size, 40);
        surface_picture with(scene_size.width, scene_size.height, 2),
            without(scene_size.width, scene_size.height, 2);
        draw_frame(with, scene, mode);
        for (int frame = 0; frame < 2; ++frame) { // the second must not see the first
            without.rasterizer.begin(without.pixels(), nullptr, scene_shading(mode));
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
        surface_picture fresh(scene_size.width, scene_size.height, 2),
            kept(scene_size.width, scene_size.height, 2);
        std::vector<std::uint32_t> other_words(fresh.words);
        l3d_pixels other = kept.pixels();
        other.words = other_words.data();
        random_polygons random(scene_seed, scene_size);
        bool untouched = false;
        for (unsigned n = 0; n < 60; ++n) {
            const surface_parts scene =
                random_scene(scene_seed + n, scene_size, random.number(0, 6));
            const bool to_other = n % 7 == 5, has_depth = n % 3 == 0, draws = n % 11 != 4;
            const l3d_pixels target = to_other ? other : kept.pixels();
            kept.rasterizer.begin(target, has_depth ? &kept.depth : nullptr, {mode, scene_light},
                                  untouched);
            fresh.begin(mode, scene_light);
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
                for (int y = 0; y < scene_size.height; ++y)
                    std::fill_n(kept.words.data() + y * target.stride + scene_size.width,
                                surface_picture::gap, surface_picture::guard);
                untouched = false;
            }
        }
    }
}

TEST(SurfaceBands, WithoutPartsThePictureIsEmpty) {
    for (const bool draws : {false, true})
        for (const bool has_depth : {false, true}) {
            surface_picture picture(scene_size.width, scene_size.height, 2);
            picture.rasterizer.begin(picture.pixels(), has_depth ? &picture.depth : nullptr, {});
            if (draws)
                picture.rasterizer.draw({});
            picture.rasterizer.finish();
            for (int y = 0; y < scene_size.height; ++y)
                for (int x = 0; x < scene_size.width; ++x) {
                    ASSERT_EQ(picture.word(x, y), 0u);
                    ASSERT_EQ(picture.inv_w(x, y), has_depth ? 0 : 1e30f);
                }
            EXPECT_TRUE(picture.guards_intact());
            EXPECT_EQ(picture.rasterizer.counts().covered, 0);
        }
}

TEST(SurfaceBands, DepthThatNobodyWantsIsLeftAloneWhereNothingIsDrawn) {
    surface_picture wanted(scene_size.width, scene_size.height, 2),
        other(scene_size.width, scene_size.height, 2);
    other.rasterizer.leave_depth(false);
    for (const int sheets : {0, 25}) {
        const surface_parts scene = random_scene(scene_seed, scene_size, sheets);
        for (surface_picture* const picture : {&wanted, &other}) {
            picture->begin(l3d_shade::lambert, scene_light);
            for (const l3d_surface_part* const part : pointers(scene))
                picture->rasterizer.draw(std::span(&part, 1)); // a batch each
            picture->rasterizer.finish();
        }
        EXPECT_EQ(other.words, wanted.words);
        EXPECT_EQ(wanted.rasterizer.counts().covered, other.rasterizer.counts().covered);
        if (sheets == 0) {
            EXPECT_EQ(wanted.inv_w(0, 0), 0);
            EXPECT_EQ(other.inv_w(0, 0), 1e30f);
        }
    }
}

TEST(SurfaceBands, PicturesOfAnySizeAreDrawn) {
    for (const l3d_size size : {l3d_size{1, 1}, l3d_size{7, 300}, l3d_size{15, 8}, l3d_size{16, 9},
                                l3d_size{17, 1}, l3d_size{3000, 9}, l3d_size{0, 0}}) {
        surface_picture slow(size.width, size.height), fast(size.width, size.height, 2);
        const surface_parts scene = random_scene(scene_seed, size, 40);
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
        const surface_parts scene = random_scene(scene_seed, size, 20);
        draw_frame(fresh, scene, l3d_shade::lambert);
        one.begin(again.pixels(), nullptr, scene_shading(l3d_shade::lambert));
        one.draw(pointers(scene));
        one.finish();
        EXPECT_EQ(again.words, fresh.words);
    }
}

TEST(SurfaceBands, AllocateNothingOnceWarm) {
    for (const int threads : {1, 3}) {
        surface_picture picture(scene_size.width, scene_size.height, threads);
        const surface_parts scene = random_scene(scene_seed, scene_size, 40);
        const std::vector<const l3d_surface_part*> all = pointers(scene);
        const auto draw = [&](l3d_depth_buffer* depth) {
            picture.rasterizer.begin(picture.pixels(), depth, {l3d_shade::lambert, scene_light});
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
    surface_picture picture(scene_size.width, scene_size.height, 2);
    surface_parts scene = random_scene(scene_seed, scene_size, 10);
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
