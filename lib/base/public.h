// SPDX-License-Identifier: MIT
// The first include of every public header: the language that it needs, and the mark of exported
// names.
#ifndef L3D_BASE_PUBLIC_H
#define L3D_BASE_PUBLIC_H

#if __cplusplus < 202002L
#error "l3d needs C++20: compile with -std=c++20 or a later standard"
#endif

/// Marks names that programs may link to. All other names in the shared library are hidden.
#define L3D_PUBLIC [[gnu::visibility("default")]]

#endif
