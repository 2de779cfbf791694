// SPDX-License-Identifier: MIT
// wide_rows: rows of large polygons, a vector of pixels at a time.
#ifndef L3D_RASTER_SURFACES_WIDE_ROWS_P_H
#define L3D_RASTER_SURFACES_WIDE_ROWS_P_H

#include "raster/shapes/attribute_plane_p.h"
#include "raster/surfaces/fill_kernel_p.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// How a shader makes words of the numbers that are interpolated behind inv_w.
struct row_light {
    enum class kind {
        word,   ///< no number: it is `word`
        held,   ///< one number: its intensity, held between darkest and brightest
        normal, ///< four numbers: a normal of any length, and how far it points from the eye
        code    ///< three numbers: a normal as normal_code has it; expects a second plane of words
    };

    kind by = kind::word;
    std::uint32_t word = 0;
    float darkest = 0, brightest = 1;
    std::array<float, 3> light{}; ///< unit vector to the light
};

/// Columns [begin, end) of some rows of a polygon, whose numbers are counted from column `start`.
///
/// Shape: run i is in element i of each array.
struct wide_runs {
    static constexpr std::size_t room = 32;

    alignas(64) std::array<std::int32_t, room> row, start, begin, end;
    std::size_t count = 0;

    void add(std::int32_t in_row, std::int32_t from, std::int32_t first, std::int32_t behind) {
        row[count] = in_row;
        start[count] = from;
        begin[count] = first;
        end[count++] = behind;
    }
    bool is_full() const { return count == room; }
};

/// The data that all rows of a polygon have in common.
struct wide_polygon {
    static constexpr std::size_t most_numbers = 5;

    plane_view planes;               ///< the plane of inv_w, then those of other numbers
    float farthest = 0, nearest = 0; ///< inv_w is held between them
    row_light light;
    std::uint32_t unit = 0x010101; ///< a grey level of 1 in a word
    std::uint32_t material = 0;    ///< the rest of a word
};

/// Fills rows of one polygon and returns how many pixels were written.
///
/// The same bits as surface_fill gives pixel by pixel with the shader that the light is of.
/// Shape:   the band's normals are for row_light::kind::code.
/// Expects: rows of the band; 0 <= begin, end <= width, start <= begin; no columns if begin >= end.
///          Words and depths of whole rows may be read and written back.
std::int64_t fill_wide_rows(const fill_band& band, const wide_polygon& of, const wide_runs& runs);

} // namespace l3d_detail

#endif
