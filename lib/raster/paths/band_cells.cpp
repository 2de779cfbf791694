// SPDX-License-Identifier: MIT
// band_cells: edges cut at rows and columns, and the pixels that outlines pass more than once.
#include "raster/paths/band_cells_p.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace l3d_detail {

namespace {

/// Pixels whose values are found together. Their visits are the bytes of a word.
constexpr std::size_t group = 8;
/// The number of visits of pixels where it is not known, or an outline may cross itself.
constexpr std::uint8_t unclear = 255;
constexpr std::size_t nowhere = ~std::size_t{0};

constexpr std::int32_t whole(double x) {
    return static_cast<std::int32_t>(x);
}

/// An edge in a band, from top to bottom, cut off at the band's borders.
struct band_edge {
    l3d_point_2d top, bottom; ///< its ends, which may lie beyond the band
    bool is_up;               ///< whether the outline leads upwards
    std::int32_t first, last; ///< the rows that it reaches
    double begin, end;        ///< the heights between which it is in the band
    double slope = 0;         ///< x by y; 0 if it is not needed
    double x, end_x;          ///< x at `begin` and at `end`

    band_edge(const l3d_point_2d& from, const l3d_point_2d& to, std::int32_t band_top,
              std::int32_t band_bottom)
        : is_up(to.y < from.y) {
        top = is_up ? to : from;
        bottom = is_up ? from : to;
        begin = std::max<double>(top.y, band_top);
        end = std::min<double>(bottom.y, band_bottom);
        first = whole(begin);
        last = whole(end);
        last -= last == end ? 1 : 0;
        x = top.x;
        end_x = bottom.x;
        if (first < last || begin != top.y || end != bottom.y) {
            slope = (bottom.x - top.x) / (bottom.y - top.y);
            x = x_at(begin);
            end_x = x_at(end);
        }
    }

    /// Whether it has a point between rows' borders.
    bool is_seen() const { return first <= last; }
    /// x at a height within it. Rounding never puts it beyond its ends.
    double x_at(double y) const {
        if (y == top.y)
            return top.x;
        if (y == bottom.y)
            return bottom.x;
        const double at = top.x + (y - top.y) * slope;
        return top.x < bottom.x ? std::clamp(at, top.x, bottom.x)
                                : std::clamp(at, bottom.x, top.x);
    }
    /// y by x.
    double steepness() const { return (bottom.y - top.y) / (bottom.x - top.x); }
    int direction() const { return is_up ? 1 : -1; }
};

/// The part of an edge in a row, from top to bottom.
struct row_part {
    double x, y, end_x, end_y;

    row_part(const band_edge& of, std::int32_t row)
        : x(of.x), y(of.begin), end_x(of.end_x), end_y(of.end) {
        if (row > of.first)
            x = of.x_at(y = row);
        if (row < of.last)
            end_x = of.x_at(end_y = row + 1);
    }
    /// The height at which it crosses a side of columns.
    double y_at(double side, double steepness) const {
        return std::clamp(y + (side - x) * steepness, y, end_y);
    }
};

} // namespace

void band_cells::begin(const l3d_pixel_box& reached, const fill_rules& rules) {
    rules_ = rules;
    left_ = reached.left;
    right_ = reached.right;
    // An edge on the right side of the last column adds to the next one.
    stride_ = (static_cast<std::size_t>(right_ - left_) + 1 + group) / group * group;
    constexpr std::size_t most_cells = 1 << 16; // 1 MB for a layer, which caches hold
    const std::size_t height = static_cast<std::size_t>(reached.bottom - reached.top);
    const std::size_t rows = std::clamp<std::size_t>(most_cells / stride_, 1, height);
    rows_ = static_cast<std::int32_t>(rows);
    const std::size_t needed = rows * stride_;
    for (std::size_t layer = 0; layer < (rules.clips ? 2U : 1U); ++layer)
        if (cells_[layer].size() < needed)
            cells_[layer].resize(needed, cell{});
    if (visits_.size() < needed) {
        visits_.resize(needed, 0);
        last_.resize(needed, 0);
    }
}

void band_cells::begin_band(std::int32_t top, std::int32_t bottom) {
    top_ = top;
    bottom_ = bottom;
    records_.clear();
    records_.push({}); // the index 0 means none
}

/// A walk along an outline.
struct band_cells::walk {
    enum way : std::uint8_t { up = 1, down = 2, to_left = 4, to_right = 8, all = 15 };

    cell* const cells;
    std::uint8_t* const visits;
    std::uint32_t* const last;
    const std::size_t stride;
    const std::int32_t left, top, bottom;
    const std::uint8_t layer;
    record* records = nullptr; ///< room for more
    std::uint32_t used;        ///< the number of records

    std::size_t here = nowhere; ///< the pixel that the outline has reached
    std::uint32_t edges = 0;    ///< the number of its edges there
    std::uint8_t ways = 0;      ///< the directions in which they run, as bits of `way`

    std::size_t pixel_at(std::int32_t row, double x) const {
        return static_cast<std::size_t>(row - top) * stride +
               static_cast<std::size_t>(whole(x) - left);
    }

    /// Adds an edge's part in a pixel. `x` is its middle, seen from the pixel's left side.
    void put(std::size_t at, double height, double x, std::uint32_t edge, cell_begin begin) {
        cells[at].cover += height;
        cells[at].area += height - height * x;
        visits[at] = static_cast<std::uint8_t>(visits[at] + (visits[at] < unclear ? 1 : 0));
        records[0] = {last[at], edge, begin, layer};
        ++records;
        last[at] = used++;
    }

    void add_part(const row_part& p, std::size_t row, int direction, double steepness,
                  std::uint32_t edge, cell_begin begin) {
        const std::int32_t first = whole(p.x), end = whole(p.end_x);
        std::size_t at = row + static_cast<std::size_t>(first - left);
        if (first == end)
            return put(at, direction * (p.end_y - p.y), (p.x + p.end_x) / 2 - first, edge, begin);
        double x = p.x, y = p.y;
        std::int32_t column = first;
        if (first < end) {
            for (; column < end; ++column, ++at) {
                const double next = p.y_at(column + 1, steepness);
                put(at, direction * (next - y), (x - column + 1) / 2, edge, begin);
                x = column + 1;
                y = next;
            }
        } else {
            for (; column > end; --column, --at) {
                const double next = p.y_at(column, steepness);
                put(at, direction * (next - y), (x - column) / 2, edge, begin);
                x = column;
                y = next;
            }
        }
        put(at, direction * (p.end_y - y), (x + p.end_x) / 2 - column, edge, begin);
    }

    void add(const l3d_point_2d& from, const l3d_point_2d& to, std::uint32_t edge, bool is_first,
             kept_list<record>& list) {
        if (std::max(from.y, to.y) <= top || std::min(from.y, to.y) >= bottom) {
            here = nowhere;
            return;
        }
        const band_edge e(from, to, top, bottom);
        if (!e.is_seen()) { // it is level, on a border of rows
            here = nowhere;
            return;
        }
        const std::size_t upper = pixel_at(e.first, e.x), lower = pixel_at(e.last, e.end_x);
        const bool begins = e.is_up ? e.end == from.y : e.begin == from.y;
        const bool ends = e.is_up ? e.begin == to.y : e.end == to.y;
        const std::size_t start = e.is_up ? lower : upper, stop = e.is_up ? upper : lower;
        const auto runs = static_cast<std::uint8_t>((to.y < from.y   ? up
                                                     : from.y < to.y ? down
                                                                     : 0) |
                                                    (from.x < to.x   ? to_right
                                                     : to.x < from.x ? to_left
                                                                     : 0));
        cell_begin begin = cell_begin::enters;
        if (start == here) {
            // Where edges in a pixel all lead up, down, to the left or to the right, they do not
            // cross each other. Two that follow each other never do.
            ++edges;
            ways |= runs;
            if (edges > 2 && ways == all) {
                begin = cell_begin::unclear;
                visits[start] = unclear;
            } else {
                begin = cell_begin::continues;
                --visits[start];
            }
        } else {
            edges = 1;
            ways = runs;
            if (is_first && begins) {
                begin = cell_begin::unclear;
                visits[start] = unclear;
            }
        }
        if (start != stop) {
            edges = 1;
            ways = runs;
        }
        here = ends ? stop : nowhere;
        const auto columns = static_cast<std::size_t>(std::abs(whole(e.end_x) - whole(e.x)));
        list.keep(used);
        records = list.room(static_cast<std::size_t>(e.last - e.first) + 2 + columns);
        const double steepness = columns > 0 ? e.steepness() : 0;
        std::size_t row = static_cast<std::size_t>(e.first - top) * stride;
        for (std::int32_t r = e.first; r <= e.last; ++r, row += stride)
            add_part(row_part(e, r), row, e.direction(), steepness, edge, begin);
    }
};

void band_cells::add(const path_chains::outline& outline, const l3d_point_2d* all,
                     const path_chains::block* blocks) {
    corners_ = all;
    walk w{cells_[outline.layer].data(),
           visits_.data(),
           last_.data(),
           stride_,
           left_,
           top_,
           bottom_,
           outline.layer,
           nullptr,
           static_cast<std::uint32_t>(records_.size())};
    const std::size_t first = outline.first_block;
    for (std::size_t b = first; b < first + outline.blocks; ++b) {
        const path_chains::block& block = blocks[b];
        if (block.bottom <= top_ || block.top >= bottom_) {
            w.here = nowhere;
            continue;
        }
        for (std::uint32_t i = block.first; i < block.end; ++i)
            w.add(all[i], all[i + 1], i, i == blocks[first].first, records_);
    }
    records_.keep(w.used);
}

void band_cells::write(span_writer& to) {
    for (std::int32_t row = top_; row < bottom_; ++row)
        write_row(row, to);
}

void band_cells::write_row(std::int32_t row, span_writer& to) {
    const std::size_t begin = static_cast<std::size_t>(row - top_) * stride_;
    const auto is_passed = [&](std::size_t at) {
        std::uint64_t word;
        std::memcpy(&word, visits_.data() + begin + at, group);
        return word != 0;
    };
    std::array<double, 2> cover{};
    std::size_t done = 0;
    const auto fill = [&](std::size_t end) {
        // Windings do not change down a gap, so they are whole but for rounding.
        for (double& c : cover)
            c = std::rint(c);
        const windings w{{static_cast<int>(cover[0]), static_cast<int>(cover[1])}};
        if (done < end && rules_.inside(w))
            to.add_solid(row, left_ + static_cast<std::int32_t>(done),
                         left_ + static_cast<std::int32_t>(end), to.value_of(1));
    };
    for (std::size_t at = 0; at < stride_; at += group) {
        if (!is_passed(at))
            continue;
        std::size_t end = at + group;
        while (end < stride_ && is_passed(end))
            end += group;
        fill(at);
        std::uint8_t* values = to.add_values(row, left_ + static_cast<std::int32_t>(at),
                                             left_ + static_cast<std::int32_t>(end));
        for (; at < end; at += group, values += group)
            convert(begin + at, cover, values, to.full());
        done = end;
    }
    fill(stride_);
}

/// Finds the values of a group of pixels. `cover` are the integrals of the windings down its left
/// side, and then down its right side.
void band_cells::convert(std::size_t at, std::array<double, 2>& cover, std::uint8_t* values,
                         double full) {
    const std::size_t layers = rules_.clips ? 2 : 1;
    std::array<std::array<double, group>, 2> sums{};
    for (std::size_t layer = 0; layer < layers; ++layer) {
        cell* const cells = cells_[layer].data() + at;
        double sum = cover[layer];
        for (std::size_t i = 0; i < group; ++i) {
            sums[layer][i] = sum + cells[i].area;
            sum += cells[i].cover;
        }
        cover[layer] = sum;
        std::fill_n(cells, group, cell{});
    }
    std::uint64_t visits;
    std::memcpy(&visits, visits_.data() + at, group);
    constexpr std::uint64_t several = 0xfefefefefefefefe;
    if ((visits & several) != 0) {
        for (std::size_t i = 0; i < group; ++i)
            if (visits_[at + i] > 1) {
                sums[0][i] = exact(at + i, {sums[0][i], sums[1][i]});
                sums[1][i] = 1;
            }
    }
    std::memset(visits_.data() + at, 0, group);
    std::fill_n(last_.data() + at, group, 0);
    // The area inside, where windings take two values that follow each other.
    std::array<double, group> areas;
    areas.fill(1);
    for (std::size_t layer = 0; layer < layers; ++layer)
        if (rules_.rule[layer] == l3d_winding::nonzero)
            for (std::size_t i = 0; i < group; ++i)
                areas[i] *= std::min(std::abs(sums[layer][i]), 1.0);
        else
            for (std::size_t i = 0; i < group; ++i)
                areas[i] *= std::abs(sums[layer][i] - 2 * std::rint(sums[layer][i] / 2));
    for (std::size_t i = 0; i < group; ++i)
        values[i] = static_cast<std::uint8_t>(static_cast<std::int32_t>(areas[i] * full + 0.5));
}

/// The area inside of a pixel that outlines pass several times.
double band_cells::exact(std::size_t at, const std::array<double, 2>& sums) {
    // Each visit adds at most 1 to the sum, so the rest is above 0 wherever in the pixel.
    constexpr double slack = 1e-9; // far above rounding
    const std::uint8_t visits = visits_[at];
    if (!rules_.clips && rules_.rule[0] == l3d_winding::nonzero && visits < unclear &&
        std::abs(sums[0]) >= visits - slack)
        return 1;
    const std::int32_t row = top_ + static_cast<std::int32_t>(at / stride_);
    const std::int32_t column = left_ + static_cast<std::int32_t>(at % stride_);
    pixel_.begin(column);
    for (std::uint32_t i = last_[at]; i != 0; i = records_[i].before) {
        const record& r = records_[i];
        const l3d_point_2d &from = corners_[r.edge], &to = corners_[r.edge + 1];
        const band_edge e(from, to, top_, bottom_);
        const row_part p(e, row);
        const std::int32_t first = whole(p.x), last = whole(p.end_x);
        const bool is_start = e.is_up ? row == e.last && column == last && e.end == from.y
                                      : row == e.first && column == first && e.begin == from.y;
        l3d_point_2d top{p.x, p.y - row}, bottom{p.end_x, p.end_y - row};
        if (first != last) {
            const double steepness = e.steepness();
            const double entry = first < last ? column : column + 1;
            const double exit = first < last ? column + 1 : column;
            if (column != first)
                top = {entry, p.y_at(entry, steepness) - row};
            if (column != last)
                bottom = {exit, p.y_at(exit, steepness) - row};
        }
        // From left to right, an edge has this on its lower side, beyond what it has above.
        const std::int8_t below = column == std::min(first, last) ? 0 : from.x < to.x ? 1 : -1;
        pixel_.add({top, bottom,
                    static_cast<std::int8_t>(from.y == to.y ? 0 : e.direction()), r.layer, below,
                    is_start ? r.begin : cell_begin::enters});
    }
    return pixel_.inside(sums, rules_);
}

} // namespace l3d_detail
