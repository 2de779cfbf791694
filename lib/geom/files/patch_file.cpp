// SPDX-License-Identifier: MIT
// Reads and writes .bpt patch files, and raises or reduces degrees to 3.
#include "geom/files/patch_file.h"

#include "geom/files/text_cursor_p.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace {

using point = std::array<double, 3>;

std::size_t points_along(int degree) {
    return static_cast<std::size_t>(degree) + 1;
}

/// Reads the patches of a .bpt file, after a check that the text can hold as many as it promises.
bool read_patches(l3d_detail::text_cursor& text, std::vector<l3d_patch_points>& patches) {
    std::int64_t count = 0;
    if (!text.integer(count, "the number of patches"))
        return false;
    if (count <= 0)
        return text.fail("the number of patches is " + std::to_string(count) + ", not positive");
    // The shortest patch has 2 degrees and 4 points: 14 numbers of one digit and one blank.
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
        const bool is_rational = text.take_in_line("rational");
        for (point& p : patch.points) {
            for (double& value : p)
                if (!text.coordinate(value))
                    return false;
            if (is_rational && !text.weight(patch.weights.emplace_back()))
                return false;
        }
    }
    return !text.next() || text.fail(l3d_detail::quoted(text.token()) + " follows the last of " +
                                     std::to_string(count) + " patches");
}

/// Raises the degree of the curve in the first degree + 1 places of `line` to `target`.
/// Source: Farin, Curves and Surfaces for CAGD: q_i = (i p_{i-1} + (n - i) p_i) / n, n = degree
/// + 1.
void elevate(std::span<point> line, int degree, int target) {
    for (int n = degree + 1; n <= target; ++n) {
        const auto last = static_cast<std::size_t>(n);
        line[last] = line[last - 1];
        for (std::size_t i = last - 1; i > 0; --i)
            for (std::size_t k = 0; k < 3; ++k)
                line[i][k] = (static_cast<double>(i) * line[i - 1][k] +
                              static_cast<double>(last - i) * line[i][k]) /
                             n;
    }
}

/// Brings the curve in the first degree + 1 places of `line` to degree 3 in the first four places.
/// Returns false if this would move the curve by more than `rounding`.
bool make_cubic(std::vector<point>& line, int degree, double rounding) {
    if (degree <= 3) {
        elevate(line, degree, 3);
        return true;
    }
    // A single cubic has the ends and the end derivatives of the curve, degree (p_1 - p_0).
    const auto n = static_cast<std::size_t>(degree);
    std::vector<point> cubic{line[0], {}, {}, line[n]};
    for (std::size_t k = 0; k < 3; ++k) {
        cubic[1][k] = line[0][k] + degree * (line[1][k] - line[0][k]) / 3;
        cubic[2][k] = line[n][k] + degree * (line[n - 1][k] - line[n][k]) / 3;
    }
    std::vector<point> raised = cubic;
    raised.resize(n + 1);
    elevate(raised, 3, degree);
    for (std::size_t i = 0; i <= n; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (std::abs(raised[i][k] - line[i][k]) > rounding)
                return false;
    std::ranges::copy(cubic, line.begin());
    return true;
}

} // namespace

std::optional<std::vector<l3d_patch_points>> l3d_read_bpt(std::string_view text,
                                                          std::string_view name, std::string& why) {
    l3d_detail::text_cursor cursor(text, name, '#');
    std::vector<l3d_patch_points> patches;
    if (read_patches(cursor, patches))
        return patches;
    why = cursor.why();
    return std::nullopt;
}

std::string l3d_write_bpt(std::span<const l3d_patch_points> patches) {
    std::string text = std::to_string(patches.size()) + '\n';
    for (const l3d_patch_points& patch : patches) {
        const bool is_rational = !patch.weights.empty();
        text += std::to_string(patch.degree_u) + ' ' + std::to_string(patch.degree_v) +
                (is_rational ? " rational\n" : "\n");
        for (std::size_t i = 0; i < patch.points.size(); ++i) {
            const point& p = patch.points[i];
            l3d_detail::append(text, p[0], ' ');
            l3d_detail::append(text, p[1], ' ');
            l3d_detail::append(text, p[2], is_rational ? ' ' : '\n');
            if (is_rational)
                l3d_detail::append(text, patch.weights[i], '\n');
        }
    }
    return text;
}

std::optional<std::array<std::array<double, 3>, 16>> l3d_as_bicubic(const l3d_patch_points& patch) {
    const auto well = [](int degree) { return degree >= 1 && degree <= l3d_bpt_largest_degree; };
    // A weight that all points share has no effect.
    const auto is_first = [&](double weight) { return weight == patch.weights.front(); };
    if (!well(patch.degree_u) || !well(patch.degree_v) ||
        !std::ranges::all_of(patch.weights, is_first))
        return std::nullopt;
    const std::size_t columns = points_along(patch.degree_u);
    const std::size_t rows = points_along(patch.degree_v);
    if (patch.points.size() != columns * rows)
        return std::nullopt;

    // Raising a degree 12 times rounds a coordinate 36 times, each time by 2^-53. The cubic's inner
    // points take 1 + 2 * 5 roundings. Points of the file may have been rounded as often:
    // 2 * 36 + 11 is less than 2^7.
    double largest = 0;
    for (const point& p : patch.points)
        for (const double value : p)
            largest = std::max(largest, std::abs(value));
    const double rounding = 0x1p-46 * largest;

    std::array<std::vector<point>, 4> grid; // grid[column][row]
    for (std::size_t row = 0; row < rows; ++row) {
        const auto first = patch.points.begin() + static_cast<std::ptrdiff_t>(row * columns);
        std::vector<point> line(first, first + static_cast<std::ptrdiff_t>(columns));
        line.resize(std::max<std::size_t>(columns, 4));
        if (!make_cubic(line, patch.degree_u, rounding))
            return std::nullopt;
        for (std::size_t column = 0; column < 4; ++column)
            grid[column].push_back(line[column]);
    }
    std::array<point, 16> result;
    for (std::size_t column = 0; column < 4; ++column) {
        grid[column].resize(std::max<std::size_t>(rows, 4));
        if (!make_cubic(grid[column], patch.degree_v, rounding))
            return std::nullopt;
        for (std::size_t row = 0; row < 4; ++row)
            result[4 * row + column] = grid[column][row];
    }
    return result;
}
