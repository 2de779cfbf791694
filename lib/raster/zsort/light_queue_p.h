// SPDX-License-Identifier: MIT
// light_queue: pixels that are lit many at a time, however few of them are side by side.
#ifndef L3D_RASTER_ZSORT_LIGHT_QUEUE_P_H
#define L3D_RASTER_ZSORT_LIGHT_QUEUE_P_H

#include "raster/shapes/scan_edge_p.h"
#include "raster/surfaces/fill_kernel_p.h"
#include "raster/surfaces/wide_rows_p.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// Pixels that wait for their light.
///
/// Shape: the pixels of a part are side by side in the picture and in the arrays; parts follow each
///        other. Whole vectors are written, so arrays are longer than their room.
struct unlit_pixels {
    static constexpr std::size_t room = 512; ///< 6 KB of arrays: they stay in the nearest cache
    static constexpr std::size_t most_parts = room / 4; ///< rows of small triangles are so long
    /// A longer run is several parts. An eighth of the room, so that little of it stays unused.
    static constexpr std::int32_t longest_part = room / 8;
    static constexpr std::size_t widest_vector = 16; ///< numbers in 512 bits

    struct part {
        std::uint32_t* to;
        std::int32_t count;
        std::int32_t fit; ///< pixels from there to the picture's side
        std::uint32_t color;
    };

    alignas(64) std::array<float, room + widest_vector> square;  ///< of the normal
    alignas(64) std::array<float, room + widest_vector> product; ///< of the normal and the light
    alignas(64) std::array<std::uint32_t, room + widest_vector> word;
    std::array<part, most_parts> parts;
    std::size_t count = 0, part_count = 0;
};

/// A triangle that is to be lit by lambert's rule.
struct unlit_triangle {
    static constexpr std::size_t numbers = 4; ///< a normal, and how far it points away from the eye

    std::array<scan_point, 3> corners;
    alignas(16) std::array<std::array<float, numbers>, 3> normals; ///< at the corners
    std::array<float, 3> light;                                    ///< unit vector to it
    std::uint32_t color;                                           ///< that multiplies greys
};

/// Fills rows of triangles over each other by lambert's rule. The same bits as fill_wide_rows with
/// attribute_planes.
///
/// A root and a quotient are most of a pixel's time. Rows of small triangles would leave half of
/// the lanes idle; here only what is cheap is done row by row.
class light_queue {
public:
    /// Fills now or, at the latest, in finish(). Returns the number of pixels.
    /// Expects: as fill_wide_rows without depths; corners that are not in a line, and the same band
    ///          until finish().
    std::int64_t add(const fill_band& band, const unlit_triangle& of, const wide_runs& runs);

    /// Fills all that waits.
    void finish();

private:
    unlit_pixels waiting_;
};

} // namespace l3d_detail

#endif
