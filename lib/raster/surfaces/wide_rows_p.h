// SPDX-License-Identifier: MIT
// wide_rows: fills rows of large polygons, a vector of pixels at a time.
#ifndef L3D_RASTER_SURFACES_WIDE_ROWS_P_H
#define L3D_RASTER_SURFACES_WIDE_ROWS_P_H

#include "raster/shapes/attribute_plane_p.h"
#include "raster/surfaces/fill_kernel_p.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// The way in which a shader makes words from its interpolated numbers, which come after inv_w.
struct row_light {
    enum class kind {
        word,   ///< no number: all pixels have the member `word`
        held,   ///< one number: the intensity, clamped to the range from darkest to brightest
        normal, ///< four numbers: a normal of any length, and its product with the ray from the eye
        code    ///< three numbers: a normal as in normal_code; x and y go to the band's normals
    };

    kind by = kind::word;
    std::uint32_t word = 0;
    float darkest = 0, brightest = 1;
    std::array<float, 3> light{}; ///< unit vector towards the light
};

/// Runs of columns [begin, end) in some rows of a polygon. Interpolated numbers are counted from
/// column `start`.
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

/// The data that all rows of a polygon share.
struct wide_polygon {
    static constexpr std::size_t most_numbers = 5;

    plane_view planes; ///< the plane of inv_w, then the planes of other numbers
    /// The least and the largest inv_w of the polygon, to which inv_w is clamped.
    float farthest = 0, nearest = 0;
    row_light light;
    std::uint32_t unit = 0x010101; ///< the pixel word of grey level 1, without the material
    std::uint32_t material = 0;    ///< the part of a word that tells the material
};

/// Fills rows of one polygon, and returns how many pixels were written.
///
/// The result has the same bits as a result of surface_fill, which fills pixel by pixel with the
/// shader that made the row_light.
/// Shape:   the band's normals are used only with row_light::kind::code.
/// Expects: rows of the band; 0 <= begin, end <= width, start <= begin; no columns if begin >= end.
///          Words and depths of whole rows may be read and written back.
std::int64_t fill_wide_rows(const fill_band& band, const wide_polygon& of, const wide_runs& runs);

} // namespace l3d_detail

#endif
