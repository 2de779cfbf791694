// SPDX-License-Identifier: MIT
// painter_pairs: tells which of two items must be painted after the other.
#ifndef L3D_PIPELINE_ZSORT_PAINTER_PAIRS_P_H
#define L3D_PIPELINE_ZSORT_PAINTER_PAIRS_P_H

#include "pipeline/zsort/painter_items_p.h"
#include "pipeline/zsort/painter_overlap_p.h"
#include "pipeline/zsort/painter_tiles_p.h"

#include <array>
#include <cstdint>

namespace l3d_detail {

/// Compares two items: tells which triangle must be painted after the other.
///
/// Lives: borrows the items.
class painter_pairs {
public:
    explicit painter_pairs(const painter_items& items) : items_(items) {}

    /// Whether `item` must be painted after `other`. This is so if both meet in the picture and
    /// `item` is in front of `other` somewhere.
    /// Expects: if both entries are exact, they have a cell in common.
    bool needs(const painter_entry& item, const painter_entry& other) const {
        return ((item.is_exact && other.is_exact) || do_meet(item.number, other.number)) &&
               (other.nearest <= item.farthest ||
                front_of(corners(item.number), corners(other.number)).first);
    }

private:
    const std::array<l3d_micro_vertex, 3>& corners(std::uint32_t number) const {
        return items_.corners(items_[number]);
    }

    /// Whether the insides of two items meet. If sides are not drawn, the boxes of pixels already
    /// tell apart many items that lie side by side.
    bool do_meet(std::uint32_t a, std::uint32_t b) const {
        return (!items_.are_pixels_all() || items_[a].box_meets(items_[b])) &&
               insides_meet(corners(a), corners(b));
    }

    const painter_items& items_;
};

} // namespace l3d_detail

#endif
