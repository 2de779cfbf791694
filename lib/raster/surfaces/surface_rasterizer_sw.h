// SPDX-License-Identifier: MIT
// l3d_surface_rasterizer_sw: the surface rasterizer on the CPU, by all its lanes and cores.
#ifndef L3D_RASTER_SURFACES_SURFACE_RASTERIZER_SW_H
#define L3D_RASTER_SURFACES_SURFACE_RASTERIZER_SW_H

#include "raster/surface_rasterizer.h"
#include "raster/parallel/workers.h"

#include <cstddef>
#include <memory>
#include <span>

namespace l3d_detail {
struct cut_triangle;
struct fill_band;
struct plane_cut;
} // namespace l3d_detail

/// The division of the work into bands. The picture does not depend on this division.
struct l3d_band_settings {
    int rows = 0; ///< rows of pixels in a band, a multiple of 8; 0: as many as fit the cache
    bool leave_out_hidden = true; ///< whether to leave out polygons that are surely hidden
};

/// Fills surfaces in horizontal bands whose colour and depth stay in a core's own cache. In each
/// band the nearest blocks are filled first, and hidden blocks are left out.
///
/// Units:   as l3d_surface_rasterizer_scalar, its slow twin.
/// Lives:   borrows the workers.
/// Cost:    a frame allocates only if it needs more memory for some purpose than any frame before.
///          In pictures at least 16 pixels wide, modes lambert, gouraud, flat and levels are filled
///          in SIMD lanes, all others pixel by pixel. Gouraud and flat cost least. Several lights
///          and highlights are done in lanes, too, except in flat shading; they take a fifth to a
///          third more.
class l3d_surface_rasterizer_sw final : public l3d_surface_rasterizer {
public:
    explicit l3d_surface_rasterizer_sw(l3d_workers& workers, l3d_band_settings settings = {});
    ~l3d_surface_rasterizer_sw() override;

    /// Starts a frame over a picture that was drawn in another way, such as by l3d_painter, from
    /// the same parts that draw will get. finish adds the shading's fog to the picture. With
    /// anti-aliasing, finish also draws pixels at edges again: each shows the mean light over its
    /// square. All other pixels stay as they are.
    /// Expects: the picture outlives the frame, and nobody else writes to it.
    void begin_over(l3d_pixels picture, const l3d_shading& shading);

    /// Fills the parts of triangles that cuts leave, after the surface parts of the same frame.
    /// Expects: a frame with a depth buffer, after draw; no anti-aliasing.
    void draw_cut(std::span<const l3d_detail::cut_triangle> triangles,
                  std::span<const l3d_detail::plane_cut> cuts);

private:
    void do_begin(l3d_pixels target, l3d_depth_buffer* depth, const l3d_shading& shading,
                  bool untouched) override;
    bool do_takes_levels() const override { return true; }
    bool do_draws_parts() const override { return true; }
    bool do_inspects() const override { return true; }
    bool do_antialiases() const override { return true; }
    void do_begin_part(l3d_pixels target, l3d_depth_buffer* depth, const l3d_shading& shading,
                       const l3d_pixel_box& part) override;
    void do_draw(std::span<const l3d_surface_part* const> parts) override;
    bool do_hidden(const l3d_subpixel_box& box, float nearest_inv_w) const override;
    void do_finish() override;
    const l3d_surface_counts& do_counts() const override { return counts_; }

    struct work_space;

    void begin_work();
    void fit_memory(l3d_size size);
    void draw_into_own(l3d_size size);
    void start(l3d_depth_buffer* depth, const l3d_shading& shading);
    void make_room_for_normals();
    void clear_words(const l3d_detail::fill_band& band);
    void draw_band(int index, std::size_t worker);
    void finish_band(int index, const l3d_detail::fill_band& band);
    void add_counts();
    bool is_over() const { return refined_.words != target_.words; }
    void color_band(const l3d_detail::fill_band& band) const;
    bool changes_words() const;
    void color_bands();
    l3d_detail::fill_band band_at(int index, std::size_t worker);
    void refine();

    l3d_workers& workers_;
    l3d_band_settings settings_;
    std::unique_ptr<work_space> work_;
    /// Number of pixels of the largest picture for which memory was allocated.
    std::int64_t largest_area_ = 0;
    l3d_pixels target_; ///< the pixels that are filled
    /// The picture that gets fog and smooth edges: the target, or the picture of begin_over.
    l3d_pixels refined_;
    l3d_pixel_box window_; ///< the drawn part of the target, in whole tiles
    /// The part that is copied from the work space to part_target_; may be empty.
    l3d_pixel_box part_;
    l3d_pixels part_target_;
    l3d_depth_buffer* depth_ = nullptr;
    int rows_ = 0;               ///< number of rows in a band
    std::size_t last_parts_ = 0; ///< number of parts in the last call of draw
    bool drawn_ = false; ///< whether this frame has drawn, so that picture and depth are cleared
    /// Whether the last frame is finished: tiles without drawing are empty in the picture.
    bool finished_ = false;
    bool untouched_ = false; ///< whether the target still holds the last frame, unchanged
    l3d_surface_counts counts_;
};

#endif
