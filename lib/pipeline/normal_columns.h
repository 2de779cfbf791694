// SPDX-License-Identifier: MIT
// l3d_normal_columns: exact surface normals along the columns of a grid.
#ifndef L3D_PIPELINE_NORMAL_COLUMNS_H
#define L3D_PIPELINE_NORMAL_COLUMNS_H

#include "geom/normal_net.h"

#include <array>
#include <cstddef>
#include <vector>

/// The normal polynomial of a patch at fixed u values, to be evaluated row by row.
///
/// In float in every build: a grey level needs 8 bits, and this loses at most some 2^-19 (the
/// power coefficients of a degree-5 polynomial are up to C(5, 2) 2^2 = 40 times the largest
/// Bernstein coefficient, which is 1).
/// Shape: one array per power and component, columns side by side.
class l3d_normal_columns {
public:
    void resize(std::size_t columns);

    /// Sets column c to the normals at u.
    void set(std::size_t c, const l3d_normal_net& net, double u);

    /// Writes the normals of all columns at v.
    void emit(double v, float* x, float* y, float* z) const;

private:
    std::size_t columns_ = 0;
    std::array<std::array<std::vector<float>, 6>, 3> powers_;
};

#endif
