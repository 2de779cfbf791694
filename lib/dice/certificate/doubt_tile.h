// SPDX-License-Identifier: MIT
// l3d_doubt_tile: bounds the exact picture in a square part of it.
#ifndef L3D_DICE_CERTIFICATE_DOUBT_TILE_H
#define L3D_DICE_CERTIFICATE_DOUBT_TILE_H

#include "dice/certificate/cell_bounds.h"
#include "dice/certificate/doubt_bounds.h"
#include "tool_2d/pixels.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Bounds of a pixel of the exact picture. Units: parts of the pixel's square, from 0 to 1.
struct l3d_doubt_pixel {
    /// Bounds of the pixel's light. They are sums over the pixel's cells.
    l3d_light_bounds light;

    /// The part in which it is uncertain which surface the exact picture shows.
    double unsure = 0;

    /// The part that may be drawn with a wrong surface, if each surface is drawn within its bounds.
    double unsure_drawn = 0;

    /// The part that certainly shows one surface in the exact picture.
    double covered = 0;

    /// Whether smaller cells may bound the pixel's light better.
    bool is_open = true;
};

/// Bounds the pixels of a square tile of the exact picture. It halves patches into pieces as small
/// as pixels and judges each pixel. Uncertain cells are cut in four, again and again. The pieces
/// that reach into uncertain cells are halved, too.
///
/// Lives: kept from tile to tile for its memory.
/// Cost:  some 7 us a pixel inside a surface, and a millisecond a pixel at an outline.
class l3d_doubt_tile {
public:
    static constexpr int side = 32; ///< side of a tile, in pixels

    /// Starts a tile. Lives: borrows the view until the next tile.
    void begin(const l3d_doubt_view& view, const l3d_pixel_box& tile);

    /// Adds a patch that may reach into the tile, as one piece. Lives: borrows the piece's patch.
    void add(const l3d_doubt_piece& whole);

    /// Bounds all pixels of the tile. Shape: row by row. Lives: until the next tile.
    std::span<const l3d_doubt_pixel> finish();

    /// The number of pieces that were halved, in all tiles so far.
    std::int64_t cuts() const { return cuts_; }

private:
    /// A square of the picture. `of_light` says that its light is still to be bounded. `of_drawing`
    /// says that it is still to be judged whether the square is drawn with the right surface.
    /// Shape: column and row in the tile, counted in cells of the present fineness.
    struct cell {
        int column = 0, row = 0;
        bool of_light = true, of_drawing = true;
        l3d_light_bounds light{}; ///< the light that the cell adds to its pixel's `light`
        /// The parts that the cell adds to these members of its l3d_doubt_pixel.
        double unsure = 0, covered = 0;
    };

    l3d_image_box box_of(const cell& c) const;
    void begin_cells(std::vector<cell>&& cells);
    bool takes_no_area(const l3d_doubt_piece& piece);
    void cut(const l3d_doubt_piece& piece, std::vector<l3d_doubt_leaf>& into);
    bool is_beside_all(const l3d_doubt_piece& piece, double near) const;
    bool is_plain(const l3d_doubt_bounds& b) const;
    bool is_wanted(const l3d_image_box& box) const;
    template <class Visit> void for_cells(const l3d_image_box& box, const Visit& visit) const;
    void sort_leaves();
    std::vector<cell> judge_cells();
    l3d_doubt_pixel& pixel_of(const cell& c);
    void judge_cell(cell& c, std::span<const std::uint32_t> touching);
    bool is_cut(cell& c);
    void give_up();

    const l3d_doubt_view* view_ = nullptr;
    l3d_pixel_box tile_;
    /// How far cells are grown when boxes are matched with them, in pixels. If any cell's drawing
    /// is still to be judged, this is the view's `bound_px`, the error bound of drawn places; else
    /// 0.
    double grown_ = 0;
    bool judges_drawing_ = false;
    int finest_drawing_ = 0;
    int fineness_ = 0; ///< cells are now 2^-fineness_ pixels wide
    bool is_too_much_ = false;
    double areas_left_out_ = 0; ///< the total area of pieces whose light is left out
    std::int64_t cuts_ = 0;
    std::vector<cell> cells_;
    /// For each place of a cell: the index of its cell in cells_, or -1.
    std::vector<std::int32_t> grid_;
    std::vector<l3d_doubt_leaf> leaves_, next_leaves_;
    std::vector<bool> is_needed_; ///< for each leaf, whether a smaller cell may still show it
    /// touching_ lists the leaves that touch each cell, one cell after another. The leaves of cell
    /// i begin at index first_[i] of this list.
    std::vector<std::uint32_t> first_, touching_;
    std::vector<l3d_doubt_pixel> pixels_;
    l3d_cell_bounds judge_;
};

#endif
