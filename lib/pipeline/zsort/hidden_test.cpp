// SPDX-License-Identifier: MIT
// hidden_test: compares, tile by tile, the members in front with those that the sort paints last.
#include "pipeline/zsort/hidden_test_p.h"

#include <algorithm>
#include <atomic>
#include <bit>

namespace l3d_detail {

std::int64_t hidden_test::find(const painter_tiles& tiles, const painter_pairs& pairs,
                               std::size_t numbers, l3d_workers& workers) {
    forget();
    if (!tiles.have_pixels())
        return 0;
    parts_.resize(numbers);
    of_workers_.resize(static_cast<std::size_t>(workers.count()));
    for (found& of : of_workers_)
        of.pairs = 0;
    workers.for_each_beside(tiles.rows(), [&](int row, int worker) {
        for (int column = 0; column < tiles.columns(); ++column)
            look(tiles.members(tiles.at(column, row)), pairs,
                 of_workers_[static_cast<std::size_t>(worker)]);
    });
    std::int64_t sum = 0;
    for (const found& of : of_workers_)
        sum += of.pairs;
    return sum;
}

void hidden_test::look(std::span<const painter_entry> members, const painter_pairs& pairs,
                       found& room) {
    if (are_apart(members)) {
        for (const painter_entry& member : members)
            note(member, true, false);
        return;
    }
    room.of_members.resize(std::max(room.of_members.size(), members.size()));
    find_sight(members, room.fronts, room.of_members.data());
    const bool is_right = is_sort_right(members, pairs, room);
    for (std::size_t i = 0; i < members.size(); ++i) {
        const std::uint64_t shown = room.of_members[i].shown;
        note(members[i], !is_right || shown != 0, !is_right || shown != members[i].cells);
    }
}

/// Whether the sort is right in a tile. It is right if, in each cell, the member that is painted
/// last is in front of all other members of the cell.
bool hidden_test::is_sort_right(std::span<const painter_entry> members, const painter_pairs& pairs,
                                found& of) {
    for (std::size_t i = 0; i < members.size(); ++i) {
        if (!members[i].is_exact)
            return false; // this member may not cover all of its cells
        std::int32_t last = -1;
        for (std::uint64_t left = of.of_members[i].doubtful; left != 0; left &= left - 1) {
            const std::int32_t front = of.fronts[static_cast<std::size_t>(std::countr_zero(left))];
            if (front == last)
                continue; // it was compared already
            last = front;
            ++of.pairs;
            if (pairs.needs(members[i], members[static_cast<std::size_t>(front)]))
                return false;
        }
    }
    return true;
}

std::size_t hidden_test::count_whole(std::size_t begin, std::size_t end) const {
    if (parts_.empty())
        return 0;
    std::size_t count = 0;
    for (std::size_t number = begin; number < end; ++number)
        count += parts_[number].seen > parts_[number].hidden; // both are 0 or 1
    return count;
}

/// Notes that parts of an item are seen, or hidden. Two workers may write at once, but they write
/// the same number.
void hidden_test::note(const painter_entry& member, bool is_seen, bool is_hidden) {
    parts& of = parts_[member.number];
    if (is_seen)
        std::atomic_ref(of.seen).store(1, std::memory_order_relaxed);
    if (is_hidden)
        std::atomic_ref(of.hidden).store(1, std::memory_order_relaxed);
}

} // namespace l3d_detail
