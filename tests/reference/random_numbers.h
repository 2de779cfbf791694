// SPDX-License-Identifier: MIT
// A source of numbers that is the same with every compiler and library.
#ifndef L3D_REFERENCE_RANDOM_NUMBERS_H
#define L3D_REFERENCE_RANDOM_NUMBERS_H

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace reference {

/// SplitMix64 (Steele, Lea, Flood 2014).
class random_numbers {
public:
    explicit random_numbers(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
    }
    /// A number whose logarithm is uniform, so that every order of magnitude is alike. Expects: 0 <
    /// low <= high.
    double of_any_size(double low, double high) {
        return std::exp(between(std::log(low), std::log(high)));
    }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

private:
    std::uint64_t state_;
};

} // namespace reference

#endif
