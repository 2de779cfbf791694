// SPDX-License-Identifier: MIT
// image_sampler: samples points, boxes, and the exact areas of slanted pixels.
#include "raster/images/image_sampler_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace l3d_detail {
namespace {

/// The largest coordinate of an image's corners, the same as for paths.
constexpr double farthest = 1 << 30;

bool is_in_reach(l3d_point_2d p) {
    return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest; // false for NaN
}

/// Adds `times` times a colour to a sum.
void add(mixed_color& sum, const mixed_color& color, double times) {
    for (std::size_t k = 0; k < 3; ++k)
        sum.values[k] += color.values[k] * times;
    sum.opacity += color.opacity * times;
}

mixed_color divided(mixed_color sum, double by) {
    for (double& value : sum.values)
        value /= by;
    sum.opacity /= by;
    return sum;
}

/// The length that the intervals [i, i + 1] and [from, to] share. Expects: the intervals overlap.
double overlap(double from, double to, int i) {
    return std::min<double>(to, i + 1) - std::max<double>(from, i);
}

} // namespace

image_sampler::image_sampler(const l3d_placed_image& image, const color_mixer& mixer)
    : image_(image), mixer_(mixer) {
    const l3d_point_2d a = image.place.across, d = image.place.down, o = image.place.origin;
    determinant_ = a.x * d.y - a.y * d.x;
    upright_ = a.y == 0 && d.x == 0;
    moved_only_ = upright_ && a.x == 1 && d.y == 1 && std::floor(o.x) == o.x &&
                  std::floor(o.y) == o.y && is_in_reach(o);
    if (moved_only_) {
        moved_x_ = static_cast<std::int32_t>(o.x);
        moved_y_ = static_cast<std::int32_t>(o.y);
    }
}

l3d_path image_sampler::reach() const {
    const double right = image_.pixels.width - 0.5, bottom = image_.pixels.height - 0.5;
    std::array<l3d_point_2d, 4> corners{
        {{-0.5, -0.5}, {right, -0.5}, {right, bottom}, {-0.5, bottom}}};
    for (l3d_point_2d& corner : corners)
        corner = image_.place.at(corner);
    l3d_path result;
    if (right < 0 || bottom < 0 || !std::ranges::all_of(corners, is_in_reach) ||
        !std::isnormal(determinant_))
        return result;
    if (image_.filter == l3d_image_filter::nearest) {
        const auto [left, far_right] = std::ranges::minmax(corners, {}, &l3d_point_2d::x);
        const auto [top, far_bottom] = std::ranges::minmax(corners, {}, &l3d_point_2d::y);
        const double x0 = std::floor(left.x) - 0.5, x1 = std::ceil(far_right.x) + 0.5;
        const double y0 = std::floor(top.y) - 0.5, y1 = std::ceil(far_bottom.y) + 0.5;
        corners = {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
    }
    result.add_polygon(corners);
    return result;
}

/// Maps a place in the picture back to the image. The 0.5 is added last, when the numbers are
/// small.
l3d_point_2d image_sampler::back(double x, double y) const {
    const l3d_point_2d a = image_.place.across, d = image_.place.down;
    const double dx = x - image_.place.origin.x, dy = y - image_.place.origin.y;
    if (upright_)
        return {dx / a.x + 0.5, dy / d.y + 0.5};
    return {(dx * d.y - dy * d.x) / determinant_ + 0.5, (dy * a.x - dx * a.y) / determinant_ + 0.5};
}

mixed_color image_sampler::color(int column, int row) const {
    const std::uint32_t word = image_.pixels.words[row * image_.pixels.stride + column];
    return mixer_.color(word, opacity(word));
}

mixed_color image_sampler::at(std::int32_t x, std::int32_t y) {
    if (image_.filter == l3d_image_filter::nearest)
        return nearest(back(x, y));
    if (image_.filter == l3d_image_filter::linear)
        return linear(back(x, y));
    return upright_ ? box_mean(back(x - 0.5, y - 0.5), back(x + 0.5, y + 0.5)) : area_mean(x, y);
}

mixed_color image_sampler::nearest(l3d_point_2d at) const {
    const double column = std::floor(at.x), row = std::floor(at.y);
    if (!(column >= 0 && column < image_.pixels.width && row >= 0 && row < image_.pixels.height))
        return {};
    return color(static_cast<int>(column), static_cast<int>(row));
}

/// The colour between the four pixels of the image around a place. Places outside of the image have
/// the colours on its border.
mixed_color image_sampler::linear(l3d_point_2d at) const {
    const auto held = [](double place, int size) {
        return std::clamp(place - 0.5, 0.0, static_cast<double>(size - 1));
    };
    const double u = held(at.x, image_.pixels.width), v = held(at.y, image_.pixels.height);
    const int column = std::min(static_cast<int>(u), std::max(image_.pixels.width - 2, 0));
    const int row = std::min(static_cast<int>(v), std::max(image_.pixels.height - 2, 0));
    const int next = std::min(column + 1, image_.pixels.width - 1);
    const int below = std::min(row + 1, image_.pixels.height - 1);
    const double s = u - column, t = v - row;
    mixed_color result;
    add(result, color(column, row), (1 - s) * (1 - t));
    add(result, color(next, row), s * (1 - t));
    add(result, color(column, below), (1 - s) * t);
    add(result, color(next, below), s * t);
    return result;
}

/// The mean colour of a pixel whose sides are parallel to the image's. In the image, the pixel is
/// an axis-aligned box.
mixed_color image_sampler::box_mean(l3d_point_2d from, l3d_point_2d to) const {
    const double width = image_.pixels.width, height = image_.pixels.height;
    const double left = std::clamp(std::min(from.x, to.x), 0.0, width);
    const double right = std::clamp(std::max(from.x, to.x), 0.0, width);
    const double top = std::clamp(std::min(from.y, to.y), 0.0, height);
    const double bottom = std::clamp(std::max(from.y, to.y), 0.0, height);
    if (!(left < right && top < bottom))
        return linear({(left + right) / 2, (top + bottom) / 2});
    mixed_color sum;
    for (int row = static_cast<int>(top); row < bottom; ++row) {
        mixed_color of_row;
        for (int column = static_cast<int>(left); column < right; ++column)
            add(of_row, color(column, row), overlap(left, right, column));
        add(sum, of_row, overlap(top, bottom, row));
    }
    return divided(sum, (right - left) * (bottom - top));
}

/// The mean colour of a slanted pixel. In each row of the image, each of the pixel's edges adds the
/// signed area to its right. Sums from left to right are then the areas that the pixel covers.
mixed_color image_sampler::area_mean(std::int32_t x, std::int32_t y) {
    const std::array<l3d_point_2d, 4> corners{back(x - 0.5, y - 0.5), back(x + 0.5, y - 0.5),
                                              back(x + 0.5, y + 0.5), back(x - 0.5, y + 0.5)};
    const auto [left, right] = std::ranges::minmax(corners, {}, &l3d_point_2d::x);
    const auto [top, bottom] = std::ranges::minmax(corners, {}, &l3d_point_2d::y);
    const double width = image_.pixels.width, height = image_.pixels.height;
    first_column_ = static_cast<int>(std::clamp(left.x, 0.0, width - 1));
    first_row_ = static_cast<int>(std::clamp(top.y, 0.0, height - 1));
    columns_ = static_cast<int>(std::ceil(std::clamp(right.x, 1.0, width))) - first_column_;
    rows_ = static_cast<int>(std::ceil(std::clamp(bottom.y, 1.0, height))) - first_row_;
    areas_.assign(static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_), 0);
    for (std::size_t i = 0; i < 4; ++i)
        add_edge(corners[i], corners[(i + 1) % 4]);

    // Edges of a mirrored image run the other way round.
    const double sign = determinant_ > 0 ? 1 : -1;
    mixed_color sum;
    double total = 0;
    const double* part = areas_.data();
    for (int row = first_row_; row < first_row_ + rows_; ++row, ++part) {
        double area = 0;
        for (int column = first_column_; column < first_column_ + columns_; ++column) {
            area += *part++;
            if (const double covered = area * sign; covered > 0) {
                add(sum, color(column, row), covered);
                total += covered;
            }
        }
    }
    // A smaller part of a pixel's area is only rounding.
    constexpr double nothing = 1e-12;
    return total * std::abs(determinant_) > nothing ? divided(sum, total) : linear(back(x, y));
}

void image_sampler::add_edge(l3d_point_2d from, l3d_point_2d to) {
    if (from.y == to.y)
        return;
    const double sign = from.y < to.y ? -1 : 1;
    if (from.y > to.y)
        std::swap(from, to);
    const double slope = (to.x - from.x) / (to.y - from.y);
    const double begin = std::max<double>(from.y, first_row_);
    const double end = std::min<double>(to.y, first_row_ + rows_);
    if (!(begin < end))
        return;
    double top = begin, x = from.x + (top - from.y) * slope;
    for (int row = static_cast<int>(begin); top < end; ++row) {
        const double bottom = std::min<double>(row + 1, end);
        const double next = bottom == to.y ? to.x : from.x + (bottom - from.y) * slope;
        add_in_row(row - first_row_, x - first_column_, next - first_column_,
                   (bottom - top) * sign);
        top = bottom;
        x = next;
    }
}

/// Adds an edge's part in one row, from one x to another. A part beyond the first or last column
/// counts as if it were on the border of this column.
void image_sampler::add_in_row(int row, double from, double to, double height) {
    if (from > to)
        std::swap(from, to); // the area to the right is the same
    const double length = to - from;
    if (!(length > 0))
        return add_in_cell(row, static_cast<int>(std::clamp<double>(from, 0, columns_)), from, to,
                           height);
    const auto share = [&](double begin, double end) { return height * (end - begin) / length; };
    if (from < 0)
        add_in_cell(row, 0, 0, 0, share(from, std::min(to, 0.0)));
    const double end = std::min<double>(to, columns_);
    double begin = std::max(from, 0.0);
    for (int column = static_cast<int>(std::min<double>(begin, columns_)); begin < end; ++column) {
        const double next = std::min<double>(column + 1, end);
        add_in_cell(row, column, begin, next, share(begin, next));
        begin = next;
    }
}

/// Adds the area to the right of an edge's part in a cell. In this cell, the area is the part's
/// height times its mean distance from the cell's right side. In all cells further right, the area
/// is the part's whole height.
void image_sampler::add_in_cell(int row, int column, double from, double to, double height) {
    if (column >= columns_)
        return;
    const double in_cell = height * (std::clamp<double>(column + 1 - (from + to) / 2, 0, 1));
    double* const at = areas_.data() + row * (columns_ + 1) + column;
    at[0] += in_cell;
    at[1] += height - in_cell;
}

} // namespace l3d_detail
