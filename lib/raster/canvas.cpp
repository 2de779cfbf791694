// SPDX-License-Identifier: MIT
// l3d_memory_canvas: makes a canvas with the system's font.
#include "raster/rasterizer_factory.h"

#include <string>
#include <utility>

namespace {

/// Makes a canvas around memory. A font that cannot be read is ignored; l3d_font::of_system tells
/// the reason.
template <class Memory> l3d_canvas around(const Memory& memory) {
    std::string why;
    return {std::make_unique<l3d_screen_memory>(memory),
            std::make_shared<l3d_rasterizer_factory_sw>(), l3d_font::of_system(why)};
}

} // namespace

l3d_canvas l3d_memory_canvas(l3d_size size) {
    return around(size);
}

l3d_canvas l3d_memory_canvas(const l3d_pixels& words) {
    return around(words);
}

l3d_canvas l3d_memory_canvas(const l3d_packed_pixels& packed) {
    return around(packed);
}
