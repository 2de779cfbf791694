// SPDX-License-Identifier: MIT
// wide_rows: rows of large polygons, a vector of pixels at a time.
#ifndef L3D_RASTER_SURFACES_WIDE_ROWS_P_H
#define L3D_RASTER_SURFACES_WIDE_ROWS_P_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// How a shader makes words of the numbers that are interpolated behind inv_w.
struct row_light {
    enum class kind {
        word,   ///< of none: it is `word`
        held,   ///< of one: its intensity, held between darkest and brightest
        normal, ///< of four: a normal of any length, and how far it points away from the eye
        code    ///< of three: a normal as normal_code has it; expects a second plane of words
    };

    kind by = kind::word;
    std::uint32_t word = 0;
    float darkest = 0, brightest = 1;
    std::array<float, 3> light{}; ///< unit vector to the light
};

/// Columns [begin, end) of a row, and the numbers of the polygon at `start`: inv_w, then others.
///
/// Shape: the pointers are those of column 0. Without a depth buffer, `depths` is null and all is
///        written. `normals` is for row_light::kind::code.
struct wide_row {
    static constexpr std::size_t most_numbers = 5;

    std::uint32_t* words = nullptr;
    float* depths = nullptr;
    std::uint32_t* normals = nullptr;
    std::int32_t start = 0, begin = 0, end = 0;
    std::array<float, most_numbers> value{};
};

/// The data that all rows of a polygon have in common.
struct wide_polygon {
    std::array<float, wide_row::most_numbers> step{}; ///< what a column adds
    float farthest = 0, nearest = 0;                  ///< inv_w is held between them
    row_light light;
    std::int32_t width = 0;        ///< of the picture; >= fill_least_width
    std::uint32_t unit = 0x010101; ///< a grey level of 1 in a word
    std::uint32_t material = 0;    ///< the rest of a word
    std::uint32_t color = white;   ///< that multiplies words, if they are painted
    static constexpr std::uint32_t white = 0xffffff;
};

/// Fills rows of one polygon and returns how many pixels were written.
///
/// The same bits as surface_fill gives pixel by pixel, and l3d_painter, with the shader that the
/// light is of.
/// Expects: 0 <= begin < end <= width; start <= begin. Words and depths of whole rows may be read
///          and written back.
std::int64_t fill_wide_rows(const wide_polygon& of, std::span<const wide_row> rows);

} // namespace l3d_detail

#endif
