// SPDX-License-Identifier: MIT
// l3d_bicubic_approximation: Hermite interpolation at corners, and its error in Bernstein form.
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

/// Binomial coefficients n over k, for products of pieces and cubics: exact in a double.
constexpr int most_degree = 15, most_product = most_degree + 3;
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
struct product_weights {
    std::array<double, (most_degree + 1) * 4> of{}; ///< one of the degrees is 3 at most

    product_weights(int m, int n) {
        std::size_t next = 0;
        for (int i = 0; i <= m; ++i)
            for (int j = 0; j <= n; ++j)
                of[next++] = binomial(m, i) * binomial(n, j) / binomial(m + n, i + j);
    }
};

net<double> along_axis(const net<vector>& of, const vector& axis) {
    net<double> result(of.m, of.n);
    std::ranges::transform(of.c, result.c.begin(),
                           [&](const vector& value) { return l3d_dot(value, axis); });
    return result;
}

/// The Bernstein net of a product of two polynomials; `times` multiplies two coefficients.
template <class V, class A, class B, class Times>
net<V> product(const net<A>& a, const net<B>& b, const Times& times) {
    const product_weights in_u(a.m, b.m), in_v(a.n, b.n);
    net<V> result(a.m + b.m, a.n + b.n);
    for (int ra = 0; ra <= a.n; ++ra)
        for (int rb = 0; rb <= b.n; ++rb) {
            const double of_row = in_v.of[static_cast<std::size_t>(ra * (b.n + 1) + rb)];
            for (int ca = 0; ca <= a.m; ++ca)
                for (int cb = 0; cb <= b.m; ++cb)
                    result.at(ra + rb, ca + cb) +=
                        times(a.at(ra, ca), b.at(rb, cb)) *
                        (of_row * in_u.of[static_cast<std::size_t>(ca * (b.m + 1) + cb)]);
        }
    return result;
}

/// A piece's control net, with rows and columns counted from one of its four corners.
struct corner_view {
    const l3d_rational_piece& piece;
    bool from_right, from_top;
    const point& at(int row, int column) const {
        return piece.at(from_top ? piece.degree_v - row : row,
                        from_right ? piece.degree_u - column : column);
    }
};

/// Sets the four control points at a corner S. With d = P - S w, the derivatives there are
/// S_u = m d_10 / w, S_v = n d_01 / w,
/// and S_uv = (m n (d_11 - d_10 - d_01) - w_u S_v - w_v S_u) / w.
/// A derivative along a boundary depends on the boundary's points alone.
///
/// A neighbour of a far larger weight would move control points far away, so it counts as at most
/// four times as heavy as the corner. Small enough cells have no such neighbour.
void fill_corner(const corner_view& of, bicubic& patch) {
    const double m = of.piece.degree_u, n = of.piece.degree_v;
    const point& p = of.at(0, 0);
    const double w = p[3];
    const vector s = place_of(p) / w;
    const auto weight = [w](const point& q) { return std::min(q[3], 4 * w); };
    const auto beside = [&](const point& q) {
        return (place_of(q) - s * q[3]) * (weight(q) / q[3]);
    };
    const point &pu = of.at(0, 1), &pv = of.at(1, 0), &puv = of.at(1, 1);
    const vector du = beside(pu), dv = beside(pv);
    const vector su = du * (m / w), sv = dv * (n / w);
    const vector suv = ((beside(puv) - du - dv) * (m * n) - sv * (m * (weight(pu) - w)) -
                        su * (n * (weight(pv) - w))) /
                       w;
    const int row = of.from_top ? 3 : 0, column = of.from_right ? 3 : 0;
    const int in_row = of.from_top ? 2 : 1, in_column = of.from_right ? 2 : 1;
    patch.at(row, column) = s;
    patch.at(row, in_column) = s + du * (m / (3 * w));
    patch.at(in_row, column) = s + dv * (n / (3 * w));
    patch.at(in_row, in_column) = s + su / 3.0 + sv / 3.0 + suv / 9.0;
}

/// A piece and its patch, turned so that v = 0 is an edge collapsed to a point, if there is one.
struct turned {
    l3d_rational_piece piece;
    bicubic patch;
    bool has_pole = false;

    turned(const l3d_rational_piece& of, const bicubic& by) : piece(of), patch(by) {
        for (int turn = 0; turn < 4; ++turn) {
            if (begins_in_a_point()) {
                has_pole = true;
                return;
            }
            turn_right();
        }
    }

    /// Whether all control points of the row v = 0 coincide, up to rounding.
    bool begins_in_a_point() const {
        double size = 0, away = 0;
        for (const vector& p : patch.points)
            size = std::max(size, largest(p));
        const vector first = place_of(piece.at(0, 0)) / piece.at(0, 0)[3];
        for (int k = 1; k <= piece.degree_u; ++k)
            away = std::max(away, largest(place_of(piece.at(0, k)) / piece.at(0, k)[3] - first));
        return away <= 16 * unit * size;
    }

    /// (u, v) becomes (v, 1 - u): a quarter turn, in which normals keep lengths and directions.
    void turn_right() {
        const l3d_rational_piece old = piece;
        const bicubic old_patch = patch;
        std::swap(piece.degree_u, piece.degree_v);
        for (int r = 0; r <= piece.degree_v; ++r)
            for (int c = 0; c <= piece.degree_u; ++c)
                piece.points[static_cast<std::size_t>(r * (piece.degree_u + 1) + c)] =
                    old.at(c, old.degree_u - r);
        for (int r = 0; r < 4; ++r)
            for (int c = 0; c < 4; ++c)
                patch.at(r, c) = old_patch.at(c, 3 - r);
    }
};

/// The bounds of docs/NUMERICS.md, section 25.
struct bounds {
    explicit bounds(const turned& of);

    double error = 0, normal_error = std::numeric_limits<double>::infinity();

private:
    void find_normal_error(const turned& of, const net<double>& w, const net<vector>& b,
                           const net<vector>& d);

    double noise_ = 0, least_w_ = 0, weight_noise_ = 0, size_b_ = 0;
};

bounds::bounds(const turned& of) {
    const l3d_rational_piece& piece = of.piece;
    const vector centre = of.patch.points[0];
    net<double> w(piece.degree_u, piece.degree_v);
    net<point> p(piece.degree_u, piece.degree_v);
    net<vector> b(3, 3);
    double size_p = 0, size_q = 0;
    least_w_ = std::numeric_limits<double>::infinity();
    weight_noise_ = piece.weight_noise;
    for (std::size_t i = 0; i < piece.points.size(); ++i) {
        const point& whole = piece.points[i];
        const vector q = place_of(whole) - centre * whole[3];
        p.c[i] = {q[0], q[1], q[2], whole[3]};
        w.c[i] = whole[3];
        least_w_ = std::min(least_w_, whole[3] - weight_noise_);
        size_p = std::max(size_p, largest(place_of(whole)));
        size_q = std::max(size_q, largest(q));
    }
    for (std::size_t i = 0; i < 16; ++i) {
        b.c[i] = of.patch.points[i] - centre;
        size_b_ = std::max(size_b_, largest(b.c[i]));
    }
    net<vector> d = product<vector>(
        p, b, [](const point& q, const vector& by) { return place_of(q) - by * q[3]; });
    const double most_w = bound_of(w), away = largest(centre);
    noise_ = std::numbers::sqrt3 *
             (piece.noise + (away + size_b_) * weight_noise_ + 4 * unit * (size_p + away * most_w) +
              64 * unit * (size_q + most_w * size_b_));
    if (!(least_w_ > 0)) {
        error = std::numeric_limits<double>::infinity();
        return;
    }
    error = (bound_of(d) + noise_) / least_w_;
    if (of.has_pole) // D is 0 there, up to rounding
        for (int k = 0; k <= d.m; ++k)
            d.at(0, k) = vector(0.0);
    find_normal_error(of, w, b, d);
}

/// Where the edge v = 0 is a point, B_u, D and E_u have a factor v. Dividing by v keeps the
/// direction of normals.
void bounds::find_normal_error(const turned& of, const net<double>& w, const net<vector>& b,
                               const net<vector>& d) {
    net<vector> bu = b.by_u();
    if (of.has_pole) {
        for (int k = 0; k <= bu.m; ++k)
            bu.at(0, k) = vector(0.0);
        bu = bu.over_v();
    }
    const net<vector> bv = b.by_v();
    const net<vector> normals =
        product<vector>(bu, bv, [](const vector& along_u, const vector& along_v) {
            return l3d_cross(along_u, along_v);
        });
    vector mean(0.0);
    for (const vector& n : normals.c)
        mean += n;
    const double length = l3d_length(mean);
    if (!(length > 0))
        return;
    const vector axis = mean / length;
    double least = length, across = 0;
    for (const vector& n : normals.c) {
        const double along = l3d_dot(n, axis);
        least = std::min(least, along);
        across = std::max(across, l3d_length(n - axis * along));
    }
    const double size_u = bound_of(bu), size_v = bound_of(bv);
    least -= 64 * unit * (size_u + size_b_) * (size_v + size_b_); // rounding
    const double factor = of.has_pole ? d.n : 1;
    const double wu = bound_of(w.by_u()) + 2 * w.m * weight_noise_;
    const double wv = bound_of(w.by_v()) + 2 * w.n * weight_noise_;
    // Bounds of the u and v derivatives of the error E = D / w, or of its component along an axis.
    const auto slopes = [&](const auto& of_u, const auto& of_v) {
        const double e_u = (bound_of(of_u) + factor * noise_) / least_w_;
        const double e_v = (bound_of(of_v) + noise_) / least_w_;
        return std::array{(bound_of(of_u.by_u()) + 2 * d.m * factor * noise_ + e_u * wu) / least_w_,
                          (bound_of(of_v.by_v()) + 2 * d.n * noise_ + e_v * wv) / least_w_};
    };
    const net<vector> of_u = of.has_pole ? d.over_v() : d;
    const auto [du, dv] = slopes(of_u, d);
    const auto [up_u, up_v] = slopes(along_axis(of_u, axis), along_axis(d, axis));
    const double off = size_u * dv + du * size_v + du * dv;
    if (!(least > 0 && off < least))
        return;
    const double turn = (across + 64 * unit * size_u * size_v) / least;
    const double tilt = size_u * (up_v + turn * dv) + size_v * (up_u + turn * du) + du * dv;
    const double angle = std::min(std::asin(off / least), std::atan(tilt / (least - off)));
    normal_error = 2 * std::sin(angle / 2) * (1 + 8 * unit);
}

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

l3d_bicubic_approximation::l3d_bicubic_approximation(const l3d_rational_piece& piece) {
    for (const bool from_top : {false, true})
        for (const bool from_right : {false, true})
            fill_corner({piece, from_right, from_top}, patch);
    const bounds found(turned(piece, patch));
    error = found.error;
    normal_error = found.normal_error;
}
