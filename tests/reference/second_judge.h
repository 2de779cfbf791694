// SPDX-License-Identifier: MIT
// The second judge: the exact picture once more, by another way.
#ifndef L3D_REFERENCE_SECOND_JUDGE_H
#define L3D_REFERENCE_SECOND_JUDGE_H

#include "reference/exact.h"

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace reference {

/// The nearest surface on a line of sight.
struct second_sample {
    double w = std::numeric_limits<double>::infinity(); ///< distance along the axis
    vec3 normal; ///< unit, not turned to the eye; zero where there is none
    int patch = -1;

    bool covered() const { return patch >= 0; }
};

/// Follows single lines of sight into the world, and clips each patch there to where it meets them.
///
/// Shares with exact_image what patch, camera and vec3 are, and nothing else: that one divides by
/// w, looks for charts of the picture and iterates in them; here nothing is projected but boxes,
/// and nothing is iterated. What both find is true unless both are wrong in the same way.
class second_judge {
public:
    /// Expects: pictures as exact_image does.
    second_judge(std::span<const patch> patches, const camera& view, picture_size size);

    /// Units: pixels; any place within 4 pixels of the picture. Good to 1e-9 px.
    second_sample look(double x, double y) const;

    /// Lambert's grey level of what is seen there. Expects: light of any length but zero.
    unsigned char grey(const second_sample& seen, double x, double y, vec3 light) const;

    /// Whether what is seen changes abruptly within the radius: from surface to nothing, by 0.05
    /// px of depth, or by a normal that is 3 degrees off.
    ///
    /// Along 16 straight ways from the middle: each is halved 26 times towards where the change is
    /// larger. An outline that is crossed twice within one of them may be missed.
    bool outline_within(double x, double y, double radius) const;

private:
    /// A part of a patch, with its control points in the camera's axes.
    struct part {
        std::array<vec3, 16> points;
        double x0 = 0, y0 = 0, x1 = 0, y1 = 0; ///< its box in the picture, pixels
        double u0 = 0, v0 = 0, du = 1, dv = 1; ///< where it lies in the patch
        int patch = 0;
    };

    vec3 to_camera(const vec3& world) const;
    vec3 direction(double x, double y) const;
    void add(const part& whole, int depth);
    void enter(const part& small);
    std::size_t tile(int column, int row) const;

    std::span<const patch> patches_;
    double near_, focal_, center_x_, center_y_;
    vec3 eye_, right_, up_, forward_;
    std::vector<part> parts_;
    int columns_, rows_;
    std::vector<std::vector<std::size_t>> tiles_; ///< parts whose boxes touch it
};

} // namespace reference

#endif
