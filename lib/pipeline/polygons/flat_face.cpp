// SPDX-License-Identifier: MIT
// flat_face: cuts convex faces into fans, and others ear by ear.
#include "pipeline/polygons/flat_face_p.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace l3d_detail {

namespace {

/// Cuts a face into triangles, ear by ear. The corners that are not cut off yet form a ring.
class ear_clipper {
public:
    explicit ear_clipper(std::span<const flat_place> places)
        : places_(places), tree_(places), next_(places.size()), previous_(places.size()),
          left_(places.size()), is_ear_(places.size()), is_cut_(places.size()) {
        for (std::size_t i = 0; i < left_; ++i) {
            next_[i] = (i + 1) % left_;
            previous_[i] = (i + left_ - 1) % left_;
        }
    }

    std::vector<flat_face::triangle> clip() {
        for (std::size_t i = 1; i < places_.size(); ++i)
            judge(i);
        while (left_ > 3)
            cut(next_ear());
        cut(next_[0]);
        return std::move(triangles_);
    }

private:
    flat_face::triangle at(std::size_t corner) const {
        return {previous_[corner], corner, next_[corner]};
    }

    void judge(std::size_t corner) {
        const flat_face::triangle cut_off = at(corner);
        const auto& [a, b, c] = cut_off;
        const wide_integer area = turn(places_[a], places_[b], places_[c]);
        is_ear_[corner] = area > 0 && !tree_.any_in(cut_off, [&](std::size_t p, const auto& turns) {
            return blocks(cut_off, p, turns);
        });
        if (is_ear_[corner])
            ears_.push(corner);
        else if (area == 0)
            flat_.push(corner);
    }

    /// Whether the face's border at corner p enters the inside of a triangle a, b, c. p lies in the
    /// triangle or on its sides; `turns` are those of corner_tree. A border that enters across the
    /// diagonal between a and c must leave at a corner inside, or at b. Such corners are tested,
    /// too.
    bool blocks(const flat_face::triangle& triangle, std::size_t p,
                const std::array<wide_integer, 3>& turns) const {
        const bool inside_ab = turns[0] > 0, inside_bc = turns[1] > 0, on_ca = turns[2] == 0;
        if (on_ca)
            return false;
        const auto enters = [&](std::size_t q) {
            const auto& [a, b, c] = triangle;
            return (inside_ab || turn(places_[a], places_[b], places_[q]) > 0) &&
                   (inside_bc || turn(places_[b], places_[c], places_[q]) > 0);
        };
        return (inside_ab && inside_bc) || enters(previous_[p]) || enters(next_[p]);
    }

    /// Takes corners off a queue until `still` is true for the first corner, and returns this
    /// corner. If no such corner is left, it returns 0, since corner 0 is never cut off.
    template <class Queue, class Still>
    static std::size_t first_of(Queue& queue, const Still& still) {
        while (!queue.empty()) {
            const std::size_t corner = queue.top();
            queue.pop();
            if (still(corner))
                return corner;
        }
        return 0;
    }

    /// The next corner to cut off: the first ear. If there is no ear, it is a corner whose triangle
    /// has no area: a corner on the line between its neighbours, or at the tip of a spike. A face
    /// that crosses itself may have no such corner either.
    std::size_t next_ear() {
        const auto is_ear = [&](std::size_t corner) { return bool(is_ear_[corner]); };
        if (const std::size_t ear = first_of(ears_, is_ear))
            return ear;
        const auto is_flat = [&](std::size_t corner) {
            const auto [a, b, c] = at(corner);
            return !is_cut_[corner] && turn(places_[a], places_[b], places_[c]) == 0;
        };
        if (const std::size_t flat = first_of(flat_, is_flat))
            return flat;
        // Where corners coincide, another corner than the neighbours of the last one cut off may
        // have become an ear.
        if (surveys_ < most_surveys) {
            ++surveys_;
            for (std::size_t i = next_[0]; i != 0; i = next_[i])
                judge(i);
            if (const std::size_t ear = first_of(ears_, is_ear))
                return ear;
        }
        return next_[0];
    }

    void cut(std::size_t corner) {
        triangles_.push_back(at(corner));
        const auto [before, cut_off, after] = at(corner);
        is_ear_[cut_off] = false;
        is_cut_[cut_off] = true;
        next_[before] = after;
        previous_[after] = before;
        --left_;
        tree_.remove(cut_off);
        for (const std::size_t neighbour : {before, after})
            if (neighbour != 0)
                judge(neighbour);
    }

    std::span<const flat_place> places_;
    corner_tree tree_;
    std::vector<std::size_t> next_, previous_;
    std::size_t left_;
    std::vector<bool> is_ear_, is_cut_;
    /// A queue of corners that were ears, or had flat triangles, when they were tested; the lowest
    /// index is on top.
    using queue =
        std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<std::size_t>>;
    queue ears_, flat_;
    /// The largest number of surveys, each of which tests all corners. Faces that cross themselves
    /// run out of ears again and again.
    static constexpr int most_surveys = 16;
    int surveys_ = 0;
    std::vector<flat_face::triangle> triangles_;
};

} // namespace

flat_face::flat_face(const l3d_polygon_mesh& mesh, std::span<const std::uint32_t> face) {
    const l3d_polygon_mesh::vector normal = mesh.area_vector(face);
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(normal[i]) > std::abs(normal[axis]))
            axis = i;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double sign = normal[axis] < 0 ? -1 : 1;
    std::vector<std::array<double, 2>> places;
    for (const std::uint32_t corner : face)
        places.push_back({sign * mesh.vertices[corner][u], mesh.vertices[corner][v]});
    places_ = on_grid(places);
}

std::vector<flat_place> on_grid(std::span<const std::array<double, 2>> places) {
    std::array<double, 2> least = places[0];
    double extent = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        double most = least[i];
        for (const auto& place : places) {
            least[i] = std::min(least[i], place[i]);
            most = std::max(most, place[i]);
        }
        extent = std::max(extent, most - least[i]);
    }
    int exponent = 0;
    std::frexp(extent, &exponent); // extent < 2^exponent
    const auto steps = [&](double x) { return std::llround(std::ldexp(x, 52 - exponent)); };
    std::vector<flat_place> result;
    for (const auto& [u, v] : places)
        result.push_back({steps(u - least[0]), steps(v - least[1])});
    return result;
}

std::vector<flat_face::triangle> flat_face::triangles() const {
    if (!is_convex())
        return ear_clipper(places_).clip();
    std::vector<triangle> fan;
    for (std::size_t i = 2; i < places_.size(); ++i)
        fan.push_back({0, i - 1, i});
    return fan;
}

/// Whether the face is convex: its border turns left everywhere, never back, and goes round once. A
/// border that goes round once reverses its direction along u at most twice.
bool flat_face::is_convex() const {
    const std::size_t n = places_.size();
    int reversals = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const flat_place &a = places_[i], &b = places_[(i + 1) % n], &c = places_[(i + 2) % n];
        const wide_integer turned = turn(a, b, c);
        const wide_integer onward =
            wide_integer{b.u - a.u} * (c.u - b.u) + wide_integer{b.v - a.v} * (c.v - b.v);
        if (turned < 0 || (turned == 0 && onward < 0))
            return false;
        reversals += (b.u < a.u) != (c.u < b.u);
    }
    return reversals <= 2;
}

} // namespace l3d_detail
