// SPDX-License-Identifier: MIT
// Reader and writer of .bpt patch files, and degree elevation.
#include "geom/patch_file.h"

#include "geom/text_cursor_p.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace {

using point = std::array<double, 3>;

std::size_t points_along(int degree) {
    return static_cast<std::size_t>(degree) + 1;
}

/// Reads what a .bpt file holds, after the text has been asked whether it can hold so much.
bool read_patches(l3d_detail::text_cursor& text, std::vector<l3d_patch_points>& patches) {
    std::int64_t count = 0;
    if (!text.integer(count, "the number of patches"))
        return false;
    if (count <= 0)
        return text.fail("the number of patches is " + std::to_string(count) + ", not positive");
    // The least patch has 2 degrees and 4 points, 14 numbers of one digit and one blank.
    constexpr std::size_t shortest = std::size_t{2} * (2 + 4 * 3);
    if (!text.plausible(count, "patches", shortest))
        return false;
    patches.resize(static_cast<std::size_t>(count));
    for (l3d_patch_points& patch : patches) {
        text.set_place(" in patch", static_cast<std::size_t>(&patch - patches.data()) + 1,
                       patches.size());
        std::int64_t degree_u = 0;
        std::int64_t degree_v = 0;
        if (!text.integer_in(degree_u, "the degree in u", 1, l3d_bpt_largest_degree) ||
            !text.integer_in(degree_v, "the degree in v", 1, l3d_bpt_largest_degree))
            return false;
        patch.degree_u = static_cast<int>(degree_u);
        patch.degree_v = static_cast<int>(degree_v);
        patch.points.resize(points_along(patch.degree_u) * points_along(patch.degree_v));
        for (point& p : patch.points)
            for (double& value : p)
                if (!text.coordinate(value))
                    return false;
    }
    return !text.next() || text.fail(l3d_detail::quoted(text.token()) + " follows the last of " +
                                     std::to_string(count) + " patches");
}

/// Raises the degree of the curve in the first degree + 1 places of `line` to 3.
/// Source: Farin, Curves and Surfaces for CAGD: q_i = (i p_{i-1} + (n - i) p_i) / n, n = degree
/// + 1.
void elevate(std::array<point, 4>& line, int degree) {
    for (int n = degree + 1; n <= 3; ++n) {
        const auto last = static_cast<std::size_t>(n);
        line[last] = line[last - 1];
        for (std::size_t i = last - 1; i > 0; --i)
            for (std::size_t k = 0; k < 3; ++k)
                line[i][k] = (static_cast<double>(i) * line[i - 1][k] +
                              static_cast<double>(last - i) * line[i][k]) /
                             n;
    }
}

} // namespace

std::optional<std::vector<l3d_patch_points>> l3d_read_bpt(std::string_view text,
                                                          std::string_view name, std::string& why) {
    l3d_detail::text_cursor cursor(text, name);
    std::vector<l3d_patch_points> patches;
    if (read_patches(cursor, patches))
        return patches;
    why = cursor.why();
    return std::nullopt;
}

std::string l3d_write_bpt(std::span<const l3d_patch_points> patches) {
    std::string text = std::to_string(patches.size()) + '\n';
    for (const l3d_patch_points& patch : patches) {
        text += std::to_string(patch.degree_u) + ' ' + std::to_string(patch.degree_v) + '\n';
        for (const point& p : patch.points) {
            l3d_detail::append(text, p[0], ' ');
            l3d_detail::append(text, p[1], ' ');
            l3d_detail::append(text, p[2], '\n');
        }
    }
    return text;
}

std::optional<std::array<std::array<double, 3>, 16>>
l3d_elevated_to_bicubic(const l3d_patch_points& patch) {
    const auto cubic_or_less = [](int degree) { return degree >= 1 && degree <= 3; };
    if (!cubic_or_less(patch.degree_u) || !cubic_or_less(patch.degree_v))
        return std::nullopt;
    const std::size_t columns = points_along(patch.degree_u);
    const std::size_t rows = points_along(patch.degree_v);
    if (patch.points.size() != columns * rows)
        return std::nullopt;

    std::array<std::array<point, 4>, 4> grid{}; // grid[column][row]
    for (std::size_t row = 0; row < rows; ++row) {
        std::array<point, 4> line{};
        std::copy_n(patch.points.begin() + static_cast<std::ptrdiff_t>(row * columns), columns,
                    line.begin());
        elevate(line, patch.degree_u);
        for (std::size_t column = 0; column < 4; ++column)
            grid[column][row] = line[column];
    }
    std::array<point, 16> result;
    for (std::size_t column = 0; column < 4; ++column) {
        elevate(grid[column], patch.degree_v);
        for (std::size_t row = 0; row < 4; ++row)
            result[4 * row + column] = grid[column][row];
    }
    return result;
}
