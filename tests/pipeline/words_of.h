// SPDX-License-Identifier: MIT
// A picture's pixels, row by row, without what may lie between rows.
#ifndef L3D_TESTS_PIPELINE_WORDS_OF_H
#define L3D_TESTS_PIPELINE_WORDS_OF_H

#include "tool_2d/pixels.h"

#include <cstdint>
#include <vector>

inline std::vector<std::uint32_t> words_of(const l3d_pixels& pixels) {
    std::vector<std::uint32_t> result;
    for (int y = 0; y < pixels.height; ++y) {
        const auto row = pixels.row(y);
        result.insert(result.end(), row.begin(), row.end());
    }
    return result;
}

#endif
