// SPDX-License-Identifier: MIT
// band_painter: fills one band of a picture after the other, for one worker.
#ifndef L3D_RASTER_SURFACES_BAND_PAINTER_P_H
#define L3D_RASTER_SURFACES_BAND_PAINTER_P_H

#include "raster/surfaces/band_list_p.h"
#include "raster/surfaces/band_scalar_p.h"
#include "raster/surfaces/coarse_depth_p.h"
#include "raster/surfaces/fill_kernel_p.h"

#include <cstddef>
#include <span>

namespace l3d_detail {

/// The data that all bands of a frame share.
struct band_frame {
    l3d_shading shading;
    /// Whether the shading's mode and the picture's width allow the fill kernel.
    bool by_lanes = false;
    bool leaves_out_hidden = true; ///< whether items that coarse_depth finds hidden are left out
    fill_words words{};
    std::span<const l3d_material> materials{};
};

/// Draws the bands of one worker, with the worker's own memory and counts.
///
/// Shape: begins at a cache line, so that no two workers share a line.
class alignas(64) band_painter {
public:
    /// Makes room so that drawing bands of this many rows allocates nothing.
    void reserve(int rows) { scalar_.reserve(rows); }

    /// Makes as much room as another worker's painter needed, since chance decides which worker
    /// gets which band.
    void reserve_as(const band_painter& other);

    /// Draws items, given by their indices in the list, into the band in this order. Notes in
    /// `coarse` which tiles were drawn into.
    void draw(const band_frame& frame, const fill_band& band, const band_list& list,
              std::span<const std::uint32_t> items, coarse_depth& coarse);

    /// Draws the parts of triangles that cuts leave.
    void draw(const band_frame& frame, const fill_band& band,
              std::span<const cut_triangle> triangles, std::span<const plane_cut> cuts,
              coarse_depth& coarse);

    /// The counts of all drawing since the last call of this function.
    fill_counts take_counts();

private:
    /// Distances of prefetching, in items. An item's triangles are prefetched `items_waiting` items
    /// before it is drawn. Drawing these items takes some thousand cycles, and loading from memory
    /// takes fewer. The item itself is prefetched `items_ahead` items before.
    static constexpr std::size_t items_waiting = 2, items_ahead = 8;

    static bool is_hidden(const band_frame& frame, const fill_band& band, const band_item& item,
                          coarse_depth& coarse);
    void draw_item(const band_frame& frame, const fill_band& band, const band_list& list,
                   const band_item& item, coarse_depth& coarse);
    static void fetch(const band_item& item);
    void draw_triangles(const band_frame& frame, const fill_band& band, const band_item& item);
    void draw_cells(const band_frame& frame, const fill_band& band, const band_list& list,
                    const band_item& item);
    void draw_run(const band_frame& frame, const fill_band& band, const band_list& list,
                  const band_item& item, const grid_cells& cells);
    void draw_rest(const band_frame& frame, const fill_band& band);
    fill_target by_lanes(const band_frame& frame, const fill_band& band) {
        return {band,  frame.shading,           queue_,     by_lanes_,
                rest_, frame.leaves_out_hidden, frame.words};
    }

    band_scalar scalar_;
    fill_queue queue_;
    fill_rest rest_;
    fill_counts by_lanes_, by_scalar_;
};

} // namespace l3d_detail

#endif
