// SPDX-License-Identifier: MIT
// Measures how far drawn depths and levels are from those of the exact surface.
#ifndef L3D_TESTS_DICE_SURFACE_CERTIFICATE_H
#define L3D_TESTS_DICE_SURFACE_CERTIFICATE_H

#include "scene/bends/surface_bends.h"
#include "scene.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace dice_tests {

/// Vectors in long double, for positions that cancel.
struct long_vec {
    long double x = 0, y = 0, z = 0;
};

/// Compares what is drawn with the exact surface at the same parameters, along its exact normal,
/// in the eye's space.
///
/// Looked at are whole convex quads and triangles of slits, where they lie in the window and
/// before the near plane, at parameters where the exact surface has a normal. Nothing is promised
/// of levels in quads that show both sides, and of those of unshaded blocks (l3d_dice_counts).
class surface_certificate {
public:
    explicit surface_certificate(const scene& s);

    /// From now on, this patch is drawn.
    void next(std::size_t patch);
    void draw(std::span<const l3d_diced_piece> pieces);

    /// Looks only at every n-th quad or triangle of each piece. Expects: n >= 1.
    void measure_every(std::size_t n) { every_ = n; }

    /// The worst that was measured of one kind, and where.
    struct worst {
        double measured = 0;
        std::size_t patch = 0;
        double u = 0, v = 0;
        bool in_slit = false;

        void take(const worst& other) {
            // !(<=): a distance that is no number is the worst.
            if (!(other.measured <= measured))
                *this = other;
        }
    };
    worst depth; ///< pixels at the depth of the exact point
    worst shade; ///< levels, without rounding to whole ones
    std::int64_t samples = 0, levels = 0;
    std::int64_t mixed = 0;    ///< polygons that show both sides
    std::int64_t unshaded = 0; ///< quads of blocks that say nothing of their levels

private:
    /// A drawn corner: its place in the eye's space, and what it stands for.
    struct corner {
        long_vec place;
        double u, v, x, y;
        l3d_micro_vertex vertex;
    };
    struct exact {
        long_vec place, normal;
        double level; ///< 229.5 n.l
        bool has_normal;
    };

    corner corner_of(const l3d_micro_vertex& vertex, double u, double v) const;
    exact exact_at(double u, double v) const;
    template <std::size_t N> bool side_of(const std::array<corner, N>& corners, double& side) const;
    bool is_seen(const long_vec& at) const;
    bool keeps_levels(const l3d_diced_piece& piece, int row, int column, bool in_slit) const;
    bool row_shows_both(const l3d_diced_piece& piece, const std::array<corner, 3>& c) const;
    bool keeps_levels(const l3d_diced_piece& piece, const std::array<corner, 3>& c) const;
    void grid(const l3d_diced_piece& piece);
    void quad(const std::array<corner, 4>& c, const std::array<double, 4>& bends, bool levels);
    void triangle(const std::array<corner, 3>& c, bool with_levels);
    void compare(const long_vec& at, double u, double v, std::span<const double> levels,
                 double side, bool in_slit);

    const scene& scene_;
    long_vec ray_to(const long_vec& place) const;

    reference::camera_frame frame_;
    l3d_shading depths_; ///< what drawn depths stand for
    long_vec light_;
    std::array<long_vec, 16> net_;
    long double reach_ = 0; ///< largest distance of a point of the net from the eye
    std::optional<l3d_surface_bends> bends_;
    std::size_t patch_ = 0, every_ = 1;
};

} // namespace dice_tests

#endif
