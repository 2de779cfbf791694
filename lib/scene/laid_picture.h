// SPDX-License-Identifier: MIT
// l3d_laid_picture: a picture that lies on the patches of an instance.
#ifndef L3D_SCENE_LAID_PICTURE_H
#define L3D_SCENE_LAID_PICTURE_H

#include "base/public.h"
#include "raster/textures/texture.h"

#include <array>
#include <memory>
#include <vector>

/// A part of a patch by its parameters.
struct L3D_PUBLIC l3d_parameter_range {
    double u0 = 0; ///< where u begins
    double u1 = 1; ///< where u ends
    double v0 = 0; ///< where v begins
    double v1 = 1; ///< where v ends

    /// One of the two halves along u, or along v.
    l3d_parameter_range half(bool along_u, bool second) const {
        l3d_parameter_range result = *this;
        if (along_u)
            (second ? result.u0 : result.u1) = (u0 + u1) / 2;
        else
            (second ? result.v0 : result.v1) = (v0 + v1) / 2;
        return result;
    }
};

/// A picture, and where it lies on patches.
///
///     std::vector<std::string> notes;
///     scene.lay(0, {.texture = l3d_read_texture("wood.png", notes)});
///
/// Shape: a place of a picture is (0, 0) in its upper left corner and (1, 1) in the lower right
///        one; beyond, l3d_texture_wrap says what is seen. Corners of a patch are those at
///        parameters (u, v) of (0, 0), (1, 0), (0, 1) and (1, 1).
struct L3D_PUBLIC l3d_laid_picture {
    /// The places of a patch's corners; between them, places are bilinear in u and v.
    using corners = std::array<std::array<double, 2>, 4>;
    /// Those that lay the whole picture on a patch.
    static constexpr corners whole{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};

    std::shared_ptr<const l3d_texture> texture; ///< none shows the colours of materials
    /// The corners of each piece of the model, in order. Without them, the whole picture lies on
    /// each piece.
    std::vector<corners> pieces{};

    friend bool operator==(const l3d_laid_picture&, const l3d_laid_picture&) = default;
};

#endif
