// SPDX-License-Identifier: MIT
// l3d_arithmetic: the number types that forward differences can be walked in.
#ifndef L3D_COMPARE_ARITHMETIC_H
#define L3D_COMPARE_ARITHMETIC_H

/// Numbers that forward differences can be walked in.
enum class l3d_arithmetic {
    float_32,
    float_64,
    fixed_16_16, ///< 32 bits, 16 after the point
    block_32,    ///< 32 bits, an exponent for each coordinate of a patch
    fixed_32_32, ///< 64 bits, 32 after the point
};

/// The arithmetic that the build uses as l3d_real.
l3d_arithmetic l3d_real_arithmetic();

const char* l3d_name_of(l3d_arithmetic arithmetic);

#endif
