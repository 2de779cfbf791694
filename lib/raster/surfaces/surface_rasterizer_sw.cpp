// SPDX-License-Identifier: MIT
// l3d_surface_rasterizer_sw: divides the picture into bands, which workers fill.
#include "raster/surfaces/surface_rasterizer_sw.h"

#include "raster/refine/picture_refiner_p.h"
#include "raster/surfaces/band_painter_p.h"
#include "raster/shaders/face_painter_p.h"
#include "raster/shaders/fog_words_p.h"
#include "raster/shaders/lit_words_p.h"
#include "raster/shaders/material_words_p.h"
#include "tool_2d/image.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <numeric>
#include <vector>

namespace {

using namespace l3d_detail;

/// The number of rows in a band. A dozen bands let the workers share a picture. Colour and depth of
/// a band take no more than half a megabyte. This is all or half of the second-level cache of a
/// processor of 2020. The number of workers has no influence, as counts of what is drawn depend on
/// the bands.
int rows_of_band(l3d_size size, bool with_normals) {
    constexpr int most_bytes = 512 << 10, bands_wanted = 12;
    const int bytes_of_pixel = 4 + 4 + (with_normals ? 4 : 0);
    constexpr int tile = depth_tile::height;
    const int fitting = most_bytes / bytes_of_pixel / std::max(size.width, 1) / tile * tile;
    const int sharing = (size.height + bands_wanted * tile - 1) / (bands_wanted * tile) * tile;
    return std::max(std::min(fitting, sharing), tile);
}

/// The second words of a picture's normals (normal_code), in rows like depths.
using normal_plane = std::vector<std::uint32_t, line_allocator<std::uint32_t>>;

/// Whether lanes can light pixels of these materials. In mode `flat` a polygon has one normal,
/// which lanes do not make.
bool lanes_take_lights(const l3d_shading& shading, std::span<const l3d_material> materials) {
    if (shading.paints && shading.paints->parts)
        return false; // each of their quads has a name, and their number is unknown yet
    const std::size_t names = shading.paints ? shading.paints->end() : materials.size();
    return shading.mode != l3d_shade::flat && names <= fill_words::most_lit_materials;
}

/// A box, grown to the borders of tiles and cut to the picture.
l3d_pixel_box in_whole_tiles(const l3d_pixel_box& box, l3d_size size) {
    constexpr std::int32_t width = depth_tile::width, height = depth_tile::height;
    return l3d_pixel_box{box.left / width * width, box.top / height * height,
                         (box.right + width - 1) / width * width,
                         (box.bottom + height - 1) / height * height}
        .intersected(l3d_whole(size));
}

} // namespace

struct l3d_surface_rasterizer_sw::work_space {
    band_frame frame;
    band_list list;
    coarse_depth coarse;
    material_words materials;
    lit_words lights;
    /// The second words of normals: a plane of a band for each worker, or one plane of the whole
    /// picture.
    std::vector<normal_plane> normals;
    std::vector<band_painter> painters; ///< a painter for each worker
    /// Depths of a band for each worker, if nobody wants depths after the frame.
    std::vector<l3d_depth_buffer> worker_depths;
    l3d_depth_buffer kept_depth; ///< depths of the picture, if only anti-aliasing needs them
    /// The number of covered pixels in each band, if they are counted.
    std::vector<std::int64_t> covered;
    /// Gets the words of begin_part and begin_over, which are not drawn into the target itself.
    l3d_image picture;
    /// The parts of all calls of draw, for anti-aliasing.
    std::vector<const l3d_surface_part*> parts;
    picture_refiner refiner;
};

l3d_surface_rasterizer_sw::l3d_surface_rasterizer_sw(l3d_workers& workers,
                                                     l3d_band_settings settings)
    : workers_(workers), settings_(settings) {
    assert(settings.rows >= 0 && settings.rows % depth_tile::height == 0);
    begin_work();
}

void l3d_surface_rasterizer_sw::begin_work() {
    work_ = std::make_unique<work_space>();
    work_->painters.resize(static_cast<std::size_t>(workers_.count()));
    work_->worker_depths.resize(static_cast<std::size_t>(workers_.count()));
}

/// Gives the frame's memory back if it was made for more than four times the picture's area.
void l3d_surface_rasterizer_sw::fit_memory(l3d_size size) {
    const std::int64_t area = l3d_whole(size).area();
    if (4 * area < largest_area_) {
        begin_work();
        finished_ = false;
        largest_area_ = area;
    }
    largest_area_ = std::max(largest_area_, area);
}

l3d_surface_rasterizer_sw::~l3d_surface_rasterizer_sw() = default;

void l3d_surface_rasterizer_sw::do_begin(l3d_pixels target, l3d_depth_buffer* depth,
                                         const l3d_shading& shading, bool untouched) {
    assert(!depth || target.size() == depth->size());
    fit_memory(target.size());
    untouched_ = untouched && finished_ && target.words == target_.words &&
                 target.size() == target_.size() && target.stride == target_.stride &&
                 shading.background == work_->frame.shading.background;
    target_ = refined_ = target;
    window_ = l3d_whole(target.size());
    part_ = {};
    start(depth, shading);
}

/// Begins a frame that only smooths the edges of a finished picture. Filling finds the depths that
/// smoothing needs. The words of filling go to another picture and are not used.
void l3d_surface_rasterizer_sw::begin_over(l3d_pixels picture, const l3d_shading& shading) {
    begin_frame(shading);
    draw_into_own(picture.size());
    refined_ = picture;
    window_ = l3d_whole(picture.size());
    part_ = {};
    start(nullptr, shading);
}

void l3d_surface_rasterizer_sw::draw_into_own(l3d_size size) {
    l3d_image& picture = work_->picture;
    if (picture.pixels().size() != size)
        picture = l3d_image(size, l3d_padded_stride(size.width));
    untouched_ = false;
    target_ = refined_ = picture.pixels();
}

/// Draws whole polygons into a picture of the rasterizer's own, so that no number of a polygon
/// depends on where the part ends. Only the part's pixels are copied to the target.
void l3d_surface_rasterizer_sw::do_begin_part(l3d_pixels target, l3d_depth_buffer* depth,
                                              const l3d_shading& shading,
                                              const l3d_pixel_box& part) {
    assert(!depth || target.size() == depth->size());
    assert(!part.empty() && part.intersected(l3d_whole(target.size())) == part);
    draw_into_own(target.size());
    window_ = in_whole_tiles(part.grown(shading.reach()).intersected(l3d_whole(target.size())),
                             target.size());
    part_ = part;
    part_target_ = target;
    start(depth, shading);
}

void l3d_surface_rasterizer_sw::start(l3d_depth_buffer* depth, const l3d_shading& shading) {
    finished_ = false;
    depth_ = depth;
    if (!depth && (shading.antialias || is_over())) {
        work_->kept_depth.resize(target_.size());
        depth_ = &work_->kept_depth;
    }
    const l3d_size size{target_.width, window_.bottom - window_.top};
    const bool is_lit = shading.is_lit(materials());
    const bool by_lanes = fill_shades(shading.mode) && target_.width >= fill_least_width &&
                          (!is_lit || lanes_take_lights(shading, materials()));
    const bool with_normals = is_lit && by_lanes;
    rows_ = settings_.rows ? settings_.rows : rows_of_band(size, with_normals);
    drawn_ = false;
    counts_ = {};
    work_->parts.clear();
    work_->materials.begin(is_lit ? std::span<const l3d_material>() : materials());
    work_->frame = {shading, by_lanes, settings_.leave_out_hidden,
                    fill_words{with_normals || work_->materials.wanted(), with_normals},
                    materials()};
    if (with_normals)
        work_->lights.begin(work_->frame.shading, materials());
    work_->coarse.resize(target_.size());
    const int bands = (size.height + rows_ - 1) / rows_;
    work_->covered.assign(static_cast<std::size_t>(bands), 0);
    if (!depth_)
        for (l3d_depth_buffer& worker_depth : work_->worker_depths)
            worker_depth.resize({target_.width, rows_});
    if (with_normals)
        make_room_for_normals();
}

/// Makes room for the second words of normals, for as many pixels as there are depths.
void l3d_surface_rasterizer_sw::make_room_for_normals() {
    const l3d_depth_buffer& like = depth_ ? *depth_ : work_->worker_depths.front();
    const auto size =
        static_cast<std::size_t>(like.pitch()) * static_cast<std::size_t>(like.size().height);
    work_->normals.resize(depth_ ? 1 : work_->worker_depths.size());
    for (normal_plane& normals : work_->normals)
        if (normals.size() < size)
            normals.resize(size);
}

void l3d_surface_rasterizer_sw::do_draw(std::span<const l3d_surface_part* const> parts) {
    assert(depth_ || !drawn_);
    const band_list& list = work_->list;
    const band_frame& frame = work_->frame;
    const bool with_levels =
        frame.by_lanes && !frame.words.has_normals && frame.shading.mode == l3d_shade::gouraud;
    const bool antialias = frame.shading.antialias;
    work_->list.make(parts, {window_, rows_, antialias}, with_levels ? &frame.shading : nullptr,
                     workers_);
    if (antialias)
        work_->parts.insert(work_->parts.end(), parts.begin(), parts.end());
    last_parts_ = parts.size();

    for (band_painter& painter : work_->painters)
        painter.reserve(rows_);
    workers_.for_each_beside(static_cast<int>(work_->covered.size()), [&](int band, int worker) {
        draw_band(band, static_cast<std::size_t>(worker));
    });

    drawn_ = true;
    counts_.quads += list.polygons();
    add_counts();
}

void l3d_surface_rasterizer_sw::draw_cut(std::span<const cut_triangle> triangles,
                                         std::span<const plane_cut> cuts) {
    assert(depth_ && drawn_ && !work_->frame.shading.antialias);
    workers_.for_each_beside(static_cast<int>(work_->covered.size()), [&](int index, int worker) {
        const auto own = static_cast<std::size_t>(worker);
        const fill_band band = band_at(index, own);
        work_->painters[own].draw(work_->frame, band, triangles, cuts, work_->coarse);
        finish_band(index, band);
    });
    counts_.quads += static_cast<std::int64_t>(triangles.size());
    add_counts();
}

void l3d_surface_rasterizer_sw::add_counts() {
    for (band_painter& painter : work_->painters) {
        for (const band_painter& other : work_->painters)
            painter.reserve_as(other);
        const fill_counts counts = painter.take_counts();
        counts_.samples += counts.samples;
        counts_.written += counts.written;
        counts_.by_plane += counts.by_plane;
        counts_.level_error = std::max(counts_.level_error, double{counts.level_error});
        counts_.normal_error = std::max(counts_.normal_error, double{counts.normal_error});
        counts_.unproven_levels += counts.unproven_levels;
        counts_.unsolved += counts.unsolved;
    }
}

void l3d_surface_rasterizer_sw::draw_band(int index, std::size_t worker) {
    const std::span<const std::uint32_t> items = work_->list.items(index);
    if (drawn_ && items.empty())
        return;
    const fill_band band = band_at(index, worker);
    coarse_depth& coarse = work_->coarse;
    if (!drawn_) {
        clear_words(band);
        coarse.forget(band.top, band.bottom);
    }
    work_->painters[worker].draw(work_->frame, band, work_->list, items, coarse);
    finish_band(index, band);
}

void l3d_surface_rasterizer_sw::finish_band(int index, const fill_band& band) {
    coarse_depth& coarse = work_->coarse;
    const bool wanted = depth_ && depth_ != &work_->kept_depth;
    if (!drawn_ && wanted && part_.empty() && leaves_depth())
        coarse.open_others(band);
    if (wanted)
        coarse.refresh(band); // several threads may ask `hidden`, so it updates nothing itself
    if (counts_pixels())
        work_->covered[static_cast<std::size_t>(index)] = coarse.covered(band);
    if (!depth_ && changes_words())
        color_band(band); // nothing else will be drawn, and the band is in the cache
}

/// The memory of a band. Depths and normals are in the worker's own memory, unless those of the
/// whole picture are kept.
fill_band l3d_surface_rasterizer_sw::band_at(int index, std::size_t worker) {
    const int top = window_.top + index * rows_, bottom = std::min(top + rows_, window_.bottom);
    l3d_depth_buffer& depth = depth_ ? *depth_ : work_->worker_depths[worker];
    const std::ptrdiff_t first = depth_ ? top * depth.pitch() : 0;
    std::uint32_t* const normals = work_->frame.words.has_normals
                                       ? work_->normals[depth_ ? 0 : worker].data() + first
                                       : nullptr;
    return {target_.row(top).data(),
            target_.stride,
            depth.data() + first,
            depth.pitch(),
            target_.width,
            top,
            bottom,
            normals};
}

/// Whether filled words still have to be coloured, or to get fog, before the picture is shown.
bool l3d_surface_rasterizer_sw::changes_words() const {
    return (work_->frame.words.has_materials && !is_over()) || work_->frame.shading.fog.is_on();
}

/// Gives a band's words their colours and their fog. Only tiles into which something was drawn have
/// defined depths. Pixels that were drawn in another way have their colours already.
void l3d_surface_rasterizer_sw::color_band(const fill_band& band) const {
    const l3d_shading& shading = work_->frame.shading;
    work_->coarse.visit_drawn(band, [&](const l3d_pixel_box& box) {
        const std::ptrdiff_t row = box.top - band.top;
        std::uint32_t* const words = refined_.row(box.top).data() + box.left;
        const std::ptrdiff_t at = row * band.depth_pitch + box.left;
        const std::int32_t width = box.right - box.left, height = box.bottom - box.top;
        const l3d_face_paints* const paints = shading.paints;
        const std::span<const l3d_material> materials = work_->frame.materials;
        if (band.normals && !is_over()) {
            const lit_pixels lit{words,
                                 refined_.stride,
                                 band.depths + at,
                                 band.normals + at,
                                 band.depth_pitch,
                                 box.left,
                                 box.top,
                                 width,
                                 height};
            if (paints) {
                face_painter painter(*paints, materials);
                light_painted(work_->lights, lit, painter);
            } else {
                work_->lights.color(lit);
            }
        }
        const material_pixels pixels{words, refined_.stride, band.depths + at, band.depth_pitch,
                                     width, height};
        const bool has_materials = work_->materials.wanted() && !is_over();
        if (has_materials && paints) {
            face_painter painter(*paints, materials);
            paint_words(pixels, box.left, box.top, painter);
        } else if (has_materials) {
            work_->materials.color(pixels);
        }
        if (shading.fog.is_on())
            put_fog(shading, pixels, box.top, target_.height);
    });
}

void l3d_surface_rasterizer_sw::color_bands() {
    workers_.for_each_beside(static_cast<int>(work_->covered.size()),
                             [&](int band, int) { color_band(band_at(band, 0)); });
}

void l3d_surface_rasterizer_sw::clear_words(const fill_band& band) {
    const l3d_background& background = work_->frame.shading.background;
    if (untouched_)
        return work_->coarse.clear_words(band, background, target_.height);
    background.fill(target_, {window_.left, band.top, window_.right, band.bottom});
}

bool l3d_surface_rasterizer_sw::do_hidden(const l3d_subpixel_box& box, float nearest_inv_w) const {
    const bool squares = work_->frame.shading.antialias;
    const l3d_pixel_box pixels = band_list::frame{window_, rows_, squares}.pixels(box);
    return drawn_ && !finished_ && (pixels.empty() || work_->coarse.hidden(pixels, nearest_inv_w));
}

void l3d_surface_rasterizer_sw::do_finish() {
    if (!drawn_)
        do_draw({});
    if (depth_ && changes_words())
        color_bands();
    if (work_->frame.shading.antialias)
        refine();
    for (int row = part_.top; row < part_.bottom; ++row)
        std::copy_n(target_.row(row).data() + part_.left, part_.right - part_.left,
                    part_target_.row(row).data() + part_.left);
    finished_ = true;
    counts_.covered =
        counts_pixels() ? std::reduce(work_->covered.begin(), work_->covered.end(), std::int64_t{0})
                        : l3d_surface_counts::none_counted;
}

/// Smooths the edges. If several calls have drawn parts, all parts are listed once more, as if one
/// call had drawn them.
void l3d_surface_rasterizer_sw::refine() {
    band_list& list = work_->list;
    if (work_->parts.size() > last_parts_)
        list.make(work_->parts, {window_, rows_, true}, nullptr, workers_);
    counts_.refined = work_->refiner.refine({.target = refined_,
                                             .depth = *depth_,
                                             .shading = work_->frame.shading,
                                             .materials = work_->frame.materials,
                                             .colors = work_->materials.colors(),
                                             .list = list,
                                             .coarse = work_->coarse,
                                             .window = window_,
                                             .rows = rows_},
                                            workers_);
}
