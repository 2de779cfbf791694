// SPDX-License-Identifier: MIT
// l3d_cubic_frame_buffer: a cube of cells, each empty or with a piece of surface in it.
#ifndef L3D_COMPARE_CELLS_CUBIC_FRAME_BUFFER_H
#define L3D_COMPARE_CELLS_CUBIC_FRAME_BUFFER_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

/// A picture in three dimensions: a scene is filled in once, and can be seen from anywhere.
///
/// Filled cells hold a normal. Bricks of 8 x 8 x 8 cells hold them. A brick takes memory, 2 KB,
/// only if one of its cells is filled; a ray strides over the others.
/// Units:  cells; the cube reaches from 0 to resolution() along each axis.
/// Source: Kaufman, Efficient Algorithms for 3D Scan-Conversion of Parametric Curves, Surfaces, and
/// Volumes, SIGGRAPH 1987. Rays as in Amanatides, Woo, A Fast Voxel Traversal Algorithm for Ray
/// Tracing, Eurographics 1987, here on two levels.
class l3d_cubic_frame_buffer {
public:
    using place = std::array<double, 3>;

    /// Makes all cells empty. Expects: 1 <= resolution <= 1024.
    void reset(int resolution);

    int resolution() const { return resolution_; }
    std::size_t filled() const { return filled_; }

    /// Fills the cell of a point with a normal, unless that cell is filled already. Points outside
    /// of the cube are left out.
    /// Units:   a unit vector, or zero.
    void fill(const place& at, const std::array<float, 3>& normal);

    /// Whether a cell is filled. Expects: a cell of the cube.
    bool is_filled(const std::array<int, 3>& of) const;

    /// The first filled cell that a ray meets.
    struct hit {
        double t;                    ///< origin + t direction is nearest to the cell's middle
        std::array<float, 3> normal; ///< good to a part in 500
    };
    /// Follows origin + t direction from t = `least_t` on. Nothing if no filled cell is met.
    /// Expects: direction of finite components, not zero.
    std::optional<hit> first(const place& origin, const place& direction, double least_t) const;

private:
    static constexpr int side = 8; ///< side of a brick, in cells
    using cell = std::uint32_t;    ///< 0: empty; else a bit and three components of 10 bits
    using brick = std::array<cell, std::size_t{side} * side * side>;

    int bricks() const { return (resolution_ + side - 1) / side; } ///< along an axis
    const brick* brick_at(const std::array<int, 3>& of) const;

    int resolution_ = 0;
    std::size_t filled_ = 0;
    std::vector<std::uint32_t> index_; ///< places in bricks_, plus one; 0: an empty brick
    std::vector<brick> bricks_;
};

#endif
