// SPDX-License-Identifier: MIT
// depth_lines: wide lines with depth, hidden where a depth buffer has something nearer.
#ifndef L3D_RASTER_LINES_DEPTH_LINES_P_H
#define L3D_RASTER_LINES_DEPTH_LINES_P_H

#include "raster/depth_buffer.h"
#include "raster/surface_rasterizer.h"
#include "tool_2d/pixels.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace l3d_detail {

/// An end of a chord. Chords are the straight pieces of a line with depth.
/// Units: pixels from the picture's top left corner; the depth is that of a depth buffer.
struct depth_point {
    double x = 0, y = 0, depth = 0;
};

/// The meaning of the depths in a depth buffer: 1 / distance, or base + step * distance in a
/// parallel projection.
struct depth_law {
    double focal; ///< pixels for each world unit, at distance 1 or in a parallel projection
    /// The depth_base and depth_step of l3d_shading; `step` is 0 in perspective.
    double base = 0, step = 0;

    /// The change of depth between two places whose distances differ by the size of a pixel at this
    /// depth.
    double per_pixel(double depth) const { return (step == 0 ? depth : std::abs(step)) / focal; }
};

/// Draws a line with depth. It gathers the pixels that the line's chords cover. Then it paints each
/// pixel once, even if several chords reach the pixel at joints or crossings.
///
/// A chord ends in half discs, which also form the joints. Let d be the distance of a pixel's
/// centre from the chord. With smooth edges, the coverage is width / 2 + 1/2 - d, clamped to the
/// range from 0 to the smaller of 1 and the width. With hard edges, a pixel is covered if d is at
/// most half of the width, or 1/2 for thinner lines.
class depth_lines {
public:
    /// The properties of a line with depth, and the depth buffer of the surfaces that hide it.
    /// Lives:   borrows the depth until paint().
    /// Units:   width and error in pixels. `error` is the largest error of the surfaces and of the
    ///          line along their normals.
    struct line {
        const l3d_depth_buffer& depth;
        double width, error;
        depth_law law;
        bool smooth;
    };

    /// Adds a chord. Expects: finite ends; the depth has the same size for all chords of a line.
    void add(const line& of, const depth_point& from, const depth_point& to);

    /// Paints the pixels of all added chords, with the shading's fog, and removes the chords.
    void paint(const l3d_pixels& target, std::uint32_t color, const l3d_shading& shading);

private:
    struct cell {
        float cover = 0, depth = 0;
    };

    /// A cell for each pixel of the picture; its cover is 0 outside of the line.
    std::vector<cell> cells_;
    std::vector<std::size_t> covered_;
};

} // namespace l3d_detail

#endif
