// SPDX-License-Identifier: MIT
// l3d_normal_columns: exact surface normals along the columns of a grid.
#ifndef L3D_DICE_NORMAL_COLUMNS_H
#define L3D_DICE_NORMAL_COLUMNS_H

#include "geom/normal_net.h"

#include <array>
#include <cstddef>
#include <vector>

/// A normal as unit vector; zero where the normal may be rounding alone.
///
/// Expects: a normal of a net (whose largest coefficient is 1), evaluated in double.
std::array<float, 3> l3d_unit_normal(const l3d_normal_net::vector& normal);

/// The normal polynomial of a patch at fixed u values, to be evaluated row by row.
///
/// Shape: one array per power and component, columns side by side.
class l3d_normal_columns {
public:
    /// Cost: allocates only when wider than ever before.
    void resize(std::size_t columns);

    /// The number of columns that need no allocation.
    std::size_t room() const { return powers_[0][0].size(); }

    /// Sets column c to the normals at u.
    void set(std::size_t c, const l3d_normal_net& net, double u);

    /// Writes the unit normals of all columns at v.
    void emit(double v, float* x, float* y, float* z) const;

private:
    std::size_t columns_ = 0;
    std::array<std::array<std::vector<double>, 6>, 3> powers_;
};

#endif
