// SPDX-License-Identifier: MIT
// l3d_bicubic_approximation, l3d_normal_approximation: interpolation between places of a piece, and
// its error in Bernstein form.
#include "geom/nurbs/bicubic_approximation.h"

#include "geom/nurbs/bernstein_products_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace {

using namespace l3d_detail;
using vector = l3d_vector<double, 3>;
using bicubic = l3d_bezier_patch<double, 3>;
using point = l3d_rational_piece::point;

constexpr double unit = 0x1p-53; // the relative rounding of a double

/// The rounding of a product's coefficients, relative to its factors. The coefficients are sums of
/// up to 16 by 16 products, made twice.
constexpr double sums_rounding = 0x1p10 * unit;

vector place_of(const point& p) {
    return {p[0], p[1], p[2]};
}

double largest(const vector& v) {
    return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

double size_of(double value) {
    return std::abs(value);
}
double size_of(const vector& v) {
    return l3d_length(v);
}

/// Upper bound of the length of a polynomial's values: its largest coefficient, by the convex hull.
template <class V> double bound_of(const net<V>& of) {
    double most = 0;
    for (const V& value : of.c)
        most = std::max(most, size_of(value));
    return most;
}

/// A closer upper bound than that of bound_of. The polynomial is halved `halvings` times, along u
/// and v in turns, and the coefficients of the parts are taken. Errors of interpolation change
/// their sign, so the coefficients of the whole polynomial are some four times too large.
double bound_of_parts(const net<vector>& of, int halvings) {
    if (halvings == 0)
        return bound_of(of);
    const auto [first, second] = of.halves(halvings % 2 == 0);
    return std::max(bound_of_parts(first, halvings - 1), bound_of_parts(second, halvings - 1));
}

/// The inner places, along u and along v, where a patch meets its piece: zeros of Chebyshev's T4,
/// stretched until the outer zeros are 0 and 1. No cubic with the same ends is closer to a quartic.
/// The error of this cubic is 0.17 of that of Hermite's cubic.
constexpr double nearer_node = 1 - std::numbers::sqrt2 / 2, farther_node = std::numbers::sqrt2 / 2;

/// The value at a node of a polynomial of this degree; point(i) is its control point i. The value
/// is the same bit for bit if control points and node are counted from the other end.
/// Source: de Casteljau.
template <class Point> point at_node(int degree, std::size_t node, const Point& control) {
    if (node == 0 || node == 3)
        return control(node == 0 ? 0 : degree);
    const double first = node == 1 ? farther_node : nearer_node;
    const double second = node == 1 ? nearer_node : farther_node;
    std::array<point, l3d_bpt_largest_degree + 1> p{};
    for (int i = 0; i <= degree; ++i)
        p[static_cast<std::size_t>(i)] = control(i);
    for (int level = degree; level > 0; --level)
        for (std::size_t i = 0; i < static_cast<std::size_t>(level); ++i)
            p[i] = p[i] * first + p[i + 1] * second;
    return p[0];
}

/// The second control point of the cubic that has these values at the nodes. If the values come in
/// reverse order, the result is the third control point. Expects: the values in the order of nodes.
vector second_point(const vector& at_0, const vector& at_a, const vector& at_b,
                    const vector& at_1) {
    constexpr double a = nearer_node, b = farther_node;
    constexpr double near = 3 * a * b * b, far = 3 * a * a * b; // B1 and B2 at a, B2 and B1 at b
    constexpr double of_a = near / (near * near - far * far);
    constexpr double of_b = far / (near * near - far * far);
    const vector end = at_1 - at_0;
    return at_0 + (at_a - at_0 - end * (a * a * a)) * of_a -
           (at_b - at_0 - end * (b * b * b)) * of_b;
}

bicubic interpolated(const l3d_rational_piece& piece) {
    bicubic result;
    for (std::size_t column = 0; column < 4; ++column) {
        std::array<point, l3d_bpt_largest_degree + 1> rows{};
        for (int r = 0; r <= piece.degree_v; ++r)
            rows[static_cast<std::size_t>(r)] = at_node(
                piece.degree_u, column, [&](int c) -> const point& { return piece.at(r, c); });
        for (std::size_t row = 0; row < 4; ++row) {
            const point p = at_node(piece.degree_v, row, [&](int r) -> const point& {
                return rows[static_cast<std::size_t>(r)];
            });
            result.points[4 * row + column] = place_of(p) / p[3];
        }
    }
    const auto through = [&](std::size_t first, std::size_t step) {
        vector* const p = result.points.data() + first;
        const std::array<vector, 4> values{p[0], p[step], p[2 * step], p[3 * step]};
        p[step] = second_point(values[0], values[1], values[2], values[3]);
        p[2 * step] = second_point(values[3], values[2], values[1], values[0]);
    };
    for (std::size_t line = 0; line < 4; ++line)
        through(4 * line, 1);
    for (std::size_t line = 0; line < 4; ++line)
        through(line, 4);
    return result;
}

/// Whether all weights of a piece are equal, so that it is a polynomial, and derivatives of W are
/// 0.
bool has_one_weight(const l3d_rational_piece& piece) {
    return std::ranges::all_of(piece.points,
                               [&](const point& p) { return p[3] == piece.points[0][3]; });
}

/// A rational piece as P / W, where P is relative to `centre`. `noise` bounds the rounding of P's
/// length, and `weight_noise` that of W.
struct centred_piece {
    net<vector> p;
    net<double> w;
    double noise = 0, weight_noise = 0;
    bool has_one_weight;

    centred_piece(const l3d_rational_piece& piece, const vector& centre)
        : p(piece.degree_u, piece.degree_v), w(piece.degree_u, piece.degree_v),
          has_one_weight(::has_one_weight(piece)) {
        double size = 0, most_w = 0;
        for (const point& q : piece.points)
            most_w = std::max(most_w, q[3]);
        // Products of three small weights would underflow.
        const double scale = std::exp2(-std::ilogb(most_w));
        for (std::size_t i = 0; i < piece.points.size(); ++i) {
            const point q = piece.points[i] * scale;
            w.c[i] = q[3];
            p.c[i] = place_of(q) - centre * q[3];
            size = std::max(size, largest(place_of(q)));
        }
        const double away = largest(centre);
        weight_noise = piece.weight_noise * scale;
        noise = std::numbers::sqrt3 * (piece.noise * scale + away * weight_noise +
                                       4 * unit * (size + away * bound_of(w)));
    }
};

/// A piece, turned so that v = 0 is the edge that is collapsed to a point, if there is one.
struct turned {
    l3d_rational_piece piece;
    bool has_pole = false;
    int turns = 0;

    explicit turned(const l3d_rational_piece& of) : piece(of) {
        for (; turns < 4 && !(has_pole = begins_in_a_point()); ++turns)
            turn_right();
    }

    vector corner() const { return place_of(piece.at(0, 0)) / piece.at(0, 0)[3]; }

    /// Whether all control points of the row v = 0 coincide, up to rounding.
    bool begins_in_a_point() const {
        double size = 0, away = 0;
        for (const point& p : piece.points)
            size = std::max(size, largest(place_of(p) / p[3]));
        for (int k = 1; k <= piece.degree_u; ++k)
            away = std::max(away, largest(place_of(piece.at(0, k)) / piece.at(0, k)[3] - corner()));
        return away <= 16 * unit * size;
    }

    /// Turns the piece by a quarter: (u, v) becomes (v, 1 - u). Normals keep lengths and
    /// directions.
    void turn_right() {
        const l3d_rational_piece old = piece;
        std::swap(piece.degree_u, piece.degree_v);
        for (int r = 0; r <= piece.degree_v; ++r)
            for (int c = 0; c <= piece.degree_u; ++c)
                piece.points[static_cast<std::size_t>(r * (piece.degree_u + 1) + c)] =
                    old.at(c, old.degree_u - r);
    }

    /// Turns a polynomial of normals by `times` quarter turns.
    static l3d_normal_polynomial right(l3d_normal_polynomial normals, int times) {
        constexpr std::size_t order = l3d_normal_polynomial::order;
        for (int i = 0; i < times; ++i) {
            const l3d_normal_polynomial old = normals;
            for (std::size_t r = 0; r < order; ++r)
                for (std::size_t c = 0; c < order; ++c)
                    normals.points[order * r + c] = old.points[order * c + order - 1 - r];
        }
        return normals;
    }
};

/// Values of a polynomial at Order by Order nodes, or as many control points; u fastest.
template <class V, std::size_t Order> using square = std::array<V, Order * Order>;

/// Interpolation by polynomials at nodes from 0 to 1.
template <std::size_t Order> struct interpolation {
    std::array<double, Order> nodes;
    std::array<std::array<double, Order>, Order> control_by_value{};

    using basis = std::array<double, most_product + 1>;

    /// The values at t of the Bernstein polynomials of degree n. Source: their recurrence.
    static constexpr basis basis_at(double t, int n) {
        basis result{1};
        for (int degree = 1; degree <= n; ++degree)
            for (auto k = static_cast<std::size_t>(degree);; --k) {
                result[k] = result[k] * (1 - t) + (k > 0 ? result[k - 1] * t : 0);
                if (k == 0)
                    break;
            }
        return result;
    }

    /// Inverts the matrix of Bernstein's basis at the nodes. Source: Gauss and Jordan; the largest
    /// entries are on the diagonal, so no pivots are sought.
    constexpr explicit interpolation(const std::array<double, Order>& at) : nodes(at) {
        auto left = control_by_value;
        auto& right = control_by_value;
        for (std::size_t i = 0; i < Order; ++i) {
            std::copy_n(basis_at(nodes[i], Order - 1).begin(), Order, left[i].begin());
            right[i][i] = 1;
        }
        for (std::size_t pivot = 0; pivot < Order; ++pivot) {
            const double by = 1 / left[pivot][pivot];
            for (std::size_t k = 0; k < Order; ++k) {
                left[pivot][k] *= by;
                right[pivot][k] *= by;
            }
            for (std::size_t i = 0; i < Order; ++i) {
                const double factor = i == pivot ? 0 : left[i][pivot];
                for (std::size_t k = 0; k < Order; ++k) {
                    left[i][k] -= factor * left[pivot][k];
                    right[i][k] -= factor * right[pivot][k];
                }
            }
        }
    }

    /// The values of a polynomial at all pairs of nodes.
    template <class V> square<V, Order> values_of(const net<V>& of) const {
        std::array<basis, Order> in_v;
        for (std::size_t row = 0; row < Order; ++row)
            in_v[row] = basis_at(nodes[row], of.n);
        square<V, Order> result{};
        for (std::size_t column = 0; column < Order; ++column) {
            const basis in_u = basis_at(nodes[column], of.m);
            for (int r = 0; r <= of.n; ++r) {
                V in_row(0.0);
                for (int k = 0; k <= of.m; ++k)
                    in_row += of.at(r, k) * in_u[static_cast<std::size_t>(k)];
                for (std::size_t row = 0; row < Order; ++row)
                    result[Order * row + column] += in_row * in_v[row][static_cast<std::size_t>(r)];
            }
        }
        return result;
    }

    /// The control points of the polynomial with these values at the nodes.
    template <class V> square<V, Order> through(const square<V, Order>& values) const {
        square<V, Order> along_u{}, result{};
        for (std::size_t i = 0; i < Order; ++i)
            for (std::size_t k = 0; k < Order; ++k)
                for (std::size_t j = 0; j < Order; ++j)
                    along_u[Order * i + k] += values[Order * i + j] * control_by_value[k][j];
        for (std::size_t i = 0; i < Order; ++i)
            for (std::size_t k = 0; k < Order; ++k)
                for (std::size_t j = 0; j < Order; ++j)
                    result[Order * k + i] += along_u[Order * j + i] * control_by_value[k][j];
        return result;
    }
};

/// The places where normals are exact: the zeros of T6, stretched as those of T4 for `nearer_node`.
constexpr std::size_t quintic_order = l3d_normal_polynomial::order;
constexpr double outer_node = 1 - std::numbers::sqrt3 / 2;
constexpr double inner_node = (std::numbers::sqrt3 - 1) / 2;
constexpr interpolation<quintic_order> quintic({0, outer_node, inner_node, 1 - inner_node,
                                                1 - outer_node, 1});

/// The highest degree of a piece whose normals are computed exactly, which takes some m^4
/// operations for degree m. A piece of degree 7 replaces one of degree 8 or more. The two meet at
/// places (1 - cos(k pi / 7)) / 2 along u and v. Their difference counts as rounding.
constexpr int most_exact_degree = 7;
constexpr interpolation<most_exact_degree + 1> septic({0, 0.0495155660487904, 0.188255099070633,
                                                       0.388739533021843, 0.611260466978157,
                                                       0.811744900929367, 0.9504844339512096, 1});

l3d_rational_piece reduced(l3d_rational_piece piece) {
    const int m = std::max(piece.degree_u, most_exact_degree);
    const int n = std::max(piece.degree_v, most_exact_degree);
    if (m == most_exact_degree && n == most_exact_degree)
        return piece;
    // Both pieces, raised to degrees m by n.
    const auto raised = [m, n](const net<point>& of, int coordinate) {
        scaled_net result(m, n);
        result.add(one(m - of.m, n - of.n),
                   scaled_net(of, [=](const point& p) { return p[coordinate]; }));
        return result;
    };
    net<point> whole(piece.degree_u, piece.degree_v), low(most_exact_degree, most_exact_degree);
    whole.c = piece.points;
    std::ranges::copy(septic.through(septic.values_of(whole)), low.c.begin());
    if (has_one_weight(piece))
        for (point& p : low.c)
            p[3] = piece.points[0][3];
    piece.degree_u = piece.degree_v = most_exact_degree;
    piece.points = low.c;
    std::array<double, 4> most{};
    for (int k = 0; k < 4; ++k) {
        const scaled_net exact = raised(whole, k), drawn = raised(low, k);
        double size = 0, off = 0;
        for (int r = 0; r <= n; ++r)
            for (int c = 0; c <= m; ++c) {
                size = std::max(size, std::abs(exact.at(r, c)));
                off = std::max(off, std::abs(exact.at(r, c) - drawn.at(r, c)));
            }
        most[static_cast<std::size_t>(k)] = off + sums_rounding * size;
    }
    piece.noise += std::max({most[0], most[1], most[2]});
    piece.weight_noise += most[3];
    return piece;
}

/// The polynomial W^3 S_u x S_v, which has the direction of the piece's normals wherever the
/// normals are not 0. If the edge v = 0 is a point, the polynomial has a factor v, which is divided
/// out.
struct exact_normals {
    net<vector> of{0, 0};
    double noise = 0; ///< bound of the coefficients' rounding

    /// `m` and `n` are the degrees for which the piece's noise holds.
    exact_normals(const centred_piece& piece, int m, int n, bool has_pole) {
        const net<vector> pu = piece.p.by_u(), pv = piece.p.by_v();
        const net<double> wu = piece.w.by_u(), wv = piece.w.by_v();
        const scaled_vectors p = scaled(piece.p), by_u = scaled(pu), by_v = scaled(pv);
        scaled_vectors sum = zeros(3 * piece.p.m - 1, 3 * piece.p.n - 1);
        add(sum, scaled(piece.w), cross(by_u, by_v));
        if (!piece.has_one_weight) {
            add(sum, scaled(wv), cross(by_u, p), -1);
            add(sum, scaled(wu), cross(p, by_v), -1);
        }
        of = net_of(sum);
        // A factor of a product of three, with a bound of its rounding.
        struct factor {
            double size, noise;
        };
        const auto product_noise = [](const factor& a, const factor& b, const factor& c) {
            return (a.size + a.noise) * (b.size + b.noise) * (c.size + c.noise) *
                       (1 + sums_rounding) -
                   a.size * b.size * c.size;
        };
        const factor s{bound_of(piece.p), piece.noise}, w{bound_of(piece.w), piece.weight_noise};
        m = std::max(m, piece.p.m);
        n = std::max(n, piece.p.n);
        const factor du{bound_of(pu), 2 * m * s.noise}, dv{bound_of(pv), 2 * n * s.noise};
        const factor dwu{bound_of(wu), 2 * m * w.noise}, dwv{bound_of(wv), 2 * n * w.noise};
        noise = product_noise(w, du, dv) + product_noise(dwv, du, s) + product_noise(dwu, s, dv);
        if (!has_pole)
            return;
        noise *= 2 * 3 * n; // the row v = 0 is noise, too
        of = of.over_v();
    }
};

} // namespace

l3d_rational_piece::l3d_rational_piece(const l3d_patch_points& patch)
    : degree_u(patch.degree_u), degree_v(patch.degree_v) {
    points.reserve(patch.points.size());
    for (std::size_t i = 0; i < patch.points.size(); ++i) {
        const double w = patch.weights.empty() ? 1 : patch.weights[i];
        const auto& p = patch.points[i];
        points.push_back({p[0] * w, p[1] * w, p[2] * w, w});
        if (w != 1)
            noise = std::max(noise, unit * largest(place_of(points.back())));
    }
}

std::pair<l3d_rational_piece, l3d_rational_piece> l3d_rational_piece::halves(bool along_u) const {
    std::pair<l3d_rational_piece, l3d_rational_piece> result{*this, *this};
    const int n = along_u ? degree_u : degree_v, lines = along_u ? degree_v : degree_u;
    const auto index = [&](int line, int i) {
        return static_cast<std::size_t>(along_u ? line * (degree_u + 1) + i
                                                : i * (degree_u + 1) + line);
    };
    double size = 0, weight = 0;
    for (const point& p : points) {
        size = std::max(size, largest(place_of(p)));
        weight = std::max(weight, p[3]);
    }
    for (int line = 0; line <= lines; ++line) {
        std::array<point, l3d_bpt_largest_degree + 1> p{};
        for (int i = 0; i <= n; ++i)
            p[static_cast<std::size_t>(i)] = points[index(line, i)];
        for (int level = 0; level <= n; ++level) {
            const auto last = static_cast<std::size_t>(n - level);
            result.first.points[index(line, level)] = p[0];
            result.second.points[index(line, n - level)] = p[last];
            for (std::size_t i = 0; i < last; ++i)
                p[i] = l3d_midpoint_of<double, 4>(p[i], p[i + 1]);
        }
    }
    for (l3d_rational_piece* half : {&result.first, &result.second}) {
        half->noise = noise + n * unit * size;
        half->weight_noise = weight_noise + n * unit * weight;
    }
    return result;
}

l3d_bicubic_approximation::l3d_bicubic_approximation(const l3d_rational_piece& piece)
    : patch(interpolated(piece)), error(std::numeric_limits<double>::infinity()) {
    const vector centre = patch.points[0];
    const centred_piece of(piece, centre);
    const double least_w = std::ranges::min(of.w.c) - of.weight_noise;
    if (!(least_w > 0))
        return;
    net<vector> b(3, 3);
    for (std::size_t i = 0; i < b.c.size(); ++i)
        b.c[i] = patch.points[i] - centre;
    scaled_vectors d = zeros(of.w.m + 3, of.w.n + 3);
    add(d, one(3, 3), scaled(of.p));
    add(d, scaled(of.w), scaled(b), -1);
    const double size_b = bound_of(b);
    const double rounding = 128 * unit * (bound_of(of.p) + bound_of(of.w) * size_b);
    constexpr int halvings = 4; // 16 parts
    error = (bound_of_parts(net_of(d), halvings) + of.noise + size_b * of.weight_noise + rounding) /
            least_w;
}

/// Compares the quintic N with the exact polynomial T of the normals. The tangent of the angle
/// between N and T is |N x T| / N.T.
l3d_normal_approximation::l3d_normal_approximation(const l3d_rational_piece& piece)
    : error(std::numeric_limits<double>::infinity()) {
    const turned of(piece);
    const centred_piece centred(reduced(of.piece), of.corner());
    const exact_normals exact(centred, of.piece.degree_u, of.piece.degree_v, of.has_pole);
    if (!(bound_of(exact.of) > exact.noise))
        return;
    auto values = quintic.values_of(exact.of);
    const auto weights = quintic.values_of(centred.w);
    constexpr double least_weight = 0x1p-100; // whose third power fits a double
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double w = std::max(weights[i], least_weight);
        values[i] /= w * w * w;
    }
    net =
        l3d_normal_net(turned::right(l3d_normal_polynomial{quintic.through(values)}, 4 - of.turns));
    ::net<vector> drawn(quintic_order - 1, quintic_order - 1);
    std::ranges::copy(turned::right(net.polynomial(), of.turns).points, drawn.c.begin());
    const scaled_vectors n = scaled(drawn), t = scaled(exact.of);
    scaled_net dot(drawn.m + exact.of.m, drawn.n + exact.of.n);
    for (std::size_t k = 0; k < 3; ++k)
        dot.add(n[k], t[k]);
    const double along = dot.least();
    const double off = bound_of(drawn) * (exact.noise + sums_rounding * bound_of(exact.of));
    if (!(along > off))
        return;
    const double across = bound_of(net_of(cross(n, t)));
    error = 2 * std::sin(std::atan((across + off) / (along - off)) / 2) * (1 + 8 * unit);
}
