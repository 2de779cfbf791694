// SPDX-License-Identifier: MIT
// paint_batch: finds the places of named pixels, and the words of places.
#include "raster/shaders/paint_batch_p.h"

#include "raster/color/linear_light_p.h"

namespace l3d_detail {

const painted_part& paint_batch::part_of(std::uint32_t name) {
    const std::span<const painted_part> all = parts_->all;
    if (!part_ || name < part_->first || (part_ != &all.back() && name >= (part_ + 1)->first))
        part_ = &*(std::ranges::upper_bound(all, name, {}, &painted_part::first) - 1);
    return *part_;
}

std::size_t paint_batch::add_part(const named_pixels& from, std::size_t begin) {
    const painted_part& part = part_of(from.names[begin]);
    const part_run run = find_quad_places(part, parts_->parameters.data(), from, begin, pixels_);
    if (run.has_triangles) {
        const auto quads = static_cast<std::uint32_t>(painted_part::quads(*part.part));
        for (std::size_t i = begin; i < run.end; ++i)
            if (const std::uint32_t index = from.names[i] - part.first;
                from.names[i] != no_name && index >= quads)
                find_triangle_place(part, index - quads, from.x + static_cast<double>(i), from.y, i,
                                    pixels_);
    }
    // The light is set after add(), whose finish() also changes lanes after its last pixel.
    add(part.texture, {begin, run.end});
    const linear_light& tables = linear_light_tables();
    for (std::size_t c = 0; c < pixels_.light.size(); ++c)
        std::fill(pixels_.light[c].begin() + static_cast<std::ptrdiff_t>(begin),
                  pixels_.light[c].begin() + static_cast<std::ptrdiff_t>(run.end),
                  tables.light(materials_[part.material].color >> (16 - 8 * c) & 255));
    return run.end;
}

/// Adds a range to the pixels that wait to be painted. All waiting pixels form one range; pixels of
/// this range that were not added show nothing.
void paint_batch::add(const l3d_texture* texture, const pixel_range& range) {
    if (texture != texture_)
        finish();
    if (waiting_.begin == waiting_.end)
        waiting_.begin = range.begin;
    waiting_.end = range.end;
    texture_ = texture;
}

void paint_batch::finish() {
    if (waiting_.begin == waiting_.end)
        return;
    if (texture_)
        light_by_texture(texture_->view(), filter_, waiting_, pixels_);
    encode_light(waiting_, pixels_);
    waiting_ = {};
}

} // namespace l3d_detail
