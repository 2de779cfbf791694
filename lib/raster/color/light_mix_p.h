// SPDX-License-Identifier: MIT
// light_mix: the mean light of several pictures.
#ifndef L3D_RASTER_COLOR_LIGHT_MIX_P_H
#define L3D_RASTER_COLOR_LIGHT_MIX_P_H

#include "raster/parallel/workers.h"
#include "tool_2d/pixels.h"

#include <vector>

namespace l3d_detail {

/// Finds the mean light of several pictures: adds up the pictures' light, each picture's with a
/// weight. A partly transparent pixel adds less light.
/// Cost: keep one object for many pictures, since it keeps its memory.
class light_mix {
public:
    /// Starts an empty sum over a box of the pictures that are added later.
    void begin(const l3d_pixel_box& box);

    /// Adds a picture.
    /// Expects: the box of begin() lies in the picture. The weights of all pictures add up to 1.
    void add(const l3d_pixels& picture, float weight, l3d_workers& workers);

    /// Writes pixel words whose levels are nearest to the sums. If all pictures have the same word
    /// in a pixel, this word is written.
    void write(const l3d_pixels& target, l3d_workers& workers) const;

private:
    /// The sums of one pixel. Units: linear light, from 0 to 1.
    struct sum {
        float red = 0, green = 0, blue = 0;
        /// The sum over pictures of the weight times the pixel's transparent share.
        float empty = 0;
    };

    template <class Visit> void for_rows(l3d_workers& workers, const Visit& visit) const;

    l3d_pixel_box box_;
    std::vector<sum> sums_; ///< a sum for each of the box's pixels, row by row
};

} // namespace l3d_detail

#endif
