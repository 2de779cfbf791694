// SPDX-License-Identifier: MIT
// l3d_line_drawing: contours, creases and borders of surfaces, seen and hidden, as polylines.
#ifndef L3D_SCENE_LINE_DRAWING_H
#define L3D_SCENE_LINE_DRAWING_H

#include "base/public.h"
#include "scene/camera.h"
#include "scene/patch_scene.h"
#include "tool_2d/pixels.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The kind of a line of a surface.
enum class L3D_PUBLIC l3d_line_kind {
    contour, ///< the surface turns away from the eye: its outline, or the outline of a fold
    crease,  ///< two pieces meet at an angle of more than two degrees
    border,  ///< the surface ends, or is trimmed
    joint    ///< two faces meet at an edge of the model without an angle
};

/// A vertex of a drawn line, in the picture.
struct L3D_PUBLIC l3d_drawn_place {
    double x = 0;     ///< pixels from the picture's left border
    double y = 0;     ///< pixels from the picture's upper border
    double depth = 0; ///< distance along the view axis, in world units

    friend bool operator==(const l3d_drawn_place&, const l3d_drawn_place&) = default;
};

/// A stretch of a line that is wholly seen, or wholly hidden.
struct L3D_PUBLIC l3d_drawn_line {
    l3d_line_kind kind = l3d_line_kind::contour; ///< the reason for the line
    /// Whether no surface lies in front of the stretch.
    bool is_seen = true;
    std::size_t instance = 0; ///< the instance's index in the scene
    /// The model's pieces that the stretch runs on or between, each once.
    std::vector<std::size_t> pieces{};
    /// The vertices of the stretch, at least two. A closed line ends where it begins.
    std::vector<l3d_drawn_place> points{};
};

/// The settings of a line drawing.
struct L3D_PUBLIC l3d_line_settings {
    static constexpr double least_tolerance = 0.01; ///< the least tolerance, in pixels
    static constexpr double most_tolerance = 10;    ///< the largest tolerance, in pixels

    /// The largest distance in the picture between drawn lines and exact lines, in pixels.
    double tolerance = 0.1;
    /// Whether lines that surfaces hide are part of the drawing.
    bool hidden = true;
    /// Whether edges of a model at which faces meet without an angle are part of the drawing.
    bool joints = false;
};

/// A drawing of a scene's surfaces as lines, with a bound of its error.
///
/// Each point of a line is within `bound` of an exact line of its kind, as long as the surfaces are
/// in front of the near plane. docs/NUMERICS.md, section 28, tells how, and where visibility is
/// unsure.
/// Units: pixels.
struct L3D_PUBLIC l3d_line_drawing {
    l3d_size size{};                     ///< size of the picture
    double bound = 0;                    ///< largest distance from the exact lines in the picture
    std::vector<l3d_drawn_line> lines{}; ///< the lines, sorted by instances, then by kinds
};

/// Draws the contours, creases and borders of all instances that are not invisible. All surfaces
/// are opaque, whatever their opacity. The near plane cuts surfaces; the far plane does not.
///
/// Surfaces that pierce each other have no line where they meet. A line changes between seen and
/// hidden where it passes through another surface.
/// Expects: a size of at least 1 x 1.
/// Errors:  throws l3d_error(bad_input) for a tolerance beyond the limits, or an invalid camera.
/// Cost:    some 1.1 million instructions for each piece of a part that fills a picture of a
///          million pixels.
L3D_PUBLIC l3d_line_drawing l3d_draw_lines(const l3d_patch_scene& scene, const l3d_camera& camera,
                                           l3d_size size, const l3d_line_settings& settings = {});

/// The look of an SVG file.
struct L3D_PUBLIC l3d_svg_look {
    /// The picture's title, which viewers show and screen readers read aloud.
    std::string title{};
    double seen_width = 1.5;   ///< width of seen lines, in pixels
    double hidden_width = 0.6; ///< width of hidden lines, in pixels
};

/// The text of an SVG file with a drawing's lines: a path for each line, in groups that Inkscape
/// shows as layers "seen" and "hidden". Hidden lines are dashed. Places have three decimals.
L3D_PUBLIC std::string l3d_svg_of(const l3d_line_drawing& drawing, const l3d_svg_look& look = {});

#endif
