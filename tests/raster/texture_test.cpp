// SPDX-License-Identifier: MIT
// l3d_texture: each filter against what it is said to do, and its error on slanted planes.
#include "raster/textures/texture.h"

#include "raster/color/srgb_light.h"
#include "tool_2d/image.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

using filter = l3d_texture_filter;

constexpr std::array filters{filter::nearest, filter::bilinear, filter::trilinear,
                             filter::anisotropic};

/// A picture of the program's: word(x, y).
template <class Word> l3d_image picture_of(l3d_size size, const Word& word) {
    l3d_image image(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            image.pixels().row(y)[static_cast<std::size_t>(x)] = word(x, y);
    return image;
}

double light(std::uint32_t word, int channel) {
    return l3d_light_of_level(double(word >> (16 - 8 * channel) & 255));
}

double level(const l3d_light_color& of, int channel) {
    return l3d_level_of_light(double(of[static_cast<std::size_t>(channel)]));
}

/// The error of a channel's root of 11 or 10 bits, in levels.
double most_off(int channel) {
    return channel == 2 ? 0.2 : 0.1;
}

std::uint32_t random_word(int x, int y) {
    std::mt19937 random(static_cast<unsigned>(1000 * x + y));
    return static_cast<std::uint32_t>(random() & 0xffffff);
}

/// A place whose pixel covers `width` by `height` of the picture's.
l3d_texture_place place(double u, double v, double width, double height, l3d_size of) {
    return {.u = u, .v = v, .u_right = width / of.width, .v_down = height / of.height};
}

TEST(texture, shows_its_own_pixels_at_their_middles) {
    constexpr l3d_size size{5, 3};
    l3d_image image = picture_of(size, random_word);
    const l3d_texture texture(image.pixels());
    EXPECT_EQ(texture.size(), size);
    for (const filter f : filters)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const auto seen = texture.light(
                    f, place((x + 0.5) / size.width + 2, (y + 0.5) / size.height - 3, 1, 1, size));
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(level(seen, c), double(random_word(x, y) >> (16 - 8 * c) & 255),
                                most_off(c));
            }
}

TEST(texture, goes_on_beyond_its_borders_as_said) {
    constexpr l3d_size size{2, 2};
    l3d_image image = picture_of(size, [](int x, int y) {
        return x == 0 ? 0xff0000U : y == 0 ? 0x00ff00U : 0x0000ffU;
    });
    const l3d_texture texture(image.pixels(), l3d_texture_wrap::clamp, l3d_texture_wrap::repeat);
    const auto seen = [&](filter f, double u, double v) {
        return texture.light(f, place(u, v, 1, 1, size));
    };
    for (const filter f : filters) {
        EXPECT_EQ(seen(f, -7.3, 0.25), (l3d_light_color{1, 0, 0}));
        EXPECT_EQ(seen(f, 1.2, 0.25), (l3d_light_color{0, 1, 0}));
        EXPECT_EQ(seen(f, 1.2, -0.25), (l3d_light_color{0, 0, 1}));
        EXPECT_EQ(seen(f, 1, 4.25), (l3d_light_color{0, 1, 0}));
    }
    // Half-way, the border of one side meets that of the other.
    EXPECT_EQ(seen(filter::bilinear, 1, 0), (l3d_light_color{0, 0.5F, 0.5F}));
    EXPECT_EQ(seen(filter::bilinear, 0.5, 0.25), (l3d_light_color{0.5F, 0.5F, 0}));
}

/// Its last picture is the mean of all, also where sizes are odd: light adds up.
TEST(texture, is_its_mean_from_afar) {
    for (const l3d_size size : {l3d_size{7, 5}, l3d_size{1, 9}, l3d_size{64, 3}}) {
        l3d_image image = picture_of(size, random_word);
        const l3d_texture texture(image.pixels());
        for (int c = 0; c < 3; ++c) {
            double mean = 0;
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    mean += light(random_word(x, y), c) / (size.width * size.height);
            for (const filter f : {filter::trilinear, filter::anisotropic})
                EXPECT_NEAR(level(texture.light(f, place(0.3, 0.8, 1e6, 1e6, size)), c),
                            l3d_level_of_light(mean), most_off(c));
        }
    }
}

TEST(texture, of_round_parts_is_the_same_by_trilinear_and_anisotropic) {
    constexpr l3d_size size{64, 64};
    l3d_image image = picture_of(size, random_word);
    const l3d_texture texture(image.pixels());
    for (const double width : {0.1, 1.0, 1.5, 2.0, 5.0, 100.0}) {
        const double c = std::cos(0.3) * width / 64, s = std::sin(0.3) * width / 64;
        const l3d_texture_place turned{0.4, 0.7, c, s, -s, c};
        const auto a = texture.light(filter::trilinear, turned);
        const auto b = texture.light(filter::anisotropic, turned);
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(double(a[i]), double(b[i]), 1e-5) << width;
    }
}

/// A floor that is seen at an angle, and the exact place of each point of the picture on it.
struct floor_view {
    double angle; ///< between the line of sight and the floor, in degrees

    /// The eye is 1 away from the floor at the middle of the picture, which is 2 wide there.
    std::array<double, 2> at(double x, double y) const {
        const double slope = angle * std::acos(-1.0) / 180;
        const double distance = 1 / (1 - y / std::tan(slope)); // along the line of sight
        return {x * distance, (distance - 1) * std::cos(slope) + distance * y * std::sin(slope)};
    }
};

/// The error of a filter over a picture of 64 x 48, root of the mean square in levels of 255.
double error_of(const l3d_texture& texture, l3d_image& image, const floor_view& view, filter f,
                double pictures) {
    std::array<double, 256> lights;
    for (std::size_t level = 0; level < lights.size(); ++level)
        lights[level] = l3d_light_of_level(double(level));
    constexpr int width = 64, height = 48, side = 16;
    const l3d_size size = texture.size();
    double sum = 0;
    int count = 0;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const auto on_floor = [&](double dx, double dy) {
                // A fifth of the view: so even the flattest floor has no horizon in it.
                const auto p = view.at((column + dx - width / 2.0) / (width / 2.0) / 5,
                                       (height / 2.0 - row - dy) / (width / 2.0) / 5);
                return std::array{p[0] * pictures, p[1] * pictures};
            };
            std::array<double, 3> mean{};
            for (int i = 0; i < side * side; ++i) {
                const auto p = on_floor((i % side + 0.5) / side, (i / side + 0.5) / side);
                const auto pixel = [](double at, int of) {
                    return std::min(static_cast<int>((at - std::floor(at)) * of), of - 1);
                };
                const std::uint32_t word = image.pixels().row(
                    pixel(p[1], size.height))[static_cast<std::size_t>(pixel(p[0], size.width))];
                for (int c = 0; c < 3; ++c)
                    mean[static_cast<std::size_t>(c)] +=
                        lights[word >> (16 - 8 * c) & 255] / (side * side);
            }
            constexpr double step = 1e-4;
            const auto p = on_floor(0.5, 0.5), right = on_floor(0.5 + step, 0.5),
                       down = on_floor(0.5, 0.5 + step);
            const auto seen =
                texture.light(f, {p[0], p[1], (right[0] - p[0]) / step, (right[1] - p[1]) / step,
                                  (down[0] - p[0]) / step, (down[1] - p[1]) / step});
            for (std::size_t c = 0; c < 3; ++c) {
                const double off =
                    l3d_level_of_light(double(seen[c])) - l3d_level_of_light(mean[c]);
                sum += off * off;
                ++count;
            }
        }
    return std::sqrt(sum / count);
}

/// The means of 256 samples of each pixel are the truth. Most of what is left is the blur that
/// four pixels, and half sizes, make of the picture.
TEST(texture, errs_by_so_many_levels_on_slanted_planes) {
    struct row {
        double angle;
        std::array<double, 4> most; ///< for each filter
    };
    l3d_image image = picture_of({128, 128}, [](int x, int y) {
        const bool odd = ((x / 8) + (y / 8)) % 2 != 0;
        const double wave = 0.5 + 0.5 * std::sin(0.2 * x) * std::cos(0.15 * y);
        const auto level = static_cast<std::uint32_t>(255 * wave);
        return odd ? level << 16 | (255 - level) << 8 | 40 : 0x203050U;
    });
    const l3d_texture texture(image.pixels());
    const std::array rows{row{90, {35, 35, 12, 12}}, row{45, {40, 36, 15, 10}},
                          row{20, {52, 48, 18, 6.5}}, row{10, {55, 52, 14.5, 4.5}}};
    for (const row& r : rows) {
        for (std::size_t i = 0; i < filters.size(); ++i) {
            const double error = error_of(texture, image, {r.angle}, filters[i], 7.5);
            const std::string name = l3d_texture_filter_names[i].first;
            EXPECT_LE(error, r.most[i]) << r.angle << ' ' << name;
            RecordProperty(name + "_" + std::to_string(static_cast<int>(r.angle)),
                           std::to_string(error));
        }
    }
}

} // namespace
