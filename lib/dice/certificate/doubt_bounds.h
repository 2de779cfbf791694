// SPDX-License-Identifier: MIT
// l3d_doubt_bounds: bounds of a piece's place and light in the exact picture.
#ifndef L3D_DICE_CERTIFICATE_DOUBT_BOUNDS_H
#define L3D_DICE_CERTIFICATE_DOUBT_BOUNDS_H

#include "dice/certificate/light_bounds.h"
#include "geom/patch_part.h"
#include "geom/step_bound.h"
#include "geom/trims/trim_region.h"
#include "raster/background.h"
#include "raster/color/srgb_light.h"
#include "raster/lighting.h"
#include "scene/dice_view.h"
#include "scene/sides/side_pairs.h"

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace l3d_detail {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

} // namespace l3d_detail

/// A lamp of the exact picture.
struct l3d_doubt_lamp {
    l3d_vector<double, 3> direction{0.0, 0.0, 1.0}; ///< unit vector towards the lamp, in the world
    l3d_light_color color{1, 1, 1};                 ///< parts of white
};

/// The lights and the fog of the exact picture, by the rules of l3d_lighting and l3d_fog.
struct l3d_doubt_lighting {
    l3d_light_color ambient{};
    std::vector<l3d_doubt_lamp> lamps; ///< at most l3d_lighting::most_further + 1
    l3d_fog fog;
    double depth_scale = 1; ///< w / distance along the view axis, from the eye of w
    double nearer = 0;      ///< distance by which the camera's eye is nearer than the eye of w
};

/// A patch that stands in the picture.
struct l3d_doubt_patch {
    std::uint32_t instance = 0, patch = 0;
    double error_xy = 0, error_w = 0; ///< errors of its homogeneous points
    double near = 0;                  ///< nothing nearer is drawn
    double normal_off = 0;            ///< error of its normals, which are as long as the model's
    double turned = 0;                ///< distance of its unit normals from the surface's
    const l3d_side_pairs* sides = nullptr; ///< neighbours in its model
    /// Whether its back need not be drawn, and the sign of the facing that is the back.
    bool one_sided = false;
    double back = 1;
    l3d_color_parts color{1, 1, 1}; ///< colour of its material
    l3d_color_parts highlight{};    ///< highlight of its material
    int sharpness = 1;
    /// The frame's lights and fog; null for one white light without highlights and fog.
    const l3d_doubt_lighting* lighting = nullptr;

    /// Whether it looks like another one in the same light.
    bool looks_like(const l3d_doubt_patch& other) const {
        return color == other.color && highlight == other.highlight && sharpness == other.sharpness;
    }
};

/// A part of an exact patch. Its normals are in the world.
struct l3d_doubt_piece : l3d_exact_part {
    const l3d_doubt_patch* of = nullptr;
    /// How much of it its face's trims leave. A part's border runs through it.
    enum class left : unsigned char { all, part, none } there = left::all;
    l3d_trim_region trims; ///< that part, in the patch's parameters; empty unless it is a part

    /// Takes what trims leave of it.
    void take(l3d_trim_region region) {
        const l3d_trim_box box{{u0, v0}, {u1, v1}};
        there = region.is_all_of(box)    ? left::all
                : region.is_none_of(box) ? left::none
                                         : left::part;
        trims = there == left::part ? std::move(region) : l3d_trim_region();
    }

    /// Whether the piece reaches a side of its patch, in the order of l3d_side_pairs.
    bool reaches(std::size_t side) const {
        return side == 0 ? v0 == 0 : side == 1 ? u1 == 1 : side == 2 ? v1 == 1 : u0 == 0;
    }
};

/// Grey levels of the exact picture: ambient light, and the most that the cosine adds.
inline constexpr double l3d_ambient_level = 25.5, l3d_cosine_level = 229.5;

/// The settings that a frame's pieces share.
///
/// Units: pixels from the picture's top left corner; w as l3d_dice_view has it.
struct l3d_doubt_view {
    l3d_dice_view view;
    /// Takes (x, y, w) to the world, as seen from the eye. Shape: its columns.
    std::array<l3d_vector<double, 3>, 3> world_of_image{};
    l3d_vector<double, 3> light{0.0, 0.0, 1.0}; ///< unit, in the world
    /// The lamps and the fog of a frame that has more than the one white `light`.
    l3d_doubt_lighting lighting{};
    /// Bounds of drawn places: in the picture, and along the normal.
    double bound_px = 0, depth_bound_px = 0;
    l3d_background background{}; ///< not none

    /// The background's light in a row of pixels.
    l3d_light_bounds background_light(int row) const {
        const std::uint32_t word = background.word(row, view.size.height);
        const std::array<double, 3> channels{l3d_light_of_level(word >> 16 & 255),
                                             l3d_light_of_level(word >> 8 & 255),
                                             l3d_light_of_level(word & 255)};
        return {channels, channels};
    }
};

/// Bounds of a number that changes over a piece. The number lies between `least` and `most`, and
/// within `off` of at(x, y), a linear function of the place.
struct l3d_doubt_line {
    double least = 0, most = 0;
    double middle = 0, along_x = 0, along_y = 0, off = 0; ///< places count from the piece's own

    double at(double x, double y) const { return middle + along_x * x + along_y * y; }
};

/// Bounds of two cosines of a piece's normals, which are turned to the eye: `lit` with the
/// direction to a lamp, `facing` with the half-way vector between lamp and eye.
struct l3d_doubt_cosines {
    l3d_doubt_line lit, facing;
};

/// Bounds of a piece's place, depth and light in a picture.
///
/// Units: pixels from the picture's top left corner.
struct l3d_doubt_bounds {
    l3d_image_box box;         ///< holds the whole piece
    double at_x = 0, at_y = 0; ///< the piece's own place, from which lines count
    unsigned open_sides = 0;   ///< bits of the sides where the surface ends
    bool may_end = false;      ///< the near or the far plane may cut it, or trims do
    int facing = 0;            ///< the sign of the normal along the line of sight; 0: perhaps both
    bool may_be_missing = false; ///< whether its back is seen, and not drawn

    l3d_doubt_line w;
    /// The relative difference of w between the drawn and the exact piece.
    double w_margin = 0;
    l3d_doubt_line level; ///< above ambient light; where it is below 0, there is only ambient light

    /// Cosines for each lamp, if the patch has lighting; none if nothing is known. With lamps, the
    /// line of `level` tells only how well it is known.
    std::vector<l3d_doubt_cosines> lamps;

    /// The linear map from a place to parameters from -1/2 to 1/2. Shape: du/dx, du/dy, dv/dx,
    /// dv/dy.
    std::array<double, 4> parameters{};
    double u_off = 0, v_off = 0; ///< largest error of the parameters; infinite: not known
    double picture_off = 0;      ///< largest distance of the piece's picture from a linear one
    double point_off = 0; ///< the part of that by which points err, however small the piece is

    /// Whether the piece may reach into a box.
    bool touches(const l3d_image_box& other) const;

    /// Whether the surface may end in a box. Expects: touches(other).
    bool may_end_in(const l3d_image_box& other) const;

    /// Whether the place (x, y) may be on the piece.
    bool may_show(double x, double y) const { return touches({x, y, x, y}); }

    /// The least and the largest value of a line in the part of a box that the piece may reach.
    std::array<double, 2> range(const l3d_doubt_line& of, const l3d_image_box& in) const;
};

/// A piece and its bounds.
struct l3d_doubt_leaf {
    l3d_doubt_piece piece;
    l3d_doubt_bounds bounds;
    bool has_no_area = false; ///< it is seen exactly from its edge, and adds no light to any cell

    /// Whether trims leave nothing of it. It is kept since the surface ends where it meets others.
    bool is_gone() const { return piece.there == l3d_doubt_piece::left::none; }
};

/// Bounds a piece in a view. Cost: a microsecond.
l3d_doubt_bounds l3d_bounds_of(const l3d_doubt_piece& piece, const l3d_doubt_view& view);

#endif
