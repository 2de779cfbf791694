// SPDX-License-Identifier: MIT
// pixel_samples: tests sides of polygons against 64 samples, and finds the nearest polygon at each.
#include "raster/refine/pixel_samples_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/refine/pixel_samples.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_integers-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/refine/half_planes_p.h"
#include "raster/refine/sample_places_p.h"

#include <algorithm>

#ifndef L3D_RASTER_PIXEL_SAMPLES_ONCE
#define L3D_RASTER_PIXEL_SAMPLES_ONCE
namespace l3d_detail {

/// A fragment that the fragments before it have not hidden wholly. Its plane of depth is relative
/// to the pixel's middle.
struct seen_so_far {
    std::uint64_t samples;
    std::uint32_t polygon;
    float depth, right, down;
};

} // namespace l3d_detail
#endif

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

constexpr hn::CappedTag<float, 4> side_floats;
constexpr hn::RebindToSigned<decltype(side_floats)> side_ints;

/// The four sides of a polygon, which find the samples on their inner sides.
///
/// A side is measured downwards, or to the right if it is horizontal, whichever of the two polygons
/// beside it asks. One polygon takes the samples on one side of the line, and the other polygon
/// takes all the rest. So each sample is in exactly one of both polygons.
class polygon_sides {
public:
    HWY_ATTR HWY_INLINE void begin(const fragment_polygon& of) {
        const auto zero = hn::Zero(side_floats), one = hn::Set(side_floats, 1.0f);
        const auto turns_left = hn::Gt(hn::Set(side_floats, of.area2 > 0 ? 0.0f : 1.0f), zero);
        for (std::size_t at = 0; at < 4; at += hn::MaxLanes(side_floats)) {
            const auto load = [&](const std::int32_t* from) HWY_ATTR {
                return hn::ConvertTo(side_floats, hn::LoadU(side_ints, from + at));
            };
            const auto x0 = load(of.x), x1 = load(of.x + 1), y0 = load(of.y), y1 = load(of.y + 1);
            const auto is_up = hn::Or(hn::Gt(y0, y1), hn::And(hn::Eq(y0, y1), hn::Gt(x0, x1)));
            const auto right = hn::Sub(x1, x0);
            const auto dx = hn::IfThenElse(is_up, hn::Neg(right), right),
                       dy = hn::Abs(hn::Sub(y1, y0)), size = hn::Add(hn::Abs(dx), dy);
            // A side that is a point has all samples on its inner side.
            const auto is_point = hn::Eq(size, zero);
            const auto scale = hn::Div(one, hn::IfThenElse(is_point, one, size));
            const auto to_steps =
                hn::Mul(scale, hn::Set(side_floats, 1.0f * half_planes::steps / l3d_subpixel_one));
            hn::Store(hn::IfThenElse(is_up, x1, x0), side_floats, x_ + at);
            hn::Store(hn::IfThenElse(is_up, y1, y0), side_floats, y_ + at);
            hn::Store(hn::Mul(dy, to_steps), side_floats, per_x_ + at);
            hn::Store(hn::Mul(dx, to_steps), side_floats, per_y_ + at);
            const auto middle = hn::IfThenElse(is_point, hn::Set(side_floats, last_step),
                                               hn::Set(side_floats, half_planes::middle));
            const auto is_other = hn::AndNot(is_point, hn::Xor(is_up, turns_left));
            const auto margin = hn::Set(side_floats, tile_margin * half_planes::steps);
            hn::Store(middle, side_floats, middle_ + at);
            hn::Store(hn::Add(middle, hn::IfThenElse(is_other, hn::Neg(margin), margin)),
                      side_floats, in_tile_ + at);
            const auto turn = hn::ConvertTo(
                side_ints,
                hn::Add(hn::Mul(hn::Mul(dx, scale), hn::Set(side_floats, half_planes::first_turn)),
                        hn::Set(side_floats, half_planes::first_turn + 0.5f)));
            hn::Store(hn::Sub(hn::Mul(turn, hn::Set(side_ints, half_planes::in_row)),
                              hn::BitCast(side_ints, hn::Set(side_floats, whole))),
                      side_ints, rows_ + at);
            hn::Store(hn::BitCast(side_ints, hn::VecFromMask(side_floats, is_other)), side_ints,
                      others_ + at);
        }
    }

    /// Finds the pixels of a tile that have samples in the polygon, and a few other pixels.
    HWY_ATTR HWY_INLINE std::uint64_t reached(std::int32_t left, std::int32_t top,
                                              const std::uint64_t* masks) {
        constexpr float middle = marked_pixels::side * l3d_subpixel_one / 2;
        return inside(static_cast<float>(left * l3d_subpixel_one) + middle,
                      static_cast<float>(top * l3d_subpixel_one) + middle,
                      1.0f / marked_pixels::side, in_tile_, masks);
    }

    /// Finds the samples of a pixel that lie in the polygon.
    HWY_ATTR HWY_INLINE std::uint64_t samples(std::int32_t x, std::int32_t y,
                                              const std::uint64_t* masks) {
        constexpr float middle = l3d_subpixel_one / 2;
        return inside(static_cast<float>(x * l3d_subpixel_one) + middle,
                      static_cast<float>(y * l3d_subpixel_one) + middle, 1, middle_, masks);
    }

private:
    /// Floats of this size have no fraction, so adding this number to a smaller one rounds the
    /// smaller number to a whole number.
    static constexpr float whole = 1 << 23;
    static constexpr float last_step = half_planes::steps + 1;

    /// The distance by which the test of a tile reaches beyond its pixels' middles, in the units of
    /// half_planes. A pixel's border is 1/2 pixel away. Half a step in direction counts at places
    /// up to 1/2 away, and half a step of e is added.
    static constexpr float tile_margin =
        0.5f / marked_pixels::side + 1.0f / half_planes::turns + 0.5f / half_planes::steps;

    /// Finds the places of a table in a square around (x, y) that lie on the inner side of all four
    /// sides.
    HWY_ATTR HWY_INLINE std::uint64_t inside(float x, float y, float per_side,
                                             const float* in_middle,
                                             const std::uint64_t* masks) const {
        alignas(16) std::int32_t places[4];
        for (std::size_t at = 0; at < 4; at += hn::MaxLanes(side_floats)) {
            const auto across =
                           hn::Mul(hn::Sub(hn::Load(side_floats, x_ + at), hn::Set(side_floats, x)),
                                   hn::Load(side_floats, per_x_ + at)),
                       down =
                           hn::Mul(hn::Sub(hn::Set(side_floats, y), hn::Load(side_floats, y_ + at)),
                                   hn::Load(side_floats, per_y_ + at));
            const auto step =
                hn::Add(hn::Mul(hn::Add(across, down), hn::Set(side_floats, per_side)),
                        hn::Load(side_floats, in_middle + at));
            const auto held =
                hn::Min(hn::Max(step, hn::Zero(side_floats)), hn::Set(side_floats, last_step));
            hn::Store(hn::Add(hn::BitCast(side_ints, hn::Add(held, hn::Set(side_floats, whole))),
                              hn::Load(side_ints, rows_ + at)),
                      side_ints, places + at);
        }
        std::uint64_t result = ~std::uint64_t{0};
        for (std::size_t side = 0; side < 4; ++side)
            result &= masks[places[side]] ^ static_cast<std::uint64_t>(std::int64_t{others_[side]});
        return result;
    }

    alignas(16) float x_[4], y_[4], per_x_[4], per_y_[4], middle_[4], in_tile_[4];
    alignas(16) std::int32_t rows_[4];
    alignas(16) std::int32_t others_[4]; ///< -1: the side has the places that a mask lacks; or 0
};

std::size_t cover(const fragment_polygon& of, std::uint32_t name, const l3d_pixel_box& box,
                  marked_pixels& pixels, fragment* to, std::uint32_t first) {
    const std::uint64_t* const of_pixels = planes_of_pixels().masks();
    const std::uint64_t* const of_samples = planes_of_samples().masks();
    const auto [farthest, nearest] =
        std::minmax({of.inv_w[0], of.inv_w[1], of.inv_w[2], of.inv_w[3]});
    std::uint32_t count = 0;
    polygon_sides sides;
    bool has_sides = false;
    for (marked_pixels::open_tiles tiles(pixels, box); tiles.next();) {
        if (!has_sides)
            sides.begin(of);
        has_sides = true;
        std::uint64_t bits = tiles.bits() & sides.reached(tiles.left(), tiles.top(), of_pixels);
        for (; bits != 0; bits &= bits - 1) {
            const std::uint64_t earlier = tiles.here().bits & ((bits & -bits) - 1);
            marked_pixel& pixel =
                pixels.pixels()[tiles.here().first +
                                static_cast<std::uint32_t>(__builtin_popcountll(earlier))];
            if (!(nearest >= pixel.farthest))
                continue;
            const std::uint64_t samples = sides.samples(pixel.x, pixel.y, of_samples);
            if (samples == 0)
                continue;
            to[count] = {samples, name, pixel.last};
            pixel.last = first + count++;
            pixel.covered |= samples;
            pixel.least = std::min(pixel.least, farthest);
            if (pixel.covered == ~std::uint64_t{0})
                pixel.farthest = std::max(pixel.farthest, pixel.least);
        }
    }
    return count;
}

/// Finds the pixels whose samples may lie in each quad between two rows of vertices, as a box
/// within `inside` for each column.
void find_boxes(const l3d_micro_grid& grid, std::size_t first, std::size_t count,
                const l3d_pixel_box& inside, std::int32_t* const (&to)[4]) {
    constexpr std::int32_t step = l3d_subpixel_one / sample_places::cells / 2;
    const auto pitch = static_cast<std::size_t>(grid.pitch);
    for (std::size_t i = 0; i < count; i += lanes) {
        const auto range = [&](std::span<const std::int32_t> of, std::int32_t begin,
                               std::int32_t end, std::int32_t* least_to,
                               std::int32_t* most_to) HWY_ATTR {
            const int_vec a = load_from(of, first + i), b = load_from(of, first + i + 1),
                          c = load_from(of, first + i + pitch),
                          d = load_from(of, first + i + pitch + 1);
            const int_vec least = hn::Min(hn::Min(a, b), hn::Min(c, d)),
                          most = hn::Max(hn::Max(a, b), hn::Max(c, d));
            const int_vec from = hn::ShiftRight<l3d_subpixel_bits>(hn::Add(least, set(step - 1)));
            const int_vec last = hn::ShiftRight<l3d_subpixel_bits>(hn::Sub(most, set(step)));
            hn::StoreU(hn::Max(from, set(begin)), ints(), least_to + i);
            hn::StoreU(hn::Min(hn::Add(last, set(1)), set(end)), ints(), most_to + i);
        };
        range(grid.x, inside.left, inside.right, to[0], to[2]);
        range(grid.y, inside.top, inside.bottom, to[1], to[3]);
    }
}

HWY_ATTR HWY_INLINE seen_fragment measured(const seen_so_far& of, const marked_pixel& pixel) {
    constexpr std::uint64_t all = ~std::uint64_t{0};
    constexpr auto digits_x = sample_places::digits(the_samples.x);
    constexpr auto digits_y = sample_places::digits(the_samples.y);
    const auto x = static_cast<float>(pixel.x), y = static_cast<float>(pixel.y);
    if (of.samples == all)
        return {all, of.polygon, sample_places::count, x + 0.5f, y + 0.5f};
    const int count = __builtin_popcountll(of.samples);
    int sum_x = 0, sum_y = 0;
    for (unsigned digit = 0; digit < digits_x.size(); ++digit) {
        sum_x += __builtin_popcountll(of.samples & digits_x[digit]) << digit;
        sum_y += __builtin_popcountll(of.samples & digits_y[digit]) << digit;
    }
    constexpr float cell = 1.0f / sample_places::cells;
    const float part = cell / static_cast<float>(count);
    return {of.samples, of.polygon, count, x + (static_cast<float>(sum_x) * part + 0.5f * cell),
            y + (static_cast<float>(sum_y) * part + 0.5f * cell)};
}

/// If the fragment `here` shares samples with fragments in `seen`, gives each shared sample to the
/// nearer fragment alone. Returns how many fragments of `seen` still have samples.
HWY_ATTR HWY_INLINE std::size_t divide(seen_so_far* seen, std::size_t count, seen_so_far& here,
                                       const half_planes& planes) {
    bool any_gone = false;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t both = here.samples & seen[i].samples;
        if (both == 0)
            continue;
        const std::uint64_t nearer =
            both & planes.not_negative(here.depth - seen[i].depth, here.right - seen[i].right,
                                       here.down - seen[i].down);
        seen[i].samples &= ~nearer;
        here.samples &= ~(both ^ nearer);
        any_gone |= seen[i].samples == 0;
    }
    if (!any_gone)
        return count;
    std::size_t left = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (seen[i].samples != 0)
            seen[left++] = seen[i];
    return left;
}

/// Finds the visible fragments of a pixel, beginning with the fragment that came last. No two
/// visible fragments share a sample, so there are 64 at most.
HWY_ATTR HWY_INLINE std::size_t see(std::span<const fragment_polygon> polygons,
                                    std::span<const fragment> fragments, const marked_pixel& pixel,
                                    const half_planes& planes,
                                    seen_so_far (&seen)[sample_places::count + 1]) {
    const float x = static_cast<float>(pixel.x) + 0.5f, y = static_cast<float>(pixel.y) + 0.5f;
    std::size_t count = 0;
    std::uint64_t covered = 0;
    for (std::uint32_t at = pixel.last; at != fragment::none; at = fragments[at].before) {
        const fragment_polygon& of = polygons[fragments[at].polygon];
        seen_so_far here{fragments[at].samples, fragments[at].polygon, of.at(of.depth, x, y),
                         of.depth.right, of.depth.down};
        if ((here.samples & covered) != 0)
            count = divide(seen, count, here, planes);
        covered |= here.samples;
        if (here.samples != 0)
            seen[count++] = here;
    }
    return count;
}

void see_all(std::span<const fragment_polygon> polygons, std::span<const fragment> fragments,
             std::span<const marked_pixel> pixels, seen_in_pixels& to) {
    const half_planes& planes = planes_of_samples();
    seen_so_far seen[sample_places::count + 1];
    std::size_t count = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        to.begins[i] = count;
        for (std::size_t n = see(polygons, fragments, pixels[i], planes, seen); n > 0; --n)
            to.fragments[count++] = measured(seen[n - 1], pixels[i]);
    }
    to.begins[pixels.size()] = count;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(cover);
L3D_SIMD_TABLE(find_boxes);
L3D_SIMD_TABLE(see_all);

std::size_t cover_samples(const fragment_polygon& of, std::uint32_t name, const l3d_pixel_box& box,
                          marked_pixels& pixels, fragment* to, std::uint32_t first) {
    return L3D_SIMD_CALL(cover)(of, name, box, pixels, to, first);
}

void quad_boxes::find(const l3d_micro_grid& grid, std::size_t first, std::size_t count,
                      const l3d_pixel_box& inside) {
    constexpr std::size_t widest_vector = 16;
    for (auto* const numbers : {&left, &top, &right, &bottom})
        if (numbers->size() < count + widest_vector)
            numbers->resize(count + widest_vector);
    L3D_SIMD_CALL(find_boxes)
    (grid, first, count, inside, {left.data(), top.data(), right.data(), bottom.data()});
}

void see_samples(std::span<const fragment_polygon> polygons, std::span<const fragment> fragments,
                 std::span<const marked_pixel> pixels, seen_in_pixels& to) {
    L3D_SIMD_CALL(see_all)(polygons, fragments, pixels, to);
}

} // namespace l3d_detail
#endif
