// SPDX-License-Identifier: MIT
// contour_light: quads around one, looked through for the nearest at a place.
#include "raster/refine/contour_light_p.h"

#include "raster/refine/linear_light_p.h"
#include "raster/surfaces/quad_cut_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace l3d_detail {

namespace {

/// Rows and columns of quads on either side of an edge. Those of 0.25 px are mostly some pixels
/// wide; where they are narrower than a quarter of a pixel, the place is not found.
constexpr int reach = 2;

/// The bends of a polygon's sides; those of a triangle are ab, ac, bc.
struct polygon_bends {
    float ab, ad, bc, dc;
};

using four = std::array<float, 4>;

float cross_of(const four& x, const four& y, std::size_t i, std::size_t k) {
    return x[i] * y[k] - y[i] * x[k];
}

bool of_both_signs(const four& numbers) {
    const auto [least, most] =
        std::pair(std::min(std::min(numbers[0], numbers[1]), std::min(numbers[2], numbers[3])),
                  std::max(std::max(numbers[0], numbers[1]), std::max(numbers[2], numbers[3])));
    return least < 0 && most > 0;
}

/// Twice the areas between the origin and the sides: of one sign if a convex polygon holds it.
four areas_at_sides(const four& x, const four& y) {
    return {cross_of(x, y, 0, 1), cross_of(x, y, 1, 2), cross_of(x, y, 2, 3), cross_of(x, y, 3, 0)};
}

/// Whether a quad's corners turn both ways; `side` has its areas_at_sides.
bool is_folded(const four& x, const four& y, const four& side) {
    const float first = cross_of(x, y, 0, 2), second = cross_of(x, y, 1, 3);
    return of_both_signs({side[3] + side[0] + second, side[0] + side[1] - first,
                          side[1] + side[2] - second, side[2] + side[3] + first});
}

/// Keeps the nearest of the polygons that hold a place.
class nearest_polygon {
public:
    nearest_polygon(float x, float y) : x_(x), y_(y) {}

    /// The part of the quads that are added from now on.
    void use_material(std::uint32_t material) { material_ = material; }

    void add_quad(const l3d_micro_grid& grid, std::size_t p00) {
        shows_both_ = grid.shows_both;
        const std::size_t p01 = p00 + static_cast<std::size_t>(grid.pitch);
        const std::array<std::size_t, 4> at{p00, p00 + 1, p01 + 1, p01};
        four x, y;
        for (std::size_t i = 0; i < at.size(); ++i) {
            x[i] = static_cast<float>(grid.x[at[i]]) - x_;
            y[i] = static_cast<float>(grid.y[at[i]]) - y_;
        }
        const four side = areas_at_sides(x, y);
        if (of_both_signs(side)) {
            if (is_folded(x, y, side))
                add_folded(grid, at);
            return;
        }
        const auto of = [&](const std::vector<float>& numbers) -> four {
            return {numbers[at[0]], numbers[at[1]], numbers[at[2]], numbers[at[3]]};
        };
        add(x, y, of(grid.inv_w), [&](float s, float t) {
            const auto &u = grid.normal[1], &v = grid.normal[2];
            return level_of_quad(of(grid.normal[0]), {u[p00], v[p00], v[p00 + 1], u[p01]}, s, t);
        });
    }

    const surface_light& found() const { return found_; }

private:
    void add_folded(const l3d_micro_grid& grid, const std::array<std::size_t, 4>& at) {
        const quad_corners v{grid.vertex(at[0]), grid.vertex(at[1]), grid.vertex(at[2]),
                             grid.vertex(at[3])};
        cut_folded_levels(v, [&](const std::array<l3d_micro_vertex, 3>& piece) {
            const auto of = [&](const auto& number) -> four {
                return {number(piece[0]), number(piece[1]), number(piece[2]), number(piece[2])};
            };
            const four x = of([&](const auto& c) { return static_cast<float>(c.x) - x_; });
            const four y = of([&](const auto& c) { return static_cast<float>(c.y) - y_; });
            if (of_both_signs(areas_at_sides(x, y)))
                return;
            add(x, y, of([](const auto& c) { return c.inv_w; }), [&](float s, float t) {
                const polygon_bends bends{piece[0].normal[1], piece[0].normal[2],
                                          piece[1].normal[2], 0};
                return level_of_triangle(of([](const auto& c) { return c.normal[0]; }), bends, s,
                                         t);
            });
        });
    }

    /// Adds a polygon that holds the place; level_at(s, t) gives its level at the mean of the
    /// corners and these parts of the diagonals.
    template <class LevelAt>
    void add(const four& x, const four& y, const four& inv_w, const LevelAt& level_at) {
        const float along1_x = x[2] - x[0], along1_y = y[2] - y[0];
        const float along2_x = x[3] - x[1], along2_y = y[3] - y[1];
        const float area2 = along1_x * along2_y - along1_y * along2_x;
        if (area2 == 0)
            return;
        const float mean_x = mean(x), mean_y = mean(y), inverse = 1 / area2;
        const float s = (mean_y * along2_x - mean_x * along2_y) * inverse;
        const float t = (mean_x * along1_y - mean_y * along1_x) * inverse;
        const float depth = mean(inv_w) + s * (inv_w[2] - inv_w[0]) + t * (inv_w[3] - inv_w[1]);
        if (depth > found_.inv_w)
            found_ = {
                linear_light::level_of(shows_both_ && area2 > 0 ? -level_at(s, t) : level_at(s, t)),
                depth, area2 > 0, material_};
    }

    static float mean(const four& of) { return 0.25f * ((of[0] + of[2]) + (of[1] + of[3])); }
    static float within(float part) { return std::clamp(part, 0.0f, 1.0f); }

    /// The bilinear map of the corners' levels and the bends of sides, as pair_measures has it.
    static float level_of_quad(const four& l, const polygon_bends& b, float s, float t) {
        const float u = within(0.5f + s - t), v = within(0.5f + s + t), u1 = 1 - u, v1 = 1 - v;
        return v1 * (u1 * l[0] + u * l[1]) + v * (u1 * l[3] + u * l[2]) +
               4 * (u * u1 * (v1 * b.ab + v * b.dc) + v * v1 * (u1 * b.ad + u * b.bc));
    }
    static float level_of_triangle(const four& l, const polygon_bends& bends, float s, float t) {
        const float b = within(0.25f - t), c = within(0.5f + s + t), a = 1 - b - c;
        return a * l[0] + b * l[1] + c * l[2] +
               4 * (a * b * bends.ab + a * c * bends.ad + b * c * bends.bc);
    }

    float x_, y_; ///< units: 1/256 pixel
    std::uint32_t material_ = 0;
    bool shows_both_ = false;
    surface_light found_;
};

/// Adds the quads around one whose bounding boxes hold the place. Units: 1/256 pixel.
void add_quads(const contour_edge::quad_place& around, std::int32_t x, std::int32_t y,
               nearest_polygon& nearest) {
    const l3d_micro_grid& grid = around.part->grid;
    nearest.use_material(around.part->material);
    const int first_row = std::max(around.row - reach, 0);
    const int last_row = std::min(around.row + reach, grid.rows - 1);
    const int first_column = std::max(around.column - reach, 0);
    const int last_column = std::min(around.column + reach, grid.columns - 1);
    // A box holds the place if it has corners on all four sides of it.
    enum side : int { on_right = 1, on_left = 2, below = 4, above = 8, all = 15 };
    std::array<int, 2 * reach> row_above{};
    for (int row = first_row; row <= last_row; ++row) {
        const std::size_t at = grid.index(row, first_column);
        const std::int32_t *const row_x = grid.x.data() + at, *const row_y = grid.y.data() + at;
        const auto sides_of = [&](int i) {
            return (row_x[i] > x ? on_right : on_left) | (row_y[i] > y ? below : above);
        };
        int before = sides_of(0);
        for (int i = 0; i < last_column - first_column; ++i) {
            const int next = sides_of(i + 1), both = before | next;
            int& up = row_above[static_cast<std::size_t>(i)];
            if (row > first_row && (both | up) == all)
                nearest.add_quad(grid, grid.index(row - 1, first_column + i));
            up = both;
            before = next;
        }
    }
}

} // namespace

bool find_light(const contour_pixel& pixel, picture_place place, surface_light& found) {
    const float x = place.x * l3d_subpixel_one, y = place.y * l3d_subpixel_one;
    nearest_polygon nearest(x, y);
    for (const contour_edge::quad_place& around : {pixel.beside, pixel.also})
        if (around.part != nullptr)
            add_quads(around, static_cast<std::int32_t>(std::floor(x)),
                      static_cast<std::int32_t>(std::floor(y)), nearest);
    found = nearest.found();
    return found.inv_w > 0;
}

namespace {

constexpr float centre = 0.5f;

/// A straight contour: a place is on its right if the product of its way from the pixel's centre
/// with (x, y), plus to_centre, is positive.
struct contour_line {
    float x, y, to_centre;

    explicit contour_line(const contour_pixel& pixel)
        : x(-part(pixel.along_y)), y(part(pixel.along_x)), to_centre(part(pixel.to_centre)) {}

private:
    static float part(std::int32_t units) {
        return static_cast<float>(units) * (1.0f / contour_pixel::whole);
    }
};

} // namespace

picture_place middle_on_right(const contour_pixel& pixel) {
    contour_line line(pixel);
    const bool is_steep = std::abs(line.x) > std::abs(line.y);
    if (is_steep)
        std::swap(line.x, line.y);
    if (line.y == 0)
        return place_on_right(pixel);
    // Two columns that give the mean of a cubic (Gauss); in each, the part from the contour on.
    constexpr float aside = 0.28867513f;
    float area = 0, x = 0, y = 0;
    for (const float column : {-aside, aside}) {
        const float cut = std::clamp(-(line.to_centre + line.x * column) / line.y, -0.5f, 0.5f);
        const float from = line.y > 0 ? cut : -0.5f, to = line.y > 0 ? 0.5f : cut;
        area += to - from;
        x += (to - from) * column;
        y += 0.5f * (to - from) * (to + from);
    }
    if (!(area > 0))
        return place_on_right(pixel);
    x /= area;
    y /= area;
    if (is_steep)
        std::swap(x, y);
    return {static_cast<float>(pixel.x) + centre + x, static_cast<float>(pixel.y) + centre + y};
}

picture_place place_on_right(const contour_pixel& pixel) {
    const contour_line line(pixel);
    const float square = line.x * line.x + line.y * line.y;
    const float length = std::sqrt(square);
    const float way = square > 0 ? (length / 16 - line.to_centre) / square : 0;
    return {static_cast<float>(pixel.x) + centre + way * line.x,
            static_cast<float>(pixel.y) + centre + way * line.y};
}

} // namespace l3d_detail
