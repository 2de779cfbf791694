// SPDX-License-Identifier: MIT
// number_hash: the hash of arrays of numbers, for the library's tables.
#ifndef L3D_BASE_NUMBER_HASH_P_H
#define L3D_BASE_NUMBER_HASH_P_H

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace l3d_detail {

/// Hashes an array of doubles or of whole numbers, for tables that have arrays as keys. Equal
/// arrays have equal hashes; -0 counts as 0.
struct number_hash {
    template <class Numbers> std::size_t operator()(const Numbers& of) const {
        // 2^64 divided by the golden ratio, made odd. A product carries bits upwards only, so it is
        // rotated by about half its width, an odd number.
        constexpr std::uint64_t factor = 0x9e3779b97f4a7c15U;
        constexpr int about_half = 29;
        std::uint64_t result = 0;
        for (const auto number : of) {
            if constexpr (std::is_same_v<decltype(number), const double>)
                result ^= std::bit_cast<std::uint64_t>(number + 0.0);
            else
                result ^= number;
            result = std::rotl(result * factor, about_half);
        }
        return static_cast<std::size_t>(result);
    }
};

} // namespace l3d_detail

#endif
