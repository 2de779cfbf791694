// SPDX-License-Identifier: MIT
// fill_pixels: writes rows of a table into picture and depth, in the library's innermost loop.
#if defined(L3D_RASTER_SURFACES_FILL_PIXELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_SURFACES_FILL_PIXELS_INL_H
#undef L3D_RASTER_SURFACES_FILL_PIXELS_INL_H
#else
#define L3D_RASTER_SURFACES_FILL_PIXELS_INL_H
#endif

#include "raster/surfaces/fill_words-inl.h"
#include "raster/parallel/store_where-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// A parabola for 1 / sqrt(q) over [0.75, 1.02], where q is the square of a normal's length. It is
/// exact at the interval's Chebyshev points. Its error is within 3e-4, which is 0.07 grey levels.
constexpr float unit_parabola[3] = {2.0041274f, -1.5196685f, 0.5155188f};

/// Adds 1 to the lanes of `mask`.
template <class D> HWY_INLINE hn::Vec<D> one_more_where(hn::Mask<D> mask, hn::Vec<D> count, D d) {
    if constexpr (masked_stores_are_cheap) // there, masks are not vectors
        return hn::IfThenElse(mask, hn::Add(count, hn::Set(d, 1)), count);
    else
        return hn::Sub(count, hn::VecFromMask(d, mask));
}

/// Fills one polygon of a table, `Pixels` pixels of a row at a time.
template <class D, std::int32_t Pixels, fill_shape Shape> class fill_polygon {
public:
    using int_tag = hn::RebindToSigned<D>;
    using count_vec = hn::Vec<int_tag>; ///< the number of written pixels, in each lane

    HWY_INLINE fill_polygon(const fill_band& band, const fill_table& table, std::size_t i)
        : words_(band.words), depths_(band.depths),
          normals_(band.normals), pitch_{band.word_pitch, band.depth_pitch}, table_(table), i_(i),
          make_(table, i) {
        const D d;
        farthest_ = hn::Set(d, table.farthest[i]);
        nearest_ = hn::Set(d, table.nearest[i]);
        if constexpr (is_grey) {
            darkest_ = hn::Set(d, table.darkest[i]);
            brightest_ = hn::Set(d, table.brightest[i]);
        }
        for (std::size_t v = 0; v < vectors; ++v) {
            columns_[v] = hn::Load(int_tag(), run_columns + v * width);
            const vec x = hn::ConvertTo(d, columns_[v]);
            inv_w_x_[v] = hn::Mul(hn::Set(d, table.inv_w_x[i]), x);
            if constexpr (is_bent) {
                x_[v] = x;
                lit_xx_[v] = hn::Mul(hn::Set(d, table.lit_xx[i]), hn::Mul(x, x));
            } else {
                lit_x_[v] = hn::Mul(hn::Set(d, table.lit_x[i]), x);
            }
            if constexpr (is_normal) {
                normal_y_x_[v] = hn::Mul(hn::Set(d, table.normal_y_x[i]), x);
                normal_z_x_[v] = hn::Mul(hn::Set(d, table.normal_z_x[i]), x);
            }
            if constexpr (is_twisted) {
                x_[v] = x;
                bend_xx_[v] = hn::Mul(hn::Set(d, table.bend_xx[i]), hn::Mul(x, x));
                facing_x_[v] = hn::Mul(hn::Set(d, table.facing_x[i]), x);
            }
        }
    }

    /// Fills a polygon with one run in each row.
    /// Expects: rows are not longer than a run, nor at the picture's right edge.
    HWY_INLINE void fill(count_vec& written) const {
        for_rows([&](const fill_row& row, const run_place& at) HWY_ATTR {
            one_run(first_start(row), at, written, columns_below(row.pixels[i_]));
        });
    }

    /// Fills a polygon with as many runs in each row as it needs. Expects: no row is at the
    /// picture's right edge.
    HWY_INLINE void fill_wide(count_vec& written) const {
        for_rows([&](const fill_row& row, const run_place& at) HWY_ATTR {
            const std::int32_t pixels = row.pixels[i_];
            for (std::int32_t done = 0; done < pixels; done += Pixels)
                one_run(start_at(row, done), at.moved_by(done), written,
                        columns_below(pixels - done));
        });
    }

    /// Fills a polygon at the picture's right edge. A run that would not fit the picture ends where
    /// the row does.
    HWY_INLINE void fill_at_edge(count_vec& written) const {
        for_rows([&](const fill_row& row, const run_place& at) HWY_ATTR {
            if (row.pixels[i_] == 0)
                return;
            std::int32_t done = row.from[i_] - row.begin[i_];
            const std::int32_t end = done + row.pixels[i_];
            for (std::int32_t next = Pixels; done < end; done = next, next += Pixels) {
                const std::int32_t begin = std::max(std::min(next, end) - Pixels, 0);
                one_run(start_at(row, begin), at.moved_by(begin), written,
                        columns_in(done - begin, end - begin));
            }
        });
    }

private:
    using vec = hn::Vec<D>;
    static constexpr bool is_grey = Shape == fill_shape::grey;
    static constexpr bool is_twisted = Shape == fill_shape::twisted;
    static constexpr bool is_bent = Shape == fill_shape::bent;
    static constexpr bool is_normal = Shape == fill_shape::normal;
    static constexpr std::size_t width = hn::MaxLanes(D()), vectors = Pixels / width;

    /// The interpolated numbers at a run's first pixel, each in all lanes.
    struct run_start {
        vec inv_w, lit, lit_x, bend, bend_x, facing, normal_y, normal_z;
    };

    /// A place in the band, or a distance between places: an index of words and an index of depths.
    struct run_place {
        std::ptrdiff_t word, depth;

        HWY_INLINE run_place moved_by(std::int32_t columns) const {
            return {word + columns, depth + columns};
        }
    };

    /// Calls action(row, place of the row's first run) for each row.
    template <class Action> HWY_INLINE void for_rows(const Action& action) const {
        run_place at{table_.word_at[i_], table_.depth_at[i_]};
        const fill_row* const end = table_.rows + table_.height[i_];
        for (const fill_row* row = table_.rows; row != end; ++row) {
            action(*row, at.moved_by(row->begin[i_]));
            at.word += pitch_.word;
            at.depth += pitch_.depth;
        }
    }

    HWY_INLINE const fill_row_twisted& twisted_of(const fill_row& row) const {
        return table_.twisted_rows[&row - table_.rows];
    }

    HWY_INLINE const fill_row_normal& normal_of(const fill_row& row) const {
        return table_.normal_rows[&row - table_.rows];
    }

    HWY_INLINE float bent_of(const fill_row& row) const {
        return table_.bent_rows[&row - table_.rows][i_];
    }

    HWY_INLINE run_start first_start(const fill_row& row) const {
        const D d;
        run_start start{hn::Set(d, row.inv_w[i_]), hn::Set(d, row.lit[i_]), {}, {}, {}, {}, {}, {}};
        if constexpr (is_bent)
            start.lit_x = hn::Set(d, bent_of(row));
        if constexpr (is_normal) {
            const fill_row_normal& normal = normal_of(row);
            start.normal_y = hn::Set(d, normal.y[i_]);
            start.normal_z = hn::Set(d, normal.z[i_]);
        }
        if constexpr (is_twisted) {
            const fill_row_twisted& twisted = twisted_of(row);
            start.bend = hn::Set(d, twisted.bend[i_]);
            start.bend_x = hn::Set(d, twisted.bend_x[i_]);
            start.facing = hn::Set(d, twisted.facing[i_]);
        }
        return start;
    }

    HWY_INLINE run_start start_at(const fill_row& row, std::int32_t column) const {
        const D d;
        const auto x = static_cast<float>(column);
        run_start there;
        there.inv_w = hn::Set(d, row.inv_w[i_] + x * table_.inv_w_x[i_]);
        if constexpr (is_bent) {
            const float slope = bent_of(row), xx = x * table_.lit_xx[i_];
            there.lit = hn::Set(d, row.lit[i_] + x * (slope + xx));
            there.lit_x = hn::Set(d, slope + 2.0f * xx);
        } else {
            there.lit = hn::Set(d, row.lit[i_] + x * table_.lit_x[i_]);
        }
        if constexpr (is_normal) {
            const fill_row_normal& normal = normal_of(row);
            there.normal_y = hn::Set(d, normal.y[i_] + x * table_.normal_y_x[i_]);
            there.normal_z = hn::Set(d, normal.z[i_] + x * table_.normal_z_x[i_]);
        }
        if constexpr (is_twisted) {
            const fill_row_twisted& twisted = twisted_of(row);
            const float xx = x * table_.bend_xx[i_];
            there.bend = hn::Set(d, twisted.bend[i_] + x * (twisted.bend_x[i_] + xx));
            there.bend_x = hn::Set(d, twisted.bend_x[i_] + 2.0f * xx);
            there.facing = hn::Set(d, twisted.facing[i_] + x * table_.facing_x[i_]);
        }
        return there;
    }

    /// Tells which columns of a run are below `end`, by a mask for each of the run's vectors.
    HWY_INLINE auto columns_below(std::int32_t end) const {
        return [this, end = hn::Set(int_tag(), end)](std::size_t v)
                   HWY_ATTR { return hn::Lt(columns_[v], end); };
    }
    HWY_INLINE auto columns_in(std::int32_t first, std::int32_t end) const {
        return [below = columns_below(first), in = columns_below(end)](std::size_t v)
                   HWY_ATTR { return hn::AndNot(below(v), in(v)); };
    }

    template <class Covered>
    HWY_INLINE void one_run(const run_start& start, const run_place& at, count_vec& written,
                            const Covered& covered) const {
        for (std::size_t v = 0; v < vectors; ++v)
            one_vector(start, v, covered(v), at, written);
    }

    HWY_INLINE void one_vector(const run_start& start, std::size_t v, hn::Mask<int_tag> covered,
                               const run_place& at, count_vec& written) const {
        const D d;
        const hn::RebindToUnsigned<D> dw;
        std::uint32_t* const to_words = words_ + at.word + v * width;
        float* const to_depths = depths_ + at.depth + v * width;
        const vec inv_w = hn::IfThenElseZero(
            hn::RebindMask(d, covered),
            hn::Min(hn::Max(hn::Add(start.inv_w, inv_w_x_[v]), farthest_), nearest_));
        const vec there = hn::LoadU(d, to_depths);
        const auto seen = hn::Gt(inv_w, there);
        hn::StoreU(hn::Max(inv_w, there), d, to_depths);
        store_where(seen, words_of(start, v), dw, to_words);
        if constexpr (is_normal)
            store_where(seen,
                        make_.of_normal_xy(hn::Add(start.lit, lit_x_[v]),
                                           hn::Add(start.normal_y, normal_y_x_[v])),
                        dw, normals_ + at.depth + v * width);
        written = one_more_where(hn::RebindMask(int_tag(), seen), written, int_tag());
    }

    HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> words_of(const run_start& start,
                                                         std::size_t v) const {
        const D d;
        if constexpr (is_normal)
            return make_.of_normal_z(hn::Add(start.normal_z, normal_z_x_[v]));
        if constexpr (is_bent)
            return make_.of_cosines(
                hn::Add(start.lit, hn::Add(hn::Mul(start.lit_x, x_[v]), lit_xx_[v])));
        vec lit = hn::Add(start.lit, lit_x_[v]);
        if constexpr (is_grey)
            return make_.of_levels(hn::Min(hn::Max(lit, darkest_), brightest_));
        if constexpr (is_twisted) {
            const vec bend =
                hn::Add(start.bend, hn::Add(hn::Mul(start.bend_x, x_[v]), bend_xx_[v]));
            const vec line =
                hn::Add(hn::Set(d, unit_parabola[1]), hn::Mul(hn::Set(d, unit_parabola[2]), bend));
            lit = hn::Mul(lit, hn::Add(hn::Set(d, unit_parabola[0]), hn::Mul(bend, line)));
            lit = hn::Xor(lit, hn::And(hn::Add(start.facing, facing_x_[v]), hn::SignBit(d)));
        }
        return make_.of_cosines(lit);
    }

    /// A copy of the band's member, as compilers must assume that stores change the band's members.
    std::uint32_t* words_;
    float* depths_;
    std::uint32_t* normals_;
    run_place pitch_;
    const fill_table& table_;
    std::size_t i_;
    word_maker<D> make_;
    count_vec columns_[vectors];
    vec inv_w_x_[vectors], lit_x_[vectors], farthest_, nearest_;
    vec darkest_, brightest_;
    vec x_[vectors], bend_xx_[vectors], facing_x_[vectors], lit_xx_[vectors];
    vec normal_y_x_[vectors], normal_z_x_[vectors];
};

/// Fills polygons of a table, and counts the pixels that were written.
///
/// Most rows are short, and suit short vectors, of which a processor computes more at a time.
class fill_polygons {
public:
    HWY_INLINE fill_polygons(const fill_band& band, const fill_table& table)
        : band_(band), table_(table), written_(hn::Zero(ints())),
          half_written_(hn::Zero(half_ints())) {}

    template <fill_shape Shape> HWY_INLINE void fill(std::size_t i) {
        if (table_.longest[i] <= half)
            fill_polygon<half_floats, half, Shape>(band_, table_, i).fill(half_written_);
        else if (table_.longest[i] <= run)
            fill_polygon<floats, run, Shape>(band_, table_, i).fill(written_);
        else if (table_.longest[i] <= most_pixels)
            fill_polygon<floats, run, Shape>(band_, table_, i).fill_wide(written_);
        else
            fill_polygon<floats, run, Shape>(band_, table_, i).fill_at_edge(written_);
    }

    HWY_INLINE std::int64_t written() const {
        return std::int64_t{hn::GetLane(hn::SumOfLanes(ints(), written_))} +
               hn::GetLane(hn::SumOfLanes(half_ints(), half_written_));
    }

private:
    static constexpr std::int32_t half = run / 2;
    using half_floats = hn::CappedTag<float, half>;
    using half_ints = hn::RebindToSigned<half_floats>;

    const fill_band& band_;
    const fill_table& table_;
    int_vec written_;
    hn::Vec<half_ints> half_written_;
};

/// Fills the polygons of a table in their order. Returns how many pixels were written.
/// Shape: all polygons have the shape `Shape`, except that polygons in a table of twisted polygons
///        may be flat.
template <fill_shape Shape>
HWY_INLINE std::int64_t fill_pixels(const fill_band& band, const fill_table& table) {
    fill_polygons polygons(band, table);
    for (std::size_t i = 0; i < lanes; ++i) {
        if (table.height[i] == 0)
            continue;
        if constexpr (Shape == fill_shape::twisted)
            if (table.twisted[i] == 0) {
                polygons.fill<fill_shape::flat>(i);
                continue;
            }
        polygons.fill<Shape>(i);
    }
    return polygons.written();
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
