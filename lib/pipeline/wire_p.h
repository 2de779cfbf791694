// SPDX-License-Identifier: MIT
// wire: lines between places of surfaces, sharp or smooth.
#ifndef L3D_PIPELINE_WIRE_P_H
#define L3D_PIPELINE_WIRE_P_H

#include "base/number_hash_p.h"
#include "raster/surface_part.h"
#include "raster/paths/path.h"
#include "raster/rasterizer_2d.h"
#include "raster/lines/line_cover_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <unordered_set>
#include <vector>

namespace l3d_detail {

/// A line in the picture, with the depths of its ends.
/// Units: 1/256 pixel from the picture's top left corner; depths as in l3d_shading.
struct wire {
    std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    float from_inv_w = 0, to_inv_w = 0;

    /// The line between the pixels in which the two ends lie. The shifts round down, even below
    /// zero.
    l3d_line_2d sharp() const {
        return {x0 >> l3d_subpixel_bits, y0 >> l3d_subpixel_bits, x1 >> l3d_subpixel_bits,
                y1 >> l3d_subpixel_bits};
    }
};

/// A set of lines, to draw a line that neighbours share only once. Both directions of a line count
/// as the same.
class shared_wires {
public:
    /// Adds a line. Returns whether the set did not have this line before.
    bool add(const wire& w) {
        const std::uint64_t from = place(w.x0, w.y0), to = place(w.x1, w.y1);
        return seen_.insert({std::min(from, to), std::max(from, to)}).second;
    }

private:
    using ends = std::array<std::uint64_t, 2>;

    static std::uint64_t place(std::int32_t x, std::int32_t y) {
        return std::uint64_t{std::bit_cast<std::uint32_t>(x)} << 32 |
               std::bit_cast<std::uint32_t>(y);
    }

    std::unordered_set<ends, number_hash> seen_;
};

/// The colour of wireframes: light blue, which is seen on the dark ground and on grey surfaces.
inline constexpr std::uint32_t wire_color = 0x0080d0ff;

/// The colour of control nets: orange.
inline constexpr std::uint32_t net_color = 0x00ff9030;

/// Draws lines of one colour, either sharp or smooth.
class wire_drawer {
public:
    /// Units: `width` of lines in pixels. It is l3d_screen::text_scale: 1 on usual displays, more
    ///        on finer ones.
    wire_drawer(l3d_rasterizer_2d& rasterizer, std::uint32_t color, bool smooth, double width)
        : rasterizer_(rasterizer), color_(color), smooth_(smooth), width_(width) {}

    void draw(std::span<const wire> wires) {
        if (width_ > 1)
            return draw_wide(wires);
        if (smooth_) {
            for (const wire& w : wires)
                rasterizer_.draw_line_antialiased(line_place(w.x0, w.y0), line_place(w.x1, w.y1),
                                                  color_);
            return;
        }
        lines_.clear();
        for (const wire& w : wires)
            lines_.push_back(w.sharp());
        rasterizer_.draw_lines(lines_, color_);
    }

private:
    /// Draws wide lines with square ends. Smooth lines become one path, so that the colour is mixed
    /// only once into pixels under several lines.
    void draw_wide(std::span<const wire> wires) {
        path_.clear();
        for (const wire& w : wires) {
            const l3d_point_2d from = line_place(w.x0, w.y0), to = line_place(w.x1, w.y1);
            const double length = std::hypot(to.x - from.x, to.y - from.y);
            const double x = length > 0 ? (to.x - from.x) / length * width_ / 2 : width_ / 2;
            const double y = length > 0 ? (to.y - from.y) / length * width_ / 2 : 0;
            const std::array corners{l3d_point_2d{from.x - x + y, from.y - y - x},
                                     l3d_point_2d{to.x + x + y, to.y + y - x},
                                     l3d_point_2d{to.x + x - y, to.y + y + x},
                                     l3d_point_2d{from.x - x - y, from.y - y + x}};
            if (smooth_)
                path_.add_polygon(corners);
            else
                rasterizer_.draw_polygon_flatshaded(corners, color_);
        }
        if (smooth_)
            rasterizer_.draw_path(path_, {.color = color_});
    }

    l3d_rasterizer_2d& rasterizer_;
    std::uint32_t color_;
    bool smooth_;
    double width_;
    std::vector<l3d_line_2d> lines_;
    l3d_path path_;
};

/// Draws a picture of lines alone, such as a wireframe, over a background, with fog if it is on. No
/// line hides another.
///
/// Without a background, or in fog, draw() writes how much of each pixel lines cover. Then finish()
/// colours the pixels by this cover (line_cover_p.h). In fog, the nearest line decides how dim a
/// pixel is.
class wire_picture {
public:
    /// Starts a picture with the background alone. Units: `width` as in wire_drawer.
    wire_picture(l3d_rasterizer_2d& rasterizer, const l3d_pixels& picture,
                 const l3d_shading& shading, bool smooth, double width)
        : rasterizer_(rasterizer), picture_(picture), shading_(shading), smooth_(smooth),
          reach_(width > 1 ? static_cast<int>(std::ceil(width * std::numbers::sqrt2 / 2)) : 0),
          covers_(shading.background.is_none() || shading.fog.is_on()),
          drawer_(rasterizer, covers_ ? whole_cover : wire_color, smooth, width) {
        (covers_ ? l3d_background() : shading.background).fill(picture);
        if (shading.fog.is_on()) {
            depths_.resize(picture.size());
            depths_.clear();
        }
    }

    void draw(std::span<const wire> wires) {
        drawer_.draw(wires);
        if (shading_.fog.is_on())
            for (const wire& w : wires)
                note_depths(w);
    }

    /// Colours the pixels by their cover, without a background or in fog. Afterwards the picture is
    /// complete.
    void finish() {
        if (!covers_)
            return;
        rasterizer_.finish();
        color_cover(picture_, {0, picture_.height}, shading_, wire_color, depths_);
    }

private:
    static constexpr std::uint32_t whole_cover = 255;

    /// Notes the depths of the pixels along a line, for the fog. For a wide line, it notes depths
    /// over the line's width and up to the line's corners.
    void note_depths(const wire& w) {
        const double change = double{w.to_inv_w} - double{w.from_inv_w};
        visit_side({w.x0, w.y0, w.from_inv_w, {}}, {w.x1, w.y1, w.to_inv_w, {}}, picture_.size(),
                   smooth_ || reach_ > 0, [&](int x, int y, double along, int) {
                       const auto here = static_cast<float>(w.from_inv_w + along * change);
                       const l3d_pixel_box near =
                           l3d_pixel_box{x, y, x + 1, y + 1}.grown(reach_).intersected(
                               l3d_whole(picture_.size()));
                       for (int row = near.top; row < near.bottom; ++row)
                           for (int column = near.left; column < near.right; ++column) {
                               float& depth = depths_.row(row)[static_cast<std::size_t>(column)];
                               depth = std::max(depth, here);
                           }
                   });
    }

    l3d_rasterizer_2d& rasterizer_;
    const l3d_pixels picture_;
    const l3d_shading shading_;
    const bool smooth_;
    const int reach_;
    const bool covers_;
    wire_drawer drawer_;
    l3d_depth_buffer depths_;
};

} // namespace l3d_detail

#endif
