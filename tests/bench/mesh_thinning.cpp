// SPDX-License-Identifier: MIT
// thin_out: half-edge collapses in the order of the error they cause, and edge flips between.
#include "bench/mesh_thinning.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <queue>

namespace {

using triangle = patch_mesh::triangle;

class thinner {
public:
    thinner(patch_mesh& mesh, const seen_patch& patch, double tolerance)
        : mesh_(mesh), patch_(patch), tolerance_(tolerance), star_(mesh.corners.size()),
          turn_(mesh.corners.size(), 0) {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (const std::uint32_t i : mesh.triangles[t])
                star_[i].push_back(t);
        alive_.assign(mesh.triangles.size(), true);
    }

    void run() {
        constexpr int rounds = 4;
        for (int round = 0; round < rounds; ++round) {
            flip_all();
            if (!collapse_all())
                break;
        }
        std::vector<triangle> left;
        for (std::size_t t = 0; t < alive_.size(); ++t)
            if (alive_[t])
                left.push_back(mesh_.triangles[t]);
        mesh_.triangles = std::move(left);
    }

private:
    struct move {
        double error;
        std::uint32_t from, to;
        std::uint32_t turn; ///< of `from`, when this was found
        bool operator<(const move& other) const { return error > other.error; }
    };

    const mesh_corner& at(std::uint32_t i) const { return mesh_.corners[i]; }

    double area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const auto &p = at(a), &q = at(b), &r = at(c);
        return (q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u);
    }
    double error(const triangle& t) const {
        return patch_.triangle_error(at(t[0]), at(t[1]), at(t[2]));
    }

    static bool on_boundary(const mesh_corner& c) {
        return c.u == 0 || c.u == 1 || c.v == 0 || c.v == 1;
    }

    /// Neighbours of a corner.
    std::vector<std::uint32_t> ring(std::uint32_t v) const {
        std::vector<std::uint32_t> result;
        for (const std::uint32_t t : star_[v])
            for (const std::uint32_t i : mesh_.triangles[t])
                if (i != v && std::ranges::find(result, i) == result.end())
                    result.push_back(i);
        return result;
    }

    /// The error of the star of `from` when it is moved into `to`; nothing if it folds or errs.
    std::optional<double> moved(std::uint32_t from, std::uint32_t to, double best) const {
        double worst = 0;
        for (const std::uint32_t t : star_[from]) {
            triangle tri = mesh_.triangles[t];
            if (std::ranges::find(tri, to) != tri.end())
                continue;
            std::ranges::replace(tri, from, to);
            constexpr double least_area = 1e-9;
            if (area(tri[0], tri[1], tri[2]) < least_area)
                return std::nullopt;
            worst = std::max(worst, error(tri));
            if (worst > best)
                return std::nullopt;
        }
        return worst;
    }

    /// Whether dense samples agree that `from` may be moved into `to`.
    bool fits(std::uint32_t from, std::uint32_t to) const {
        return std::ranges::all_of(star_[from], [&](std::uint32_t t) {
            triangle tri = mesh_.triangles[t];
            if (std::ranges::find(tri, to) != tri.end())
                return true;
            std::ranges::replace(tri, from, to);
            return mesh_.error(tri, patch_) <= tolerance_;
        });
    }

    void find_move(std::uint32_t from) {
        if (star_[from].empty() || on_boundary(at(from)))
            return;
        move best{tolerance_, from, from, turn_[from]};
        for (const std::uint32_t to : ring(from))
            if (const auto e = moved(from, to, best.error)) {
                best.error = *e;
                best.to = to;
            }
        if (best.to != from && fits(from, best.to))
            queue_.push(best);
    }

    bool collapse_all() {
        bool any = false;
        for (std::uint32_t i = 0; i < star_.size(); ++i)
            find_move(i);
        while (!queue_.empty()) {
            const move m = queue_.top();
            queue_.pop();
            if (m.turn != turn_[m.from] || star_[m.from].empty())
                continue;
            collapse(m.from, m.to);
            any = true;
        }
        return any;
    }

    void collapse(std::uint32_t from, std::uint32_t to) {
        const std::vector<std::uint32_t> touched = ring(from);
        for (const std::uint32_t t : star_[from]) {
            triangle& tri = mesh_.triangles[t];
            if (std::ranges::find(tri, to) != tri.end()) {
                alive_[t] = false;
                for (const std::uint32_t i : tri)
                    if (i != from)
                        std::erase(star_[i], t);
            } else {
                std::ranges::replace(tri, from, to);
                star_[to].push_back(t);
            }
        }
        star_[from].clear();
        for (const std::uint32_t i : touched)
            ++turn_[i];
        for (const std::uint32_t i : touched)
            find_move(i);
    }

    /// Turns edges as long as that lowers the larger error of the two triangles.
    void flip_all() {
        for (bool again = true; again;) {
            again = false;
            for (std::uint32_t t = 0; t < alive_.size(); ++t)
                for (std::size_t k = 0; k < 3 && alive_[t]; ++k)
                    again =
                        flip(t, mesh_.triangles[t][k], mesh_.triangles[t][(k + 1) % 3]) || again;
        }
    }

    bool flip(std::uint32_t t, std::uint32_t a, std::uint32_t b) {
        const auto other = std::ranges::find_if(star_[a], [&](std::uint32_t s) {
            return s != t && std::ranges::find(mesh_.triangles[s], b) != mesh_.triangles[s].end();
        });
        if (other == star_[a].end())
            return false;
        const std::uint32_t s = *other;
        const auto third = [&](std::uint32_t of) {
            return *std::ranges::find_if(mesh_.triangles[of],
                                         [&](std::uint32_t i) { return i != a && i != b; });
        };
        const std::uint32_t c = third(t), d = third(s);
        // a b is counter-clockwise in t, so c lies on its left and d on its right.
        const triangle one{a, d, c}, two{d, b, c};
        constexpr double least_area = 1e-9;
        if (area(a, d, c) < least_area || area(d, b, c) < least_area)
            return false;
        const double now = std::max(error(mesh_.triangles[t]), error(mesh_.triangles[s]));
        const double then = std::max(error(one), error(two));
        constexpr double gain = 1 - 1e-6; // what is less is rounding, and would go on for ever
        if (then >= now * gain || mesh_.error(one, patch_) > tolerance_ ||
            mesh_.error(two, patch_) > tolerance_)
            return false;
        mesh_.triangles[t] = one;
        mesh_.triangles[s] = two;
        std::erase(star_[b], t);
        std::erase(star_[a], s);
        star_[d].push_back(t);
        star_[c].push_back(s);
        return true;
    }

    patch_mesh& mesh_;
    const seen_patch& patch_;
    double tolerance_;
    std::vector<std::vector<std::uint32_t>> star_; ///< triangles of each corner
    std::vector<std::uint32_t> turn_;              ///< changes of each corner's star so far
    std::vector<bool> alive_;
    std::priority_queue<move> queue_;
};

} // namespace

void thin_out(patch_mesh& mesh, const seen_patch& patch, double tolerance) {
    thinner(mesh, patch, tolerance).run();
}
