// SPDX-License-Identifier: MIT
// l3d_surface_bends: takes the largest bounds of parts, rounded up, and bounds placed patches.
#include "scene/bends/surface_bends.h"
#include "scene/bends/bends_of_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

using namespace l3d_detail;

namespace {

constexpr float no_bound = std::numeric_limits<float>::infinity();

/// Rounds x up to a float, or to infinity for a NaN. Rounding to nearest changes x by at most 2^-24
/// of it, or by 2^-150 if x is below the smallest normal float, 2^-126.
float rounded_up(double x) {
    constexpr double most = 0x1p127;
    return x < most ? static_cast<float>(x * (1 + 0x1p-23)) + (x > 0 ? 0x1p-126F : 0.0F) : no_bound;
}

/// Bounds the largest eigenvalue of M^T M from above and the least from below. M is the upper left
/// three by three of a map.
///
/// After Jacobi's rotations, Gershgorin's circles bound eigenvalues: each is near a diagonal entry,
/// within the sum of the other entries' sizes in that row. Three rounds leave rounding of some 100
/// * 2^-53, relative to the largest entry. The slack is 2^-43 of that entry.
struct squared_scales {
    double least, most;

    explicit squared_scales(const l3d_matrix<double>& map) {
        double a[3][3];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                a[i][j] = map(0, i) * map(0, j) + map(1, i) * map(1, j) + map(2, i) * map(2, j);
        for (int round = 0; round < 3; ++round)
            for (int p = 0; p < 3; ++p)
                rotate(a, p, (p + 1) % 3);
        least = HUGE_VAL;
        most = 0;
        for (int i = 0; i < 3; ++i) {
            const double others = std::abs(a[i][(i + 1) % 3]) + std::abs(a[i][(i + 2) % 3]);
            least = std::min(least, a[i][i] - others);
            most = std::max(most, a[i][i] + others);
        }
        least -= 0x1p-43 * most;
        most += 0x1p-43 * most;
    }

private:
    /// Rotates the matrix so that its entry (p, q) vanishes.
    static void rotate(double (&a)[3][3], int p, int q) {
        if (a[p][q] == 0)
            return;
        const double twist = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double t = std::copysign(1.0, twist) / (std::abs(twist) + std::hypot(twist, 1.0));
        const double c = 1 / std::sqrt(1 + t * t), s = t * c;
        for (int k = 0; k < 3; ++k) {
            const double x = a[k][p], y = a[k][q];
            a[k][p] = c * x - s * y;
            a[k][q] = s * x + c * y;
        }
        for (int k = 0; k < 3; ++k) {
            const double x = a[p][k], y = a[q][k];
            a[p][k] = c * x - s * y;
            a[q][k] = s * x + c * y;
        }
    }
};

/// Bounds the derivatives of normals N' = B N / |B N| by the derivatives of N. B holds the
/// cofactors of a map, and |B d| is between b |d| and kappa b |d|.
///
/// Let B^T B = c (1 + F) with c in the middle of its eigenvalues, so |F| <= f = (kappa^2 - 1) /
/// (kappa^2 + 1). Let r = |B N|, so c / r^2 <= (kappa^2 + 1) / 2. As N . N = 1, r^2 / c = 1 + N . F
/// N. So half of its derivatives over r^2 are at most g = c f / r^2 <= (kappa^2 - 1) / 2 times sums
/// of products of N's. Derivatives of r r = r^2 bound those of r over r. Derivatives of r N' = B N
/// bound those of N', as |B N_u| / r is at most kappa |N_u|. A similarity has kappa = 1 and g = 0.
class turned_normals {
public:
    turned_normals(double kappa, double g) : kappa_(kappa), g_(g) {}

    l3d_bend_numbers<double> operator()(l3d_bend_numbers<double> n) const {
        l3d_bend_numbers<double> result = n;
        const double ru = g_ * n.turn_u, rv = g_ * n.turn_v;
        const double ruu = g_ * (n.n_uu + n.turn_u * n.turn_u) + ru * ru;
        const double rvv = g_ * (n.n_vv + n.turn_v * n.turn_v) + rv * rv;
        const double ruv = g_ * (n.n_uv + n.turn_u * n.turn_v) + ru * rv;
        result.turn_u = kappa_ * n.turn_u;
        result.turn_v = kappa_ * n.turn_v;
        result.n_uu = kappa_ * n.n_uu + ruu + 2 * ru * result.turn_u;
        result.n_vv = kappa_ * n.n_vv + rvv + 2 * rv * result.turn_v;
        result.n_uv = kappa_ * n.n_uv + ruv + ru * result.turn_v + rv * result.turn_u;
        const double ruuu = g_ * (n.n_uuu + 3 * n.turn_u * n.n_uu) + 3 * ru * ruu;
        const double rvvv = g_ * (n.n_vvv + 3 * n.turn_v * n.n_vv) + 3 * rv * rvv;
        result.n_uuu = kappa_ * n.n_uuu + ruuu + 3 * ruu * result.turn_u + 3 * ru * result.n_uu;
        result.n_vvv = kappa_ * n.n_vvv + rvvv + 3 * rvv * result.turn_v + 3 * rv * result.n_vv;
        const double ruuv =
            g_ * (n.n_uuv + 2 * n.n_uv * n.turn_u + n.turn_v * n.n_uu) + rv * ruu + 2 * ru * ruv;
        const double ruvv =
            g_ * (n.n_uvv + 2 * n.n_uv * n.turn_v + n.turn_u * n.n_vv) + ru * rvv + 2 * rv * ruv;
        result.n_uuv = kappa_ * n.n_uuv + ruuv + 2 * ruv * result.turn_u + ruu * result.turn_v +
                       2 * ru * result.n_uv + rv * result.n_uu;
        result.n_uvv = kappa_ * n.n_uvv + ruvv + 2 * ruv * result.turn_v + rvv * result.turn_u +
                       2 * rv * result.n_uv + ru * result.n_vv;
        return result;
    }

private:
    double kappa_, g_;
};

} // namespace

double l3d_levels_off(const l3d_bend_numbers<double>& bends, double h_u, double h_v) {
    const double uuv = h_u * h_u * h_v * bends.n_uuv, uvv = h_u * h_v * h_v * bends.n_uvv;
    const double straight = h_u * h_u * h_u * bends.n_uuu + h_v * h_v * h_v * bends.n_vvv;
    return double{l3d_level_of_cosine} *
           (l3d_of_thirds * straight + (uuv + uvv + std::min(uuv, uvv)) / 16);
}

void l3d_surface_bends::set_steps() {
    for (std::size_t i = 0; i < blocks; ++i) {
        const l3d_bend_numbers<double> of = bends_of_block(of_blocks_, i);
        // Where normals hardly turn, half of the cube root of the third derivative decides.
        const double u = std::max(of.turn_u, std::cbrt(of.n_uuu) / 2);
        const double v = std::max(of.turn_v, std::cbrt(of.n_vvv) / 2);
        const double both = u > 0 && v > 0 ? std::cbrt(l3d_levels_off(of, 1 / u, 1 / v)) : 0;
        const auto steps = [&](double turn) {
            const double n = turn * both;
            return n > 1 && n < 0x1p20 ? static_cast<float>(n) : 1.0F;
        };
        steps_u_[i] = steps(u);
        steps_v_[i] = steps(v);
    }
}

l3d_surface_bends::l3d_surface_bends(const l3d_bezier_patch<double, 3>& patch,
                                     const l3d_normal_net& normals) {
    // On the heap: 160 KB are more than a host's thread may have for its stack.
    const auto bounds = std::make_unique<const bends_of_blocks>(patch, normals);
    for (std::size_t n = 0; n < bend_numbers; ++n) {
        lanes& of = of_blocks_.*bend_members<lanes>[n];
        float most = 0;
        for (std::size_t i = 0; i < blocks; ++i) {
            of[i] = rounded_up(bounds->most(n, i));
            most = std::max(most, of[i]);
        }
        // Over a block, the patch's parameters run a quarter as far. A power of two scales exactly.
        of_whole_.*bend_members<float>[n] = std::ldexp(most, 2 * bend_orders[n]);
    }
    set_steps();
}

/// Bounds the patch under a map A. For bends, N' . A d = N . d / |A^-T N| <= s N . d, where s is
/// the largest factor by which A lengthens a vector. The quotient of the largest and the least such
/// factor is the same for A and for its cofactors.
l3d_surface_bends l3d_surface_bends::under(const l3d_matrix<double>& placement) const {
    const squared_scales scales(placement);
    const double scale = std::sqrt(scales.most) * (1 + 0x1p-40);
    const double squared = scales.least > 0 ? scales.most / scales.least : HUGE_VAL;
    const turned_normals turned(std::sqrt(squared), (squared - 1) / 2);
    const auto placed = [&](const l3d_bend_numbers<double>& of) {
        l3d_bend_numbers<double> result = turned(of);
        for (std::size_t n = 0; n <= bend_uuvv; ++n)
            result.*bend_members<double>[n] *= scale;
        if (!(scales.least > 0))
            for (std::size_t n = 0; n < bend_uuvv; ++n)
                result.*bend_members<double>[n] = HUGE_VAL;
        return result;
    };
    l3d_surface_bends result;
    l3d_bend_numbers<double> of{};
    for (std::size_t i = 0; i < blocks; ++i) {
        of = placed(bends_of_block(of_blocks_, i));
        for (std::size_t n = 0; n < bend_numbers; ++n)
            (result.of_blocks_.*bend_members<lanes>[n])[i] =
                rounded_up(of.*bend_members<double>[n]);
    }
    for (std::size_t n = 0; n < bend_numbers; ++n)
        of.*bend_members<double>[n] = of_whole_.*bend_members<float>[n];
    of = placed(of);
    for (std::size_t n = 0; n < bend_numbers; ++n)
        result.of_whole_.*bend_members<float>[n] = rounded_up(of.*bend_members<double>[n]);
    result.set_steps();
    return result;
}
