// SPDX-License-Identifier: MIT
// painter_cover: sets and tests a bit for each pixel, row by row.
#include "pipeline/zsort/painter_cover_p.h"

namespace l3d_detail {

void painter_cover::begin(l3d_size size, std::span<const l3d_painter_triangle> triangles,
                          const std::vector<l3d_painter_cut>& cuts) {
    triangles_ = triangles;
    cuts_ = &cuts;
    pixels_.begin(size);
    scan_.set_rows({0, size.height});
}

void painter_cover::add(const l3d_painter_piece& piece) {
    placed_.clear();
    add_cuts(piece, triangles_, *cuts_, placed_);
    visit_rows(scan_, triangles_[piece.triangle].v, placed_, pixels_.size().width,
               [&](std::int32_t row, std::int32_t, columns span) {
                   pixels_.set_all(row, span.begin, span.end);
                   return true;
               });
}

bool painter_cover::hides_sides(const l3d_painter_piece& piece) const {
    bool hidden = true;
    for (const bool smooth : {false, true}) // hidden must be both kinds of lines
        visit_sides(triangles_[piece.triangle], placed_, pixels_.size(), smooth,
                    [&](int x, int y, int, double) { hidden = hidden && pixels_.has(x, y); });
    return hidden;
}

bool painter_cover::hides(const l3d_painter_piece& piece) {
    placed_.clear();
    add_cuts(piece, triangles_, *cuts_, placed_);
    bool hidden = true;
    visit_rows(scan_, triangles_[piece.triangle].v, placed_, pixels_.size().width,
               [&](std::int32_t row, std::int32_t, columns span) {
                   hidden = hidden && pixels_.has_all(row, span.begin, span.end);
                   return hidden;
               });
    return hidden && hides_sides(piece);
}

} // namespace l3d_detail
