// SPDX-License-Identifier: MIT
// mesh_steps: bounds second derivatives, and finds steps on which patches with common borders
// agree.
#include "raster/paths/mesh_steps_p.h"

#include <algorithm>
#include <cmath>

namespace l3d_detail {

namespace {

/// The largest errors of a dicing. A colour may be `place_error` pixels from its place on the
/// patch. A linear colour may be `level_error` levels from the bilinear colour.
constexpr double place_error = 1.0 / 16, level_error = 1.0 / 16;
/// The largest number of steps in a quarter. If a patch fills a picture of 2^14 pixels a side, each
/// of its 512 x 512 cells is then 2^5 pixels wide.
constexpr int most_steps = 128;

/// Four control numbers in a row of a net. A net has one coordinate of a bicubic patch's control
/// points, or of the control vectors of a second derivative.
using curve = std::array<double, 4>;
using net = std::array<curve, 4>;

/// The nets of both coordinates, x and y.
using nets = std::array<net, 2>;
template <class Function> auto of_both(const nets& of, const Function& function) {
    return std::array{function(of[0]), function(of[1])};
}

/// The four control numbers of a cubic that equals the curve with control numbers a and b: raises
/// the degree.
curve as_cubic(double a, double b) {
    const double step = (b - a) / 3;
    return {a, a + step, a + 2 * step, b};
}
curve as_cubic(double a, double b, double c) {
    return {a, (a + 2 * b) / 3, (2 * b + c) / 3, c};
}

double bend(double a, double b, double c) {
    return 6 * (a - 2 * b + c);
}

net turned(const net& p) {
    net result;
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c)
            result[r][c] = p[c][r];
    return result;
}

/// The control vectors of Suu. For the transposed net, the result is Svv, transposed.
net along_rows(const net& p) {
    net result;
    for (std::size_t r = 0; r < 4; ++r)
        result[r] = as_cubic(bend(p[r][0], p[r][1], p[r][2]), bend(p[r][1], p[r][2], p[r][3]));
    return result;
}

/// The control vectors of Suv, transposed.
net twist_of(const net& p) {
    net rows; // three rows, cubics along u
    for (std::size_t r = 0; r < 3; ++r) {
        const auto twist = [&](std::size_t c) {
            return 9 * (p[r][c] - p[r + 1][c] - p[r][c + 1] + p[r + 1][c + 1]);
        };
        rows[r] = as_cubic(twist(0), twist(1), twist(2));
    }
    net result;
    for (std::size_t c = 0; c < 4; ++c)
        result[c] = as_cubic(rows[0][c], rows[1][c], rows[2][c]);
    return result;
}

/// Cuts all columns into quarters, by de Casteljau's algorithm twice in the middle.
std::array<net, 4> quarters(const net& p) {
    constexpr auto middle = [](const curve& a, const curve& b) {
        curve result;
        for (std::size_t c = 0; c < 4; ++c)
            result[c] = (a[c] + b[c]) / 2;
        return result;
    };
    constexpr auto halves = [middle](const net& of) {
        const curve first = middle(of[0], of[1]), last = middle(of[2], of[3]),
                    inner = middle(of[1], of[2]), second = middle(first, inner),
                    third = middle(inner, last), fourth = middle(second, third);
        return std::array<net, 2>{{{of[0], first, second, fourth}, {fourth, third, last, of[3]}}};
    };
    const auto [above, below] = halves(p);
    const auto [first, second] = halves(above);
    const auto [third, fourth] = halves(below);
    return {first, second, third, fourth};
}

/// An upper bound of the length of the vectors in a patch: the longest control vector.
double longest(const nets& of) {
    curve squares{}; // squares of four vectors at once
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c)
            squares[c] =
                std::max(squares[c], of[0][r][c] * of[0][r][c] + of[1][r][c] * of[1][r][c]);
    return std::sqrt(*std::ranges::max_element(squares));
}

/// The largest x y a + y z b + z x c for x, y, z >= 0 with the sum 1. If one of a, b and c is at
/// least the sum of the other two, the largest value is in the middle of the triangle's side to
/// which this number belongs. Otherwise it is inside the triangle.
double largest_mix(double a, double b, double c) {
    const double most = std::max({a, b, c});
    if (2 * most >= a + b + c)
        return most / 4;
    a /= most; // lest products overflow
    b /= most;
    c /= most;
    return most * (a * b * c / (2 * (a * b + b * c + c * a) - a * a - b * b - c * c));
}

/// The steps that a part of a patch needs: steps of at most 1 / `steps` of the whole parameter
/// range are short enough.
struct needed_steps {
    double steps;
    bool rising; ///< whether cells are cut along the rising diagonal
};

/// The steps that keep places within place_error. A linear triangle errs by at most half of the
/// largest_mix of the second derivatives along its sides. In a cell of side h, these are h^2 times
/// Suu, Svv and, along the diagonal, Suu +- 2 Suv + Svv. Making a cell shorter only along u, or
/// only along v, adds no error (NUMERICS 20).
///
/// Source: Waldron: The error in linear interpolation at the vertices of a simplex (SIAM J.
/// Numerical Analysis 35, 1998).
needed_steps steps_for_places(const nets& along, const nets& down, const nets& twist) {
    nets falling, rising;
    for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t r = 0; r < 4; ++r)
            for (std::size_t c = 0; c < 4; ++c) {
                const double both = along[k][r][c] + down[k][r][c];
                falling[k][r][c] = both + 2 * twist[k][r][c];
                rising[k][r][c] = both - 2 * twist[k][r][c];
            }
    const double if_falling = longest(falling), if_rising = longest(rising);
    const double most =
        largest_mix(longest(along), longest(down), std::min(if_falling, if_rising)) / 2;
    return {std::sqrt(most / place_error), if_rising < if_falling};
}

/// The steps that keep colours within level_error. In a cell of side h, linear colours err by at
/// most h^2 / 4 times the twist of the bilinear colours.
double steps_for_colors(const l3d_mesh_patch& patch) {
    int most = 0;
    for (const int shift : {0, 8, 16}) {
        const auto level = [&](std::size_t i) { return int(patch.colors[i] >> shift & 255); };
        most = std::max(most, std::abs(level(0) - level(1) - level(2) + level(3)));
    }
    return std::sqrt(most / (4 * level_error));
}

int whole_steps(double steps, int most) {
    return static_cast<int>(std::ceil(std::clamp<double>(steps, 1, most)));
}

/// The dicing that a patch needs by itself, without regard to its neighbours.
mesh_dicing dicing_of(const l3d_mesh_patch& patch, mesh_colors colors) {
    mesh_dicing result;
    if (!is_finite(patch))
        return result;
    nets points;
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c) {
            points[0][r][c] = patch.points[r][c].x;
            points[1][r][c] = patch.points[r][c].y;
        }
    // Columns of control points are rows here, so that quarters of columns come first.
    const nets along = of_both(points, [](const net&p) { return turned(along_rows(p)); }),
               down = of_both(points, [](const net&p) { return along_rows(turned(p)); }),
               twist = of_both(points, twist_of);
    const double for_colors = colors == mesh_colors::linear ? steps_for_colors(patch) : 1;
    const needed_steps all = steps_for_places(along, down, twist);
    result.along.whole = result.down.whole =
        whole_steps(std::max(all.steps, for_colors), 4 * most_steps);
    result.rising = all.rising ? 0xffff : 0;
    if (!result.along.is_quartered())
        return result;
    result.rising = 0;
    const auto alongs = of_both(along, quarters), downs = of_both(down, quarters),
               twists = of_both(twist, quarters);
    for (std::size_t c = 0; c < 4; ++c) {
        const auto parts = [c](const std::array<std::array<net, 4>, 2>& columns) {
            return std::array{quarters(turned(columns[0][c])), quarters(turned(columns[1][c]))};
        };
        const auto along_parts = parts(alongs), down_parts = parts(downs),
                   twist_parts = parts(twists);
        for (std::size_t r = 0; r < 4; ++r) {
            const auto part_of = [r](const std::array<std::array<net, 4>, 2>& rows) {
                return nets{rows[0][r], rows[1][r]};
            };
            const needed_steps part =
                steps_for_places(part_of(along_parts), part_of(down_parts), part_of(twist_parts));
            const int steps = whole_steps(std::max(part.steps, for_colors) / 4, most_steps);
            int &in_column = result.along.of_quarter[c], &in_row = result.down.of_quarter[r];
            in_column = std::max(in_column, steps);
            in_row = std::max(in_row, steps);
            if (part.rising)
                result.rising = static_cast<std::uint16_t>(result.rising | 1u << (4 * r + c));
        }
    }
    return result;
}

} // namespace

bool is_finite(const l3d_mesh_patch& patch) {
    return std::ranges::all_of(patch.points, [](const auto& row) {
        return std::ranges::all_of(
            row, [](const l3d_point_2d& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
    });
}

void mesh_steps::cover(const mesh_steps& other) {
    whole = std::max(whole, other.whole);
    for (std::size_t q = 0; q < 4; ++q)
        of_quarter[q] = std::max(of_quarter[q], other.of_quarter[q]);
}

mesh_steps mesh_steps::backwards() const {
    return {whole, {of_quarter[3], of_quarter[2], of_quarter[1], of_quarter[0]}};
}

void mesh_knots::set(const mesh_steps& steps) {
    size = 0;
    const std::size_t most = steps.is_quartered() ? 4 * std::size_t{most_steps} : mesh_steps::few;
    for (std::vector<double>* of : {&at, &weights[0], &weights[1], &weights[2], &weights[3]})
        of->resize(most + 1 + room);
    quarter.resize(most + 1);
    // Weights at i / n. Those at (n - i) / n are the same numbers in the opposite order, bit for
    // bit.
    const auto add = [this](int i, int n, std::size_t of_quarter) {
        const double t = static_cast<double>(i) / n, s = static_cast<double>(n - i) / n;
        at[size] = t;
        weights[0][size] = s * s * s;
        weights[1][size] = 3 * (s * s * t);
        weights[2][size] = 3 * (t * t * s);
        weights[3][size] = t * t * t;
        quarter[size++] = of_quarter;
    };
    add(0, 1, 0);
    if (!steps.is_quartered())
        for (int i = 1; i <= steps.whole; ++i)
            add(i, steps.whole, 0);
    else
        for (std::size_t q = 0; q < 4; ++q)
            for (int n = steps.of_quarter[q], i = 1; i <= n; ++i)
                add(static_cast<int>(q) * n + i, 4 * n, q);
}

std::vector<mesh_dicing> dicings_of(std::span<const l3d_mesh_patch> patches, mesh_colors colors) {
    std::vector<mesh_dicing> result(patches.size());
    std::ranges::transform(patches, result.begin(), [colors](const l3d_mesh_patch& patch) {
        return dicing_of(patch, colors);
    });
    agree_on_borders(patches, result);
    return result;
}

} // namespace l3d_detail
