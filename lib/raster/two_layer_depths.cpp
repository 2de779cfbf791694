// SPDX-License-Identifier: MIT
// l3d_two_layer_depths: keeps the two nearest sheets of each pixel.
#include "raster/two_layer_depths.h"

#include "raster/shapes/attribute_plane_p.h"

#include <algorithm>
#include <cmath>

namespace {

using namespace l3d_detail;

/// The thickness below which a polygon counts as a slit, as its slope says nothing about the
/// surface. Slopes are limited: over this length, depth changes by at most the difference of the
/// polygon's largest and least depth. Units: pixels.
constexpr double thinnest = 0.25;

/// The rounding of 1 / w. The division, the scale, the means of corners and the pixel's own value
/// each add half of 2^-23.
constexpr double rounding = 4 * 0x1p-24;

scan_point place_of(const l3d_micro_vertex& v) {
    return {v.x, v.y};
}

std::int64_t twice_area(const l3d_micro_vertex& a, const l3d_micro_vertex& b,
                        const l3d_micro_vertex& c) {
    return cross(place_of(b) - place_of(a), place_of(c) - place_of(a));
}

} // namespace

bool l3d_sheet_patch::meets(const l3d_sheet_patch& other) const {
    return instance == other.instance &&
           (patch == other.patch ||
            std::binary_search(touching.begin(), touching.end(), other.patch));
}

void l3d_two_layer_depths::begin(l3d_size size, double focal, double depth_by_pixel) {
    size_ = size;
    focal_ = focal;
    depth_by_pixel_ = depth_by_pixel;
    patches_.clear();
    pixels_.assign(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height),
                   {});
    scan_.set_rows({0, size.height});
}

void l3d_two_layer_depths::add(const l3d_surface_part& part, const l3d_sheet_patch& of) {
    const auto owner = static_cast<std::uint32_t>(kinds * patches_.size());
    patches_.push_back(of);
    const l3d_micro_grid& grid = part.grid;
    for (int row = 0; row + 1 < grid.rows; ++row)
        for (int column = 0; column + 1 < grid.columns; ++column) {
            if (grid.is_cut(grid.index(row, column)))
                continue;
            const bool is_rim =
                row == 0 || column == 0 || row + 2 == grid.rows || column + 2 == grid.columns;
            add_quad(grid.vertex(row, column), grid.vertex(row, column + 1),
                     grid.vertex(row + 1, column + 1), grid.vertex(row + 1, column),
                     owner + (is_rim ? rim : inner));
        }
    // The triangles of a part without a grid are a clipped piece, whose sides may be on its rim.
    const std::uint32_t of_triangles = grid.rows > 0 ? slit : rim;
    for (std::size_t i = 0; i < part.triangles.count; ++i)
        add_triangle(part.triangles.vertex(i, 0), part.triangles.vertex(i, 1),
                     part.triangles.vertex(i, 2), owner + of_triangles);
}

/// Adds a quad as two triangles, which do not overlap unless the quad is folded.
void l3d_two_layer_depths::add_quad(const l3d_micro_vertex& a, const l3d_micro_vertex& b,
                                    const l3d_micro_vertex& c, const l3d_micro_vertex& d,
                                    std::uint32_t owner) {
    const bool by_ac = (twice_area(a, b, c) > 0) == (twice_area(a, c, d) > 0);
    const bool by_bd = (twice_area(a, b, d) > 0) == (twice_area(b, c, d) > 0);
    if (by_ac || !by_bd) {
        add_triangle(a, b, c, owner);
        add_triangle(a, c, d, owner);
    } else {
        add_triangle(a, b, d, owner);
        add_triangle(b, c, d, owner);
    }
}

void l3d_two_layer_depths::add_triangle(const l3d_micro_vertex& a, const l3d_micro_vertex& b,
                                        const l3d_micro_vertex& c, std::uint32_t owner) {
    const std::int64_t area = twice_area(a, b, c);
    const std::array<scan_point, 3> corners{place_of(a), place_of(b), place_of(c)};
    if (area == 0)
        return;
    const scan_rows rows = scan_.convert(std::span<const scan_point, 3>(corners), area > 0);
    constexpr std::int32_t one = l3d_subpixel_one, half = one / 2;
    const std::int32_t left = std::max(0, first_centre(std::min({a.x, b.x, c.x})));
    const std::int64_t x0 = std::int64_t{left} * one + half,
                       y0 = std::int64_t{rows.top} * one + half;
    const double to_b = double{b.inv_w} - a.inv_w, to_c = double{c.inv_w} - a.inv_w;
    const double unit = static_cast<double>(one) / static_cast<double>(area);
    const auto d = [](std::int64_t p, std::int64_t q) { return static_cast<double>(p - q); };
    const double plane_x = (to_b * d(c.y, a.y) - to_c * d(b.y, a.y)) * unit;
    const double plane_y = (to_c * d(b.x, a.x) - to_b * d(c.x, a.x)) * unit;
    const double start = a.inv_w + (plane_x * d(x0, a.x) + plane_y * d(y0, a.y)) / one;
    const auto [least, most] = std::minmax<double>({a.inv_w, b.inv_w, c.inv_w});
    const double steepest = (most - least) / thinnest;
    const auto along_x = static_cast<float>(std::clamp(plane_x, -steepest, steepest));
    const auto along_y = static_cast<float>(std::clamp(plane_y, -steepest, steepest));
    for (std::int32_t y = rows.top; y < rows.bottom; ++y)
        for (std::int32_t x = std::max(scan_.first(y), 0),
                          end = std::min(scan_.last(y), size_.width);
             x < end; ++x) {
            const double inv_w =
                std::clamp(start + plane_x * (x - left) + plane_y * (y - rows.top), least, most);
            put(pixels_[place(x, y)], {static_cast<float>(inv_w), along_x, along_y, owner}, x, y);
        }
}

void l3d_two_layer_depths::put(pixel& into, const fragment& f, int x, int y) const {
    if (f.inv_w > into.front.inv_w) {
        into.gap = std::min(gap_between(f, into.front, x, y), gap_between(f, into.second, x, y));
        into.second = into.front;
        into.front = f;
        return;
    }
    into.gap = std::min(into.gap, gap_between(into.front, f, x, y));
    if (f.inv_w > into.second.inv_w)
        into.second = f;
}

/// Whether two fragments of a pixel may be one sheet, whose overlapping polygons cover the pixel
/// twice. Quads of the same patch count as two sheets, since they meet where the patch cuts itself,
/// and hardly ever along the sides of its pieces.
bool l3d_two_layer_depths::overlap(const fragment& a, const fragment& b) const {
    const std::uint32_t of_a = a.owner / kinds, of_b = b.owner / kinds;
    const std::uint32_t in_a = a.owner % kinds, in_b = b.owner % kinds;
    if (patches_[of_a].is(patches_[of_b]))
        return in_a + in_b >= rim + slit;
    return in_a != inner && in_b != inner && patches_[of_a].meets(patches_[of_b]);
}

/// The distance between two sheets at a pixel, in pixels.
///
/// The sheets' planes are 1 / w = c + along_x x + along_y y, with x and y from the picture's
/// centre. In space, such a plane is f along_x X + f along_y Y + c Z = 1. So a step by a pixel's
/// size along the normal changes 1 / w by |(along_x, along_y, c / f)|. A step to the next pixel
/// changes the difference of both depths by the difference of the planes' slopes. In a parallel
/// projection, depth_by_pixel takes the place of c / f.
float l3d_two_layer_depths::gap_between(const fragment& front, const fragment& other, int x,
                                        int y) const {
    constexpr float far = std::numeric_limits<float>::infinity();
    if (other.inv_w <= 0)
        return far;
    const auto per_pixel = [&](const fragment& of) {
        if (depth_by_pixel_ > 0)
            return std::hypot(of.along_x, of.along_y, depth_by_pixel_);
        const double c = of.inv_w - of.along_x * (x + 0.5 - size_.width / 2.0) -
                         of.along_y * (y + 0.5 - size_.height / 2.0);
        return std::hypot(of.along_x, of.along_y, c / focal_);
    };
    const double of_front = per_pixel(front), of_both = of_front + per_pixel(other);
    const double by_place =
        std::hypot(front.along_x - other.along_x, front.along_y - other.along_y);
    if (by_place <= of_both / 4 && overlap(front, other))
        return far;
    const double both = double(front.inv_w) + other.inv_w;
    const double apart =
        std::max(0.0, std::abs(double(front.inv_w) - other.inv_w) - rounding * both);
    return static_cast<float>(apart / (by_place + 2 * of_front + of_both));
}
