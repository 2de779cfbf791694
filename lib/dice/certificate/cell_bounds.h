// SPDX-License-Identifier: MIT
// l3d_cell_bounds: bounds the exact picture in a part of a pixel.
#ifndef L3D_DICE_CERTIFICATE_CELL_BOUNDS_H
#define L3D_DICE_CERTIFICATE_CELL_BOUNDS_H

#include "base/directed_sets_p.h"
#include "dice/certificate/doubt_bounds.h"
#include "dice/certificate/light_bounds.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

/// Bounds the light of the exact picture in cells, from the pieces that reach into them. A cell is
/// a square of the picture, a pixel or smaller. A piece is a small part of a patch.
///
/// Pieces that meet make a sheet. If no piece of a sheet ends, folds or breaks in a cell, the sheet
/// fills the cell or lies outside it (NUMERICS, The map of doubt).
/// Lives: kept for its memory.
/// Cost:  grows with the square of the number of pieces.
class l3d_cell_bounds {
public:
    /// Bounds the exact picture in a cell.
    /// Shape: `touching` has the indices in `leaves` of all pieces that may reach into the cell.
    l3d_doubt_verdict judge(const l3d_image_box& cell, std::span<const std::uint32_t> touching,
                            std::span<const l3d_doubt_leaf> leaves, const l3d_dice_view& view,
                            const l3d_light_bounds& background);

    /// Whether a cell, grown by the bound of places, certainly shows a single surface. The cell
    /// must show this surface alone even if each surface is drawn nearer or farther by its bound of
    /// depth.
    /// Shape: `touching` as in judge().
    bool is_drawn_alone(const l3d_image_box& grown, std::span<const std::uint32_t> touching,
                        std::span<const l3d_doubt_leaf> leaves, const l3d_dice_view& view);

    /// Bounds the exact picture in a part of the cell that was judged last.
    /// Expects: judge() found that a single surface, or the background, fills that cell.
    l3d_doubt_verdict judge_alone(const l3d_image_box& part,
                                  const l3d_light_bounds& background) const;

    /// Sets the flags in `pieces` of all pieces that may be seen in the cell that was judged last.
    /// All other pieces are wholly hidden in the cell. Parts of the cell can be bounded without the
    /// hidden pieces.
    void mark_seen(std::vector<bool>& pieces) const;

    /// Whether it is hopeless to cut the cell that was judged last, since its parts would hardly be
    /// bounded better. It is hopeless if a piece without any bound of its normals may be seen at
    /// each of the cell's corners.
    bool is_hopeless() const { return is_hopeless_; }

    /// The facts about a piece that decide which other pieces it meets.
    struct member {
        l3d_image_box part; ///< the part of the piece's box that lies in the cell
        double u0, u1, v0, v1;
        const l3d_doubt_patch* of;
        unsigned sides; ///< a bit for each side of the patch that the piece reaches
        int facing;
        std::uint32_t index; ///< the piece's index in `leaves`
        /// A bit for each corner of the cell at which the piece may have any light.
        unsigned dark_corners;
        double nearest = 0; ///< least w of the piece in the cell
    };

private:
    /// The facts about a sheet. A sheet holds pieces that are connected in the cell, and perhaps
    /// further pieces.
    struct sheet {
        bool may_end = false; ///< whether the sheet may end or fold in the cell
        bool is_there = false, may_be_there = false;
        bool is_seen = false; ///< whether the sheet may be seen in the cell
        double farthest = 0;  ///< largest w of the sheet in the cell
        bool fills() const { return is_there && !may_end; }
    };

    void gather(const l3d_image_box& cell, std::span<const std::uint32_t> touching,
                std::span<const l3d_doubt_leaf> leaves);
    void connect();
    void look_for(const l3d_image_box& cell, const l3d_dice_view& view, double margin);
    double farthest_seen();
    /// Whether piece i may be seen, if everything beyond w = `farthest` is hidden.
    bool may_be_seen(std::size_t i, double farthest) const;
    /// The index of the member that stands for the sheet of member i.
    std::size_t root_of(std::size_t i) const { return joined_.find(i).line; }

    static constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

    std::vector<const l3d_doubt_leaf*> pieces_;
    std::vector<member> members_; ///< one member for each of pieces_, in the same order
    /// Sets of members, one for each sheet; the sets' directions are not used.
    l3d_detail::directed_sets joined_;
    std::vector<sheet> sheets_;  ///< one for each member; valid only for the roots of sheets
    std::size_t only_ = nowhere; ///< the root of the only sheet that is seen in the cell
    bool is_hopeless_ = false;
};

#endif
