// SPDX-License-Identifier: MIT
// flat_face: convex faces as fans, others ear by ear.
#include "pipeline/polygons/flat_face_p.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace l3d_detail {

namespace {

/// The corners of a face that are not cut off yet, in a ring.
class ear_clipper {
public:
    explicit ear_clipper(std::span<const flat_place> places)
        : places_(places), tree_(places), next_(places.size()), previous_(places.size()),
          left_(places.size()), is_ear_(places.size()) {
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
        const auto [a, b, c] = at(corner);
        is_ear_[corner] = turn(places_[a], places_[b], places_[c]) > 0 && !tree_.any_in({a, b, c});
        if (is_ear_[corner])
            ears_.push(corner);
    }

    /// The ear that comes first; the corner after corner 0 of a face that crosses itself and may
    /// have none. Corner 0 is never cut off.
    std::size_t next_ear() {
        while (!ears_.empty()) {
            const std::size_t ear = ears_.top();
            ears_.pop();
            if (is_ear_[ear])
                return ear;
        }
        return next_[0];
    }

    void cut(std::size_t corner) {
        triangles_.push_back(at(corner));
        const auto [before, cut_off, after] = at(corner);
        is_ear_[cut_off] = false;
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
    std::vector<bool> is_ear_;
    /// Those that were ears when they were judged, the first on top.
    std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> ears_;
    std::vector<flat_face::triangle> triangles_;
};

} // namespace

l3d_polygon_mesh::vector area_vector(const l3d_polygon_mesh& mesh,
                                     std::span<const std::uint32_t> face) {
    l3d_polygon_mesh::vector sum{0.0, 0.0, 0.0};
    const l3d_polygon_mesh::vector& first = mesh.vertices[face[0]];
    for (std::size_t i = 2; i < face.size(); ++i)
        sum += l3d_cross(mesh.vertices[face[i - 1]] - first, mesh.vertices[face[i]] - first);
    return sum;
}

flat_face::flat_face(const l3d_polygon_mesh& mesh, std::span<const std::uint32_t> face) {
    const l3d_polygon_mesh::vector normal = area_vector(mesh, face);
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(normal[i]) > std::abs(normal[axis]))
            axis = i;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double sign = normal[axis] < 0 ? -1 : 1;
    for (const std::uint32_t corner : face)
        places_.push_back({sign * mesh.vertices[corner][u], mesh.vertices[corner][v]});
}

std::vector<flat_face::triangle> flat_face::triangles() const {
    if (!is_convex())
        return ear_clipper(places_).clip();
    std::vector<triangle> fan;
    for (std::size_t i = 2; i < places_.size(); ++i)
        fan.push_back({0, i - 1, i});
    return fan;
}

/// Turns left everywhere, and goes round once: right, then left along u.
bool flat_face::is_convex() const {
    const std::size_t n = places_.size();
    int reversals = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n, k = (i + 2) % n;
        if (turn(places_[i], places_[j], places_[k]) < 0)
            return false;
        reversals += (places_[j].u < places_[i].u) != (places_[k].u < places_[j].u);
    }
    return reversals <= 2;
}

} // namespace l3d_detail
