// SPDX-License-Identifier: MIT
// l3d_painter_order: keys, tiles, and the walk over what hides what.
#include "pipeline/polygons/painter_order.h"

#include "geom/radix_sort.h"
#include "pipeline/polygons/painter_components_p.h"
#include "pipeline/polygons/painter_knot_p.h"
#include "pipeline/polygons/painter_overlap_p.h"
#include "pipeline/polygons/painter_tiles_p.h"
#include "raster/parallel/chunks_p.h"

#include <algorithm>
#include <bit>
#include <vector>

namespace {

using namespace l3d_detail;

/// So many triangles are one item of a worker's work: some 10^4 cycles at the least.
constexpr std::size_t chunk_triangles = 1024;

/// Half-planes of a triangle, as the fill rule has them: what is on an edge counts as if it lay a
/// little to the right and, less so, below.
class inside_test {
public:
    /// Expects: area2 is not 0.
    inside_test(const std::array<l3d_micro_vertex, 3>& v, std::int64_t area2) {
        const std::int64_t sign = area2 > 0 ? 1 : -1;
        for (std::size_t i = 0; i < 3; ++i) {
            const l3d_micro_vertex &a = v[i], &b = v[(i + 1) % 3];
            edge& of = edges_[i];
            of = {sign * (std::int64_t{b.x} - a.x), sign * (std::int64_t{b.y} - a.y), a.x, a.y, 0};
            of.least = of.dy < 0 || (of.dy == 0 && of.dx > 0) ? 0 : 1;
        }
    }

    bool has(std::int32_t column, std::int32_t row) const {
        constexpr std::int32_t half = l3d_subpixel_one / 2;
        const std::int64_t x = column * l3d_subpixel_one + half, y = row * l3d_subpixel_one + half;
        for (const edge& e : edges_)
            if (e.dx * (y - e.y) - e.dy * (x - e.x) < e.least)
                return false;
        return true;
    }

private:
    struct edge {
        std::int64_t dx, dy, x, y, least;
    };
    std::array<edge, 3> edges_;
};

/// Whether a triangle has an area and, if it can have few pixels, any of them. More are looked at
/// by who paints them.
bool may_have_pixels(const std::array<l3d_micro_vertex, 3>& v, const pixel_range& range) {
    constexpr std::int32_t few = 4;
    const std::int64_t area2 = (std::int64_t{v[1].x} - v[0].x) * (std::int64_t{v[2].y} - v[0].y) -
                               (std::int64_t{v[1].y} - v[0].y) * (std::int64_t{v[2].x} - v[0].x);
    if (area2 == 0)
        return false;
    if (range.right - range.left > few || range.bottom - range.top > few)
        return true;
    const inside_test inside(v, area2);
    for (std::int32_t row = range.top; row < range.bottom; ++row)
        for (std::int32_t column = range.left; column < range.right; ++column)
            if (inside.has(column, row))
                return true;
    return false;
}

bool has_area(const std::array<l3d_micro_vertex, 3>& v) {
    return (std::int64_t{v[1].x} - v[0].x) * (std::int64_t{v[2].y} - v[0].y) !=
           (std::int64_t{v[1].y} - v[0].y) * (std::int64_t{v[2].x} - v[0].x);
}

/// `triangle` must be painted after `before`, which is later in the sorted order.
struct late_need {
    std::uint32_t triangle, before;
};

/// What a row of tiles found.
struct row_of_needs {
    std::vector<late_need> found;
    std::int64_t pairs = 0; ///< compared
};

} // namespace

struct l3d_painter_order::work_space {
    explicit work_space(l3d_workers& by) : workers(by) {}

    l3d_workers& workers;
    std::vector<l3d_sort_item> keys, other_keys;
    std::vector<std::size_t> kept; ///< of each chunk's keys
    std::span<const l3d_painter_triangle> given;
    std::vector<pixel_range> ranges; ///< of those that are sorted, in their order
    std::vector<std::uint32_t> knot_members;
    painter_tiles tiles;
    std::vector<row_of_needs> rows;
    std::vector<std::uint32_t> late, late_begins; ///< what each triangle needs of the later ones
    ordered_components components;
    painter_knot knot;
    std::vector<l3d_painter_piece> pieces;
    std::vector<l3d_painter_cut> cuts;

    /// By the farthest corner, as positive floats are ordered like their bits.
    void sort(l3d_size size, bool with_sides) {
        keys.resize(given.size());
        kept.resize(chunks_of(given.size(), chunk_triangles));
        for_each_chunk(workers, given.size(), chunk_triangles,
                       [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                           std::size_t to = begin;
                           for (std::size_t i = begin; i < end; ++i) {
                               const auto& v = given[i].v;
                               const pixel_range range = range_of(v, size);
                               if (!range.empty() &&
                                   (with_sides ? has_area(v) : may_have_pixels(v, range)))
                                   keys[to++] = {std::bit_cast<std::uint32_t>(range.farthest),
                                                 static_cast<std::uint32_t>(i)};
                           }
                           kept[chunk] = to - begin;
                       });
        auto end = keys.begin();
        for (std::size_t chunk = 0; chunk < kept.size(); ++chunk) {
            const auto from = keys.begin() + static_cast<std::ptrdiff_t>(chunk * chunk_triangles);
            end = std::copy(from, from + static_cast<std::ptrdiff_t>(kept[chunk]), end);
        }
        keys.erase(end, keys.end());
        l3d_radix_sort(keys, other_keys);
    }

    void find_ranges(l3d_size size) {
        ranges.resize(keys.size());
        for_each_chunk(workers, keys.size(), chunk_triangles,
                       [&](std::size_t begin, std::size_t end_of, std::size_t) {
                           for (std::size_t i = begin; i < end_of; ++i)
                               ranges[i] = range_of(at(static_cast<std::uint32_t>(i)), size);
                       });
    }

    /// The corners of a triangle, by its place in the sorted order.
    const std::array<l3d_micro_vertex, 3>& at(std::uint32_t sorted) const {
        return given[keys[sorted].index].v;
    }

    /// Whether a triangle must be painted after another, whose box it meets: it is in front of it
    /// somewhere.
    bool needs(std::uint32_t triangle, std::uint32_t other) const {
        return insides_meet(at(triangle), at(other)) &&
               (ranges[other].nearest <= ranges[triangle].farthest ||
                front_of(at(triangle), at(other)).first);
    }

    /// Finds what each triangle needs of those that are sorted after it.
    void find_late() {
        rows.resize(static_cast<std::size_t>(tiles.rows()));
        workers.for_each(tiles.rows(), [&](int row, int) { find_late(row); });
        // A stable sort by counting, so the order does not depend on who found what.
        late_begins.assign(keys.size() + 2, 0);
        for (const row_of_needs& row : rows)
            for (const late_need& need : row.found)
                ++late_begins[need.triangle + 2];
        for (std::size_t i = 2; i < late_begins.size(); ++i)
            late_begins[i] += late_begins[i - 1];
        late.resize(late_begins.back());
        for (const row_of_needs& row : rows)
            for (const late_need& need : row.found)
                late[late_begins[need.triangle + 1]++] = need.before;
    }

    void find_late(int row) {
        row_of_needs& to = rows[static_cast<std::size_t>(row)];
        to.found.clear();
        to.pairs = 0;
        for (int column = 0; column < tiles.columns(); ++column) {
            const painter_tile tile = tiles.tile(column, row);
            const std::span<const std::uint32_t> members = tiles.members(tile);
            for (std::size_t i = 0; i < members.size(); ++i) {
                const pixel_range& own = ranges[members[i]];
                for (const std::uint32_t other : members.subspan(i + 1)) {
                    const pixel_range& range = ranges[other];
                    if (range.farthest >= own.nearest)
                        break; // wholly in front, and so are all that follow
                    if (!tiles.first_meet(tile, own, range))
                        continue;
                    ++to.pairs;
                    if (needs(members[i], other))
                        to.found.push_back({members[i], other});
                }
            }
        }
    }

    /// Adds what a triangle needs of those that are sorted before it and wait for something.
    void find_early(std::uint32_t triangle, std::vector<std::uint32_t>& out,
                    l3d_painter_order_counts& counts) {
        const pixel_range& own = ranges[triangle];
        const auto emitted = [&](std::uint32_t i) { return components.emitted(i); };
        tiles.for_each(own, [&](const painter_tile& tile) {
            for (const std::uint32_t i : tiles.rest(tile, emitted)) {
                if (i >= triangle)
                    break;
                if (!tiles.first_meet(tile, own, ranges[i]) || emitted(i))
                    continue;
                ++counts.pairs;
                if (needs(triangle, i))
                    out.push_back(i);
            }
        });
    }

    /// Adds what must be painted before a triangle: those that it is in front of somewhere.
    void find_needed(std::uint32_t triangle, bool in_turn, std::vector<std::uint32_t>& out,
                     l3d_painter_order_counts& counts) {
        if (!in_turn)
            find_early(triangle, out, counts);
        out.insert(out.end(), late.begin() + late_begins[triangle],
                   late.begin() + late_begins[triangle + 1]);
    }
};

l3d_painter_order::l3d_painter_order(l3d_workers& workers)
    : work_(std::make_unique<work_space>(workers)) {}

l3d_painter_order::~l3d_painter_order() = default;

void l3d_painter_order::make(std::span<const l3d_painter_triangle> triangles, l3d_size size,
                             const way& how) {
    work_space& w = *work_;
    counts_ = {};
    counts_.triangles = static_cast<std::int64_t>(triangles.size());
    w.pieces.clear();
    w.cuts.clear();
    w.given = triangles;
    w.sort(size, how.sides);
    const auto count = static_cast<std::uint32_t>(w.keys.size());
    if (!how.resolve) {
        for (const l3d_sort_item& key : w.keys)
            w.pieces.push_back({key.index});
        return;
    }
    w.find_ranges(size);
    w.tiles.make(w.ranges, size, w.workers);
    w.find_late();
    for (const row_of_needs& row : w.rows)
        counts_.pairs += row.pairs;
    w.components.walk(
        count,
        [&](std::uint32_t triangle, bool in_turn, std::vector<std::uint32_t>& out) {
            w.find_needed(triangle, in_turn, out, counts_);
        },
        [&](std::span<const std::uint32_t> component) {
            if (component.size() == 1) {
                w.pieces.push_back({w.keys[component.front()].index});
                return;
            }
            ++counts_.knots;
            counts_.knotted += static_cast<std::int64_t>(component.size());
            w.knot_members.clear();
            for (const std::uint32_t member : component)
                w.knot_members.push_back(w.keys[member].index);
            w.knot.untie(size, w.given, w.knot_members, w.pieces, w.cuts);
        });
    counts_.cuts = static_cast<std::int64_t>(w.cuts.size()) / 2;
}

std::span<const l3d_painter_triangle> l3d_painter_order::triangles() const {
    return work_->given;
}

std::span<const l3d_painter_piece> l3d_painter_order::pieces() const {
    return work_->pieces;
}

std::span<const l3d_painter_cut> l3d_painter_order::cuts() const {
    return work_->cuts;
}
