// SPDX-License-Identifier: MIT
// pair_measures: pairs in lanes.
#include "raster/refine/pair_measures_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/refine/pair_measures.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"
#include "raster/refine/linear_light_p.h"
#include "raster/refine/polygon_levels-inl.h"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

static_assert(lanes <= pair_measures::widest_vector);

/// a / b, or 0 where b is 0.
HWY_INLINE float_vec quotient(float_vec a, float_vec b) {
    const auto none = hn::Eq(b, hn::Zero(floats()));
    return hn::IfThenZeroElse(none, hn::Div(a, hn::IfThenElse(none, set(1.0f), b)));
}

/// The integral of x, held within the pixel, along y from one end of a side to the other, held so,
/// too. The sum over all sides is the area inside the pixel, with the sign of the turn.
HWY_INLINE float_vec area_beside(float_vec ax, float_vec ay, float_vec bx, float_vec by) {
    const float_vec from = within(ay), to = within(by);
    const float_vec slope = quotient(hn::Sub(bx, ax), hn::Sub(by, ay));
    const float_vec p = hn::Add(ax, hn::Mul(hn::Sub(from, ay), slope));
    const float_vec q = hn::Add(ax, hn::Mul(hn::Sub(to, ay), slope));
    const float_vec low = hn::Min(p, q), high = hn::Max(p, q);
    const float_vec first = within(low), last = within(high);
    // Between `low` and `high`, x rises steadily: 0 outside on the left, 1 outside on the right.
    const float_vec inside =
        hn::Mul(hn::Mul(set(0.5f), hn::Sub(last, first)), hn::Add(last, first));
    const float_vec beyond = hn::Max(hn::Sub(high, hn::Max(low, set(1.0f))), hn::Zero(floats()));
    const float_vec width = hn::Sub(high, low);
    const float_vec mean = hn::IfThenElse(hn::Eq(width, hn::Zero(floats())), first,
                                          quotient(hn::Add(inside, beyond), width));
    return hn::Mul(mean, hn::Sub(to, from));
}

/// The polygons of some pairs, number by number. Places are relative to the pixels, in parts of
/// them.
struct pair_numbers {
    alignas(64) float x[4][lanes], y[4][lanes], inv_w[4][lanes], level[4][lanes];
    alignas(64) float ab[lanes], ad[lanes], bc[lanes], dc[lanes]; ///< what a quad's sides bend by
    alignas(64) float farthest[lanes], nearest[lanes], is_quad[lanes];

    void set(std::size_t lane, const fragment_polygon& of, std::int32_t left, std::int32_t top) {
        const auto place = [](std::int32_t units, std::int32_t pixel) {
            return static_cast<float>(units - pixel * l3d_subpixel_one) * (1.0f / l3d_subpixel_one);
        };
        for (std::size_t i = 0; i < 4; ++i) {
            x[i][lane] = place(of.x[i], left);
            y[i][lane] = place(of.y[i], top);
            inv_w[i][lane] = of.inv_w[i];
            level[i][lane] = of.light[0][i];
        }
        ab[lane] = of.light[1][0];
        ad[lane] = of.light[2][0];
        bc[lane] = of.light[2][1];
        dc[lane] = of.light[1][3];
        farthest[lane] = of.farthest;
        nearest[lane] = of.nearest;
        is_quad[lane] = of.corners == 4 ? 1.0f : 0.0f;
    }
};

/// Some pairs of polygons and pixels.
class pair_lanes {
public:
    HWY_INLINE explicit pair_lanes(const pair_numbers& numbers) : numbers_(numbers) {
        for (std::size_t i = 0; i < 4; ++i) {
            x_[i] = load(numbers.x[i]);
            y_[i] = load(numbers.y[i]);
        }
        along1_x_ = hn::Sub(x_[2], x_[0]);
        along1_y_ = hn::Sub(y_[2], y_[0]);
        along2_x_ = hn::Sub(x_[3], x_[1]);
        along2_y_ = hn::Sub(y_[3], y_[1]);
        inverse_ = quotient(set(1.0f),
                            hn::Sub(hn::Mul(along1_x_, along2_y_), hn::Mul(along1_y_, along2_x_)));
        mean_x_ = mean_of(x_);
        mean_y_ = mean_of(y_);
    }

    HWY_INLINE void store(pair_measures& to, std::size_t at) const {
        const floats d;
        float_vec area = hn::Zero(d);
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t next = (i + 1) % 4;
            area = hn::Add(area, area_beside(x_[i], y_[i], x_[next], y_[next]));
        }
        hn::StoreU(hn::Abs(area), d, to.area.data() + at);
        store_samples(to, at);
        const float_vec x = mean_within(x_), y = mean_within(y_);
        hn::StoreU(x, d, to.x.data() + at);
        hn::StoreU(y, d, to.y.data() + at);

        const float_vec s = first_part(x, y), t = second_part(x, y);
        store_depth(to, at, s, t);
        store_levels(to, at, s, t);
    }

private:
    static HWY_INLINE float_vec load(const float (&of)[lanes]) { return hn::Load(floats(), of); }

    static HWY_INLINE float_vec mean_of(const float_vec (&v)[4]) {
        return hn::Mul(set(0.25f), hn::Add(hn::Add(v[0], v[2]), hn::Add(v[1], v[3])));
    }
    static HWY_INLINE float_vec mean_within(const float_vec (&v)[4]) {
        const float_vec held[4] = {within(v[0]), within(v[1]), within(v[2]), within(v[3])};
        return mean_of(held);
    }

    /// In each row of samples, the polygon reaches from the largest of the sides that it lies right
    /// of to the least of those that it lies left of.
    HWY_INLINE void store_samples(pair_measures& to, std::size_t at) const {
        const floats d;
        const ints di;
        const auto clockwise = hn::Gt(inverse_, hn::Zero(d));
        float_vec slope[4];
        hn::Mask<floats> is_left[4], level[4];
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t next = (i + 1) % 4;
            const float_vec dy = hn::Sub(y_[next], y_[i]);
            slope[i] = quotient(hn::Sub(x_[next], x_[i]), dy);
            level[i] = hn::Eq(dy, hn::Zero(d));
            is_left[i] = hn::Xor(hn::Gt(dy, hn::Zero(d)), clockwise);
        }
        const float_vec top = hn::Min(hn::Min(y_[0], y_[1]), hn::Min(y_[2], y_[3]));
        const float_vec bottom = hn::Max(hn::Max(y_[0], y_[1]), hn::Max(y_[2], y_[3]));
        int_vec halves[2] = {hn::Zero(di), hn::Zero(di)};
        for (int row = 0; row < mask_side; ++row) {
            const float_vec y = set((static_cast<float>(row) + 0.5f) / mask_side);
            float_vec from = set(0.0f), end = set(1.0f);
            for (std::size_t i = 0; i < 4; ++i) {
                const float_vec x = hn::Add(x_[i], hn::Mul(hn::Sub(y, y_[i]), slope[i]));
                const auto bounds_left = hn::AndNot(level[i], is_left[i]);
                const auto bounds_right = hn::Not(hn::Or(level[i], is_left[i]));
                from = hn::IfThenElse(bounds_left, hn::Max(from, x), from);
                end = hn::IfThenElse(bounds_right, hn::Min(end, x), end);
            }
            const auto meets = hn::And(hn::Ge(y, top), hn::Lt(y, bottom));
            end = hn::IfThenElse(meets, hn::Max(end, from), from);
            const int_vec bits = hn::AndNot(below(from), below(end));
            halves[row / 4] =
                hn::Or(halves[row / 4], hn::Shl(bits, hn::Set(di, row % 4 * mask_side)));
        }
        hn::StoreU(hn::BitCast(hn::RebindToUnsigned<ints>(), halves[0]),
                   hn::RebindToUnsigned<ints>(), to.top.data() + at);
        hn::StoreU(hn::BitCast(hn::RebindToUnsigned<ints>(), halves[1]),
                   hn::RebindToUnsigned<ints>(), to.bottom.data() + at);
    }

    /// A bit for each sample of a row that is before a place.
    static HWY_INLINE int_vec below(float_vec place) {
        const ints di;
        const float_vec count = hn::Add(hn::Mul(within(place), set(float{mask_side})), set(0.5f));
        const int_vec samples = hn::ConvertTo(di, count);
        return hn::Sub(hn::Shl(hn::Set(di, 1), samples), hn::Set(di, 1));
    }

    HWY_INLINE void store_depth(pair_measures& to, std::size_t at, float_vec s, float_vec t) const {
        const floats d;
        const float_vec inv_w[4] = {load(numbers_.inv_w[0]), load(numbers_.inv_w[1]),
                                    load(numbers_.inv_w[2]), load(numbers_.inv_w[3])};
        const float_vec first = hn::Sub(inv_w[2], inv_w[0]), second = hn::Sub(inv_w[3], inv_w[1]);
        const float_vec mean = mean_of(inv_w);
        const float_vec there = hn::Add(mean, hn::Add(hn::Mul(s, first), hn::Mul(t, second)));
        const plane_slopes slopes = slopes_of(inv_w);
        hn::StoreU(hn::Min(hn::Max(there, load(numbers_.farthest)), load(numbers_.nearest)), d,
                   to.inv_w.data() + at);
        hn::StoreU(slopes.of_x, d, to.of_x.data() + at);
        hn::StoreU(slopes.of_y, d, to.of_y.data() + at);
    }

    /// The level at the mean place, and how far apart levels are in the pixel, but for bends. What
    /// is darker than the ambient light, or brighter than white, counts as these.
    HWY_INLINE void store_levels(pair_measures& to, std::size_t at, float_vec s,
                                 float_vec t) const {
        const floats d;
        const polygon_levels levels{{load(numbers_.level[0]), load(numbers_.level[1]),
                                     load(numbers_.level[2]), load(numbers_.level[3])},
                                    load(numbers_.ab),
                                    load(numbers_.ad),
                                    load(numbers_.bc),
                                    load(numbers_.dc)};
        const auto is_quad = hn::Gt(load(numbers_.is_quad), hn::Zero(d));
        hn::StoreU(hn::IfThenElse(is_quad, levels.of_quad(s, t), levels.of_triangle(s, t)), d,
                   to.level.data() + at);
        float_vec least = set(linear_light::most_lit), most = set(0.0f);
        for (const float_vec corner : levels.corner) {
            least = hn::Min(least, corner);
            most = hn::Max(most, corner);
        }
        const float_vec range =
            hn::Sub(hn::Min(most, set(linear_light::most_lit)), hn::Max(least, set(0.0f)));
        const plane_slopes slopes = slopes_of(levels.corner);
        const float_vec across = hn::Add(hn::Abs(slopes.of_x), hn::Abs(slopes.of_y));
        hn::StoreU(hn::Min(range, across), d, to.spread.data() + at);
    }

    /// What a number of the corners rises by in a pixel, on the plane along both diagonals.
    struct plane_slopes {
        float_vec of_x, of_y;
    };
    HWY_INLINE plane_slopes slopes_of(const float_vec (&of)[4]) const {
        const float_vec first = hn::Mul(hn::Sub(of[2], of[0]), inverse_);
        const float_vec second = hn::Mul(hn::Sub(of[3], of[1]), inverse_);
        return {hn::Sub(hn::Mul(first, along2_y_), hn::Mul(second, along1_y_)),
                hn::Sub(hn::Mul(second, along1_x_), hn::Mul(first, along2_x_))};
    }

    /// The parts of both diagonals that lead from the mean of the corners to a place.
    HWY_INLINE float_vec first_part(float_vec x, float_vec y) const {
        const float_vec h_x = hn::Sub(x, mean_x_), h_y = hn::Sub(y, mean_y_);
        return hn::Mul(hn::Sub(hn::Mul(h_x, along2_y_), hn::Mul(h_y, along2_x_)), inverse_);
    }
    HWY_INLINE float_vec second_part(float_vec x, float_vec y) const {
        const float_vec h_x = hn::Sub(x, mean_x_), h_y = hn::Sub(y, mean_y_);
        return hn::Mul(hn::Sub(hn::Mul(along1_x_, h_y), hn::Mul(along1_y_, h_x)), inverse_);
    }

    const pair_numbers& numbers_;
    float_vec x_[4], y_[4];
    float_vec along1_x_, along1_y_, along2_x_, along2_y_, inverse_; ///< diagonals; 1 / their cross
    float_vec mean_x_, mean_y_;
};

void measure_pairs(const band_fragments& band, pair_measures& to) {
    const auto pairs = band.pairs();
    pair_numbers numbers{};
    for (std::size_t at = 0; at < pairs.size(); at += lanes) {
        const std::size_t end = std::min(pairs.size(), at + lanes);
        for (std::size_t i = at; i < end; ++i) {
            const band_fragments::pixel& pixel = band.pixels()[pairs[i].pixel];
            numbers.set(i - at, band.polygons()[pairs[i].polygon], pixel.x, pixel.y);
        }
        pair_lanes(numbers).store(to, at);
    }
}

std::uint64_t samples_above(float at, float of_x, float of_y) {
    constexpr hn::CappedTag<float, mask_side> d;
    const float step_x = of_x / mask_side, step_y = of_y / mask_side;
    float row_value = at + 0.5f * (step_x + step_y);
    std::uint8_t bytes[8] = {};
    std::uint64_t result = 0;
    for (int row = 0; row < mask_side; ++row, row_value += step_y)
        for (std::size_t column = 0; column < mask_side; column += hn::Lanes(d)) {
            const auto along = hn::Mul(hn::Iota(d, static_cast<float>(column)), hn::Set(d, step_x));
            const auto value = hn::Add(hn::Set(d, row_value), along);
            hn::StoreMaskBits(d, hn::Gt(value, hn::Zero(d)), bytes);
            result |= std::uint64_t{bytes[0]}
                      << (static_cast<std::size_t>(row * mask_side) + column);
        }
    return result;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(measure_pairs);
L3D_SIMD_TABLE(samples_above);

std::uint64_t samples_above(float at, float of_x, float of_y) {
    return L3D_SIMD_CALL(samples_above)(at, of_x, of_y);
}

void pair_measures::resize(std::size_t count) {
    // The last vector may be only begun.
    const std::size_t room = count + widest_vector;
    for (auto* const numbers : {&area, &x, &y, &inv_w, &of_x, &of_y, &level, &spread})
        if (numbers->size() < room)
            numbers->resize(room);
    for (auto* const bits : {&top, &bottom})
        if (bits->size() < room)
            bits->resize(room);
}

void measure_pairs(const band_fragments& band, pair_measures& to) {
    to.resize(band.pairs().size());
    L3D_SIMD_CALL(measure_pairs)(band, to);
}

} // namespace l3d_detail
#endif
