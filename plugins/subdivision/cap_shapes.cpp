// SPDX-License-Identifier: MIT
// cap_shapes: subdivides the ring alone ten times more, and compares the cap with the result.
#include "cap_shapes.h"

#include "refined_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace l3d_limit {

namespace far = OpenSubdiv::Far;

face_ring::face_ring(const far::TopologyLevel& level, int face) {
    std::map<int, int> number;
    const auto number_of = [&](int vertex) {
        const auto [at, is_new] = number.try_emplace(vertex, static_cast<int>(vertices.size()));
        if (is_new)
            vertices.push_back(vertex);
        return at->second;
    };
    std::vector<int> faces;
    const auto add = [&](int which, int first) {
        if (std::ranges::find(faces, which) != faces.end())
            return;
        faces.push_back(which);
        const auto of = level.GetFaceVertices(which);
        face_sizes.push_back(of.size());
        for (int k = 0; k < of.size(); ++k)
            corners.push_back(number_of(of[(first + k) % of.size()]));
    };
    add(face, 0);
    const auto own = level.GetFaceVertices(face);
    for (int i = 0; i < own.size(); ++i) {
        // The faces around a vertex run counterclockwise. The list begins with the face itself, so
        // that equal rings have equal shapes.
        const auto around = level.GetVertexFaces(own[i]);
        const auto local = level.GetVertexFaceLocalIndices(own[i]);
        const int begin = std::max(0, around.FindIndex(face));
        for (int k = 0; k < around.size(); ++k) {
            const int at = (begin + k) % around.size();
            add(around[at], local[at]);
        }
    }
    for (int i = 0; i < own.size(); ++i) {
        if (level.GetVertexSharpness(own[i]) > 0) {
            point_vertices.push_back(number_of(own[i]));
            point_sharpness.push_back(level.GetVertexSharpness(own[i]));
        }
        for (const int edge : level.GetVertexEdges(own[i])) {
            if (!(level.GetEdgeSharpness(edge) > 0) || level.IsEdgeBoundary(edge))
                continue;
            const auto ends = level.GetEdgeVertices(edge);
            crease_vertices.push_back(number_of(ends[0]));
            crease_vertices.push_back(number_of(ends[1]));
            crease_sharpness.push_back(level.GetEdgeSharpness(edge));
        }
    }
    shape = face_sizes;
    shape.push_back(-1);
    for (const std::vector<int>* list : {&corners, &crease_vertices, &point_vertices}) {
        shape.insert(shape.end(), list->begin(), list->end());
        shape.push_back(-1);
    }
    for (const std::vector<float>* list : {&crease_sharpness, &point_sharpness})
        for (const float sharpness : *list)
            shape.push_back(std::bit_cast<int>(sharpness));
}

namespace {

/// A point as a weighted sum of a ring's vertices: a weight for each vertex.
struct weighted {
    std::vector<double> of;

    void Clear() { std::ranges::fill(of, 0); }
    void AddWithWeight(const weighted& other, double by) {
        for (std::size_t i = 0; i < of.size(); ++i)
            of[i] += by * other.of[i];
    }
};

/// The weights of one vertex of the ring in each of 16 control points.
net net_of(const std::array<weighted, 16>& points, std::size_t vertex) {
    net result{};
    for (std::size_t k = 0; k < 16; ++k)
        result[k] = points[k].of[vertex];
    return result;
}

/// The bicubic Bezier patch for a Gregory patch's twenty points. Five points belong to each corner:
/// the corner itself, its neighbours on both sides, and two inner points. The bicubic patch has the
/// mean of the two inner points.
net bezier_of_gregory(const std::array<double, 20>& p) {
    const auto middle = [&](std::size_t corner) {
        return (p[5 * corner + 3] + p[5 * corner + 4]) / 2;
    };
    return {p[0],  p[1],      p[7],      p[5],  p[2],  middle(0), middle(1), p[6],
            p[16], middle(3), middle(2), p[12], p[15], p[17],     p[11],     p[10]};
}

/// The deepest level of subdivision that OpenSubdiv's Far has.
constexpr int deepest = 10;

/// The most stages of ten subdivisions each. Around a vertex with any number of faces, a
/// subdivision shrinks lengths to 0.655 or less. So after 40 subdivisions less than 2^-24 of a
/// length is left.
constexpr std::size_t most_stages = 4;

mesh_topology topology_of(const face_ring& ring) {
    return {.vertices = static_cast<int>(ring.vertices.size()),
            .face_sizes = ring.face_sizes,
            .corners = ring.corners,
            .crease_vertices = ring.crease_vertices,
            .crease_sharpness = ring.crease_sharpness,
            .point_vertices = ring.point_vertices,
            .point_sharpness = ring.point_sharpness,
            .holes = {}};
}

/// Subdivides the first face of a mesh that consists of the ring's faces alone.
refined_mesh refined_ring(const face_ring& ring, OpenSubdiv::Sdc::Options options, int levels) {
    constexpr int only[] = {0};
    return {topology_of(ring), options, levels, only};
}

/// A face that is still irregular after some subdivisions of a ring's face.
struct rest {
    face_ring ring;
    /// Vertices of `ring`, as weighted sums of the first ring's vertices.
    std::vector<weighted> vertices;
    double u, v, size; ///< the part of the first ring's face that this face covers
};

} // namespace

struct cap_shapes::weights {
    /// The results of ten subdivisions. Each result is a difference of two points. It is stored as
    /// a row of weights, one weight for each vertex.
    struct stage {
        /// Differences between the control points of exact patches and those of the cap's part.
        std::vector<double> differences;
        /// Differences from the cap's first control point in each face that is still irregular. The
        /// list surface_spread has the differences of all points on which the limit surface
        /// depends. The list cap_spread has the differences of the cap's remaining control points.
        std::vector<double> surface_spread, cap_spread;
    };
    std::size_t vertices = 0;
    std::vector<net> cap; ///< weights of each vertex in the cap's control points
    std::vector<stage> stages;
    std::vector<rest> left; ///< faces that are still irregular after all stages

    weights(const face_ring& ring, OpenSubdiv::Sdc::Options options);
    void add_stage(OpenSubdiv::Sdc::Options options);
};

cap_shapes::weights::weights(const face_ring& ring, OpenSubdiv::Sdc::Options options)
    : vertices(ring.vertices.size()) {
    std::vector<weighted> units(vertices, weighted{std::vector<double>(vertices, 0)});
    for (std::size_t i = 0; i < vertices; ++i)
        units[i].of[i] = 1;
    const refined_mesh flat = refined_ring(ring, options, 0);
    const auto ends = flat.gregory_points(flat.refined(units), flat.leaves().at(0));
    for (std::size_t i = 0; i < vertices; ++i) {
        std::array<double, 20> of_vertex{};
        for (std::size_t k = 0; k < 20; ++k)
            of_vertex[k] = ends[k].of[i];
        cap.push_back(bezier_of_gregory(of_vertex));
    }
    left.push_back({ring, std::move(units), 0, 0, 1});
}

void cap_shapes::weights::add_stage(OpenSubdiv::Sdc::Options options) {
    stage& to = stages.emplace_back();
    std::vector<rest> next;
    for (const rest& from : left) {
        const refined_mesh deep = refined_ring(from.ring, options, deepest);
        const auto points = deep.refined(from.vertices);
        for (const leaf& one : deep.leaves()) {
            const double u = from.u + from.size * one.u, v = from.v + from.size * one.v,
                         size = from.size * one.size;
            std::vector<net> ours;
            for (const net& of_vertex : cap)
                ours.push_back(part_of(of_vertex, u, v, size));
            if (one.is_regular) {
                const auto control = deep.control_points(points, one);
                std::vector<net> exact;
                for (std::size_t i = 0; i < vertices; ++i) {
                    net p = net_of(control, i);
                    reflect_at_boundaries(p, one.boundary);
                    exact.push_back(bezier_of(p));
                }
                for (std::size_t k = 0; k < 16; ++k)
                    for (std::size_t i = 0; i < vertices; ++i)
                        to.differences.push_back(exact[i][k] - ours[i][k]);
                continue;
            }
            face_ring ring(deep.refiner().GetLevel(one.level), one.face);
            std::vector<weighted> of_ring;
            for (const int vertex : ring.vertices)
                of_ring.push_back(
                    points[static_cast<std::size_t>(deep.first_of(one.level) + vertex)]);
            for (const weighted& vertex : of_ring)
                for (std::size_t i = 0; i < vertices; ++i)
                    to.surface_spread.push_back(vertex.of[i] - ours[i][0]);
            for (std::size_t k = 1; k < 16; ++k)
                for (std::size_t i = 0; i < vertices; ++i)
                    to.cap_spread.push_back(ours[i][k] - ours[i][0]);
            next.push_back({std::move(ring), std::move(of_ring), u, v, size});
        }
    }
    left = std::move(next);
}

cap_shapes::cap_shapes(OpenSubdiv::Sdc::Options options) : options_(options) {}
cap_shapes::~cap_shapes() = default;

cap cap_shapes::of(const face_ring& ring, const std::vector<place>& places) {
    std::unique_ptr<weights>& by = kept_[ring.shape];
    if (!by)
        by = std::make_unique<weights>(ring, options_);
    const std::size_t count = by->vertices;
    const auto longest = [&](const std::vector<double>& rows) {
        double most = 0;
        for (std::size_t row = 0; row < rows.size(); row += count) {
            place off{};
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    off[k] += rows[row + i] * places[i][k];
            most = std::max(most, std::hypot(off[0], off[1], off[2]));
        }
        return most;
    };
    cap result;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t point = 0; point < 16; ++point)
                result.bezier[k][point] += by->cap[i][point] * places[i][k];
    for (std::size_t stage = 0;; ++stage) {
        if (stage == by->stages.size())
            by->add_stage(options_);
        const weights::stage& at = by->stages[stage];
        result.error = std::max(result.error, longest(at.differences));
        const double left = longest(at.surface_spread) + longest(at.cap_spread);
        if (left <= result.error || stage + 1 == most_stages) {
            result.error = std::max(result.error, left);
            return result;
        }
    }
}

} // namespace l3d_limit
