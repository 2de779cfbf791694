// SPDX-License-Identifier: MIT
// Intersections: split until a piece is one to one or meets no sample, then iterate.
#include "reference/hits.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace reference {
namespace {

/// Samples this near to the edge of a piece belong to it. Seams must not lose a sample to rounding:
/// coordinates up to 1e4 px carry 2e-12 px. 1e-9 px is far below all that is measured.
constexpr double margin_px = 1e-9;

constexpr int most_pieces = 20'000'000;

/// Below 1/2 the iteration needs no more than one halving per step; 0.45 leaves room for rounding.
constexpr double largest_contraction = 0.45;

/// x and y of a derivative of F_c: linear in the picture point c.
struct pair {
    double x, y;
};
pair seen_from(const hpoint& p, double cx, double cy) {
    return {p.x - cx * p.w, p.y - cy * p.w};
}

pair times(const double (&m)[2][2], const pair& p) {
    return {m[0][0] * p.x + m[0][1] * p.y, m[1][0] * p.x + m[1][1] * p.y};
}

/// Solves [a b] s = r by Cramer's rule; empty if a and b are parallel to 13 digits.
std::optional<pair> solve(const pair& a, const pair& b, const pair& r) {
    const double determinant = a.x * b.y - a.y * b.x;
    const double scale = (std::abs(a.x) + std::abs(a.y)) * (std::abs(b.x) + std::abs(b.y));
    if (!(std::abs(determinant) > 1e-13 * scale))
        return std::nullopt;
    return pair{(r.x * b.y - r.y * b.x) / determinant, (a.x * r.y - a.y * r.x) / determinant};
}

/// The largest difference of inverse * 3 (p[k + step] - p[k]) from `wanted`, by component.
pair spread(const net& piece, const double (&inverse)[2][2], std::size_t step, double cx, double cy,
            const pair& wanted) {
    pair result{0, 0};
    for (std::size_t k = 0; k + step < 16; ++k) {
        if (step == 1 && k % 4 == 3)
            continue;
        const hpoint& from = piece.points[k];
        const hpoint& to = piece.points[k + step];
        const hpoint slope{3 * (to.x - from.x), 3 * (to.y - from.y), 3 * (to.w - from.w)};
        const pair g = times(inverse, seen_from(slope, cx, cy));
        result.x = std::max(result.x, std::abs(g.x - wanted.x));
        result.y = std::max(result.y, std::abs(g.y - wanted.y));
    }
    return result;
}

double contraction_of(const net& piece, const double (&inverse)[2][2], const rect& box) {
    double result = 0;
    for (const double cx : {box.x0, box.x1})
        for (const double cy : {box.y0, box.y1}) {
            const pair by_u = spread(piece, inverse, 1, cx, cy, {1, 0});
            const pair by_v = spread(piece, inverse, 4, cx, cy, {0, 1});
            result = std::max({result, by_u.x + by_v.x, by_u.y + by_v.y});
        }
    return result;
}

struct location {
    double u, v, w;
};

/// The zero of F_c on the piece, if there is one.
///
/// Whatever zero p* there is obeys |p - g - p*| <= k |p - p*| <= k |g| / (1 - k) with
/// g = inverse F(p): as soon as this ball misses the piece, there is none. Newton's steps are taken
/// while they shrink |g|; the steps g always do.
class root_finder {
public:
    root_finder(const net& piece, const chart& map) : piece_(piece), map_(map) {}

    std::optional<location> find(double cx, double cy) const {
        double u = 0.5, v = 0.5, previous = std::numeric_limits<double>::infinity();
        bool newton = true;
        for (int round = 0; round < 200; ++round) {
            const jet at = evaluate(piece_, u, v);
            const pair f = seen_from(at.value, cx, cy);
            const pair g = times(map_.inverse, f);
            const double size = std::max(std::abs(g.x), std::abs(g.y));
            const double slack_u = slack(0, at.value.w), slack_v = slack(1, at.value.w);
            const double radius = map_.contraction * size / (1 - map_.contraction);
            if (misses(u - g.x, radius + slack_u) || misses(v - g.y, radius + slack_v))
                return std::nullopt;
            const double residual_px = (std::abs(f.x) + std::abs(f.y)) / at.value.w;
            if (size < 1e-13 || residual_px < 1e-12 || (size < 1e-8 && size >= previous))
                return location{u, v, at.value.w};
            newton = newton && size < previous / 2;
            previous = size;
            const auto step = newton
                                  ? solve(seen_from(at.by_u, cx, cy), seen_from(at.by_v, cx, cy), f)
                                  : std::nullopt;
            u = std::clamp(u - (step ? step->x : g.x), -slack_u, 1 + slack_u);
            v = std::clamp(v - (step ? step->y : g.y), -slack_v, 1 + slack_v);
        }
        return std::nullopt;
    }

private:
    static bool misses(double center, double radius) {
        return center + radius < 0 || center - radius > 1;
    }

    /// margin_px in units of a parameter.
    double slack(std::size_t row, double w) const {
        const double per_px = w * (std::abs(map_.inverse[row][0]) + std::abs(map_.inverse[row][1]));
        return std::min(margin_px * per_px, 1e-2);
    }

    const net& piece_;
    const chart& map_;
};

class hit_search {
public:
    hit_search(double near, const sample_grid& grid, const std::function<void(const hit&)>& found,
               const std::stop_token& stop)
        : near_(near), grid_(grid), window_(grown(grid.box())), found_(found), stop_(stop) {}

    void search(const net& piece) {
        end_if_told(stop_);
        if (++pieces_ > most_pieces)
            throw std::runtime_error("exact picture: a patch needs too many pieces");
        const range depth = depth_range(piece);
        if (!(depth.high >= near_) || is_outside(piece, window_))
            return;
        if (depth.low > 0) {
            const samples inside = samples_in(bounding_box(piece));
            if (inside.empty())
                return;
            if (const auto map = make_chart(piece, window_)) {
                collect(piece, *map, inside);
                return;
            }
            // Seen edge on: a line covers no area, hence no sample.
            if (is_line(piece, margin_px))
                return;
        }
        const auto [low, high] = halves(piece);
        search(low);
        search(high);
    }

private:
    struct samples {
        int i0, i1, j0, j1;
        bool empty() const { return i0 > i1 || j0 > j1; }
    };

    static rect grown(const rect& box) {
        return {box.x0 - margin_px, box.y0 - margin_px, box.x1 + margin_px, box.y1 + margin_px};
    }

    samples samples_in(const rect& exact_box) const {
        const rect box = grown(exact_box);
        const auto from = [&](double position, double origin, int count) {
            return static_cast<int>(
                std::clamp(std::ceil((position - origin) / grid_.step), 0.0, double(count)));
        };
        const auto to = [&](double position, double origin, int count) {
            return static_cast<int>(
                std::clamp(std::floor((position - origin) / grid_.step), -1.0, double(count - 1)));
        };
        return {from(box.x0, grid_.x0, grid_.columns), to(box.x1, grid_.x0, grid_.columns),
                from(box.y0, grid_.y0, grid_.rows), to(box.y1, grid_.y0, grid_.rows)};
    }

    void collect(const net& piece, const chart& map, const samples& inside) const {
        const root_finder finder(piece, map);
        for (int j = inside.j0; j <= inside.j1; ++j) {
            end_if_told(stop_);
            for (int i = inside.i0; i <= inside.i1; ++i) {
                const auto at = finder.find(grid_.x0 + i * grid_.step, grid_.y0 + j * grid_.step);
                if (at && at->w >= near_)
                    found_({i, j, std::clamp(piece.u0 + piece.du * at->u, 0.0, 1.0),
                            std::clamp(piece.v0 + piece.dv * at->v, 0.0, 1.0), at->w});
            }
        }
    }

    double near_;
    sample_grid grid_;
    rect window_;
    const std::function<void(const hit&)>& found_;
    const std::stop_token& stop_;
    int pieces_ = 0;
};

} // namespace

std::optional<chart> make_chart(const net& piece, const rect& where) {
    const rect whole = bounding_box(piece);
    const rect box{std::max(whole.x0, where.x0), std::max(whole.y0, where.y0),
                   std::min(whole.x1, where.x1), std::min(whole.y1, where.y1)};
    const double cx = (box.x0 + box.x1) / 2, cy = (box.y0 + box.y1) / 2;
    const jet at = evaluate(piece, 0.5, 0.5);
    const pair a = seen_from(at.by_u, cx, cy), b = seen_from(at.by_v, cx, cy);
    const auto first = solve(a, b, {1, 0}), second = solve(a, b, {0, 1});
    if (!first || !second)
        return std::nullopt;
    chart result{{{first->x, second->x}, {first->y, second->y}}, 0};
    result.contraction = contraction_of(piece, result.inverse, box);
    if (!(result.contraction <= largest_contraction))
        return std::nullopt;
    return result;
}

void find_hits(const net& piece, double near, const sample_grid& grid,
               const std::function<void(const hit&)>& found, const std::stop_token& stop) {
    hit_search(near, grid, found, stop).search(piece);
}

} // namespace reference
