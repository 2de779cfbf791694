// SPDX-License-Identifier: MIT
// wire: lines between places of surfaces, sharp or smooth.
#ifndef L3D_PIPELINE_WIRE_P_H
#define L3D_PIPELINE_WIRE_P_H

#include "raster/micro_grid.h"
#include "raster/paths/path.h"
#include "raster/rasterizer_2d.h"
#include "raster/lines/line_pixels_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_set>
#include <vector>

namespace l3d_detail {

/// A line. Units: 1/256 pixel from the picture's top left corner.
struct wire {
    std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    /// The line between the pixels of its ends: a shift rounds down, also below zero.
    l3d_line_2d sharp() const {
        return {x0 >> l3d_subpixel_bits, y0 >> l3d_subpixel_bits, x1 >> l3d_subpixel_bits,
                y1 >> l3d_subpixel_bits};
    }
};

/// A set of lines that several neighbours may share, in either direction.
class shared_wires {
public:
    /// Whether this line is new.
    bool add(const wire& w) {
        const std::uint64_t from = place(w.x0, w.y0), to = place(w.x1, w.y1);
        return seen_.insert({std::min(from, to), std::max(from, to)}).second;
    }

private:
    using ends = std::array<std::uint64_t, 2>;

    struct hash {
        std::size_t operator()(const ends& of) const {
            // 2^64 by the golden ratio, odd: every bit of the ends reaches the upper half
            const std::uint64_t mixed = (of[0] ^ std::rotl(of[1], 32)) * 0x9e3779b97f4a7c15U;
            return static_cast<std::size_t>(mixed ^ mixed >> 32);
        }
    };

    static std::uint64_t place(std::int32_t x, std::int32_t y) {
        return std::uint64_t{std::bit_cast<std::uint32_t>(x)} << 32 |
               std::bit_cast<std::uint32_t>(y);
    }

    std::unordered_set<ends, hash> seen_;
};

inline constexpr std::uint32_t white = 0x00ffffff;
/// The colour of lines: light blue, seen on the dark ground and on grey surfaces.
inline constexpr std::uint32_t wire_color = 0x0080d0ff;

/// Draws lines of one colour, sharp or smooth.
class wire_drawer {
public:
    /// Units:   `width` in pixels, as l3d_screen::text_scale has it: 1 where a display is no finer
    ///          than usual.
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
    /// Draws wide lines with square ends. All smooth ones are one path, so pixels under several are
    /// covered once.
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

/// Turns white lines on black into lines of a colour on nothing: each level is the line's share of
/// the pixel. Without a background, lines are drawn in white first.
inline void make_lines_transparent(const l3d_pixels& picture, std::uint32_t color) {
    for (int y = 0; y < picture.height; ++y)
        for (std::uint32_t& word : picture.row(y)) {
            const std::uint32_t covered = word & 255;
            word = covered == 0 ? l3d_pixels::transparent : color | (255 - covered) << 24;
        }
}

} // namespace l3d_detail

#endif
