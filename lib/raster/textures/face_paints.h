// SPDX-License-Identifier: MIT
// l3d_face_paints: triangles whose pixels have colours of their own.
#ifndef L3D_RASTER_TEXTURES_FACE_PAINTS_H
#define L3D_RASTER_TEXTURES_FACE_PAINTS_H

#include "base/public.h"
#include "geom/matrix.h"
#include "geom/vector.h"
#include "raster/textures/texture.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

/// A triangle of a model, with what is blended between its corners.
struct L3D_PUBLIC l3d_painted_triangle {
    std::array<std::uint32_t, 3> corners{}; ///< places among the model's vertices
    std::uint32_t material = 0;             ///< place among the model's materials
    std::array<std::array<float, 2>, 3>
        picture_places{}; ///< u and v, as l3d_texture_place has them
    std::array<std::uint32_t, 3> colors{0xffffff, 0xffffff, 0xffffff}; ///< 0x00RRGGBB
};

/// A model with such triangles, where it is in the picture.
///
/// In each pixel, what lies between the corners is that of the triangle's exact plane, and so are
/// the ways to the next pixels. Light is linear: it is the product of the light of the material's
/// colour, of the corners' colours between them, and of the texture.
/// Lives:   borrows its arrays.
struct L3D_PUBLIC l3d_painted_model {
    std::uint32_t first = 0;          ///< material by which parts name its first triangle
    std::uint32_t first_material = 0; ///< the place of its first material among the frame's
    /// From a vertex to the picture: x and y in pixels, times w, and w in the last row.
    l3d_matrix<double> to_picture = l3d_matrix<double>();
    std::span<const l3d_vector<double, 3>> vertices; ///< vertices of the model
    std::span<const l3d_painted_triangle> triangles; ///< each has the name of the one before and 1
    /// The pictures that materials name. A null pointer, or one beyond the last, is no texture.
    std::span<const std::shared_ptr<const l3d_texture>> textures;
};

/// All of a frame.
struct L3D_PUBLIC l3d_face_paints {
    /// In the order of their names, which begin behind the frame's materials.
    std::vector<l3d_painted_model> models;
    /// How textures are looked up.
    l3d_texture_filter filter = l3d_texture_filter::anisotropic;

    /// Behind the last name.
    std::size_t end() const {
        return models.empty() ? 0 : models.back().first + models.back().triangles.size();
    }
};

#endif
