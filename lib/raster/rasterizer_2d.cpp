// SPDX-License-Identifier: MIT
// l3d_rasterizer_2d_imp: draws coverage for outputs that cannot mix colours, and paths for all.
#include "raster/rasterizer_2d.h"

#include "raster/images/image_sampler_p.h"
#include "raster/paths/curve_pixels_p.h"
#include "raster/paths/gradient.h"
#include "raster/paths/mesh_dicer_p.h"
#include "raster/paths/path_scan_p.h"
#include "raster/shapes/blend_p.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace {

/// The size of an output that does not tell its size.
constexpr l3d_size largest{l3d_largest_side, l3d_largest_side};

} // namespace

/// Draws a box by a polygon. A pixel whose sample is on the left or top edge belongs to the
/// polygon; a pixel on the right or bottom edge does not.
void l3d_rasterizer_2d::draw_box(const l3d_pixel_box& box, std::uint32_t color) {
    if (box.empty())
        return;
    const double left = box.left, top = box.top, right = box.right, bottom = box.bottom;
    imp_.do_draw_polygon_flatshaded(
        std::array<l3d_point_2d, 4>{{{left, top}, {right, top}, {right, bottom}, {left, bottom}}},
        color);
}

void l3d_rasterizer_2d_imp::do_draw_line(int x0, int y0, int x1, int y1, std::uint32_t color) {
    const l3d_line_2d line{x0, y0, x1, y1};
    do_draw_lines({&line, 1}, color);
}

void l3d_rasterizer_2d_imp::do_draw_coverage(const l3d_coverage_2d& shape, std::uint32_t color) {
    constexpr int half = 128;
    const auto covers = [](std::uint8_t value) { return value >= half; };
    for (int y = 0; y < shape.height; ++y) {
        const auto row = shape.row(y);
        for (auto at = std::ranges::find_if(row, covers); at != row.end();) {
            const auto end = std::find_if_not(at, row.end(), covers);
            const l3d_line_2d run{shape.left + static_cast<int>(at - row.begin()), shape.top + y,
                                  shape.left + static_cast<int>(end - row.begin()) - 1,
                                  shape.top + y};
            do_draw_lines({&run, 1}, color);
            at = std::find_if(end, row.end(), covers);
        }
    }
}

void l3d_rasterizer_2d_imp::do_draw_path(const l3d_path& path, const l3d_fill& fill) {
    l3d_detail::path_scan scan;
    const auto spans = scan.convert(l3d_detail::order_of(path, fill, l3d_whole(largest)));
    std::vector<std::uint8_t> same;
    std::vector<std::uint32_t> colors;
    const auto draw = [&](const l3d_detail::covered_run& run) {
        const int count = run.last - run.first;
        if (run.value >= 0)
            same.assign(static_cast<std::size_t>(count), static_cast<std::uint8_t>(run.value));
        const std::uint8_t* values = run.value >= 0 ? same.data() : scan.values() + run.values;
        if (fill.gradient == nullptr)
            return do_draw_coverage({run.first, run.row, count, 1, values, 0}, fill.color);
        colors.resize(static_cast<std::size_t>(count));
        fill.gradient->colors(run.first, run.row, colors);
        for (int i = 0; i < count; ++i) {
            const std::uint32_t color = colors[static_cast<std::size_t>(i)];
            const auto covered = static_cast<std::uint8_t>(l3d_detail::share_of(color, values[i]));
            do_draw_coverage({run.first + i, run.row, 1, 1, &covered, 0}, color & 0x00ffffff);
        }
    };
    for (const l3d_detail::covered_span& s : spans)
        s.visit_runs(draw);
}

void l3d_rasterizer_2d_imp::do_draw_image(const l3d_placed_image& image, const l3d_fill& fill) {
    const l3d_detail::color_mixer mixer(fill.blending);
    l3d_detail::image_sampler sampler(image, mixer);
    l3d_detail::path_scan scan;
    const l3d_path reach = sampler.reach();
    const auto draw = [&](const l3d_detail::covered_run& run) {
        const std::uint8_t* const values = scan.values() + run.values;
        for (int x = run.first; x < run.last; ++x) {
            const auto color = sampler.at(x, run.row);
            const int share = run.value >= 0 ? run.value : values[x - run.first];
            const auto covered = static_cast<std::uint8_t>(share * color.opacity + 0.5);
            if (covered > 0)
                do_draw_coverage({x, run.row, 1, 1, &covered, 0}, mixer.word(color));
        }
    };
    for (const l3d_detail::covered_span& s :
         scan.convert(l3d_detail::order_of(reach, fill, l3d_whole(largest))))
        s.visit_runs(draw);
}

void l3d_rasterizer_2d_imp::do_draw_curves(const l3d_path& path, std::uint32_t color) {
    l3d_detail::visit_curve_pixels(path, largest,
                                   [&](int x, int y) { do_draw_point(x, y, color); });
}

void l3d_rasterizer_2d_imp::do_draw_mesh(std::span<const l3d_mesh_patch> patches) {
    const auto rounded = [](const l3d_detail::mesh_corner& c) {
        const auto level = [&c](std::size_t k) {
            return static_cast<std::uint32_t>(c.color[k] + 0.5);
        };
        return l3d_colored_point_2d{c.at.x, c.at.y, level(0) << 16 | level(1) << 8 | level(2)};
    };
    l3d_detail::mesh_dicer dicer(patches, l3d_detail::mesh_colors::linear);
    dicer.visit([&](const l3d_detail::mesh_strip& strip) {
        for (std::size_t i = 0; i < strip.cells(); ++i) {
            const l3d_detail::mesh_cell cell = strip.cell(i);
            for (const auto& [p, q, r] : cell.triangles())
                do_draw_polygon_gouraudshaded(std::array{
                    rounded(cell.corners[p]), rounded(cell.corners[q]), rounded(cell.corners[r])});
        }
    });
}
