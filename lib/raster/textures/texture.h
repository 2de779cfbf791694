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

/// The way to find a pixel's colour in a texture's picture, from the part of this picture that the
/// pixel covers.
enum class L3D_PUBLIC l3d_texture_filter {
    nearest, ///< the colour of the picture's pixel under the middle of the drawn pixel
    /// Bilinear interpolation between the picture's four pixels around the drawn pixel's middle.
    bilinear,
    /// Bilinear interpolation in two neighbouring copies of the picture, one of which may be the
    /// picture itself, and linear interpolation between both. The pixels of the larger copy are not
    /// wider than the part is long; those of the smaller copy are wider.
    trilinear,
    /// The mean of up to 16 trilinear colours along the part. Each of these colours comes from
    /// copies whose pixels are about as wide as the part's narrow side.
    anisotropic
};

/// The names by which users choose the filters.
inline constexpr std::array<std::pair<const char*, l3d_texture_filter>, 4> l3d_texture_filter_names{
    {{"nearest", l3d_texture_filter::nearest},
     {"bilinear", l3d_texture_filter::bilinear},
     {"trilinear", l3d_texture_filter::trilinear},
     {"anisotropic", l3d_texture_filter::anisotropic}}};

/// The continuation of a texture's picture beyond its borders.
enum class L3D_PUBLIC l3d_texture_wrap {
    repeat, ///< the picture again, as it is
    clamp,  ///< the colours at the picture's border
    mirror  ///< the picture mirrored, then as it is, and so on by turns
};

/// The part of a texture's picture that a pixel covers: a parallelogram around a place.
///
/// Units: (0, 0) is the picture's top left corner, (1, 1) the bottom right one.
struct L3D_PUBLIC l3d_texture_place {
    double u = 0, v = 0; ///< the place of the texture's picture under the middle of the pixel
    /// The step from this place to the place of the next pixel on the right.
    double u_right = 0, v_right = 0;
    /// The step from this place to the place of the next pixel below.
    double u_down = 0, v_down = 0;
};

namespace l3d_detail {
struct texture_view;
}

/// A texture: a picture that is painted on surfaces. It is kept as amounts of light, with smaller
/// copies down to a single pixel.
///
/// Each copy has half the width and height of the next larger one, rounded down. Each pixel of a
/// copy is the exact mean of the area that it covers in the next larger copy. Light is linear:
/// levels are decoded by the sRGB curve. A channel of a pixel is kept as the square root of its
/// light, in 11 bits, or 10 for blue. Its error is within 1/10 of one of the 255 steps of a
/// channel, or 1/5 for blue. So converting it back gives the same channel.
/// Lives:   a texture never changes; share it by std::shared_ptr.
/// Cost:    4 bytes for each pixel, and a third more for the smaller copies. The picture and each
///          copy also have a border of one pixel on all sides. As the array grows by doubling, it
///          may hold as much unused memory again.
class L3D_PUBLIC l3d_texture {
public:
    /// The most samples of the filter `anisotropic`. Each of these is a sample of the filter
    /// `trilinear`.
    static constexpr int most_samples = 16;

    /// Makes a texture from a copy of the picture. The highest bytes of the picture's words are
    /// ignored.
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

    /// A view of the texture's pixels in memory, for the library's own SIMD lanes.
    /// Lives: as long as the texture.
    l3d_detail::texture_view view() const;

    /// The light of a drawn pixel that covers this part of the picture; 1 is the light of white.
    /// The result has the same bits on every processor. The filter `trilinear` takes the longer one
    /// of the two steps as the part's length. The filter `anisotropic` takes the length and the
    /// width of the ellipse in the parallelogram.
    /// Expects: finite numbers.
    l3d_light_color light(l3d_texture_filter filter, const l3d_texture_place& place) const;

private:
    l3d_size size_;
    /// Index of the first pixel of the picture and of each smaller copy.
    std::vector<std::int32_t> first_;
    std::vector<std::uint32_t> texels_; ///< the pixels, as in l3d_detail::texture_view::texels
    l3d_texture_wrap wrap_u_, wrap_v_;
};

/// A triangle of a model, with the values that are interpolated between its corners.
struct L3D_PUBLIC l3d_painted_triangle {
    std::array<std::uint32_t, 3> corners{}; ///< the corners, as indices of the model's vertices
    std::uint32_t material = 0; ///< index of the triangle's material among the model's materials
    /// The corners' u and v, as in l3d_texture_place.
    std::array<std::array<float, 2>, 3> picture_places{};
    /// The corners' colours, 0x00RRGGBB.
    std::array<std::uint32_t, 3> colors{0xffffff, 0xffffff, 0xffffff};
};

/// A model made of painted triangles, and its place in the picture.
///
/// A pixel gets its values, and their changes to the next pixels, by interpolation on the
/// triangle's exact plane. Light is linear. A pixel's light is a product of three lights: the light
/// of the material's colour, the light of the colour interpolated between the corners, and the
/// texture's light.
/// Lives:   borrows its arrays.
struct L3D_PUBLIC l3d_painted_model {
    /// The number of material by which parts name the model's first triangle.
    std::uint32_t first = 0;
    /// The index of the model's first material in the frame's list.
    std::uint32_t first_material = 0;
    /// Maps a vertex to the picture: x and y in pixels, both times w, and w in the last row.
    l3d_matrix<double> to_picture = l3d_matrix<double>();
    std::span<const l3d_vector<double, 3>> vertices; ///< vertices of the model
    /// The model's triangles. Parts name them by consecutive numbers of material, from `first` on.
    std::span<const l3d_painted_triangle> triangles;
    /// The pictures that materials name. A null pointer, or an index beyond the last texture, means
    /// no texture.
    std::span<const std::shared_ptr<const l3d_texture>> textures;
};

namespace l3d_detail {
struct painted_parts;
}

/// All painted triangles and patches of a frame.
struct L3D_PUBLIC l3d_face_paints {
    /// The painted models, in the order of their triangles' numbers. These numbers begin after the
    /// numbers of the frame's materials.
    std::vector<l3d_painted_model> models;
    /// The painted parts of patches, whose numbers begin after the triangles' numbers; null if no
    /// patch is painted. More parts may be added until the frame's finish.
    /// Lives: borrowed until the frame's finish, and so are the parts.
    const l3d_detail::painted_parts* parts = nullptr;
    /// The filter of all textures.
    l3d_texture_filter filter = l3d_texture_filter::anisotropic;

    /// The first number of material after the numbers of all triangles.
    std::size_t end() const {
        return models.empty() ? 0 : models.back().first + models.back().triangles.size();
    }
};

#endif
