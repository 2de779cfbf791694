// SPDX-License-Identifier: MIT
// l3d_placed_bends: block by block.
#include "dice/placed_bends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace {

constexpr double per_cosine = double{l3d_level_of_cosine};

/// What grey levels are off by beside interpolation: rounding to a whole level, and the arithmetic
/// of floats, some 20 * 2^-24 of numbers up to 2^8 times what their terms cancel.
constexpr double rounded_level = 0.5 + 0.01;

/// A chord of step h is off by at most two terms, along the normal at its own parameter. One comes
/// from the second derivatives there. The other is h^3 of the third derivatives times this number,
/// the largest value of s (1 - s) ((1 - 2 s) / 6 + l3d_balance). It holds whether one end of the
/// chord is moved, or both, or none.
constexpr double of_moved_thirds = 0.0322;

/// A difference over a step h of a cubic, less h times its derivative at any point of the step, is
/// at most the sum of two terms. They are h^2 times the second derivative there times the first
/// number, and h^3 times the third derivative times the second number. With s the point's place,
/// the numbers are (1 - 2 s) / 2 and ((1 - s)^3 + s^3) / 6, and l3d_balance more where ends are
/// moved.
constexpr double of_difference_second = 1.0 / 2 + l3d_balance;
constexpr double of_difference_third = 1.0 / 6 + l3d_balance;

/// Fourth derivatives, two by each parameter, count with h_u^2 h_v^2 times this. It is the sum of
/// 1/64 of chords, 2 l3d_balance / 8 of moved chords, and l3d_balance^2 of both moved. The last
/// term is a quarter of what they make of the corners' mixed difference.
constexpr double of_fourths = 1.0 / 64 + l3d_balance / 4 + l3d_balance * l3d_balance +
                              of_difference_second * of_difference_second / 4;

/// What the mixed difference of a cell's corners has of |S_uuuv|, |S_uvvv| and of all mixed
/// derivatives above the fourth, over h_u h_v.
///
/// They are 18, 18 and 36 times differences of the control points. A difference of differences is
/// twice the largest of these at most: so |S_uuuvv| <= 4 |S_uuuv|, |S_uuuvvv| <= 8 |S_uuuv|, by the
/// parameters of the piece, which run over a block `strips` times as fast.
class mixed_rest {
public:
    /// Units: unit is what a scaled w of 1 is long; x and y have `focal` as well.
    mixed_rest(const std::array<l3d_image_point, 16>& p, int strips, double unit, double focal)
        : per_strip_(1.0 / strips) {
        const auto third = [&](std::size_t line, bool turned) {
            const std::size_t first = turned ? line : 4 * line, step = turned ? 4 : 1;
            return p[first + 3 * step] - p[first] + (p[first + step] - p[first + 2 * step]) * 3.0;
        };
        const double scale = 18 * unit * per_strip_ * per_strip_ * per_strip_ * per_strip_;
        for (const bool turned : {false, true})
            for (std::size_t line = 0; line < 3; ++line) {
                const l3d_image_point d = third(line + 1, turned) - third(line, turned);
                const double x = d[0] / focal, y = d[1] / focal;
                double& most = turned ? uvvv_ : uuuv_;
                most = std::max(most, scale * std::sqrt(x * x + y * y + d[2] * d[2]));
            }
    }

    double operator()(double h_u, double h_v) const {
        const double more_u = per_strip_ * h_u, more_v = per_strip_ * h_v;
        return of_difference_third * (h_u * h_u * uuuv_ *
                                          (1 + 4 * of_difference_second * more_v +
                                           8 * of_difference_third * more_v * more_v) +
                                      h_v * h_v * uvvv_ * (1 + 4 * of_difference_second * more_u));
    }

private:
    double per_strip_, uuuv_ = 0, uvvv_ = 0;
};

/// Asked for above what second derivatives say, for the third ones in the middle of a plan.
double with_thirds(double second, double third, double steps) {
    return second + of_moved_thirds / l3d_balance * third / steps;
}

bool is_seen(const l3d_block_needs& needs, std::size_t i) {
    return needs.uu[i] + needs.uv[i] + needs.vv[i] > 0 || needs.least_u[i] + needs.least_v[i] > 0;
}

/// What levels are off by that are linear over two triangles of a quad.
double levels_off_linear(const l3d_bend_numbers<double>& b, double h_u, double h_v) {
    return per_cosine * ((h_u * h_u * b.n_uu + h_v * h_v * b.n_vv) / 8 + h_u * h_v * b.n_uv / 4);
}

/// What levels are off by in the slit along a side with steps h, if triangles reach that far.
///
/// A triangle of the slit has levels of the grid's row at its corners and at the middles of its
/// sides. All six are numbers of one parameter. So their parabola is off by as much as one along a
/// line. What the row itself is off by counts 5/3 times, the most that the sizes of six weights add
/// up to. A plane's weights are positive.
double levels_off_slit(double h, double bent, double straight, double n_2, double n_3) {
    constexpr double of_six = 5.0 / 3;
    if (std::isinf(bent + straight)) // beyond the row's end
        return bent + straight;
    const auto cube = [](double x) { return x * x * x; };
    double off = 0;
    if (bent > 0)
        off = per_cosine * l3d_of_thirds * (cube(bent) + of_six * cube(h)) * n_3;
    if (straight > 0)
        off = std::max(off, per_cosine * (straight * straight + h * h) / 8 * n_2);
    return off;
}

} // namespace

/// Where there is no normal, all that bends may bend along it; what corners are off a plane by is
/// measured when they are there (l3d_most_off_plane).
void l3d_placed_bends::set_by_size(const l3d_net_piece& piece, int strips, numbers& of) const {
    const auto& p = piece.net.points;
    // The net is scaled: x and y by the focal length and what w is scaled by, w by that alone.
    const double unit = 1 / w_per_length_;
    const auto size = [&](const l3d_image_point& d) {
        return unit * std::hypot(d[0] / focal_, d[1] / focal_, d[2]);
    };
    const double per_uu = 1.0 / (strips * strips);
    of = numbers{{}, of.steps_u, of.steps_v};
    of.n_uuu = std::numeric_limits<double>::infinity();
    for (std::size_t line = 0; line < 4; ++line)
        for (std::size_t i = 0; i < 2; ++i) {
            const std::size_t u = 4 * line + i, v = 4 * i + line;
            of.uu = std::max(of.uu, 6 * per_uu * size(p[u] - p[u + 1] * 2.0 + p[u + 2]));
            of.vv = std::max(of.vv, 6 * per_uu * size(p[v] - p[v + 4] * 2.0 + p[v + 8]));
        }
}

/// A block of a piece lies in one of the patch's blocks, or is made of several: the piece is a part
/// of the patch by halves.
auto l3d_placed_bends::of_block(const l3d_net_piece& piece, int strips, std::size_t column,
                                std::size_t row) const -> numbers {
    constexpr std::size_t across = 4;
    using lane_numbers = l3d_bend_numbers<l3d_surface_bends::lanes>;
    const lane_numbers& of = bends_->of_blocks();
    numbers result{};
    const auto take = [&](std::size_t i, double u, double v) {
        const auto at = [i](const l3d_surface_bends::lanes& of_blocks, double& most, double scale) {
            most = std::max(most, scale * double{of_blocks[i]});
        };
        at(of.uu, result.uu, u * u);
        at(of.uv, result.uv, u * v);
        at(of.vv, result.vv, v * v);
        at(of.uuu, result.uuu, u * u * u);
        at(of.uuv, result.uuv, u * u * v);
        at(of.uvv, result.uvv, u * v * v);
        at(of.vvv, result.vvv, v * v * v);
        at(of.uuvv, result.uuvv, u * u * v * v);
        at(of.n_uu, result.n_uu, u * u);
        at(of.n_uv, result.n_uv, u * v);
        at(of.n_vv, result.n_vv, v * v);
        at(of.n_uuu, result.n_uuu, u * u * u);
        at(of.n_uuv, result.n_uuv, u * u * v);
        at(of.n_uvv, result.n_uvv, u * v * v);
        at(of.n_vvv, result.n_vvv, v * v * v);
        at(bends_->steps_u(), result.steps_u, u);
        at(bends_->steps_v(), result.steps_v, v);
    };
    const double size_u = (piece.u1 - piece.u0) / strips, size_v = (piece.v1 - piece.v0) / strips;
    const auto blocks_of = [&](double low, double size, std::size_t i) {
        // Blocks begin and end at multiples of powers of two: a little inside is exact enough.
        const double from = low + size * (static_cast<double>(i) + 0x1p-10);
        const double to = low + size * (static_cast<double>(i + 1) - 0x1p-10);
        return std::array{static_cast<std::size_t>(across * from),
                          static_cast<std::size_t>(across * to)};
    };
    const auto columns = blocks_of(piece.u0, size_u, column);
    const auto rows = blocks_of(piece.v0, size_v, row);
    for (std::size_t r = rows[0]; r <= rows[1]; ++r)
        for (std::size_t c = columns[0]; c <= columns[1]; ++c)
            take(across * r + c, across * size_u, across * size_v);
    if (!std::isfinite(result.uu + result.uv + result.vv + result.uuu + result.vvv))
        set_by_size(piece, strips, result);
    return result;
}

void l3d_placed_bends::ask(const l3d_net_piece& piece, const l3d_dice_view& view, double budget,
                           double depth_budget, l3d_block_needs& needs) const {
    const double to_w = view.focal * w_per_length_;
    const double levels = std::max(view.shade_tolerance - rounded_level - l3d_most_level_error,
                                   view.shade_tolerance / 4);
    const double more_steps = std::cbrt(1 / levels);
    const auto strips = static_cast<std::size_t>(needs.strips);
    // Fewest steps come from sides of at most l3d_largest_quad pixels.
    constexpr double finest_quad = 6;
    constexpr double most_steps = l3d_largest_quad / finest_quad;
    for (std::size_t row = 0; row < strips; ++row)
        for (std::size_t column = 0; column < strips; ++column) {
            const std::size_t i = strips * row + column;
            if (!is_seen(needs, i))
                continue;
            const numbers b = of_block(piece, needs.strips, column, row);
            // As the planner sees it, budgets of depth are those of places.
            const double per_budget = to_w / needs.least_w[i] * (budget / depth_budget);
            const auto steps_of = [&](double second) {
                return std::max(1.0, std::sqrt(second / (4 * budget)));
            };
            const double n_u = steps_of(needs.uu[i]), n_v = steps_of(needs.vv[i]);
            const auto raise = [&](double& need, double by) {
                if (std::isfinite(by))
                    need = std::max(need, by);
            };
            raise(needs.uu[i], per_budget * with_thirds(b.uu, b.uuu, n_u));
            raise(needs.vv[i], per_budget * with_thirds(b.vv, b.vvv, n_v));
            // The planner counts a sixteenth of what corners are off a plane by.
            raise(needs.uv[i], 4 * per_budget * (b.uv + b.uuv / n_u + b.uvv / n_v));
            if (!view.makes_levels() && view.shading.mode != l3d_shade::error)
                continue;
            raise(needs.least_u[i],
                  std::min(b.steps_u * more_steps, most_steps * needs.least_u[i]));
            raise(needs.least_v[i],
                  std::min(b.steps_v * more_steps, most_steps * needs.least_v[i]));
        }
}

l3d_surface_certificate
l3d_placed_bends::certificate(const l3d_net_piece& piece, const l3d_dice_view& view,
                              const l3d_block_needs& needs, const l3d_step_plan& plan,
                              const l3d_slit_spans& slits, bool clipped) const {
    constexpr double nothing = std::numeric_limits<double>::infinity();
    if (!*this)
        return {nothing, nothing};
    const auto strips = static_cast<std::size_t>(needs.strips);
    const mixed_rest mixed(piece.net.points, needs.strips, 1 / w_per_length_, focal_);
    l3d_surface_certificate result;
    for (std::size_t row = 0; row < strips; ++row)
        for (std::size_t column = 0; column < strips; ++column) {
            const std::size_t i = strips * row + column;
            if (!is_seen(needs, i))
                continue;
            const double to_pixels = view.focal * w_per_length_ / needs.least_w[i];
            const numbers b = of_block(piece, needs.strips, column, row);
            const double h_u = 1.0 / plan.nu[column], h_v = 1.0 / plan.nv[row];
            const auto bent = [&](double h, double second, double third, bool at_side) {
                // Slits at the piece's sides lie between chords that are not balanced.
                const bool balanced = plan.balanced && h < 1 && !at_side;
                return h * h *
                       ((balanced ? l3d_balance : 1.0 / 8) * second + of_moved_thirds * h * third);
            };
            const bool side_row = row == 0 || row + 1 == strips;
            const bool side_column = column == 0 || column + 1 == strips;
            const double along_u = bent(h_u, b.uu, b.uuu, false),
                         along_v = bent(h_v, b.vv, b.vvv, false);
            const double off_plane =
                h_u * h_v *
                (b.uv + of_difference_second * (h_u * b.uuv + h_v * b.uvv) + mixed(h_u, h_v)) / 4;
            const double quad =
                along_u + along_v + off_plane + of_fourths * h_u * h_u * h_v * h_v * b.uuvv;
            const double slit = std::max(side_row ? bent(h_u, b.uu, b.uuu, true) : 0.0,
                                         side_column ? bent(h_v, b.vv, b.vvv, true) : 0.0);
            result.depth = std::max({result.depth, to_pixels * quad, to_pixels * slit});
            const double off =
                clipped ? levels_off_linear(b, h_u, h_v) : l3d_levels_off(b, h_u, h_v);
            if (off + rounded_level + l3d_most_level_error <= view.shade_tolerance)
                result.shade = std::max(result.shade, off);
            else
                result.unshaded_quads += std::int64_t{plan.nu[column]} * plan.nv[row];
            const auto slit_levels = [&](bool of_u, std::size_t block, bool at_side) {
                const double size = (of_u ? piece.u1 - piece.u0 : piece.v1 - piece.v0) /
                                    static_cast<double>(strips);
                const std::size_t direction = of_u ? 0 : 1;
                return at_side
                           ? levels_off_slit(of_u ? h_u : h_v, slits.bent[direction][block] / size,
                                             slits.straight[direction][block] / size,
                                             of_u ? b.n_uu : b.n_vv, of_u ? b.n_uuu : b.n_vvv)
                           : 0;
            };
            const double off_slit =
                std::max(slit_levels(true, column, side_row), slit_levels(false, row, side_column));
            if (off_slit + rounded_level + l3d_most_level_error <= view.shade_tolerance)
                result.shade = std::max(result.shade, off_slit);
            else
                ++result.unshaded_quads;
            if (!std::isfinite(b.n_uuu))
                result.without_normals |= 1U << i;
        }
    result.shade = result.shade + rounded_level;
    return result;
}

double l3d_most_off_plane(const l3d_surface_part& part, unsigned blocks,
                          const l3d_dice_view& view) {
    using vector = l3d_vector<double, 3>;
    const l3d_micro_grid& grid = part.grid;
    const auto place = [&](std::size_t i) {
        const double w = 1 / double{grid.inv_w[i]}, pixel = w / (l3d_subpixel_one * view.focal);
        return vector{(grid.x[i] - view.centre_x()) * pixel, (grid.y[i] - view.centre_y()) * pixel,
                      w};
    };
    const auto of_quad = [&](int row, int column) {
        const std::size_t a = grid.index(row, column), d = grid.index(row + 1, column);
        const vector p[4] = {place(a), place(a + 1), place(d + 1), place(d)};
        const vector normal = l3d_cross(p[2] - p[0], p[3] - p[1]);
        const double length = l3d_length(normal);
        const vector twist = p[0] - p[1] + p[2] - p[3];
        const double off =
            length > 0 ? std::abs(l3d_dot(normal, twist)) / length : l3d_length(twist);
        return view.focal * off / (4 * std::min({p[0][2], p[1][2], p[2][2], p[3][2]}));
    };
    double most = 0;
    const auto strips = static_cast<std::size_t>(part.block_rows.blocks);
    for (std::size_t i = 0; i < strips * strips; ++i) {
        if ((blocks >> i & 1) == 0)
            continue;
        const auto &rows = part.block_rows.first, &columns = part.block_columns.first;
        for (int row = rows[i / strips]; row < rows[i / strips + 1]; ++row)
            for (int column = columns[i % strips]; column < columns[i % strips + 1]; ++column)
                most = std::max(most, of_quad(row, column));
    }
    return most;
}
