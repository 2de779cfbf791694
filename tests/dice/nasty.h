// SPDX-License-Identifier: MIT
// Random patches where a projection is least itself: at, around and far from the eye.
#ifndef L3D_TESTS_DICE_NASTY_H
#define L3D_TESTS_DICE_NASTY_H

#include "reference/exact.h"

#include <cstdint>
#include <vector>

namespace dice_tests {

enum class nasty_kind {
    around_eye, ///< control points on all sides of the eye
    crossing,   ///< from behind the near plane to far before it
    spear,      ///< along the line of sight, distances 1 : 1000
    deep,       ///< any picture position, distances 1 : 100000
    wide,       ///< up to 100000 pixels from the picture's centre
    flat,       ///< planes: straight chords are exact, all error is that of vertices
};

/// The same seed gives the same patches with every compiler.
std::vector<reference::patch> nasty_patches(std::uint64_t seed, nasty_kind kind, int count,
                                            const reference::camera& view,
                                            reference::picture_size size);

/// One each of all the ways to be nasty without being infinite.
std::vector<reference::patch> hopeless_patches(std::uint64_t seed, const reference::camera& view,
                                               reference::picture_size size);

/// A source of numbers that is the same with every library.
class number_source {
public:
    explicit number_source(std::uint64_t seed) : state_(seed) {}
    double between(double low, double high);
    /// Every order of magnitude alike. Expects: 0 < low <= high.
    double of_any_size(double low, double high);

private:
    std::uint64_t state_;
};

} // namespace dice_tests

#endif
