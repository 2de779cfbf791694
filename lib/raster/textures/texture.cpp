// SPDX-License-Identifier: MIT
// l3d_texture: smaller pictures, and what filters take of them.
#include "raster/textures/texture.h"

#include "raster/color/linear_light_p.h"
#include "raster/textures/texture_lanes_p.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

namespace {

constexpr std::size_t channels = 4; ///< channels of a pixel in memory
constexpr float white = 65535;

/// A picture of floats while the smaller ones are made of it.
struct float_picture {
    int width = 0, height = 0;
    std::vector<float> light;

    float_picture(int of_width, int of_height)
        : width(of_width), height(of_height), light(channels * static_cast<std::size_t>(of_width) *
                                                    static_cast<std::size_t>(of_height)) {}

    float* at(int x, int y) {
        return &light[channels * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x))];
    }
};

/// Calls add(from, weight) for the pixels of `size` that one of `smaller` covers, and its share.
template <class Add> void visit_covered(int at, int smaller, int size, const Add& add) {
    // In units in which a small pixel is `size` wide and a large one `smaller`.
    const std::int64_t begin = std::int64_t{at} * size, end = begin + size;
    for (auto from = static_cast<int>(begin / smaller); std::int64_t{from} * smaller < end;
         ++from) {
        const std::int64_t left = std::max(begin, std::int64_t{from} * smaller);
        const std::int64_t right = std::min(end, (std::int64_t{from} + 1) * smaller);
        add(from, static_cast<float>(right - left) / static_cast<float>(size));
    }
}

/// The picture in half the width and height.
float_picture halved(float_picture& from) {
    float_picture across(std::max(from.width / 2, 1), from.height);
    for (int y = 0; y < across.height; ++y)
        for (int x = 0; x < across.width; ++x)
            visit_covered(x, across.width, from.width, [&](int at, float weight) {
                for (std::size_t c = 0; c < channels; ++c)
                    across.at(x, y)[c] += weight * from.at(at, y)[c];
            });
    float_picture result(across.width, std::max(from.height / 2, 1));
    for (int y = 0; y < result.height; ++y)
        visit_covered(y, result.height, across.height, [&](int at, float weight) {
            for (int x = 0; x < result.width; ++x)
                for (std::size_t c = 0; c < channels; ++c)
                    result.at(x, y)[c] += weight * across.at(x, at)[c];
        });
    return result;
}

/// A place in a picture along one axis, from 0 to 1 at its borders.
double held(double place, l3d_texture_wrap wrap) {
    switch (wrap) {
    case l3d_texture_wrap::repeat:
        return place - std::floor(place);
    case l3d_texture_wrap::mirror:
        return 1 - std::abs(1 - (place - 2 * std::floor(place / 2)));
    default:
        return std::clamp(place, 0.0, 1.0);
    }
}

/// The two pixels around a place along one axis, and the share of the second.
struct neighbours {
    std::size_t first, second;
    float share;

    neighbours(double place, int size, l3d_texture_wrap wrap) {
        // From half a pixel before the first to half a pixel behind the last.
        const double at = held(place, wrap) * size - 0.5;
        const int below = static_cast<int>(at + 1) - 1;
        share = static_cast<float>(at - below);
        const bool repeats = wrap == l3d_texture_wrap::repeat;
        first = static_cast<std::size_t>(below >= 0 ? below : repeats ? size - 1 : 0);
        second = static_cast<std::size_t>(below + 1 < size ? below + 1 : repeats ? 0 : size - 1);
    }
};

} // namespace

/// The four channels of a pixel as they add up, in a vector of the compiler's: those of Highway
/// come with code for each processor, and four numbers gain nothing from wider ones.
struct l3d_texture::sum {
    using floats = float __attribute__((vector_size(channels * sizeof(float))));
    using halves = std::uint16_t __attribute__((vector_size(channels * sizeof(std::uint16_t))));

    floats of{};

    void add(const std::uint16_t* pixel, float weight) {
        halves light;
        std::memcpy(&light, pixel, sizeof(light));
        of += __builtin_convertvector(light, floats) * weight;
    }
};

l3d_texture::l3d_texture(const l3d_pixels& picture, l3d_texture_wrap wrap_u,
                         l3d_texture_wrap wrap_v)
    : wrap_u_(wrap_u), wrap_v_(wrap_v) {
    assert(picture.width > 0 && picture.height > 0);
    const l3d_detail::linear_light& tables = l3d_detail::linear_light_tables();
    float_picture next(picture.width, picture.height);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::uint32_t word = picture.row(y)[static_cast<std::size_t>(x)];
            for (std::size_t c = 0; c < 3; ++c)
                next.at(x, y)[c] = white * tables.light(word >> (16 - 8 * c) & 255);
        }
    for (;;) {
        levels_.push_back({next.width, next.height, light_.size() / channels});
        for (const float light : next.light)
            light_.push_back(static_cast<std::uint16_t>(light + 0.5F));
        if (next.width == 1 && next.height == 1)
            return;
        next = halved(next);
    }
}

void l3d_texture::add_bilinear(std::size_t number, double u, double v, float weight,
                               sum& to) const {
    const level& of = levels_[number];
    const neighbours across(u, of.width, wrap_u_), down(v, of.height, wrap_v_);
    const std::uint16_t* const upper = pixel(of, 0, down.first);
    const std::uint16_t* const lower = pixel(of, 0, down.second);
    const float below = weight * down.share, above = weight - below;
    to.add(upper + channels * across.first, above - above * across.share);
    to.add(upper + channels * across.second, above * across.share);
    to.add(lower + channels * across.first, below - below * across.share);
    to.add(lower + channels * across.second, below * across.share);
}

/// Between two pictures the share of the smaller one grows with the width, from the one's pixels to
/// the other's. No logarithm is taken, whose last bits differ among libraries.
/// Units: the width in pixels of the whole picture.
void l3d_texture::add_trilinear(double width, double u, double v, float weight, sum& to) const {
    if (!(width > 1))
        return add_bilinear(0, u, v, weight, to);
    int exponent = 0;
    const double mantissa = std::frexp(std::min(width, 0x1p62), &exponent); // from 1/2 to 1
    const auto number = static_cast<std::size_t>(exponent - 1);
    if (number + 1 >= levels_.size())
        return add_bilinear(levels_.size() - 1, u, v, weight, to);
    const auto smaller = static_cast<float>(2 * mantissa - 1);
    add_bilinear(number, u, v, weight - weight * smaller, to);
    if (smaller > 0)
        add_bilinear(number + 1, u, v, weight * smaller, to);
}

/// A circle becomes an ellipse under the linear map from the picture's pixels to the texture's. Its
/// axes are the map's singular values, and the longer one is an eigenvector of the map times its
/// transpose.
void l3d_texture::add_anisotropic(const l3d_texture_place& place, sum& to) const {
    const double width = size().width, height = size().height;
    const double ru = place.u_right * width, rv = place.v_right * height;
    const double du = place.u_down * width, dv = place.v_down * height;
    const double uu = ru * ru + du * du, uv = ru * rv + du * dv, vv = rv * rv + dv * dv;
    const double mean = (uu + vv) / 2, area = ru * dv - rv * du;
    const double square = mean + std::sqrt(std::max(mean * mean - area * area, 0.0));
    constexpr double most = 1e30; // wider than any picture; products of more are no numbers
    if (!(square < most))
        return add_trilinear(most, place.u, place.v, 1, to);
    const double longer = std::sqrt(square), shorter = longer > 0 ? std::abs(area) / longer : 0.0;
    // A footprint that is round but for rounding has no longer axis.
    constexpr double round = 1e-3;
    const double wanted = std::ceil(longer / std::max(shorter, 1.0) - round);
    const int count = static_cast<int>(std::clamp(wanted, 1.0, double{most_samples}));
    if (count == 1)
        return add_trilinear(longer, place.u, place.v, 1, to);
    double along_u = uv, along_v = square - uu;
    if (uu > vv) {
        along_u = square - vv;
        along_v = uv;
    }
    const double scale = longer / std::sqrt(along_u * along_u + along_v * along_v);
    const double step_u = along_u * scale / width / count,
                 step_v = along_v * scale / height / count;
    for (int i = 0; i < count; ++i) {
        const double from_middle = i - 0.5 * (count - 1);
        add_trilinear(std::max(shorter, longer / count), place.u + from_middle * step_u,
                      place.v + from_middle * step_v, 1.0F / static_cast<float>(count), to);
    }
}

l3d_detail::texture_view l3d_texture::view() const {
    l3d_detail::texture_view result;
    result.pixels = light_.data();
    result.width = size().width;
    result.height = size().height;
    result.levels = static_cast<int>(levels_.size());
    result.wrap_u = wrap_u_;
    result.wrap_v = wrap_v_;
    for (std::size_t i = 0; i < levels_.size(); ++i)
        result.first[i] = static_cast<std::int32_t>(levels_[i].first);
    return result;
}

l3d_light_color l3d_texture::light(l3d_texture_filter filter,
                                   const l3d_texture_place& place) const {
    sum result;
    const double width = size().width, height = size().height;
    switch (filter) {
    case l3d_texture_filter::nearest: {
        const auto place_of = [](double at, int of) {
            return static_cast<std::size_t>(std::min(static_cast<int>(at * of), of - 1));
        };
        const std::size_t x = place_of(held(place.u, wrap_u_), levels_[0].width);
        const std::size_t y = place_of(held(place.v, wrap_v_), levels_[0].height);
        result.add(pixel(levels_[0], x, y), 1);
        break;
    }
    case l3d_texture_filter::bilinear:
        add_bilinear(0, place.u, place.v, 1, result);
        break;
    case l3d_texture_filter::trilinear: {
        const auto length = [&](double u, double v) {
            return u * width * u * width + v * height * v * height;
        };
        add_trilinear(std::sqrt(std::max(length(place.u_right, place.v_right),
                                         length(place.u_down, place.v_down))),
                      place.u, place.v, 1, result);
        break;
    }
    case l3d_texture_filter::anisotropic:
        add_anisotropic(place, result);
        break;
    }
    return {result.of[0] / white, result.of[1] / white, result.of[2] / white};
}
