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

/// Gathers runs of pixels of painted parts, and colours them some at a time in lanes.
///
/// Cost:  keeps the last quads, which pixels in the next rows mostly need again.
/// Lives: borrows parts and materials; belongs to one worker.
class paint_batch {
public:
    paint_batch(const painted_parts* parts, l3d_texture_filter filter,
                std::span<const l3d_material> materials)
        : parts_(parts), filter_(filter), materials_(materials) {
        names_.fill(no_name);
    }
    /// Makes a batch with the same parts, which has no quads yet.
    /// Expects: no pixels wait in `other`.
    paint_batch(const paint_batch& other)
        : paint_batch(other.parts_, other.filter_, other.materials_) {}
    paint_batch& operator=(const paint_batch&) = delete;

    /// Whether a number of material ("name") belongs to a part of a patch.
    bool has(std::uint32_t name) const { return parts_ && parts_->has(name); }

    /// The index of a name's material among those of the frame. Expects: has(name).
    std::uint32_t material(std::uint32_t name) { return part_of(name).material; }

    /// Adds consecutive pixels of a row that see one polygon of a part. Their colours are written
    /// by finish().
    /// Units: pixels; x is the first pixel's place.
    /// Shape: `count` colours.
    /// Expects: has(name); count at most painted_pixels::room.
    void add(std::uint32_t name, double x, double y, std::size_t count, std::uint32_t* colors);

    /// Adds pixels of a row that see this texture, or none if it is null. The caller sets their
    /// places and their light in pixels(). Their colours are written by finish().
    /// Shape: `count` colours. Returns the index of the first pixel.
    /// Expects: count at most painted_pixels::room.
    std::size_t add(const l3d_texture* texture, std::size_t count, std::uint32_t* colors) {
        return wait({texture, false}, count, colors);
    }
    painted_pixels& pixels() { return pixels_; }

    /// Colours the pixels that still wait.
    void finish();

private:
    /// The properties that all waiting pixels share.
    struct look {
        const l3d_texture* texture = nullptr;
        bool is_of_quads = false; ///< whether places and light must still be found from quads
        bool operator==(const look&) const = default;
    };

    static constexpr std::uint32_t no_name = ~std::uint32_t{0};
    static constexpr std::size_t kept = 64; ///< limit of quads, as many as pixels that wait
    static_assert(kept == painted_pixels::room);

    const painted_part& part_of(std::uint32_t name);
    std::size_t slot_of(std::uint32_t name);
    std::size_t wait(const look& like, std::size_t count, std::uint32_t* colors);

    const painted_parts* parts_;
    l3d_texture_filter filter_;
    std::span<const l3d_material> materials_;
    const painted_part* part_ = nullptr; ///< the part that was used last
    look look_;
    std::array<std::uint32_t, kept> names_; ///< the names of the kept quads
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
