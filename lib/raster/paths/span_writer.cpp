// SPDX-License-Identifier: MIT
// span_writer: lengthens the last span, or begins a new one.
#include "raster/paths/span_writer_p.h"

namespace l3d_detail {

void span_writer::begin(const l3d_pixel_box& box, double full) {
    box_ = box;
    width_ = box.right - box.left;
    full_ = full;
    spans_.clear();
    values_.clear();
}

/// Makes room for a value for each column from `first` to `end`: in the last span if it ends at
/// `first`, else in a new span.
void span_writer::add_span(std::int32_t row, std::int32_t first, std::int32_t end) {
    if (ends_at(row, first))
        spans_.back().between = spans_.back().beyond = spans_.back().last = end;
    else
        spans_.push({row, first, end, end, end, 0, values_.size()});
}

/// Whether the last span can grow at this column. It can if it ends at this column, if its last
/// columns have a value each, and if its values were added last.
bool span_writer::ends_at(std::int32_t row, std::int32_t column) {
    if (spans_.size() == 0)
        return false;
    const covered_span& s = spans_.back();
    return s.row == row && s.last == column && s.between == s.last &&
           s.values + s.values_before() == values_.size();
}

std::uint8_t* span_writer::add_values(std::int32_t row, std::int32_t first, std::int32_t end) {
    const std::int32_t seen = std::min(end, width_);
    if (first < seen)
        add_span(row + box_.top, first + box_.left, seen + box_.left);
    const auto count = static_cast<std::size_t>(end - first);
    std::uint8_t* const values = values_.room(count);
    values_.use(count);
    return values;
}

void span_writer::add_solid(std::int32_t row, std::int32_t first, std::int32_t end, int value) {
    end = std::min(end, width_);
    if (first >= end || value == 0)
        return;
    const std::int32_t y = row + box_.top, left = first + box_.left, right = end + box_.left;
    if (spans_.size() > 0 && spans_.back().value == value && spans_.back().row == y &&
        spans_.back().beyond == left && spans_.back().last == left) {
        spans_.back().beyond = spans_.back().last = right;
    } else {
        spans_.push({y, left, left, right, right, value, 0});
    }
}

} // namespace l3d_detail
