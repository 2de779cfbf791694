// SPDX-License-Identifier: MIT
// line_of_sight: tells whether a surface lies in front of a place.
#ifndef L3D_SCENE_DRAWING_SIGHT_P_H
#define L3D_SCENE_DRAWING_SIGHT_P_H

#include "scene/drawing/image_piece_p.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace l3d_detail {

/// Tells whether a place of the picture is hidden by exact pieces.
///
/// Pieces are halved until they are flat to 1/256 pixel. So the answer is exact for a ray that
/// passes within that distance. Halves are kept for further questions.
class line_of_sight {
public:
    /// How much nearer than a place a surface must be to hide it. The place's line may lie on a
    /// surface that is not.
    /// Units: pixels of depth.
    static constexpr double least_gap = 0.25;
    /// The same for pieces whose sides the line follows.
    static constexpr double least_gap_of_sides = 2;

    /// Lives: borrows pieces and view.
    line_of_sight(std::span<const image_piece> pieces, const drawing_view& view);

    /// Whether a piece lies in front of the place. `sides` are the pieces whose sides the line
    /// follows.
    bool is_hidden(const image_place& at, std::span<const std::size_t> sides);

private:
    /// A part of a piece, with its halves once somebody asked for them.
    struct node {
        bernstein_net net;
        double u0 = 0, u1 = 1, v0 = 0, v1 = 1;
        std::size_t halves = 0; ///< the index of the first half; 0 for none yet
        int halvings = 0;
        std::optional<image_bounds> box; ///< nothing if not all is in front of the near plane
        std::optional<flat_image> flat;  ///< for flat parts
    };

    void add(bernstein_net net, const node* whole, bool along_u, bool second);
    bool hides(std::size_t piece, const image_place& at, double gap);
    void split(std::size_t index);

    std::span<const image_piece> pieces_;
    const drawing_view& view_;
    std::vector<node> nodes_; ///< the first ones are whole pieces
    std::vector<std::size_t> stack_;
};

} // namespace l3d_detail

#endif
