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

/// An end of a chord. Units: pixels from the picture's left upper corner; a depth as the depth
/// buffer has it.
struct depth_point {
    double x = 0, y = 0, depth = 0;
};

/// The meaning of depths: 1 / distance, or base + step distance in a parallel projection.
struct depth_law {
    double focal; ///< pixels for each world unit, at distance 1 or in a parallel projection
    double base = 0, step = 0; ///< as l3d_shading has them; step is 0 in perspective

    /// The change of depth from a place to one that is a pixel's size farther.
    double per_pixel(double depth) const { return (step == 0 ? depth : std::abs(step)) / focal; }
};

/// Gathers what the chords of one line cover, and then paints it. So a pixel that several chords
/// reach, at joints or where the line crosses itself, gets the colour once.
///
/// Chords end in half discs, which also are the joints. With smooth edges a pixel is covered by
/// width / 2 + 1/2 - d, at least 0 and at most 1 and the width, where d is its centre's distance
/// from the chord. With hard edges, it is covered if d is at most half of the width, or of 1.
class depth_lines {
public:
    /// Begins a line.
    /// Lives:   borrows the depth until paint().
    /// Units:   width and error in pixels. `error` is how far the surfaces and the line may be off
    ///          along their normals.
    struct line {
        const l3d_depth_buffer& depth;
        double width, error;
        depth_law law;
        bool smooth;
    };

    /// Adds a chord. Expects: finite ends; the depth's size is the same for all chords of a line.
    void add(const line& of, const depth_point& from, const depth_point& to);

    /// Paints the line, in the shading's fog, and forgets it.
    void paint(const l3d_pixels& target, std::uint32_t color, const l3d_shading& shading);

private:
    struct cell {
        float cover = 0, depth = 0;
    };

    std::vector<cell> cells_; ///< all of the picture, 0 outside of the line
    std::vector<std::size_t> covered_;
};

} // namespace l3d_detail

#endif
