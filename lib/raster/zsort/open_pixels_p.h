// SPDX-License-Identifier: MIT
// open_pixels: which pixels of some rows nothing was painted to yet.
#ifndef L3D_RASTER_ZSORT_OPEN_PIXELS_P_H
#define L3D_RASTER_ZSORT_OPEN_PIXELS_P_H

#include "raster/shapes/piece_pixels_p.h"
#include "raster/shapes/scan_polygon_p.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace l3d_detail {

/// A bit for each pixel of some rows, so that what is painted from front to back is painted once.
///
/// Shape: rows of whole words of 64 bits; a bit is set where a pixel is taken.
/// Cost:  a row of a picture of 1024 pixels takes two cache lines.
class open_pixels {
public:
    /// Opens all pixels of these rows. Keeps its memory.
    void open(scan_rows rows, std::int32_t width) {
        rows_ = rows;
        words_ = static_cast<std::size_t>((width + bits - 1) / bits);
        taken_.assign(words_ * static_cast<std::size_t>(rows.bottom - rows.top), 0);
    }

    /// Whether a pixel of these columns and rows is open. Expects: they lie in the rows.
    bool any(scan_rows rows, columns of) const {
        for (std::int32_t x = of.begin; x < of.end;) {
            const part here(x, of.end);
            for (std::int32_t row = rows.top; row < rows.bottom; ++row)
                if ((~taken(row)[here.word] & here.mask) != 0)
                    return true;
            x = here.end;
        }
        return false;
    }

    /// Takes the columns of a row. Calls visit(columns) for each run of them that was open.
    template <class Visit> void take(std::int32_t row, columns of, const Visit& visit) {
        if (of.begin >= of.end)
            return;
        std::uint64_t* const words = taken(row);
        const part first(of.begin, of.end);
        if (first.end < of.end) // most rows of triangles lie in one word
            return take_words(words, of, visit);
        const std::uint64_t open = ~words[first.word] & first.mask;
        words[first.word] |= first.mask;
        if (open == first.mask)
            visit(of);
        else
            visit_bits(open, of.begin / bits * bits, visit);
    }

    /// Whether a pixel of a piece is open. Expects: its pixels are known.
    bool any(const l3d_painter_piece& piece) const {
        constexpr std::int32_t side = l3d_painter_piece::small_side;
        std::int32_t row = piece.top;
        for (std::uint64_t cover = piece.cover; cover != 0; cover >>= side, ++row) {
            const std::uint64_t in_row = cover & ((1U << side) - 1);
            if (row >= rows_.top && row < rows_.bottom && open_of(row, piece.left, in_row) != 0)
                return true;
        }
        return false;
    }

    /// Takes columns of a row: bit k of `wanted` stands for column x + k.
    /// Returns: those of them that were open.
    /// Expects: eight bits, of columns that the picture has.
    std::uint64_t take(std::int32_t row, std::int32_t x, std::uint64_t wanted) {
        const std::uint64_t open = open_of(row, x, wanted);
        std::uint64_t* const words = taken(row) + x / bits;
        const int shift = x % bits;
        words[0] |= open << shift;
        if (const std::uint64_t next = open >> (bits - 1 - shift) >> 1; next != 0)
            words[1] |= next;
        return open;
    }

    /// Calls visit(columns) for each run of bits that are set; bit 0 is column x.
    template <class Visit>
    static void visit_bits(std::uint64_t open, std::int32_t x, const Visit& visit) {
        while (open != 0) {
            const int first = std::countr_zero(open);
            const int length = std::countr_one(open >> first);
            visit(columns{x + first, x + first + length});
            open &= open + (open & -open); // without the lowest run
        }
    }

private:
    static constexpr std::int32_t bits = 64;

    /// take() of any columns.
    template <class Visit> void take_words(std::uint64_t* words, columns of, const Visit& visit) {
        columns run{of.begin, of.begin}; // open, and perhaps not at its end yet
        for (std::int32_t x = of.begin; x < of.end;) {
            const part here(x, of.end);
            const std::uint64_t open = ~words[here.word] & here.mask;
            words[here.word] |= here.mask;
            visit_bits(open, x / bits * bits, [&](columns next) {
                if (next.begin == run.end) {
                    run.end = next.end;
                    return;
                }
                if (run.begin < run.end)
                    visit(run);
                run = next;
            });
            x = here.end;
        }
        if (run.begin < run.end)
            visit(run);
    }

    /// The columns from x on that are in the same word. Expects: x >= 0.
    struct part {
        std::size_t word;
        std::int32_t end;
        std::uint64_t mask;

        part(std::int32_t x, std::int32_t most)
            : word(static_cast<std::uint32_t>(x) / bits), end(std::min((x | (bits - 1)) + 1, most)),
              mask(~std::uint64_t{0} >> (bits - (end - x)) << (x & (bits - 1))) {}
    };

    /// Those of `wanted` that are open; bits as of take().
    std::uint64_t open_of(std::int32_t row, std::int32_t x, std::uint64_t wanted) const {
        const std::uint64_t* const words = taken(row) + x / bits;
        const int shift = x % bits;
        std::uint64_t there = words[0] >> shift;
        if (wanted >> (bits - 1 - shift) >> 1 != 0) // some are in the next word
            there |= words[1] << (bits - shift);
        return wanted & ~there;
    }

    const std::uint64_t* taken(std::int32_t row) const {
        return taken_.data() + static_cast<std::size_t>(row - rows_.top) * words_;
    }
    std::uint64_t* taken(std::int32_t row) {
        return taken_.data() + static_cast<std::size_t>(row - rows_.top) * words_;
    }

    scan_rows rows_;
    std::size_t words_ = 0;
    std::vector<std::uint64_t> taken_;
};

} // namespace l3d_detail

#endif
