// SPDX-License-Identifier: MIT
// painter_cover: bits of rows.
#include "pipeline/zsort/painter_cover_p.h"

#include <algorithm>

namespace l3d_detail {

namespace {

constexpr std::int32_t bits = 64;

/// Calls visit(index, mask) for the words of a row that hold these columns, until it says false;
/// returns whether it never did.
template <class Visit> bool visit_words(columns span, const Visit& visit) {
    for (std::int32_t word = span.begin / bits; word * bits < span.end; ++word) {
        const std::int32_t first = std::max(span.begin - word * bits, 0);
        const std::int32_t behind = std::min(span.end - word * bits, bits);
        const std::uint64_t from_first = ~std::uint64_t{0} << first;
        if (!visit(static_cast<std::size_t>(word),
                   from_first & ~std::uint64_t{0} >> (bits - behind)))
            return false;
    }
    return true;
}

} // namespace

void painter_cover::begin(l3d_size size, std::span<const l3d_painter_triangle> triangles,
                          const std::vector<l3d_painter_cut>& cuts) {
    size_ = size;
    triangles_ = triangles;
    cuts_ = &cuts;
    words_ = static_cast<std::size_t>((size.width + bits - 1) / bits);
    pixels_.assign(words_ * static_cast<std::size_t>(size.height), 0);
    scan_.set_rows({0, size.height});
}

void painter_cover::add(const l3d_painter_piece& piece) {
    placed_.clear();
    add_cuts(piece, triangles_, *cuts_, placed_);
    visit_rows(scan_, triangles_[piece.triangle].v, placed_, size_.width,
               [&](std::int32_t row, std::int32_t, columns span) {
                   std::uint64_t* const words = &pixels_[static_cast<std::size_t>(row) * words_];
                   visit_words(span, [words](std::size_t i, std::uint64_t mask) {
                       words[i] |= mask;
                       return true;
                   });
                   return true;
               });
}

bool painter_cover::covers(std::int32_t row, columns span) const {
    const std::uint64_t* const words = &pixels_[static_cast<std::size_t>(row) * words_];
    return visit_words(
        span, [words](std::size_t i, std::uint64_t mask) { return (words[i] & mask) == mask; });
}

bool painter_cover::hides_sides(const l3d_painter_piece& piece) const {
    bool hidden = true;
    for (const bool smooth : {false, true}) // whichever will be drawn
        visit_sides(triangles_[piece.triangle], placed_, size_, smooth,
                    [&](int x, int y, int, double) {
                        hidden = hidden && covers(y, {x, x + 1});
                    });
    return hidden;
}

bool painter_cover::hides(const l3d_painter_piece& piece) {
    placed_.clear();
    add_cuts(piece, triangles_, *cuts_, placed_);
    bool hidden = true;
    visit_rows(scan_, triangles_[piece.triangle].v, placed_, size_.width,
               [&](std::int32_t row, std::int32_t, columns span) {
                   hidden = hidden && covers(row, span);
                   return hidden;
               });
    return hidden && hides_sides(piece);
}

} // namespace l3d_detail
