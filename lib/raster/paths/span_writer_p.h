// SPDX-License-Identifier: MIT
// span_writer: collects the spans of a path, row by row.
#ifndef L3D_RASTER_PATHS_SPAN_WRITER_P_H
#define L3D_RASTER_PATHS_SPAN_WRITER_P_H

#include "raster/paths/covered_span_p.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// Collects the spans of a path's covered pixels. Rows and columns are those of a box of the
/// picture.
class span_writer {
public:
    /// Removes all spans. `full` is the value of a pixel that is covered wholly, at most 255.
    void begin(const l3d_pixel_box& box, double full);

    double full() const { return full_; }
    std::uint8_t value_of(double covered) const {
        return static_cast<std::uint8_t>(std::clamp(covered, 0.0, 1.0) * full_ + 0.5);
    }

    /// Adds columns first <= column < end that have a value each. Columns beyond the box are left
    /// out. Returns the place to which the caller writes the values.
    std::uint8_t* add_values(std::int32_t row, std::int32_t first, std::int32_t end);

    /// Adds columns first <= column < end that share one value.
    void add_solid(std::int32_t row, std::int32_t first, std::int32_t end, int value);

    /// The lists of spans and of values, for callers that add to them directly.
    kept_list<covered_span>& spans() { return spans_; }
    kept_list<std::uint8_t>& values() { return values_; }
    const kept_list<std::uint8_t>& values() const { return values_; }

private:
    void add_span(std::int32_t row, std::int32_t first, std::int32_t end);
    bool ends_at(std::int32_t row, std::int32_t column);

    l3d_pixel_box box_{};
    std::int32_t width_ = 0;
    double full_ = 255;
    kept_list<covered_span> spans_;
    kept_list<std::uint8_t> values_;
};

} // namespace l3d_detail

#endif
