// SPDX-License-Identifier: MIT
// l3d_texture: makes smaller pictures, each the mean of the next larger one.
#include "raster/textures/texture.h"

#include "raster/color/linear_light_p.h"
#include "raster/textures/texture_lanes_p.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace {

constexpr std::size_t channels = 3;

/// A picture as amounts of light in floats, from which the next smaller copy is made.
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

/// Shrinks a picture along one axis, from `size` to `smaller` pixels: calls add(from, weight) for
/// each pixel `from` that the smaller picture's pixel `at` covers. A weight is the covered share of
/// the smaller picture's pixel.
template <class Add> void visit_covered(int at, int smaller, int size, const Add& add) {
    // In these units, a pixel of the smaller picture is `size` wide, and one of the larger picture
    // `smaller`.
    const std::int64_t begin = std::int64_t{at} * size, end = begin + size;
    for (auto from = static_cast<int>(begin / smaller); std::int64_t{from} * smaller < end;
         ++from) {
        const std::int64_t left = std::max(begin, std::int64_t{from} * smaller);
        const std::int64_t right = std::min(end, (std::int64_t{from} + 1) * smaller);
        add(from, static_cast<float>(right - left) / static_cast<float>(size));
    }
}

/// A pixel's light as a word of texture_view::texels.
std::uint32_t packed(const float* light) {
    std::uint32_t word = 0;
    for (std::size_t c = 0; c < channels; ++c) {
        const auto most = static_cast<float>((1 << l3d_detail::texture_view::bits[c]) - 1);
        word = word << l3d_detail::texture_view::bits[c] |
               static_cast<std::uint32_t>(most * std::sqrt(light[c]) + 0.5F);
    }
    return word;
}

/// The index of the picture's pixel that is seen at place `at` along one axis. The place may be up
/// to one pixel beyond the picture's borders.
int held(int at, int size, l3d_texture_wrap wrap) {
    return wrap == l3d_texture_wrap::repeat ? (at + size) % size : std::clamp(at, 0, size - 1);
}

/// A picture of half the width and half the height.
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

} // namespace

l3d_texture::l3d_texture(const l3d_pixels& picture, l3d_texture_wrap wrap_u,
                         l3d_texture_wrap wrap_v)
    : size_{picture.width, picture.height}, wrap_u_(wrap_u), wrap_v_(wrap_v) {
    assert(picture.width > 0 && picture.height > 0);
    const l3d_detail::linear_light& tables = l3d_detail::linear_light_tables();
    float_picture next(picture.width, picture.height);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::uint32_t word = picture.row(y)[static_cast<std::size_t>(x)];
            for (std::size_t c = 0; c < 3; ++c)
                next.at(x, y)[c] = tables.light(word >> (16 - 8 * c) & 255);
        }
    for (;;) {
        const int pitch = l3d_detail::texture_view::pitch(next.width);
        first_.push_back(static_cast<std::int32_t>(texels_.size()) + pitch + 1);
        for (int y = -1; y <= next.height; ++y)
            for (int x = -1; x <= next.width; ++x)
                texels_.push_back(
                    packed(next.at(held(x, next.width, wrap_u), held(y, next.height, wrap_v))));
        if (next.width == 1 && next.height == 1)
            return;
        next = halved(next);
    }
}

l3d_detail::texture_view l3d_texture::view() const {
    l3d_detail::texture_view result;
    result.texels = texels_.data();
    result.width = size_.width;
    result.height = size_.height;
    result.levels = static_cast<int>(first_.size());
    result.wrap_u = wrap_u_;
    result.wrap_v = wrap_v_;
    std::ranges::copy(first_, result.first.begin());
    return result;
}

l3d_light_color l3d_texture::light(l3d_texture_filter filter,
                                   const l3d_texture_place& place) const {
    l3d_detail::painted_pixels pixels{};
    pixels.set(0, *this, place);
    for (auto& channel : pixels.light)
        channel[0] = 1;
    l3d_detail::light_by_texture(view(), filter, {0, 1}, pixels);
    return {pixels.light[0][0], pixels.light[1][0], pixels.light[2][0]};
}
