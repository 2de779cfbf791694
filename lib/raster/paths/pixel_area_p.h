// SPDX-License-Identifier: MIT
// pixel_area: the area of one pixel that lies inside of edges that cross each other.
#ifndef L3D_RASTER_PATHS_PIXEL_AREA_P_H
#define L3D_RASTER_PATHS_PIXEL_AREA_P_H

#include "raster/paths/covered_span_p.h"
#include "raster/paths/path_chains_p.h"
#include "raster/paths/row_areas_p.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace l3d_detail {

/// How an outline comes to be in a pixel where an edge begins.
enum class cell_begin : std::uint8_t {
    enters,      ///< by another side than the left one, or not known to
    continues,   ///< by the edge before
    unclear,     ///< its first corner lies in the pixel, or it may cross itself there
    enters_left, ///< by the pixel's left side
};

/// The part of an outline's edge in one pixel, in the direction of the outline.
/// Units:   x and y from 0 to 1, seen from the pixel's top left corner.
struct edge_cell {
    l3d_point_2d from, to;
    std::uint32_t edge;     ///< its index; that of the outline's next edge is the next one
    std::uint8_t layer;     ///< 0: an edge of the filled path; 1: of its clip path
    std::int8_t below_left; ///< if the edge crosses the pixel's left side: what this adds to the
                            ///< windings along the side, below the crossing; else 0
    cell_begin begin;
};

/// Finds the exact covered area of a pixel from all edges that reach it.
///
/// The range of windings may tell that all of the pixel is inside, or none. Where many visits meet
/// under the nonzero rule, fields of the pixel may be surely inside, and all of them often are.
///
/// Otherwise the borders of the inside are found: along each edge, the winding on its left changes
/// where other edges cross it, begin or end. The parts with the inside on one side alone add to the
/// area. If rounding may tell wrong which edge is on the left, the pixel is cut into slabs.
/// Cost:    the square of the number of edges. Slabs take n log n for n edges, times their number.
class pixel_area {
public:
    /// Begins a pixel without edges.
    void begin();

    /// Adds an edge that reaches the pixel. Edges come in the order opposite to their outlines'.
    void add(const edge_cell& cell);

    /// The area inside, from 0 to 1. `sums` are the integrals of both layers' windings over the
    /// pixel; they tell the windings at its corner.
    double inside(const std::array<double, 2>& sums, const fill_rules& rules);

private:
    /// The fields of a pixel. Each has a bit in a word.
    static constexpr int rows = 8, columns = 8;
    /// The least and the most winding anywhere in the pixel.
    struct windings_range {
        int least = 0, most = 0;
    };
    static constexpr std::uint64_t all_fields = ~std::uint64_t{0};
    static constexpr std::uint64_t all_in_row = (1U << columns) - 1;
    static constexpr std::uint64_t in_each_row = all_fields / all_in_row;
    /// A visit: a way of an outline through the pixel, from side to side. On its one side, the
    /// higher one, the winding is higher by 1 than on the other.
    struct visit {
        double adds = 0;         ///< its part of the sum
        l3d_point_2d way{};      ///< from the begin to the end of its last edge
        std::uint32_t edge = 0;  ///< the index of its last edge
        std::uint32_t edges = 0; ///< the number of its edges
    };
    /// An edge. Where its upper end lies on the pixel's left side, that side above is taken as a
    /// part of it, and where its lower end does, the side below. So the winding does not change
    /// where it comes to the side. A level edge counts as its part of the side alone.
    struct part : row_edge {
        double slope;
        bool up_left, down_left; ///< whether the upper and the lower end lie on the left side
        double x_at(double y) const { return x0 + (y - y0) * slope; }
    };
    struct range_of_y {
        double top, bottom;
    };

    void end_visit();
    std::uint64_t find_open(int beside, int sign) const;
    static range_of_y open_heights(const part& p, std::uint64_t open);
    std::optional<double> between_borders(const windings& corner, std::uint64_t open,
                                          const fill_rules& rules);
    void find_changes();
    double on_left(windings beside, const fill_rules& rules) const;
    double slabs(const windings& corner, const fill_rules& rules);

    visit last_, before_last_;             ///< visits in the order of edges
    windings_range range_{};               ///< that of the windings, less the corner's
    int turns_right_ = 0, turns_left_ = 0; ///< pairs of visits, by the turn between them
    bool are_shares_clear_ = true;         ///< whether each visit has places on both sides
    bool open_ = false;                    ///< whether the last visit waits for its first edges
    bool is_unclear_ = false;              ///< whether visits may not lead from side to side once
    std::array<double, 2> own_{};          ///< the part of the sums that the edges of the pixel add
    windings before_{};                    ///< those left of the prolonged parts, less the corner's
    kept_list<part> parts_;
    kept_list<winding_change> changes_; ///< along the pixel's left side
    kept_list<winding_change> passed_;  ///< on the left of an edge, where it passes others
    std::vector<row_edge> slab_edges_;
    row_areas slabs_;
};

/// Counts the last visit, if it has edges.
///
/// A visit that adds less than 0 has the pixel's top left corner on its higher side. Two edges that
/// follow each other, and meet elsewhere, do not cross here. If they turn to the right, each place
/// is on the higher side of one of them, else on the lower side of one.
inline void pixel_area::end_visit() {
    if (last_.edges == 0)
        return;
    constexpr double unclear = 1e-9, surely = 1e-10; // far above rounding
    const int on_higher = last_.adds < unclear ? 1 : 0;
    const double share = last_.adds + on_higher;
    are_shares_clear_ &= share > unclear && share < 1 - unclear;
    range_.least -= on_higher;
    range_.most += 1 - on_higher;
    if (last_.edges == 1 && before_last_.edges == 1 && before_last_.edge == last_.edge + 1) {
        const double turn = last_.way.x * before_last_.way.y - last_.way.y * before_last_.way.x;
        turns_right_ += turn > surely ? 1 : 0;
        turns_left_ += turn < -surely ? 1 : 0;
        last_.edges = 0; // no more pairs with it
    }
    before_last_ = last_;
    last_ = {};
}

inline void pixel_area::add(const edge_cell& e) {
    // An edge that leads upwards adds 1 on its right.
    double adds = (e.from.y - e.to.y) * (1 - (e.from.x + e.to.x) / 2);
    const l3d_point_2d way{e.to.x - e.from.x, e.to.y - e.from.y};
    const bool is_up = way.y < 0;
    if (e.below_left != 0)
        adds += e.below_left * (1 - (e.below_left > 0 ? e.from.y : e.to.y));
    own_[e.layer] += adds;
    const std::int8_t direction = way.y == 0 ? e.below_left : is_up ? 1 : -1;
    const l3d_point_2d &upper = is_up ? e.to : e.from, &lower = is_up ? e.from : e.to;
    if (direction != 0)
        parts_.push({{upper.x, upper.y, lower.x, lower.y, direction, e.layer},
                     way.y == 0 ? 0 : way.x / way.y,
                     e.below_left == -direction,
                     e.below_left == direction});
    before_.turns[e.layer] -= e.below_left == -direction ? direction : 0;
    if (!open_)
        end_visit();
    if (last_.edges++ == 0) {
        last_.way = way;
        last_.edge = e.edge;
    }
    last_.adds += adds;
    is_unclear_ |= e.begin == cell_begin::unclear;
    open_ = e.begin == cell_begin::continues;
}

} // namespace l3d_detail

#endif
