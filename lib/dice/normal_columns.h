// SPDX-License-Identifier: MIT
// l3d_normal_columns: exact surface normals along the columns of a grid.
#ifndef L3D_DICE_NORMAL_COLUMNS_H
#define L3D_DICE_NORMAL_COLUMNS_H

#include "geom/normal_net.h"

#include <array>
#include <cstddef>
#include <vector>

/// Makes a unit vector of a normal. The result is zero if the normal is so short that it may be
/// rounding alone.
///
/// Expects: a normal evaluated in double from a net whose largest coefficient is 1.
std::array<float, 3> l3d_unit_normal(const l3d_normal_net::vector& normal);

/// Evaluates a patch's normals row by row, at fixed values of u. Each column of a grid holds the
/// polynomial in v of the normals at the column's u.
///
/// Shape: one array for each power of v and each component, with the columns side by side.
class l3d_normal_columns {
public:
    /// Cost: allocates only if there are more columns than ever before.
    void resize(std::size_t columns);

    /// The number of columns for which there is memory.
    std::size_t room() const { return powers_[0][0].size(); }

    /// Sets column c to the normals of `net` at u.
    void set(std::size_t c, const l3d_normal_net& net, double u);

    /// Writes the unit normals of all columns at v.
    void emit(double v, float* x, float* y, float* z) const;

private:
    std::size_t columns_ = 0;
    std::array<std::array<std::vector<double>, 6>, 3> powers_;
};

#endif
