// SPDX-License-Identifier: MIT
// pixel_area: what visits of outlines tell of a pixel; slabs where they do not.
#include "raster/paths/pixel_area_p.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace l3d_detail {

void pixel_area::begin(std::int32_t column) {
    column_ = column;
    slabs_.set_width(1);
    parts_.clear();
    changes_.clear();
    own_ = {};
    visit_ = shares_ = 0;
    visits_ = 0;
    is_unclear_ = false;
}

void pixel_area::add(const edge_cell& cell) {
    const double x0 = cell.top.x - column_, y0 = cell.top.y;
    const double x1 = cell.bottom.x - column_, y1 = cell.bottom.y;
    double adds = cell.direction * (y1 - y0) * (1 - (x0 + x1) / 2);
    if (cell.below_left != 0) { // the end on the side is the left one
        changes_.push_back({x0 <= x1 ? y0 : y1, cell.below_left, cell.layer});
        adds += cell.below_left * (1 - changes_.back().y);
    }
    if (y0 < y1)
        parts_.push_back({x0, y0, x1, y1, cell.direction, cell.layer});
    own_[cell.layer] += adds;
    visit_ += adds;
    is_unclear_ |= cell.begin == cell_begin::unclear;
    if (cell.begin != cell_begin::continues)
        end_visit();
}

/// Ends a visit: a way through the pixel, from side to side. On its one side the winding is higher
/// by 1 than on the other. The share of the pixel there differs from what its edges add by a
/// whole number.
void pixel_area::end_visit() {
    constexpr double unclear = 1e-9; // far above rounding
    const double share = visit_ - std::floor(visit_);
    shares_ += share < unclear ? 1 : share;
    visit_ = 0;
    ++visits_;
}

/// Whether the winding is certainly at least 1, or at most -1, wherever in the pixel. `corner` is
/// that of its top left corner.
///
/// The pixel has 8 x 8 fields, and each has a lower bound of its windings. An edge that makes the
/// winding fall counts from the first field on that it may reach. One that makes it rise counts
/// behind those that it may reach. A row's bounds are the bytes of a word.
bool pixel_area::is_wound_about(int corner) const {
    constexpr int fields = 8, zero = 127; // a byte above it has its highest bit set
    constexpr std::uint64_t ones = 0x0101010101010101;
    if (corner == 0 && changes_.empty())
        return false; // as is the corner itself
    if (parts_.size() + changes_.size() + static_cast<std::size_t>(std::abs(corner)) > zero)
        return false;
    const int sign = corner < 0 ? -1 : 1;
    const auto floor = [](double y) { return static_cast<int>(y); };
    const auto ceil = [](double y) {
        const int whole = static_cast<int>(y);
        return whole + (whole < y ? 1 : 0);
    };
    std::array<std::uint64_t, fields + 1> least;
    least.fill(ones * static_cast<std::uint64_t>(zero + sign * corner));
    for (const winding_change& c : changes_) {
        const int by = sign * c.direction;
        const double y = c.y * fields;
        for (int k = by < 0 ? floor(y) : ceil(y); k < fields; ++k)
            least[static_cast<std::size_t>(k)] += by < 0 ? -ones : ones;
    }
    for (const row_edge& p : parts_) {
        const double slope = (p.x1 - p.x0) / (p.y1 - p.y0);
        // The margin covers the rounding of x and of up to eight steps, each below 1.
        constexpr double scale = 1 << 16, margin = 16;
        const bool falls = sign * p.direction < 0;
        const double y0 = p.y0 * fields, y1 = p.y1 * fields;
        const int begin = falls ? floor(y0) : ceil(y0);
        const int end = falls ? ceil(y1) : floor(y1);
        const double low = std::min(p.x0, p.x1) * fields, high = std::max(p.x0, p.x1) * fields;
        const auto fixed_low = static_cast<std::int64_t>(low * scale - margin);
        const auto fixed_high = static_cast<std::int64_t>(high * scale + margin);
        // Where an edge leads to the right, it is leftmost on top of a row of fields.
        std::int64_t x = falls ? fixed_low : fixed_high, step = 0;
        if (std::abs(slope) < 64) {
            const double row = begin + (falls == (slope < 0) ? 1 : 0);
            x = static_cast<std::int64_t>((p.x0 * fields + (row - y0) * slope) * scale +
                                          (falls ? -margin : margin));
            step = static_cast<std::int64_t>(slope * scale);
        }
        for (int k = begin; k < end; ++k, x += step) {
            const std::int64_t at =
                std::clamp<std::int64_t>(std::clamp(x, fixed_low, fixed_high), 0, fields << 16);
            const std::int64_t field = (falls ? at : at + 0xffff) >> 16;
            const std::uint64_t behind = field < fields ? ones << (field << 3) : 0;
            least[static_cast<std::size_t>(k)] += falls ? -behind : behind;
        }
    }
    std::uint64_t all = ~std::uint64_t{0};
    for (std::size_t k = 0; k < fields; ++k)
        all &= least[k];
    return (all & 128 * ones) == 128 * ones;
}

double pixel_area::inside(const std::array<double, 2>& sums, const fill_rules& rules) {
    const bool is_nonzero = !rules.clips && rules.rule[0] == l3d_winding::nonzero;
    if (is_nonzero && !is_unclear_) {
        const auto least = std::lrint(sums[0] - shares_); // where all visits have their lower sides
        if (least > 0 || least + visits_ < 0)
            return 1;
    }
    // The rest of the sum, without what the pixel's edges add, is that of its corner.
    const windings w{{static_cast<int>(std::lrint(sums[0] - own_[0])),
                      static_cast<int>(std::lrint(sums[1] - own_[1]))}};
    constexpr int many = 6; // for fewer visits, slabs cost less
    if (is_nonzero && visits_ >= many && is_wound_about(w.turns[0]))
        return 1;
    std::ranges::sort(changes_, {}, &winding_change::y);
    slabs_.add_cluster(parts_, w, rules, changes_);
    double* const borders = slabs_.sums();
    double area = std::exchange(borders[0], 0);
    borders[1] = borders[2] = 0;
    // Where the left side is inside, all is but for what borders take away.
    windings left = w;
    double top = 0;
    for (const winding_change& c : changes_) {
        area += rules.inside(left) ? c.y - top : 0;
        left.cross(c);
        top = c.y;
    }
    return area + (rules.inside(left) ? 1 - top : 0);
}

} // namespace l3d_detail
