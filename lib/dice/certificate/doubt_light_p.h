// SPDX-License-Identifier: MIT
// light_in, lone_sheet: bound the light of pieces in a cell, from bounds of their levels or
// cosines.
#ifndef L3D_DICE_CERTIFICATE_DOUBT_LIGHT_P_H
#define L3D_DICE_CERTIFICATE_DOUBT_LIGHT_P_H

#include "dice/certificate/doubt_bounds.h"
#include "dice/certificate/light_bounds.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace l3d_detail {

struct interval {
    double low = std::numeric_limits<double>::infinity(),
           high = -std::numeric_limits<double>::infinity();

    void add(const interval& more) {
        low = std::min(low, more.low);
        high = std::max(high, more.high);
    }
};

/// The lines that decide the light of a piece. They are a single line for the level, or lines for
/// the cosines of all lamps and for w. Each line bounds a number that is nearly a linear function
/// of the place in the picture.
struct light_lines {
    static constexpr std::size_t most = 2 * (l3d_lighting::most_further + 1) + 1;

    std::array<const l3d_doubt_line*, most> lines{};
    std::size_t count = 0;

    explicit light_lines(const l3d_doubt_bounds& b);
};
using light_ranges = std::array<interval, light_lines::most>;

/// Bounds the light of a piece in a cell. `background` is the colour of a fog that has no colour of
/// its own.
l3d_light_bounds light_in(const l3d_doubt_leaf& leaf, const l3d_image_box& cell,
                          const l3d_light_bounds& background);

/// Bounds the mean light of a cell that a single sheet fills, where nothing else is seen. The
/// bounds follow from the lines of the best known piece, and from the differences between these
/// lines and those of all other pieces.
class lone_sheet {
public:
    lone_sheet(const l3d_image_box& cell, const l3d_light_bounds& background)
        : cell_(cell), background_(background) {}

    /// Offers a piece of the sheet; the best known piece is kept. Expects: all pieces are offered
    /// before any is added.
    void offer(const l3d_doubt_leaf& leaf);
    /// Adds a piece of the sheet that touches the cell.
    void add(const l3d_doubt_leaf& leaf);
    l3d_doubt_verdict verdict() const;

private:
    l3d_doubt_verdict of_levels() const;
    l3d_doubt_verdict of_lamps() const;
    l3d_light_bounds mean_by_lamps(int cuts) const;
    double at(std::size_t line, double x, double y) const;

    const l3d_image_box& cell_;
    const l3d_light_bounds& background_;
    const l3d_doubt_leaf* best_ = nullptr;
    const l3d_doubt_leaf* first_ = nullptr; ///< the leaf added last
    bool is_one_look_ = true, is_known_ = true;
    l3d_light_bounds light_; ///< bounds of the light of all pieces that were added
    /// The ranges of all pieces' lines, and of their differences from the best known piece's lines.
    light_ranges ranges_, beside_;
};

} // namespace l3d_detail

#endif
