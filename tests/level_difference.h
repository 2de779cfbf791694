// SPDX-License-Identifier: MIT
// How far two pixel words are apart.
#ifndef L3D_TESTS_LEVEL_DIFFERENCE_H
#define L3D_TESTS_LEVEL_DIFFERENCE_H

#include <algorithm>
#include <cstdint>
#include <cstdlib>

/// The most that one of the four bytes differs by: red, green, blue, or the highest.
inline int level_difference(std::uint32_t a, std::uint32_t b) {
    int most = 0;
    for (int shift = 0; shift < 32; shift += 8)
        most = std::max(most, std::abs(static_cast<int>(a >> shift & 255) -
                                       static_cast<int>(b >> shift & 255)));
    return most;
}

#endif
