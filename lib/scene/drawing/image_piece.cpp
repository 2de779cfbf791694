// SPDX-License-Identifier: MIT
// image_piece: evaluates Bernstein polynomials of any degree, and the determinant of contours.
#include "scene/drawing/image_piece_p.h"

#include "geom/nurbs/bernstein_products_p.h"

#include <algorithm>
#include <cmath>

namespace l3d_detail {

namespace {

using values = std::array<double, bernstein_net::most_degree + 1>;

/// The values at t of all Bernstein polynomials of a degree.
void basis_of(int degree, double t, values& b) {
    b[0] = 1;
    for (int d = 1; d <= degree; ++d) {
        double carried = 0;
        for (int i = 0; i < d; ++i) {
            const double old = b[static_cast<std::size_t>(i)];
            b[static_cast<std::size_t>(i)] = carried + old * (1 - t);
            carried = old * t;
        }
        b[static_cast<std::size_t>(d)] = carried;
    }
}

/// The values and the derivatives at t of all Bernstein polynomials of a degree.
void bases_of(int degree, double t, values& b, values& slopes) {
    std::fill_n(slopes.begin(), degree + 1, 0.0);
    if (degree == 0) {
        b[0] = 1;
        return;
    }
    values lower;
    basis_of(degree - 1, t, lower);
    std::fill_n(b.begin(), degree + 1, 0.0);
    for (int i = 0; i < degree; ++i) {
        const auto k = static_cast<std::size_t>(i);
        b[k] += lower[k] * (1 - t);
        b[k + 1] += lower[k] * t;
        slopes[k] -= degree * lower[k];
        slopes[k + 1] += degree * lower[k];
    }
}

/// Visits each row of coefficients along u, or each column along v. Calls visit(index of the first,
/// stride, degree).
template <class Visit> void for_lines(const bernstein_net& net, bool along_u, const Visit& visit) {
    const int lines = along_u ? net.n : net.m, degree = along_u ? net.m : net.n;
    const auto stride = static_cast<std::size_t>(along_u ? net.dims : (net.m + 1) * net.dims);
    for (int line = 0; line <= lines; ++line)
        for (int k = 0; k < net.dims; ++k)
            visit((along_u ? net.index(line, 0) : net.index(0, line)) + static_cast<std::size_t>(k),
                  stride, degree);
}

/// The net of coordinate k alone, from a net with several coordinates.
bernstein_net coordinate(const bernstein_net& of, int k) {
    bernstein_net result(of.m, of.n, 1);
    for (std::size_t i = 0; i < result.c.size(); ++i)
        result.c[i] = of.c[i * static_cast<std::size_t>(of.dims) + static_cast<std::size_t>(k)];
    return result;
}

/// Adds sign * a * b to a net whose degrees are the sums of those of a and b.
/// Source: Farin, Curves and Surfaces for CAGD, section 6.6.
void add_product(const bernstein_net& a, const bernstein_net& b, double sign, bernstein_net& to) {
    for (int r = 0; r <= a.n; ++r)
        for (int c = 0; c <= a.m; ++c) {
            const double here = sign * *a.at(r, c) * binomial(a.n, r) * binomial(a.m, c);
            for (int s = 0; s <= b.n; ++s) {
                const double rows = binomial(b.n, s) / binomial(a.n + b.n, r + s);
                for (int d = 0; d <= b.m; ++d)
                    *to.at(r + s, c + d) +=
                        here * *b.at(s, d) * rows * binomial(b.m, d) / binomial(a.m + b.m, c + d);
            }
        }
}

/// Divides a polynomial by v, 1 - v, u or 1 - u as long as it vanishes where the factor vanishes.
/// The polynomial vanishes at boundaries of the piece that are points. Source: v B^(n-1)_j = (j +
/// 1) / n B^n_(j+1).
void divide_by_vanishing(bernstein_net& f) {
    constexpr double rounding = 0x1p-40; // the shear leaves far more at a contour along a boundary
    constexpr int most_times = 4;
    for (int side = 0; side < 4; ++side)
        for (int times = 0; times < most_times; ++times) {
            const bool in_v = side < 2, at_end = side % 2 == 1;
            const int degree = in_v ? f.n : f.m, across = in_v ? f.m : f.n;
            const auto coefficient = [&](int along, int k) {
                return in_v ? f.at(along, k) : f.at(k, along);
            };
            double most = 0, here = 0;
            for (const double value : f.c)
                most = std::max(most, std::abs(value));
            for (int k = 0; k <= across; ++k)
                here = std::max(here, std::abs(*coefficient(at_end ? degree : 0, k)));
            if (degree < 2 || !(here <= rounding * most))
                break;
            bernstein_net less(in_v ? f.m : f.m - 1, in_v ? f.n - 1 : f.n, 1);
            for (int j = 0; j < degree; ++j)
                for (int k = 0; k <= across; ++k) {
                    const double factor = double(degree) / (at_end ? degree - j : j + 1);
                    *(in_v ? less.at(j, k) : less.at(k, j)) =
                        *coefficient(at_end ? j : j + 1, k) * factor;
                }
            f = std::move(less);
        }
}

/// The polynomial whose zeros are the contours: det(p, dp/du, dp/dv) of the homogeneous places of
/// the picture. It is the third power of w times the determinant by which the map to the picture
/// scales areas. So it is zero where the map to the picture folds.
bernstein_net contour_of(const bernstein_net& p) {
    const bernstein_net by_u = p.derivative(true), by_v = p.derivative(false);
    bernstein_net result(3 * p.m - 1, 3 * p.n - 1, 1);
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3, last = (k + 2) % 3;
        bernstein_net cross(2 * p.m - 1, 2 * p.n - 1, 1);
        add_product(coordinate(by_u, next), coordinate(by_v, last), 1, cross);
        add_product(coordinate(by_u, last), coordinate(by_v, next), -1, cross);
        add_product(coordinate(p, k), cross, 1, result);
    }
    divide_by_vanishing(result);
    return result;
}

} // namespace

std::pair<bernstein_net, bernstein_net> bernstein_net::halves(bernstein_net whole, bool along_u) {
    std::pair<bernstein_net, bernstein_net> result{{whole.m, whole.n, whole.dims}, {}};
    bernstein_net &low = result.first, &high = result.second;
    high = std::move(whole);
    for_lines(low, along_u, [&](std::size_t first, std::size_t stride, int degree) {
        low.c[first] = high.c[first];
        for (int left = degree; left > 0; --left) {
            for (std::size_t i = 0; i < static_cast<std::size_t>(left); ++i) {
                double& value = high.c[first + i * stride];
                value = (value + high.c[first + (i + 1) * stride]) * 0.5;
            }
            low.c[first + static_cast<std::size_t>(degree - left + 1) * stride] = high.c[first];
        }
    });
    return result;
}

bernstein_net bernstein_net::derivative(bool along_u) const {
    bernstein_net result(along_u ? m - 1 : m, along_u ? n : n - 1, dims);
    const double degree = along_u ? m : n;
    for (int r = 0; r <= result.n; ++r)
        for (int k = 0; k <= result.m; ++k)
            for (int d = 0; d < dims; ++d)
                result.at(r, k)[d] =
                    ((along_u ? at(r, k + 1) : at(r + 1, k))[d] - at(r, k)[d]) * degree;
    return result;
}

bernstein_net bernstein_net::part(double u0, double u1, double v0, double v1) const {
    bernstein_net result = *this;
    for (const bool along_u : {true, false}) {
        const double from = along_u ? u0 : v0, to = along_u ? u1 : v1;
        if (from == 0 && to == 1)
            continue;
        const bernstein_net old = result;
        for_lines(old, along_u, [&](std::size_t first, std::size_t stride, int degree) {
            // The coefficient is the blossom at `from` in degree - k arguments and at `to` in k
            // arguments.
            for (int k = 0; k <= degree; ++k) {
                values p{};
                for (int i = 0; i <= degree; ++i)
                    p[static_cast<std::size_t>(i)] =
                        old.c[first + static_cast<std::size_t>(i) * stride];
                for (int step = 0; step < degree; ++step) {
                    const double t = step < k ? to : from;
                    for (std::size_t i = 0; i < static_cast<std::size_t>(degree - step); ++i)
                        p[i] = p[i] * (1 - t) + p[i + 1] * t;
                }
                result.c[first + static_cast<std::size_t>(k) * stride] = p[0];
            }
        });
    }
    return result;
}

bernstein_net::jet bernstein_net::evaluate(double u, double v) const {
    values bu, bv, su, sv;
    bases_of(m, u, bu, su);
    bases_of(n, v, bv, sv);
    jet result;
    for (int r = 0; r <= n; ++r) {
        std::array<double, 4> value{}, slope{};
        for (int k = 0; k <= m; ++k)
            for (int d = 0; d < dims; ++d) {
                const auto e = static_cast<std::size_t>(d);
                value[e] += at(r, k)[d] * bu[static_cast<std::size_t>(k)];
                slope[e] += at(r, k)[d] * su[static_cast<std::size_t>(k)];
            }
        for (std::size_t d = 0; d < 4; ++d) {
            result.value[d] += value[d] * bv[static_cast<std::size_t>(r)];
            result.by_u[d] += slope[d] * bv[static_cast<std::size_t>(r)];
            result.by_v[d] += value[d] * sv[static_cast<std::size_t>(r)];
        }
    }
    return result;
}

drawing_view::drawing_view(const l3d_camera& camera, l3d_size size, double middle_depth,
                           double reach)
    : to_image_(camera.image_matrix(size)), size_(size), is_parallel_(camera.is_parallel()) {
    const l3d_vector<double, 3> forward = camera.axes().forward;
    depth_row_ = {forward[0], forward[1], forward[2], -l3d_dot(forward, camera.eye)};
    // A depth of 1 / distance is linear in the picture.
    middle_ = is_parallel_ ? middle_depth : std::max(middle_depth, camera.near_z);
    scale_ = is_parallel_ ? camera.scale_at_target(size) : camera.focal_length(size) * middle_;
    near_ = is_parallel_ ? 0 : scale_ * (1 / middle_ - 1 / camera.near_z);
    error_ = shear * 2 * reach * (is_parallel_ ? scale_ : scale_ / middle_);
}

std::array<double, 4> drawing_view::placed(const std::array<double, 4>& world) const {
    const l3d_vector<double, 4> p(world[0], world[1], world[2], world[3]);
    const l3d_vector<double, 4> q = to_image_ * p;
    double depth = 0;
    for (int k = 0; k < 4; ++k)
        depth += depth_row_[k] * p[k];
    const double z =
        is_parallel_ ? scale_ * (depth - middle_ * p[3]) : scale_ * (depth / middle_ - p[3]);
    constexpr double golden = 0.6180339887498949; // no direction of a drawing has this slope
    return {q[0] + shear * z, q[1] + shear * golden * z, q[3], z};
}

double drawing_view::depth_of(double z) const {
    return is_parallel_ ? middle_ + z / scale_ : 1 / (1 / middle_ - z / scale_);
}

double drawing_view::scale_at(double z) const {
    return is_parallel_ ? scale_ : scale_ / middle_ / depth_of(z);
}

image_piece::image_piece(const l3d_patch_points& piece, const l3d_matrix<double>& placement,
                         const drawing_view& view)
    : net(piece.degree_u, piece.degree_v, 4), world(piece.degree_u, piece.degree_v, 4) {
    for (std::size_t i = 0; i < piece.points.size(); ++i) {
        const double w = piece.weights.empty() ? 1 : piece.weights[i];
        const auto& p = piece.points[i];
        const l3d_vector<double, 4> q =
            placement * l3d_vector<double, 4>(p[0] * w, p[1] * w, p[2] * w, w);
        const std::array<double, 4> there{q[0], q[1], q[2], q[3]}, seen = view.placed(there);
        std::ranges::copy(there, &world.c[4 * i]);
        std::ranges::copy(seen, &net.c[4 * i]);
    }
    contour = contour_of(net);
}

/// Bounds how far changes of u and v move a place in the picture. This bound tells how fine
/// polygons must be to stand for trims. With P = (x, y) / w in the net's box, P' is ((x, y)' - P
/// w') / w. If the net reaches the near plane, w counts as at least a 16th of the largest w.
/// Otherwise parts that are hardly seen would ask for millions of chords.
double image_piece::trim(std::span<const l3d_trim_loop> loops, double wanted,
                         const drawing_view& view) {
    double most = 0, least = net.c[2];
    for (std::size_t i = 0; i < net.c.size(); i += 4) {
        most = std::max(most, net.c[i + 2]);
        least = std::min(least, net.c[i + 2]);
    }
    constexpr double depths = 16; // largest ratio of depths that counts at the near plane
    if (side_of_near(net, view) != ahead_of_near::all)
        least = most / depths;
    image_bounds box{};
    bool is_first = true;
    double least_w = most;
    for (std::size_t i = 0; i < net.c.size(); i += 4) {
        const double w = std::max(net.c[i + 2], least), x = net.c[i] / w, y = net.c[i + 1] / w;
        if (std::exchange(is_first, false))
            box = {x, x, y, y, 0, 0};
        box = {std::min(box.left, x),
               std::max(box.right, x),
               std::min(box.top, y),
               std::max(box.bottom, y),
               0,
               0};
        least_w = std::min(least_w, w);
    }
    const double x = (box.left + box.right) / 2, y = (box.top + box.bottom) / 2;
    const double radius = std::hypot(box.width(), box.height()) / 2;
    l3d_trim_place lengths{};
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
        const bernstein_net by = net.derivative(k == 0);
        for (std::size_t i = 0; i < by.c.size(); i += 4) {
            const double w = by.c[i + 2];
            const double off = std::hypot(by.c[i] - x * w, by.c[i + 1] - y * w);
            lengths[k] = std::max(lengths[k], (off + radius * std::abs(w)) / least_w);
        }
    }
    is_trimmed = true;
    const double off = l3d_flat_trims(loops, lengths, wanted, region);
    // Trims of files may run along sides of pieces, and leave them by rounding. Such a trim must
    // not cut off a part of the side.
    constexpr double rounding = 1e-9;
    for (l3d_trim_polygon& polygon : region.polygons)
        for (l3d_trim_corner& corner : polygon)
            for (double& at : corner)
                if (std::abs(at - std::round(at)) < rounding)
                    at = std::round(at);
    region = region.within({});
    rows = region_rows(region);
    return off;
}

image_place image_piece::at(double u, double v) const {
    const auto p = net.evaluate(u, v).value;
    return {p[0] / p[2], p[1] / p[2], p[3] / p[2]};
}

l3d_vector<double, 3> image_piece::normal(double u, double v) const {
    using vector = l3d_vector<double, 3>;
    const bernstein_net::jet j = world.evaluate(u, v);
    vector su, sv;
    for (int k = 0; k < 3; ++k) {
        const auto e = static_cast<std::size_t>(k);
        const double at = j.value[e] / j.value[3];
        su[k] = j.by_u[e] - at * j.by_u[3];
        sv[k] = j.by_v[e] - at * j.by_v[3];
    }
    const vector n = l3d_cross(su, sv);
    const double length = l3d_length(n);
    constexpr double least_sine = 1e-9; // below, rounding decides
    return length > least_sine * l3d_length(su) * l3d_length(sv) ? n * (1 / length) : vector(0.0);
}

/// Sorts the sides of the region's polygons into rows. There are so many rows that each holds a few
/// sides.
region_rows::region_rows(const l3d_trim_region& region) {
    std::size_t sides = 0;
    for (const l3d_trim_polygon& polygon : region.polygons)
        sides += polygon.size();
    constexpr std::size_t sides_of_row = 4;
    rows_.resize(sides / sides_of_row + 1);
    for (const l3d_trim_polygon& polygon : region.polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const l3d_trim_place &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            if (a[1] == b[1])
                continue;
            const auto [low, high] = std::minmax(a[1], b[1]);
            for (std::size_t row = row_of(low); row <= row_of(high); ++row)
                rows_[row].push_back({a, b});
        }
}

std::size_t region_rows::row_of(double v) const {
    const double last = static_cast<double>(rows_.size()) - 1;
    return static_cast<std::size_t>(std::clamp(v * last, 0.0, last));
}

bool region_rows::contains(double u, double v) const {
    bool inside = false;
    for (const auto& [a, b] : rows_[row_of(v)])
        if ((a[1] <= v) != (b[1] <= v) && a[0] + (b[0] - a[0]) * ((v - a[1]) / (b[1] - a[1])) > u)
            inside = !inside;
    return inside;
}

ahead_of_near side_of_near(const bernstein_net& net, const drawing_view& view) {
    std::size_t ahead = 0;
    for (std::size_t i = 0; i < net.c.size(); i += 4)
        if (view.ahead(&net.c[i]) > 0)
            ++ahead;
    return ahead == net.places() ? ahead_of_near::all
           : ahead == 0          ? ahead_of_near::none
                                 : ahead_of_near::some;
}

image_bounds bounds_of(const bernstein_net& net) {
    image_bounds b;
    for (std::size_t i = 0; i < net.c.size(); i += 4) {
        const double w = net.c[i + 2];
        const double x = net.c[i] / w, y = net.c[i + 1] / w, z = net.c[i + 3] / w;
        if (i == 0)
            b = {x, x, y, y, z, z};
        b = {std::min(b.left, x),   std::max(b.right, x), std::min(b.top, y),
             std::max(b.bottom, y), std::min(b.near, z),  std::max(b.far, z)};
    }
    return b;
}

bool is_beside(const bernstein_net& net, const drawing_view& view) {
    constexpr double margin = 2; // lines that touch the border, and pieces that hide them
    const double across = view.size().width / 2.0 + margin;
    const double down = view.size().height / 2.0 + margin;
    std::array<bool, 4> beside{true, true, true, true};
    for (std::size_t i = 0; i < net.c.size(); i += 4) {
        const double x = net.c[i], y = net.c[i + 1], w = net.c[i + 2];
        beside = {beside[0] && x + across * w < 0, beside[1] && across * w - x < 0,
                  beside[2] && y + down * w < 0, beside[3] && down * w - y < 0};
    }
    return beside[0] || beside[1] || beside[2] || beside[3];
}

flat_image::flat_image(const bernstein_net& net) {
    const auto corner = [&](int row, int column) -> image_place {
        const double* const p = net.at(row, column);
        return {p[0] / p[2], p[1] / p[2], p[3] / p[2]};
    };
    const image_place a = corner(0, 0), b = corner(0, net.m), c = corner(net.n, 0),
                      d = corner(net.n, net.m);
    const auto mean = [](double image_place::*k, const image_place& p, const image_place& q) {
        return (p.*k + q.*k) / 2;
    };
    for (const auto k : {&image_place::x, &image_place::y, &image_place::z}) {
        const double low_v = mean(k, a, b), high_v = mean(k, c, d);
        along_u.*k = mean(k, b, d) - mean(k, a, c);
        along_v.*k = high_v - low_v;
        middle.*k = (low_v + high_v) / 2;
    }
    // With the parallelogram X and its mean weight, the distance of sum B_i p_i from X is
    // (sum B_i d_i + sum B_i (X_i - X) (w_i - w_mean)) / sum B_i w_i, d_i = p_i - X_i w_i.
    double least = net.c[2], most = net.c[2], squares = 0;
    for (int r = 0; r <= net.n; ++r)
        for (int k = 0; k <= net.m; ++k) {
            const double* const p = net.at(r, k);
            const image_place flat = at(double(k) / net.m, double(r) / net.n);
            const double dx = p[0] - flat.x * p[2], dy = p[1] - flat.y * p[2];
            squares = std::max(squares, dx * dx + dy * dy);
            least = std::min(least, p[2]);
            most = std::max(most, p[2]);
        }
    const double widest = std::hypot(along_u.x, along_u.y) + std::hypot(along_v.x, along_v.y);
    error = (std::sqrt(squares) + widest * (most - least) / 2) / least;
}

bool bends_along_u(const bernstein_net& net) {
    struct differences {
        double bend = 0, length = 0; ///< squares of the second and the first derivative
    };
    std::array<differences, 2> along{};
    double twist = 0;
    const auto at = [&](int row, int column) -> image_place {
        const double* const p = net.at(row, column);
        return {p[0] / p[2], p[1] / p[2], p[3] / p[2]};
    };
    const auto square = [](double x) { return x * x; };
    for (int r = 0; r <= net.n; ++r)
        for (int k = 0; k <= net.m; ++k) {
            const image_place p = at(r, k);
            for (const std::size_t direction : {0U, 1U}) {
                const int u = direction == 0 ? 1 : 0, v = 1 - u;
                const int degree = direction == 0 ? net.m : net.n;
                const int here = direction == 0 ? k : r;
                if (here == degree)
                    continue;
                differences& to = along[direction];
                const image_place next = at(r + v, k + u);
                const double first = square(degree) * (square(next.x - p.x) + square(next.y - p.y));
                to.length = std::max(to.length, first + square(degree * (next.z - p.z)));
                // Perspective bends parameters: x'' = -2 x' w' / w along a straight line.
                const double w = net.at(r, k)[2], rise = net.at(r + v, k + u)[2] - w;
                to.bend = std::max(to.bend, 4 * first * square(degree * rise / w));
                if (here == 0)
                    continue;
                const image_place last = at(r - v, k - u);
                to.bend = std::max(to.bend, square(degree * (degree - 1)) *
                                                (square(last.x + next.x - 2 * p.x) +
                                                 square(last.y + next.y - 2 * p.y)));
            }
            if (r == net.n || k == net.m)
                continue;
            const image_place a = at(r, k + 1), b = at(r + 1, k), c = at(r + 1, k + 1);
            twist = std::max(twist, square(net.m * net.n) * (square(p.x - a.x - b.x + c.x) +
                                                             square(p.y - a.y - b.y + c.y)));
        }
    const auto& [in_u, in_v] = along;
    return twist > std::max(in_u.bend, in_v.bend) ? in_u.length >= in_v.length
                                                  : in_u.bend >= in_v.bend;
}

double distance_from(const image_place& p, const image_place& from, const image_place& to) {
    const double dx = to.x - from.x, dy = to.y - from.y, square = dx * dx + dy * dy;
    const double along = (p.x - from.x) * dx + (p.y - from.y) * dy;
    const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
    const double ex = p.x - from.x - t * dx, ey = p.y - from.y - t * dy;
    return std::sqrt(ex * ex + ey * ey);
}

} // namespace l3d_detail
