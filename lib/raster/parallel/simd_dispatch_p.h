// SPDX-License-Identifier: MIT
// Compiles a function once for each vector instruction set, and chooses among the results.
//
// Highway's own choice lives in its shared library, whose loading costs 7 ms, more than all the
// rest of a small program's start. So its headers compile the functions, and the choice is made
// here.
#ifndef L3D_RASTER_PARALLEL_SIMD_DISPATCH_P_H
#define L3D_RASTER_PARALLEL_SIMD_DISPATCH_P_H

#include <hwy/highway.h>

#include <cstddef>

namespace l3d_detail {

/// The index of the instruction set in use, in the tables that L3D_SIMD_TABLE defines.
std::size_t simd_place();

} // namespace l3d_detail

/// Defines the table of a function's versions, best first; the last one serves everywhere. Use it
/// in the part of a file that is compiled once, in the function's namespace, but outside of
/// N_<target>.
#define L3D_SIMD_TABLE(function)                                                                   \
    constexpr decltype(&HWY_STATIC_DISPATCH(function)) function##_by_target[] = {                  \
        HWY_CHOOSE_AVX3(function), HWY_CHOOSE_AVX2(function), HWY_CHOOSE_SSE4(function),           \
        &HWY_STATIC_DISPATCH(function)}

/// The version of a function for the instruction set in use, ready to be called.
#define L3D_SIMD_CALL(function) (*function##_by_target[l3d_detail::simd_place()])

#endif
