// SPDX-License-Identifier: MIT
// l3d_point_place_of, l3d_draw_point: draw one triangle around a pixel's centre.
#include "dice/point_patch.h"

#include "dice/error_color.h"
#include "dice/grid_light.h"
#include "dice/normal_columns.h"
#include "raster/pixel_centres.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

/// The corners of the triangle that draws a point, in sub-pixels from the pixel's centre. No
/// smaller triangle of whole numbers holds the centre inside.
constexpr std::array<std::array<std::int32_t, 2>, 3> triangle_places{{{-1, -1}, {1, -1}, {0, 1}}};
constexpr double extent = 1.5 / l3d_subpixel_one;

bool far_apart(const l3d_image_point& a, const l3d_image_point& b, double limit) {
    return l3d_far_apart(a, b, 0, limit) || l3d_far_apart(a, b, 1, limit);
}

/// Finds the only pixel whose centre lies between two places along x or y, even if snapping moved
/// the places. Returns nothing if there is none, or more than one.
std::optional<std::int32_t> only_centre(double low, double high, double corner) {
    const auto centres = l3d_centres_near(low, high, corner);
    if (!centres.only_one())
        return std::nullopt;
    return static_cast<std::int32_t>(centres.first);
}

} // namespace

std::optional<l3d_point_place> l3d_point_place_of(const l3d_image_net& net,
                                                  const l3d_dice_view& view) {
    if (far_apart(net.at(0, 0), net.at(3, 3), view.tolerance) ||
        far_apart(net.at(0, 3), net.at(3, 0), view.tolerance))
        return std::nullopt;
    const l3d_depth_range& depth = net.w();
    if (depth.least <= view.near || depth.most >= view.far || !view.section.leaves(net.points) ||
        depth.most - depth.least > view.depth_of_point(depth.least))
        return std::nullopt;
    const l3d_image_box& box = net.box();
    const double transformed =
        l3d_vertex_error(view.error_xy, view.error_w, box.reach(), depth.least);
    const double bound = std::hypot(box.width(), box.height()) + extent + transformed;
    if (!(bound <= std::min(view.tolerance, 1.0)))
        return std::nullopt;
    const auto column = only_centre(box.left, box.right, view.window().left);
    const auto row = only_centre(box.top, box.bottom, view.window().top);
    if (!column || !row)
        return std::nullopt;
    // Snapping moves places towards a centre that may be outside of the box.
    const double x = view.window().left + *column + 0.5, y = view.window().top + *row + 0.5;
    const double farthest = std::hypot(std::max(std::abs(x - box.left), std::abs(x - box.right)),
                                       std::max(std::abs(y - box.top), std::abs(y - box.bottom))) +
                            extent + transformed;
    if (!(farthest <= view.tolerance))
        return std::nullopt;
    return l3d_point_place{*column * l3d_subpixel_one + l3d_subpixel_one / 2,
                           *row * l3d_subpixel_one + l3d_subpixel_one / 2, farthest};
}

void l3d_draw_point(const l3d_point_place& place, const l3d_image_patch& net,
                    const l3d_normal_net::vector& normal, const l3d_dice_view& view,
                    l3d_piece_pool& out, l3d_dice_counts& counts) {
    constexpr double middle = 0.5;
    l3d_diced_piece& piece = out.next();
    const double w = net.evaluate(middle, middle)[2];
    const std::array<float, 3> unit = l3d_unit_normal(normal);
    float lit[3] = {unit[0], unit[1], unit[2]};
    if (l3d_light_vertex(view, net.evaluate(middle, middle), lit))
        for (float& number : lit)
            number = -number;
    std::array<l3d_dice_vertex, 3> triangle;
    for (std::size_t i = 0; i < triangle.size(); ++i) {
        triangle[i].vertex = {place.x + triangle_places[i][0],
                              place.y + triangle_places[i][1],
                              view.depth_at(w),
                              {lit[0], lit[1], lit[2]}};
        triangle[i].u = triangle[i].v = middle;
    }
    piece.add_triangle(triangle[0], triangle[1], triangle[2]);
    piece.bound = place.bound;
    piece.part.error_color = l3d_error_color(place.bound, view.tolerance);
    counts.bound_px = std::max(counts.bound_px, place.bound);
    ++counts.drawn;
    ++counts.as_points;
    ++counts.pieces;
    ++counts.samples;
}
