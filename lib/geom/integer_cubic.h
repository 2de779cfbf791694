// SPDX-License-Identifier: MIT
// l3d_integer_cubic: a cubic that is halved and walked in whole numbers.
#ifndef L3D_GEOM_INTEGER_CUBIC_H
#define L3D_GEOM_INTEGER_CUBIC_H

#include "base/public.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <utility>

/// A cubic Bezier polynomial with whole control values. Halving it and stepping along it multiply
/// its values by 8 for each doubling of the steps. So every difference is a whole number, and
/// nothing is ever rounded.
///
/// Units:   the true values are the stored ones divided by 8^level.
/// Expects: control values of at most 2^24 in magnitude at level 0, and at most most_level.
/// Source:  Klassen: Exact Integer Hybrid Subdivision and Forward Differencing of Cubics, ACM
///          Transactions on Graphics 13 (1994). Which steps are halvings is the caller's choice.
class L3D_PUBLIC l3d_integer_cubic {
public:
    /// Values have 24 + 3 * 12 = 60 bits then, and differences no more.
    static constexpr int most_level = 12;

    /// A cubic by its control values, at level 0.
    explicit l3d_integer_cubic(const std::array<std::int64_t, 4>& control) : control_(control) {}

    /// The number of times that values were multiplied by 8.
    int level() const { return level_; }

    /// Both halves, a level higher.
    std::pair<l3d_integer_cubic, l3d_integer_cubic> split() const {
        assert(level_ < most_level);
        const auto& [a, b, c, d] = control_;
        const std::int64_t first = 4 * (a + b), last = 4 * (c + d);
        const std::int64_t left = 2 * (a + 2 * b + c), right = 2 * (b + 2 * c + d);
        const std::int64_t middle = a + 3 * (b + c) + d;
        return {l3d_integer_cubic({8 * a, first, left, middle}, level_ + 1),
                l3d_integer_cubic({middle, right, last, 8 * d}, level_ + 1)};
    }

    /// Calls visit(value) for 2^doublings + 1 values along the cubic, both ends included. Each is
    /// three additions away from the one before, at the level level() + doublings.
    template <class Visitor> void walk(int doublings, const Visitor& visit) const {
        assert(doublings >= 0 && level_ + doublings <= most_level);
        const auto& [a, b, c, d] = control_;
        // With steps of h = 1 / n, the powers of the parameter weigh n^3, n^2, n and 1 of 8^level.
        const std::int64_t n = std::int64_t{1} << doublings;
        const std::int64_t first = 3 * (b - a) * n * n, second = 3 * (a - 2 * b + c) * n;
        const std::int64_t third = d - a + 3 * (b - c);
        std::int64_t value = a * n * n * n, by = first + second + third;
        std::int64_t grows = 2 * second + 6 * third;
        const std::int64_t always = 6 * third;
        visit(value);
        for (std::int64_t i = 0; i < n; ++i) {
            value += by;
            by += grows;
            grows += always;
            visit(value);
        }
    }

    /// Visits the same values by halving first: the cubic is halved `halvings` times, and each
    /// piece is walked. The ends where pieces meet are visited once.
    template <class Visitor>
    void walk_halved(int halvings, int doublings, const Visitor& visit) const {
        bool is_first = true;
        walk_pieces(halvings, doublings, is_first, visit);
    }

private:
    l3d_integer_cubic(const std::array<std::int64_t, 4>& control, int level)
        : control_(control), level_(level) {}

    template <class Visitor>
    void walk_pieces(int halvings, int doublings, bool& is_first, const Visitor& visit) const {
        if (halvings > 0) {
            const auto [left, right] = split();
            left.walk_pieces(halvings - 1, doublings, is_first, visit);
            right.walk_pieces(halvings - 1, doublings, is_first, visit);
            return;
        }
        bool is_shared = !is_first;
        is_first = false;
        walk(doublings, [&](std::int64_t value) {
            if (!is_shared)
                visit(value);
            is_shared = false;
        });
    }

    std::array<std::int64_t, 4> control_;
    int level_ = 0;
};

#endif
