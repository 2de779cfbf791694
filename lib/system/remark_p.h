// SPDX-License-Identifier: MIT
// pass_on_remark: what a screen has to say reaches the user.
#ifndef L3D_SYSTEM_REMARK_P_H
#define L3D_SYSTEM_REMARK_P_H

#include "tool_2d/screen.h"

#include <iostream>
#include <string_view>

namespace l3d_detail {

/// One line on stderr, "program: remark", if the screen has one.
inline void pass_on_remark(l3d_screen& screen, std::string_view program) {
    if (const auto remark = screen.take_remark(); !remark.empty())
        std::cerr << program << ": " << remark << '\n';
}

} // namespace l3d_detail

#endif
