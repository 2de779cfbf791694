// SPDX-License-Identifier: MIT
// Where surfaces may end in the picture: their borders, and where they fold over.
#ifndef L3D_REFERENCE_OUTLINES_H
#define L3D_REFERENCE_OUTLINES_H

#include "reference/net.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace reference {

/// A part of a patch's boundary: four control points before the division.
struct border_part {
    std::array<hpoint, 4> points;
    bool first = true, last = true; ///< whether the ends are corners of the patch
};

/// A piece, an eighth of a pixel wide at most, in which a surface may fold over or be cut by the
/// near plane.
struct fold_piece {
    rect box;
    std::array<border_part, 4> sides; ///< they lie on the surface
};

/// The places where outlines may be: every outline of the exact picture lies on a border, in a fold
/// piece, or where two surfaces cross.
///
/// A piece that make_chart proves to map one to one has no fold. Pieces without proof are halved
/// down to an eighth of a pixel. So in a pixel without borders and folds, each sheet covers the
/// whole square.
///
/// Errors: std::runtime_error after 20 million pieces.
class outline_map {
public:
    /// Expects: as exact_image does.
    outline_map(std::span<const patch> patches, const camera& view, picture_size size);

    /// The borders or folds that may pass the pixel, nearer than w.
    std::vector<border_part> borders(int x, int y, double w) const;
    std::vector<fold_piece> folds(int x, int y, double w) const;
    bool any(int x, int y, double w) const;

private:
    void add_border(const border_part& part, int depth);
    void add_folds(const net& piece);
    template <class Visit> void for_pixels(const rect& box, Visit visit) const;

    double near_;
    picture_size size_;
    rect window_;
    int pieces_ = 0;
    std::vector<border_part> borders_;
    std::vector<fold_piece> folds_;
    std::vector<std::vector<std::uint32_t>> borders_at_, folds_at_; ///< by pixel, row by row
};

/// The places where a border meets the line y = c (`along_x`) or x = c, by their other coordinate.
std::vector<double> crossings(const border_part& of, bool along_x, double c);

/// The coordinates y (`along_x`) or x at which the border turns back in that direction, or ends in
/// a corner of the patch.
std::vector<double> turns(const border_part& of, bool along_x);

} // namespace reference

#endif
