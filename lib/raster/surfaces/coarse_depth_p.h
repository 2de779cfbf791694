// SPDX-License-Identifier: MIT
// coarse_depth: bounds of a picture's depths, tile by tile.
#ifndef L3D_RASTER_SURFACES_COARSE_DEPTH_P_H
#define L3D_RASTER_SURFACES_COARSE_DEPTH_P_H

#include "raster/surfaces/fill_kernel_p.h"
#include "raster/surfaces/pixel_box_p.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace l3d_detail {

/// A tile of a picture. A cache line of depths wide; about as large as a micro-quad at a tolerance
/// of 1/4 pixel.
struct depth_tile {
    static constexpr std::int32_t width = 16, height = 8;
};

/// The knowledge of a picture's tiles. Shape: rows of `columns` numbers, and of `words` with a bit
/// for each tile.
struct tile_table {
    std::size_t columns = 0, words = 0;
    std::vector<float> farthest;      ///< no pixel has a smaller inv_w
    std::vector<std::uint64_t> drawn; ///< whether drawn to; else depths are not even defined
    std::vector<std::uint64_t> newer; ///< whether drawn to since `farthest` was found
};

/// The tiles of a picture, which tell hidden shapes, and depths that nobody has set to 0 yet. A
/// tile's depths are set to 0 when something is drawn there, for then they are wanted in the
/// nearest cache.
///
/// Depths only come nearer in a frame, so the farthest one found for a tile stays a bound.
/// Expects: boxes not empty, inside the window, and inside the band where there is one; bands of
///          whole rows of tiles. Threads that change different bands do not meet.
class coarse_depth {
public:
    void resize(l3d_size size);

    /// Makes the words of tiles that something was drawn to show the background.
    void clear_words(const fill_band& band, const l3d_background& background,
                     std::int32_t height) const;

    /// Forgets all drawing in rows [top, bottom), whatever their depths say.
    void forget(std::int32_t top, std::int32_t bottom);

    /// Prepares a box for drawing: sets the depths of its tiles to 0 unless that was done.
    void open(const l3d_pixel_box& box, const fill_band& band);

    /// Prepares all depths of the band for reading: sets those of other tiles to 0, too.
    void open_others(const fill_band& band);

    /// Whether nothing in the box that is no nearer than `nearest` would be seen.
    /// Cost:    for a tile that may hide it, one to eight cache lines of depths.
    bool hidden(const l3d_pixel_box& box, float nearest, const fill_band& band);

    /// Whether something is hidden by the bounds found already.
    bool hidden(const l3d_pixel_box& box, float nearest) const;

    /// Finds the farthest depths of all tiles of the band that were drawn to.
    void refresh(const fill_band& band);

    /// Whether something may be in the pixel's tile; else its depth is not defined.
    bool drawn_at(std::int32_t x, std::int32_t y) const {
        const auto column = static_cast<std::size_t>(x / depth_tile::width);
        const auto row = static_cast<std::size_t>(y / depth_tile::height);
        return (table_.drawn[row * table_.words + column / 64] >> (column % 64) & 1) != 0;
    }

    /// The columns in which something may be, in a tile that has pixels of rows [top, bottom); as
    /// a box of these rows.
    l3d_pixel_box drawn_in(std::int32_t top, std::int32_t bottom) const;

    /// Calls visit(box) for rows of tiles of the band in which something may be.
    template <class Visit> void visit_drawn(const fill_band& band, const Visit& visit) const {
        constexpr std::int32_t width = depth_tile::width, height = depth_tile::height;
        for (std::int32_t y = band.top; y < band.bottom; y += height)
            for (std::int32_t x = 0, end = 0; x < band.width; x = end) {
                const bool drawn = drawn_at(x, y);
                for (end = x + width; end < band.width && drawn_at(end, y) == drawn;)
                    end += width;
                if (drawn)
                    visit({x, y, std::min(end, band.width), std::min(y + height, band.bottom)});
            }
    }

    /// The number of pixels of the band that something covers.
    std::int64_t covered(const fill_band& band) const;

private:
    tile_table table_;
};

} // namespace l3d_detail

#endif
