// SPDX-License-Identifier: MIT
// row_areas: finds the area of each pixel of a row that lies inside of crossing edges.
#ifndef L3D_RASTER_PATHS_ROW_AREAS_P_H
#define L3D_RASTER_PATHS_ROW_AREAS_P_H

#include "raster/rasterizer_2d.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Sorts a list, which mostly has few elements.
template <class List, class Less> void sort_few(List& of, const Less& less) {
    constexpr std::size_t few = 16; // insertion takes up to n^2 / 4 moves
    if (of.size() > few)
        return std::sort(of.begin(), of.end(), less);
    for (std::size_t i = 1; i < of.size(); ++i) {
        const auto moving = of[i];
        std::size_t hole = i;
        for (; hole > 0 && less(moving, of[hole - 1]); --hole)
            of[hole] = of[hole - 1];
        of[hole] = moving;
    }
}

/// The part of an edge in one row of pixels.
/// Units:   x in pixels from the picture's left side, y from 0 to 1 down the row; y0 <= y1.
struct row_edge {
    double x0, y0, x1, y1;
    /// 1 if the outline leads upwards along this edge, which adds 1 to the winding on its right;
    /// else -1.
    std::int8_t direction;
    std::uint8_t layer; ///< 0: an edge of the filled path; 1: of its clip path
};

/// The winding numbers of a place: one number for the filled path, and one for the path that clips
/// it.
struct windings {
    std::array<int, 2> turns{};

    /// Changes the numbers as the place moves to the right across a border, which has a direction
    /// and a layer.
    template <class Border> void cross(const Border& border) {
        turns[border.layer] += border.direction;
    }
};

/// The winding rules of both layers: the filled path and its clip path.
struct fill_rules {
    std::array<l3d_winding, 2> rule{};
    bool clips = false; ///< whether there is a clip path

    bool inside(const windings& w) const {
        return layer_inside(w, 0) && (!clips || layer_inside(w, 1));
    }

    /// Whether all winding numbers between two bounds are surely alike: all inside, or all outside.
    bool same_between(const windings& low, const windings& high) const {
        const bool first = layer_same(low, high, 0);
        if (!clips)
            return first;
        const bool second = layer_same(low, high, 1);
        return (first && second) || (first && !layer_inside(low, 0)) ||
               (second && !layer_inside(low, 1));
    }

private:
    bool layer_same(const windings& low, const windings& high, std::size_t layer) const {
        const int least = low.turns[layer], most = high.turns[layer];
        return least == most || (rule[layer] == l3d_winding::nonzero && (least > 0 || most < 0));
    }
    bool layer_inside(const windings& w, std::size_t layer) const {
        const int turns = w.turns[layer];
        return rule[layer] == l3d_winding::even_odd ? (turns & 1) != 0 : turns != 0;
    }
};

/// A change of the winding numbers on the left of some edges, from a height downwards.
struct winding_change {
    double y;
    std::int8_t direction;
    std::uint8_t layer;
};

/// Finds the exact covered areas of the pixels of one row, as running sums from left to right.
///
/// Each border between inside and outside adds the area on its right to the columns that it
/// reaches. So the running sum over columns is the covered area of each pixel, also behind the last
/// border.
/// Cost:    add_border: linear in the columns that are reached. add_cluster: n log n for n edges,
///          times the number of their ends and crossings.
class row_areas {
public:
    /// Sets the columns to 0 to width - 1. Expects: all sums are 0, as callers leave them.
    void set_width(std::int32_t width);

    /// Adds the edges of a cluster. `left` has the winding numbers on the left of all edges at the
    /// row's top. `changes` lists, from top to bottom, how these numbers change down the row.
    ///
    /// Edges may cross and lie upon each other. The row is cut at their ends and crossings. Between
    /// two cuts, edges have an order from left to right. An edge adds area only where one of its
    /// sides is inside and the other side is outside.
    void add_cluster(std::span<const row_edge> edges, const windings& left, const fill_rules& rules,
                     std::span<const winding_change> changes = {});

    /// Adds a single border, from x0 to x1, independent of other borders. `height` is the border's
    /// height in the row, negative if the inside is on the border's left.
    void add_border(double x0, double x1, double height);

    /// The differences of areas from column to column, to be summed up from the left. There are two
    /// more differences than columns.
    double* sums() { return sums_.data(); }

private:
    struct chord {
        double x0, x1; ///< the chord's x at the top and at the bottom of the slab
        const row_edge* edge;

        bool operator<(const chord& other) const {
            return x0 != other.x0 ? x0 < other.x0 : x1 < other.x1;
        }
    };

    void add_slab(double top, double bottom, const windings& left, const fill_rules& rules);
    void find_crossings(std::span<const chord> chords, double top, double bottom);
    windings add_crossing(std::span<const chord> chords, double top, double bottom,
                          const windings& left, const fill_rules& rules);
    windings add_ordered(std::span<const chord> chords, double top, double bottom,
                         const windings& left, const fill_rules& rules);

    /// A crossing, where two chords change places.
    struct crossing {
        double y;
        std::size_t from_left, from_right;
    };
    /// The state of a chord among chords that cross.
    struct track {
        std::size_t place; ///< the chord's place in the order from left to right
        double since;      ///< the height at which the chord became a border, if its sign is not 0
        int sign; ///< 0: the chord is no border; 1: the inside is on its right; -1: on its left
    };

    std::vector<double> sums_;
    std::vector<double> ends_;
    std::vector<chord> chords_;
    std::vector<crossing> crossings_, waiting_;
    std::vector<track> tracks_;
    std::vector<windings> before_; ///< the winding numbers on the left of each place in the order
    std::vector<std::size_t> by_lower_;
    /// For each chord, the least lower end among this chord and the chords after it.
    std::vector<double> least_after_;
    std::vector<const row_edge*> sorted_;
};

inline void row_areas::add_border(double x0, double x1, double height) {
    const double left = std::min(x0, x1), right = std::max(x0, x1);
    const auto first = static_cast<std::int32_t>(left);
    const auto last = static_cast<std::int32_t>(right);
    double* sum = sums_.data() + first;
    if (first == last) {
        const double beyond = height * ((x0 + x1) / 2 - first);
        sum[0] += height - beyond;
        sum[1] += beyond;
        return;
    }
    // From left to right, `passed` is the part of the height on the left of a column's right side.
    const double per_column = height / (right - left);
    if (first + 1 == last) {
        const double passed = (last - left) * per_column, rest = height - passed;
        const double before = passed * ((left + last) / 2 - first);
        const double beyond = rest * ((last + right) / 2 - last);
        sum[0] += passed - before;
        sum[1] += before + (rest - beyond);
        sum[2] += beyond;
        return;
    }
    double from = left, before = 0;
    for (std::int32_t column = first; column <= last; ++column, ++sum) {
        const double to = std::min<double>(column + 1, right);
        const double passed = column == last ? height : (to - left) * per_column;
        const double here = passed - before;
        const double beyond = here * ((from + to) / 2 - column);
        sum[0] += here - beyond;
        sum[1] += beyond;
        before = passed;
        from = to;
    }
}

/// Adds consecutive borders as a single border as long as these borders stay in one pixel.
class pixel_sum {
public:
    /// Begins a sum, which is later added to `areas`. `x` is where the first border begins.
    pixel_sum(row_areas& areas, double x) : areas_(areas), column_(static_cast<std::int32_t>(x)) {}
    ~pixel_sum() { end(); }
    pixel_sum(const pixel_sum&) = delete;
    pixel_sum& operator=(const pixel_sum&) = delete;

    /// Adds a border as row_areas::add_border does, but sums areas in another order.
    void add_border(double x0, double x1, double height) {
        const auto column = static_cast<std::int32_t>(x1);
        if (column == column_) {
            height_ += height;
            beyond_ += height * ((x0 + x1) / 2 - column);
        } else {
            end();
            column_ = column;
            areas_.add_border(x0, x1, height);
        }
    }

private:
    void end() {
        double* const sum = areas_.sums() + column_;
        sum[0] += height_ - beyond_;
        sum[1] += beyond_;
        height_ = beyond_ = 0;
    }

    row_areas& areas_;
    std::int32_t column_;
    double height_ = 0, beyond_ = 0;
};

} // namespace l3d_detail

#endif
