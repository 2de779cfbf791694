// SPDX-License-Identifier: MIT
// l3d_strip_walker: walks many isocurves of a patch side by side by forward differences.
#ifndef L3D_DICE_STRIP_WALKER_H
#define L3D_DICE_STRIP_WALKER_H

#include "geom/forward_difference.h"
#include "scene/dice_view.h"
#include "dice/snap.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Walks the rows of vertices in a strip of a patch by forward differences. Column c holds the
/// differences of the curve v -> (x, y, w) at a fixed u. A step moves all columns to the next row.
///
/// Shape: one array for each coordinate and difference, with the columns side by side, so that each
///        SIMD lane can take a column.
/// Cost:  9 additions a column and step, one reciprocal and two products a vertex.
template <class T> class l3d_strip_walker {
public:
    /// Sets the number of columns. Registers hold coordinates times `unit`, a power of two, which
    /// is 1 for floats.
    /// Cost: allocates only if there are more columns than ever before.
    void resize(std::size_t columns, double unit = 1) {
        columns_ = columns;
        unit_ = unit;
        for (auto& coordinate : registers_)
            for (auto& difference : coordinate)
                if (difference.size() < columns)
                    difference.resize(columns);
    }

    /// The number of columns for which there is memory.
    std::size_t room() const { return registers_[0][0].size(); }

    /// Sets column c exactly to the beginning of `curve`, and prepares to walk it in `steps` steps.
    void start(std::size_t c, const l3d_image_curve& curve, int steps) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto i = static_cast<int>(k);
            const auto& p = curve.points;
            const auto d = l3d_forward_difference<T, 3>::build(
                {p[0][i] * unit_, p[1][i] * unit_, p[2][i] * unit_, p[3][i] * unit_}, steps);
            for (std::size_t n = 0; n < 4; ++n)
                registers_[k][n][c] = d.d[n];
        }
    }

    /// Puts column c on one point for the current row. Expects: no step() before the column starts
    /// again.
    void place(std::size_t c, const l3d_image_point& point) {
        for (std::size_t k = 0; k < 3; ++k)
            registers_[k][0][c] = l3d_from_double<T>(point[static_cast<int>(k)] * unit_);
    }

    /// Writes the current row of points, projected and snapped to sub-pixels.
    /// Expects: x, y, inv_w have room for all columns; every point is drawable; perspective.
    void emit(const l3d_dice_view& view, std::int32_t* x, std::int32_t* y, float* inv_w) const {
        const T* hx = registers_[0][0].data();
        const T* hy = registers_[1][0].data();
        const T* hw = registers_[2][0].data();
        const std::int32_t centre_x = view.centre_x(), centre_y = view.centre_y();
        const auto scale = static_cast<float>(view.depth_scale * unit_);
        for (std::size_t c = 0; c < columns_; ++c) {
            const l3d_snapped s = l3d_snap(hx[c], hy[c], hw[c]);
            x[c] = s.x + centre_x;
            y[c] = s.y + centre_y;
            inv_w[c] = s.inv_w * scale;
        }
    }

    /// Moves all columns to the next row.
    void step() {
        for (auto& coordinate : registers_)
            for (std::size_t n = 0; n < 3; ++n) {
                T* low = coordinate[n].data();
                const T* high = coordinate[n + 1].data();
                for (std::size_t c = 0; c < columns_; ++c)
                    low[c] = low[c] + high[c];
            }
    }

private:
    std::size_t columns_ = 0;
    double unit_ = 1;
    std::array<std::array<std::vector<T>, 4>, 3> registers_;
};

#endif
