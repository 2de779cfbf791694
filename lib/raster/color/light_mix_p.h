// SPDX-License-Identifier: MIT
// light_mix: the mean light of several pictures.
#ifndef L3D_RASTER_COLOR_LIGHT_MIX_P_H
#define L3D_RASTER_COLOR_LIGHT_MIX_P_H

#include "raster/parallel/workers.h"
#include "tool_2d/pixels.h"

#include <vector>

namespace l3d_detail {

/// Adds up the light of pictures, each with a weight. A pixel that is partly transparent adds less.
/// Cost: keep one object for many pictures, since it keeps its memory.
class light_mix {
public:
    /// Starts an empty sum over this part of the next pictures.
    void begin(const l3d_pixel_box& box);

    /// Expects: the box lies in the picture. Over all pictures, weights add up to 1.
    void add(const l3d_pixels& picture, float weight, l3d_workers& workers);

    /// Writes the nearest levels of the sums. A word that all pictures share stays.
    void write(const l3d_pixels& target, l3d_workers& workers) const;

private:
    /// Units: linear, from 0 to 1.
    struct sum {
        float red = 0, green = 0, blue = 0;
        float empty = 0; ///< the part that shows nothing
    };

    template <class Visit> void for_rows(l3d_workers& workers, const Visit& visit) const;

    l3d_pixel_box box_;
    std::vector<sum> sums_; ///< row by row
};

} // namespace l3d_detail

#endif
