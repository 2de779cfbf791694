// SPDX-License-Identifier: MIT
// Distances to the covered region and to its outside, by best-first search over pieces.
#include "reference/region.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <stdexcept>
#include <utility>

namespace reference {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double surface_accuracy = 1e-4;
constexpr double outline_accuracy = 2e-3;

/// Pieces that the search for a nearest point may look at: about a second.
constexpr int most_candidates = 200'000;

/// Counts them. Errors: std::runtime_error after the last, and if told to stop.
class patience {
public:
    explicit patience(const std::stop_token& stop) : stop_(stop) {}

    void use() {
        end_if_told(stop_);
        if (++used_ > most_candidates)
            throw std::runtime_error("exact region: the nearest point needs too many pieces");
    }

private:
    const std::stop_token& stop_;
    int used_ = 0;
};

/// Pieces are cut to this size once, so that a query looks at a few hundred of them.
constexpr double piece_px = 32;
/// Beyond the window, where nobody asks, pieces stay as large as they are.
constexpr double margin_px = 64;
constexpr int deepest_piece = 24;

struct xy {
    double x, y;
};
double dot(const xy& a, const xy& b) {
    return a.x * b.x + a.y * b.y;
}

double box_distance(const rect& box, double x, double y) {
    const double dx = std::max({box.x0 - x, 0.0, x - box.x1});
    const double dy = std::max({box.y0 - y, 0.0, y - box.y1});
    return std::hypot(dx, dy);
}

/// A lower bound of the distance of a picture point from the hull of a piece's control points,
/// tight to a few percent of the piece's thickness. Takes six steps of Frank and Wolfe's method
/// towards the nearest point of the hull, each of which proves a bound. Expects: all w > 0.
double hull_distance(const net& piece, double x, double y) {
    std::array<xy, 16> p{};
    xy nearest{0, 0};
    for (std::size_t k = 0; k < 16; ++k) {
        const hpoint& h = piece.points[k];
        p[k] = {h.x / h.w - x, h.y / h.w - y};
        nearest = {nearest.x + p[k].x / 16, nearest.y + p[k].y / 16};
    }
    double bound = 0;
    for (int round = 0; round < 6; ++round) {
        const double length = std::sqrt(dot(nearest, nearest));
        if (length == 0)
            return bound;
        const xy support = *std::min_element(p.begin(), p.end(), [&](const xy& a, const xy& b) {
            return dot(a, nearest) < dot(b, nearest);
        });
        bound = std::max(bound, dot(support, nearest) / length);
        const xy way{support.x - nearest.x, support.y - nearest.y};
        if (dot(way, way) == 0)
            return bound;
        const double t = std::clamp(-dot(nearest, way) / dot(way, way), 0.0, 1.0);
        nearest = {nearest.x + t * way.x, nearest.y + t * way.y};
    }
    return bound;
}

double lower_bound(const net& piece, double x, double y) {
    return depth_range(piece).low > 0 ? hull_distance(piece, x, y) : 0;
}

double corner_distance(const net& piece, double near, double x, double y) {
    double result = infinity;
    for (const std::size_t k : {0u, 3u, 12u, 15u}) {
        const hpoint& p = piece.points[k];
        if (p.w >= near)
            result = std::min(result, std::hypot(p.x / p.w - x, p.y / p.w - y));
    }
    return result;
}

struct candidate {
    double lower;
    net surface;
    friend bool operator<(const candidate& a, const candidate& b) { return a.lower > b.lower; }
};
using nearest_first = std::priority_queue<candidate>;

/// Too small to be cut further: 2^-45 of the patch.
bool is_point(const net& piece) {
    return std::max(piece.du, piece.dv) < 0x1p-45;
}

/// Whether the outline of the region can run through a piece: it touches the patch's boundary or
/// the near plane, or is not proved to be free of silhouettes.
bool may_hold_outline(const net& piece, double near) {
    const bool at_boundary =
        piece.u0 == 0 || piece.v0 == 0 || piece.u0 + piece.du == 1 || piece.v0 + piece.dv == 1;
    return at_boundary || depth_range(piece).low < near || !make_chart(piece, bounding_box(piece));
}

double largest_extent(const net& piece) {
    if (depth_range(piece).low <= 0)
        return infinity;
    const rect box = bounding_box(piece);
    return std::max(box.x1 - box.x0, box.y1 - box.y0);
}

/// Coverage of a square of samples around a point.
class sample_square {
public:
    static constexpr int half = 16, side = 2 * half + 1;

    sample_square(double x, double y, double radius)
        : grid{x - radius, y - radius, radius / half, side, side}, covered_(side * side, false) {}

    void mark(const hit& at) { covered_[place(at.i, at.j)] = true; }

    /// Uncovered samples within the radius, nearest first, as offsets from the middle.
    std::vector<xy> gaps() const {
        std::vector<xy> result;
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                const xy offset{(i - half) * grid.step, (j - half) * grid.step};
                if (!covered_[place(i, j)] &&
                    dot(offset, offset) <= half * half * grid.step * grid.step)
                    result.push_back(offset);
            }
        std::sort(result.begin(), result.end(),
                  [](const xy& a, const xy& b) { return dot(a, a) < dot(b, b); });
        return result;
    }

    const sample_grid grid;

private:
    static std::size_t place(int i, int j) {
        return static_cast<std::size_t>(j) * side + static_cast<std::size_t>(i);
    }
    std::vector<bool> covered_;
};

} // namespace

exact_region::exact_region(std::span<const patch> patches, const camera& view, picture_size size,
                           std::stop_token stop)
    : near_(view.least_w()), stop_(std::move(stop)) {
    const camera_frame frame(view, size);
    const rect window{-margin_px, -margin_px, size.width + margin_px, size.height + margin_px};
    for (const patch& surface : patches)
        add(make_net(surface, frame), window, 0);
}

void exact_region::add(const net& surface, const rect& window, int depth) {
    const range w = depth_range(surface);
    if (!(w.high >= near_))
        return;
    const bool bounded = w.low > 0;
    const bool small = bounded && largest_extent(surface) <= piece_px;
    if (small || depth == deepest_piece || is_outside(surface, window)) {
        pieces_.push_back({surface, bounded ? bounding_box(surface) : rect{}, bounded});
        return;
    }
    const auto [low, high] = halves(surface);
    add(low, window, depth + 1);
    add(high, window, depth + 1);
}

bool exact_region::covers(double x, double y) const {
    const sample_grid point{x, y, 1, 1, 1};
    for (const piece& part : pieces_) {
        if (part.bounded && !part.box.touches({x - 1, y - 1, x + 1, y + 1}))
            continue;
        bool found = false;
        find_hits(part.surface, near_, point, [&](const hit&) { found = true; });
        if (found)
            return true;
    }
    return false;
}

double exact_region::distance_to_exact_surface(double x, double y) const {
    if (covers(x, y))
        return 0;
    double best = infinity;
    for (const piece& part : pieces_)
        best = std::min(best, corner_distance(part.surface, near_, x, y));
    nearest_first open;
    for (const piece& part : pieces_)
        if (!part.bounded || box_distance(part.box, x, y) < best)
            open.push({lower_bound(part.surface, x, y), part.surface});
    patience pieces(stop_);
    while (!open.empty() && open.top().lower < best - surface_accuracy) {
        pieces.use();
        const candidate next = open.top();
        open.pop();
        const auto [low, high] = halves(next.surface);
        for (const net& half : {low, high}) {
            if (depth_range(half).high < near_)
                continue;
            const double lower = std::max(next.lower, lower_bound(half, x, y));
            best = std::min(best, is_point(half) ? lower : corner_distance(half, near_, x, y));
            if (lower < best - surface_accuracy)
                open.push({lower, half});
        }
    }
    return best;
}

double exact_region::distance_to_outline(double x, double y) const {
    nearest_first open;
    for (const piece& part : pieces_)
        if (may_hold_outline(part.surface, near_))
            open.push({lower_bound(part.surface, x, y), part.surface});
    patience pieces(stop_);
    while (!open.empty()) {
        pieces.use();
        const candidate next = open.top();
        if (largest_extent(next.surface) < outline_accuracy / 2 || is_point(next.surface))
            return std::max(0.0, next.lower - outline_accuracy);
        open.pop();
        const auto [low, high] = halves(next.surface);
        for (const net& half : {low, high})
            if (depth_range(half).high >= near_ && may_hold_outline(half, near_))
                open.push({std::max(next.lower, lower_bound(half, x, y)), half});
    }
    return infinity;
}

double exact_region::nearest_gap(double x, double y, double radius) const {
    sample_square square(x, y, radius);
    for (const piece& part : pieces_)
        if (!part.bounded || part.box.touches(square.grid.box()))
            find_hits(part.surface, near_, square.grid, [&](const hit& at) { square.mark(at); });
    std::vector<xy> gaps = square.gaps();
    // The nearest samples stand for different directions; the outline is bisected along each.
    gaps.resize(std::min<std::size_t>(gaps.size(), 4));
    double best = infinity;
    for (const xy& gap : gaps) {
        double inside = 0, outside = 1;
        while (outside - inside > 1e-4) {
            const double t = (inside + outside) / 2;
            (covers(x + t * gap.x, y + t * gap.y) ? inside : outside) = t;
        }
        best = std::min(best, outside * std::sqrt(dot(gap, gap)));
    }
    return best;
}

exact_region::interval exact_region::distance_to_uncovered(double x, double y, double limit) const {
    if (!covers(x, y))
        return {0, 0};
    interval result;
    result.lower = distance_to_outline(x, y);
    // From small to large: a square sees gaps down to 1/16 of its radius.
    for (double radius = std::clamp(2 * result.lower, std::min(limit, 1.0 / 64), limit);
         result.upper == infinity; radius = std::min(limit, 2 * radius)) {
        result.upper = nearest_gap(x, y, radius);
        if (radius == limit)
            break;
    }
    return result;
}

} // namespace reference
