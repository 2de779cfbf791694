// SPDX-License-Identifier: MIT
// with_shader: chooses the shader that draws a frame's mode.
#ifndef L3D_RASTER_SHADERS_SHADER_CHOICE_P_H
#define L3D_RASTER_SHADERS_SHADER_CHOICE_P_H

#include "raster/shaders/face_painter_p.h"
#include "raster/shaders/inspection_shader_p.h"
#include "raster/shaders/levels_shader_p.h"
#include "raster/shaders/lit_shader_p.h"
#include "raster/shaders/own_shader_p.h"
#include "raster/shaders/surface_shader_p.h"

namespace l3d_detail {

/// Whether a shader takes levels and bends, and so must know to which quad a piece belongs.
template <class Shader>
concept has_bends = requires(Shader shader, const quad_corners& v) {
    shader.begin_quad(v);
};

/// Whether a shader must know the material of its polygons.
template <class Shader>
concept has_materials = requires(Shader shader) {
    shader.use_material(0U);
};

/// Whether a shader must know a pixel's place in the picture.
template <class Shader>
concept has_places = requires(Shader shader, const float* values) {
    shader.word_at(values, 0.0, 0.0);
};

/// Whether a shader takes runs of pixels, and writes their words at the end of each run.
template <class Shader>
concept shades_runs = requires(Shader shader, const float* values, std::uint32_t& word) {
    shader.note(values, 0.0, 0.0, word);
    shader.end_run();
};

/// Whether a shader only stores normals, which are lit later.
template <class Shader>
concept shades_later = requires(const Shader& shader, const float* values) {
    shader.code(values);
};

/// Whether rows of this shader may be filled in SIMD lanes.
template <class Shader>
concept has_lanes = requires(const Shader shader) {
    shader.in_lanes();
};

/// Whether a shader lights normals that are interpolated between a polygon's corners.
template <class Shader>
concept has_normals = Shader::interpolates_normals;

/// Whether a shader counts the pixels for which it finds no exact place.
template <class Shader>
concept counts_unsolved = requires(Shader shader) {
    shader.take_unsolved();
};

/// Calls action with the shader that the frame's mode needs. So the mode is tested once for a batch
/// of polygons, and not for each pixel.
template <class Action>
void with_shader(const l3d_shading& shading, std::span<const l3d_material> materials,
                 std::uint32_t error_color, const Action& action) {
    if (shading.is_lit(materials))
        return shading.paints ? action(painted_lit_shader(shading, materials))
                              : action(lit_shader(shading, materials));
    if (l3d_is_inspection(shading.mode))
        return action(inspection_shader(shading));
    if (shading.mode == l3d_shade::own)
        return action(own_shader(shading));
    switch (shading.mode) {
    case l3d_shade::lambert:
        return action(lambert_shader(shading));
    case l3d_shade::gouraud:
        return action(gouraud_shader(shading));
    case l3d_shade::flat:
        return action(flat_shader(shading));
    case l3d_shade::normals:
        return action(normals_shader(shading));
    case l3d_shade::error:
        return action(constant_shader(error_color));
    case l3d_shade::levels:
        return action(levels_shader());
    default:
        return;
    }
}

} // namespace l3d_detail

#endif
