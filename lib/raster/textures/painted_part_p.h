// SPDX-License-Identifier: MIT
// painted_parts: parts of patches that pictures are laid on.
#ifndef L3D_RASTER_TEXTURES_PAINTED_PART_P_H
#define L3D_RASTER_TEXTURES_PAINTED_PART_P_H

#include "raster/surface_part.h"
#include "raster/textures/texture.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// The parameters of a place on a patch.
struct l3d_patch_parameters {
    double u = 0, v = 0;
};

namespace l3d_detail {

/// The map from a patch's parameters to a texture's picture, bilinear between the patch's corners.
struct picture_map {
    using place = std::array<double, 2>;
    place at_zero{0, 0}, along_u{1, 0}, along_v{0, 1}, along_both{0, 0};

    /// Makes the map. Shape: places in the picture at (u, v) = (0, 0), (1, 0), (0, 1) and (1, 1).
    static picture_map between(const std::array<place, 4>& corners) {
        picture_map result;
        for (std::size_t i = 0; i < 2; ++i) {
            result.at_zero[i] = corners[0][i];
            result.along_u[i] = corners[1][i] - corners[0][i];
            result.along_v[i] = corners[2][i] - corners[0][i];
            result.along_both[i] = corners[3][i] - corners[1][i] - result.along_v[i];
        }
        return result;
    }

    place at(const l3d_patch_parameters& p) const {
        place result;
        for (std::size_t i = 0; i < 2; ++i)
            result[i] =
                at_zero[i] + p.u * along_u[i] + p.v * along_v[i] + p.u * p.v * along_both[i];
        return result;
    }
};

/// A picture_map in floats, for parameters relative to those of one place on the patch. Shape: u
/// and v of the texture's picture.
///
/// Cost: floats round parameters by 2^-24 of the patch. This rounding is seen only where a patch
///       repeats a picture more often than pixels could show.
struct near_map {
    std::array<float, 2> at{}, along_u{}, along_v{}, along_both{};
};

/// A part of a patch that is painted with a texture. Each of its quads and triangles has a name of
/// its own: a number in place of a material's. Names rise with the quads' places in the grid, and
/// triangles follow the quads.
/// Lives: borrows part, parameters and texture.
struct painted_part {
    std::uint32_t first = 0;    ///< the name of the quad at index 0
    std::uint32_t material = 0; ///< the index of the part's material among the frame's materials
    const l3d_surface_part* part = nullptr;
    /// Parameters of the grid's first vertex, to which `near` and `parameters` are relative.
    l3d_patch_parameters origin;
    near_map near;
    /// Indices, in painted_parts::parameters, of the columns' and the rows' first parameters.
    std::size_t columns = 0, rows = 0;
    std::array<std::span<const l3d_patch_parameters>, 3>
        triangles; ///< the parameters of the triangles' corners
    const l3d_texture* texture = nullptr;
    picture_map map;

    /// The number of names for the quads of a part: one for each vertex of its grid.
    static std::size_t quads(const l3d_surface_part& part) {
        return static_cast<std::size_t>(part.grid.rows) * static_cast<std::size_t>(part.grid.pitch);
    }
};

/// All painted parts of a frame, in the order of their names. More parts may be added until the
/// frame is coloured.
struct painted_parts {
    std::vector<painted_part> all;
    std::vector<float> parameters; ///< the parameters of the columns and rows of all grids

    void clear() {
        all.clear();
        parameters.clear();
    }

    /// Adds a part whose grid's columns and rows have these parameters.
    /// Expects: all members of the part but origin, near, columns and rows are set.
    void add(painted_part of, std::span<const double> u, std::span<const double> v);

    /// Whether a name belongs to one of these parts.
    /// Expects: all triangles of models have smaller names.
    bool has(std::uint32_t name) const { return !all.empty() && name >= all.front().first; }
};

} // namespace l3d_detail

#endif
