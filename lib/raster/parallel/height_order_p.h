// SPDX-License-Identifier: MIT
// height_order: sorts things from the picture's top down, for l3d_workers::for_each_beside.
#ifndef L3D_RASTER_PARALLEL_HEIGHT_ORDER_P_H
#define L3D_RASTER_PARALLEL_HEIGHT_ORDER_P_H

#include "raster/parallel/workers.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace l3d_detail {

/// Sorts things by their heights in the picture, before they are filled. Things are then filled in
/// the order of the picture's bands. So the worker that fills a thing is mostly the worker that
/// made it, whose core has the thing in its cache.
///
/// Lives: keeps its memory from frame to frame.
class height_order {
public:
    void clear() { places_.clear(); }

    /// Adds the next thing. Units: y in any unit, growing downwards, the same for all things.
    void add(std::int32_t y) { places_.push_back({y, static_cast<std::uint32_t>(places_.size())}); }

    /// Sorts the things, unless there is only one worker.
    void sort_for(const l3d_workers& workers) {
        if (workers.count() > 1)
            std::sort(places_.begin(), places_.end());
    }

    /// The thing that is i-th from the top. The result is its number in the order of the calls of
    /// add().
    std::size_t operator[](int i) const { return places_[static_cast<std::size_t>(i)].index; }

private:
    struct place {
        std::int32_t y;
        std::uint32_t index;

        bool operator<(const place& other) const {
            return std::tie(y, index) < std::tie(other.y, other.index);
        }
    };

    std::vector<place> places_;
};

} // namespace l3d_detail

#endif
