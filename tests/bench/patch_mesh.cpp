// SPDX-License-Identifier: MIT
// patch_mesh: boundaries from edge curves, grids inside, rings between.
#include "bench/patch_mesh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

namespace {

using curve = l3d_bezier_curve<double, 3>;
using position = l3d_vector<double, 3>;

struct curve_point {
    double t;
    position at;
};

bool runs_backwards(const curve& c) {
    for (std::size_t i = 0; i < 2; ++i)
        for (int k = 0; k < 3; ++k)
            if (c.points[i][k] != c.points[3 - i][k])
                return c.points[3 - i][k] < c.points[i][k];
    return false;
}

bool is_a_point(const curve& c) {
    return std::ranges::all_of(c.points, [&](const position& p) { return p == c.points[0]; });
}

std::vector<curve_point> points_at(const curve& c, const std::vector<double>& parameters) {
    std::vector<curve_point> points;
    for (const double t : parameters)
        points.push_back({t, t == 0 ? c.points[0] : t == 1 ? c.points[3] : c.evaluate(t)});
    return points;
}

/// Largest error of a polyline, at three points of each chord.
double error_of(const curve& c, std::span<const curve_point> line, const seen_world& world) {
    double largest = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const l3d_image_point a = world(line[i].at), b = world(line[i + 1].at);
        for (const double s : {0.25, 0.5, 0.75}) {
            const l3d_image_point drawn = a * (1 - s) + b * s;
            const double x = drawn[0] / drawn[2], y = drawn[1] / drawn[2];
            const auto& w = world.window;
            if (x < w.left || x > w.right || y < w.top || y > w.bottom)
                continue;
            const l3d_image_point e =
                world(c.evaluate(line[i].t + s * (line[i + 1].t - line[i].t)));
            largest = std::max(largest, std::hypot(x - e[0] / e[2], y - e[1] / e[2]));
        }
    }
    return largest;
}

/// Appends triangles and turns them alike.
class tiler {
public:
    tiler(const seen_patch& patch, patch_mesh& mesh) : patch_(patch), mesh_(mesh) {}

    std::uint32_t add(const mesh_corner& c) {
        mesh_.corners.push_back(c);
        return static_cast<std::uint32_t>(mesh_.corners.size() - 1);
    }

    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto &p = at(a), &q = at(b), &r = at(c);
        const double area = (q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u);
        if (area > 0)
            mesh_.triangles.push_back({a, b, c});
        else if (area < 0)
            mesh_.triangles.push_back({a, c, b});
    }

    /// A quad, corners in turn, along its better diagonal.
    void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        if (error(a, c) <= error(b, d)) {
            triangle(a, b, c);
            triangle(a, c, d);
        } else {
            triangle(a, b, d);
            triangle(b, c, d);
        }
    }

    /// The strip between two lines, each in order; the shorter of the next two rungs is taken.
    void zip(std::span<const std::uint32_t> outer, std::span<const std::uint32_t> inner) {
        std::size_t i = 0, j = 0;
        while (i + 1 < outer.size() || j + 1 < inner.size()) {
            const bool can_outer = i + 1 < outer.size(), can_inner = j + 1 < inner.size();
            const bool step_outer = can_outer && (!can_inner || rung(outer[i + 1], inner[j]) <=
                                                                    rung(inner[j + 1], outer[i]));
            if (step_outer) {
                triangle(outer[i], outer[i + 1], inner[j]);
                ++i;
            } else {
                triangle(outer[i], inner[j + 1], inner[j]);
                ++j;
            }
        }
    }

private:
    const mesh_corner& at(std::uint32_t i) const { return mesh_.corners[i]; }
    double error(std::uint32_t a, std::uint32_t b) const { return patch_.edge_error(at(a), at(b)); }
    /// Out of the window there are no errors, and the shortest in parameters is taken.
    double rung(std::uint32_t a, std::uint32_t b) const {
        constexpr double little = 1e-3;
        return error(a, b) + little * std::hypot(at(a).u - at(b).u, at(a).v - at(b).v);
    }

    const seen_patch& patch_;
    patch_mesh& mesh_;
};

constexpr std::array all_sides{shared_edges::low_v, shared_edges::high_v, shared_edges::low_u,
                               shared_edges::high_u};

} // namespace

double patch_mesh::error(const triangle& t, const seen_patch& patch) const {
    double largest = 0;
    each_sample(t, [&](const l3d_image_point& drawn, double u, double v) {
        largest = std::max(largest, patch.point_error(drawn, u, v));
    });
    return largest;
}

double patch_mesh::error(const seen_patch& patch) const {
    double largest = 0;
    for (const triangle& t : triangles)
        largest = std::max(largest, error(t, patch));
    return largest;
}

void patch_mesh::keep_visible(const seen_patch& patch) {
    std::erase_if(triangles, [&](const triangle& t) {
        const auto &a = corners[t[0]], &b = corners[t[1]], &c = corners[t[2]];
        return a.position == b.position || b.position == c.position || c.position == a.position ||
               !patch.visible(a, b, c);
    });
}

shared_edges::shared_edges(const l3d_patch_model& model, const seen_world& world, double tolerance)
    : world_(world) {
    const auto same = [](const curve& a, const curve& b) { return a.points == b.points; };
    for (const auto& p : model.patches()) {
        auto& uses = uses_.emplace_back();
        const std::array<curve, 4> sides{p.row(0), p.row(3), p.column(0), p.column(3)};
        for (std::size_t s = 0; s < sides.size(); ++s) {
            const bool backwards = runs_backwards(sides[s]);
            const curve canonical = backwards ? sides[s].reversed() : sides[s];
            const auto known = std::ranges::find_if(
                edges_, [&](const edge& e) { return same(e.canonical, canonical); });
            uses[s] = {static_cast<std::size_t>(known - edges_.begin()), backwards};
            if (known != edges_.end())
                continue;
            edge& e = edges_.emplace_back(
                edge{canonical, growth_of(canonical, world), is_a_point(canonical), 1});
            // A chord of 1 / n errs by second / (8 n^2).
            e.pieces =
                std::max(1, static_cast<int>(0.9 * e.growth.back() / std::sqrt(8 * tolerance)));
            while (!e.collapsed &&
                   error_of(canonical, points_at(canonical, knots(e.growth, e.pieces)), world) >
                       tolerance)
                ++e.pieces;
        }
    }
}

void shared_edges::refine(std::size_t patch, side s) {
    int& pieces = edges_[uses_[patch][s].edge].pieces;
    pieces += 1 + pieces / 8;
}

std::vector<mesh_corner> shared_edges::points(std::size_t patch, side s) const {
    const edge& e = at(patch, s);
    const bool backwards = uses_[patch][s].backwards;
    const double across = s == high_v || s == high_u ? 1 : 0;
    std::vector<mesh_corner> result;
    for (const curve_point& p : points_at(e.canonical, knots(e.growth, e.pieces))) {
        const double t = backwards ? 1 - p.t : p.t;
        result.push_back(s == low_v || s == high_v ? world_.corner(t, across, p.at)
                                                   : world_.corner(across, t, p.at));
    }
    if (backwards)
        std::ranges::reverse(result);
    return result;
}

grid_maker::grid_maker(const seen_patch& patch, std::size_t index)
    : patch_(patch), index_(index), along_u_(patch.growth_along_u()),
      along_v_(patch.growth_along_v()) {}

void grid_maker::set_steps(double tolerance, double scale) {
    const double step = std::sqrt(8 * tolerance * scale / 2);
    const auto steps = [&](const seen_patch::growth& g) {
        return std::max(2, static_cast<int>(std::ceil(g.back() / step)));
    };
    nu_ = steps(along_u_);
    nv_ = steps(along_v_);
}

patch_mesh grid_maker::grid(const shared_edges& edges) const {
    patch_mesh mesh;
    tiler tile(patch_, mesh);
    const std::vector<double> u = knots(along_u_, nu_), v = knots(along_v_, nv_);

    std::array<std::vector<std::uint32_t>, 4> rim;
    for (const auto s : all_sides) {
        const bool along_u = s == shared_edges::low_v || s == shared_edges::high_v;
        if (!edges.collapsed(index_, s)) {
            for (const mesh_corner& c : edges.points(index_, s))
                rim[s].push_back(tile.add(c));
            continue;
        }
        const double across = s == shared_edges::high_v || s == shared_edges::high_u ? 1 : 0;
        for (const double t : along_u ? u : v)
            rim[s].push_back(
                tile.add(along_u ? patch_.corner(t, across) : patch_.corner(across, t)));
    }
    std::vector<std::vector<std::uint32_t>> inner;
    for (std::size_t r = 1; r + 1 < v.size(); ++r) {
        inner.emplace_back();
        for (std::size_t c = 1; c + 1 < u.size(); ++c)
            inner.back().push_back(tile.add(patch_.corner(u[c], v[r])));
    }
    std::vector<std::uint32_t> first, last;
    for (const auto& row : inner) {
        first.push_back(row.front());
        last.push_back(row.back());
    }
    tile.zip(rim[shared_edges::low_v], inner.front());
    tile.zip(rim[shared_edges::low_u], first);
    for (std::size_t r = 0; r + 1 < inner.size(); ++r)
        for (std::size_t c = 0; c + 1 < inner[r].size(); ++c)
            tile.quad(inner[r][c], inner[r][c + 1], inner[r + 1][c + 1], inner[r + 1][c]);
    tile.zip(rim[shared_edges::high_u], last);
    tile.zip(rim[shared_edges::high_v], inner.back());
    return mesh;
}

bool grid_maker::improve(shared_edges& edges, double tolerance, double& scale) const {
    const patch_mesh mesh = grid(edges);
    bool inside = false;
    std::array<bool, 4> rims{};
    for (const auto& t : mesh.triangles) {
        const mesh_corner &a = mesh.corners[t[0]], &b = mesh.corners[t[1]], &c = mesh.corners[t[2]];
        if (mesh.error(t, patch_) <= tolerance)
            continue;
        bool at_rim = false;
        for (const auto s : all_sides) {
            const bool along_u = s == shared_edges::low_v || s == shared_edges::high_v;
            const double across = s == shared_edges::high_v || s == shared_edges::high_u ? 1 : 0;
            const auto on_side = [&](const mesh_corner& q) {
                return (along_u ? q.v : q.u) == across;
            };
            const bool coarse =
                !edges.collapsed(index_, s) && edges.pieces(index_, s) < (along_u ? nu_ : nv_);
            if (coarse && (on_side(a) || on_side(b) || on_side(c)))
                at_rim = rims[s] = true;
        }
        inside = inside || !at_rim;
    }
    if (inside)
        scale *= 0.93;
    for (const auto s : all_sides)
        if (rims[s])
            edges.refine(index_, s);
    return inside || rims != std::array<bool, 4>{};
}
