// SPDX-License-Identifier: MIT
// contour_pixels: what the contours of surfaces are in the pixels that they pass through.
#ifndef L3D_RASTER_REFINE_CONTOUR_PIXELS_P_H
#define L3D_RASTER_REFINE_CONTOUR_PIXELS_P_H

#include "raster/refine/contour_edges_p.h"
#include "raster/refine/drawn_depth_p.h"
#include "raster/refine/pixel_bits_p.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// A bit for each way from a pixel's centre to the middle of a side: whether contours cross it an
/// odd number of times. So two neighbours' centres lie on different sides of a contour if just one
/// of the two halves of the way between them is cut.
struct contour_cuts {
    pixel_bits up, down, left, right;

    void resize(l3d_size size) {
        for (pixel_bits* const of : {&up, &down, &left, &right})
            of->resize(size);
    }
    void clear(std::int32_t top, std::int32_t bottom) {
        for (pixel_bits* const of : {&up, &down, &left, &right})
            of->clear(top, bottom);
    }
};

/// A pixel that contours pass through, all taken together.
struct contour_pixel {
    std::int32_t x, y;
    /// The integral of x dy along the contours, and along the pixel's border from each end on to
    /// corner (0, 0). But for a whole number, the area on the right. Units: 1 / whole.
    std::int32_t area;
    std::int32_t turns;     ///< how often these ways cross the ray from the centre to the right
    std::int32_t crossings; ///< of the pixel's border
    std::uint32_t loose;    ///< 0 if each vertex is an end as often as it is a beginning, or nearly

    static constexpr std::int32_t whole = 1 << 20;

    /// One contour passes through the pixel, in one piece.
    bool simple() const { return crossings == 2 && loose == 0; }
    /// The share of the square on the right of the contour.
    std::int32_t share() const { return area & (whole - 1); }
    /// Whether the centre is on the right: 1, or on the left: 0.
    std::int32_t centre() const { return turns - (area >> 20); }
};

/// Collects the pixels of a band that visible contours pass through.
/// Lives: of one worker, kept for its memory.
class contour_pixels {
public:
    void begin(const l3d_pixel_box& band) {
        band_ = band;
        pairs_.clear();
    }

    /// Adds the pixels of an edge in which it is not hidden.
    void add(const contour_edge& edge, const drawn_depth& depth);

    /// Sums up the pairs and sets the cuts. Expects: the band's cuts are clear; `seen` is work
    /// space.
    void finish(contour_cuts& cuts, pixel_bits& seen);

    std::span<const contour_pixel> pixels() const { return pixels_; }

private:
    struct place {
        double x, y; ///< in the pixel
    };
    void pass(std::int32_t x, std::int32_t y, place from, place to, bool enters, bool leaves,
              std::uint32_t loose, const contour_edge& edge, const drawn_depth& depth);

    struct pair {
        contour_pixel of;
        std::uint32_t cuts; ///< up, down, left, right
    };

    l3d_pixel_box band_;
    std::vector<pair> pairs_;
    std::vector<contour_pixel> pixels_;
    std::vector<std::uint32_t> before_;
};

} // namespace l3d_detail

#endif
