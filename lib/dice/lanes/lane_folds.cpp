// SPDX-License-Identifier: MIT
// Finds folded quads, the quads of a row side by side in SIMD lanes, and measures them.
#include "dice/lanes/lane_folds_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dice/lanes/lane_folds.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_integers-inl.h"
#include "raster/parallel/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Bounds the relative rounding of a product of two differences. The product is rounded, and so is
/// each difference that exceeds 2^24.
constexpr float rounding = 0x1p-21F;

/// The sides of quads as vectors from corner to corner, in lanes.
struct side {
    float_vec x, y;

    HWY_INLINE side(int_vec x0, int_vec y0, int_vec x1, int_vec y1)
        : x(hn::ConvertTo(floats(), hn::Sub(x1, x0))), y(hn::ConvertTo(floats(), hn::Sub(y1, y0))) {
    }
};

/// The range of the four turns at a quad's corners, widened by rounding. A quad whose range holds
/// both signs may be folded.
struct turn_range {
    float_vec least, most;

    HWY_INLINE turn_range() : least(hn::Zero(floats())), most(least) {}

    HWY_INLINE void take(const side& a, const side& b) {
        const float_vec left = hn::Mul(a.x, b.y), right = hn::Mul(a.y, b.x);
        const float_vec turn = hn::Sub(left, right);
        const float_vec off =
            hn::Mul(hn::Set(floats(), rounding), hn::Add(hn::Abs(left), hn::Abs(right)));
        least = hn::Min(least, hn::Sub(turn, off));
        most = hn::Max(most, hn::Add(turn, off));
    }
};

/// Calls visit(column) for the quads of a row that may be folded.
template <class Visit>
HWY_INLINE void for_folded(const l3d_micro_grid& grid, int row, const Visit& visit) {
    const ints d;
    const std::size_t above = grid.index(row, 0), below = grid.index(row + 1, 0);
    const auto quads = static_cast<std::size_t>(grid.columns - 1);
    // Behind the last row there may be no more numbers. So the last vector of a row overlaps the
    // one before, and a row with fewer quads than lanes is copied.
    const auto corner = [&](const auto& of, std::size_t at) HWY_ATTR {
        if (quads >= lanes)
            return hn::LoadU(d, of.data() + at);
        alignas(64) std::int32_t copy[16] = {};
        std::copy_n(of.data() + at, quads, copy);
        return hn::Load(d, copy);
    };
    for (std::size_t to = 0; to < quads; to += lanes) {
        const std::size_t i = quads >= lanes ? std::min(to, quads - lanes) : 0;
        const int_vec ax = corner(grid.x, above + i), ay = corner(grid.y, above + i);
        const int_vec bx = corner(grid.x, above + i + 1), by = corner(grid.y, above + i + 1);
        const int_vec cx = corner(grid.x, below + i), cy = corner(grid.y, below + i);
        const int_vec dx = corner(grid.x, below + i + 1), dy = corner(grid.y, below + i + 1);
        const side ab(ax, ay, bx, by), cd(cx, cy, dx, dy), ac(ax, ay, cx, cy), bd(bx, by, dx, dy);
        turn_range turns;
        turns.take(ab, ac);
        turns.take(ab, bd);
        turns.take(cd, ac);
        turns.take(cd, bd);
        const auto zero = hn::Zero(floats());
        const auto both = hn::And(hn::Lt(turns.least, zero), hn::Gt(turns.most, zero));
        for (std::uint64_t bits = bits_of(hn::RebindMask(ints(), both)); bits != 0;
             bits &= bits - 1)
            visit(i + static_cast<std::size_t>(std::countr_zero(bits)));
    }
}

/// Measures the error of drawing a quad as a fan of triangles; 0 if the quad is not folded.
/// Shape: corners p00, p10, p01, p11.
double fan_error(const std::array<l3d_micro_vertex, 4>& p, bool is_parallel) {
    struct place {
        std::int64_t x, y;
    };
    std::array<place, 4> from{}; // each corner, from the first one
    std::array<double, 4> w{};
    double reach = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        from[i] = {std::int64_t{p[i].x} - p[0].x, std::int64_t{p[i].y} - p[0].y};
        w[i] = is_parallel ? 1 : 1 / double{p[i].inv_w};
        reach = std::max(
            reach, std::hypot(static_cast<double>(from[i].x), static_cast<double>(from[i].y)));
    }
    bool right = false, left = false;
    constexpr std::array<std::size_t, 4> around{0, 1, 3, 2};
    for (std::size_t i = 0; i < 4; ++i) {
        const place &a = from[around[i]], &b = from[around[(i + 1) % 4]];
        const place& c = from[around[(i + 2) % 4]];
        const std::int64_t turn = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
        right = right || turn > 0;
        left = left || turn < 0;
    }
    if (!right || !left)
        return 0;
    const auto mixed = [&](auto of) { return w[3] * of(3) - w[1] * of(1) - w[2] * of(2); };
    const double x = mixed([&](std::size_t i) { return static_cast<double>(from[i].x); });
    const double y = mixed([&](std::size_t i) { return static_cast<double>(from[i].y); });
    const double of_w = std::abs(w[0] - w[1] - w[2] + w[3]);
    const double seen = std::hypot(x, y) + reach * of_w;
    return seen / (16 * l3d_subpixel_one * *std::ranges::min_element(w));
}

/// The strip to which a row or column of quads belongs.
std::size_t strip_of(const l3d_block_starts& starts, int quad) {
    std::size_t strip = 0;
    while (quad >= starts.first[strip + 1])
        ++strip;
    return strip;
}

HWY_ATTR void fold(const l3d_surface_part& part, const l3d_block_needs::per_block& errors,
                   double& most) {
    const l3d_micro_grid& grid = part.grid;
    for (int row = 0; row + 1 < grid.rows; ++row)
        for_folded(grid, row, [&](std::size_t i) {
            const int column = static_cast<int>(i);
            const double fan =
                fan_error({grid.vertex(row, column), grid.vertex(row, column + 1),
                           grid.vertex(row + 1, column), grid.vertex(row + 1, column + 1)},
                          grid.is_parallel);
            if (fan > 0)
                most = std::max(
                    most,
                    fan + errors[l3d_block_needs::most_strips * strip_of(part.block_rows, row) +
                                 strip_of(part.block_columns, column)]);
        });
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(fold);

double most_folded(const l3d_surface_part& part, const l3d_block_needs::per_block& errors) {
    double most = 0;
    L3D_SIMD_CALL(fold)(part, errors, most);
    return most;
}

} // namespace l3d_detail
#endif
