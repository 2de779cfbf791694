// SPDX-License-Identifier: MIT
// face_painter: the colour of a painted triangle in each pixel.
#ifndef L3D_RASTER_SHADERS_FACE_PAINTER_P_H
#define L3D_RASTER_SHADERS_FACE_PAINTER_P_H

#include "geom/material.h"
#include "geom/vector.h"
#include "raster/shaders/paint_batch_p.h"
#include "raster/shaders/lit_shader_p.h"
#include "raster/shaders/lit_words_p.h"
#include "raster/shaders/material_words_p.h"
#include "raster/textures/texture.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// Finds the colour of a painted triangle in each pixel, or the colour of a material. Triangles and
/// materials are named by numbers ("names"), as in l3d_face_paints. The painter keeps the planes of
/// the last triangle, as neighbouring pixels mostly show the same triangle.
/// Lives: borrows paints and materials; each painter belongs to one worker.
class face_painter {
public:
    face_painter(const l3d_face_paints& paints, std::span<const l3d_material> materials)
        : paints_(&paints), materials_(materials), batch_(paints.parts, paints.filter, materials) {
        one_.names.fill(no_name);
        one_.count = 1;
    }

    /// The colour of a name at a place of the picture, 0x00RRGGBB. A place outside of the triangle
    /// gets the colour of the nearest point on its sides.
    /// Units: pixels from the top left corner.
    std::uint32_t color(std::uint32_t name, double x, double y) {
        one_.names[0] = name;
        one_.x = x;
        one_.y = y;
        paint(one_);
        return words()[0];
    }

    /// Finds the colours of pixels of a row: afterwards, words() has the colours of pixels that
    /// show something.
    void paint(const named_pixels& pixels);
    const std::uint32_t* words() const { return batch_.words(); }

    /// The index, in the frame's list, of the material that a name has.
    std::uint32_t material(std::uint32_t name) {
        if (batch_.has(name))
            return batch_.material(name);
        if (name != name_)
            begin(name);
        return material_;
    }

private:
    /// A linear function of the place in the picture.
    /// Shape: factors of x and y, and the value at (0, 0).
    using plane = l3d_vector<double, 3>;

    void paint_face(const named_pixels& from, const pixel_range& range);
    void begin(std::uint32_t name);
    void begin_triangle(const l3d_painted_model& model, const l3d_painted_triangle& triangle);
    void place(double x, double y, std::size_t pixel);
    l3d_texture_place place_at(const std::array<double, 3>& shares) const;

    const l3d_face_paints* paints_;
    std::span<const l3d_material> materials_;
    paint_batch batch_;
    named_pixels one_{};
    std::uint32_t name_ = no_name, material_ = 0, flat_color_ = 0;
    /// The painted triangle that is set up; null if the whole polygon has flat_color_.
    const l3d_painted_triangle* triangle_ = nullptr;
    const l3d_texture* texture_ = nullptr;
    std::array<plane, 3> sides_{}; ///< a function for each corner, which is 0 on the opposite side
    plane u_{0.0}, v_{0.0}, all_{0.0}; ///< u and v, each times all_; all_ is the sum of sides_
    /// The light of each corner's colour, times the light of the material's colour.
    std::array<l3d_light_color, 3> corners_{};
};

/// A lit_shader for frames with painted triangles, which finds their colour in each pixel.
class painted_lit_shader : public lit_shader {
public:
    /// Lives: borrows shading and materials.
    painted_lit_shader(const l3d_shading& shading, std::span<const l3d_material> materials)
        : lit_shader(shading, materials), painter_(*shading.paints, materials) {}

    /// Sets the number of material ("name") of the next polygons.
    void use_material(std::uint32_t name) {
        name_ = name;
        lit_shader::use_material(painter_.material(name));
    }

    /// The pixel word at a place in the picture. Units: pixels from its top left corner.
    std::uint32_t word_at(const float* values, double x, double y) {
        use_color(painter_.color(name_, x, y));
        return lit_shader::word(values);
    }
    std::uint32_t word_around(const float* values, double x, double y) {
        return word_at(values, x, y);
    }

private:
    face_painter painter_;
    std::uint32_t name_ = 0;
};

/// Replaces levels of painted triangles and materials by their colours, as material_words::color
/// does in frames without paints. (left, top) is the first pixel's place in the picture.
void paint_words(const material_pixels& pixels, std::int32_t left, std::int32_t top,
                 face_painter& painter);

/// Lights the normals of painted triangles and materials, as lit_words::color does in frames
/// without paints.
void light_painted(const lit_words& lights, const lit_pixels& pixels, face_painter& painter);

} // namespace l3d_detail

#endif
