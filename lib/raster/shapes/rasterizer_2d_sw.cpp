// SPDX-License-Identifier: MIT
// l3d_rasterizer_2d_sw_imp: turns steps and spans into words.
#include "raster/shapes/rasterizer_2d_sw.h"

#include "raster/images/image_sampler_p.h"
#include "raster/paths/curve_pixels_p.h"
#include "raster/paths/gradient.h"
#include "raster/paths/mesh_dicer_p.h"
#include "raster/paths/mesh_strip_p.h"
#include "raster/shapes/blend_p.h"
#include "raster/color/color_mixer_p.h"
#include "raster/lines/line_steps_p.h"
#include "raster/lines/smooth_line_p.h"
#include "raster/shapes/visit_coverage_p.h"
#include "raster/shapes/small_triangle_p.h"
#include "raster/shapes/span_kernels_p.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace {

using namespace l3d_detail;

shaded_corner corner_of(const l3d_colored_point_2d& p) {
    const auto channel = [&p](int shift) { return static_cast<double>(p.color >> shift & 255); };
    return {lattice_point({p.x, p.y}), {channel(16), channel(8), channel(0)}};
}

} // namespace

void l3d_rasterizer_2d_sw_imp::do_set_target(l3d_pixels target) {
    target_ = target;
    constexpr double most = scan_limit / l3d_subpixel_one;
    ends_ = {std::min<double>(target.width, most), std::min<double>(target.height, most)};
    scan_.set_rows({0, target.height});
}

void l3d_rasterizer_2d_sw_imp::do_clear_buffer(std::uint32_t color) {
    for (int y = 0; y < target_.height; ++y)
        std::ranges::fill(target_.row(y), color);
}

void l3d_rasterizer_2d_sw_imp::do_draw_point(int x, int y, std::uint32_t color) {
    if (x >= 0 && x < target_.width && y >= 0 && y < target_.height)
        target_.row(y)[static_cast<std::size_t>(x)] = color;
}

void l3d_rasterizer_2d_sw_imp::do_draw_line(int x0, int y0, int x1, int y1, std::uint32_t color) {
    draw_plain_line(target_, x0, y0, x1, y1, color);
}

void l3d_rasterizer_2d_sw_imp::do_draw_lines(std::span<const l3d_line_2d> lines,
                                             std::uint32_t color) {
    for (const l3d_line_2d& line : lines)
        draw_plain_line(target_, line.x0, line.y0, line.x1, line.y1, color);
}

void l3d_rasterizer_2d_sw_imp::do_draw_line_antialiased(l3d_point_2d from, l3d_point_2d to,
                                                        std::uint32_t color) {
    if (!is_number(from) || !is_number(to))
        return;
    smooth_line(from, to, target_.size()).for_each_pixel([&](int x, int y, int coverage) {
        std::uint32_t& word = target_.row(y)[static_cast<std::size_t>(x)];
        word = blended(word, color, coverage);
    });
}

void l3d_rasterizer_2d_sw_imp::do_draw_polygon_flatshaded(l3d_outline_2d corners,
                                                          std::uint32_t color) {
    if (corners.size() == 3 && fill_small_triangle(target_, corners.first<3>(), ends_, color))
        return;
    if (!corners_.set(corners))
        return;
    if (corners_.all_near())
        fill_convex(corners_.near(), color);
    else
        fill_convex(corners_.far(), color);
}

template <class Point>
void l3d_rasterizer_2d_sw_imp::fill_convex(std::span<const Point> corners, std::uint32_t color) {
    const scan_rows rows = scan_.convert(corners, corners_.clockwise());
    if (rows.top < rows.bottom)
        fill_rows(target_, rows.top, scan_.ends(rows), color);
}

void l3d_rasterizer_2d_sw_imp::do_draw_polygon_gouraudshaded(
    std::span<const l3d_colored_point_2d> corners) {
    if (!std::ranges::all_of(corners, [](const auto& p) { return is_number({p.x, p.y}); }))
        return;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const std::array<shaded_corner, 3> triangle{
            corner_of(corners[0]), corner_of(corners[i - 1]), corner_of(corners[i])};
        shade_spans(target_, triangle_.convert(triangle, target_.size()));
    }
}

void l3d_rasterizer_2d_sw_imp::do_draw_outlines(std::span<const l3d_outline_2d> outlines,
                                                l3d_winding inside, std::uint32_t color) {
    fill_spans(target_, winding_.convert(outlines, inside, target_.size()), color);
}

void l3d_rasterizer_2d_sw_imp::do_draw_coverage(const l3d_coverage_2d& shape, std::uint32_t color) {
    visit_coverage(shape, target_.size(), [&](int x, int y, std::span<const std::uint8_t> values) {
        std::uint32_t* word = target_.row(y).data() + x;
        for (const std::uint8_t coverage : values) {
            if (coverage > 0)
                *word = blended_over_gap(*word, color, coverage);
            ++word;
        }
    });
}

/// Calls paint(x, y, word, share of 255) for each pixel of a run, and stores the word that paint
/// returns.
template <class Paint>
void l3d_rasterizer_2d_sw_imp::paint_run(const covered_run& run, const Paint& paint) const {
    std::uint32_t* const row = target_.row(run.row).data();
    const std::uint8_t* const values = paths_.values() + run.values;
    for (std::int32_t x = run.first; x < run.last; ++x) {
        const int share = run.value >= 0 ? run.value : values[x - run.first];
        if (share > 0)
            row[x] = paint(x, run.row, row[x], share);
    }
}

void l3d_rasterizer_2d_sw_imp::do_draw_path(const l3d_path& path, const l3d_fill& fill) {
    const auto spans = paths_.convert(order_of(path, fill, l3d_whole(target_.size())));
    const bool is_coded = fill.blending == l3d_blending::coded;
    if (is_coded && fill.gradient == nullptr)
        return cover_spans(target_, spans, paths_.values(), fill.color & 0x00ffffff);
    const color_mixer mixer(fill.blending);
    const mixed_color color = mixer.color(fill.color);
    const auto paint = [&](const covered_run& run) {
        if (fill.gradient != nullptr) {
            colors_.resize(static_cast<std::size_t>(run.last - run.first));
            fill.gradient->colors(run.first, run.row, colors_);
        }
        paint_run(run, [&](std::int32_t x, std::int32_t, std::uint32_t word, int share) {
            const auto i = static_cast<std::size_t>(x - run.first);
            if (fill.gradient == nullptr)
                return mixer.over(word, color, share / 255.0);
            const std::uint32_t here = colors_[i];
            const int covered = share_of(here, share);
            if (covered == 0)
                return word;
            if (is_coded)
                return blended_over_gap(word, here, covered);
            return mixer.over(word, mixer.color(here), covered / 255.0);
        });
    };
    for (const covered_span& s : spans)
        s.visit_runs(paint);
}

/// Draws an image. An opaque image that is only moved by whole pixels is copied where it covers
/// pixels wholly.
void l3d_rasterizer_2d_sw_imp::do_draw_image(const l3d_placed_image& image, const l3d_fill& fill) {
    const color_mixer mixer(fill.blending);
    image_sampler sampler(image, mixer);
    const l3d_path reach = sampler.reach();
    path_scan::order order = order_of(reach, fill, l3d_whole(target_.size()));
    const double alpha = order.full / 255;
    if (alpha == 0)
        return;
    order.full = 255; // alpha is not rounded
    const bool is_copied = sampler.is_moved_only() && !image.transparent && alpha == 1;
    const l3d_pixel_box whole{sampler.moved_x(), sampler.moved_y(),
                              sampler.moved_x() + image.pixels.width,
                              sampler.moved_y() + image.pixels.height};
    const auto copy = [&](const covered_run& run) {
        const std::uint32_t* const row =
            image.pixels.words + (run.row - sampler.moved_y()) * image.pixels.stride;
        const std::int32_t first = std::max(run.first, whole.left);
        const std::int32_t last = std::min(run.last, whole.right);
        if (run.row >= whole.top && run.row < whole.bottom && first < last)
            std::transform(row + (first - whole.left), row + (last - whole.left),
                           target_.row(run.row).data() + first,
                           [](std::uint32_t word) { return word & 0x00ffffff; });
    };
    const auto paint = [&](const covered_run& run) {
        if (is_copied && run.value == 255)
            return copy(run);
        paint_run(run, [&](std::int32_t x, std::int32_t y, std::uint32_t word, int share) {
            return mixer.over(word, sampler.at(x, y), share / 255.0 * alpha);
        });
    };
    for (const covered_span& s : paths_.convert(order))
        s.visit_runs(paint);
}

void l3d_rasterizer_2d_sw_imp::do_draw_curves(const l3d_path& path, std::uint32_t color) {
    visit_curve_pixels(path, target_.size(),
                       [&](int x, int y) { target_.words[y * target_.stride + x] = color; });
}

void l3d_rasterizer_2d_sw_imp::do_draw_mesh(std::span<const l3d_mesh_patch> patches) {
    mesh_dicer dicer(patches, mesh_colors::bilinear);
    dicer.visit([&](const mesh_strip& strip) {
        for (std::size_t i = 0; (i = shade_strip(target_, strip, ends_, i)) < 2 * strip.cells();
             ++i) {
            const mesh_cell cell = strip.cell(i / 2);
            const auto corner = [&cell](std::size_t k) {
                return shaded_corner{lattice_point(cell.corners[k].at),
                                     {static_cast<double>(k % 2), static_cast<double>(k / 2), 0}};
            };
            const auto [p, q, r] = cell.triangles()[i % 2];
            shade_bilinear(target_, cell,
                           triangle_.convert({corner(p), corner(q), corner(r)}, target_.size()));
        }
    });
}
