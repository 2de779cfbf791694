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
    double w = std::numeric_limits<double>::infinity(); ///< distance along the view axis
    /// The depth of the next surface behind this one. It is at least 1e-3 px behind, since seams
    /// are met twice.
    double behind = std::numeric_limits<double>::infinity();
    vec3 normal; ///< unit, not turned to the eye; zero where there is none
    int patch = -1;

    bool covered() const { return patch >= 0; }
};

/// The way in which a surface ends in the picture, or changes abruptly.
enum class outline_kind {
    none,
    border, ///< nothing is seen beyond it
    jump,   ///< another surface is seen far behind, where one surface ends or folds over
    crease, ///< the normal changes, where two sheets cross, or one bends sharply
    close   ///< no outline is seen, but another sheet lies close behind
};

/// Finds the surface on single lines of sight: it clips each patch there to where it meets the
/// line.
///
/// It shares with exact_image only the types patch, camera and vec3. exact_image divides by w,
/// looks for charts of the picture and iterates in them. Here only boxes are projected, and nothing
/// is iterated. If both agree, they are right unless both are wrong in the same way.
class second_judge {
public:
    /// Expects: pictures as exact_image does.
    second_judge(std::span<const patch> patches, const camera& view, picture_size size);

    /// The nearest surface at a place in the picture. Units: pixels; any place within 4 pixels of
    /// the picture. Good to 1e-9 px.
    second_sample look(double x, double y) const;

    /// Lambert's grey level of the surface that is seen there. Expects: light of any length but
    /// zero.
    unsigned char grey(const second_sample& seen, double x, double y, vec3 light) const;

    /// Whether, and how, the picture changes abruptly within the radius. Abrupt is a change from
    /// surface to nothing, by 0.05 px of depth, or by 3 degrees of the normal. If nothing changes,
    /// it tells whether another sheet is nearer than `close_px` behind, along the normal.
    ///
    /// It looks along 16 straight ways from the middle. Each is halved 18 times towards where the
    /// change is larger. An outline that is crossed twice within one of these ways may be missed.
    outline_kind outline_within(double x, double y, double radius, double close_px = 0) const;

private:
    /// The difference of two samples; 1 is abrupt.
    struct change {
        double size = 0;
        outline_kind kind = outline_kind::none;
    };
    change between(const second_sample& p, const second_sample& q) const;
    change sharpest(const second_sample& middle, const second_sample& end, double x, double y,
                    double dx, double dy) const;
    bool is_close(const second_sample& seen, double x, double y, double close_px) const;
    /// A part of a patch, with its control points in the camera's axes.
    struct part {
        std::array<vec3, 16> points;
        double x0 = 0, y0 = 0, x1 = 0, y1 = 0; ///< the part's box in the picture, in pixels
        double u0 = 0, v0 = 0, du = 1, dv = 1; ///< its place in the patch
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
    std::vector<std::vector<std::size_t>> tiles_; ///< for each tile, the parts whose boxes touch it
};

} // namespace reference

#endif
