// SPDX-License-Identifier: MIT
// l3d_memory_canvas.
#include "raster/canvas.h"

#include "raster/rasterizer_factory_sw.h"
#include "tool_2d/screen_memory.h"

l3d_canvas l3d_memory_canvas(l3d_size size) {
    return {std::make_unique<l3d_screen_memory>(size),
            std::make_shared<l3d_rasterizer_factory_sw>()};
}
