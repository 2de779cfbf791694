// SPDX-License-Identifier: MIT
// l3d_screen_memory: keeps its own or borrowed pixels, and converts them when they are shown.
#include "tool_2d/screen_memory.h"

#include "tool_2d/pixel_writer_p.h"

#include <new>

l3d_screen_memory::l3d_screen_memory(l3d_size size)
    : image_(size, l3d_padded_stride(size.width)), words_(image_.pixels()) {
    assert(size.width >= 1 && size.height >= 1);
}

l3d_screen_memory::l3d_screen_memory(const l3d_pixels& words) : words_(words) {
    assert(words.width >= 1 && words.height >= 1 && words.stride >= words.width);
}

l3d_screen_memory::l3d_screen_memory(const l3d_packed_pixels& packed)
    : image_(packed.size, l3d_padded_stride(packed.size.width)), words_(image_.pixels()),
      packed_(packed), info_(packed.layout),
      writer_(std::make_unique<l3d_detail::pixel_writer>(info_)) {
    assert(packed.size.width >= 1 && packed.size.height >= 1);
}

l3d_screen_memory::~l3d_screen_memory() = default;

void l3d_screen_memory::do_show(const l3d_pixel_box& part) {
    if (writer_)
        writer_->write(words_, l3d_detail::pixel_writer::writable_part(part, words_.size()),
                       packed_.size, packed_.bytes, packed_.pitch);
}

std::string l3d_screen_memory::do_describe() const {
    return "memory: " + info_.layout().describe();
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
