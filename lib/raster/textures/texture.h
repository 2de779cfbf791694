// SPDX-License-Identifier: MIT
// l3d_texture: a picture to be laid on surfaces, in several sizes.
#ifndef L3D_RASTER_TEXTURES_TEXTURE_H
#define L3D_RASTER_TEXTURES_TEXTURE_H

#include "base/public.h"
#include "raster/lighting.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/// The way to find a pixel's colour in a picture of which the pixel covers some part.
enum class L3D_PUBLIC l3d_texture_filter {
    nearest,    ///< the picture's pixel under the middle of the pixel
    bilinear,   ///< between the four pixels around that place
    trilinear,  ///< bilinear in two smaller pictures, with pixels as wide as the part is long
    anisotropic ///< mean of up to 16 trilinear colours along the part, as fine as the part is
                ///< narrow
};

/// The filters' names for users.
inline constexpr std::array<std::pair<const char*, l3d_texture_filter>, 4> l3d_texture_filter_names{
    {{"nearest", l3d_texture_filter::nearest},
     {"bilinear", l3d_texture_filter::bilinear},
     {"trilinear", l3d_texture_filter::trilinear},
     {"anisotropic", l3d_texture_filter::anisotropic}}};

/// The continuation of a picture beyond its borders.
enum class L3D_PUBLIC l3d_texture_wrap {
    repeat, ///< the picture again
    clamp   ///< the pixels at its border
};

/// The part of a picture that a pixel covers: a parallelogram around a place.
///
/// Units: (0, 0) is the picture's top left corner, (1, 1) the bottom right one.
struct L3D_PUBLIC l3d_texture_place {
    double u = 0, v = 0;             ///< the place under the middle of the pixel
    double u_right = 0, v_right = 0; ///< the way from there to the next pixel on the right
    double u_down = 0, v_down = 0;   ///< the way to the next one below
};

/// A picture as amounts of light, and smaller ones down to a single pixel.
///
/// Each smaller picture has half the width and height, rounded down, and each of its pixels is the
/// exact mean of what it covers of the next larger one. Light is linear: levels are decoded by the
/// sRGB curve.
/// Lives:   a texture never changes; share it by std::shared_ptr.
/// Cost:    8 bytes for each pixel, and a third more for the smaller pictures.
class L3D_PUBLIC l3d_texture {
public:
    /// The most samples of the filter `anisotropic`, each one of `trilinear`.
    static constexpr int most_samples = 16;

    /// Takes a copy of the picture; the highest bytes of its words mean nothing.
    /// Expects: a width and a height that are not 0.
    explicit l3d_texture(const l3d_pixels& picture,
                         l3d_texture_wrap wrap_u = l3d_texture_wrap::repeat,
                         l3d_texture_wrap wrap_v = l3d_texture_wrap::repeat);

    /// The size of the whole picture.
    l3d_size size() const { return {levels_[0].width, levels_[0].height}; }

    /// The light of a pixel that covers this part: 1 is that of a level of 255. The same bits on
    /// every processor. `trilinear` takes the longer one of the two ways as length,
    /// `anisotropic` the axes of the ellipse in the parallelogram.
    /// Expects: finite numbers.
    l3d_light_color light(l3d_texture_filter filter, const l3d_texture_place& place) const;

private:
    /// One of the pictures. A pixel has red, green, blue and nothing, so that it is a vector.
    struct level {
        int width = 0, height = 0;
        std::vector<std::uint16_t> light; ///< 65535 is that of a level of 255
    };
    struct sum;

    void add_bilinear(std::size_t level, double u, double v, float weight, sum& to) const;
    void add_trilinear(double width, double u, double v, float weight, sum& to) const;
    void add_anisotropic(const l3d_texture_place& place, sum& to) const;

    std::vector<level> levels_; ///< the whole picture first
    l3d_texture_wrap wrap_u_, wrap_v_;
};

#endif
