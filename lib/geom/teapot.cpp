// SPDX-License-Identifier: MIT
// Holds the teapot's text; the build makes the included file from data/teapot.bpt.
#include "geom/teapot.h"

std::string_view l3d_teapot_bpt() {
    static constexpr std::string_view text =
#include "data/teapot.bpt.inc"
        ;
    return text;
}

/// The body has 12 of the 28 patches, 4 of which are its rim; handle and spout have 4 each, the lid
/// 8.
std::vector<l3d_part_run> l3d_teapot_parts() {
    return {{"body", 0}, {"handle", 12}, {"spout", 16}, {"lid", 20}};
}
