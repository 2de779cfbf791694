// SPDX-License-Identifier: MIT
// l3d_surface_rasterizer_mesa: has the shaders, and makes triangles for them.
#include "raster/surfaces/surface_rasterizer_mesa.h"

#include "raster/surfaces/band_cells_p.h"
#include "raster/surfaces/quad_cut_p.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <span>
#include <utility>

namespace {

using namespace l3d_detail;

// `shade` counts as l3d_shade does, and `flat` is `lambert` with one normal for all corners. 1 /
// 8192 is mesa_target::reach, and 2^-32 its depth_scale. 1.2e-38 is a little more than the least
// normalized float, so that a zero normal has cosine 0. Levels are rounded here, since GL may round
// them in other ways.
const mesa_target::program_text shaded_surfaces{.vertex = R"(#version 120
        attribute vec3 position;
        attribute vec3 normal;
        attribute vec4 material;
        uniform vec2 middle;
        uniform vec3 light;
        uniform vec3 ray;
        uniform vec3 ray_right;
        uniform vec3 ray_down;
        varying float inv_w;
        varying vec3 direction;
        varying float away;
        varying float grey;
        varying vec3 color;
        float intensity(float cosine) { return 0.1 + 0.9 * clamp(cosine, 0.0, 1.0); }
        void main() {
            gl_Position = vec4((position.xy - middle) * (1.0 / 8192.0), 0.0, 1.0);
            inv_w = position.z;
            color = material.rgb;
            direction = normal;
            float cosine = dot(light, normal) / sqrt(max(dot(normal, normal), 1.2e-38));
            away = dot(normal, ray + position.x * ray_right + position.y * ray_down);
            grey = intensity(away > 0.0 ? -cosine : cosine);
        })",
                                                .fragment = R"(#version 120
        uniform int shade;
        uniform vec3 light;
        varying float inv_w;
        varying vec3 direction;
        varying float away;
        varying float grey;
        varying vec3 color;
        vec3 shaded() {
            float side = away > 0.0 ? -1.0 : 1.0;
            if (shade == 1)
                return vec3(grey);
            if (shade == 4)
                return direction;
            vec3 unit = side * direction / sqrt(max(dot(direction, direction), 1.2e-38));
            if (shade == 3)
                return 0.5 * (unit + 1.0);
            return vec3(0.1 + 0.9 * clamp(dot(light, unit), 0.0, 1.0));
        }
        void main() {
            vec3 level = floor(255.0 * clamp(shaded(), 0.0, 1.0) + 0.5);
            gl_FragColor = vec4(floor(color * level + 0.5) / 255.0, 0.0);
            gl_FragDepth = inv_w * (1.0 / 65536.0 / 65536.0);
        })",
                                                .attributes = {"position", "normal", "material"}};
static_assert(mesa_target::reach == 8192);
static_assert(static_cast<int>(l3d_shade::gouraud) == 1 &&
              static_cast<int>(l3d_shade::normals) == 3 && static_cast<int>(l3d_shade::error) == 4);

/// The number of vertices that are gathered before GL gets them. Each has 28 bytes, so a batch has
/// up to 1.4 MB.
constexpr std::size_t full_batch = std::size_t{3} << 14;

l3d_micro_vertex mean_normal(std::span<const l3d_micro_vertex> polygon, l3d_micro_vertex corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        corner.normal[axis] = 0;
        for (const l3d_micro_vertex& each : polygon)
            corner.normal[axis] += each.normal[axis];
    }
    return corner;
}

} // namespace

l3d_surface_rasterizer_mesa::l3d_surface_rasterizer_mesa(std::unique_ptr<mesa_context> context)
    : gl_target_(std::move(context), shaded_surfaces, true) {
    gl_target_.gl().GenQueries(1, &query_);
}

void l3d_surface_rasterizer_mesa::do_begin(l3d_pixels target, l3d_depth_buffer* depth,
                                           const l3d_shading& shading, bool) {
    assert(!depth || target.size() == depth->size());
    target_ = target;
    depth_ = depth ? depth : &own_depth_;
    shading_ = shading;
    counts_ = {};
    batch_.clear();
    cleared_ = false;
    const mesa_gl& gl = gl_target_.gl();
    if (held_size_ != target.size()) {
        held_size_ = target.size();
        fits_ = gl_target_.resize(target.size());
        gl.Uniform2f(gl_target_.uniform("middle"), static_cast<float>(gl_target_.middle_x()),
                     static_cast<float>(gl_target_.middle_y()));
    }
    by_cpu_ = !fits_ || shading.is_lit(materials()) || shading.paints;
    if (!depth && (counts_pixels() || by_cpu_))
        own_depth_.resize(target.size());
    if (by_cpu_) {
        cpu_.count_pixels(counts_pixels());
        cpu_.use_materials(materials());
        return cpu_.begin(target, depth_, shading);
    }
    gl.Uniform1i(gl_target_.uniform("shade"), static_cast<int>(shading.mode));
    for (const auto& [name, value] :
         {std::pair{"light", &shading.light}, std::pair{"ray", &shading.ray},
          std::pair{"ray_right", &shading.ray_right}, std::pair{"ray_down", &shading.ray_down}})
        gl.Uniform3f(gl_target_.uniform(name), (*value)[0], (*value)[1], (*value)[2]);
}

void l3d_surface_rasterizer_mesa::do_draw(std::span<const l3d_surface_part* const> parts) {
    if (by_cpu_)
        return cpu_.draw(parts);
    for (const l3d_surface_part* part : parts)
        add_part(*part);
}

void l3d_surface_rasterizer_mesa::add_part(const l3d_surface_part& part) {
    error_color_ = part.error_color;
    set_material(part.material);
    const l3d_micro_grid& grid = part.grid;
    const grid_cells cells = all_cells(grid);
    for (int row = 0; row < cells.row_end; ++row)
        for (int column = 0; column < cells.column_end; ++column)
            add_quad(corners_of(grid, grid.index(row, column)), grid.shows_both, grid.is_parallel);
    for (std::size_t i = 0; i < part.triangles.count; ++i) {
        set_material(part.material_of(i));
        add(std::array{part.triangles.vertex(i, 0), part.triangles.vertex(i, 1),
                       part.triangles.vertex(i, 2)});
    }
    counts_.quads += polygons(part);
}

/// Sets the material of all vertices that are added after this call.
void l3d_surface_rasterizer_mesa::set_material(std::uint32_t material) {
    const std::uint32_t word =
        materials().empty() ? l3d_material().color : materials()[material].color;
    for (std::size_t i = 0; i < 3; ++i)
        color_[i] = static_cast<std::uint8_t>(word >> (16 - 8 * i));
}

void l3d_surface_rasterizer_mesa::add_quad(std::array<l3d_micro_vertex, 4> corners, bool shows_both,
                                           bool parallel) {
    const quad_turns turns(corners);
    if (turns.folded())
        return cut_folded(corners, parallel, turns, [&](auto piece, std::int64_t area2) {
            if (shows_both)
                show_side(piece, area2);
            add(piece);
        });
    if (shows_both)
        show_side(corners, turns.area2());
    add(corners);
}

void l3d_surface_rasterizer_mesa::add(std::span<const l3d_micro_vertex> convex) {
    const auto part = [this](int shift) { // a component of the error colour
        return static_cast<float>(error_color_ >> shift & 255) / 255.0f;
    };
    const auto add_corner = [&](const l3d_micro_vertex& corner) {
        const l3d_micro_vertex v =
            shading_.mode == l3d_shade::flat ? mean_normal(convex, corner) : corner;
        vertex& made =
            batch_.emplace_back(vertex{{static_cast<float>(v.x) / l3d_subpixel_one,
                                        static_cast<float>(v.y) / l3d_subpixel_one, v.inv_w},
                                       {v.normal[0], v.normal[1], v.normal[2]},
                                       color_});
        if (shading_.mode == l3d_shade::error)
            made = {{made.position[0], made.position[1], made.position[2]},
                    {part(16), part(8), part(0)},
                    color_};
    };
    for (std::size_t i = 2; i < convex.size(); ++i) {
        add_corner(convex[0]);
        add_corner(convex[i - 1]);
        add_corner(convex[i]);
    }
    if (batch_.size() >= full_batch)
        flush();
}

void l3d_surface_rasterizer_mesa::flush() {
    const mesa_gl& gl = gl_target_.gl();
    if (!cleared_) {
        gl_target_.clear(shading_.background);
        cleared_ = true;
    }
    if (batch_.empty())
        return;
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(vertex), batch_[0].position);
    gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(vertex), batch_[0].normal);
    gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(vertex),
                           batch_[0].material.data());

    if (counts_pixels()) {
        gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        gl.DepthMask(GL_FALSE);
        gl.DepthFunc(GL_ALWAYS);
        counts_.samples += draw();
        gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        gl.DepthMask(GL_TRUE);
    }
    gl.DepthFunc(GL_GREATER); // the first of equally near ones stays
    counts_.written += draw();
    batch_.clear();
}

/// Draws the batch; returns how many samples passed the depth test, if they are counted.
std::int64_t l3d_surface_rasterizer_mesa::draw() {
    const mesa_gl& gl = gl_target_.gl();
    if (counts_pixels())
        gl.BeginQuery(GL_SAMPLES_PASSED, query_);
    gl.DrawArrays(GL_TRIANGLES, 0, static_cast<int>(batch_.size()));
    if (!counts_pixels())
        return 0;
    gl.EndQuery(GL_SAMPLES_PASSED);
    unsigned passed = 0;
    gl.GetQueryObjectuiv(query_, GL_QUERY_RESULT, &passed);
    return passed;
}

void l3d_surface_rasterizer_mesa::do_finish() {
    if (by_cpu_)
        return cpu_.finish();
    flush();
    gl_target_.download(target_, shading_.background);
    if (depth_ != &own_depth_ || counts_pixels())
        gl_target_.download(*depth_);
    counts_.covered = counts_pixels() ? l3d_covered(*depth_) : l3d_surface_counts::none_counted;
}

const l3d_surface_counts& l3d_surface_rasterizer_mesa::do_counts() const {
    return by_cpu_ ? cpu_.counts() : counts_;
}
