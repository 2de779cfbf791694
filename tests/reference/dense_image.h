// SPDX-License-Identifier: MIT
// The exact picture's own twin: brute force, simple enough to be believed.
#ifndef L3D_REFERENCE_DENSE_IMAGE_H
#define L3D_REFERENCE_DENSE_IMAGE_H

#include "reference/exact.h"

#include <cstddef>
#include <span>
#include <vector>

namespace reference {

/// Evaluates every patch in powers of u and v on a grid of cells x cells, and fills every cell as
/// two triangles. The nearest surface is kept.
///
/// Expects: all control points at w > 0. The near plane is ignored.
/// Cost:    50 ns per cell. The error is the cells' chord error.
class dense_image {
public:
    dense_image(std::span<const patch> patches, const camera& view, picture_size size, int cells);

    bool covered(int x, int y) const { return inverse_w(x, y) > 0; }
    /// 1 / distance along the view axis; 0 where nothing is seen.
    double inverse_w(int x, int y) const { return depth_[place(x, y)]; }

private:
    struct vertex {
        double x, y, inverse_w;
    };
    std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
               static_cast<std::size_t>(x);
    }
    void draw(const patch& surface, const camera_frame& frame, int cells);
    void fill(const vertex& a, const vertex& b, const vertex& c);

    picture_size size_;
    std::vector<double> depth_;
};

} // namespace reference

#endif
