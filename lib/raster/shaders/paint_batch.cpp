// SPDX-License-Identifier: MIT
// paint_batch: from names to quads, and from quads to words.
#include "raster/shaders/paint_batch_p.h"

#include "raster/color/linear_light_p.h"

#include <algorithm>

namespace l3d_detail {

const painted_part& paint_batch::part_of(std::uint32_t name) {
    const std::span<const painted_part> all = parts_->all;
    if (!part_ || name < part_->first || (part_ != &all.back() && name >= (part_ + 1)->first))
        part_ = &*(std::ranges::upper_bound(all, name, {}, &painted_part::first) - 1);
    return *part_;
}

/// Each name has one slot, by its hash. Waiting pixels are coloured before another name takes their
/// slot.
std::size_t paint_batch::slot_of(std::uint32_t name) {
    constexpr std::uint32_t golden = 0x9e3779b1; // spreads neighbours, by Knuth's golden ratio
    const std::size_t slot = name * golden >> (32 - 6);
    static_assert(kept == std::size_t{1} << 6);
    if (names_[slot] == name)
        return slot;
    if (awaited_ >> slot & 1)
        finish();
    names_[slot] = name;
    const painted_part& part = part_of(name);
    textures_[slot] = part.texture;
    placed_quad& quad = quads_[slot];
    quad.set(part, name);
    const linear_light& tables = linear_light_tables();
    for (std::size_t c = 0; c < 3; ++c)
        quad.of[placed_quad::red + c] =
            tables.light(materials_[part.material].color >> (16 - 8 * c) & 255);
    return slot;
}

std::size_t paint_batch::wait(const look& like, std::size_t count, std::uint32_t* colors) {
    if (pixels_.count + count > painted_pixels::room || like != look_)
        finish();
    look_ = like;
    const std::size_t begin = pixels_.count;
    pixels_.count += count;
    for (std::size_t i = 0; i < count; ++i)
        targets_[begin + i] = colors + i;
    return begin;
}

void paint_batch::add(std::uint32_t name, double x, double y, std::size_t count,
                      std::uint32_t* colors) {
    const std::size_t slot = slot_of(name);
    const std::size_t begin = wait({textures_[slot], true}, count, colors);
    awaited_ |= std::uint64_t{1} << slot;
    const auto first = static_cast<std::int32_t>(slot * placed_quad::stride);
    const auto left = static_cast<float>(x), row = static_cast<float>(y);
    for (std::size_t i = 0; i < count; ++i) {
        places_.first[begin + i] = first;
        places_.x[begin + i] = left + static_cast<float>(i);
        places_.y[begin + i] = row;
    }
}

void paint_batch::finish() {
    if (pixels_.count == 0)
        return;
    if (look_.is_of_quads)
        find_quad_places(quads_.data(), places_, pixels_);
    if (look_.texture)
        light_by_texture(look_.texture->view(), filter_, pixels_);
    encode_light(pixels_);
    for (std::size_t i = 0; i < pixels_.count; ++i)
        *targets_[i] = pixels_.words[i];
    pixels_.count = 0;
    awaited_ = 0;
}

} // namespace l3d_detail
