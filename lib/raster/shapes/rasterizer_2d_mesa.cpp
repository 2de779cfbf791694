// SPDX-License-Identifier: MIT
// l3d_rasterizer_2d_mesa_imp: gives GL triangles, and brings the picture to GL and back.
#include "raster/shapes/rasterizer_2d_mesa.h"

#include "raster/lines/line_steps_p.h"
#include "raster/lines/smooth_line_p.h"
#include "raster/shapes/visit_coverage_p.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <utility>

namespace {

using namespace l3d_detail;

// 1 / 8192 is mesa_target::reach.
const mesa_target::program_text flat_colors{.vertex = R"(#version 120
        attribute vec2 position;
        attribute vec4 color;
        uniform vec2 middle;
        varying vec4 word;
        void main() {
            gl_Position = vec4((position - middle) * (1.0 / 8192.0), 0.0, 1.0);
            word = color;
        })",
                                            .fragment = R"(#version 120
        varying vec4 word;
        void main() { gl_FragColor = word; })",
                                            .attributes = {"position", "color"}};
static_assert(mesa_target::reach == 8192);

/// The number of vertices that are gathered before GL gets them. Each has 12 bytes, so a batch has
/// up to 590 kB.
constexpr std::size_t full_batch = std::size_t{3} << 14;

} // namespace

l3d_rasterizer_2d_mesa_imp::l3d_rasterizer_2d_mesa_imp(std::unique_ptr<mesa_context> context,
                                                       l3d_pixels target)
    : gl_target_(std::move(context), flat_colors, false), cpu_imp_(target), cpu_(cpu_imp_) {
    do_set_target(target);
}

void l3d_rasterizer_2d_mesa_imp::do_set_target(l3d_pixels target) {
    target_ = target;
    batch_.clear();
    held_ = held::not_at_all;
    cpu_imp_.set_target(target);
    fits_ = gl_target_.resize(target.size());
    if (fits_)
        gl_target_.gl().Uniform2f(gl_target_.uniform("middle"),
                                  static_cast<float>(gl_target_.middle_x()),
                                  static_cast<float>(gl_target_.middle_y()));
}

/// Clears the picture in memory if the colour is black, which costs less than clearing in GL and
/// reading back. Other colours are uploaded once something is drawn on them.
void l3d_rasterizer_2d_mesa_imp::do_clear_buffer(std::uint32_t color) {
    batch_.clear();
    cpu_.clear_buffer(color);
    held_ = color == 0 ? held::as_black : held::not_at_all;
}

void l3d_rasterizer_2d_mesa_imp::do_finish() {
    flush();
    if (held_ == held::newer_than_target)
        gl_target_.download(target_);
    held_ = held::not_at_all;
}

void l3d_rasterizer_2d_mesa_imp::flush() {
    if (batch_.empty())
        return;
    const mesa_gl& gl = gl_target_.gl();
    if (held_ == held::not_at_all) {
        gl_target_.upload(target_);
    } else if (held_ == held::as_black) {
        gl.ClearColor(0, 0, 0, 0);
        gl.Clear(GL_COLOR_BUFFER_BIT);
    }
    held_ = held::newer_than_target;
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(vertex), &batch_[0].x);
    gl.VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(vertex), &batch_[0].color);
    gl.DrawArrays(GL_TRIANGLES, 0, static_cast<int>(batch_.size()));
    batch_.clear();
}

/// Sets how GL mixes colours. The highest byte of a pixel word, which is GL's alpha, stays as it
/// was.
void l3d_rasterizer_2d_mesa_imp::set_blending(blending wanted) {
    if (wanted == blending_)
        return;
    flush();
    blending_ = wanted;
    const mesa_gl& gl = gl_target_.gl();
    if (wanted == blending::off)
        return gl.Disable(GL_BLEND);
    gl.Enable(GL_BLEND);
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
}

void l3d_rasterizer_2d_mesa_imp::do_draw_point(int x, int y, std::uint32_t color) {
    if (!fits_)
        return cpu_.draw_point(x, y, color);
    set_blending(blending::off);
    if (x >= 0 && x < target_.width && y >= 0 && y < target_.height)
        add_rectangle(x, y, x + 1, y + 1, color);
}

void l3d_rasterizer_2d_mesa_imp::do_draw_lines(std::span<const l3d_line_2d> lines,
                                               std::uint32_t color) {
    if (!fits_)
        return cpu_.draw_lines(lines, color);
    set_blending(blending::off);
    for (const l3d_line_2d& line : lines)
        draw_line(line, color);
}

/// Draws one rectangle for each run of pixels with the same coordinate along the shorter axis.
void l3d_rasterizer_2d_mesa_imp::draw_line(const l3d_line_2d& line, std::uint32_t color) {
    if (line.x0 == line.x1 && line.y0 == line.y1)
        return do_draw_point(line.x0, line.y0, color);
    const line_steps steps = steps_of(line, target_.size());
    if (steps.first > steps.last)
        return;
    exact_steps minors = steps.minors();
    for (std::int64_t i = steps.first; i <= steps.last;) {
        const std::int64_t run = minors.floor();
        const int minor = static_cast<int>(steps.minor + run);
        const int begin = static_cast<int>(steps.major + i);
        for (; i <= steps.last && minors.floor() == run; minors.step())
            ++i;
        const int end = static_cast<int>(steps.major + i);
        if (steps.x_major)
            add_rectangle(begin, minor, end, minor + 1, color);
        else
            add_rectangle(minor, begin, minor + 1, end, color);
    }
}

void l3d_rasterizer_2d_mesa_imp::do_draw_line_antialiased(l3d_point_2d from, l3d_point_2d to,
                                                          std::uint32_t color) {
    if (!fits_)
        return cpu_.draw_line_antialiased(from, to, color);
    if (!is_number(from) || !is_number(to))
        return;
    set_blending(blending::by_coverage);
    smooth_line(from, to, target_.size()).for_each_pixel([&](int x, int y, int coverage) {
        const auto alpha = static_cast<std::uint32_t>(coverage) << 24;
        add_rectangle(x, y, x + 1, y + 1, (color & 0x00ffffff) | alpha);
    });
}

bool l3d_rasterizer_2d_mesa_imp::reaches(const far_point& corner) const {
    constexpr int most = (mesa_target::reach - 1) * l3d_subpixel_one;
    return std::abs(corner.x - gl_target_.middle_x() * l3d_subpixel_one) <= most &&
           std::abs(corner.y - gl_target_.middle_y() * l3d_subpixel_one) <= most;
}

void l3d_rasterizer_2d_mesa_imp::do_draw_polygon_flatshaded(l3d_outline_2d corners,
                                                            std::uint32_t color) {
    if (!corners_.set(corners))
        return;
    const auto in_reach = [this](const far_point& corner) { return reaches(corner); };
    if (!fits_ || !std::ranges::all_of(corners_.far(), in_reach)) {
        do_finish();
        return cpu_.draw_polygon_flatshaded(corners, color);
    }
    set_blending(blending::off);
    for (std::size_t i = 2; i < corners_.far().size(); ++i) {
        add(corners_.far()[0], color);
        add(corners_.far()[i - 1], color);
        add(corners_.far()[i], color);
    }
    if (batch_.size() >= full_batch)
        flush();
}

void l3d_rasterizer_2d_mesa_imp::do_draw_polygon_gouraudshaded(
    std::span<const l3d_colored_point_2d> corners) {
    const auto position = [](const l3d_colored_point_2d& c) { return l3d_point_2d{c.x, c.y}; };
    const auto in_reach = [&](const l3d_colored_point_2d& c) {
        return is_number(position(c)) && reaches(lattice_point(position(c)));
    };
    if (!fits_ || !std::ranges::all_of(corners, in_reach)) {
        do_finish();
        return cpu_.draw_polygon_gouraudshaded(corners);
    }
    set_blending(blending::off);
    const auto add_corner = [&](const l3d_colored_point_2d& c) {
        add(lattice_point(position(c)), c.color & 0x00ffffff);
    };
    for (std::size_t i = 2; i < corners.size(); ++i) {
        add_corner(corners[0]);
        add_corner(corners[i - 1]);
        add_corner(corners[i]);
    }
    if (batch_.size() >= full_batch)
        flush();
}

void l3d_rasterizer_2d_mesa_imp::do_draw_outlines(std::span<const l3d_outline_2d> outlines,
                                                  l3d_winding inside, std::uint32_t color) {
    if (!fits_)
        return cpu_.draw_outlines(outlines, inside, color);
    set_blending(blending::off);
    for (const pixel_span& span : winding_.convert(outlines, inside, target_.size()))
        add_rectangle(span.first, span.row, span.last, span.row + 1, color);
}

/// Draws one rectangle for each run of pixels that are covered alike.
void l3d_rasterizer_2d_mesa_imp::do_draw_coverage(const l3d_coverage_2d& shape,
                                                  std::uint32_t color) {
    if (!fits_)
        return cpu_.draw_coverage(shape, color);
    set_blending(blending::by_coverage);
    visit_coverage(shape, target_.size(), [&](int x, int y, std::span<const std::uint8_t> values) {
        for (std::size_t i = 0, end = 0; i < values.size(); i = end) {
            while (end < values.size() && values[end] == values[i])
                ++end;
            if (values[i] > 0)
                add_rectangle(x + static_cast<int>(i), y, x + static_cast<int>(end), y + 1,
                              (color & 0x00ffffff) | std::uint32_t{values[i]} << 24);
        }
    });
}

void l3d_rasterizer_2d_mesa_imp::do_draw_curves(const l3d_path& path, std::uint32_t color) {
    do_finish();
    cpu_.draw_curves(path, color);
}

void l3d_rasterizer_2d_mesa_imp::do_draw_mesh(std::span<const l3d_mesh_patch> patches) {
    do_finish();
    cpu_.draw_mesh(patches);
}

/// Draws the path in memory, as GL has no exact areas.
void l3d_rasterizer_2d_mesa_imp::do_draw_path(const l3d_path& path, const l3d_fill& fill) {
    do_finish();
    cpu_.draw_path(path, fill);
}

void l3d_rasterizer_2d_mesa_imp::do_draw_image(const l3d_placed_image& image,
                                               const l3d_fill& fill) {
    do_finish();
    cpu_.draw_image(image, fill);
}

void l3d_rasterizer_2d_mesa_imp::add_rectangle(int left, int top, int right, int bottom,
                                               std::uint32_t color) {
    const auto x0 = static_cast<float>(left), x1 = static_cast<float>(right);
    const auto y0 = static_cast<float>(top), y1 = static_cast<float>(bottom);
    add(x0, y0, color);
    add(x1, y0, color);
    add(x1, y1, color);
    add(x0, y0, color);
    add(x1, y1, color);
    add(x0, y1, color);
    if (batch_.size() >= full_batch)
        flush();
}

void l3d_rasterizer_2d_mesa_imp::add(const far_point& corner, std::uint32_t color) {
    add(static_cast<float>(corner.x) / l3d_subpixel_one,
        static_cast<float>(corner.y) / l3d_subpixel_one, color);
}

void l3d_rasterizer_2d_mesa_imp::add(float x, float y, std::uint32_t color) {
    const auto byte = [color](int shift) { return static_cast<std::uint8_t>(color >> shift); };
    batch_.push_back({x, y, {byte(16), byte(8), byte(0), byte(24)}});
}
