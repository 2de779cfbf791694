// SPDX-License-Identifier: MIT
// contour_pixels: what the contours of surfaces are in the pixels that they pass through.
#ifndef L3D_RASTER_REFINE_CONTOUR_PIXELS_P_H
#define L3D_RASTER_REFINE_CONTOUR_PIXELS_P_H

#include "raster/refine/contour_edges_p.h"
#include "raster/refine/drawn_depth_p.h"
#include "raster/refine/pixel_bits_p.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Which ways between the centres of neighbours contours cross an odd number of times. So these
/// lie on different sides of a contour.
///
/// Ways down are in halves, since bands are worked on side by side: from a pixel's centre to the
/// middle of its lower side, and on from the upper side of the next one.
struct contour_cuts {
    pixel_bits right, down, up;

    void resize(l3d_size size) {
        for (pixel_bits* const of : {&right, &down, &up})
            of->resize(size);
    }
    void clear(std::int32_t top, std::int32_t bottom) {
        for (pixel_bits* const of : {&right, &down, &up})
            of->clear(top, bottom);
    }

    /// Whether the pixel on the right is on another side. Expects: it is in the picture.
    bool on_right(std::int32_t x, std::int32_t y) const { return right.has(x, y); }
    /// Whether the pixel below is. Expects: it is in the picture.
    bool below(std::int32_t x, std::int32_t y) const { return down.has(x, y) != up.has(x, y + 1); }
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

    /// Of more than two crossings: beginnings and ends of contours take turns round the border. So
    /// all of them together divide the square into two, what is on the right and what is not.
    bool takes_turns;

    /// The way along the contours in the pixel, and the sums of its pieces' cross products with
    /// ways from them to the centre, positive if that is on the right. Units: 1 / whole.
    std::int32_t along_x, along_y, to_centre;

    /// The sums of the pieces' lengths, and of these times contour_edge::level.
    std::int32_t length, levels;

    contour_edge::quad_place beside, also; ///< of one of its contours

    bool folds = true; ///< at all of its contours, the surface on the right folds over

    static constexpr std::int32_t whole = 1 << 20;

    /// One contour passes through the pixel, or several of one surface, each in one piece.
    bool simple() const { return loose == 0 && (crossings == 2 || takes_turns); }
    /// The share of the square on the right of the contour.
    std::int32_t share() const { return area & (whole - 1); }
    /// The level at the contour, if vertices have levels.
    float level() const {
        return length > 0 ? static_cast<float>(levels) / static_cast<float>(length) : 0.0f;
    }
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
        std::uint32_t cuts;         ///< up, down, left, right
        float enters_at, leaves_at; ///< the way along the border from corner (0, 0); -1: not there
        std::uint32_t pixel;        ///< which of pixels_
        std::uint32_t before;       ///< 1 + index of another one in the pixel; 0: it is the first

        bool coincides(const pair& other) const;
    };
    struct end {
        std::uint32_t pixel;
        float at;
        bool enters;

        friend auto operator<=>(const end&, const end&) = default;
    };

    bool is_again(pair& p);
    void find_turns();

    l3d_pixel_box band_;
    std::vector<pair> pairs_;
    std::vector<contour_pixel> pixels_;
    std::vector<end> ends_;
    std::vector<std::uint32_t> before_;
    std::vector<std::uint32_t> last_;  ///< 1 + index of a pair in each of pixels_; 0: there is none
    std::vector<std::uint32_t> count_; ///< of pairs in each of pixels_
};

} // namespace l3d_detail

#endif
