// SPDX-License-Identifier: MIT
// Measures how far each drawn thing is from the exact surface.
#ifndef L3D_TESTS_DICE_CERTIFICATE_H
#define L3D_TESTS_DICE_CERTIFICATE_H

#include "drawn_points.h"
#include "reference/net.h"
#include "tool_2d/pixels.h"

#include <cstdint>
#include <span>

namespace dice_tests {

/// The homogeneous point of a net at (u, v), in double, for speed.
reference::hpoint value_of(const reference::net& net, double u, double v);

/// Compares drawn_points with the exact surface at the same parameters.
class certificate {
public:
    certificate(const reference::camera& view, l3d_size size)
        : frame_(view, {size.width, size.height}), size_(size) {}

    /// From now on, this surface is drawn.
    void next(const reference::patch& surface) { net_ = make_net(surface, frame_); }

    /// Measures pieces, which have kept their parameters. The bound is the triangles'.
    void draw(std::span<const l3d_diced_piece> pieces, double frame_bound);

    /// Measures only every n-th quad or triangle of each batch. Expects: n >= 1.
    void measure_every(std::size_t n) { every_ = n; }

    std::int64_t samples = 0;
    std::int64_t violations = 0; ///< samples farther off than the bound given with them
    double largest = 0, sum = 0; ///< of measured distances, pixels
    double largest_promise = 0;  ///< of the bounds given with grids and triangles
    double worst_ratio = 0;      ///< measured / bound
    double worst_u = 0, worst_v = 0, worst_measured = 0, worst_bound = 0;
    bool worst_is_grid = false;

    double mean() const { return samples > 0 ? sum / static_cast<double>(samples) : 0; }

private:
    void sample(const drawn_point& at);

    reference::camera_frame frame_;
    reference::net net_;
    l3d_size size_;
    std::size_t every_ = 1;
    double bound_ = 0;
    bool grid_ = false;
};

} // namespace dice_tests

#endif
