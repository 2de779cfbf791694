// SPDX-License-Identifier: MIT
// l3d_screen_memory: padded pixels, and nothing else.
#include "tool_2d/screen_memory.h"

#include <new>

l3d_screen_memory::l3d_screen_memory(l3d_size size) : image_(size, l3d_padded_stride(size.width)) {
    assert(size.width >= 1 && size.height >= 1);
}

std::string l3d_screen_memory::do_describe() const {
    return "memory: depth 24, 32 bits per pixel, this machine's byte order";
}

std::unique_ptr<l3d_screen> l3d_screen_factory_memory::do_create(const l3d_screen_request& request,
                                                                 l3d_service& refusal) const {
    try {
        return std::make_unique<l3d_screen_memory>(request.size);
    } catch (const std::bad_alloc&) {
        refusal = {l3d_service::level::not_here, "not enough memory for a picture of " +
                                                     std::to_string(request.size.width) + "x" +
                                                     std::to_string(request.size.height)};
        return nullptr;
    }
}
