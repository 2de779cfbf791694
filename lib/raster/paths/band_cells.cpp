// SPDX-License-Identifier: MIT
// band_cells: cuts edges at rows and columns, and finds pixels that outlines pass more than once.
#include "raster/paths/band_cells_p.h"

#include "raster/paths/area_values_p.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include <hwy/base.h>

namespace l3d_detail {

namespace {

constexpr std::int32_t whole(double x) {
    return static_cast<std::int32_t>(x);
}

/// An edge in the direction of its outline, in the rows of a band.
struct band_edge {
    l3d_point_2d from, to;           ///< the edge's ends, which may lie beyond the band
    double x, y, end_x, end_y;       ///< the ends of the edge's part in the band
    bool begins = true, ends = true; ///< whether the edge's beginning and end lie in the band

    /// If borders of rows cut the edge: the change of x from row to row, and the least and the
    /// largest x of its ends.
    double slope = 0, least = 0, most = 0;

    band_edge(const l3d_point_2d& first, const l3d_point_2d& last)
        : from(first), to(last), x(from.x), y(from.y), end_x(to.x), end_y(to.y) {}

    bool leads_up() const { return to.y < from.y; }

    /// Cuts the edge at the band's borders. Returns false if the edge lies outside of the band.
    bool clip(double top, double bottom) {
        const double upper = std::min(from.y, to.y), lower = std::max(from.y, to.y);
        if (lower <= top || upper >= bottom)
            return false;
        if (upper < top || lower > bottom) {
            set_slope();
            const auto cut = [&](double& at_x, double& at_y) {
                const bool is_cut = at_y < top || at_y > bottom;
                if (is_cut)
                    at_x = x_at(at_y = at_y < top ? top : bottom);
                return !is_cut;
            };
            begins = cut(x, y);
            ends = cut(end_x, end_y);
        }
        return true;
    }
    void set_slope() {
        slope = (to.x - from.x) / (to.y - from.y);
        least = std::min(from.x, to.x);
        most = std::max(from.x, to.x);
    }
    /// The edge's x at a border of rows. Rounding never puts this x beyond the edge's ends.
    double x_at(double border) const {
        return std::min(std::max(from.x + (border - from.y) * slope, least), most);
    }
    /// The edge's dy / dx. Expects: the ends differ in x.
    double steepness() const { return (to.y - from.y) / (to.x - from.x); }
};

/// The part of an edge in a row, in the direction of its outline, and the columns of its ends.
struct row_part {
    double x, y, end_x, end_y;
    std::int32_t column, end_column;
};

} // namespace

void band_cells::begin(const l3d_pixel_box& reached, const fill_rules& rules) {
    rules_ = rules;
    left_ = reached.left;
    right_ = reached.right;
    // An edge on the right side of the last column adds to the next one.
    stride_ = (static_cast<std::size_t>(right_ - left_) + 1 + group) / group * group;
    constexpr std::size_t most_cells = 1 << 16; // 1.5 MB for a layer, which caches hold
    const std::size_t height = static_cast<std::size_t>(reached.bottom - reached.top);
    const std::size_t rows = std::clamp<std::size_t>(most_cells / stride_, 1, height);
    rows_ = static_cast<std::int32_t>(rows);
    const std::size_t needed = rows * stride_;
    words_ = (stride_ / group + 63) / 64;
    if (groups_.size() < rows * words_)
        groups_.resize(rows * words_, 0);
    if (sums_.size() < stride_)
        sums_.resize(stride_);
    for (std::size_t layer = 0; layer < (rules.clips ? 2U : 1U); ++layer)
        if (cells_[layer].size() < needed)
            cells_[layer].resize(needed, cell{});
}

void band_cells::begin_band(std::int32_t top, std::int32_t bottom) {
    top_ = top;
    bottom_ = bottom;
    records_.clear();
    records_.push({}); // the index 0 means none
}

/// A walk along an outline, which adds its edges to the pixels that they pass.
struct band_cells::walk {
    enum way : std::uint32_t { none = 0, up = 1, down = 2, to_left = 4, to_right = 8, all = 15 };

    cell* const cells;
    std::uint64_t* const groups;
    const std::ptrdiff_t stride, words;
    const std::int32_t left, top;
    const double band_top, band_bottom;
    edge_record* records = nullptr; ///< the records of all edges, and room for more
    std::uint32_t used;             ///< the number of records

    cell* here = nullptr;    ///< the pixel that the outline has reached
    std::uint32_t edges = 0; ///< the number of the outline's edges in this pixel
    std::uint32_t ways = 0;  ///< the directions in which these edges run, as bits of `way`

    /// Adds an edge's part in a pixel. `right` is the distance from the part's middle to the
    /// pixel's right side.
    HWY_INLINE void put(cell& at, double x, double y, double end_x, double end_y, double right,
                        std::uint32_t edge) {
        const double height = y - end_y;
        at.cover += height;
        at.area += height * right;
        ++at.visits;
        records[used] = {{x, y}, {end_x, end_y}, at.last, edge};
        at.last = used++;
    }

    /// Adds an edge's part in a row. `at` is the pixel where it begins. Returns the pixel where it
    /// ends.
    HWY_INLINE cell* add_part(cell* at, const row_part& p, double steepness, std::uint32_t edge) {
        if (p.column == p.end_column) {
            put(*at, p.x, p.y, p.end_x, p.end_y, p.column + 1 - (p.x + p.end_x) / 2, edge);
            return at;
        }
        double x = p.x, y = p.y;
        if (p.column < p.end_column) {
            for (double side = p.column + 1; side <= p.end_column; side += 1, ++at) {
                const double next = p.y + (side - p.x) * steepness;
                put(*at, x, y, side, next, (side - x) / 2, edge);
                x = side;
                y = next;
                edge = (edge & ~edge_record::marks) |
                       static_cast<std::uint32_t>(cell_begin::enters_left);
            }
            put(*at, x, y, p.end_x, p.end_y, 1 - (p.end_x - x) / 2, edge);
        } else {
            for (double side = p.column; side > p.end_column; side -= 1, --at) {
                const double next = p.y + (side - p.x) * steepness;
                put(*at, x, y, side, next, 1 - (x - side) / 2, edge | edge_record::leaves_left);
                x = side;
                y = next;
                edge &= ~edge_record::marks;
            }
            put(*at, x, y, p.end_x, p.end_y, (x - p.end_x) / 2, edge);
        }
        return at;
    }

    /// Marks the groups that hold columns `first` to `last` of a row.
    static HWY_INLINE void mark(std::uint64_t* row, std::int32_t first, std::int32_t last) {
        constexpr std::uint32_t bits = 64;
        auto g = static_cast<std::uint32_t>(first) / static_cast<std::uint32_t>(group);
        auto end = static_cast<std::uint32_t>(last) / static_cast<std::uint32_t>(group);
        row[g / bits] |= std::uint64_t{1} << (g % bits);
        if (g == end)
            return;
        if (g > end)
            std::swap(g, end);
        for (; g <= end; ++g)
            row[g / bits] |= std::uint64_t{1} << (g % bits);
    }

    /// The directions in which an edge runs.
    static std::uint32_t ways_of(const l3d_point_2d& from, const l3d_point_2d& to) {
        return (to.y < from.y ? up : none) | (from.y < to.y ? down : none) |
               (from.x < to.x ? to_right : none) | (to.x < from.x ? to_left : none);
    }

    /// Notes that the outline's next edge begins in a pixel, and returns the way by which the
    /// outline got into this pixel.
    HWY_INLINE cell_begin come_to(cell* pixel, const l3d_point_2d* corner, bool is_begin) {
        if (pixel != here) {
            edges = 1;
            if (!is_begin)
                return cell_begin::enters;
            pixel->visits = unclear_visits;
            return cell_begin::unclear;
        }
        // Edges in a pixel do not cross each other if all lead up, or all down, or all to the left,
        // or all to the right. Two successive edges never do.
        if (++edges > 2) {
            if (edges == 3)
                ways = ways_of(corner[-2], corner[-1]) | ways_of(corner[-1], corner[0]);
            ways |= ways_of(corner[0], corner[1]);
            if (ways == all) {
                pixel->visits = unclear_visits;
                return cell_begin::unclear;
            }
        }
        --pixel->visits;
        return cell_begin::continues;
    }

    /// Adds the edge that begins at a corner.
    template <bool clips>
    HWY_INLINE void add(const l3d_point_2d* corner, std::uint32_t index, bool is_first) {
        band_edge e(corner[0], corner[1]);
        if (clips && !e.clip(band_top, band_bottom)) {
            here = nullptr;
            return;
        }
        // An edge that begins or ends at a border of rows does so in the row that it reaches.
        const bool is_up = e.leads_up();
        std::int32_t row = whole(e.y), last_row = whole(e.end_y);
        std::int32_t& lower = is_up ? row : last_row;
        lower -= lower >= (is_up ? e.y : e.end_y) ? 1 : 0;
        if (is_up ? row < last_row : last_row < row) { // a level edge between two rows
            here = nullptr;
            return;
        }
        const std::int32_t end_column = whole(e.end_x);
        row_part p{e.x, e.y, e.end_x, e.end_y, whole(e.x), end_column};
        cell* at = cells + (row - top) * stride + (p.column - left);
        const cell_begin begin = come_to(at, corner, is_first && e.begins);
        std::uint32_t edge = index << edge_record::mark_bits | static_cast<std::uint32_t>(begin);
        const double steepness = p.column == end_column ? 0 : e.steepness();
        std::uint64_t* marks = groups + (row - top) * words;
        if (row != last_row) {
            e.set_slope();
            const std::int32_t step = is_up ? -1 : 1;
            const std::ptrdiff_t next_words = step * words, next_row = step * stride;
            for (double border = is_up ? row : row + 1; row != last_row; row += step) {
                p.end_y = border;
                p.end_x = e.x_at(border);
                p.end_column = whole(p.end_x);
                mark(marks, p.column - left, p.end_column - left);
                at = add_part(at, p, steepness, edge) + next_row;
                edge &= ~edge_record::marks;
                marks += next_words;
                border += step;
                p.x = p.end_x;
                p.y = p.end_y;
                p.column = p.end_column;
            }
            p.end_x = e.end_x;
            p.end_y = e.end_y;
            p.end_column = end_column;
            edges = 1;
        }
        if (p.column != end_column)
            edges = 1;
        mark(marks, p.column - left, end_column - left);
        at = add_part(at, p, steepness, edge);
        here = e.ends ? at : nullptr;
    }
};

void band_cells::add(const path_chains::outline& outline, const l3d_point_2d* all,
                     const path_chains::block* blocks) {
    corners_ = all;
    walk w{cells_[outline.layer].data(),
           groups_.data(),
           static_cast<std::ptrdiff_t>(stride_),
           static_cast<std::ptrdiff_t>(words_),
           left_,
           top_,
           static_cast<double>(top_),
           static_cast<double>(bottom_),
           nullptr,
           static_cast<std::uint32_t>(records_.size())};
    const std::size_t most_parts = static_cast<std::size_t>(rows_) + stride_;
    const std::size_t first = outline.first_block;
    for (std::size_t b = first; b < first + outline.blocks; ++b) {
        const path_chains::block& block = blocks[b];
        if (block.bottom <= top_ || block.top >= bottom_) {
            w.here = nullptr;
            continue;
        }
        const std::uint32_t begin = block.first, end = block.end;
        records_.keep(w.used);
        w.records = records_.room((end - begin) * most_parts) - w.used;
        if (block.top >= top_ && block.bottom <= bottom_)
            for (std::uint32_t i = begin; i < end; ++i)
                w.add<false>(all + i, i, i == blocks[first].first);
        else
            for (std::uint32_t i = begin; i < end; ++i)
                w.add<true>(all + i, i, i == blocks[first].first);
    }
    records_.keep(w.used);
}

void band_cells::write(span_writer& to) {
    for (std::int32_t row = top_; row < bottom_; ++row)
        write_row(row, to);
}

void band_cells::write_row(std::int32_t row, span_writer& to) {
    const auto r = static_cast<std::size_t>(row - top_);
    std::array<double, 2> cover{};
    std::size_t done = 0;
    const auto column = [this](std::size_t of) { return left_ + static_cast<std::int32_t>(of); };
    const auto fill = [&](std::size_t end) {
        // In a gap between edges, the winding number does not change, so its integral is a whole
        // number except for rounding.
        const windings w{
            {static_cast<int>(std::lrint(cover[0])), static_cast<int>(std::lrint(cover[1]))}};
        cover = {static_cast<double>(w.turns[0]), static_cast<double>(w.turns[1])};
        if (rules_.inside(w))
            to.add_solid(row, column(done), column(end), to.value_of(1));
    };
    for (std::size_t word = 0; word < words_; ++word)
        for (std::uint64_t marks = std::exchange(groups_[r * words_ + word], 0); marks != 0;) {
            const int begin = std::countr_zero(marks), count = std::countr_one(marks >> begin);
            const std::size_t at = group * (64 * word + static_cast<std::size_t>(begin));
            const std::size_t end = at + group * static_cast<std::size_t>(count);
            marks = begin + count < 64 ? marks >> (begin + count) << (begin + count) : 0;
            if (at > done)
                fill(at);
            if (rules_.clips)
                find_clipped(r * stride_ + at, r * stride_ + end, cover);
            else
                find_sums(r * stride_ + at, r * stride_ + end, cover[0]);
            find_values(sums_.data(), end - at,
                        rules_.clips || rules_.rule[0] == l3d_winding::nonzero, to.full(),
                        to.add_values(row, column(at), column(end)));
            done = end;
        }
    if (done < stride_)
        fill(stride_);
}

/// Finds the integrals of the winding number for a run of pixels in a row. On entry, `cover` is the
/// integral down the run's left side; on return, it is the integral down the right side.
void band_cells::find_sums(std::size_t at, std::size_t end, double& cover) {
    double sum = cover;
    for (double* sums = sums_.data(); at < end; at += group, sums += group) {
        cell* const cells = cells_[0].data() + at;
        std::array<double, group> here;
        std::uint32_t visits = 0;
        for (std::size_t i = 0; i < group; ++i) {
            here[i] = sum + cells[i].area;
            sum += cells[i].cover;
            visits |= cells[i].visits;
        }
        std::copy(here.begin(), here.end(), sums);
        if (visits > 1)
            find_exact(at, sums);
        std::fill_n(cells, group, cell{});
    }
    cover = sum;
}

/// Replaces integrals by areas in the pixels of a group that outlines pass several times.
void band_cells::find_exact(std::size_t at, double* sums) {
    for (std::size_t i = 0; i < group; ++i)
        if (const std::uint32_t visits = cells_[0][at + i].visits; visits > 1)
            sums[i] = exact(at + i, visits, {sums[i], 0});
}

/// Finds the covered areas of a run of pixels in a row, if there is a clip path, too.
void band_cells::find_clipped(std::size_t at, std::size_t end, std::array<double, 2>& cover) {
    for (double* area = sums_.data(); at < end; ++at, ++area) {
        std::array<double, 2> sums;
        for (std::size_t layer = 0; layer < 2; ++layer) {
            sums[layer] = cover[layer] + cells_[layer][at].area;
            cover[layer] += cells_[layer][at].cover;
        }
        const std::uint32_t visits = cells_[0][at].visits + cells_[1][at].visits;
        *area = visits > 1 ? exact(at, visits, sums)
                           : area_inside(sums[0], rules_.rule[0] == l3d_winding::nonzero) *
                                 area_inside(sums[1], rules_.rule[1] == l3d_winding::nonzero);
        cells_[0][at] = cells_[1][at] = {};
    }
}

/// The covered area of a pixel that outlines pass several times, or an integral from which the area
/// follows by area_inside().
double band_cells::exact(std::size_t at, std::uint32_t visits, const std::array<double, 2>& sums) {
    // Each visit adds at most 1 to the sum. So the winding number is above 0 everywhere in the
    // pixel if the sum is as large as the number of visits.
    constexpr double slack = 1e-9; // far above rounding
    if (!rules_.clips && rules_.rule[0] == l3d_winding::nonzero && visits < unclear_visits &&
        std::abs(sums[0]) >= visits - slack)
        return 1;
    const std::uint32_t last = cells_[0][at].last;
    if (!rules_.clips && visits == 2) {
        // Two successive edges do not cross. If their corner lies outside the pixel, the winding
        // number is the same on both sides of the strip between them, and the sum tells the area.
        const edge_record &second = records_[last], &first = records_[second.before];
        if (first.before == 0 && second.index() == first.index() + 1)
            return sums[0];
    }
    const l3d_point_2d corner{left_ + static_cast<double>(at % stride_),
                              top_ + static_cast<double>(at / stride_)};
    pixel_.begin();
    for (std::size_t layer = 0; layer < (rules_.clips ? 2U : 1U); ++layer)
        pixel_.add(records_.data(), cells_[layer][at].last, layer);
    return pixel_.inside(corner, sums, visits, rules_);
}

} // namespace l3d_detail
