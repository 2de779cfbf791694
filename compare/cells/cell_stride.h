// SPDX-License-Identifier: MIT
// l3d_cell_stride: a walk along a ray through all cells that it pierces.
#ifndef L3D_COMPARE_CELLS_CELL_STRIDE_H
#define L3D_COMPARE_CELLS_CELL_STRIDE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

/// Walks along a ray from cell to cell through cubes of side `size`. Successive cells share a face.
/// Source: Amanatides, Woo, A Fast Voxel Traversal Algorithm for Ray Tracing, Eurographics 1987.
class l3d_cell_stride {
public:
    using place = std::array<double, 3>;

    /// Begins at the cell of origin + t direction.
    l3d_cell_stride(const place& origin, const place& direction, double t, double size, int cells)
        : t_(t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const double at = (origin[i] + t * direction[i]) / size;
            cell_[i] = std::clamp(static_cast<int>(std::floor(at)), 0, cells - 1);
            step_[i] = direction[i] > 0 ? 1 : -1;
            const bool stands = direction[i] == 0;
            constexpr double never = std::numeric_limits<double>::infinity();
            const double wall = (cell_[i] + (step_[i] > 0)) * size;
            next_[i] = stands ? never : (wall - origin[i]) / direction[i];
            each_[i] = stands ? never : size / std::abs(direction[i]);
        }
    }

    const std::array<int, 3>& cell() const { return cell_; }
    double t() const { return t_; }

    /// The t at which the ray leaves the cell.
    double leaves() const { return std::min({next_[0], next_[1], next_[2]}); }

    void go_on() {
        const std::size_t i =
            next_[0] <= next_[1] ? (next_[0] <= next_[2] ? 0 : 2) : (next_[1] <= next_[2] ? 1 : 2);
        t_ = next_[i];
        next_[i] += each_[i];
        cell_[i] += step_[i];
    }

private:
    std::array<int, 3> cell_, step_;
    place next_, each_;
    double t_;
};

/// The part of a ray, [first, second], that lies in a cube from 0 to `side` along each axis and not
/// before `least_t`. It is empty unless first < second.
/// Expects: direction not zero.
inline std::array<double, 2> l3d_in_cube(const l3d_cell_stride::place& origin,
                                         const l3d_cell_stride::place& direction, double side,
                                         double least_t) {
    double t = least_t, end = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        if (direction[i] == 0) {
            if (origin[i] < 0 || origin[i] >= side)
                return {t, t};
            continue;
        }
        const double a = -origin[i] / direction[i], b = (side - origin[i]) / direction[i];
        t = std::max(t, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    return {t, end};
}

#endif
