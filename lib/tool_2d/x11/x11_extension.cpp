// SPDX-License-Identifier: MIT
// clear_stack_below: not inlined, so that its array lies where the next call's does.
#include "tool_2d/x11/x11_extension_p.h"

#include <algorithm>
#include <array>

namespace l3d_detail {

[[gnu::noinline]] void clear_stack_below() {
    std::array<volatile char, 4096> below;
    std::ranges::fill(below, '\0');
}

} // namespace l3d_detail
