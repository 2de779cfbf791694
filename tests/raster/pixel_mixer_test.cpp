// SPDX-License-Identifier: MIT
// pixel_mixer against its slow twin: every pixel of random scenes by areas, and by 256 samples.
#include "raster/refine/pixel_mixer_p.h"
#include "raster/refine/sampled_pixel_p.h"
#include "raster/srgb_light.h"
#include "raster/shaders/shader_choice_p.h"
#include "surface_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace {

using namespace l3d_detail;

constexpr l3d_size size{101, 67};

/// All polygons of a scene, in all pixels whose squares they reach.
struct all_fragments {
    l3d_workers workers{1};
    band_list list;
    coarse_depth coarse;
    pixel_bits bits;
    band_fragments fragments;

    all_fragments(const surface_parts& scene, const l3d_shading& shading) {
        const l3d_pixel_box window = l3d_whole(size);
        list.make(pointers(scene), {.window = window, .rows = size.height, .squares = true},
                  nullptr, workers);
        coarse.resize(size);
        coarse.forget(0, size.height); // so that nothing counts as hidden
        bits.resize(size);
        bits.clear(0, size.height);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                bits.set(x, y);
        fragments.begin(bits, drawn_depth(nullptr, 0, window, coarse), size.width, 0, size.height);
        fragments.use_colors({}, false);
        for (const std::uint32_t index : list.items(0))
            fragments.add(list, list.item(index), shading.mode == l3d_shade::levels);
        fragments.sort();
    }
};

/// The words that the slow twin makes of all pixels.
std::vector<std::uint32_t> sampled(const all_fragments& of, const l3d_shading& shading) {
    std::vector<std::uint32_t> result;
    const band_fragments& band = of.fragments;
    const linear_light& tables = linear_light_tables();
    sampled_pixel sampler;
    with_shader(shading, {}, 0, [&](auto shader) {
        for (std::size_t i = 0; i < band.pixels().size(); ++i) {
            const band_fragments::pixel at = band.pixels()[i];
            sampler.begin({at.x * l3d_subpixel_one, at.y * l3d_subpixel_one});
            for (std::size_t pair = band.begin_of(i); pair < band.begin_of(i + 1); ++pair)
                sampler.add(band.polygons()[band.pairs()[pair].polygon]);
            float empty = 0;
            const light_sum light =
                sampler.light(shader, {shading, size.height}, false, band.closed(i), empty);
            result.push_back(
                light.word_before(shading.background.word(at.y, size.height), empty, tables));
        }
    });
    return result;
}

/// Where pixel_mixer samples, both are the same bits. Elsewhere samples are off by up to 1.18 of 64
/// at each edge. One pixel of several edges was found to be off by 3.7 of 64; the root mean square
/// over a picture was 0.0028 of white at most. Limits are 1.2 times that.
TEST(PixelMixer, MixesWhatItsSlowTwinSamples) {
    for (const l3d_shade mode : {l3d_shade::gouraud, l3d_shade::flat, l3d_shade::levels})
        for (unsigned n = 0; n < 8; ++n) {
            l3d_shading shading = scene_shading(mode);
            shading.antialias = true;
            shading.background = l3d_background::color(n % 2 == 0 ? 0 : 0xffffff);
            const all_fragments all(random_scene(scene_seed + n, size, 6), shading);
            const auto slow = sampled(all, shading);
            pixel_mixer mixer;
            mixer.draw(all.fragments, shading, {}, false, size.height);
            const auto fast = mixer.words();
            ASSERT_EQ(fast.size(), slow.size());
            double largest = 0, squares = 0;
            for (std::size_t i = 0; i < fast.size(); ++i) {
                const double off =
                    std::abs(l3d_light_of_level(fast[i] & 255) - l3d_light_of_level(slow[i] & 255));
                largest = std::max(largest, off);
                squares += off * off;
            }
            const double rms = std::sqrt(squares / static_cast<double>(fast.size()));
            const auto by_samples = mixer.take_sampled();
            EXPECT_GT(by_samples, 40);
            EXPECT_LT(by_samples, static_cast<std::int64_t>(fast.size()) / 2);
            EXPECT_LT(largest, 0.07);
            EXPECT_LT(rms, 0.0034);
        }
}

/// The same surface without a grid.
l3d_surface_part facets_of(const l3d_surface_part& part) {
    l3d_surface_part result;
    result.triangles = part.triangles;
    for (int row = 0; row + 1 < part.grid.rows; ++row)
        for (int column = 0; column + 1 < part.grid.columns; ++column) {
            const auto at = [&](int down, int right) {
                return part.grid.vertex(part.grid.index(row + down, column + right));
            };
            result.triangles.add(at(0, 0), at(0, 1), at(1, 1));
            result.triangles.add(at(0, 0), at(1, 1), at(1, 0));
        }
    return result;
}

/// Of facets in one place the first is seen, whichever way the others turn.
TEST(PixelMixer, ShowsFacetsInOnePlaceOnce) {
    const l3d_shading shading = scene_shading(l3d_shade::gouraud);
    const auto words_of = [&](const surface_parts& scene) {
        const all_fragments all(scene, shading);
        pixel_mixer mixer;
        mixer.draw(all.fragments, shading, {}, false, size.height);
        return std::vector(mixer.words().begin(), mixer.words().end());
    };
    for (unsigned n = 0; n < 4; ++n) {
        surface_parts once;
        for (const l3d_surface_part& part : random_scene(scene_seed + n, size, 6))
            once.push_back(facets_of(part));
        surface_parts thrice = once;
        thrice.insert(thrice.end(), once.begin(), once.end());
        for (l3d_surface_part part : once) {
            for (l3d_micro_triangles::block& block : part.triangles.blocks)
                std::swap(block[0], block[1]);
            thrice.push_back(part);
        }
        EXPECT_EQ(words_of(thrice), words_of(once)) << n;
    }
}

using triangle = std::array<l3d_micro_vertex, 3>;

/// Whether a triangle and a pixel's square have an area in common. If not, a side of one of them
/// lies between both.
bool reaches_into(const triangle& corners, band_fragments::pixel pixel) {
    constexpr std::int64_t one = l3d_subpixel_one;
    const std::int64_t left = pixel.x * one, top = pixel.y * one;
    const auto apart = [&](std::int64_t nx, std::int64_t ny) {
        std::int64_t low = std::numeric_limits<std::int64_t>::max(), high = -low;
        for (const l3d_micro_vertex& v : corners) {
            low = std::min(low, nx * (v.x - left) + ny * (v.y - top));
            high = std::max(high, nx * (v.x - left) + ny * (v.y - top));
        }
        const std::int64_t least =
            one * (std::min<std::int64_t>(nx, 0) + std::min<std::int64_t>(ny, 0));
        const std::int64_t most =
            one * (std::max<std::int64_t>(nx, 0) + std::max<std::int64_t>(ny, 0));
        return high <= least || low >= most;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const l3d_micro_vertex &a = corners[i], &b = corners[(i + 1) % 3];
        if (apart(a.y - b.y, b.x - a.x))
            return false;
    }
    return !apart(1, 0) && !apart(0, 1);
}

/// Needles from side to side have pairs in proportion to their length, not to their boxes.
TEST(BandFragments, PairNeedlesWithThePixelsThatTheyReach) {
    random_polygons random(scene_seed, size);
    int wide = 0;
    for (int n = 0; n < 300; ++n) {
        const auto place = [&](int reach) {
            return std::array{random.number(0, 256 * size.width),
                              random.number(0, 256 * size.height), random.number(-reach, reach),
                              random.number(-reach, reach)};
        };
        // Every third one is level or upright.
        const auto from = place(n % 2 == 0 ? 300 : 6000), to = place(0);
        const int to_x = n % 3 == 1 ? from[0] : to[0], to_y = n % 3 == 2 ? from[1] : to[1];
        const triangle corners{
            l3d_micro_vertex{from[0], from[1], 0.5f, {0, 0, 1}},
            l3d_micro_vertex{to_x, to_y, 0.5f, {0, 0, 1}},
            l3d_micro_vertex{from[0] + from[2], from[1] + from[3], 0.5f, {0, 0, 1}}};
        l3d_surface_part part;
        part.triangles.add(corners[0], corners[1], corners[2]);
        const all_fragments all({part}, scene_shading(l3d_shade::gouraud));
        const band_fragments& band = all.fragments;
        std::size_t reached = 0;
        for (std::size_t i = 0; i < band.pixels().size(); ++i) {
            const bool is_paired = band.begin_of(i) < band.begin_of(i + 1);
            const bool reaches = reaches_into(corners, band.pixels()[i]);
            EXPECT_TRUE(is_paired || !reaches || band.polygons().empty())
                << n << ' ' << band.pixels()[i].x << ' ' << band.pixels()[i].y;
            reached += reaches ? 1 : 0;
        }
        // A row may have a pixel more on either side. Narrow boxes are paired whole.
        const auto [first, last] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
        if (std::min(last, 256 * size.width) - std::max(first, 0) > 33 * 256) {
            ++wide;
            EXPECT_LE(band.pairs().size(), reached + 2u * size.height) << n;
        }
    }
    EXPECT_GT(wide, 100);
}

} // namespace
