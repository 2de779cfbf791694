// SPDX-License-Identifier: MIT
// Holds doubles in lanes, at most eight, with operators, and vectors of three of them.
#if defined(L3D_RASTER_PARALLEL_LANE_DOUBLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_PARALLEL_LANE_DOUBLES_INL_H
#undef L3D_RASTER_PARALLEL_LANE_DOUBLES_INL_H
#else
#define L3D_RASTER_PARALLEL_LANE_DOUBLES_INL_H
#endif

#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using eight_doubles = hn::CappedTag<double, 8>;

/// A double in each lane. Each product and each sum is rounded separately, so every instruction set
/// gives the same bits.
struct number {
    hn::Vec<eight_doubles> v;

    HWY_ATTR HWY_INLINE friend number operator+(number a, number b) { return {hn::Add(a.v, b.v)}; }
    HWY_ATTR HWY_INLINE friend number operator-(number a, number b) { return {hn::Sub(a.v, b.v)}; }
    HWY_ATTR HWY_INLINE friend number operator*(number a, number b) { return {hn::Mul(a.v, b.v)}; }
    HWY_ATTR HWY_INLINE friend number operator/(number a, number b) { return {hn::Div(a.v, b.v)}; }
};

HWY_ATTR HWY_INLINE number same(double x) {
    return {hn::Set(eight_doubles(), x)};
}
HWY_ATTR HWY_INLINE number loaded(const double* from) {
    return {hn::Load(eight_doubles(), from)};
}
HWY_ATTR HWY_INLINE void store(number x, double* to) {
    hn::Store(x.v, eight_doubles(), to);
}
HWY_ATTR HWY_INLINE number largest(number a, number b) {
    return {hn::Max(a.v, b.v)};
}
HWY_ATTR HWY_INLINE number magnitude(number a) {
    return {hn::Abs(a.v)};
}
HWY_ATTR HWY_INLINE number root(number a) {
    return {hn::Sqrt(a.v)};
}
HWY_ATTR HWY_INLINE std::size_t lanes_at_once() {
    return hn::Lanes(eight_doubles());
}

struct vector {
    number x, y, z;

    HWY_ATTR HWY_INLINE friend vector operator+(const vector& a, const vector& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    HWY_ATTR HWY_INLINE friend vector operator-(const vector& a, const vector& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    HWY_ATTR HWY_INLINE friend vector operator*(const vector& a, number s) {
        return {a.x * s, a.y * s, a.z * s};
    }
};

HWY_ATTR HWY_INLINE number dot(const vector& a, const vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
HWY_ATTR HWY_INLINE number squared(const vector& a) {
    return dot(a, a);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
