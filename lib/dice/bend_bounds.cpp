// SPDX-License-Identifier: MIT
// l3d_bend_bounds: bounds of the errors of depth and shade, block by block.
#include "dice/bend_bounds.h"

#include "dice/drawn_error.h"
#include "dice/snap.h"
#include "scene/bends/surface_bends_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace {

constexpr double per_cosine = double{l3d_level_of_cosine};

/// Bounds the error of shade levels that does not come from interpolation. It comes from rounding
/// to a whole level, and from float arithmetic. Numbers in this arithmetic are up to 2^8, and some
/// 20 roundings of 2^-24 count as often as terms cancel.
constexpr double rounded_level = 0.5 + 0.01;

/// Bounds |S_uuuv| and |S_uvvv| by the parameters of a piece's blocks: 18 times the fourth
/// differences of the piece's control net, scaled to a block.
struct mixed_thirds {
    double uuuv = 0, uvvv = 0;

    /// Units: `unit` is the length for which w = 1 stands; x and y are `focal` times as large.
    mixed_thirds(const std::array<l3d_image_point, 16>& p, int strips, double unit, double focal) {
        const auto third = [&](std::size_t line, bool turned) {
            const std::size_t first = turned ? line : 4 * line, step = turned ? 4 : 1;
            return p[first + 3 * step] - p[first] + (p[first + step] - p[first + 2 * step]) * 3.0;
        };
        const double per_strip = 1.0 / strips;
        const double scale = 18 * unit * per_strip * per_strip * per_strip * per_strip;
        for (const bool turned : {false, true})
            for (std::size_t line = 0; line < 3; ++line) {
                const l3d_image_point d = third(line + 1, turned) - third(line, turned);
                const double x = d[0] / focal, y = d[1] / focal;
                double& most = turned ? uvvv : uuuv;
                most = std::max(most, scale * std::sqrt(x * x + y * y + d[2] * d[2]));
            }
    }
};

/// The largest proven error of normals where pixels interpolate normals. Blocks whose normals may
/// err by more count as unproven.
constexpr double most_normal = 1.0 / 64;

/// Whether pixels interpolate the normals of vertices, not their shade levels.
bool takes_normals(const l3d_dice_view& view) {
    return !view.makes_levels() && view.shading.mode != l3d_shade::error;
}

float power(float x, int n) {
    float result = 1;
    for (int i = 0; i < n; ++i)
        result *= x;
    return result;
}

bool is_seen(const l3d_block_needs& needs, std::size_t i) {
    return needs.uu[i] + needs.uv[i] + needs.vv[i] > 0 || needs.least_u[i] + needs.least_v[i] > 0;
}

/// Returns needs with the bends of the blocks whose bits are set. The bends of all other blocks are
/// cleared.
l3d_block_needs only(const l3d_block_needs& needs, unsigned blocks) {
    l3d_block_needs result = needs;
    for (std::size_t i = 0; i < l3d_block_needs::most_blocks; ++i)
        if ((blocks >> i & 1) == 0)
            result.bends.clear(i);
    return result;
}

/// Bounds the error of shade levels that are interpolated linearly over the two triangles of a
/// quad.
double levels_off_linear(const l3d_bend_numbers<double>& b, double h_u, double h_v) {
    return per_cosine * ((h_u * h_u * b.n_uu + h_v * h_v * b.n_vv) / 8 + h_u * h_v * b.n_uv / 4);
}

/// Bounds the error of normals that are interpolated between corners: linearly over triangles, or
/// bilinearly over a quad. Clipping normalizes interpolated normals at each of seven planes, which
/// adds at most the square of the angle between corners' normals (NUMERICS, section 24).
double normals_off(const l3d_bend_numbers<double>& b, double h_u, double h_v, bool clipped) {
    const double off = levels_off_linear(b, h_u, h_v) / per_cosine;
    const double apart = h_u * b.turn_u + h_v * b.turn_v;
    if (!clipped)
        return off;
    return apart <= 1 ? off + apart * apart : std::numeric_limits<double>::infinity();
}

/// Bounds the error of shade levels in the slit along a side whose steps are h. `bent` is how far
/// the slit's triangles with parabolas of levels reach along the side, `straight` how far those
/// with linear levels do (l3d_gap_spans).
/// Units: parameters of the block.
///
/// A triangle of the slit takes levels of the grid's row at its corners and at the middles of its
/// sides. All six levels depend on one parameter. So the parabola through them errs as a parabola
/// along a line. The row's own error counts 5/3 times, the most to which the sizes of six weights
/// add up. With linear levels the weights are positive, so the row's error counts once.
double levels_off_slit(double h, double bent, double straight, double n_2, double n_3) {
    constexpr double of_six = 5.0 / 3;
    if (std::isinf(bent + straight)) // it reaches beyond the row's end
        return bent + straight;
    const auto cube = [](double x) { return x * x * x; };
    double off = 0;
    if (bent > 0)
        off = per_cosine * l3d_of_thirds * (cube(bent) + of_six * cube(h)) * n_3;
    if (straight > 0)
        off = std::max(off, per_cosine * (straight * straight + h * h) / 8 * n_2);
    return off;
}

/// Bounds the error of normals that are interpolated linearly over a slit's triangles. A triangle's
/// corner between the row's vertices has the error of the row's chords, and as much again from
/// normalizing.
double normals_off_slit(double h, double longest, double n_2, double turn) {
    if (std::isinf(longest)) // it reaches beyond the row's end
        return longest;
    const double apart = longest * turn;
    return longest > 0 ? (longest * longest / 8 + h * h / 4) * n_2 + apart * apart : 0;
}

} // namespace

/// Sets the bends of blocks whose normals have no bounds. Whole second differences bound their
/// bends along any normal. Once vertices exist, l3d_most_off_plane measures how far the blocks'
/// quads are off planes.
void l3d_bend_bounds::set_by_size(const l3d_patch_part& piece, int strips, of_piece& of) const {
    unsigned without = 0;
    const auto count = static_cast<std::size_t>(strips * strips);
    for (std::size_t i = 0; i < count; ++i)
        if (!std::isfinite(of.bends.uu[i] + of.bends.uv[i] + of.bends.vv[i] + of.bends.uuu[i] +
                           of.bends.vvv[i]))
            without |= 1U << i;
    if (without == 0)
        return;
    const auto& p = piece.net.points;
    // The net is scaled: x and y by the focal length and by w's scale, w by its scale alone.
    const double unit = 1 / w_per_length_;
    const auto size = [&](const l3d_image_point& d) {
        return unit * std::hypot(d[0] / focal_, d[1] / focal_, d[2]);
    };
    double uu = 0, vv = 0;
    for (std::size_t line = 0; line < 4; ++line)
        for (std::size_t i = 0; i < 2; ++i) {
            const std::size_t u = 4 * line + i, v = 4 * i + line;
            uu = std::max(uu, size(p[u] - p[u + 1] * 2.0 + p[u + 2]));
            vv = std::max(vv, size(p[v] - p[v + 4] * 2.0 + p[v + 8]));
        }
    // The factor 1 + 2^-23 makes up for rounding to floats.
    const double of_block = 6 * (1 + 0x1p-23) / (strips * strips);
    for (std::size_t i = 0; i < count; ++i) {
        if ((without >> i & 1) == 0)
            continue;
        for (const auto member : l3d_detail::bend_members<l3d_surface_bends::lanes>)
            (of.bends.*member)[i] = 0;
        of.bends.uu[i] = static_cast<float>(of_block * uu);
        of.bends.vv[i] = static_cast<float>(of_block * vv);
        of.bends.n_uuu[i] = std::numeric_limits<float>::infinity();
    }
}

/// Finds the bends of a piece's blocks. A piece is made by halving the patch. So each of the
/// piece's blocks lies in one block of the patch or consists of several, and all factors are powers
/// of two.
auto l3d_bend_bounds::of_blocks(const l3d_patch_part& piece, int strips) const -> of_piece {
    of_piece result;
    const bool is_whole = piece.u1 - piece.u0 == 1 && piece.v1 - piece.v0 == 1;
    if (is_whole && strips == l3d_block_needs::most_strips) {
        result = {bends_->of_blocks(), bends_->steps_u(), bends_->steps_v()};
    } else if (is_whole && strips == 1) {
        for (std::size_t n = 0; n < l3d_detail::bend_members<float>.size(); ++n)
            (result.bends.*l3d_detail::bend_members<l3d_surface_bends::lanes>[n])[0] =
                bends_->of_whole().*l3d_detail::bend_members<float>[n];
        const auto most_of_whole = [](const l3d_surface_bends::lanes& steps) {
            constexpr float across = 4;
            float most = 0;
            for (const float n : steps)
                most = std::max(most, n);
            return across * most;
        };
        result.steps_u[0] = most_of_whole(bends_->steps_u());
        result.steps_v[0] = most_of_whole(bends_->steps_v());
    } else {
        result = {};
        const auto count = static_cast<std::size_t>(strips);
        for (std::size_t row = 0; row < count; ++row)
            for (std::size_t column = 0; column < count; ++column)
                take_block(piece, strips, column, row, result);
    }
    set_by_size(piece, strips, result);
    return result;
}

void l3d_bend_bounds::take_block(const l3d_patch_part& piece, int strips, std::size_t column,
                                 std::size_t row, of_piece& to) const {
    constexpr std::size_t across = 4;
    const std::size_t at = static_cast<std::size_t>(strips) * row + column;
    const double size_u = (piece.u1 - piece.u0) / strips, size_v = (piece.v1 - piece.v0) / strips;
    const auto blocks_of = [](double low, double size, std::size_t i) {
        // Blocks end at multiples of powers of two. So points a little inside are in the right
        // block despite rounding.
        const double from = low + size * (static_cast<double>(i) + 0x1p-10);
        const double end = low + size * (static_cast<double>(i + 1) - 0x1p-10);
        return std::array{static_cast<std::size_t>(across * from),
                          static_cast<std::size_t>(across * end)};
    };
    const auto columns = blocks_of(piece.u0, size_u, column);
    const auto rows = blocks_of(piece.v0, size_v, row);
    // The size of the piece's blocks in units of the patch's.
    const auto u = static_cast<float>(across * size_u), v = static_cast<float>(across * size_v);
    const auto take = [&](const l3d_surface_bends::lanes& from, l3d_surface_bends::lanes& most,
                          float scale) {
        for (std::size_t r = rows[0]; r <= rows[1]; ++r)
            for (std::size_t c = columns[0]; c <= columns[1]; ++c)
                most[at] = std::max(most[at], scale * from[across * r + c]);
    };
    using l3d_detail::bend_members;
    for (std::size_t n = 0; n < bend_members<l3d_surface_bends::lanes>.size(); ++n) {
        const auto [by_u, by_v] = l3d_detail::bend_powers[n];
        const auto member = bend_members<l3d_surface_bends::lanes>[n];
        take(bends_->of_blocks().*member, to.bends.*member, power(u, by_u) * power(v, by_v));
    }
    take(bends_->steps_u(), to.steps_u, u);
    take(bends_->steps_v(), to.steps_v, v);
}

void l3d_bend_bounds::ask(const l3d_patch_part& piece, const l3d_dice_view& view,
                          double depth_budget, l3d_block_needs& needs) const {
    const double levels = std::max(view.shade_tolerance - rounded_level - l3d_most_level_error,
                                   view.shade_tolerance / 4);
    const double more_steps = std::cbrt(1 / levels);
    // The least steps give sides of l3d_largest_quad pixels. Multiplied by at most this ratio, they
    // give sides of finest_quad pixels.
    constexpr double finest_quad = 6;
    constexpr double most_steps = l3d_largest_quad / finest_quad;
    const bool keeps_shade = !takes_normals(view);
    const auto count = static_cast<std::size_t>(needs.strips * needs.strips);
    const of_piece of = of_blocks(piece, needs.strips);
    const mixed_thirds mixed(piece.net.points, needs.strips, 1 / w_per_length_, focal_);
    needs.keeps_bends = true;
    std::array<double, l3d_block_needs::most_blocks> scale{};
    // Blocks without normals are measured after dicing. Half of the snapping error stays free for
    // them, since most of their quads are flat except for snapping.
    const double less = std::max(depth_budget - l3d_snap_error<double>(0) / 2, depth_budget / 2);
    for (std::size_t i = 0; i < count; ++i)
        if (is_seen(needs, i)) {
            const bool has_normals = std::isfinite(of.bends.n_uuu[i]);
            needs.without_normals |= has_normals ? 0U : 1U << i;
            const double of_block = has_normals ? depth_budget : less;
            scale[i] = view.focal * w_per_length_ / (needs.least_w[i] * of_block);
        }
    const auto put = [&](const l3d_surface_bends::lanes& from, l3d_block_needs::per_block& to) {
        for (std::size_t i = 0; i < count; ++i)
            to[i] = scale[i] * double{from[i]};
    };
    l3d_block_needs::normal_bends& to = needs.bends;
    put(of.bends.uu, to.uu);
    put(of.bends.uv, to.uv);
    put(of.bends.vv, to.vv);
    put(of.bends.uuu, to.uuu);
    put(of.bends.uuv, to.uuv);
    put(of.bends.uvv, to.uvv);
    put(of.bends.vvv, to.vvv);
    put(of.bends.uuvv, to.uuvv);
    for (std::size_t i = 0; i < count; ++i) {
        to.uuuv[i] = scale[i] * mixed.uuuv;
        to.uvvv[i] = scale[i] * mixed.uvvv;
    }
    if (!keeps_shade)
        return;
    const auto raise = [&](double& need, float steps) {
        const double by = std::min(double{steps} * more_steps, most_steps * need);
        if (std::isfinite(by))
            need = std::max(need, by);
    };
    for (std::size_t i = 0; i < count; ++i)
        if (scale[i] > 0) {
            raise(needs.least_u[i], of.steps_u[i]);
            raise(needs.least_v[i], of.steps_v[i]);
        }
}

l3d_surface_certificate l3d_bend_bounds::certificate(const l3d_patch_part& piece,
                                                     const l3d_dice_view& view, double depth_budget,
                                                     const l3d_block_needs& needs,
                                                     const l3d_step_plan& plan,
                                                     const l3d_gap_spans& slits,
                                                     bool clipped) const {
    constexpr double nothing = std::numeric_limits<double>::infinity();
    if (!*this)
        return {nothing, nothing};
    const auto strips = static_cast<std::size_t>(needs.strips);
    const of_piece of = of_blocks(piece, needs.strips);
    l3d_surface_certificate result;
    result.depth = plan.bend_error * depth_budget;
    const bool of_normals = takes_normals(view);
    const auto take = [&](double off, std::int64_t quads) {
        if (of_normals && off <= most_normal)
            result.normal = std::max(result.normal, off);
        else if (!of_normals && off + rounded_level + l3d_most_level_error <= view.shade_tolerance)
            result.shade = std::max(result.shade, off);
        else
            result.unproven_quads += quads;
    };
    for (std::size_t row = 0; row < strips; ++row)
        for (std::size_t column = 0; column < strips; ++column) {
            const std::size_t i = strips * row + column;
            if (!is_seen(needs, i))
                continue;
            const l3d_bend_numbers<double> b = l3d_detail::bends_of_block(of.bends, i);
            const double h_u = 1.0 / plan.nu[column], h_v = 1.0 / plan.nv[row];
            const bool side_row = row == 0 || row + 1 == strips;
            const bool side_column = column == 0 || column + 1 == strips;
            take(of_normals ? normals_off(b, h_u, h_v, clipped)
                 : clipped  ? levels_off_linear(b, h_u, h_v)
                            : l3d_levels_off(b, h_u, h_v),
                 std::int64_t{plan.nu[column]} * plan.nv[row]);
            const auto off_slit = [&](bool of_u, std::size_t block, bool at_side) {
                if (!at_side)
                    return 0.0;
                const double size = (of_u ? piece.u1 - piece.u0 : piece.v1 - piece.v0) /
                                    static_cast<double>(strips);
                const std::size_t direction = of_u ? 0 : 1;
                const double bent = slits.bent[direction][block] / size;
                const double straight = slits.straight[direction][block] / size;
                const double h = of_u ? h_u : h_v, n_2 = of_u ? b.n_uu : b.n_vv;
                const double turn = clipped ? (of_u ? b.turn_u : b.turn_v) : 0;
                return of_normals
                           ? normals_off_slit(h, std::max(bent, straight), n_2, turn)
                           : levels_off_slit(h, bent, straight, n_2, of_u ? b.n_uuu : b.n_vvv);
            };
            take(std::max(off_slit(true, column, side_row), off_slit(false, row, side_column)), 1);
            if (!std::isfinite(b.n_uuu))
                result.without_normals |= 1U << i;
        }
    if (!of_normals)
        result.shade = result.shade + rounded_level;
    if (result.without_normals != 0)
        result.depth_without_normals =
            depth_budget * l3d_bend_error_of(only(needs, result.without_normals), plan);
    return result;
}

double l3d_most_off_plane(const l3d_surface_part& part, unsigned blocks,
                          const l3d_dice_view& view) {
    using vector = l3d_vector<double, 3>;
    const l3d_micro_grid& grid = part.grid;
    const auto place = [&](std::size_t i) {
        const double w = view.is_parallel() ? view.w_at(grid.inv_w[i]) : 1 / double{grid.inv_w[i]};
        const double pixel = w / (l3d_subpixel_one * view.focal);
        return vector{(grid.x[i] - view.centre_x()) * pixel, (grid.y[i] - view.centre_y()) * pixel,
                      w};
    };
    // The two vertices of a column on the rows of a quad. The next column has the quad's other two.
    using side = std::array<vector, 2>;
    const auto off_plane = [&](const side& left, const side& right) {
        const vector normal = l3d_cross(right[1] - left[0], left[1] - right[0]);
        const vector twist = left[0] - right[0] + right[1] - left[1];
        const double square = l3d_dot(normal, normal);
        const double off =
            square > 0 ? std::abs(l3d_dot(normal, twist)) / std::sqrt(square) : l3d_length(twist);
        return view.focal * off /
               (4 * std::min({left[0][2], right[0][2], right[1][2], left[1][2]}));
    };
    double most = 0;
    const auto strips = static_cast<std::size_t>(part.block_rows.blocks);
    for (std::size_t i = 0; i < strips * strips; ++i) {
        if ((blocks >> i & 1) == 0)
            continue;
        const auto &rows = part.block_rows.first, &columns = part.block_columns.first;
        for (int row = rows[i / strips]; row < rows[i / strips + 1]; ++row) {
            side left{};
            for (int column = columns[i % strips]; column <= columns[i % strips + 1]; ++column) {
                const side right{place(grid.index(row, column)),
                                 place(grid.index(row + 1, column))};
                if (column > columns[i % strips])
                    most = std::max(most, off_plane(left, right));
                left = right;
            }
        }
    }
    return std::max(most - l3d_vertex_accuracy::of_centre(), most / 4);
}

/// More steps help where quads are too far off planes. Both the bounded and the measured error fall
/// with the square of the number of steps. The error of snapping does not fall, and may exceed the
/// budget.
bool l3d_ask_for_planes(const l3d_surface_part& part, const l3d_step_plan& plan,
                        const l3d_dice_view& view, double depth_budget, l3d_block_needs& needs) {
    if (needs.without_normals == 0)
        return false;
    const double off = l3d_most_off_plane(part, needs.without_normals, view) +
                       depth_budget * l3d_bend_error_of(only(needs, needs.without_normals), plan);
    if (off <= depth_budget + l3d_snapped_planes)
        return false;
    constexpr double most = 2; // smaller quads may be far flatter than the measured ones
    const double more = std::min(std::sqrt(off / depth_budget), most);
    for (std::size_t i = 0; i < l3d_block_needs::most_blocks; ++i)
        if ((needs.without_normals >> i & 1) != 0) {
            const auto strips = static_cast<std::size_t>(plan.strips);
            needs.least_u[i] = std::max(needs.least_u[i], more * plan.nu[i % strips]);
            needs.least_v[i] = std::max(needs.least_v[i], more * plan.nv[i / strips]);
        }
    return true;
}
