// SPDX-License-Identifier: MIT
// face_painter: makes planes of triangles in homogeneous space, and evaluates them at pixels.
#include "raster/shaders/face_painter_p.h"

#include "raster/color/linear_light_p.h"
#include "raster/textures/texture_lanes_p.h"

#include <algorithm>

namespace l3d_detail {

namespace {

using vector = l3d_vector<double, 3>;

/// A vertex in homogeneous coordinates of the picture: x and y in pixels times w, and w.
vector placed(const l3d_matrix<double>& m, const l3d_vector<double, 3>& v) {
    vector result;
    for (int i = 0; i < 3; ++i) {
        const int row = i == 2 ? 3 : i;
        result[i] = m(row, 0) * v[0] + m(row, 1) * v[1] + m(row, 2) * v[2] + m(row, 3);
    }
    return result;
}

l3d_light_color light_of(std::uint32_t color) {
    const linear_light& tables = linear_light_tables();
    return {tables.light(color >> 16 & 255), tables.light(color >> 8 & 255),
            tables.light(color & 255)};
}

l3d_light_color product(const l3d_light_color& a, const l3d_light_color& b) {
    return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}

} // namespace

void face_painter::begin(std::uint32_t name) {
    name_ = name;
    triangle_ = nullptr;
    if (name < materials_.size()) {
        material_ = name;
        flat_color_ = materials_[name].color;
        return;
    }
    const auto behind = std::ranges::upper_bound(paints_->models, name, {},
                                                 [](const auto& model) { return model.first; });
    const l3d_painted_model& model = *(behind - 1);
    begin_triangle(model, model.triangles[name - model.first]);
}

/// Sets up the planes that give a pixel's barycentric coordinates in a triangle.
///
/// A place in the picture is a direction (x, y, 1) in the space of x w, y w and w. The plane
/// through the origin and two corners is 0 on the side between them. So the share of the third
/// corner is the distance of (x, y, 1) from that plane, over the sum of all three such distances.
/// No corner need be visible.
void face_painter::begin_triangle(const l3d_painted_model& model,
                                  const l3d_painted_triangle& triangle) {
    triangle_ = &triangle;
    material_ = model.first_material + triangle.material;
    const l3d_material& material = materials_[material_];
    const l3d_light_color light = light_of(material.color);
    const auto picture = static_cast<std::size_t>(material.picture);
    texture_ = material.picture >= 0 && picture < model.textures.size()
                   ? model.textures[picture].get()
                   : nullptr;
    std::array<vector, 3> at;
    for (std::size_t k = 0; k < at.size(); ++k)
        at[k] = placed(model.to_picture, model.vertices[triangle.corners[k]]);
    const double turn = l3d_dot(at[0], l3d_cross(at[1], at[2])) < 0 ? -1 : 1;
    u_ = v_ = all_ = vector(0.0);
    for (std::size_t k = 0; k < at.size(); ++k) {
        sides_[k] = l3d_cross(at[(k + 1) % 3], at[(k + 2) % 3]) * turn;
        u_ += sides_[k] * double{triangle.picture_places[k][0]};
        v_ += sides_[k] * double{triangle.picture_places[k][1]};
        all_ += sides_[k];
        corners_[k] = product(light, light_of(triangle.colors[k]));
    }
    if (texture_ || triangle.colors[0] != triangle.colors[1] ||
        triangle.colors[1] != triangle.colors[2])
        return;
    triangle_ = nullptr;
    const linear_light& tables = linear_light_tables();
    flat_color_ = 0;
    for (const float channel : corners_[0])
        flat_color_ = flat_color_ << 8 | tables.level(channel);
}

/// The place in the texture that a pixel shows. With u = n / d, where n and d are linear, a step in
/// x changes u by (n_x - u d_x) / d.
/// Expects: shares that add up to d.
l3d_texture_place face_painter::place_at(const std::array<double, 3>& shares) const {
    const double over = 1 / (shares[0] + shares[1] + shares[2]);
    const auto& places = triangle_->picture_places;
    l3d_texture_place place;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        place.u += shares[k] * over * double{places[k][0]};
        place.v += shares[k] * over * double{places[k][1]};
    }
    place.u_right = (u_[0] - place.u * all_[0]) * over;
    place.v_right = (v_[0] - place.v * all_[0]) * over;
    place.u_down = (u_[1] - place.u * all_[1]) * over;
    place.v_down = (v_[1] - place.v * all_[1]) * over;
    return place;
}

/// Finds the light and the place in the texture of a pixel. Corners are drawn on a lattice of 1/256
/// pixel. So a pixel at a side may lie beside the exact triangle; negative shares count as 0.
void face_painter::place(double x, double y, std::size_t pixel) {
    std::array<double, 3> shares;
    for (std::size_t k = 0; k < shares.size(); ++k)
        shares[k] = std::max(sides_[k][0] * x + sides_[k][1] * y + sides_[k][2], 0.0);
    // With a smaller sum, the triangle is a line, as far as numbers tell.
    if (!(shares[0] + shares[1] + shares[2] > 0x1p-1000))
        shares = {1, 0, 0};
    const double over = 1 / (shares[0] + shares[1] + shares[2]);
    for (std::size_t c = 0; c < 3; ++c)
        batch_.pixels().light[c][pixel] = static_cast<float>((shares[0] * double{corners_[0][c]} +
                                                              shares[1] * double{corners_[1][c]} +
                                                              shares[2] * double{corners_[2][c]}) *
                                                             over);
    if (texture_)
        batch_.pixels().set(pixel, *texture_, place_at(shares));
}

void face_painter::paint(const named_pixels& pixels) {
    for (std::size_t i = 0; i < pixels.count;) {
        const std::uint32_t name = pixels.names[i];
        if (name == no_name) {
            ++i;
        } else if (batch_.has(name)) {
            i = batch_.add_part(pixels, i);
        } else {
            const std::size_t begin = i;
            while (i < pixels.count && pixels.names[i] == name)
                ++i;
            paint_face(pixels, {begin, i});
        }
    }
    batch_.finish();
}

/// Paints neighbouring pixels. Expects: all of them show one polygon or one material.
void face_painter::paint_face(const named_pixels& from, const pixel_range& range) {
    if (from.names[range.begin] != name_)
        begin(from.names[range.begin]);
    if (!triangle_)
        return batch_.add_color(flat_color_, range);
    batch_.add(texture_, range);
    for (std::size_t i = range.begin; i < range.end; ++i)
        place(from.x + static_cast<double>(i), from.y, i);
}

namespace {

constexpr auto columns_together = static_cast<std::int32_t>(painted_pixels::most);

} // namespace

void paint_words(const material_pixels& pixels, std::int32_t left, std::int32_t top,
                 face_painter& painter) {
    named_pixels named{};
    for (std::int32_t begin = 0; begin < pixels.width; begin += columns_together) {
        const auto count =
            static_cast<std::size_t>(std::min(pixels.width - begin, columns_together));
        for (std::int32_t row = 0; row < pixels.height; ++row) {
            std::uint32_t* const words = pixels.words + row * pixels.word_pitch + begin;
            const float* const depths = pixels.depths + row * pixels.depth_pitch + begin;
            named.x = left + begin + 0.5;
            named.y = top + row + 0.5;
            take_names(words, depths, count, named);
            painter.paint(named);
            color_levels(words, depths, painter.words(), count);
        }
    }
}

void light_painted(const lit_words& lights, const lit_pixels& pixels, face_painter& painter) {
    named_pixels named{};
    named.names.fill(no_name);
    for (std::int32_t begin = 0; begin < pixels.width; begin += columns_together)
        for (std::int32_t row = 0; row < pixels.height; ++row) {
            lit_pixels some = pixels;
            some.words += row * pixels.word_pitch + begin;
            some.depths += row * pixels.depth_pitch + begin;
            some.normals += row * pixels.depth_pitch + begin;
            some.left += begin;
            some.top += row;
            some.width = std::min(pixels.width - begin, columns_together);
            some.height = 1;
            named.count = static_cast<std::size_t>(some.width);
            named.x = some.left + 0.5;
            named.y = some.top + 0.5;
            for (std::size_t i = 0; i < named.count; ++i)
                named.names[i] = some.depths[i] > 0 ? some.words[i] & 0xffff : no_name;
            painter.paint(named);
            for (std::size_t i = 0; i < named.count; ++i)
                if (named.names[i] != no_name)
                    some.words[i] = (some.words[i] & 0xffff0000) | painter.material(named.names[i]);
            some.colors = painter.words();
            lights.color(some);
        }
}

} // namespace l3d_detail
