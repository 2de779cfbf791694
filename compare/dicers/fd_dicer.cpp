// SPDX-License-Identifier: MIT
// l3d_fd_dicer: scales nets to the registers, and walks in them.
#include "compare/dicers/fd_dicer.h"

#include "geom/block_fixed.h"
#include "geom/forward_difference.h"
#include "dice/step_plan.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <span>

namespace {

/// Largest control values of a coordinate, and largest first, second and third differences of its
/// columns.
std::array<double, 4> sizes_of(const l3d_image_patch& net, int coordinate) {
    std::array<double, 4> result{};
    for (int c = 0; c < 4; ++c) {
        std::array<double, 4> d{};
        for (int r = 0; r < 4; ++r)
            d[static_cast<std::size_t>(r)] = net.at(r, c)[coordinate];
        for (std::size_t order = 0; order < 4; ++order) {
            for (std::size_t i = 0; i + order < 4; ++i)
                result[order] = std::max(result[order], std::abs(d[i]));
            for (std::size_t i = 0; i + order + 1 < 4; ++i)
                d[i] = d[i + 1] - d[i];
        }
    }
    return result;
}

template <class T> double walk_error(const std::array<double, 4>& size, int steps) {
    return l3d_forward_difference_error<T>(steps, size[0], size[1], size[2], size[3]);
}

/// A number as a register; integers wrap around.
template <class R> R to_register(double value) {
    if constexpr (std::floating_point<R>)
        return static_cast<R>(value);
    else
        return static_cast<R>(std::llrint(value));
}

double to_number(float value) {
    return value;
}
double to_number(double value) {
    return value;
}
double to_number(std::uint32_t value) {
    return static_cast<std::int32_t>(value);
}
double to_number(std::uint64_t value) {
    return static_cast<double>(static_cast<std::int64_t>(value));
}

} // namespace

/// Chooses the scale of each coordinate. 16.16 gets coordinates below 2^14, so that the first
/// differences of a walk are below 2^15.
l3d_fd_dicer::scales l3d_fd_dicer::scales_of(const l3d_image_patch& net, int steps) const {
    const std::array<std::array<double, 4>, 3> size{sizes_of(net, 0), sizes_of(net, 1),
                                                    sizes_of(net, 2)};
    std::array<double, 3> error{};
    scales result;
    const double largest = std::max({size[0][0], size[1][0], size[2][0]});
    for (std::size_t k = 0; k < 3; ++k) {
        int bits = 0;
        switch (arithmetic_) {
        case l3d_arithmetic::float_32:
            error[k] = walk_error<float>(size[k], steps);
            continue;
        case l3d_arithmetic::float_64:
            error[k] = walk_error<double>(size[k], steps);
            continue;
        case l3d_arithmetic::fixed_16_16:
            bits = 16 + 14 - (std::ilogb(std::max(largest, 1e-300)) + 1);
            break;
        case l3d_arithmetic::block_32:
            bits = l3d_block_fraction_bits(size[k][0]);
            break;
        case l3d_arithmetic::fixed_32_32:
            bits = 32;
            break;
        }
        result.factor[k] = std::ldexp(1.0, bits);
        // A walk in double at the same place errs only by the cancellation of differences.
        error[k] = l3d_block_walk_error(bits, steps) + walk_error<double>(size[k], steps);
    }
    result.error_xy = std::max(error[0], error[1]);
    result.error_w = error[2];
    return result;
}

template <class R>
void l3d_fd_dicer::walk(registers<R>& walked, const l3d_image_patch& net, const scales& scaled,
                        const l3d_dice_view& view, const l3d_diced_piece& piece,
                        l3d_micro_grid& grid) {
    const std::size_t columns = piece.u.size();
    const int steps = static_cast<int>(piece.v.size()) - 1;
    for (auto& coordinate : walked.of)
        for (auto& difference : coordinate)
            difference.resize(std::max(difference.size(), columns));
    for (std::size_t c = 0; c < columns; ++c) {
        const auto p = net.curve_at_u(piece.u[c]).points;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto i = static_cast<int>(k);
            const auto d = l3d_forward_difference<double, 3>::build(
                {p[0][i], p[1][i], p[2][i], p[3][i]}, steps);
            for (std::size_t n = 0; n < 4; ++n)
                walked.of[k][n][c] = to_register<R>(d.d[n] * scaled.factor[k]);
        }
    }
    const auto depth_scale = static_cast<float>(view.depth_scale);
    const std::array<double, 3> back{1 / scaled.factor[0], 1 / scaled.factor[1],
                                     1 / scaled.factor[2]};
    for (int row = 0; row <= steps; ++row) {
        const std::size_t at = grid.index(row, 0);
        for (std::size_t c = 0; c < columns; ++c) {
            // A walk that goes astray may end behind the eye. Its bound is infinite then.
            const double w =
                std::max(to_number(walked.of[2][0][c]) * back[2], view.near / l3d_guard_band);
            const double x = to_number(walked.of[0][0][c]) * back[0];
            const double y = to_number(walked.of[1][0][c]) * back[1];
            const double reach = l3d_guard_band * w;
            const l3d_snapped s =
                l3d_snap(std::clamp(x, -reach, reach), std::clamp(y, -reach, reach), w);
            grid.x[at + c] = s.x + view.centre_x();
            grid.y[at + c] = s.y + view.centre_y();
            grid.inv_w[at + c] = s.inv_w * depth_scale;
        }
        for (auto& coordinate : walked.of)
            for (std::size_t n = 0; n < 3; ++n)
                for (std::size_t c = 0; c < columns; ++c)
                    coordinate[n][c] = coordinate[n][c] + coordinate[n + 1][c];
    }
}

void l3d_fd_dicer::dice(const l3d_image_patch& net, const l3d_normal_net& normals,
                        const l3d_dice_view& view, l3d_piece_pool& out, l3d_dice_counts& counts) {
    edges_.build(net, view);
    const auto outer = edges_.outer();
    const bool whole_edges = std::all_of(outer.begin(), outer.end(),
                                         [](const auto& edge) { return edge.strips().blocks > 0; });
    if (!whole_edges) {
        --counts.drawn; // the other dicer counts the patch
        return adaptive_.dice(net, normals, view, edges_, out, counts);
    }
    l3d_vertex_accuracy accuracy = l3d_evaluated_accuracy(net, view);
    const double budget = view.chord_budget(accuracy.drawn_error(l3d_vertex_accuracy::in_front));
    const l3d_step_plan plan =
        l3d_plan_steps(net, std::span(&net, 1), view, budget, l3d_quad_kind::whole);
    if (!plan.visible)
        return;
    const int nu = steps_ > 0 ? steps_ : plan.nu[0], nv = steps_ > 0 ? steps_ : plan.nv[0];

    l3d_diced_piece& piece = out.next();
    grid_.begin(normals, nu, nv, piece);
    const scales scaled = scales_of(net, nv);
    l3d_micro_grid& grid = piece.part.grid;
    switch (arithmetic_) {
    case l3d_arithmetic::float_32:
        walk(floats_, net, scaled, view, piece, grid);
        break;
    case l3d_arithmetic::float_64:
        walk(doubles_, net, scaled, view, piece, grid);
        break;
    case l3d_arithmetic::fixed_16_16:
    case l3d_arithmetic::block_32:
        walk(words_, net, scaled, view, piece, grid);
        break;
    case l3d_arithmetic::fixed_32_32:
        walk(long_words_, net, scaled, view, piece, grid);
        break;
    }
    accuracy.error_xy += scaled.error_xy;
    accuracy.error_w += scaled.error_w;
    piece.bound = l3d_uniform_bound(net, view, nu, nv, accuracy);
    ++counts.pieces;
    counts.samples += static_cast<std::int64_t>(piece.u.size() * piece.v.size());
    counts.bound_px = std::max(counts.bound_px, piece.bound);
    for (std::size_t side = 0; side < outer.size(); ++side) {
        l3d_close_side(piece, side, outer[side], view);
        counts.add_edge(outer[side].size(),
                        outer[side].chord_error() +
                            accuracy.drawn_error(l3d_vertex_accuracy::in_front));
    }
}
