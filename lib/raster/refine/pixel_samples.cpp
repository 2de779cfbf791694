// SPDX-License-Identifier: MIT
// pixel_samples: sides of polygons against 64 samples, and what is nearest at each.
#include "raster/refine/pixel_samples_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/refine/pixel_samples.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"
#include "raster/refine/sample_places_p.h"
#include "raster/surfaces/quad_cut_p.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#ifndef L3D_RASTER_PIXEL_SAMPLES_ONCE
#define L3D_RASTER_PIXEL_SAMPLES_ONCE
namespace l3d_detail {

/// Places of samples from the pixel's middle. Units: pixels.
struct sample_offsets {
    alignas(64) std::array<float, sample_places::count> x{}, y{};

    constexpr sample_offsets() {
        constexpr float cell = 1.0f / sample_places::cells;
        for (std::size_t i = 0; i < sample_places::count; ++i) {
            x[i] = cell * (static_cast<float>(the_samples.x[i]) + 0.5f) - 0.5f;
            y[i] = cell * (static_cast<float>(the_samples.y[i]) + 0.5f) - 0.5f;
        }
    }
};
inline constexpr sample_offsets offsets;

/// Samples in the order of pairs of vectors: the first of a pair has the even ones of those that
/// both have, the second the odd ones. So bytes of both, next to each other, are in order.
template <std::size_t Lanes> struct paired_samples {
    alignas(64) std::array<std::int16_t, sample_places::count> x{}, y{};

    constexpr paired_samples() {
        for (std::size_t i = 0; i < sample_places::count; ++i) {
            const std::size_t pair = i / (2 * Lanes) * (2 * Lanes);
            const std::size_t from = pair + i % Lanes * 2 + i / Lanes % 2;
            x[i] = the_samples.x[from];
            y[i] = the_samples.y[from];
        }
    }
};

/// A fragment that is seen so far, and its plane of depth in the pixel's middle.
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

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<std::int16_t, 32> shorts;
constexpr hn::CappedTag<float, 16> floats;
constexpr hn::CappedTag<double, 4> doubles;
constexpr hn::Rebind<std::int32_t, decltype(doubles)> side_ints;
constexpr hn::CappedTag<std::int32_t, 16> ints;
constexpr std::size_t tile_side = marked_pixels::side;
constexpr hn::CappedTag<std::int32_t, tile_side> row_ints;
constexpr std::size_t row_lanes = hn::MaxLanes(row_ints);
using double_vec = hn::Vec<decltype(doubles)>;
using short_vec = hn::Vec<decltype(shorts)>;
constexpr std::size_t short_lanes = hn::MaxLanes(shorts), float_lanes = hn::MaxLanes(floats);
constexpr paired_samples<short_lanes> paired;

/// Lane i is bit i.
template <class D> HWY_ATTR HWY_INLINE std::uint64_t bits_of(D d, hn::Mask<D> mask) {
    std::uint8_t in_bytes[sizeof(std::uint64_t)] = {};
    hn::StoreMaskBits(d, mask, in_bytes);
    std::uint64_t bits = 0;
    std::memcpy(&bits, in_bytes, sizeof bits);
    return bits;
}

/// The bits of a pair of vectors of paired_samples.
template <class Mask> HWY_ATTR HWY_INLINE std::uint64_t bits_of_pair(Mask even, Mask odd) {
    if constexpr (short_lanes == 1) {
        return bits_of(shorts, even) | bits_of(shorts, odd) << 1;
    } else {
        const hn::Repartition<std::int8_t, decltype(shorts)> bytes;
        const auto both = hn::OddEven(hn::BitCast(bytes, hn::VecFromMask(shorts, odd)),
                                      hn::BitCast(bytes, hn::VecFromMask(shorts, even)));
        return bits_of(bytes, hn::MaskFromVec(both));
    }
}

/// A polygon's sides, in the way round that has the inside on the right.
///
/// With E = dx (y - y0) - dy (x - x0) a sample is inside if E > 0, or if E = 0 at a left or an
/// upper side. Let c be E at sample (0, 0) of a pixel, and 1 more at these sides, and let t be c /
/// 16 rounded up. Sample (i, j) is inside if dy i - dx j < t. The polygon beside the same side has
/// -dx, -dy and 1 - c, so 1 - t, and its samples are exactly the others. Places are less than 2^24
/// and c less than 2^50, so that all of it is exact in double.
///
/// 15 (|dx| + |dy|) fits 16 bits if the sum is no more than 2184, eight pixels and a half. Longer
/// sides are halved until they are, towards 0, and c with them. Again both polygons do the same. A
/// side is turned by less than 1/1092, which moves it by less than 1/1000 pixel within a pixel.
/// From pixel to pixel, t grows by whole steps; c is taken anew in every tile, where these may be
/// off by 16/1092 of a cell.
class polygon_sides {
public:
    HWY_ATTR HWY_INLINE void begin(const fragment_polygon& of) {
        const double_vec way_round = hn::Set(doubles, of.area2 > 0 ? 1.0 : -1.0);
        const std::int32_t next_x[4] = {of.x[1], of.x[2], of.x[3], of.x[0]};
        const std::int32_t next_y[4] = {of.y[1], of.y[2], of.y[3], of.y[0]};
        for (std::size_t at = 0; at < 4; at += hn::MaxLanes(doubles)) {
            const auto load = [&](const std::int32_t* from) HWY_ATTR {
                return hn::PromoteTo(doubles, hn::LoadU(side_ints, from + at));
            };
            const double_vec x = load(of.x), y = load(of.y);
            const double_vec dx = hn::Mul(way_round, hn::Sub(load(next_x), x));
            const double_vec dy = hn::Mul(way_round, hn::Sub(load(next_y), y));
            const double_vec zero = hn::Zero(doubles), one = hn::Set(doubles, 1.0);
            const auto takes_side =
                hn::Or(hn::Lt(dy, zero), hn::And(hn::Eq(dy, zero), hn::Ge(dx, zero)));
            hn::Store(x, doubles, x_ + at);
            hn::Store(y, doubles, y_ + at);
            hn::Store(dx, doubles, dx_ + at);
            hn::Store(dy, doubles, dy_ + at);
            hn::Store(hn::IfThenElseZero(takes_side, one), doubles, takes_side_ + at);
            const double_vec scale = scale_of(hn::Add(hn::Abs(dx), hn::Abs(dy)));
            hn::Store(hn::Mul(scale, hn::Set(doubles, 1.0 / cell)), doubles, scale_ + at);
            const double_vec cells = hn::Mul(scale, hn::Set(doubles, sample_places::cells));
            const auto whole = [&](double_vec number) HWY_ATTR {
                return hn::DemoteTo(side_ints, number); // towards 0
            };
            hn::Store(whole(hn::Mul(scale, dx)), side_ints, short_x_ + at);
            hn::Store(whole(hn::Mul(scale, dy)), side_ints, short_y_ + at);
            const double_vec last = hn::Mul(scale, hn::Set(doubles, sample_places::cells - 1.0));
            hn::Store(whole(hn::Add(hn::Min(hn::Mul(last, dy), zero),
                                    hn::Min(hn::Mul(last, hn::Neg(dx)), zero))),
                      side_ints, least_ + at);
            hn::Store(whole(hn::Mul(cells, hn::Neg(dy))), side_ints, right_ + at);
            hn::Store(whole(hn::Mul(cells, dx)), side_ints, down_ + at);
        }
        for (std::size_t side = 0; side < 4; ++side) {
            const short_vec dx = hn::Set(shorts, static_cast<std::int16_t>(short_x_[side])),
                            dy = hn::Set(shorts, static_cast<std::int16_t>(short_y_[side]));
            for (std::size_t at = 0; at < sample_places::count; at += short_lanes)
                hn::Store(hn::Sub(hn::Mul(dy, hn::Load(shorts, paired.x.data() + at)),
                                  hn::Mul(dx, hn::Load(shorts, paired.y.data() + at))),
                          shorts, products_[side] + at);
            for (std::size_t at = 0; at < tile_side; at += row_lanes)
                hn::Store(hn::Mul(hn::Set(row_ints, right_[side]),
                                  hn::Iota(row_ints, static_cast<std::int32_t>(at))),
                          row_ints, columns_[side] + at);
        }
    }

    /// Goes to the tile whose first pixel this is. Numbers t of far sides are held, the same on
    /// both of their sides: in a tile, they change by less than 2^20.
    HWY_ATTR HWY_INLINE void begin_tile(std::int32_t left, std::int32_t top) {
        constexpr double most = 1 << 29;
        constexpr double pixel = l3d_subpixel_one, first = 0.5 * cell;
        const double_vec column = hn::Set(doubles, pixel * left + first),
                         row = hn::Set(doubles, pixel * top + first);
        for (std::size_t at = 0; at < 4; at += hn::MaxLanes(doubles)) {
            const auto load = [&](const double* from)
                                  HWY_ATTR { return hn::Load(doubles, from + at); };
            const double_vec c = hn::Add(hn::Sub(hn::Mul(load(dx_), hn::Sub(row, load(y_))),
                                                 hn::Mul(load(dy_), hn::Sub(column, load(x_)))),
                                         load(takes_side_));
            const double_vec t = hn::Ceil(hn::Mul(c, load(scale_)));
            const double_vec held =
                hn::Min(hn::Max(t, hn::Set(doubles, 1 - most)), hn::Set(doubles, most));
            hn::Store(hn::DemoteTo(side_ints, held), side_ints, t_ + at);
        }
    }

    /// Goes to a row of the tile. Returns: a bit for each pixel not all of whose samples are beyond
    /// one side.
    HWY_ATTR HWY_INLINE std::uint64_t begin_row(std::int32_t row) {
        alignas(16) std::int32_t first[4];
        for (std::size_t at = 0; at < 4; at += hn::MaxLanes(doubles))
            hn::Store(hn::Add(hn::Load(side_ints, t_ + at),
                              hn::Mul(hn::Load(side_ints, down_ + at), hn::Set(side_ints, row))),
                      side_ints, first + at);
        const auto most = hn::Set(row_ints, std::numeric_limits<std::int16_t>::max());
        std::uint64_t reached = 0;
        for (std::size_t at = 0; at < tile_side; at += row_lanes) {
            auto all = hn::FirstN(row_ints, row_lanes);
            for (std::size_t side = 0; side < 4; ++side) {
                const auto there = hn::Add(hn::Set(row_ints, first[side]),
                                           hn::Load(row_ints, columns_[side] + at));
                hn::Store(hn::Min(there, most), row_ints, here_[side] + at);
                all = hn::And(all, hn::Gt(there, hn::Set(row_ints, least_[side])));
            }
            reached |= bits_of(row_ints, all) << at;
        }
        return reached;
    }

    /// The samples of one of these.
    HWY_ATTR HWY_INLINE std::uint64_t samples(std::size_t column) const {
        const auto inside = [&](std::size_t at) HWY_ATTR {
            const auto before = [&](std::size_t side) HWY_ATTR {
                return hn::Gt(hn::Set(shorts, static_cast<std::int16_t>(here_[side][column])),
                              hn::Load(shorts, products_[side] + at));
            };
            return hn::And(hn::And(before(0), before(1)), hn::And(before(2), before(3)));
        };
        std::uint64_t samples = 0;
        for (std::size_t at = 0; at < sample_places::count; at += 2 * short_lanes)
            samples |= bits_of_pair(inside(at), inside(at + short_lanes)) << at;
        return samples;
    }

private:
    static constexpr int longest = 32767 / (sample_places::cells - 1);
    static constexpr int cell = l3d_subpixel_one / sample_places::cells;

    /// How much sides are shortened.
    static HWY_ATTR HWY_INLINE double_vec scale_of(double_vec size) {
        const double_vec least = hn::Set(doubles, longest + 1.0), half = hn::Set(doubles, 0.5);
        double_vec scale = hn::Set(doubles, 1.0);
        for (auto is_long = hn::Ge(size, least); !hn::AllFalse(doubles, is_long);
             is_long = hn::Ge(size, least)) {
            size = hn::IfThenElse(is_long, hn::Mul(size, half), size);
            scale = hn::IfThenElse(is_long, hn::Mul(scale, half), scale);
        }
        return scale;
    }

    alignas(64) std::int16_t products_[4][sample_places::count];
    alignas(64) std::int32_t columns_[4][tile_side], here_[4][tile_side]; ///< t added, and t
    alignas(32) double x_[4], y_[4], dx_[4], dy_[4], takes_side_[4], scale_[4];
    alignas(16) std::int32_t short_x_[4], short_y_[4], least_[4], right_[4], down_[4], t_[4];
};

std::size_t cover(const fragment_polygon& of, std::uint32_t name, const l3d_pixel_box& box,
                  marked_pixels& pixels, fragment* to, std::uint32_t first) {
    constexpr std::int32_t side = marked_pixels::side;
    constexpr std::uint64_t a_row = (1u << side) - 1;
    const auto depths = std::minmax({of.inv_w[0], of.inv_w[1], of.inv_w[2], of.inv_w[3]});
    const float farthest = depths.first, nearest = depths.second;
    std::uint32_t count = 0;
    polygon_sides sides;
    bool has_sides = false;
    pixels.visit(box, [&](const marked_pixels::tile& tile, std::int32_t left, std::int32_t top,
                          std::uint64_t bits) HWY_ATTR {
        if (!has_sides)
            sides.begin(of);
        has_sides = true;
        sides.begin_tile(left, top);
        while (bits != 0) {
            const int row = std::countr_zero(bits) / side;
            std::uint64_t reached = bits & sides.begin_row(row) << (row * side);
            bits &= ~(a_row << (row * side));
            for (; reached != 0; reached &= reached - 1) {
                const std::uint64_t earlier = tile.bits & ((reached & -reached) - 1);
                marked_pixel& pixel =
                    pixels.pixels()[tile.first +
                                    static_cast<std::uint32_t>(__builtin_popcountll(earlier))];
                if (!(nearest >= pixel.farthest))
                    continue;
                const std::uint64_t samples =
                    sides.samples(static_cast<std::size_t>(std::countr_zero(reached)) % tile_side);
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
    });
    return count;
}

/// The least and the most of two rows of vertices in each column.
void find_boxes(const l3d_micro_grid& grid, std::size_t first, std::size_t count,
                const l3d_pixel_box& inside, std::int32_t* const (&to)[4]) {
    constexpr std::int32_t step = l3d_subpixel_one / sample_places::cells / 2;
    const auto pitch = static_cast<std::size_t>(grid.pitch);
    const std::size_t lanes = hn::Lanes(ints), size = grid.x.size();
    std::int32_t copy[hn::MaxLanes(ints)] = {};
    const auto load = [&](const std::vector<std::int32_t>& of, std::size_t at) HWY_ATTR {
        if (HWY_LIKELY(at + lanes <= size))
            return hn::LoadU(ints, of.data() + at);
        std::copy(of.data() + std::min(at, size), of.data() + size, copy);
        return hn::LoadU(ints, copy);
    };
    for (std::size_t i = 0; i < count; i += lanes) {
        const auto range = [&](const std::vector<std::int32_t>& of, std::int32_t begin,
                               std::int32_t end, std::int32_t* least_to,
                               std::int32_t* most_to) HWY_ATTR {
            const auto a = load(of, first + i), b = load(of, first + i + 1),
                       c = load(of, first + i + pitch), d = load(of, first + i + pitch + 1);
            const auto least = hn::Min(hn::Min(a, b), hn::Min(c, d)),
                       most = hn::Max(hn::Max(a, b), hn::Max(c, d));
            const auto from =
                hn::ShiftRight<l3d_subpixel_bits>(hn::Add(least, hn::Set(ints, step - 1)));
            const auto last = hn::ShiftRight<l3d_subpixel_bits>(hn::Sub(most, hn::Set(ints, step)));
            hn::StoreU(hn::Max(from, hn::Set(ints, begin)), ints, least_to + i);
            hn::StoreU(hn::Min(hn::Add(last, hn::Set(ints, 1)), hn::Set(ints, end)), ints,
                       most_to + i);
        };
        range(grid.x, inside.left, inside.right, to[0], to[2]);
        range(grid.y, inside.top, inside.bottom, to[1], to[3]);
    }
}

/// The samples where a number that is linear over the pixel is not negative: `middle` in its
/// middle, and what a pixel to the right and one down add.
HWY_ATTR HWY_INLINE std::uint64_t not_negative(float middle, float right, float down) {
    const float range = 0.5f * (std::abs(right) + std::abs(down));
    if (middle >= range)
        return ~std::uint64_t{0};
    if (middle < -range)
        return 0;
    const auto at_middle = hn::Set(floats, middle), to_right = hn::Set(floats, right),
               to_down = hn::Set(floats, down);
    std::uint64_t samples = 0;
    for (std::size_t at = 0; at < sample_places::count; at += float_lanes) {
        const auto number =
            hn::Add(at_middle, hn::Add(hn::Mul(to_right, hn::Load(floats, offsets.x.data() + at)),
                                       hn::Mul(to_down, hn::Load(floats, offsets.y.data() + at))));
        samples |= bits_of(floats, hn::Ge(number, hn::Zero(floats))) << at;
    }
    return samples;
}

HWY_ATTR HWY_INLINE seen_fragment measured(const seen_so_far& of, const marked_pixel& pixel) {
    constexpr std::uint64_t all = ~std::uint64_t{0};
    constexpr std::array digits_x{
        sample_places::with_digit(the_samples.x, 0), sample_places::with_digit(the_samples.x, 1),
        sample_places::with_digit(the_samples.x, 2), sample_places::with_digit(the_samples.x, 3)};
    constexpr std::array digits_y{
        sample_places::with_digit(the_samples.y, 0), sample_places::with_digit(the_samples.y, 1),
        sample_places::with_digit(the_samples.y, 2), sample_places::with_digit(the_samples.y, 3)};
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

/// Gives the samples that a fragment shares with others to the nearer one. Returns how many of the
/// others are left.
HWY_ATTR HWY_INLINE std::size_t divide(seen_so_far* seen, std::size_t count, seen_so_far& here) {
    bool any_gone = false;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t both = here.samples & seen[i].samples;
        if (both == 0)
            continue;
        const std::uint64_t nearer =
            both & not_negative(here.depth - seen[i].depth, here.right - seen[i].right,
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

/// Adds a pixel's fragments, the last that came first. No two of those seen share a sample, so they
/// are 64 at most.
HWY_ATTR HWY_INLINE std::size_t see(std::span<const fragment_polygon> polygons,
                                    std::span<const fragment> fragments, const marked_pixel& pixel,
                                    seen_so_far (&seen)[sample_places::count + 1]) {
    const float x = static_cast<float>(pixel.x) + 0.5f, y = static_cast<float>(pixel.y) + 0.5f;
    std::size_t count = 0;
    std::uint64_t covered = 0;
    for (std::uint32_t at = pixel.last; at != fragment::none; at = fragments[at].before) {
        const fragment_polygon& of = polygons[fragments[at].polygon];
        seen_so_far here{
            fragments[at].samples, fragments[at].polygon,
            of.depth + (of.depth_right * (x - of.middle_x) + of.depth_down * (y - of.middle_y)),
            of.depth_right, of.depth_down};
        if ((here.samples & covered) != 0)
            count = divide(seen, count, here);
        covered |= here.samples;
        if (here.samples != 0)
            seen[count++] = here;
    }
    return count;
}

std::size_t see_all(std::span<const fragment_polygon> polygons, std::span<const fragment> fragments,
                    std::span<const marked_pixel> pixels, seen_fragment* to,
                    std::uint32_t* begins) {
    seen_so_far seen[sample_places::count + 1];
    std::size_t count = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        begins[i] = static_cast<std::uint32_t>(count);
        for (std::size_t n = see(polygons, fragments, pixels[i], seen); n > 0; --n)
            to[count++] = measured(seen[n - 1], pixels[i]);
    }
    begins[pixels.size()] = static_cast<std::uint32_t>(count);
    return count;
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

void fragment_polygon::set_corners(std::span<const l3d_micro_vertex> of) {
    for (std::size_t i = 0; i < 4; ++i) {
        const l3d_micro_vertex& v = of[std::min(i, of.size() - 1)];
        x[i] = v.x;
        y[i] = v.y;
        inv_w[i] = v.inv_w;
    }
    corners = static_cast<std::int32_t>(of.size());
    area2 = cross({x[2] - x[0], y[2] - y[0]}, {x[3] - x[1], y[3] - y[1]});
}

void fragment_polygon::set_plane() {
    const double unit = 1.0 / l3d_subpixel_one;
    const std::int64_t ax = std::int64_t{x[2]} - x[0], ay = std::int64_t{y[2]} - y[0];
    const std::int64_t bx = std::int64_t{x[3]} - x[1], by = std::int64_t{y[3]} - y[1];
    middle_x = static_cast<float>(0.25 * unit * (double(x[0]) + x[1] + x[2] + x[3]));
    middle_y = static_cast<float>(0.25 * unit * (double(y[0]) + y[1] + y[2] + y[3]));
    depth = 0.25f * ((inv_w[0] + inv_w[1]) + (inv_w[2] + inv_w[3]));
    const double per_area = l3d_subpixel_one / static_cast<double>(area2);
    const double a = double{inv_w[2]} - inv_w[0], b = double{inv_w[3]} - inv_w[1];
    depth_right = static_cast<float>((a * double(by) - b * double(ay)) * per_area);
    depth_down = static_cast<float>((b * double(ax) - a * double(bx)) * per_area);
}

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
                 std::span<const marked_pixel> pixels, std::vector<seen_fragment>& seen,
                 std::vector<std::uint32_t>& begins) {
    seen.resize(fragments.size());
    begins.resize(pixels.size() + 1);
    seen.resize(L3D_SIMD_CALL(see_all)(polygons, fragments, pixels, seen.data(), begins.data()));
}

} // namespace l3d_detail
#endif
