// SPDX-License-Identifier: MIT
// l3d_painter_order: keys, tiles, and the walk over what hides what.
#include "pipeline/polygons/painter_order.h"

#include "geom/radix_sort.h"
#include "pipeline/polygons/painter_components_p.h"
#include "pipeline/polygons/painter_knot_p.h"
#include "pipeline/polygons/painter_overlap_p.h"
#include "raster/shapes/scan_edge_p.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace {

using namespace l3d_detail;

/// The pixels whose centres are in a triangle's box, ends excluded, and its range of 1/w.
struct pixel_range {
    std::int32_t left, top, right, bottom;
    float farthest, nearest;

    bool empty() const { return left >= right || top >= bottom; }
    bool meets(const pixel_range& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

pixel_range range_of(const std::array<l3d_micro_vertex, 3>& v, l3d_size size) {
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
    const auto [farthest, nearest] = std::minmax({v[0].inv_w, v[1].inv_w, v[2].inv_w});
    return {std::max(first_centre(left), 0),
            std::max(first_centre(top), 0),
            std::min(first_centre(right), size.width),
            std::min(first_centre(bottom), size.height),
            farthest,
            nearest};
}

bool has_area(const std::array<l3d_micro_vertex, 3>& v) {
    return (std::int64_t{v[1].x} - v[0].x) * (std::int64_t{v[2].y} - v[0].y) !=
           (std::int64_t{v[1].y} - v[0].y) * (std::int64_t{v[2].x} - v[0].x);
}

/// For each tile of the picture the triangles whose boxes reach it, the farthest first.
class tile_lists {
public:
    /// Squares about twice as wide as the mean triangle: fewer would list each triangle often,
    /// larger ones would list together what does not meet.
    void make(const std::vector<pixel_range>& ranges, l3d_size size) {
        double area = 0;
        for (const pixel_range& r : ranges)
            area += double(r.right - r.left) * (r.bottom - r.top);
        const double side = 2 * std::sqrt(area / std::max<double>(1, double(ranges.size())));
        constexpr int least = 2, most = 7; // 4 to 128 pixels
        shift_ =
            std::clamp(static_cast<int>(std::lround(std::log2(std::max(side, 1.0)))), least, most);
        columns_ = ((size.width - 1) >> shift_) + 1;
        const int rows = ((size.height - 1) >> shift_) + 1;
        // Counted two places too far: after the sums and the filling, begins_[t] is where t begins.
        begins_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows) + 2, 0);
        for (const pixel_range& r : ranges)
            for_each(r, [&](std::size_t tile, int, int) { ++begins_[tile + 2]; });
        for (std::size_t t = 2; t < begins_.size(); ++t)
            begins_[t] += begins_[t - 1];
        entries_.resize(begins_.back());
        for (std::uint32_t i = 0; i < ranges.size(); ++i)
            for_each(ranges[i],
                     [&](std::size_t tile, int, int) { entries_[begins_[tile + 1]++] = i; });
        heads_.assign(begins_.begin(), begins_.end());
    }

    /// Calls visit(tile, column, row of tiles) for each that a range reaches.
    template <class Visit> void for_each(const pixel_range& r, const Visit& visit) const {
        for (int row = r.top >> shift_; row <= (r.bottom - 1) >> shift_; ++row)
            for (int column = r.left >> shift_; column <= (r.right - 1) >> shift_; ++column)
                visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                          static_cast<std::size_t>(column),
                      column, row);
    }

    /// The members of a tile. Those at its beginning for which `skip` is true are dropped for good.
    template <class Skip> std::span<const std::uint32_t> rest(std::size_t tile, const Skip& skip) {
        std::uint32_t& head = heads_[tile];
        const std::uint32_t end = begins_[tile + 1];
        while (head < end && skip(entries_[head]))
            ++head;
        return {entries_.data() + head, end - head};
    }

    /// Whether a tile is the first of those that both ranges reach.
    bool is_first_common(int column, int row, const pixel_range& a, const pixel_range& b) const {
        return column == std::max(a.left, b.left) >> shift_ &&
               row == std::max(a.top, b.top) >> shift_;
    }

private:
    int shift_ = 0, columns_ = 0;
    std::vector<std::uint32_t> begins_, heads_, entries_;
};

} // namespace

struct l3d_painter_order::work_space {
    std::vector<l3d_sort_item> keys, other_keys;
    std::vector<l3d_painter_triangle> sorted;
    std::vector<pixel_range> ranges;
    tile_lists tiles;
    ordered_components components;
    painter_knot knot;
    std::vector<l3d_painter_piece> pieces;
    std::vector<l3d_painter_cut> cuts;

    /// By the farthest corner, as positive floats are ordered like their bits.
    void sort(std::span<const l3d_painter_triangle> triangles, l3d_size size) {
        keys.clear();
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            const pixel_range range = range_of(triangles[i].v, size);
            if (!range.empty() && has_area(triangles[i].v))
                keys.push_back({std::bit_cast<std::uint32_t>(range.farthest), i});
        }
        l3d_radix_sort(keys, other_keys);
        sorted.resize(keys.size());
        ranges.resize(keys.size());
        for (std::size_t i = 0; i < keys.size(); ++i) {
            sorted[i] = triangles[keys[i].index];
            ranges[i] = range_of(sorted[i].v, size);
        }
    }

    /// Adds what must be painted before a triangle: those that it is in front of somewhere.
    void find_needed(std::uint32_t triangle, std::vector<std::uint32_t>& out,
                     l3d_painter_order_counts& counts) {
        const pixel_range& own = ranges[triangle];
        const auto emitted = [&](std::uint32_t i) { return components.emitted(i); };
        tiles.for_each(own, [&](std::size_t tile, int column, int row) {
            for (const std::uint32_t i : tiles.rest(tile, emitted)) {
                const pixel_range& range = ranges[i];
                if (range.farthest >= own.nearest)
                    break; // wholly in front, and so are all that follow
                if (i == triangle || !own.meets(range) ||
                    !tiles.is_first_common(column, row, own, range) || emitted(i))
                    continue;
                ++counts.pairs;
                if (insides_meet(sorted[triangle].v, sorted[i].v) &&
                    (range.nearest <= own.farthest ||
                     front_of(sorted[triangle].v, sorted[i].v).first))
                    out.push_back(i);
            }
        });
    }
};

l3d_painter_order::l3d_painter_order() : work_(std::make_unique<work_space>()) {}

l3d_painter_order::~l3d_painter_order() = default;

void l3d_painter_order::make(std::span<const l3d_painter_triangle> triangles, l3d_size size,
                             bool resolve) {
    work_space& w = *work_;
    counts_ = {};
    counts_.triangles = static_cast<std::int64_t>(triangles.size());
    w.pieces.clear();
    w.cuts.clear();
    w.sort(triangles, size);
    const auto count = static_cast<std::uint32_t>(w.sorted.size());
    if (!resolve) {
        for (std::uint32_t i = 0; i < count; ++i)
            w.pieces.push_back({i});
        return;
    }
    w.tiles.make(w.ranges, size);
    w.components.walk(
        count,
        [&](std::uint32_t triangle, std::vector<std::uint32_t>& out) {
            w.find_needed(triangle, out, counts_);
        },
        [&](std::span<const std::uint32_t> component) {
            if (component.size() == 1) {
                w.pieces.push_back({component.front()});
                return;
            }
            ++counts_.knots;
            counts_.knotted += static_cast<std::int64_t>(component.size());
            w.knot.untie(size, w.sorted, component, w.pieces, w.cuts);
        });
    counts_.cuts = static_cast<std::int64_t>(w.cuts.size()) / 2;
}

std::span<const l3d_painter_triangle> l3d_painter_order::triangles() const {
    return work_->sorted;
}

std::span<const l3d_painter_piece> l3d_painter_order::pieces() const {
    return work_->pieces;
}

std::span<const l3d_painter_cut> l3d_painter_order::cuts() const {
    return work_->cuts;
}
