// SPDX-License-Identifier: MIT
// l3d_radix_sort: a stable sort by whole-number keys in linear time.
#ifndef L3D_GEOM_RADIX_SORT_H
#define L3D_GEOM_RADIX_SORT_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// A key and the index of its item, for l3d_radix_sort.
struct l3d_sort_item {
    std::uint32_t key = 0;   ///< the number to sort by
    std::uint32_t index = 0; ///< which of the caller's items has the key
    friend bool operator==(const l3d_sort_item&, const l3d_sort_item&) = default;
};

/// Sorts items by rising key; items of equal keys keep their order.
///
/// Keys are sorted by one digit of 11 bits after another, from the least significant of three. Each
/// digit has 2^11 counters of 4 bytes. All counters take 24 KB, and stay in the first level cache
/// of 32 KB. All digits are counted in one pass; a digit in which all keys agree costs no pass of
/// its own.
/// Cost:    linear: one pass to count, at most three to move. `other` is room for intermediate
///          results and keeps its memory; its contents mean nothing afterwards.
inline void l3d_radix_sort(std::vector<l3d_sort_item>& items, std::vector<l3d_sort_item>& other) {
    constexpr int digits = 3, bits = 11;
    constexpr std::uint32_t mask = (1u << bits) - 1;
    std::array<std::array<std::uint32_t, mask + 1>, digits> begins{};
    const auto digit_of = [](const l3d_sort_item& item, std::size_t digit) {
        return item.key >> (digit * bits) & mask;
    };
    for (const l3d_sort_item& item : items)
        for (std::size_t d = 0; d < digits; ++d)
            ++begins[d][digit_of(item, d)];
    other.resize(items.size());
    for (std::size_t d = 0; d < digits && !items.empty(); ++d) {
        if (begins[d][digit_of(items.front(), d)] == items.size())
            continue;
        std::uint32_t sum = 0;
        for (std::uint32_t& begin : begins[d]) {
            const std::uint32_t count = begin;
            begin = sum;
            sum += count;
        }
        for (const l3d_sort_item& item : items)
            other[begins[d][digit_of(item, d)]++] = item;
        items.swap(other);
    }
}

#endif
