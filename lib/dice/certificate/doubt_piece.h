// SPDX-License-Identifier: MIT
// l3d_doubt_piece: a part of an exact patch.
#ifndef L3D_DICE_CERTIFICATE_DOUBT_PIECE_H
#define L3D_DICE_CERTIFICATE_DOUBT_PIECE_H

#include "dice/certificate/light_bounds.h"
#include "scene/side_pairs.h"
#include "geom/normal_net.h"
#include "geom/step_bound.h"
#include "raster/background.h"
#include "raster/lighting.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

/// A lamp of the exact picture.
struct l3d_doubt_lamp {
    l3d_vector<double, 3> direction{0.0, 0.0, 1.0}; ///< towards it: unit, in the world
    l3d_light_color color{1, 1, 1};                 ///< parts of white
};

/// Light by the rule of l3d_lighting, and fog.
struct l3d_doubt_lighting {
    l3d_light_color ambient{};
    std::vector<l3d_doubt_lamp> lamps; ///< at most l3d_lighting::most_further + 1
    l3d_fog fog;
    double depth_scale = 1; ///< w / distance along the view axis, from the eye of w
    double nearer = 0;      ///< the camera's eye is so much nearer than that of w
};

/// A patch that stands in the picture.
struct l3d_doubt_patch {
    std::uint32_t instance = 0, patch = 0;
    double error_xy = 0, error_w = 0; ///< errors of its homogeneous points
    double near = 0;                  ///< nothing nearer is drawn
    double normal_off = 0;            ///< error of its normals, whose length is that of the model's
    const l3d_side_pairs* sides = nullptr; ///< neighbours in its model
    /// Whether its back need not be drawn, and the sign of the facing that is the back.
    bool one_sided = false;
    double back = 1;
    l3d_color_parts color{1, 1, 1}; ///< colour of its material
    l3d_color_parts highlight{};    ///< likewise
    int sharpness = 1;
    /// The frame's lights and fog; null for one white light without highlights and fog.
    const l3d_doubt_lighting* lighting = nullptr;

    /// Whether it looks like another one in the same light.
    bool looks_like(const l3d_doubt_patch& other) const {
        return color == other.color && highlight == other.highlight && sharpness == other.sharpness;
    }
};

/// A part of a patch by halves. Shape: nets as l3d_bezier_patch and l3d_normal_net have them.
struct l3d_doubt_piece {
    using vector = l3d_vector<double, 3>;
    static constexpr std::size_t order = 6; ///< order of normals, of degree 5

    const l3d_doubt_patch* of = nullptr;
    l3d_image_patch net;
    std::array<vector, order * order> normals; ///< in the world
    double u0 = 0, u1 = 1, v0 = 0, v1 = 1;     ///< parameters in the patch; exact

    /// The halves along u, or along v.
    std::pair<l3d_doubt_piece, l3d_doubt_piece> split(bool along_u) const;

    /// Whether the picture is longer along u than along v. Expects: every w > 0.
    bool is_longer_along_u() const;

    /// Whether the piece reaches a side of its patch, in the order of l3d_side_pairs.
    bool reaches(std::size_t side) const {
        return side == 0 ? v0 == 0 : side == 1 ? u1 == 1 : side == 2 ? v1 == 1 : u0 == 0;
    }
};

#endif
