// SPDX-License-Identifier: MIT
// Makes the shapes of nurbs: a revolved profile, a B-spline sheet, and the library's exact shapes.
#include "shapes.h"

#include <array>
#include <utility>

namespace {

/// The vase of the tutorial: a cubic profile, from the middle of the foot up to the lip, revolved.
std::vector<l3d_nurbs_surface> vase() {
    std::vector<l3d_nurbs_curve::vector> profile{{0, 0, 0},       {0.3, 0, 0},    {0.5, 0, 0},
                                                 {0.45, 0.15, 0}, {1.1, 0.7, 0},  {0.8, 1.6, 0},
                                                 {0.2, 2.0, 0},   {0.35, 2.5, 0}, {0.6, 2.6, 0}};
    const l3d_bspline_direction along = l3d_bspline_direction::clamped(3, profile.size());
    return {l3d_revolved({along, std::move(profile)})};
}

/// A bicubic sheet of 6 by 5 control points, with a hill beside its middle.
std::vector<l3d_nurbs_surface> sheet() {
    constexpr std::size_t columns = 6, rows = 5;
    std::vector<l3d_nurbs_surface::vector> points;
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const bool is_hill = row == 2 && (column == 2 || column == 3);
            points.push_back({static_cast<double>(column) - 2.5, is_hill ? 1.8 : 0.0,
                              2.0 - static_cast<double>(row)});
        }
    return {{l3d_bspline_direction::clamped(3, columns), l3d_bspline_direction::clamped(3, rows),
             std::move(points)}};
}

constexpr std::array<std::pair<std::string_view, std::vector<l3d_nurbs_surface> (*)()>, 2> own{
    {{"vase", vase}, {"sheet", sheet}}};

} // namespace

std::size_t shape_count() {
    return own.size() + l3d_exact_shape_names().size();
}

shape shape_at(std::size_t index) {
    if (index < own.size())
        return {own[index].first, own[index].second()};
    const std::string_view name = l3d_exact_shape_names()[index - own.size()];
    return {name, *l3d_exact_shape(name)};
}
