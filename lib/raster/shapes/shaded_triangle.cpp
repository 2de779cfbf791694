// SPDX-License-Identifier: MIT
// shaded_triangle: walks along the edges first, and then along the spans between them.
#include "raster/shapes/shaded_triangle_p.h"

#include <algorithm>

namespace l3d_detail {

namespace {

/// The leftmost column that may be a span's anchor (shaded_span). Floats hold whole numbers exactly
/// up to 2^24, and pictures are at most 2^23 wide.
constexpr std::int32_t farthest_anchor = -(1 << 23);

std::array<double, 3> between(const std::array<double, 3>& from, const std::array<double, 3>& to,
                              double part) {
    std::array<double, 3> result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = from[i] + (to[i] - from[i]) * part;
    return result;
}

wide_integer doubled_area(const std::array<shaded_corner, 3>& c) {
    const far_point a = c[0].at, b = c[1].at, d = c[2].at;
    return wide_integer{b.x - a.x} * (d.y - a.y) - wide_integer{b.y - a.y} * (d.x - a.x);
}

} // namespace

std::span<const shaded_span> shaded_triangle::convert(const std::array<shaded_corner, 3>& corners,
                                                      l3d_size size) {
    const auto height = static_cast<std::size_t>(std::max(size.height, 0));
    if (ends_.size() < height)
        ends_.resize(height);
    spans_.clear();
    top_ = size.height;
    bottom_ = 0;
    const wide_integer area = doubled_area(corners);
    if (area == 0)
        return spans_;
    for (std::size_t i = 0; i < 3; ++i) {
        const shaded_corner &from = corners[i], &to = corners[(i + 1) % 3];
        const bool down = from.at.y < to.at.y;
        add_edge(down ? from : to, down ? to : from, down != (area > 0), size.height);
    }
    for (std::int32_t row = top_; row < bottom_; ++row)
        add_span(row, size.width);
    return spans_;
}

void shaded_triangle::add_edge(const shaded_corner& upper, const shaded_corner& lower, bool left,
                               std::int32_t height) {
    const std::int32_t top = std::max(first_centre(upper.at.y), 0);
    const std::int32_t bottom = std::min(first_centre(lower.at.y), height);
    if (top >= bottom)
        return;
    top_ = std::min(top_, top);
    bottom_ = std::max(bottom_, bottom);
    exact_edge edge(upper.at, lower.at, top);
    const auto rows = static_cast<double>(lower.at.y - upper.at.y);
    for (std::int32_t row = top; row < bottom; ++row, edge.step()) {
        const std::int64_t down =
            std::int64_t{l3d_subpixel_one} * row + l3d_subpixel_one / 2 - upper.at.y;
        ends_[static_cast<std::size_t>(row)][left ? 0 : 1] = {
            edge.column(), left ? edge.beyond() : edge.short_of(),
            between(upper.color, lower.color, static_cast<double>(down) / rows)};
    }
}

void shaded_triangle::add_span(std::int32_t row, std::int32_t width) {
    const auto& [left, right] = ends_[static_cast<std::size_t>(row)];
    shaded_span span{row,
                     std::max(left.column, 0),
                     std::min(right.column, width),
                     std::max(left.column, farthest_anchor),
                     {},
                     {}};
    if (span.first >= span.last)
        return;
    const double between_samples = right.column - 1.0 - left.column;
    const double whole = left.distance + between_samples + right.distance;
    const double to_anchor = left.distance + (span.anchor - 1.0 * left.column);
    for (std::size_t i = 0; i < 3; ++i) {
        const double step = (right.color[i] - left.color[i]) / whole;
        span.start[i] = static_cast<float>(left.color[i] + step * to_anchor);
        span.step[i] = static_cast<float>(step);
    }
    spans_.push_back(span);
}

} // namespace l3d_detail
