// SPDX-License-Identifier: MIT
// l3d_height_patches: makes Catmull-Rom splines along rows, then along columns.
#include "geom/files/patch_file.h"

#include "base/error.h"
#include "base/formatted_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace {

/// Control heights of the Catmull-Rom spline through heights: each height, and two between
/// neighbours. Control heights beside a missing height are NaN.
std::vector<double> control_heights(const std::vector<double>& through) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const auto at = [&](std::size_t i) { return i < through.size() ? through[i] : nothing; };
    const auto third_of_slope = [&](std::size_t i) { // control points lie a third of a step away
        const double before = at(i - 1), here = at(i), after = at(i + 1); // at(-1) is NaN
        if (std::isnan(before))
            return (after - here) / 3;
        return std::isnan(after) ? (here - before) / 3 : (after - before) / 6;
    };
    std::vector<double> result{through[0]};
    for (std::size_t i = 0; i + 1 < through.size(); ++i) {
        const bool is_there = !std::isnan(through[i]) && !std::isnan(through[i + 1]);
        result.push_back(is_there ? through[i] + third_of_slope(i) : nothing);
        result.push_back(is_there ? through[i + 1] - third_of_slope(i + 1) : nothing);
        result.push_back(through[i + 1]);
    }
    return result;
}

} // namespace

std::string l3d_height_field::complaint() const {
    using l3d_detail::formatted;
    if (columns < 2 || heights.size() < 2 * columns || heights.size() % columns != 0)
        return formatted("height field: %zu heights make no two or more whole rows of %zu columns",
                         heights.size(), columns);
    const auto longest = static_cast<double>(std::max(columns, heights.size() / columns));
    if (!(spacing > 0 && spacing * longest <= l3d_bpt_largest_coordinate))
        return formatted("height field: a spacing of %g is not positive, or makes it wider than "
                         "1e12",
                         spacing);
    for (std::size_t i = 0; i < heights.size(); ++i)
        if (std::abs(heights[i]) > l3d_bpt_largest_coordinate)
            return formatted("height field: the height in row %zu, column %zu is %g, beyond 1e12",
                             i / columns + 1, i % columns + 1, heights[i]);
    return "";
}

std::vector<l3d_patch_points> l3d_height_patches(const l3d_height_field& field) {
    const std::string why = field.complaint();
    if (!why.empty())
        throw l3d_error(l3d_exit::bad_input, why);
    const std::size_t rows = field.heights.size() / field.columns;
    std::vector<std::vector<double>> along_rows;
    for (std::size_t r = 0; r < rows; ++r) {
        const double* const first = field.heights.data() + r * field.columns;
        along_rows.push_back(control_heights({first, first + field.columns}));
    }
    const std::size_t wide = along_rows[0].size();
    std::vector<std::vector<double>> along_columns;
    for (std::size_t c = 0; c < wide; ++c) {
        std::vector<double> through(rows);
        for (std::size_t r = 0; r < rows; ++r)
            through[r] = along_rows[r][c];
        along_columns.push_back(control_heights(through));
    }
    // Neighbouring patches compute the same place from the same whole multiple of a third of the
    // spacing.
    const auto place = [&](std::size_t third, std::size_t heights) {
        return (static_cast<double>(third) - 1.5 * static_cast<double>(heights - 1)) *
               (field.spacing / 3);
    };
    std::vector<l3d_patch_points> result;
    for (std::size_t r = 0; r + 1 < rows; ++r)
        for (std::size_t c = 0; c + 1 < field.columns; ++c) {
            l3d_patch_points patch{3, 3, {}};
            for (std::size_t v = 0; v < 4; ++v)
                for (std::size_t u = 0; u < 4; ++u) { // u along z, v along x: normals along y
                    const std::size_t x = 3 * c + v, z = 3 * r + u;
                    patch.points.push_back(
                        {place(x, field.columns), along_columns[x][z], place(z, rows)});
                }
            if (std::ranges::none_of(
                    patch.points, [](const std::array<double, 3>& p) { return std::isnan(p[1]); }))
                result.push_back(std::move(patch));
        }
    return result;
}
