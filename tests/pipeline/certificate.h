// SPDX-License-Identifier: MIT
// What measures how far each drawn thing is from the exact surface.
#ifndef L3D_TESTS_PIPELINE_CERTIFICATE_H
#define L3D_TESTS_PIPELINE_CERTIFICATE_H

#include "pipeline/diced_piece.h"
#include "reference/net.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstdint>
#include <span>

namespace pipeline_tests {

/// The homogeneous point of a net at (u, v), in double, for speed.
reference::hpoint value_of(const reference::net& net, double u, double v);

/// Samples what the rasterizer would draw, and the exact surface at the same parameters.
///
/// A drawn polygon is the picture of a polygon in homogeneous space with corners (w x, w y, w) and
/// parameters linear in that space. A convex quad is bilinear there, a folded one is four triangles
/// around its mean. Only drawn points inside the window count: of others nothing is claimed.
class certificate {
public:
    certificate(const reference::camera& view, l3d_size size)
        : frame_(view, {size.width, size.height}), size_(size) {}

    /// What is drawn from now on is this surface.
    void next(const reference::patch& surface) { net_ = make_net(surface, frame_); }

    /// Measures pieces, which have kept their parameters. The bound is the triangles'.
    void draw(std::span<const l3d_diced_piece> pieces, double frame_bound);

    /// Of each batch, measures only every n-th quad or triangle. Expects: n >= 1.
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
    struct corner {
        double x, y, w, u, v;
    };

    void draw_grid(const l3d_diced_piece& piece);
    void draw_triangles(const l3d_diced_piece& piece, double frame_bound);

    corner corner_of(const l3d_micro_vertex& vertex, double u, double v) const;
    bool may_be_seen(std::span<const corner> corners) const;
    void quad(const std::array<corner, 4>& c);
    void triangle(const std::array<corner, 3>& c);
    void sample(std::span<const corner> corners, std::span<const double> weights);

    reference::camera_frame frame_;
    reference::net net_;
    l3d_size size_;
    std::size_t every_ = 1;
    double bound_ = 0;
    bool grid_ = false;
};

} // namespace pipeline_tests

#endif
