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

/// Tells whether exact pieces hide a place of a line in the picture.
///
/// Pieces are halved until they are flat to 1/256 pixel. So the answer is exact for some ray within
/// 1/256 pixel of the place. Halves are kept for further calls.
class line_of_sight {
public:
    /// How much nearer than a place a surface must be to hide the place. The surface that holds the
    /// place's own line is never so much nearer.
    /// Units: pixels of depth.
    static constexpr double least_gap = 0.25;
    /// How much nearer a piece must be to hide a place if the line follows the piece's side.
    static constexpr double least_gap_of_sides = 2;

    /// Lives: borrows pieces and view.
    line_of_sight(std::span<const image_piece> pieces, const drawing_view& view);

    /// Whether a piece lies in front of the place. `sides` has the indices of the pieces whose
    /// sides the line follows.
    bool is_hidden(const image_place& at, std::span<const std::size_t> sides);

private:
    /// A rectangle of a piece's parameters with the net over it. Its halves are made when a search
    /// first needs them.
    struct node {
        bernstein_net net;
        double u0 = 0, u1 = 1, v0 = 0, v1 = 1;
        std::size_t halves = 0; ///< the index of the first half; 0 for none yet
        int halvings = 0;
        /// The box of the net; nothing if the net reaches the near plane.
        std::optional<image_bounds> box;
        std::optional<flat_image> flat; ///< the parallelogram that stands for a flat net
    };

    void add(bernstein_net net, const node* whole, bool along_u, bool second);
    bool hides(std::size_t piece, const image_place& at, double gap);
    void split(std::size_t index);

    std::span<const image_piece> pieces_;
    const drawing_view& view_;
    std::vector<node> nodes_; ///< the first nodes are whole pieces
    std::vector<std::size_t> stack_;
};

} // namespace l3d_detail

#endif
