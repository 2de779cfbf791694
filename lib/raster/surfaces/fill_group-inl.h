// SPDX-License-Identifier: MIT
// fill_group: turns polygons of a queue into a table of rows.
#if defined(L3D_RASTER_SURFACES_FILL_GROUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_RASTER_SURFACES_FILL_GROUP_INL_H
#undef L3D_RASTER_SURFACES_FILL_GROUP_INL_H
#else
#define L3D_RASTER_SURFACES_FILL_GROUP_INL_H
#endif

#include "raster/surfaces/fill_kernel_p.h"
#include "raster/surfaces/fill_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// A polygon is a sliver if the product of its diagonals' lengths is more than this many times
/// their cross product, which is twice the area.
constexpr float sliver_ratio = 64;

/// Fills a vector of polygons, one in each lane. set_up() turns their corners into rows of a table;
/// fill() writes the pixels of these rows.
///
/// Shape: Light is the class that computes the polygons' greys or normals, such as lambert_lanes,
///        grey_lanes, level_lanes or normal_lanes.
template <class Light> class fill_group {
public:
    /// Sets up a vector of polygons. Returns whether there is anything to fill.
    /// Expects: room for a vector of polygons in the queue from `at` on, the first `valid` in use.
    HWY_INLINE bool set_up(const fill_target& to, std::size_t at, std::size_t valid,
                           fill_table& table) {
        const ints d;
        const int_mask seen = hn::Gt(load(to.queue.seen + at), hn::Zero(d));
        const int_mask wanted = hn::And(seen, hn::FirstN(d, valid));
        if (hn::AllFalse(d, wanted))
            return false;
        at_ = at;
        place(to.band, to.queue, at);
        const int_mask fits = classify(to, at, hn::And(live_, wanted));
        const int_vec height = hn::IfThenElseZero(fits, hn::Sub(to_row_, from_row_));
        const std::int32_t highest = hn::GetLane(hn::MaxOfLanes(d, height));
        if (highest == 0)
            return false;
        places_.fits = fits;
        planes(to.queue, at, table);
        light_.set_up(to.shading, places_, table, to.counts);
        rows(to, height, highest, table);
        return true;
    }

    /// Writes the pixels of the polygons that set_up() has put into the table. Returns how many
    /// pixels were written.
    HWY_INLINE std::int64_t fill(const fill_band& band, const fill_table& table) const {
        return light_.fill(band, table);
    }

private:
    /// Finds the part of each polygon's box in the band, and the corners relative to the box.
    HWY_INLINE void place(const fill_band& band, const fill_queue& queue, std::size_t at) {
        const lane_corners corners(queue, at);
        const int_vec zero = hn::Zero(ints());
        column_ = first_centre_of(ints(), corners.left);
        row_ = first_centre_of(ints(), corners.top);
        from_column_ = hn::Max(zero, hn::Sub(zero, column_));
        to_column_ =
            hn::Sub(hn::Min(first_centre_of(ints(), corners.right), set(band.width)), column_);
        from_row_ = hn::Max(zero, hn::Sub(set(band.top), row_));
        to_row_ = hn::Sub(hn::Min(first_centre_of(ints(), corners.bottom), set(band.bottom)), row_);
        live_ = hn::And(hn::Lt(from_column_, to_column_), hn::Lt(from_row_, to_row_));
        at_edge_ = hn::Gt(hn::Add(column_, to_column_), set(band.width - run + 1));
        const int_vec extent =
            hn::Max(hn::Sub(corners.right, corners.left), hn::Sub(corners.bottom, corners.top));
        large_ = hn::Gt(extent, set(most_pixels * pixel - 1));
        for (int i = 0; i < 4; ++i) {
            places_.x[i] = corners.x[i];
            places_.y[i] = corners.y[i];
            x_[i] = hn::Sub(corners.x[i], centre_of(column_));
            y_[i] = hn::Sub(corners.y[i], centre_of(row_));
        }
    }

    static HWY_INLINE int_vec centre_of(int_vec index) {
        return hn::Add(hn::ShiftLeft<l3d_subpixel_bits>(index), set(pixel / 2));
    }

    /// Finds which polygons are filled with this vector. Other polygons are queued for later, whole
    /// or in pieces.
    HWY_INLINE int_mask classify(const fill_target& to, std::size_t at, int_mask candidates) {
        light_.load(to.queue, at);
        places_.piece = hn::Eq(load(to.queue.name + at), set(fill_queue::piece));
        along1_x_ = hn::Sub(x_[2], x_[0]);
        along1_y_ = hn::Sub(y_[2], y_[0]);
        along2_x_ = hn::Sub(x_[3], x_[1]);
        along2_y_ = hn::Sub(y_[3], y_[1]);
        area2_ = cross_of(along1_x_, along1_y_, along2_x_, along2_y_);
        turn_a_ = turn(3, 0, 1);
        turn_b_ = turn(0, 1, 2);
        const int_vec turn_c = hn::Sub(area2_, turn_a_);
        turn_d_ = hn::Sub(area2_, turn_b_);

        const int_vec zero = hn::Zero(ints());
        const int_vec least = hn::Min(hn::Min(turn_a_, turn_b_), hn::Min(turn_c, turn_d_));
        const int_vec most = hn::Max(hn::Max(turn_a_, turn_b_), hn::Max(turn_c, turn_d_));
        const int_mask left = hn::Lt(least, zero), right = hn::Gt(most, zero);
        const int_mask level = hn::Not(hn::Or(left, right)); // all on one line: covers nothing
        const int_mask folded = hn::Or(hn::And(left, right), hn::Eq(area2_, zero));
        // 2 skew > |area2|, without leaving 32 bits; the skew of a triangle does not count
        const int_vec skew =
            hn::Add(hn::Abs(hn::Sub(turn_a_, turn_c)), hn::Abs(hn::Sub(turn_b_, turn_d_)));
        const int_mask is_quad = hn::Not(hn::Lt(load(to.queue.name + at), zero));
        const int_mask skewed = hn::And(is_quad, hn::Gt(skew, hn::ShiftRight<1>(hn::Abs(area2_))));
        places_.triangle = hn::Not(is_quad);
        skew_ = skew;
        const int_mask unfit = light_.with_unfit(hn::Or(large_, slivers_at_the_edge()), skewed);
        const int_mask others = hn::Or(unfit, hn::Or(folded, skewed));
        candidates = hn::AndNot(hn::AndNot(large_, level), candidates);
        const int_mask left_over = hn::And(others, candidates);
        if (!hn::AllFalse(ints(), left_over))
            put_by(to, at, left_over, light_.fit_in_pieces(hn::AndNot(at_edge_, hn::Not(unfit))));
        return hn::AndNot(others, candidates);
    }

    /// Finds the slivers at the picture's right edge. At this edge, a run begins left of the
    /// polygon, to fit the picture. A sliver's numbers where the run begins are some hundred times
    /// the corners' numbers. Pieces of quads would be thin, so quads at the edge are not cut.
    HWY_INLINE int_mask slivers_at_the_edge() const {
        if (hn::AllFalse(ints(), at_edge_))
            return at_edge_;
        const float_vec square1 =
            hn::Add(square_of(to_float(along1_x_)), square_of(to_float(along1_y_)));
        const float_vec square2 =
            hn::Add(square_of(to_float(along2_x_)), square_of(to_float(along2_y_)));
        const float_vec limit = hn::Mul(to_float(area2_), set(sliver_ratio));
        const auto thin = hn::Gt(hn::Mul(square1, square2), square_of(limit));
        return hn::And(at_edge_, hn::RebindMask(ints(), thin));
    }

    HWY_INLINE int_vec turn(int before, int i, int next) const {
        return cross_of(hn::Sub(x_[i], x_[before]), hn::Sub(y_[i], y_[before]),
                        hn::Sub(x_[next], x_[i]), hn::Sub(y_[next], y_[i]));
    }

    static HWY_NOINLINE void put_by(const fill_target& to, std::size_t at, int_mask left_over,
                                    int_mask in_pieces) {
        HWY_ALIGN std::int32_t is_left_over[lanes], is_in_pieces[lanes];
        hn::Store(hn::IfThenElseZero(left_over, set(1)), ints(), is_left_over);
        hn::Store(hn::IfThenElseZero(in_pieces, set(1)), ints(), is_in_pieces);
        for (std::size_t i = 0; i < lanes; ++i)
            if (is_left_over[i] != 0)
                fill_put_by(to, at + i, is_in_pieces[i] != 0);
    }

    HWY_INLINE void planes(const fill_queue& queue, std::size_t at, fill_table& table) {
        const floats d;
        lane_frame& frame = places_.frame;
        frame.inverse = hn::Div(set(1.0f), to_float(area2_));
        places_.uneven = hn::Mul(hn::Abs(frame.inverse), hn::Mul(set(0.25f), to_float(skew_)));
        // m - a = (ab + ac + ad) / 4, ad = ab + bd, and ab x bd = turn_a, ac x ab = -turn_b,
        // ac x ad = turn_d
        const float_vec half = hn::Mul(frame.inverse, set(0.5f));
        frame.mean_s = hn::Add(set(0.25f), hn::Mul(to_float(turn_a_), half));
        frame.mean_t = hn::Mul(to_float(hn::Sub(turn_d_, turn_b_)), hn::Mul(half, set(0.5f)));
        places_.column_s = to_float(hn::ShiftLeft<l3d_subpixel_bits>(along2_y_));
        places_.column_t = hn::Neg(to_float(hn::ShiftLeft<l3d_subpixel_bits>(along1_y_)));

        float_vec inv_w[4];
        for (int i = 0; i < 4; ++i)
            inv_w[i] = load_float(queue.corner[i][2] + at);
        hn::Store(least_of(inv_w), d, table.farthest.of);
        hn::Store(most_of(inv_w), d, table.nearest.of);
        inv_w_ = frame.plane(inv_w);
        hn::Store(inv_w_.along(places_.column_s, places_.column_t), d, table.inv_w_x.of);
    }

    HWY_INLINE void rows(const fill_target& to, int_vec height, std::int32_t highest,
                         fill_table& table) {
        const ints d;
        const floats df;
        const int_mask clockwise = hn::Gt(area2_, hn::Zero(d));
        lane_edge edges[4];
        for (int i = 0; i < 4; ++i)
            edges[i].set(x_[i], y_[i], x_[(i + 1) % 4], y_[(i + 1) % 4], clockwise, from_row_);

        const int_vec row = hn::Sub(hn::Add(row_, from_row_), set(to.band.top));
        const auto first_of_row = [&](std::ptrdiff_t pitch) HWY_ATTR {
            return hn::Add(column_, hn::Mul(row, set(static_cast<std::int32_t>(pitch))));
        };
        hn::Store(first_of_row(to.band.word_pitch), d, table.word_at.of);
        hn::Store(first_of_row(to.band.depth_pitch), d, table.depth_at.of);
        const hn::RebindToUnsigned<ints> dw;
        table.words = to.words;
        hn::Store(to.words.has_materials ? hn::LoadU(dw, to.queue.material + at_) : hn::Zero(dw),
                  dw, table.material.of);

        const int_vec down = hn::Sub(hn::ShiftLeft<l3d_subpixel_bits>(from_row_), y_[0]);
        int_vec row_s = hn::Neg(hn::Add(hn::Mul(x_[0], along2_y_), hn::Mul(down, along2_x_)));
        int_vec row_t = hn::Add(hn::Mul(down, along1_x_), hn::Mul(x_[0], along1_y_));
        const int_vec down_s = hn::ShiftLeft<l3d_subpixel_bits>(along2_x_);
        const int_vec down_t = hn::ShiftLeft<l3d_subpixel_bits>(along1_x_);
        const int_vec column_s = hn::ShiftLeft<l3d_subpixel_bits>(along2_y_);
        const int_vec column_t = hn::ShiftLeft<l3d_subpixel_bits>(along1_y_);

        const int_vec last_begin =
            hn::Min(hn::Sub(set(to.band.width - run), column_), hn::Sub(to_column_, set(1)));
        int_vec samples = hn::Zero(d);
        int_vec longest = hn::IfThenElseZero(at_edge_, set(most_pixels + 1));
        for (std::int32_t k = 0; k < highest; ++k) {
            fill_row& row_k = table.rows[k];
            int_vec from = from_column_, end = to_column_;
            for (lane_edge& edge : edges) {
                edge.limit(from, end);
                edge.step();
            }
            const int_mask below = hn::Lt(set(k), height);
            const int_vec pixels =
                hn::IfThenElseZero(below, hn::Max(hn::Sub(end, from), hn::Zero(d)));
            const int_vec begin = hn::Min(from, last_begin);
            hn::Store(from, d, row_k.from.of);
            hn::Store(pixels, d, row_k.pixels.of);
            hn::Store(begin, d, row_k.begin.of);
            longest = hn::Max(longest, pixels);
            samples = hn::Add(samples, pixels);

            const float_vec s = to_float(hn::Add(row_s, hn::Mul(begin, column_s)));
            const float_vec t = to_float(hn::Sub(row_t, hn::Mul(begin, column_t)));
            hn::Store(inv_w_.at(s, t), df, row_k.inv_w.of);
            light_.put(s, t, table, k);
            row_s = hn::Sub(row_s, down_s);
            row_t = hn::Add(row_t, down_t);
        }
        hn::Store(longest, d, table.longest.of);
        hn::Store(hn::IfThenElseZero(hn::Gt(samples, hn::Zero(d)), height), d, table.height.of);
        to.counts.samples += hn::GetLane(hn::SumOfLanes(d, samples));
    }

    std::size_t at_ = 0;  ///< index of the vector's first polygon in the queue
    int_vec x_[4], y_[4]; ///< the corners, relative to the centre of pixel (column_, row_)
    int_vec column_, row_;
    /// Columns and rows of the polygon's box in the band, relative to (column_, row_).
    int_vec from_column_, to_column_, from_row_, to_row_;
    int_mask live_, large_;
    int_mask at_edge_; ///< polygons in which a row may begin where a run does not fit the picture
    /// For corners a, b and d, the cross product of the two sides that meet at the corner.
    int_vec turn_a_, turn_b_, turn_d_;
    int_vec along1_x_, along1_y_, along2_x_, along2_y_, area2_, skew_;
    lane_places places_;
    lane_plane inv_w_;
    Light light_;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
