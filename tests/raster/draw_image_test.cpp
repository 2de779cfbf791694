// SPDX-License-Identifier: MIT
// draw_image: each filter against its rule in long double, areas against the image's squares.
#include "raster/canvas_2d.h"
#include "raster/placement_2d.h"
#include "raster/paths/path.h"
#include "raster/slow_area.h"
#include "raster/slow_light.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace {

constexpr int width = 15, height = 11;

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// An image with words between its rows that must not be read.
struct test_image {
    int width, height;
    std::vector<std::uint32_t> words;

    test_image(std::mt19937& random, int w, int h)
        : width(w), height(h), words(std::size_t(w + 2) * std::size_t(h), 0x00ff00ff) {
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x)
                at(x, y) = static_cast<std::uint32_t>(random());
    }
    std::uint32_t& at(int x, int y) {
        return words[std::size_t(y) * std::size_t(width + 2) + std::size_t(x)];
    }
    l3d_pixels pixels() { return {words.data(), width, height, width + 2}; }
};

/// Turned, mirrored, enlarged, shrunk, upright, on pixels' borders, and far away.
l3d_placement_2d random_place(std::mt19937& random) {
    const double size = std::pow(10, uniform(random, -1, 0.7));
    l3d_placement_2d place{{uniform(random, -3, width + 1), uniform(random, -3, height + 1)},
                           {uniform(random, -size, size), uniform(random, -size, size)},
                           {uniform(random, -size, size), uniform(random, -size, size)}};
    const auto manner = random() % 6;
    if (manner < 2) {
        place.across.y = place.down.x = 0;
        if (manner == 0) {
            const auto halves = [](double& x) { x = std::round(x * 2) / 2; };
            halves(place.origin.x);
            halves(place.origin.y);
            halves(place.across.x);
            halves(place.down.y);
        }
    } else if (manner == 2) {
        place.down = {-place.across.y, place.across.x};
    } else if (manner == 3) {
        const l3d_point_2d middle{width / 2.0, height / 2.0};
        place = l3d_placement_2d::moved(double(random() % 9), double(random() % 6))
                    .then(l3d_placement_2d::turned(90.0 * double(random() % 4), middle));
    }
    return place;
}

/// The squares of an image, as outlines in the picture.
std::vector<l3d_point_2d> square(const l3d_placement_2d& place, double left, double top,
                                 double right, double bottom) {
    return {place.at({left, top}), place.at({right, top}), place.at({right, bottom}),
            place.at({left, bottom})};
}

/// What is mixed into a pixel: amounts of red, green and blue, and how much of the pixel they
/// cover.
struct exact_color {
    std::array<long double, 3> values{};
    long double opacity = 0;
    void add(std::uint32_t word, long double times, bool transparent, l3d_blending how) {
        const long double shown =
            times * (transparent ? 1 - static_cast<long double>(word >> 24) / 255 : 1);
        for (int k = 0; k < 3; ++k)
            values[std::size_t(k)] +=
                shown * slow_light::amount(how, slow_light::channel(word, 16 - 8 * k));
        opacity += shown;
    }
};

/// A pixel that was `before` and should have the color in `share` of it, to within `off` levels of
/// share.
void expect_mixed(std::uint32_t before, std::uint32_t after, const exact_color& color,
                  long double share, long double share_off, l3d_blending how, int n) {
    for (int k = 0; k < 3; ++k) {
        const int shift = 16 - 8 * k;
        const auto level_with = [&](long double s) {
            const long double amount = slow_light::amount(how, slow_light::channel(before, shift)) *
                                           (1 - color.opacity * s) +
                                       color.values[std::size_t(k)] * s;
            return slow_light::level(
                how, std::clamp<long double>(amount, 0, slow_light::amount(how, 255)));
        };
        const long double a = level_with(share - share_off), b = level_with(share + share_off);
        const int got = slow_light::channel(after, shift);
        ASSERT_GE(got, static_cast<double>(std::min(a, b)) - 0.5 - 1e-6) << "image " << n;
        ASSERT_LE(got, static_cast<double>(std::max(a, b)) + 0.5 + 1e-6) << "image " << n;
    }
}

struct drawn_image {
    test_image image;
    l3d_placed_image placed;
    l3d_fill fill;
    l3d_path clip;
    slow_area::shape clip_shape;

    drawn_image(std::mt19937& random, l3d_image_filter filter, int n)
        : image(random, 1 + static_cast<int>(random() % 6), 1 + static_cast<int>(random() % 5)) {
        placed = {image.pixels(), random_place(random), filter, n % 3 == 0};
        fill.alpha = n % 4 == 0 ? 1 : uniform(random, 0, 1);
        fill.blending = n % 2 == 0 ? l3d_blending::coded : l3d_blending::linear;
        if (n % 5 == 0)
            fill.box = {2, 1, 11, 8};
        if (n % 7 == 0) {
            std::vector<l3d_point_2d> corners(5);
            for (l3d_point_2d& p : corners)
                p = {uniform(random, -2, width), uniform(random, -2, height)};
            clip.add_polygon(corners);
            clip_shape.outlines = {corners};
            fill.clip = &clip;
        }
    }
    bool in_box(int x, int y) const {
        return x >= fill.box.left && x < fill.box.right && y >= fill.box.top && y < fill.box.bottom;
    }
};

/// What was there before, row by row.
std::vector<std::uint32_t> noise(std::mt19937& random) {
    std::vector<std::uint32_t> words(std::size_t{width} * height);
    for (std::uint32_t& word : words)
        word = static_cast<std::uint32_t>(random()) & 0x00ffffff;
    return words;
}

std::uint32_t word_of(const std::vector<std::uint32_t>& words, int x, int y) {
    return words[std::size_t(y) * width + std::size_t(x)];
}

void put(canvas& c, const std::vector<std::uint32_t>& words) {
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            c.at(x, y) = word_of(words, x, y);
}

/// A share is rounded to 1/255, before alpha.
constexpr long double share_rounding = (0.5L + 1e-6L) / 255;

TEST(draw_image, has_the_mean_of_the_squares_that_lie_in_each_pixel) {
    std::mt19937 random(1);
    std::size_t inner = 0;
    for (int n = 0; n < 400; ++n) {
        drawn_image d(random, l3d_image_filter::area, n);
        const auto before = noise(random);
        canvas after(width, height);
        put(after, before);
        after.draw.draw_image(d.placed, d.fill);
        ASSERT_TRUE(after.guards_intact());
        std::vector<slow_area::picture> squares;
        for (int j = 0; j < d.image.height; ++j)
            for (int i = 0; i < d.image.width; ++i)
                squares.emplace_back(std::vector<slow_area::shape>{
                    {{square(d.placed.place, i - 0.5, j - 0.5, i + 0.5, j + 0.5)},
                     l3d_winding::nonzero}});
        std::vector<slow_area::shape> shapes{
            {{square(d.placed.place, -0.5, -0.5, d.image.width - 0.5, d.image.height - 0.5)},
             l3d_winding::nonzero}};
        if (d.fill.clip != nullptr)
            shapes.push_back(d.clip_shape);
        const slow_area::picture all(shapes);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const std::uint32_t was = word_of(before, x, y);
                const long double share = d.in_box(x, y) ? all.share(x, y) : 0;
                exact_color color;
                long double total = 0;
                for (std::size_t k = 0; share > 0 && k < squares.size(); ++k)
                    if (const long double part = squares[k].share(x, y); part > 0) {
                        const int i = static_cast<int>(k) % d.image.width;
                        const int j = static_cast<int>(k) / d.image.width;
                        color.add(d.image.at(i, j), part, d.placed.transparent, d.fill.blending);
                        total += part;
                    }
                if (total <= 1e-9L) {
                    ASSERT_EQ(after.at(x, y), was) << n;
                    continue;
                }
                for (long double& value : color.values)
                    value /= total;
                color.opacity /= total;
                const bool whole = share > 1 - 1e-9L;
                inner += whole;
                expect_mixed(was, after.at(x, y), color, share * d.fill.alpha,
                             whole ? 0 : share_rounding * d.fill.alpha, d.fill.blending, n);
                if (::testing::Test::HasFatalFailure())
                    return;
            }
    }
    EXPECT_GT(inner, 1000u);
}

/// Samples on a side, up to rounding, may go either way.
TEST(draw_image, has_the_pixel_of_the_image_that_holds_each_sample_and_those_around_it) {
    std::mt19937 random(2);
    std::size_t seen = 0, on_a_side = 0;
    for (int n = 0; n < 1200; ++n) {
        const bool nearest = n % 3 != 1;
        drawn_image d(random, nearest ? l3d_image_filter::nearest : l3d_image_filter::linear, n);
        const auto before = noise(random);
        canvas after(width, height);
        put(after, before);
        after.draw.draw_image(d.placed, d.fill);
        ASSERT_TRUE(after.guards_intact());
        const l3d_placement_2d& p = d.placed.place;
        const long double det = static_cast<long double>(p.across.x) * p.down.y -
                                static_cast<long double>(p.across.y) * p.down.x;
        std::vector<slow_area::shape> shapes;
        if (!nearest)
            shapes.push_back({{square(p, -0.5, -0.5, d.image.width - 0.5, d.image.height - 0.5)},
                              l3d_winding::nonzero});
        if (d.fill.clip != nullptr)
            shapes.push_back(d.clip_shape);
        const slow_area::picture all(shapes);
        for (int y = 0; y < height && det != 0; ++y)
            for (int x = 0; x < width; ++x) {
                const std::uint32_t was = word_of(before, x, y);
                const long double dx = static_cast<long double>(x) - p.origin.x;
                const long double dy = static_cast<long double>(y) - p.origin.y;
                const long double u = (dx * p.down.y - dy * p.down.x) / det;
                const long double v = (dy * p.across.x - dx * p.across.y) / det;
                const long double share = !d.in_box(x, y)  ? 0
                                          : shapes.empty() ? 1
                                                           : all.share(x, y);
                exact_color color;
                if (nearest) {
                    const long double i = std::floor(u + 0.5L), j = std::floor(v + 0.5L);
                    const auto is_near = [](long double place) {
                        const long double off = place + 0.5L - std::round(place + 0.5L);
                        return off != 0 && std::abs(off) < 1e-12L;
                    };
                    if (is_near(u) || is_near(v)) {
                        ++on_a_side;
                        continue;
                    }
                    if (i >= 0 && j >= 0 && i < d.image.width && j < d.image.height)
                        color.add(d.image.at(static_cast<int>(i), static_cast<int>(j)), 1,
                                  d.placed.transparent, d.fill.blending);
                } else {
                    const auto weight = [](long double place, int i, int size) {
                        const long double held =
                            std::clamp<long double>(place, 0, static_cast<long double>(size - 1));
                        return std::max(0.0L, 1 - std::abs(held - i));
                    };
                    for (int j = 0; j < d.image.height; ++j)
                        for (int i = 0; i < d.image.width; ++i)
                            color.add(d.image.at(i, j),
                                      weight(u, i, d.image.width) * weight(v, j, d.image.height),
                                      d.placed.transparent, d.fill.blending);
                }
                const bool whole = share > 1 - 1e-9L || share == 0;
                seen += whole && share > 0 && color.opacity > 0;
                expect_mixed(was, after.at(x, y), color, share * d.fill.alpha,
                             whole ? 0 : share_rounding * d.fill.alpha, d.fill.blending, n);
                if (::testing::Test::HasFatalFailure())
                    return;
            }
    }
    EXPECT_GT(seen, 3500u);
    EXPECT_LT(on_a_side, 500u);
}

TEST(draw_image, moved_by_whole_pixels_is_the_image_itself_with_every_filter) {
    std::mt19937 random(3);
    for (const auto filter :
         {l3d_image_filter::nearest, l3d_image_filter::linear, l3d_image_filter::area})
        for (const auto blending : {l3d_blending::coded, l3d_blending::linear})
            for (int n = 0; n < 60; ++n) {
                test_image image(random, 5, 4);
                const int left = static_cast<int>(random() % 20) - 4;
                const int top = static_cast<int>(random() % 15) - 3;
                const auto place = l3d_placement_2d::moved(left, top);
                auto expected = noise(random);
                canvas copied(width, height), mixed(width, height);
                put(copied, expected);
                put(mixed, expected);
                copied.draw.draw_image({image.pixels(), place, filter}, {.blending = blending});
                // a clip path around everything takes the slow way
                l3d_path clip;
                clip.add_circle({width / 2.0, height / 2.0}, 100);
                mixed.draw.draw_image({image.pixels(), place, filter},
                                      {.clip = &clip, .blending = blending});
                for (int y = 0; y < height; ++y)
                    for (int x = 0; x < width; ++x) {
                        const int i = x - left, j = y - top;
                        if (i >= 0 && i < 5 && j >= 0 && j < 4)
                            expected[std::size_t(y) * width + std::size_t(x)] =
                                image.at(i, j) & 0x00ffffff;
                        ASSERT_EQ(copied.at(x, y), word_of(expected, x, y)) << n;
                        ASSERT_EQ(mixed.at(x, y), word_of(expected, x, y)) << n;
                    }
                ASSERT_TRUE(copied.guards_intact() && mixed.guards_intact());
            }
}

/// An image cut in two, each part drawn by itself, is the image: no crack, no double hit.
TEST(draw_image, fits_into_a_box_to_its_borders) {
    std::mt19937 random(4);
    test_image image(random, 3, 2);
    canvas c(width, height);
    c.draw.draw_image({image.pixels(), l3d_placement_2d::image_in_box({3, 2}, 2, 3, 9, 4)});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool inside = x >= 2 && x < 11 && y >= 3 && y < 7;
            EXPECT_EQ(c.at(x, y), inside ? image.at((x - 2) / 3, (y - 3) / 2) & 0x00ffffff : 0u);
        }
}

TEST(draw_image, draws_nothing_without_area_or_pixels_or_numbers) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::mt19937 random(5);
    test_image image(random, 5, 4);
    canvas c(width, height);
    for (const auto filter :
         {l3d_image_filter::nearest, l3d_image_filter::linear, l3d_image_filter::area}) {
        for (const double odd : {nan, infinity, -infinity, 1e300, 0.0, 1e-320}) {
            c.draw.draw_image({image.pixels(), {{2, 2}, {odd, 0}, {0, 1}}, filter});
            c.draw.draw_image({image.pixels(), {{2, 2}, {odd, 1}, {odd, 1}}, filter});
            if (odd != 0 && odd != 1e-320)
                c.draw.draw_image({image.pixels(), {{odd, 2}, {1, 0}, {0, 1}}, filter});
        }
        c.draw.draw_image({image.pixels(), {{2, 2}, {1, 2}, {2, 4}}, filter});
        c.draw.draw_image({{nullptr, 0, 0, 0}, {}, filter});
        c.draw.draw_image({image.pixels(), {}, filter}, {.alpha = 0});
        c.draw.draw_image({image.pixels(), {}, filter}, {.box = {5, 5, 5, 9}});
    }
    EXPECT_TRUE(c.lit().empty());
    EXPECT_TRUE(c.guards_intact());
}

/// A large image in a small place: all of it counts; a small one in a large place, too.
TEST(draw_image, of_any_size_fits) {
    std::vector<std::uint32_t> words(std::size_t{1000} * 800);
    for (std::size_t i = 0; i < words.size(); ++i)
        words[i] = i % 1000 < 500 ? 0x00c80000 : 0x00006400;
    canvas c(2, 1);
    c.draw.draw_image(
        {{words.data(), 1000, 800, 1000}, l3d_placement_2d::image_in_box({1000, 800}, 0, 0, 2, 1)});
    EXPECT_EQ(c.at(0, 0), 0x00c80000u);
    EXPECT_EQ(c.at(1, 0), 0x00006400u);
    words[0] = 0x000000ff;
    c.draw.draw_image({{words.data(), 1, 1, 1}, {{0, 0}, {1e8, 3e7}, {-2e7, 1e8}}});
    EXPECT_EQ(c.at(0, 0), 0x000000ffu);
}

} // namespace
