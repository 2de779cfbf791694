// SPDX-License-Identifier: MIT
// row_areas: the area of each pixel of a row that lies inside of edges that cross each other.
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

/// The part of an edge in one row of pixels.
/// Units:   x in pixels from the picture's left, y from 0 to 1 down the row; y0 <= y1.
struct row_edge {
    double x0, y0, x1, y1;
    std::int8_t direction; ///< 1 if it leads upwards, and adds 1 to the winding right of it
    std::uint8_t layer;    ///< 0: of what is filled; 1: of what clips it
};

/// The windings of outlines around a place: those of the filled path, and those of the path that
/// clips it.
struct windings {
    std::array<int, 2> turns{};

    /// Crosses a border, which has a direction and a layer.
    template <class Border> void cross(const Border& border) {
        turns[border.layer] += border.direction;
    }
};

/// Winding rules of both layers.
struct fill_rules {
    std::array<l3d_winding, 2> rule{};
    bool clips = false; ///< there is a second layer

    bool inside(const windings& w) const {
        return layer_inside(w, 0) && (!clips || layer_inside(w, 1));
    }

    /// Whether inside and outside are surely the same wherever windings lie between two bounds.
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

/// Exact areas of the pixels of one row, summed up from the borders of the inside.
///
/// A border adds the area right of it in its own columns. So the running sum over columns is
/// the area of each pixel, also behind the last column that a border reaches.
/// Cost:    add: linear in the columns that are reached. add_cluster: n log n for n edges, times
///          the number of their ends and crossings; if they are many, for those of two columns.
class row_areas {
public:
    /// Sets the columns to 0 to width - 1. Expects: all sums are 0, as users leave them.
    void set_width(std::int32_t width);

    /// Adds edges of a cluster, which have the windings `left` on their left.
    ///
    /// Edges may cross and lie upon each other. The row is cut at their ends and crossings.
    /// Between two cuts edges have an order, and only edges at which inside and outside change
    /// count.
    void add_cluster(std::span<const row_edge> edges, const windings& left,
                     const fill_rules& rules);

    /// Adds a single border, whatever lies between it and others. The height is negative if the
    /// inside is left of it.
    void add_border(double x0, double x1, double height);

    /// The sums of columns, to be run up. Beyond the last column there are two more.
    double* sums() { return sums_.data(); }

private:
    struct chord {
        double x0, x1; ///< at the top and at the bottom of the slab
        const row_edge* edge;

        bool operator<(const chord& other) const {
            return x0 != other.x0 ? x0 < other.x0 : x1 < other.x1;
        }
    };

    /// A height from which on the windings left of the strip are others.
    struct change {
        double y;
        windings by;
    };

    void add_in_strips(std::span<const row_edge> edges, const windings& left,
                       const fill_rules& rules);
    void add_strip(std::span<const row_edge> edges, const windings& left, const fill_rules& rules);
    void add_changes(std::span<const row_edge> edges);
    void add_slab(double top, double bottom, const windings& left, const fill_rules& rules);
    void find_crossings(std::span<const chord> chords, double top, double bottom);
    windings add_crossing(std::span<const chord> chords, double top, double bottom,
                          const windings& left, const fill_rules& rules);
    windings add_ordered(std::span<const chord> chords, double top, double bottom,
                         const windings& left, const fill_rules& rules);

    /// Two chords change places.
    struct crossing {
        double y;
        std::size_t from_left, from_right;
    };
    /// A chord among those that cross.
    struct track {
        std::size_t place; ///< from left to right
        double since;      ///< the height from which on it has been a border, if its sign is not 0
        int sign;          ///< 1: the inside is right of it
    };

    std::vector<double> sums_;
    std::vector<double> ends_;
    std::vector<chord> chords_;
    std::vector<crossing> crossings_, waiting_;
    std::vector<track> tracks_;
    std::vector<windings> before_; ///< windings left of each place
    std::vector<std::size_t> by_lower_;
    std::vector<double> least_after_; ///< least of the lower ends, from each chord on
    std::vector<const row_edge*> sorted_;
    std::vector<std::vector<row_edge>> strips_;
    std::vector<change> changes_; ///< from top to bottom
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
    // From left to right: `passed` is how much of the height lies left of a column's right side.
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

/// Puts borders that follow each other together as long as they stay in one pixel.
class pixel_sum {
public:
    /// Begins at x, the place of the first border.
    pixel_sum(row_areas& areas, double x) : areas_(areas), column_(static_cast<std::int32_t>(x)) {}
    ~pixel_sum() { end(); }
    pixel_sum(const pixel_sum&) = delete;
    pixel_sum& operator=(const pixel_sum&) = delete;

    /// As row_areas::add_border, but for the order of sums.
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
