// SPDX-License-Identifier: MIT
// paint_batch: pixels of a row whose textures are looked up together.
#ifndef L3D_RASTER_SHADERS_PAINT_BATCH_P_H
#define L3D_RASTER_SHADERS_PAINT_BATCH_P_H

#include "geom/material.h"
#include "raster/textures/painted_part_p.h"
#include "raster/textures/quad_places_p.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// Gathers runs of pixels of painted parts, and colours many of the pixels at a time, in lanes.
///
/// Cost:  keeps the quads that it set up last, as pixels in the next rows mostly need these again.
/// Lives: borrows parts and materials; each batch belongs to one worker.
class paint_batch {
public:
    paint_batch(const painted_parts* parts, l3d_texture_filter filter,
                std::span<const l3d_material> materials)
        : parts_(parts), filter_(filter), materials_(materials) {}

    /// Whether a number of material ("name") belongs to a part of a patch.
    bool has(std::uint32_t name) const { return parts_ && parts_->has(name); }

    /// The index of a name's material among the frame's materials. Expects: has(name).
    std::uint32_t material(std::uint32_t name) { return part_of(name).material; }

    /// Takes pixels from `begin` on, as long as they show the first pixel's part or nothing.
    /// Returns the index behind the last pixel taken.
    /// Expects: has() is true for the first pixel's name.
    std::size_t add_part(const named_pixels& from, std::size_t begin);

    /// Takes pixels whose places and light the caller sets in pixels(). The pixels show this
    /// texture, or none if it is null.
    void add(const l3d_texture* texture, const pixel_range& range);
    painted_pixels& pixels() { return pixels_; }

    /// Takes pixels that get this colour, 0x00RRGGBB.
    void add_color(std::uint32_t color, const pixel_range& range) {
        finish();
        std::fill(pixels_.words.begin() + static_cast<std::ptrdiff_t>(range.begin),
                  pixels_.words.begin() + static_cast<std::ptrdiff_t>(range.end), color);
    }

    /// Colours the pixels that still wait to be coloured together. Afterwards, words() has the
    /// colours of all pixels that were taken.
    void finish();
    const std::uint32_t* words() const { return pixels_.words.data(); }

private:
    const painted_part& part_of(std::uint32_t name);

    const painted_parts* parts_;
    l3d_texture_filter filter_;
    std::span<const l3d_material> materials_;
    const painted_part* part_ = nullptr;   ///< the part whose name was asked for last
    const l3d_texture* texture_ = nullptr; ///< the texture of the pixels that wait
    pixel_range waiting_;
    painted_pixels pixels_{};
};

} // namespace l3d_detail

#endif
