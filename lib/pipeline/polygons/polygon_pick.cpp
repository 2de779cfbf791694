// SPDX-License-Identifier: MIT
// l3d_polygon_pick_at: meets triangles with the ray, in coordinates that are 0 along it.
#include "pipeline/polygons/polygon_view.h"

#include "base/formatted_p.h"
#include "base/printable_p.h"
#include "geom/transform.h"

#include <algorithm>
#include <cmath>

namespace {

using vector = l3d_camera::vector;

constexpr double epsilon = 0x1p-53;
/// Bounds the rounding of each coordinate that seen_along_ray computes, as a part of the sum of the
/// magnitudes of its terms. The matrix adds 24 roundings, turning the model 24, products and sums
/// 8.
constexpr double ray_rounding = 64 * epsilon;
constexpr double world_rounding = 32 * epsilon;

double sum_of_magnitudes(const vector& v) {
    return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

vector largest_of(const vector& a, const vector& b) {
    return {std::max(std::abs(a[0]), std::abs(b[0])), std::max(std::abs(a[1]), std::abs(b[1])),
            std::max(std::abs(a[2]), std::abs(b[2]))};
}

/// Maps a point of a model to two coordinates that are 0 on the ray, and to the point's depth.
class seen_along_ray {
public:
    seen_along_ray(const l3d_polygon_model& model, const l3d_polygon_view& view, double x, double y)
        : view_(view), x_(x - view.size().width / 2.0), y_(y - view.size().height / 2.0) {
        const l3d_matrix<double>& m = view.placement();
        reach_ = sum_of_magnitudes(largest_of(model.least(), model.most())) * 3 +
                 sum_of_magnitudes({m(0, 3), m(1, 3), m(2, 3)});
        const l3d_camera& camera = view.camera();
        const double distance = view.is_parallel() ? l3d_length(camera.target - camera.eye) : 1;
        const double scale = camera.focal_length(view.size()) / distance;
        const double terms = reach_ + sum_of_magnitudes(camera.eye);
        error_ = ray_rounding * 3 *
                 (scale * terms +
                  std::max(std::abs(x_), std::abs(y_)) * (view.is_parallel() ? 1 : terms));
    }

    vector operator()(const vector& point) const {
        const auto p = view_.matrix() * l3d_vector<double, 4>(point[0], point[1], point[2], 1.0);
        return {p[0] - x_ * p[3], p[1] - y_ * p[3], p[2]};
    }

    double error() const { return error_; }
    double reach() const { return reach_; }

private:
    const l3d_polygon_view& view_;
    double x_, y_, reach_ = 0, error_ = 0;
};

/// The place where the ray crosses a triangle, as weights of the corners. The weights are in
/// proportion to three areas.
struct crossing {
    std::array<double, 3> weights{};
    double error = 0, depth = 0;

    /// Finds the crossing. Returns false if the ray misses the triangle, or sees it edge on.
    bool find(const std::array<vector, 3>& seen, double error_of_seen) {
        std::array<double, 3> areas{};
        double sum = 0, largest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const vector &a = seen[(i + 1) % 3], &b = seen[(i + 2) % 3];
            areas[i] = a[0] * b[1] - a[1] * b[0];
            sum += areas[i];
            largest = std::max({largest, std::abs(a[0]), std::abs(a[1])});
        }
        const double area_error =
            4 * error_of_seen * (largest + error_of_seen) + 4 * epsilon * largest * largest;
        if (!(std::abs(sum) > 6 * area_error))
            return false;
        const double side = sum > 0 ? 1 : -1;
        // A ray that passes by within the error belongs to this triangle or its neighbour.
        if (std::ranges::any_of(areas, [&](double a) { return side * a < -area_error; }))
            return false;
        for (std::size_t i = 0; i < 3; ++i)
            weights[i] = std::clamp(areas[i] / sum, 0.0, 1.0);
        error = 5 * area_error / (std::abs(sum) - 3 * area_error) + 4 * epsilon;
        depth = weights[0] * seen[0][2] + weights[1] * seen[1][2] + weights[2] * seen[2][2];
        return true;
    }
};

void describe(l3d_polygon_pick& pick, const l3d_polygon_model& model, const l3d_polygon_view& view,
              double rounding) {
    std::array<vector, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
        p[i] = l3d_transformed(view.placement(),
                               l3d_point<double>(model.mesh().vertices[pick.corners[i]]))
                   .from_origin;
        pick.point += p[i] * pick.weights[i];
    }
    const vector a = p[1] - p[0], b = p[2] - p[0];
    const double sides = l3d_length(a) + l3d_length(b);
    pick.point_error = 2 * pick.weights_error * sides + rounding;
    const vector area = l3d_cross(a, b);
    const vector& eye = view.camera().eye;
    const vector towards = view.is_parallel() ? eye - view.camera().target : eye - pick.point;
    const double side = l3d_dot(area, towards) < 0 ? -1 : 1;
    pick.normal = l3d_normalized(area) * side;
    pick.normal_error = 4 * sides * (rounding + epsilon * sides) / l3d_length(area) + 4 * epsilon;
}

} // namespace

std::optional<l3d_polygon_pick> l3d_polygon_pick_at(const l3d_polygon_model& model,
                                                    const l3d_polygon_view& view, bool culls,
                                                    double x, double y) {
    const seen_along_ray ray(model, view, x, y);
    const auto& vertices = model.mesh().vertices;
    std::optional<l3d_polygon_pick> nearest;
    for (const l3d_model_triangle& triangle : model.triangles()) {
        std::array<vector, 3> seen;
        for (std::size_t i = 0; i < 3; ++i)
            seen[i] = ray(vertices[triangle.corners[i]]);
        crossing at;
        if (!at.find(seen, ray.error()) || (nearest && at.depth >= nearest->depth))
            continue;
        const bool is_between = view.is_parallel() || (at.depth >= view.camera().near_z &&
                                                       at.depth <= view.camera().far_z);
        const auto normal = l3d_converted<double>(model.face_normals()[triangle.face]);
        if (!is_between || (culls && !(view.faces_eye(normal, vertices[triangle.corners[0]]) > 0)))
            continue;
        nearest = l3d_polygon_pick{.face = triangle.face,
                                   .corners = triangle.corners,
                                   .weights = at.weights,
                                   .weights_error = at.error,
                                   .depth = at.depth};
    }
    if (!nearest)
        return nearest;
    nearest->part = model.parts().name_of(nearest->face);
    describe(*nearest, model, view, world_rounding * ray.reach());
    return nearest;
}

std::string l3d_polygon_pick::text() const {
    std::string text = "face " + std::to_string(face);
    if (!part.empty())
        text += "\npart " + l3d_detail::printable(part);
    text += "\nvertices";
    for (const std::uint32_t corner : corners)
        text += ' ' + std::to_string(corner);
    const auto add = [&text](const char* name, const auto& numbers, double error) {
        text += name + l3d_detail::formatted(" %.15g %.15g %.15g +- %.2g\n", numbers[0], numbers[1],
                                             numbers[2], error);
    };
    text += '\n';
    add("weights", weights, weights_error);
    add("point", point, point_error);
    add("normal", normal, normal_error);
    return text;
}

std::string l3d_polygon_pick::line() const {
    return (part.empty() ? "" : l3d_detail::printable(part) + ", ") + "face " +
           std::to_string(face) +
           l3d_detail::formatted(" at %.4g, %.4g, %.4g +- %.1g", point[0], point[1], point[2],
                                 point_error);
}
