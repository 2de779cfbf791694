// SPDX-License-Identifier: MIT
// attribute_planes: numbers that are linear in the picture over one polygon.
#ifndef L3D_RASTER_SHAPES_ATTRIBUTE_PLANE_P_H
#define L3D_RASTER_SHAPES_ATTRIBUTE_PLANE_P_H

#include "raster/shapes/scan_edge_p.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// Twice the signed area of the triangle that two vectors span. If |components| <= 2^24, then
/// |result| <= 2^49.
constexpr std::int64_t cross(scan_point a, scan_point b) {
    return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
}

constexpr scan_point operator-(scan_point a, scan_point b) {
    return {a.x - b.x, a.y - b.y};
}

/// A view of the planes of attribute_planes: linear functions of the place in the picture. Each is
/// base + along_x (x - base_x) + along_y (y - base_y).
/// Lives: borrows the arrays.
/// Units: places in 1/256 pixel.
struct plane_view {
    double base_x = 0, base_y = 0;
    const double* base = nullptr;
    const double* along_x = nullptr;
    const double* along_y = nullptr;
};

/// The planes through `Count` numbers at each corner of a polygon, for interpolation.
///
/// Planes are computed in double, since along a sliver the two gradients are large and cancel. Take
/// corners within 64 pixels (2^14) and the least area (1/2). Gradients then reach 2^14 times the
/// corners' differences per unit, and 2^28 times at the far end. So 53 bits leave an error of 2^-25
/// of the differences.
template <std::size_t Count> class attribute_planes {
public:
    using numbers = std::array<float, Count>;

    /// Makes the planes through three corners. `area2` is cross(b - a, c - a). Expects: area2 != 0.
    attribute_planes(const std::array<scan_point, 3>& p, const std::array<numbers, 3>& v,
                     std::int64_t area2)
        : base_x_(p[0].x), base_y_(p[0].y) {
        for (std::size_t i = 0; i < Count; ++i)
            base_[i] = v[0][i];
        set_gradients(p[1] - p[0], p[2] - p[0], v[1], v[0], v[2], v[0], area2);
    }

    /// Makes the planes through the mean of four corners, parallel to the differences along both
    /// diagonals. `area2` is cross(c - a, d - b).
    /// Expects: area2 != 0.
    attribute_planes(const std::array<scan_point, 4>& p, const std::array<numbers, 4>& v,
                     std::int64_t area2)
        : base_x_(0.25 * (double(p[0].x) + p[1].x + p[2].x + p[3].x)),
          base_y_(0.25 * (double(p[0].y) + p[1].y + p[2].y + p[3].y)) {
        for (std::size_t i = 0; i < Count; ++i)
            base_[i] = 0.25 * (double(v[0][i]) + v[1][i] + v[2][i] + v[3][i]);
        set_gradients(p[2] - p[0], p[3] - p[1], v[2], v[0], v[3], v[1], area2);
    }

    /// The interpolated numbers at the centre of a pixel.
    numbers at(std::int32_t column, std::int32_t row) const {
        return at_place(pixel * (column + 0.5), pixel * (row + 0.5));
    }

    /// The interpolated numbers at any place. Units: 1/256 pixel.
    numbers at_place(double x, double y) const {
        numbers result;
        for (std::size_t i = 0; i < Count; ++i)
            result[i] = static_cast<float>(number(i, x, y));
        return result;
    }
    double number(std::size_t i, double x, double y) const {
        return base_[i] + along_x_[i] * (x - base_x_) + along_y_[i] * (y - base_y_);
    }

    /// The change of number i over 1/256 pixel along x; along_y() is its change along y.
    double along_x(std::size_t i) const { return along_x_[i]; }
    double along_y(std::size_t i) const { return along_y_[i]; }

    /// A view of these planes. Lives: borrows them.
    plane_view view() const {
        return {base_x_, base_y_, base_.data(), along_x_.data(), along_y_.data()};
    }

    /// The change of each number for one column to the right.
    numbers per_column() const {
        numbers result;
        for (std::size_t i = 0; i < Count; ++i)
            result[i] = static_cast<float>(along_x_[i] * pixel);
        return result;
    }

private:
    /// Finds the gradients with gradient . d1 = v1 - u1 and gradient . d2 = v2 - u2.
    void set_gradients(scan_point d1, scan_point d2, const numbers& v1, const numbers& u1,
                       const numbers& v2, const numbers& u2, std::int64_t area2) {
        const double scale = 1.0 / static_cast<double>(area2);
        const double x1 = d1.x * scale, y1 = d1.y * scale, x2 = d2.x * scale, y2 = d2.y * scale;
        for (std::size_t i = 0; i < Count; ++i) {
            const double first = double(v1[i]) - u1[i], second = double(v2[i]) - u2[i];
            along_x_[i] = first * y2 - second * y1;
            along_y_[i] = second * x1 - first * x2;
        }
    }

    static constexpr double pixel = l3d_subpixel_one;

    double base_x_, base_y_;
    std::array<double, Count> base_, along_x_, along_y_;
};

} // namespace l3d_detail

#endif
