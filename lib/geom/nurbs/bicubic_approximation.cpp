// SPDX-License-Identifier: MIT
// l3d_bicubic_approximation, l3d_normal_approximation: interpolation between places of a piece, and
// its error in Bernstein form.
#include "geom/nurbs/bicubic_approximation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace {

using vector = l3d_vector<double, 3>;
using bicubic = l3d_bezier_patch<double, 3>;
using point = l3d_rational_piece::point;

constexpr double unit = 0x1p-53; // the relative rounding of a double

/// The rounding of coefficients of products, by the sizes of their factors: sums of up to 16 by 16
/// products, made twice.
constexpr double sums_rounding = 0x1p10 * unit;

vector place_of(const point& p) {
    return {p[0], p[1], p[2]};
}

double largest(const vector& v) {
    return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

/// Bernstein coefficients of a polynomial of degree m along u and n along v.
template <class V> struct net {
    int m, n;
    std::vector<V> c; // u runs fastest

    net(int of_m, int of_n)
        : m(of_m), n(of_n), c(static_cast<std::size_t>((of_m + 1) * (of_n + 1)), V(0.0)) {}
    V& at(int row, int column) { return c[static_cast<std::size_t>(row * (m + 1) + column)]; }
    const V& at(int row, int column) const {
        return c[static_cast<std::size_t>(row * (m + 1) + column)];
    }

    net by_u() const {
        net result(m - 1, n);
        for (int r = 0; r <= n; ++r)
            for (int k = 0; k < m; ++k)
                result.at(r, k) = (at(r, k + 1) - at(r, k)) * double(m);
        return result;
    }
    net by_v() const {
        net result(m, n - 1);
        for (int r = 0; r < n; ++r)
            for (int k = 0; k <= m; ++k)
                result.at(r, k) = (at(r + 1, k) - at(r, k)) * double(n);
        return result;
    }
    /// The same polynomial over both halves of u or of v. Source: de Casteljau.
    std::array<net, 2> halves(bool along_u) const {
        std::array<net, 2> result{*this, *this};
        const int degree = along_u ? m : n, lines = along_u ? n : m;
        for (int line = 0; line <= lines; ++line) {
            const auto in = [&](net& half, int i) -> V& {
                return along_u ? half.at(line, i) : half.at(i, line);
            };
            for (int level = 0; level <= degree; ++level) {
                in(result[0], level) = in(result[1], 0);
                for (int i = 0; i < degree - level; ++i)
                    in(result[1], i) = (in(result[1], i) + in(result[1], i + 1)) * 0.5;
            }
        }
        return result;
    }
    /// The quotient by v of a polynomial that is 0 at v = 0: v B^(n-1)_j = (j + 1) / n B^n_(j+1).
    net over_v() const {
        net result(m, n - 1);
        for (int r = 0; r < n; ++r)
            for (int k = 0; k <= m; ++k)
                result.at(r, k) = at(r + 1, k) * (double(n) / (r + 1));
        return result;
    }
};

double size_of(double value) {
    return std::abs(value);
}
double size_of(const vector& v) {
    return l3d_length(v);
}

/// Upper bound of the polynomial's size: its largest coefficient, by the convex hull.
template <class V> double bound_of(const net<V>& of) {
    double most = 0;
    for (const V& value : of.c)
        most = std::max(most, size_of(value));
    return most;
}

/// The same by the coefficients of parts, after some halvings in turns. Errors of interpolation
/// change signs: over the whole, their coefficients are some four times as large as they are.
double bound_of_parts(const net<vector>& of, int halvings) {
    if (halvings == 0)
        return bound_of(of);
    const auto [first, second] = of.halves(halvings % 2 == 0);
    return std::max(bound_of_parts(first, halvings - 1), bound_of_parts(second, halvings - 1));
}

/// The largest degree of a product: that of a piece's normals, of at most three times its degree,
/// and the quintic that approximates them.
constexpr int most_product = 3 * l3d_bpt_largest_degree + l3d_normal_polynomial::order;
/// Binomial coefficients n over k, which are exact in a double.
constexpr auto binomials = [] {
    std::array<std::array<double, most_product + 1>, most_product + 1> result{};
    for (std::size_t n = 0; n <= most_product; ++n)
        for (std::size_t k = 0; k <= n; ++k)
            result[n][k] = k == 0 ? 1 : result[n - 1][k - 1] + result[n - 1][k];
    return result;
}();

double binomial(int n, int k) {
    return binomials[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}

/// Weights of the products a_i b_j in Bernstein coefficient i + j of a product of degrees m and n,
/// j fastest. The weights of one coefficient add up to 1.
std::vector<double> product_weights(int m, int n) {
    std::vector<double> result;
    result.reserve(static_cast<std::size_t>((m + 1) * (n + 1)));
    for (int i = 0; i <= m; ++i)
        for (int j = 0; j <= n; ++j)
            result.push_back(binomial(m, i) * binomial(n, j) / binomial(m + n, i + j));
    return result;
}

/// The Bernstein net of a product of two polynomials; `times` multiplies two coefficients.
template <class V, class A, class B, class Times>
net<V> product(const net<A>& a, const net<B>& b, const Times& times) {
    const std::vector<double> in_u = product_weights(a.m, b.m), in_v = product_weights(a.n, b.n);
    net<V> result(a.m + b.m, a.n + b.n);
    for (int ra = 0; ra <= a.n; ++ra)
        for (int rb = 0; rb <= b.n; ++rb) {
            const double of_row = in_v[static_cast<std::size_t>(ra * (b.n + 1) + rb)];
            for (int ca = 0; ca <= a.m; ++ca)
                for (int cb = 0; cb <= b.m; ++cb)
                    result.at(ra + rb, ca + cb) +=
                        times(a.at(ra, ca), b.at(rb, cb)) *
                        (of_row * in_u[static_cast<std::size_t>(ca * (b.m + 1) + cb)]);
        }
    return result;
}

vector cross(const vector& a, const vector& b) {
    return l3d_cross(a, b);
}

/// The places, in both directions of a patch, that it shares with its piece, beside the ends: zeros
/// of Chebyshev's polynomial T4, stretched until the outer ones are 0 and 1. No cubic with the same
/// ends is closer to a quartic. It is off by 0.17 of what Hermite's cubic is.
constexpr double nearer_node = 1 - std::numbers::sqrt2 / 2, farther_node = std::numbers::sqrt2 / 2;

/// The value at a node of a polynomial of this degree; point(i) is its control point i.
/// The same bit for bit if the control points and the node are counted from the other end.
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

/// The second control point of the cubic through values at the nodes. From the other end it is the
/// third one. Expects: the values in the order of nodes.
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

/// A piece as P and W around a place of it, with bounds of their rounding: `noise` of P's length.
struct centred_piece {
    net<vector> p;
    net<double> w;
    double noise = 0, weight_noise = 0;

    centred_piece(const l3d_rational_piece& piece, const vector& centre)
        : p(piece.degree_u, piece.degree_v), w(piece.degree_u, piece.degree_v) {
        double size = 0, most_w = 0;
        for (const point& q : piece.points)
            most_w = std::max(most_w, q[3]);
        // Products of three small weights would be too small for a double.
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

/// A piece, turned so that v = 0 is an edge collapsed to a point, if there is one.
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

    /// (u, v) becomes (v, 1 - u): a quarter turn, in which normals keep lengths and directions.
    void turn_right() {
        const l3d_rational_piece old = piece;
        std::swap(piece.degree_u, piece.degree_v);
        for (int r = 0; r <= piece.degree_v; ++r)
            for (int c = 0; c <= piece.degree_u; ++c)
                piece.points[static_cast<std::size_t>(r * (piece.degree_u + 1) + c)] =
                    old.at(c, old.degree_u - r);
    }

    /// Normals, turned as often.
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

/// Values of a polynomial at Order by Order nodes, u fastest, or the control points of one.
template <class V, std::size_t Order> using square = std::array<V, Order * Order>;

/// Interpolation by polynomials at nodes from 0 to 1.
template <std::size_t Order> struct interpolation {
    std::array<double, Order> nodes;
    std::array<std::array<double, Order>, Order> control_by_value{};

    /// Inverts the matrix of Bernstein's basis at the nodes. Source: Gauss and Jordan; the diagonal
    /// is largest.
    constexpr explicit interpolation(const std::array<double, Order>& at) : nodes(at) {
        auto left = control_by_value;
        auto& right = control_by_value;
        for (std::size_t i = 0; i < Order; ++i) {
            for (std::size_t k = 0; k < Order; ++k) {
                left[i][k] = binomials[Order - 1][k];
                for (std::size_t n = 0; n + 1 < Order; ++n)
                    left[i][k] *= n < k ? nodes[i] : 1 - nodes[i];
            }
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

    /// Source: de Casteljau.
    template <class V> square<V, Order> values_of(const net<V>& of) const {
        const auto collapsed = [](std::vector<V> p, double t) {
            for (std::size_t left = p.size() - 1; left > 0; --left)
                for (std::size_t i = 0; i < left; ++i)
                    p[i] = p[i] * (1 - t) + p[i + 1] * t;
            return p[0];
        };
        square<V, Order> result{};
        for (std::size_t column = 0; column < Order; ++column) {
            std::vector<V> rows;
            for (auto row = of.c.begin(); row != of.c.end(); row += of.m + 1)
                rows.push_back(collapsed(std::vector<V>(row, row + of.m + 1), nodes[column]));
            for (std::size_t row = 0; row < Order; ++row)
                result[Order * row + column] = collapsed(rows, nodes[row]);
        }
        return result;
    }

    /// The control points of the polynomial with these values.
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

/// The places that normals are taken from: the zeros of T6, stretched as those of T4 above.
constexpr std::size_t quintic_order = l3d_normal_polynomial::order;
constexpr double outer_node = 1 - std::numbers::sqrt3 / 2;
constexpr double inner_node = (std::numbers::sqrt3 - 1) / 2;
constexpr interpolation<quintic_order> quintic({0, outer_node, inner_node, 1 - inner_node,
                                                1 - outer_node, 1});

/// Normals of a piece of degree m take some m^4 operations. From degree 8 on they are those of a
/// piece of degree 7, through places (1 - cos(k pi / 7)) / 2. Their difference counts as rounding.
constexpr int most_exact_degree = 7;
constexpr interpolation<most_exact_degree + 1> septic({0, 0.0495155660487904, 0.188255099070633,
                                                       0.388739533021843, 0.611260466978157,
                                                       0.811744900929367, 0.9504844339512096, 1});

l3d_rational_piece reduced(l3d_rational_piece piece) {
    const int m = std::max(piece.degree_u, most_exact_degree);
    const int n = std::max(piece.degree_v, most_exact_degree);
    if (m == most_exact_degree && n == most_exact_degree)
        return piece;
    // Both as polynomials of degree m by n.
    const auto raised = [m, n](const net<point>& of) {
        net<double> one(m - of.m, n - of.n);
        std::ranges::fill(one.c, 1.0);
        return product<point>(of, one, [](const point& p, double by) { return p * by; });
    };
    net<point> whole(piece.degree_u, piece.degree_v), low(most_exact_degree, most_exact_degree);
    whole.c = piece.points;
    std::ranges::copy(septic.through(septic.values_of(whole)), low.c.begin());
    const net<point> exact = raised(whole), drawn = raised(low);
    double size = 0, weight = 0, off = 0, weight_off = 0;
    for (std::size_t i = 0; i < exact.c.size(); ++i) {
        const point d = exact.c[i] - drawn.c[i];
        size = std::max(size, largest(place_of(exact.c[i])));
        weight = std::max(weight, exact.c[i][3]);
        off = std::max(off, largest(place_of(d)));
        weight_off = std::max(weight_off, std::abs(d[3]));
    }
    piece.degree_u = piece.degree_v = most_exact_degree;
    piece.points = low.c;
    piece.noise += off + sums_rounding * size;
    piece.weight_noise += weight_off + sums_rounding * weight;
    return piece;
}

/// A polynomial in the direction of the piece's normals, where these are not 0: W^3 S_u x S_v.
/// An edge v = 0 that is a point leaves a factor v, by which it is divided.
struct exact_normals {
    net<vector> of{0, 0};
    double noise = 0; ///< bound of the rounding of coefficients

    /// `m` and `n` are the degrees of what the piece's noise is part of.
    exact_normals(const centred_piece& piece, int m, int n, bool has_pole) {
        const net<vector> pu = piece.p.by_u(), pv = piece.p.by_v();
        const net<double> wu = piece.w.by_u(), wv = piece.w.by_v();
        const auto times = [](double a, const vector& b) { return b * a; };
        of = product<vector>(piece.w, product<vector>(pu, pv, cross), times);
        const net<vector> by_wv = product<vector>(wv, product<vector>(pu, piece.p, cross), times);
        const net<vector> by_wu = product<vector>(wu, product<vector>(piece.p, pv, cross), times);
        for (std::size_t i = 0; i < of.c.size(); ++i)
            of.c[i] = of.c[i] - by_wv.c[i] - by_wu.c[i];
        // Three factors, each with its own rounding.
        struct factor {
            double size, noise;
        };
        const auto product_noise = [](const factor& a, const factor& b, const factor& c) {
            return (a.size + a.noise) * (b.size + b.noise) * (c.size + c.noise) *
                       (1 + sums_rounding) -
                   a.size * b.size * c.size;
        };
        const factor p{bound_of(piece.p), piece.noise}, w{bound_of(piece.w), piece.weight_noise};
        m = std::max(m, piece.p.m);
        n = std::max(n, piece.p.n);
        const factor du{bound_of(pu), 2 * m * p.noise}, dv{bound_of(pv), 2 * n * p.noise};
        const factor dwu{bound_of(wu), 2 * m * w.noise}, dwv{bound_of(wv), 2 * n * w.noise};
        noise = product_noise(w, du, dv) + product_noise(dwv, du, p) + product_noise(dwu, p, dv);
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
    net<point> p(of.w.m, of.w.n);
    for (std::size_t i = 0; i < p.c.size(); ++i)
        p.c[i] = point(of.p.c[i], of.w.c[i]);
    net<vector> b(3, 3);
    for (std::size_t i = 0; i < b.c.size(); ++i)
        b.c[i] = patch.points[i] - centre;
    const net<vector> d = product<vector>(
        p, b, [](const point& q, const vector& by) { return place_of(q) - by * q[3]; });
    const double size_b = bound_of(b);
    const double rounding = 128 * unit * (bound_of(of.p) + bound_of(of.w) * size_b);
    constexpr int halvings = 4; // 16 parts
    error =
        (bound_of_parts(d, halvings) + of.noise + size_b * of.weight_noise + rounding) / least_w;
}

/// N is the quintic and T the exact polynomial. The tangent of their angle is |N x T| / N.T.
l3d_normal_approximation::l3d_normal_approximation(const l3d_rational_piece& piece)
    : error(std::numeric_limits<double>::infinity()) {
    const turned of(piece);
    const centred_piece centred(reduced(of.piece), of.corner());
    const exact_normals exact(centred, of.piece.degree_u, of.piece.degree_v, of.has_pole);
    if (!(bound_of(exact.of) > exact.noise))
        return;
    auto values = quintic.values_of(exact.of);
    const auto weights = quintic.values_of(centred.w);
    constexpr double least_weight = 0x1p-100; // whose third power a double still has
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double w = std::max(weights[i], least_weight);
        values[i] /= w * w * w;
    }
    net =
        l3d_normal_net(turned::right(l3d_normal_polynomial{quintic.through(values)}, 4 - of.turns));
    ::net<vector> drawn(quintic_order - 1, quintic_order - 1);
    std::ranges::copy(turned::right(net.polynomial(), of.turns).points, drawn.c.begin());
    const ::net<point> products =
        product<point>(drawn, exact.of, [](const vector& n, const vector& t) {
            return point(l3d_cross(n, t), l3d_dot(n, t));
        });
    double across = 0, along = std::numeric_limits<double>::infinity();
    for (const point& p : products.c) {
        across = std::max(across, l3d_length(place_of(p)));
        along = std::min(along, p[3]);
    }
    const double off = bound_of(drawn) * (exact.noise + sums_rounding * bound_of(exact.of));
    if (along > off)
        error = 2 * std::sin(std::atan((across + off) / (along - off)) / 2) * (1 + 8 * unit);
}
