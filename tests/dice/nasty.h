// SPDX-License-Identifier: MIT
// Random patches where a projection is least itself: at, around and far from the eye.
#ifndef L3D_TESTS_DICE_NASTY_H
#define L3D_TESTS_DICE_NASTY_H

#include "reference/exact.h"
#include "reference/random_numbers.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace dice_tests {

using reference::random_numbers;

enum class nasty_kind {
    around_eye, ///< control points on all sides of the eye
    crossing,   ///< from behind the near plane to far before it
    spear,      ///< along the line of sight, distances 1 : 1000
    deep,       ///< any picture position, distances 1 : 100000
    wide,       ///< up to 100000 pixels from the picture's centre
    flat,       ///< planes: straight chords are exact, all error is that of vertices
};

/// All kinds, with the names that test output gives them.
inline constexpr std::pair<nasty_kind, const char*> nasty_kinds[] = {
    {nasty_kind::around_eye, "around eye"},
    {nasty_kind::crossing, "crossing"},
    {nasty_kind::spear, "spear"},
    {nasty_kind::deep, "deep"},
    {nasty_kind::wide, "wide"},
    {nasty_kind::flat, "flat"}};

/// The same seed gives the same patches with every compiler.
std::vector<reference::patch> nasty_patches(std::uint64_t seed, nasty_kind kind, int count,
                                            const reference::camera& view,
                                            reference::picture_size size);

/// One each of all the ways to be nasty without being infinite.
std::vector<reference::patch> hopeless_patches(std::uint64_t seed, const reference::camera& view,
                                               reference::picture_size size);

} // namespace dice_tests

#endif
