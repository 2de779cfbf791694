// SPDX-License-Identifier: MIT
// l3d_painter_order: sorts by keys, tests tiles, and walks from items to those that they hide.
#include "pipeline/zsort/painter_order.h"

#include "geom/radix_sort.h"
#include "pipeline/zsort/painter_components_p.h"
#include "pipeline/zsort/painter_items_p.h"
#include "pipeline/zsort/cycle_cutter_p.h"
#include "pipeline/zsort/hidden_test_p.h"
#include "pipeline/zsort/painter_tiles_p.h"
#include "raster/parallel/chunks_p.h"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

namespace {

using namespace l3d_detail;

/// A need that the sort does not meet: one item must be painted after a second item, although the
/// sort puts the first before the second.
struct late_need {
    order_node item, before;

    std::pair<order_node, order_node> both() const { return {item, before}; }
};

/// The needs that were found in one row of tiles.
struct row_of_needs {
    std::vector<late_need> found;
    std::int64_t pairs = 0; ///< number of pairs of items that were compared
};

/// The members of a tile in sorted order. The object copies the members' cells and depths, which
/// decide most often whether two members are compared. Each worker has an object of its own, in
/// cache lines of its own, and writes to it at each member.
class alignas(128) sorted_members {
public:
    void sort(std::span<const painter_entry> members) {
        order_.clear();
        for (std::size_t i = 0; i < members.size(); ++i) // equals stay in rising order
            order_.push_back(bits_of(members[i].farthest) << 32 | i);
        std::ranges::sort(order_);
        cells_.clear();
        for (const std::uint64_t next : order_)
            cells_.push_back(members[next & 0xffffffff].cells);
        members_ = members;
    }

    /// Calls visit(member, later member) for each pair of members whose cells and ranges of depth
    /// meet.
    template <class Visit> void visit_pairs(const Visit& visit) const {
        // Local copies need not be read again after each visit.
        const std::span<const std::uint64_t> order(order_), cells(cells_);
        const std::span<const painter_entry> members = members_;
        for (std::size_t i = 0; i < order.size(); ++i) {
            const painter_entry& own = members[order[i] & 0xffffffff];
            const std::uint64_t own_cells = own.cells;
            const std::uint64_t end = bits_of(own.nearest) << 32; // later ones are wholly in front
            for (std::size_t k = i + 1; k < order.size() && order[k] < end; ++k)
                if ((cells[k] & own_cells) != 0)
                    visit(own, members[order[k] & 0xffffffff]);
        }
    }

private:
    /// The bits of a positive float, which are ordered like the float.
    static std::uint64_t bits_of(float number) { return std::bit_cast<std::uint32_t>(number); }

    std::span<const painter_entry> members_;
    /// A number for each member. Its upper half is the depth bits of the member's farthest corner;
    /// its lower half is the member's index.
    std::vector<std::uint64_t> order_;
    std::vector<std::uint64_t> cells_; ///< cells of the members, in the order of order_
};

} // namespace

struct l3d_painter_order::work_space {
    /// The number of items between the present item and the item that is prefetched. Sorted items
    /// lie anywhere in memory, and fetching an item takes some hundred cycles.
    static constexpr std::size_t ahead = 16;
    /// The number of pieces that a worker takes at a time, which costs some 10^4 cycles at least.
    static constexpr std::size_t chunk_pieces = 4096;
    /// In place of a piece's cut, marks a piece that has an item's number in place of a triangle's
    /// index. No cut has this index, since there are never so many cuts.
    static constexpr std::uint32_t of_item = l3d_painter_cut::last - 1;

    explicit work_space(l3d_workers& by)
        : workers(by), of_workers(static_cast<std::size_t>(by.count())) {}

    l3d_workers& workers;
    std::span<const l3d_painter_triangle> given;
    l3d_size size{};
    way how;
    painter_items items;
    painter_pairs pair_test{items};
    /// Keys and numbers of the items to sort, and memory for sorting.
    std::vector<l3d_sort_item> keys, other_keys;
    std::vector<std::uint32_t> knot_members;
    painter_tiles tiles;
    std::vector<sorted_members> of_workers;
    hidden_test sight;
    std::vector<row_of_needs> rows;
    std::vector<late_need> late; ///< all late needs, in rising order
    ordered_components components;
    cycle_cutter knot;
    std::vector<l3d_painter_piece> ordered; ///< pieces of items that need an order
    std::vector<l3d_painter_cut> cuts;
    /// For each chunk, the index of the first piece that is seen wholly. The last entry is the end
    /// of all pieces.
    std::vector<std::size_t> chunk_begins;
    /// All pieces, the ordered ones first. The vector never shrinks, since growing it again would
    /// write all new pieces.
    std::vector<l3d_painter_piece> pieces;

    /// Sorts the items that need an order by their farthest corners. Keys are the bits of positive
    /// floats, which are ordered like the floats.
    void sort() {
        keys.clear();
        for (std::size_t chunk = 0; chunk < items.chunks(); ++chunk) {
            auto number = static_cast<std::uint32_t>(items.first(chunk));
            for (const painter_item& item : items.of_chunk(chunk)) {
                if (sight.needs_order(number))
                    keys.push_back({std::bit_cast<std::uint32_t>(item.farthest), number});
                ++number;
            }
        }
        l3d_radix_sort(keys, other_keys);
    }

    /// Finds, for each item, the needed items that are sorted after the item. One worker sorts at
    /// the same time.
    void sort_and_find_late() {
        rows.resize(static_cast<std::size_t>(tiles.rows()));
        workers.for_each(1 + tiles.rows(), [&](int task, int worker) {
            if (task == 0)
                sort();
            else
                find_late(task - 1, of_workers[static_cast<std::size_t>(worker)]);
        });
        for (const row_of_needs& row : rows)
            late.insert(late.end(), row.found.begin(), row.found.end());
        // Two tiles may have found the same need.
        std::ranges::sort(late, {}, &late_need::both);
    }

    void find_late(int row, sorted_members& sorted) {
        row_of_needs& to = rows[static_cast<std::size_t>(row)];
        to.found.clear();
        to.pairs = 0;
        for (int column = 0; column < tiles.columns(); ++column) {
            const std::size_t tile = tiles.at(column, row);
            tiles.keep_if(
                tile, [&](const painter_entry& entry) { return sight.needs_order(entry.number); });
            const auto members = tiles.members(tile);
            if (are_apart(members))
                continue;
            sorted.sort(members);
            sorted.visit_pairs([&](const painter_entry& own, const painter_entry& other) {
                if (!own.may_meet(other))
                    return;
                ++to.pairs;
                if (pair_test.needs(own, other))
                    to.found.push_back({own.node(), other.node()});
            });
        }
    }

    /// Adds to `out` those items that `node` needs, that are sorted before `node`, and that are not
    /// emitted yet.
    void find_early(order_node node, std::vector<order_node>& out,
                    l3d_painter_order_counts& counts) {
        const auto is_emitted = [&](const painter_entry& entry) {
            return components.emitted(entry.node());
        };
        const std::uint32_t number = number_of(node);
        tiles.for_each(items[number], number, [&](std::size_t tile, const painter_entry& own) {
            for (const painter_entry& other : tiles.rest(tile, is_emitted)) {
                if (other.node() >= node)
                    break;
                if (!own.may_meet(other) || is_emitted(other))
                    continue;
                ++counts.pairs;
                if (pair_test.needs(own, other))
                    out.push_back(other.node());
            }
        });
    }

    /// Adds to `out` the items that must be painted before the item `node`, since `node` is
    /// somewhere in front of each of these items.
    void find_needed(order_node node, bool in_turn, std::vector<order_node>& out,
                     l3d_painter_order_counts& counts) {
        if (!in_turn)
            find_early(node, out, counts);
        auto need = std::ranges::lower_bound(late, node, {}, &late_need::item);
        for (; need != late.end() && need->item == node; ++need)
            out.push_back(need->before);
    }

    /// Adds a piece with the item's number in place of the triangle's index.
    void emit(order_node node) { ordered.push_back({number_of(node), of_item}); }

    /// Emits all items in sorted order, without comparing them.
    void emit_sorted() {
        for (const l3d_sort_item& key : keys)
            emit(order_node_of(key.key, key.index));
    }

    static l3d_painter_piece piece_of(const painter_item& item) {
        return {item.triangle, l3d_painter_cut::last};
    }

    /// Replaces items' numbers in pieces by triangles' indices, and adds pieces for the items that
    /// are seen wholly.
    void place_pieces() {
        chunk_begins.assign(1, ordered.size());
        for (std::size_t chunk = 0; chunk < items.chunks(); ++chunk) {
            const std::size_t first = items.first(chunk);
            chunk_begins.push_back(chunk_begins.back() +
                                   sight.count_whole(first, first + items.of_chunk(chunk).size()));
        }
        pieces.resize(std::max(pieces.size(), piece_count()));
        const std::size_t of_ordered = chunks_of(ordered.size(), chunk_pieces);
        workers.for_each_beside(static_cast<int>(of_ordered + items.chunks()), [&](int index, int) {
            const auto chunk = static_cast<std::size_t>(index);
            if (chunk < of_ordered)
                place_ordered(chunk * chunk_pieces,
                              std::min((chunk + 1) * chunk_pieces, ordered.size()));
            else
                place_whole(chunk - of_ordered);
        });
    }

    void place_ordered(std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (i + ahead < end && ordered[i + ahead].cut == of_item)
                __builtin_prefetch(&items[ordered[i + ahead].triangle]);
            const l3d_painter_piece& piece = ordered[i];
            pieces[i] = piece.cut == of_item ? piece_of(items[piece.triangle]) : piece;
        }
    }

    /// Places the pieces of a chunk's items that are seen wholly.
    void place_whole(std::size_t chunk) {
        auto number = static_cast<std::uint32_t>(items.first(chunk));
        l3d_painter_piece* to = pieces.data() + chunk_begins[chunk];
        for (const painter_item& item : items.of_chunk(chunk))
            if (sight.is_whole(number++))
                *to++ = piece_of(item);
    }

    std::size_t piece_count() const { return chunk_begins.back(); }

    void emit_component(std::span<const order_node> component, l3d_painter_order_counts& counts) {
        if (component.size() == 1)
            return emit(component.front());
        ++counts.knots;
        counts.knotted += static_cast<std::int64_t>(component.size());
        knot_members.clear();
        for (const order_node member : component)
            knot_members.push_back(items[number_of(member)].triangle);
        knot.untie(workers, size, given, knot_members, ordered, cuts);
    }

    /// Emits the items in an order that meets all needs.
    void emit_resolved(l3d_painter_order_counts& counts) {
        auto next = late.begin();
        components.walk(
            keys, items.numbers(),
            [&](order_node node) { // called for rising nodes
                while (next != late.end() && next->item < node)
                    ++next;
                return next == late.end() || next->item != node;
            },
            [&](order_node node, bool in_turn, std::vector<order_node>& out) {
                workers.ask();
                find_needed(node, in_turn, out, counts);
            },
            [&](std::span<const order_node> component) { emit_component(component, counts); });
        counts.cuts = static_cast<std::int64_t>(cuts.size()) / 2;
    }
};

l3d_painter_order::l3d_painter_order(l3d_workers& workers)
    : work_(std::make_unique<work_space>(workers)) {}

l3d_painter_order::~l3d_painter_order() = default;

void l3d_painter_order::make(std::span<const l3d_painter_triangle> triangles, l3d_size size,
                             const way& how) {
    const std::size_t chunks = chunks_of(triangles.size(), painter_items::usual_chunk);
    std::vector<std::size_t> ends;
    for (std::size_t i = 1; i <= chunks; ++i)
        ends.push_back(std::min(i * painter_items::usual_chunk, triangles.size()));
    begin(triangles, ends, size, how);
    work_->workers.for_each(static_cast<int>(chunks),
                            [&](int chunk, int) { note(static_cast<std::size_t>(chunk)); });
    finish();
}

void l3d_painter_order::begin(std::span<const l3d_painter_triangle> triangles,
                              std::span<const std::size_t> ends, l3d_size size, const way& how) {
    work_space& w = *work_;
    counts_ = {};
    counts_.triangles = static_cast<std::int64_t>(triangles.size());
    w.ordered.clear();
    w.cuts.clear();
    w.given = triangles;
    w.size = size;
    w.how = how;
    w.items.begin(triangles, ends, size, how.sides);
}

void l3d_painter_order::note(std::size_t chunk) {
    work_->items.make(chunk);
}

void l3d_painter_order::finish() {
    work_space& w = *work_;
    w.items.finish();
    w.late.clear();
    if (w.how.resolve) {
        w.tiles.make(w.items, w.size, w.workers);
        counts_.pairs += w.sight.find(w.tiles, w.pair_test, w.items.numbers(), w.workers);
        w.sort_and_find_late();
        for (const row_of_needs& row : w.rows)
            counts_.pairs += row.pairs;
    } else {
        w.sight.forget();
        w.sort();
    }
    if (w.late.empty())
        w.emit_sorted(); // no pair violates the sorted order
    else
        w.emit_resolved(counts_);
    w.place_pieces();
}

std::span<const l3d_painter_triangle> l3d_painter_order::triangles() const {
    return work_->given;
}

std::span<const l3d_painter_piece> l3d_painter_order::pieces() const {
    return {work_->pieces.data(), work_->piece_count()};
}

std::span<const l3d_painter_cut> l3d_painter_order::cuts() const {
    return work_->cuts;
}
