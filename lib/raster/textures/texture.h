// SPDX-License-Identifier: MIT
// l3d_texture: a picture to be laid on surfaces, in several sizes; and the triangles that it is
// laid on.
#ifndef L3D_RASTER_TEXTURES_TEXTURE_H
#define L3D_RASTER_TEXTURES_TEXTURE_H

#include "base/public.h"
#include "geom/matrix.h"
#include "geom/vector.h"
#include "raster/lighting.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

/// The way to find a pixel's colour in a texture's picture. The pixel covers some part of it.
enum class L3D_PUBLIC l3d_texture_filter {
    nearest,   ///< the picture's pixel under the middle of the drawn pixel
    bilinear,  ///< bilinear interpolation between the four pixels around that place
    trilinear, ///< bilinear in two smaller pictures, whose pixels are as wide as the part is long
    /// Mean of up to 16 trilinear colours along the part, each as fine as the part is narrow.
    anisotropic
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
    clamp,  ///< the pixels at its border
    mirror  ///< the picture turned over, and then again
};

/// The part of a texture's picture that a pixel covers: a parallelogram around a place.
///
/// Units: (0, 0) is the picture's top left corner, (1, 1) the bottom right one.
struct L3D_PUBLIC l3d_texture_place {
    double u = 0, v = 0;             ///< the place under the middle of the pixel
    double u_right = 0, v_right = 0; ///< the step from there to the next pixel on the right
    double u_down = 0, v_down = 0;   ///< the step from there to the next pixel below
};

namespace l3d_detail {
struct texture_view;
}

/// A texture: a picture as amounts of light, and smaller copies down to a single pixel.
///
/// Each copy has half the width and height of the next larger one, rounded down. Each of its pixels
/// is the exact mean of the area that it covers there. Light is linear: levels are decoded by the
/// sRGB curve.
/// A channel is kept as the root of its light, in 11 bits, or 10 for blue. That is within 1/10 of a
/// level, or 1/5 for blue, and a level comes back as it was.
/// Lives:   a texture never changes; share it by std::shared_ptr.
/// Cost:    8 bytes for each pixel, and a third more for the smaller copies.
class L3D_PUBLIC l3d_texture {
public:
    /// The most samples of the filter `anisotropic`. Each is a sample of the filter `trilinear`.
    static constexpr int most_samples = 16;

    /// Makes a texture from a copy of the picture. The highest bytes of its words are ignored.
    /// Expects: a width and a height that are not 0.
    explicit l3d_texture(const l3d_pixels& picture,
                         l3d_texture_wrap wrap_u = l3d_texture_wrap::repeat,
                         l3d_texture_wrap wrap_v = l3d_texture_wrap::repeat);

    /// The size of the whole picture.
    l3d_size size() const { return size_; }

    /// The continuation of the picture beyond its left and right borders.
    l3d_texture_wrap wrap_u() const { return wrap_u_; }
    /// The continuation of the picture beyond its upper and lower borders.
    l3d_texture_wrap wrap_v() const { return wrap_v_; }

    /// The places of the pixels in memory, for the library's own SIMD lanes.
    /// Lives: as long as the texture.
    l3d_detail::texture_view view() const;

    /// The light of a pixel that covers this part; 1 is the light of level 255. The result has the
    /// same bits on every processor. `trilinear` takes the longer one of the two steps as the
    /// part's length. `anisotropic` takes the axes of the ellipse in the parallelogram.
    /// Expects: finite numbers.
    l3d_light_color light(l3d_texture_filter filter, const l3d_texture_place& place) const;

private:
    l3d_size size_;
    std::vector<std::int32_t> first_;   ///< the first pixel of each picture, the whole one first
    std::vector<std::uint32_t> texels_; ///< as l3d_detail::texture_view has them
    l3d_texture_wrap wrap_u_, wrap_v_;
};

/// A triangle of a model, with the values that are interpolated between its corners.
struct L3D_PUBLIC l3d_painted_triangle {
    std::array<std::uint32_t, 3> corners{};               ///< indices of the model's vertices
    std::uint32_t material = 0;                           ///< index of the model's material
    std::array<std::array<float, 2>, 3> picture_places{}; ///< u and v, as in l3d_texture_place
    std::array<std::uint32_t, 3> colors{0xffffff, 0xffffff, 0xffffff}; ///< 0x00RRGGBB
};

/// A model made of painted triangles, and its place in the picture.
///
/// In each pixel, values between the corners are those on the triangle's exact plane, and so are
/// their changes to the next pixels. Light is linear. It is the product of three lights: that of
/// the material's colour, of the colour interpolated between the corners, and of the texture.
/// Lives:   borrows its arrays.
struct L3D_PUBLIC l3d_painted_model {
    std::uint32_t first = 0;          ///< number of material that parts use for its first triangle
    std::uint32_t first_material = 0; ///< the index of its first material in the frame's list
    /// Maps a vertex to the picture: x and y in pixels, both times w, and w in the last row.
    l3d_matrix<double> to_picture = l3d_matrix<double>();
    std::span<const l3d_vector<double, 3>> vertices; ///< vertices of the model
    /// Triangles; each has the next number of material.
    std::span<const l3d_painted_triangle> triangles;
    /// The pictures that materials name. A null pointer, or an index beyond the last, is no
    /// texture.
    std::span<const std::shared_ptr<const l3d_texture>> textures;
};

namespace l3d_detail {
struct painted_parts;
}

/// All painted triangles and patches of a frame.
struct L3D_PUBLIC l3d_face_paints {
    /// The painted models, in the order of their triangles' numbers. These begin after the frame's
    /// materials.
    std::vector<l3d_painted_model> models;
    /// The painted parts of patches, with numbers after those of the triangles; null if there are
    /// none. More may be added until the frame's finish.
    /// Lives: borrowed until the finish, and so are the parts.
    const l3d_detail::painted_parts* parts = nullptr;
    /// The filter of all textures.
    l3d_texture_filter filter = l3d_texture_filter::anisotropic;

    /// The number after the last triangle's.
    std::size_t end() const {
        return models.empty() ? 0 : models.back().first + models.back().triangles.size();
    }
};

#endif
