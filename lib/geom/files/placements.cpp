// SPDX-License-Identifier: MIT
// l3d_flattened, l3d_shape_of: copy a model's shapes to their places, or take out one shape.
#include "geom/files/model_file.h"

#include "geom/transform.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace {

using matrix = l3d_matrix<double>;

l3d_vector<double, 3> placed(const matrix& place, double x, double y, double z) {
    return l3d_transformed(place, l3d_point<double>(x, y, z)).from_origin;
}

l3d_nurbs_curve placed(const matrix& place, const l3d_nurbs_curve& curve) {
    std::vector<l3d_nurbs_curve::vector> points;
    points.reserve(curve.points().size());
    for (const auto& p : curve.points())
        points.push_back(placed(place, p[0], p[1], p[2]));
    return {curve.along(), std::move(points), curve.weights()};
}

/// Adds copies of one model's shapes to another model, at places.
class placer {
public:
    placer(const l3d_model_file& from, l3d_model_file& to) : from_(from), to_(to) {}

    void add(const l3d_model_placement& at) {
        const auto number =
            numbers_.try_emplace(numbers_of(at.place), numbers_.size()).first->second;
        const bool is_last = at.shape + 1 == from_.shapes.size();
        const l3d_model_shape first = from_.shapes[at.shape];
        const l3d_model_shape end =
            is_last ? l3d_model_shape{static_cast<std::uint32_t>(from_.patches.size()),
                                      static_cast<std::uint32_t>(from_.curves.size())}
                    : from_.shapes[at.shape + 1];
        const auto look = [&](std::uint32_t own) {
            return own == l3d_material_of_place ? at.material : own;
        };
        double squares = 0; // lengths grow by at most its root
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                squares += at.place(row, column) * at.place(row, column);
        const double stretch = std::sqrt(squares);
        to_.patch_parts.push_back({at.name, static_cast<std::uint32_t>(to_.patches.size())});
        for (std::size_t i = first.first_patch; i < end.first_patch; ++i) {
            l3d_patch_points& patch = to_.patches.emplace_back(from_.patches[i]);
            for (auto& p : patch.points) {
                const auto q = placed(at.place, p[0], p[1], p[2]);
                p = {q[0], q[1], q[2]};
            }
            for (l3d_trim_loop& loop : patch.trims)
                for (l3d_trim_curve& curve : loop)
                    if (curve.edge != l3d_no_edge)
                        curve.edge = edge(curve.edge, at.place, number);
            if (!from_.patch_errors.empty()) {
                to_.patch_errors.push_back(from_.patch_errors[i]);
                to_.patch_errors.back().places *= stretch;
            }
            if (!from_.patch_faces.empty())
                to_.patch_faces.push_back(from_.patch_faces[i]);
            if (!from_.patch_materials.empty())
                to_.patch_materials.push_back(look(from_.patch_materials[i]));
        }
        for (std::size_t i = first.first_curve; i < end.first_curve; ++i) {
            to_.curves.push_back(placed(at.place, from_.curves[i]));
            if (!from_.curve_materials.empty())
                to_.curve_materials.push_back(look(from_.curve_materials[i]));
        }
    }

private:
    static std::array<double, 12> numbers_of(const matrix& place) {
        std::array<double, 12> result{};
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = place(static_cast<int>(i / 4), static_cast<int>(i % 4));
        return result;
    }

    /// The index of the copy of edge `of` that stands at a place. Shapes at one place share this
    /// copy.
    std::uint32_t edge(std::uint32_t of, const matrix& place, std::size_t number) {
        const auto next = static_cast<std::uint32_t>(to_.edges.size());
        const auto [at, is_new] = edges_.try_emplace({number, of}, next);
        if (is_new)
            to_.edges.push_back({placed(place, from_.edges[of].curve), from_.edges[of].tolerance});
        return at->second;
    }

    const l3d_model_file& from_;
    l3d_model_file& to_;
    /// A number for each place, by the matrix's rows.
    std::map<std::array<double, 12>, std::size_t> numbers_;
    std::map<std::pair<std::size_t, std::uint32_t>, std::uint32_t> edges_;
};

} // namespace

l3d_model_file l3d_flattened(const l3d_model_file& model) {
    if (model.placements.empty())
        return model;
    l3d_model_file result = model;
    result.patches.clear();
    result.patch_errors.clear();
    result.patch_faces.clear();
    result.patch_materials.clear();
    result.patch_parts.clear();
    result.curves.clear();
    result.curve_materials.clear();
    result.edges.clear();
    result.shapes.clear();
    result.placements.clear();
    placer to(model, result);
    for (const l3d_model_placement& at : model.placements)
        to.add(at);
    return result;
}

l3d_model_file l3d_shape_of(const l3d_model_file& model, std::size_t shape,
                            std::uint32_t material) {
    l3d_model_file result;
    result.mesh.materials = model.mesh.materials;
    result.mesh.looks = model.mesh.looks;
    l3d_model_placement at;
    at.shape = static_cast<std::uint32_t>(shape);
    at.material = material;
    placer(model, result).add(at);
    result.patch_parts.clear();
    return result;
}
