// SPDX-License-Identifier: MIT
// The samples that polygons have in pixels, and what is seen of them.
#include "raster/refine/band_fragments_p.h"
#include "raster/refine/picture_refiner_p.h"
#include "raster/refine/sample_places_p.h"
#include "surface_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
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
    l3d_pixel_bits bits;
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
        begin(window, static_cast<std::size_t>(bits.count()));
        add(shading);
    }

    std::int32_t begin(const l3d_pixel_box& box, std::size_t most) {
        return fragments.begin(bits, drawn_depth(nullptr, 0, l3d_whole(size), coarse), box, most);
    }

    void add(const l3d_shading& shading) {
        fragments.use_colors({}, false);
        for (const std::uint32_t index : list.items(0))
            fragments.add(list, list.item(index), shading.mode == l3d_shade::levels);
    }
};

/// How far a place lies inside of a polygon's sides, in the measure of half_planes; less than 0 if
/// it is outside. Units: pixels; places in 1/256 pixel.
double inside_by(const fragment_polygon& of, std::int64_t x, std::int64_t y) {
    const std::int64_t way_round = of.area2 > 0 ? 1 : -1;
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        const std::int64_t dx = way_round * (of.x[next] - of.x[i]);
        const std::int64_t dy = way_round * (of.y[next] - of.y[i]);
        const std::int64_t right = dx * (y - of.y[i]) - dy * (x - of.x[i]);
        if (dx != 0 || dy != 0)
            least = std::min(least, static_cast<double>(right) /
                                        (256.0 * static_cast<double>(std::abs(dx) + std::abs(dy))));
    }
    return least;
}

double inside_by(const fragment_polygon& of, const marked_pixel& pixel, std::size_t sample) {
    return inside_by(of, 256 * pixel.x + 16 * the_samples.x[sample] + 8,
                     256 * pixel.y + 16 * the_samples.y[sample] + 8);
}

/// Half a step in direction moves a line by 1/128 at the ends of a pixel, and half a step of the
/// distance is 1/252.
constexpr double most_moved = 1.0 / 128 + 1.0 / 252 + 1e-3;

fragment_polygon polygon_of(const std::array<l3d_micro_vertex, 3>& corners) {
    fragment_polygon result{};
    const auto& [a, b, c] = corners;
    result.set({a, b, c, c}, 3, twice_area(a, b, c));
    result.set_plane();
    return result;
}

/// The samples of each of some polygons in all pixels of a picture.
struct masks {
    marked_pixels pixels;
    std::vector<fragment> fragments;

    masks(std::span<const fragment_polygon> polygons, l3d_size of) {
        const l3d_pixel_box window = l3d_whole(of);
        coarse_depth coarse;
        coarse.resize(of);
        coarse.forget(0, of.height); // so that nothing counts as hidden
        l3d_pixel_bits bits;
        bits.resize(of);
        bits.clear(0, of.height);
        for (int y = 0; y < of.height; ++y)
            for (int x = 0; x < of.width; ++x)
                bits.set(x, y);
        pixels.begin(bits, drawn_depth(nullptr, 0, window, coarse), window,
                     static_cast<std::size_t>(bits.count()));
        for (const fragment_polygon& p : polygons) {
            const std::size_t first = fragments.size();
            fragments.resize(first + pixels.pixels().size() + 1);
            fragments.resize(first + cover_samples(p, name++, window, pixels,
                                                   fragments.data() + first,
                                                   static_cast<std::uint32_t>(first)));
        }
    }

    std::uint64_t of(const marked_pixel& pixel, std::uint32_t polygon) const {
        for (std::uint32_t at = pixel.last; at != fragment::none; at = fragments[at].before)
            if (fragments[at].polygon == polygon)
                return fragments[at].samples;
        return 0;
    }

    std::uint32_t name = 0;
};

TEST(PixelSamples, AreInPolygonsButForThoseAtTheirSides) {
    random_polygons random(scene_seed, size);
    for (int n = 0; n < 400; ++n) {
        std::array<l3d_micro_vertex, 3> corners;
        for (l3d_micro_vertex& v : corners)
            v = {random.number(0, 1000), random.number(0, 1000), 1, {}};
        const fragment_polygon polygon = polygon_of(corners);
        if (polygon.area2 == 0)
            continue;
        const masks all(std::span(&polygon, 1), {5, 5});
        for (const marked_pixel& pixel : all.pixels.pixels())
            for (std::size_t i = 0; i < the_samples.count; ++i) {
                const double by = inside_by(polygon, pixel, i);
                if (std::abs(by) > most_moved) {
                    ASSERT_EQ(all.of(pixel, 0) >> i & 1, by > 0)
                        << n << ", pixel " << pixel.x << ", " << pixel.y << ", sample " << i;
                }
            }
    }
}

/// A fan of triangles round a point, of any size. Each sample belongs to exactly one of them, but
/// for few in the pixel of the point: lines that are moved do not meet in one place.
TEST(PixelSamples, BelongToExactlyOneOfTwoNeighbours) {
    random_polygons random(scene_seed, size);
    constexpr l3d_size around{40, 40};
    std::size_t samples = 0, of_another = 0;
    for (int n = 0; n < 300; ++n) {
        const int reach = 256 * 120 << n % 7;
        const l3d_micro_vertex middle{
            random.number(0, 256 * 40), random.number(0, 256 * 40), 1, {}};
        const auto beside = [&](int x, int y) {
            return l3d_micro_vertex{middle.x + x * reach + random.number(-reach / 2, reach / 2),
                                    middle.y + y * reach + random.number(-reach / 2, reach / 2),
                                    1,
                                    {}};
        };
        const std::array v{beside(-1, -1), beside(1, -1), beside(1, 1), beside(-1, 1)};
        std::array<fragment_polygon, 4> fan;
        for (std::size_t i = 0; i < 4; ++i) {
            std::array corners{v[i], v[(i + 1) % 4], middle};
            std::rotate(corners.begin(), corners.begin() + n % 3, corners.end());
            if (random.number(0, 1) == 0)
                std::swap(corners[0], corners[1]);
            fan[i] = polygon_of(corners);
        }
        const masks all(fan, around);
        for (const marked_pixel& pixel : all.pixels.pixels()) {
            std::uint64_t any = 0, twice = 0;
            for (std::uint32_t i = 0; i < 4; ++i) {
                const std::uint64_t of = all.of(pixel, i);
                twice |= any & of;
                any |= of;
                for (std::size_t k = 0; k < the_samples.count; ++k)
                    of_another += (of >> k & 1) != 0 && inside_by(fan[i], pixel, k) < -most_moved;
            }
            const bool has_middle = std::abs(256 * pixel.x + 128 - middle.x) <= 128 + 4 &&
                                    std::abs(256 * pixel.y + 128 - middle.y) <= 128 + 4;
            ASSERT_LE(std::popcount(~any | twice), has_middle ? 2 : 0)
                << n << ": " << pixel.x << ", " << pixel.y;
            samples += the_samples.count;
        }
    }
    EXPECT_LT(of_another, samples / 10000);
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
TEST(PixelSamples, ShowFacetsInOnePlaceOnce) {
    const l3d_shading shading = scene_shading(l3d_shade::gouraud);
    const auto words_of = [&](const surface_parts& scene) {
        const all_fragments all(scene, shading);
        surface_picture picture(size.width, size.height, 1);
        light_pixels(all.fragments, shading, {}, false, picture.pixels());
        return picture.words;
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

/// A picture that is drawn slice by slice is the same, and its slices hold all of its rows.
TEST(BandFragments, ShowTheSameInSlices) {
    const l3d_shading shading = scene_shading(l3d_shade::gouraud);
    const surface_parts scene = random_scene(scene_seed, size, 6);
    surface_picture whole(size.width, size.height, 1), sliced(size.width, size.height, 1);
    all_fragments all(scene, shading);
    light_pixels(all.fragments, shading, {}, false, whole.pixels());
    int slices = 0;
    for (l3d_pixel_box rest = l3d_whole(size); !rest.empty(); ++slices) {
        rest.top = all.begin(rest, 1500);
        all.add(shading);
        light_pixels(all.fragments, shading, {}, false, sliced.pixels());
    }
    EXPECT_EQ(slices, 5); // two rows of tiles have 2 x 8 x 101 pixels
    EXPECT_EQ(sliced.words, whole.words);
}

/// Thousands of slivers in each pixel are left out as others hide them.
TEST(BandFragments, KeepWhatIsSeenOfThousandsInAPixel) {
    l3d_surface_part part;
    random_polygons random(scene_seed, size);
    constexpr int slivers = 60000;
    for (int i = 0; i < slivers; ++i) {
        const int x = 256 * 20 + random.number(0, 1024), y = 256 * 20 + random.number(0, 1024);
        const float inv_w = 0.5f + 1e-6f * static_cast<float>(i);
        part.triangles.add({x, y, inv_w, {0, 0, 1}}, {x + 600, y + 10, inv_w, {0, 0, 1}},
                           {x, y + 60, inv_w, {0, 0, 1}});
    }
    const all_fragments all({part}, scene_shading(l3d_shade::gouraud));
    const band_fragments& band = all.fragments;
    std::size_t fragments = 0;
    band.visit_seen([&](std::size_t i, std::span<const seen_fragment> all_seen) {
        for (const seen_fragment& seen : all_seen) {
            ++fragments;
            for (std::size_t k = 0; k < the_samples.count; ++k) {
                if ((seen.samples >> k & 1) == 0)
                    continue;
                // No later one, which is nearer, has the sample.
                const fragment_polygon& nearest = band.polygon(seen);
                const auto name = std::lround((nearest.inv_w[0] - 0.5f) / 1e-6f);
                for (long later = name + 1; later < std::min<long>(name + 40, slivers); ++later) {
                    const std::array corners{part.triangles.vertex(std::size_t(later), 0),
                                             part.triangles.vertex(std::size_t(later), 1),
                                             part.triangles.vertex(std::size_t(later), 2)};
                    ASSERT_FALSE(corners[0].inv_w > nearest.inv_w[0] &&
                                 inside_by(polygon_of(corners), band.pixels()[i], k) > most_moved);
                }
            }
        }
    });
    EXPECT_GT(fragments, 500U);
    EXPECT_LT(band.kept_fragments(), std::size_t{1} << 18);
}

TEST(pixel_bits, of_some_columns_are_set_found_and_counted) {
    constexpr std::int32_t width = 200;
    for (const auto& [left, right] : {std::pair{0, 1}, {63, 65}, {5, 64}, {64, 128}, {60, 200}}) {
        l3d_pixel_bits bits, one_by_one;
        bits.begin({2 * width, 4}); // forgotten by the next
        bits.set_all(1, 0, 2 * width);
        for (l3d_pixel_bits* some : {&bits, &one_by_one})
            some->begin({width, 3});
        bits.set_all(1, left, right);
        EXPECT_FALSE(bits == one_by_one);
        for (std::int32_t x = left; x < right; ++x)
            one_by_one.set(x, 1);
        EXPECT_TRUE(bits == one_by_one);
        EXPECT_EQ(bits.count(), right - left);
        EXPECT_TRUE(bits.has_all(1, left, right));
        EXPECT_FALSE(left > 0 && bits.has_all(1, left - 1, right));
        EXPECT_FALSE(right < width && bits.has_all(1, left, right + 1));
        EXPECT_FALSE(bits.has_all(2, left, right));
    }
}

} // namespace
