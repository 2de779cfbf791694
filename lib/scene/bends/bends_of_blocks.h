// SPDX-License-Identifier: MIT
// bends_of_blocks: bounds the bends of a patch part by part, and quarters parts whose bounds are
// loose.
#ifndef L3D_SCENE_BENDS_BENDS_OF_BLOCKS_H
#define L3D_SCENE_BENDS_BENDS_OF_BLOCKS_H

#include "scene/bends/surface_bends_p.h"

#include <array>
#include <cstddef>
#include <vector>

namespace l3d_detail {

/// Finds bounds of the bend numbers (bend_number) of a patch's blocks, for l3d_surface_bends. The
/// bound of a number in a block is the largest of its bounds in the block's parts.
///
/// At first a block has four parts. The number's value in the middle of a part is at most its
/// largest value in the block. So the value tells how loose a bound can be. The loosest parts are
/// quartered, as long as `groups` has room.
class bends_of_blocks {
public:
    bends_of_blocks(const l3d_bezier_patch<double, 3>& patch, const l3d_normal_net& normals);

    /// The bound of a bend number in a block, for derivatives by parameters from 0 to 1 across the
    /// block.
    double most(std::size_t number, std::size_t block) const { return most_[number][block]; }

private:
    /// The largest number of groups of eight parts: one for each row of parts, and five for
    /// quarters of the loosest parts. Bounding them all takes 60 us a patch.
    static constexpr std::size_t groups = bend_parts + 5;
    static constexpr std::size_t blocks = l3d_surface_bends::blocks;

    struct part {
        std::size_t group, lane, block;
        int halvings; ///< how often the block's sides were halved to make the part
        double looseness;
    };

    void add(std::size_t group, std::size_t lane, std::size_t block, int halvings);
    void judge();
    double looseness(const part& p) const;
    bool quarter_loosest();

    part_group parts_[groups];
    group_bounds bounds_[groups];
    std::size_t used_ = bend_parts;
    std::vector<part> leaves_;
    double size_ = 0;
    double least_[bend_numbers][blocks], most_[bend_numbers][blocks];
    double by_good_[bend_numbers][blocks];
};

} // namespace l3d_detail

#endif
