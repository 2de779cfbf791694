// SPDX-License-Identifier: MIT
// pair_measures: the pixels of a polygon in lanes.
#include "raster/refine/pair_measures_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/refine/pair_measures.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// A polygon reaches few marked pixels: wider vectors would be half empty.
using ints = hn::CappedTag<std::int32_t, 8>;
using floats = hn::RebindToFloat<ints>;
using int_vec = hn::Vec<ints>;
using float_vec = hn::Vec<floats>;
constexpr std::size_t lanes = hn::MaxLanes(ints());

HWY_INLINE float_vec set(float value) {
    return hn::Set(floats(), value);
}

HWY_INLINE float_vec within(float_vec v) {
    return hn::Min(hn::Max(v, hn::Zero(floats())), set(1));
}

/// a / b, or 0 where b is 0.
HWY_INLINE float_vec quotient(float_vec a, float_vec b) {
    const auto none = hn::Eq(b, hn::Zero(floats()));
    return hn::IfThenZeroElse(none, hn::Div(a, hn::IfThenElse(none, set(1), b)));
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
    const float_vec beyond = hn::Max(hn::Sub(high, hn::Max(low, set(1))), hn::Zero(floats()));
    const float_vec width = hn::Sub(high, low);
    const float_vec mean = hn::IfThenElse(hn::Eq(width, hn::Zero(floats())), first,
                                          quotient(hn::Add(inside, beyond), width));
    return hn::Mul(mean, hn::Sub(to, from));
}

/// A polygon, and some of its pixels.
class pair_lanes {
public:
    HWY_INLINE pair_lanes(const fragment_polygon& polygon, int_vec pixel_x, int_vec pixel_y)
        : polygon_(polygon) {
        const int_vec left = hn::ShiftLeft<l3d_subpixel_bits>(pixel_x);
        const int_vec top = hn::ShiftLeft<l3d_subpixel_bits>(pixel_y);
        const auto place = [&](std::int32_t of, int_vec corner) HWY_ATTR {
            const float_vec units = hn::ConvertTo(floats(), hn::Sub(hn::Set(ints(), of), corner));
            return hn::Mul(units, set(1.0f / l3d_subpixel_one));
        };
        for (std::size_t i = 0; i < 4; ++i) {
            x_[i] = place(polygon.x[i], left);
            y_[i] = place(polygon.y[i], top);
        }
        along1_x_ = hn::Sub(x_[2], x_[0]);
        along1_y_ = hn::Sub(y_[2], y_[0]);
        along2_x_ = hn::Sub(x_[3], x_[1]);
        along2_y_ = hn::Sub(y_[3], y_[1]);
        inverse_ =
            quotient(set(1), hn::Sub(hn::Mul(along1_x_, along2_y_), hn::Mul(along1_y_, along2_x_)));
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

        // Parts of the diagonals from the mean of the corners.
        const float_vec h_x = hn::Sub(x, mean_x_), h_y = hn::Sub(y, mean_y_);
        const float_vec s =
            hn::Mul(hn::Sub(hn::Mul(h_x, along2_y_), hn::Mul(h_y, along2_x_)), inverse_);
        const float_vec t =
            hn::Mul(hn::Sub(hn::Mul(along1_x_, h_y), hn::Mul(along1_y_, h_x)), inverse_);
        store_depth(to, at, s, t);
        store_level(to, at, s, t);
    }

private:
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
            float_vec from = set(0), end = set(1);
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
        const float_vec count = hn::Add(hn::Mul(within(place), set(mask_side)), set(0.5f));
        const int_vec samples = hn::ConvertTo(di, count);
        return hn::Sub(hn::Shl(hn::Set(di, 1), samples), hn::Set(di, 1));
    }

    HWY_INLINE void store_depth(pair_measures& to, std::size_t at, float_vec s, float_vec t) const {
        const floats d;
        const auto& inv_w = polygon_.inv_w;
        const float_vec first = set(inv_w[2] - inv_w[0]), second = set(inv_w[3] - inv_w[1]);
        const float_vec mean = set(0.25f * ((inv_w[0] + inv_w[2]) + (inv_w[1] + inv_w[3])));
        const float_vec there = hn::Add(mean, hn::Add(hn::Mul(s, first), hn::Mul(t, second)));
        const float_vec first1 = hn::Mul(first, inverse_), second1 = hn::Mul(second, inverse_);
        hn::StoreU(hn::Min(hn::Max(there, set(polygon_.farthest)), set(polygon_.nearest)), d,
                   to.inv_w.data() + at);
        hn::StoreU(hn::Sub(hn::Mul(first1, along2_y_), hn::Mul(second1, along1_y_)), d,
                   to.of_x.data() + at);
        hn::StoreU(hn::Sub(hn::Mul(second1, along1_x_), hn::Mul(first1, along2_x_)), d,
                   to.of_y.data() + at);
    }

    HWY_INLINE void store_level(pair_measures& to, std::size_t at, float_vec s, float_vec t) const {
        const float_vec level =
            polygon_.corners == 4 ? level_of_quad(s, t) : level_of_triangle(s, t);
        hn::StoreU(level, floats(), to.level.data() + at);
    }

    /// The bilinear map of a quad's corners' levels, and its sides' bends, at the parameters that a
    /// parallelogram would have. As level_lanes, for one place.
    HWY_INLINE float_vec level_of_quad(float_vec s, float_vec t) const {
        const auto& level = polygon_.light[0];
        const float_vec ab = set(polygon_.light[1][0]), ad = set(polygon_.light[2][0]);
        const float_vec bc = set(polygon_.light[2][1]), dc = set(polygon_.light[1][3]);
        const float_vec half = set(0.5f), one = set(1), four = set(4);
        const float_vec u = within(hn::Add(half, hn::Sub(s, t)));
        const float_vec v = within(hn::Add(half, hn::Add(s, t)));
        const float_vec u1 = hn::Sub(one, u), v1 = hn::Sub(one, v);
        const float_vec low = hn::Add(hn::Mul(u1, set(level[0])), hn::Mul(u, set(level[1])));
        const float_vec high = hn::Add(hn::Mul(u1, set(level[3])), hn::Mul(u, set(level[2])));
        const float_vec of_u =
            hn::Mul(hn::Mul(four, hn::Mul(u, u1)), hn::Add(hn::Mul(v1, ab), hn::Mul(v, dc)));
        const float_vec of_v =
            hn::Mul(hn::Mul(four, hn::Mul(v, v1)), hn::Add(hn::Mul(u1, ad), hn::Mul(u, bc)));
        return hn::Add(hn::Add(hn::Mul(v1, low), hn::Mul(v, high)), hn::Add(of_u, of_v));
    }

    /// The parabola through a triangle's corners and the middles of its sides. With d = c, the
    /// place is (1/4 - s) a + (1/4 - t) b + (1/2 + s + t) c.
    HWY_INLINE float_vec level_of_triangle(float_vec s, float_vec t) const {
        const auto& level = polygon_.light[0];
        const float_vec ab = set(polygon_.light[1][0]), ac = set(polygon_.light[2][0]);
        const float_vec bc = set(polygon_.light[2][1]);
        const float_vec b = within(hn::Sub(set(0.25f), t));
        const float_vec c = within(hn::Add(set(0.5f), hn::Add(s, t)));
        const float_vec a = hn::Sub(hn::Sub(set(1), b), c);
        const float_vec bends =
            hn::Add(hn::Mul(hn::Mul(a, b), ab),
                    hn::Add(hn::Mul(hn::Mul(a, c), ac), hn::Mul(hn::Mul(b, c), bc)));
        return hn::Add(hn::Add(hn::Mul(a, set(level[0])), hn::Mul(b, set(level[1]))),
                       hn::Add(hn::Mul(c, set(level[2])), hn::Mul(set(4), bends)));
    }

    const fragment_polygon& polygon_;
    float_vec x_[4], y_[4];
    float_vec along1_x_, along1_y_, along2_x_, along2_y_, inverse_; ///< diagonals; 1 / their cross
    float_vec mean_x_, mean_y_;
};

void measure_pairs(const band_fragments& band, pair_measures& to) {
    const ints d;
    std::size_t begin = 0;
    for (const fragment_polygon& polygon : band.polygons()) {
        for (std::size_t at = begin; at < polygon.pairs_end; at += lanes)
            pair_lanes(polygon, hn::LoadU(d, band.pair_x() + at), hn::LoadU(d, band.pair_y() + at))
                .store(to, at);
        begin = polygon.pairs_end;
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(measure_pairs);

void pair_measures::resize(std::size_t count) {
    // A polygon's last vector may be only begun.
    const std::size_t room = count + band_fragments::widest_vector;
    for (auto* const numbers : {&area, &x, &y, &inv_w, &of_x, &of_y, &level})
        if (numbers->size() < room)
            numbers->resize(room);
    for (auto* const bits : {&top, &bottom})
        if (bits->size() < room)
            bits->resize(room);
}

void measure_pairs(const band_fragments& band, pair_measures& to) {
    to.resize(band.pairs());
    L3D_SIMD_CALL(measure_pairs)(band, to);
}

} // namespace l3d_detail
#endif
