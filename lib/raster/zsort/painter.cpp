// SPDX-License-Identifier: MIT
// l3d_painter: turns places in an order into depths.
#include "raster/zsort/painter.h"

#include "raster/lines/line_cover_p.h"
#include "raster/parallel/chunks_p.h"
#include "raster/shapes/piece_pixels_p.h"

#include <bit>
#include <cstddef>

namespace {

using namespace l3d_detail;

/// Turns a piece's place in the order into a depth, a positive float from 1/2 on. Later places get
/// larger depths. Floats are ordered like their bits.
float depth_of_place(std::size_t place) {
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(0.5F) +
                                static_cast<std::uint32_t>(place));
}

std::array<l3d_micro_vertex, 3> at_place(std::array<l3d_micro_vertex, 3> v, std::size_t place) {
    for (l3d_micro_vertex& corner : v)
        corner.inv_w = depth_of_place(place);
    return v;
}

} // namespace

/// Puts the triangles that no cut divides into parts, the topmost triangles first. So the
/// rasterizer can leave out items that these hide.
void l3d_painter::make_parts(std::span<const l3d_painter_triangle> triangles,
                             std::span<const l3d_painter_piece> pieces, bool with_materials) {
    constexpr std::size_t in_part = 1024; // some 10^4 cycles of work, and 72 KB
    if (const std::size_t wanted = chunks_of(pieces.size(), in_part); parts_.size() < wanted)
        parts_.resize(wanted);
    drawn_.clear();
    for (std::size_t i = 0; i < chunks_of(pieces.size(), in_part); ++i)
        drawn_.push_back(&parts_[i]);
    for_each_chunk(workers_, pieces.size(), in_part,
                   [&](std::size_t begin, std::size_t end, std::size_t number) {
                       l3d_micro_triangles& to = parts_[number].triangles;
                       to.clear();
                       for (std::size_t i = begin; i < end; ++i) {
                           const std::size_t place = pieces.size() - 1 - i;
                           if (pieces[place].cut != l3d_painter_cut::last)
                               continue;
                           const l3d_painter_triangle& of = triangles[pieces[place].triangle];
                           const auto [a, b, c] = at_place(of.v, place);
                           if (with_materials)
                               to.add(a, b, c, of.material);
                           else
                               to.add(a, b, c);
                       }
                   });
}

void l3d_painter::make_cut(std::span<const l3d_painter_triangle> triangles,
                           std::span<const l3d_painter_piece> pieces,
                           std::span<const l3d_painter_cut> cuts) {
    cut_.clear();
    plane_cuts_.clear();
    for (std::size_t place = 0; place < pieces.size(); ++place) {
        if (pieces[place].cut == l3d_painter_cut::last)
            continue;
        const l3d_painter_triangle& of = triangles[pieces[place].triangle];
        const std::size_t begin = plane_cuts_.size();
        add_cuts(pieces[place], triangles, cuts, plane_cuts_);
        cut_.push_back({at_place(of.v, place), of.material, begin, plane_cuts_.size()});
    }
}

void l3d_painter::paint(l3d_pixels target, const l3d_shading& shading,
                        std::span<const l3d_material> materials,
                        std::span<const l3d_painter_triangle> triangles,
                        std::span<const l3d_painter_piece> pieces,
                        std::span<const l3d_painter_cut> cuts) {
    make_parts(triangles, pieces, !materials.empty() || shading.paints != nullptr);
    make_cut(triangles, pieces, cuts);
    if (!cut_.empty())
        places_.resize(target.size());
    l3d_shading without_depth = shading;
    without_depth.antialias = false;
    without_depth.fog = {};
    filler_.count_pixels(false);
    filler_.use_materials(materials);
    filler_.begin(target, cut_.empty() ? nullptr : &places_, without_depth);
    filler_.draw(drawn_);
    if (!cut_.empty())
        filler_.draw_cut(cut_, plane_cuts_);
    filler_.finish();
}

void l3d_painter::paint_lines(l3d_pixels target, const l3d_shading& shading,
                              std::span<const l3d_painter_triangle> triangles,
                              std::span<const l3d_painter_piece> pieces,
                              std::span<const l3d_painter_cut> cuts, const l3d_line_look& look) {
    make_parts(triangles, pieces, false);
    make_cut(triangles, pieces, cuts);
    places_.resize(target.size());
    filler_.begin(target, &places_, {.mode = l3d_shade::flat});
    filler_.draw(drawn_);
    filler_.draw_cut(cut_, plane_cuts_);
    filler_.finish();
    l3d_background().fill(target);
    line_depths_.resize(shading.fog.is_on() ? target.size() : l3d_size{});
    std::vector<plane_cut>& own_cuts = plane_cuts_;
    for (std::size_t place = 0; place < pieces.size(); ++place) {
        own_cuts.clear();
        add_cuts(pieces[place], triangles, cuts, own_cuts);
        visit_sides(triangles[pieces[place].triangle], own_cuts, target.size(), look.smooth,
                    [&](int x, int y, int coverage, double inv_w) {
                        const auto column = static_cast<std::size_t>(x);
                        const float on_top = places_.row(y)[column], own = depth_of_place(place);
                        std::uint32_t& word = target.row(y)[column];
                        if (own < on_top)
                            return;
                        if (shading.fog.is_on())
                            cover_pixel(word, line_depths_.row(y)[column], coverage, inv_w);
                        else
                            cover_pixel(word, coverage);
                    });
    }
    color_cover(target, {0, target.height}, shading, look.color, line_depths_);
}
