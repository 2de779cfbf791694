// SPDX-License-Identifier: MIT
// The version of l3d that a program is compiled with.
#ifndef L3D_BASE_VERSION_H
#define L3D_BASE_VERSION_H

/// The first number of the version. Versions are compared by the first number, then the second,
/// then the third. From 1.0.0 on, a program that compiles with one version compiles with every
/// later one of the same first number.
#define L3D_VERSION_MAJOR 0
/// The second number: counted up when something is added or, before 1.0, changed.
#define L3D_VERSION_MINOR 1
/// The third number: counted up when something is mended and nothing else differs.
#define L3D_VERSION_PATCH 0

/// The version as one number with two digits for each part, for `#if L3D_VERSION >= 100`.
#define L3D_VERSION (L3D_VERSION_MAJOR * 10000 + L3D_VERSION_MINOR * 100 + L3D_VERSION_PATCH)

/// The version as text.
#define L3D_VERSION_TEXT "0.1.0"

#endif
