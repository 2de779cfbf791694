// SPDX-License-Identifier: MIT
// The teapot's text; the build makes the included file from data/teapot.bpt.
#include "geom/teapot.h"

std::string_view l3d_teapot_bpt() {
    static constexpr std::string_view text =
#include "data/teapot.bpt.inc"
        ;
    return text;
}
