// SPDX-License-Identifier: MIT
// l3d_doubt_bounds: bounds where a piece is in the exact picture, and its light there.
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

/// A lamp so far away that its light has one direction. It lights the exact picture.
struct l3d_doubt_lamp {
    l3d_vector<double, 3> direction{0.0, 0.0, 1.0}; ///< unit vector towards the lamp, in the world
    l3d_light_color color{1, 1, 1}; ///< colour of the lamp's light, as parts of white
};

/// The lights and the fog of the exact picture, by the rules of l3d_lighting and l3d_fog.
struct l3d_doubt_lighting {
    l3d_light_color ambient{};
    std::vector<l3d_doubt_lamp> lamps; ///< the lamps, at most l3d_lighting::most_further + 1
    l3d_fog fog;
    /// How much w grows for each unit of distance along the view axis.
    double depth_scale = 1;
    double nearer = 0; ///< how much nearer the camera's eye is than the eye from which w counts
};

/// A patch in the picture, with the facts that bounds of all its pieces need.
struct l3d_doubt_patch {
    std::uint32_t instance = 0, patch = 0;
    double error_xy = 0, error_w = 0; ///< errors of the patch's homogeneous points
    double near = 0;                  ///< the w of the patch's near plane
    double normal_off = 0;            ///< error of the patch's normals, which are not unit vectors
    /// Largest difference between the patch's unit normals and those of the surface that the patch
    /// approximates.
    double turned = 0;
    const l3d_side_pairs* sides = nullptr; ///< the patch's neighbours in its model
    /// Whether the patch's back is not drawn. Where l3d_doubt_bounds::facing has the sign `back`,
    /// the patch shows its back.
    bool one_sided = false;
    double back = 1;
    l3d_color_parts color{1, 1, 1}; ///< colour of the patch's material
    l3d_color_parts highlight{};    ///< highlight of the patch's material
    int sharpness = 1;
    /// The frame's lights and fog; null for one white light without highlights and fog.
    const l3d_doubt_lighting* lighting = nullptr;

    /// Whether the patch looks like another patch in the same light.
    bool looks_like(const l3d_doubt_patch& other) const {
        return color == other.color && highlight == other.highlight && sharpness == other.sharpness;
    }
};

/// A part of an exact patch, made by halving, whose place and light are bounded. The part's normals
/// are in the world.
struct l3d_doubt_piece : l3d_exact_part {
    const l3d_doubt_patch* of = nullptr;
    /// How much of the piece the trims of its face leave. A border of the trims runs through the
    /// piece if they leave a `part`.
    enum class left : unsigned char { all, part, none } there = left::all;
    /// The region that trims leave of the piece, in the patch's parameters. It is empty unless
    /// trims leave a part.
    l3d_trim_region trims;

    /// Sets the region that trims leave of the piece. Expects: the region lies in the piece.
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

/// Shade levels of the exact picture, from 0 to 255: the level of ambient light alone, and the most
/// that the cosine with the light's direction adds to this level.
inline constexpr double l3d_ambient_level = 25.5, l3d_cosine_level = 229.5;

/// The view, the light and the background that all pieces of a frame share.
struct l3d_doubt_view {
    l3d_dice_view view;
    /// Maps (x, y, w) of a point to the vector in the world from the eye to the point. Shape: the
    /// columns of the matrix.
    std::array<l3d_vector<double, 3>, 3> world_of_image{};
    /// Unit vector towards the white light, in the world.
    l3d_vector<double, 3> light{0.0, 0.0, 1.0};
    /// The lamps and the fog, for a frame that has more than the one white `light`.
    l3d_doubt_lighting lighting{};
    /// Error bounds of the drawn frame: of places in the picture, and of depth along the normal.
    double bound_px = 0, depth_bound_px = 0;
    l3d_background background{}; ///< the background behind all surfaces; not l3d_background::none()

    /// The exact light of the background in a row of pixels.
    l3d_light_bounds background_light(int row) const {
        const std::uint32_t word = background.word(row, view.size.height);
        const std::array<double, 3> channels{l3d_light_of_level(word >> 16 & 255),
                                             l3d_light_of_level(word >> 8 & 255),
                                             l3d_light_of_level(word & 255)};
        return {channels, channels};
    }
};

/// Bounds of a number that changes over a piece. The number lies between `least` and `most`. At the
/// place (x, y) it is also within `off` of at(x, y), a linear function. Places are relative to the
/// piece's own place (l3d_doubt_bounds::at_x, at_y).
struct l3d_doubt_line {
    double least = 0, most = 0;
    /// The value at(0, 0), the slopes of at() along x and y, and the largest error of at().
    double middle = 0, along_x = 0, along_y = 0, off = 0;

    double at(double x, double y) const { return middle + along_x * x + along_y * y; }
};

/// Bounds of two cosines of a piece's normals, for one lamp. `lit` is the cosine with the direction
/// to the lamp. `facing` is the cosine with the half-way vector between lamp and eye. Normals are
/// turned to the eye.
struct l3d_doubt_cosines {
    l3d_doubt_line lit, facing;
};

/// Bounds of a piece's place, depth and light in the exact picture.
struct l3d_doubt_bounds {
    l3d_image_box box;         ///< a box in the picture that holds the whole piece
    double at_x = 0, at_y = 0; ///< the piece's own place, from which l3d_doubt_line counts places
    unsigned open_sides = 0;   ///< a bit for each side of the piece where the surface ends
    bool may_end = false;      ///< whether the near plane, the far plane or trims may cut the piece
    /// The sign of the normal along the line of sight; 0 if both signs may occur.
    int facing = 0;
    /// Whether parts of the piece may be missing: its back is not drawn, and may be turned to the
    /// eye.
    bool may_be_missing = false;

    l3d_doubt_line w;
    /// The largest relative difference of w between the drawn and the exact piece.
    double w_margin = 0;
    /// The shade level above that of ambient light. A negative number means ambient light alone.
    l3d_doubt_line level;

    /// The cosines for each lamp, if the patch has lighting. The list is empty if nothing is known.
    /// With lamps, `level.off` only tells how well the light is known.
    std::vector<l3d_doubt_cosines> lamps;

    /// The linear map from a place in the picture to the piece's parameters, which run from -1/2 to
    /// 1/2. Shape: du/dx, du/dy, dv/dx, dv/dy.
    std::array<double, 4> parameters{};
    double u_off = 0, v_off = 0; ///< largest errors of the map `parameters`; infinite if unknown
    /// Largest distance of the piece's picture from the parallelogram of the map `parameters`, in
    /// pixels.
    double picture_off = 0;
    /// The part of picture_off that comes from the error of points. Halving the piece does not make
    /// this part smaller.
    double point_off = 0;

    /// Whether the piece may reach into a box.
    bool touches(const l3d_image_box& other) const;

    /// Whether the surface may end in a box. Expects: touches(other).
    bool may_end_in(const l3d_image_box& other) const;

    /// Whether the place (x, y) may be on the piece.
    bool may_show(double x, double y) const { return touches({x, y, x, y}); }

    /// The least and the largest value of a line over the part of a box that the piece may reach.
    std::array<double, 2> range(const l3d_doubt_line& of, const l3d_image_box& in) const;
};

/// A piece that is not halved any further for the present cells, and its bounds.
struct l3d_doubt_leaf {
    l3d_doubt_piece piece;
    l3d_doubt_bounds bounds;
    bool has_no_area = false; ///< whether the piece is seen edge-on, so that it adds no light

    /// Whether trims leave nothing of the piece. The piece is kept because sheets that meet it end
    /// there.
    bool is_gone() const { return piece.there == l3d_doubt_piece::left::none; }
};

/// Bounds the place, depth and light of a piece in a view. Cost: a microsecond.
l3d_doubt_bounds l3d_bounds_of(const l3d_doubt_piece& piece, const l3d_doubt_view& view);

#endif
