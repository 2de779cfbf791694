// SPDX-License-Identifier: MIT
// l3d_random: random numbers that are the same on every machine.
#ifndef L3D_GEOM_RANDOM_H
#define L3D_GEOM_RANDOM_H

#include "base/public.h"

#include <bit>
#include <cassert>
#include <cstdint>

/// A sequence of random numbers from a seed, the same with every implementation of C++. The
/// distributions of the C++ library differ between implementations, so pictures made from a seed
/// would differ, too.
///
/// Cost:    a product, an addition, a few shifts; 8 bytes. The period is 2^64.
/// Source:  O'Neill, PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for
///          Random Number Generation (2014), the member XSH-RR 64/32.
class L3D_PUBLIC l3d_random {
public:
    /// The sequence that belongs to the seed, from its beginning.
    explicit constexpr l3d_random(std::uint64_t seed) noexcept : state_(seed + increment) {
        next();
    }

    /// 32 random bits.
    constexpr std::uint32_t next() noexcept {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005u + increment;
        const auto mixed = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
        return std::rotr(mixed, static_cast<int>(old >> 59));
    }

    /// A whole number from `least` to `most`, both included, each equally likely.
    ///
    /// Expects: least <= most.
    /// Source:  Lemire, Fast Random Integer Generation in an Interval (2019). The result is the
    ///          upper half of a product. In the few cases that would make some numbers more likely,
    ///          bits are drawn again.
    constexpr int between(int least, int most) noexcept {
        assert(least <= most);
        const auto count = static_cast<std::uint32_t>(static_cast<std::int64_t>(most) - least + 1);
        if (count == 0) // all of the 2^32 numbers
            return static_cast<int>(next());
        const std::uint32_t surplus = (0u - count) % count; // 2^32 modulo count
        std::uint64_t product = std::uint64_t{next()} * count;
        while (static_cast<std::uint32_t>(product) < surplus)
            product = std::uint64_t{next()} * count;
        return static_cast<int>(least + static_cast<std::int64_t>(product >> 32));
    }

    /// A number from 0 to less than 1, a multiple of 2^-32.
    constexpr double fraction() noexcept { return next() * 0x1p-32; }

private:
    static constexpr std::uint64_t increment = 1442695040888963407u; // any odd number

    std::uint64_t state_;
};

#endif
