// SPDX-License-Identifier: MIT
// paint_batch: pixels whose textures are looked up together.
#ifndef L3D_RASTER_SHADERS_PAINT_BATCH_P_H
#define L3D_RASTER_SHADERS_PAINT_BATCH_P_H

#include "geom/material.h"
#include "raster/textures/painted_part_p.h"
#include "raster/textures/quad_places_p.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// Takes runs of pixels, and colours them some at a time in lanes.
///
/// Cost: keeps the last quads, since rows of pixels come back to them.
/// Lives: borrows parts and materials; of one worker.
class paint_batch {
public:
    paint_batch(const painted_parts* parts, l3d_texture_filter filter,
                std::span<const l3d_material> materials)
        : parts_(parts), filter_(filter), materials_(materials) {
        names_.fill(no_name);
    }
    /// A copy looks up the same, and knows no quads yet. Expects: nothing waits.
    paint_batch(const paint_batch& other)
        : paint_batch(other.parts_, other.filter_, other.materials_) {}
    paint_batch& operator=(const paint_batch&) = delete;

    /// Whether a name is of a part of a patch.
    bool has(std::uint32_t name) const { return parts_ && parts_->has(name); }

    /// The place of a name's material among those of the frame. Expects: has(name).
    std::uint32_t material(std::uint32_t name) { return part_of(name).material; }

    /// Colours pixels of a row by what they see of one polygon of a part, until finish().
    /// Units: pixels; x is the first one's place, and the others follow by 1.
    /// Shape: `count` colours. Expects: has(name); count at most painted_pixels::room.
    void add(std::uint32_t name, double x, double y, std::size_t count, std::uint32_t* colors);

    /// Colours pixels of a row by the places and the light that the caller sets in pixels(), until
    /// finish(). They see this texture, or none if it is null.
    /// Shape: `count` colours. Returns the index of the first pixel.
    /// Expects: count at most painted_pixels::room.
    std::size_t add(const l3d_texture* texture, std::size_t count, std::uint32_t* colors) {
        return wait({texture, false}, count, colors);
    }
    painted_pixels& pixels() { return pixels_; }

    /// Colours what still waits.
    void finish();

private:
    /// The things that all pixels that wait have in common.
    struct look {
        const l3d_texture* texture = nullptr;
        bool is_of_quads = false; ///< places and light are not known yet
        bool operator==(const look&) const = default;
    };

    static constexpr std::uint32_t no_name = ~std::uint32_t{0};
    static constexpr std::size_t kept = 64; ///< quads, as many as pixels wait
    static_assert(kept == painted_pixels::room);

    const painted_part& part_of(std::uint32_t name);
    std::size_t slot_of(std::uint32_t name);
    std::size_t wait(const look& like, std::size_t count, std::uint32_t* colors);

    const painted_parts* parts_;
    l3d_texture_filter filter_;
    std::span<const l3d_material> materials_;
    const painted_part* part_ = nullptr; ///< the last one
    look look_;
    std::array<std::uint32_t, kept> names_; ///< names of the quads that are kept
    std::array<const l3d_texture*, kept> textures_;
    std::uint64_t awaited_ = 0; ///< a bit for each quad that a waiting pixel sees
    std::array<std::uint32_t*, painted_pixels::room> targets_;
    // Lanes also take what is behind the last pixel: at first zeros, and later what was there.
    std::array<placed_quad, kept> quads_{};
    quad_pixels places_{};
    painted_pixels pixels_{};
};

} // namespace l3d_detail

#endif
