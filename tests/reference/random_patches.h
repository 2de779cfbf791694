// SPDX-License-Identifier: MIT
// Random surfaces in front of a camera, ordinary and nasty ones.
#ifndef L3D_REFERENCE_RANDOM_PATCHES_H
#define L3D_REFERENCE_RANDOM_PATCHES_H

#include "reference/exact.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace reference {

enum class patch_kind {
    moderate,   ///< gently curved, a twentieth to half of the picture wide
    thin,       ///< one side up to 1e6 times the other
    folded,     ///< control points at random places: folds, loops, several layers
    coincident, ///< control points that coincide, and edges that are collapsed into points
    stiff,      ///< parametric speed that changes up to 1e6 times within the patch
};

/// All kinds, with the names that test output gives them.
inline constexpr std::pair<patch_kind, const char*> patch_kinds[] = {
    {patch_kind::moderate, "moderate"},
    {patch_kind::thin, "thin"},
    {patch_kind::folded, "folded"},
    {patch_kind::coincident, "coincident"},
    {patch_kind::stiff, "stiff"}};

/// Makes random patches of one kind. All control points lie at w >= 2 near. The same seed gives the
/// same patches everywhere, since the generator is our own.
std::vector<patch> random_patches(std::uint64_t seed, patch_kind kind, int count,
                                  const camera& view, picture_size size);

/// Makes k x k patches that share their edges bit for bit and together cover the whole window.
///
/// Each patch's parameters are turned and mirrored at random, in all eight ways. `fold` is the
/// displacement of inner control points, in cells of the control lattice. Below 0.3 there is hardly
/// any fold, at 2 folds are everywhere. The depths of neighbouring control points differ by up to 1
/// : 1 + depth.
///
/// The patches surely cover the window. The outer control points, hence the hulls of the outer
/// edges, stay beyond the window's sides, so the outer boundary runs round it once.
std::vector<patch> random_tiling(std::uint64_t seed, int k, double fold, double depth,
                                 const camera& view, picture_size size);

} // namespace reference

#endif
