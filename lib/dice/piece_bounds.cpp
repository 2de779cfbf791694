// SPDX-License-Identifier: MIT
// l3d_piece_bounds: makes the nets of blocks, and bounds the errors of vertices.
#include "dice/piece_bounds.h"

#include "geom/forward_difference.h"
#include "geom/patch_part.h"
#include "dice/step_plan.h"

#include <algorithm>
#include <cmath>

namespace {

/// The largest sizes of a net's coordinates, and of their first, second and third differences along
/// v.
/// Shape: by the order of differences.
struct magnitudes {
    std::array<double, 4> xy{}, w{};

    explicit magnitudes(const l3d_image_patch& net) {
        for (int c = 0; c < 4; ++c) {
            std::array<l3d_image_point, 4> d = net.column(c).points;
            for (std::size_t order = 0; order < 4; ++order) {
                for (std::size_t i = 0; i + order < 4; ++i) {
                    xy[order] = std::max({xy[order], std::abs(d[i][0]), std::abs(d[i][1])});
                    w[order] = std::max(w[order], std::abs(d[i][2]));
                }
                for (std::size_t i = 0; i + order + 1 < 4; ++i)
                    d[i] = d[i + 1] - d[i];
            }
        }
    }
};

/// Bounds the error of walking n steps in T along one of `strips` equal parts of [0, 1]. Registers
/// hold `unit` times the coordinates. Differences of order k shrink by strips^k.
template <class T>
double walking_error(const std::array<double, 4>& size, double unit, int n, int strips) {
    const double s = strips, whole = l3d_balanced_reach * unit;
    return l3d_forward_difference_error<T>(n, whole * size[0], whole * size[1] / s,
                                           whole * size[2] / (s * s),
                                           whole * size[3] / (s * s * s)) /
           unit;
}

/// The unit of fixed-point registers: a power of two. It brings w to at most 2^8 and, within the
/// guard band, x and y to at most 2^22. Differences of third order may be eight times as large, and
/// 32.32 has 31 integer bits.
/// Expects: 0 < largest_w < 2^200; the image transform's scale ensures it.
template <class T> double register_unit(double largest_w) {
    if constexpr (l3d_is_fixed<T>)
        return std::exp2(7 - std::floor(std::log2(largest_w)));
    else
        return 1;
}

} // namespace

template <class T>
l3d_piece_bounds<T>::l3d_piece_bounds(const l3d_image_net& piece, const l3d_dice_view& view)
    : net_(piece) {
    const l3d_depth_range depth = net_.w();
    l3d_image_box seen = view.margin();
    l3d_vertex_accuracy accuracy;
    accuracy.w_low = view.drawn_w(depth.least);
    accuracy.reach = l3d_guard_band;
    bool small = false;
    if (depth.least > view.near) {
        const l3d_image_box& hull = net_.box();
        whole_ = hull.reach() < l3d_guard_band && depth.most < view.far &&
                 view.section.leaves(net_.points);
        if (whole_) {
            accuracy.reach = view.drawn_box(hull).reach();
            small = l3d_is_one_block(net_, hull, view);
            if (!seen.intersected(hull).empty())
                seen = seen.intersected(hull);
        }
    }
    accuracy.seen_reach = seen.reach();
    if (small) {
        blocks_[0] = net_;
    } else {
        blocks_ = l3d_blocks_of<l3d_image_patch>(net_);
        count_ = blocks_.size();
    }
    bound_vertices(accuracy, view);
}

template <class T>
void l3d_piece_bounds<T>::bound_vertices(l3d_vertex_accuracy accuracy, const l3d_dice_view& view) {
    // First, the error of vertices that are evaluated one by one.
    const magnitudes size(net_);
    accuracy.error_xy = view.error_xy + l3d_evaluation_error(size.xy[0]);
    accuracy.error_w = view.error_w + l3d_evaluation_error(size.w[0]);
    accuracy.snap_error = l3d_snap_error<double>(accuracy.reach);
    // The centre of a folded quad is rounded to sub-pixels once more.
    if (whole_)
        accuracy.snap_error += l3d_snap_error<double>(0);
    const double w_ratio = whole_ ? l3d_vertex_accuracy::in_front : l3d_vertex_accuracy::crossing;
    vertex_error_ = accuracy.drawn_error(w_ratio);
    error_w_ = accuracy.error_w;
    // The depths of a parallel projection are small differences of w, too small for most registers.
    if (!whole_ || view.is_parallel())
        return;

    // Then, the error of vertices that are walked by forward differences, if that is exact enough.
    const int strips = count_ == 1 ? 1 : l3d_step_plan::most_strips;
    unit_ = register_unit<T>(size.w[0]);
    accuracy.error_xy += walking_error<T>(size.xy, unit_, l3d_most_steps_whole, strips);
    const double walk_w = walking_error<T>(size.w, unit_, l3d_most_steps_whole, strips);
    accuracy.error_w += walk_w;
    accuracy.snap_error += l3d_snap_error<T>(accuracy.reach) - l3d_snap_error<T>(0);
    const double walking = accuracy.drawn_error(w_ratio);
    // An error of w moves a vertex along the line of sight: `focal` / w pixels for a unit of w.
    const double more = walking - vertex_error_ + view.focal * walk_w / accuracy.w_low;
    walked_ = more <= view.walk_allowance(vertex_error_);
    if (walked_) {
        vertex_error_ = walking;
        error_w_ = accuracy.error_w;
    }
}

template class l3d_piece_bounds<float>;
template class l3d_piece_bounds<double>;
template class l3d_piece_bounds<l3d_fixed<std::int64_t, 32>>;
