// SPDX-License-Identifier: MIT
// small_painter: planes of normals and their light, a pixel a lane.
#include "raster/shapes/small_painter_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/shapes/small_painter.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_doubles-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/shaders/normal_light-inl.h"
#include "raster/surfaces/away_from_eye_p.h"

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

using some_floats = hn::Rebind<float, eight_doubles>;
using some_integers = hn::Rebind<std::int32_t, eight_doubles>;
using float_lanes = hn::Vec<some_floats>;

HWY_INLINE number whole(const std::int32_t* from) {
    return {hn::PromoteTo(eight_doubles(), hn::Load(some_integers(), from))};
}
HWY_INLINE number real(const float* from) {
    return {hn::PromoteTo(eight_doubles(), hn::Load(some_floats(), from))};
}
HWY_INLINE float_lanes narrow(number x) {
    return hn::DemoteTo(some_floats(), x.v);
}

/// attribute_planes of triangles side by side, and a pixel of each: operation by operation the
/// same.
class pixel_planes {
public:
    HWY_INLINE pixel_planes(const small_pixels& of, std::size_t at) : of_(of), at_(at) {
        const number x = whole(of.x[0] + at), y = whole(of.y[0] + at);
        const number x1 = whole(of.x[1] + at) - x, y1 = whole(of.y[1] + at) - y;
        const number x2 = whole(of.x[2] + at) - x, y2 = whole(of.y[2] + at) - y;
        const number scale = same(1.0) / (x1 * y2 - y1 * x2); // exact: |products| <= 2^24
        x1_ = x1 * scale;
        y1_ = y1 * scale;
        x2_ = x2 * scale;
        y2_ = y2 * scale;
        to_x_ = centre(of.start + at) - x;
        to_y_ = centre(of.row + at) - y;
        column_ = hn::ConvertTo(some_floats(), hn::Load(some_integers(), of.column + at));
    }

    /// A number of the normal at each pixel.
    HWY_INLINE float_lanes at(std::size_t n) const {
        const number base = real(of_.normal[0][n] + at_);
        const number first = real(of_.normal[1][n] + at_) - base;
        const number second = real(of_.normal[2][n] + at_) - base;
        const number along_x = first * y2_ - second * y1_, along_y = second * x1_ - first * x2_;
        const float_lanes value = narrow(base + along_x * to_x_ + along_y * to_y_);
        return hn::Add(value, hn::Mul(narrow(along_x * same(l3d_subpixel_one)), column_));
    }

private:
    static HWY_INLINE number centre(const std::int32_t* index) {
        return same(l3d_subpixel_one) * (whole(index) + same(0.5));
    }

    const small_pixels& of_;
    std::size_t at_;
    number x1_, y1_, x2_, y2_, to_x_, to_y_;
    float_lanes column_;
};

/// What is behind `count` in a vector is no pixel, and its word is not used.
void light_pixels(small_pixels& pixels, std::size_t count, const std::array<float, 3>& light,
                  bool with_away) {
    const some_floats d;
    const hn::RebindToUnsigned<some_floats> dw;
    const normal_light<some_floats> lambert(light);
    for (std::size_t i = 0; i < count; i += hn::MaxLanes(d)) {
        const pixel_planes planes(pixels, i);
        const auto away = with_away ? planes.at(3) : hn::Zero(d);
        const auto level =
            lambert.level(planes.at(0), planes.at(1), planes.at(2), hn::Gt(away, hn::Zero(d)));
        hn::Store(hn::Mul(level, hn::Set(dw, 0x010101u)), dw, pixels.word + i);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(light_pixels);

void small_painter::begin(l3d_pixels target, const l3d_shading& shading) {
    shading_ = &shading;
    target_ = target;
    count_ = 0;
    const auto is_zero = [](float number) { return number == 0; };
    with_away_ = !(std::ranges::all_of(shading.ray, is_zero) &&
                   std::ranges::all_of(shading.ray_right, is_zero) &&
                   std::ranges::all_of(shading.ray_down, is_zero));
}

std::int64_t small_painter::paint(const l3d_painter_piece& piece,
                                  const l3d_painter_triangle& triangle, scan_rows rows,
                                  std::uint32_t color, open_pixels* open) {
    constexpr std::int32_t side = l3d_painter_piece::small_side;
    std::int64_t painted = 0;
    std::int32_t row = piece.top;
    for (std::uint64_t left = piece.cover; left != 0; left >>= side, ++row) {
        const std::uint64_t in_row = left & ((1U << side) - 1);
        if (in_row == 0 || row < rows.top || row >= rows.bottom)
            continue;
        const std::int32_t start = std::countr_zero(in_row);
        std::uint64_t wanted = open ? open->take(row, piece.left, in_row) : in_row;
        for (; wanted != 0; wanted &= wanted - 1, ++painted)
            add(triangle.v, piece.left + start, row, std::countr_zero(wanted) - start, color);
    }
    return painted;
}

void small_painter::add(const std::array<l3d_micro_vertex, 3>& v, std::int32_t start,
                        std::int32_t row, std::int32_t column, std::uint32_t color) {
    if (count_ == small_pixels::room)
        finish();
    const std::size_t i = count_++;
    for (std::size_t k = 0; k < v.size(); ++k) {
        waiting_.x[k][i] = v[k].x;
        waiting_.y[k][i] = v[k].y;
        for (std::size_t n = 0; n < 3; ++n)
            waiting_.normal[k][n][i] = v[k].normal[n];
        if (with_away_)
            waiting_.normal[k][3][i] = away_from_eye(v[k], *shading_);
    }
    waiting_.start[i] = start;
    waiting_.row[i] = row;
    waiting_.column[i] = column;
    colors_[i] = color;
    places_[i] = target_.row(row).data() + start + column;
}

void small_painter::finish() {
    if (count_ == 0)
        return;
    L3D_SIMD_CALL(light_pixels)(waiting_, count_, shading_->light, with_away_);
    for (std::size_t i = 0; i < count_; ++i)
        *places_[i] = l3d_product_of_colors(colors_[i], waiting_.word[i]);
    count_ = 0;
}

} // namespace l3d_detail
#endif
