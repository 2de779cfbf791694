// SPDX-License-Identifier: MIT
// The vector instruction set that the fast paths use.
#ifndef L3D_RASTER_PARALLEL_SIMD_TARGET_H
#define L3D_RASTER_PARALLEL_SIMD_TARGET_H

#include <string>
#include <string_view>
#include <vector>

/// The instruction sets that this processor has and the library was built for, best first. Names
/// are spelled as in Highway: AVX3 (that is AVX-512), AVX2, SSE4. BASE stands for the set that the
/// compiler assumes anyway.
std::vector<std::string> l3d_simd_targets();

/// The instruction set in use: the best one, unless another was set.
std::string l3d_simd_target();

/// Sets the instruction set of the fast paths for the whole process; an empty name means the best
/// one. Use the function to compare sets: pictures have the same bits with every set.
/// Errors:  false, and nothing changes, if there is no set of this name.
/// Expects: nothing is being drawn meanwhile.
bool l3d_set_simd_target(std::string_view name);

#endif
