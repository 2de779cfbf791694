// SPDX-License-Identifier: MIT
// The slow twin of hidden surfaces, and scenes for it.
#include "painter_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace pipeline_tests {

namespace {

using corners = std::array<l3d_micro_vertex, 3>;

/// Positive where p is inside the edge a b of a clockwise triangle, y down; of a centre on the edge
/// only left and top edges keep it.
bool inside(const l3d_micro_vertex& a, const l3d_micro_vertex& b, std::int64_t x, std::int64_t y) {
    const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
    const std::int64_t side = dx * (y - a.y) - dy * (x - a.x);
    const bool left_or_top = dy < 0 || (dy == 0 && dx > 0);
    return side > 0 || (side == 0 && left_or_top);
}

long double depth_at(const corners& v, std::int64_t x, std::int64_t y) {
    using real = long double;
    const auto turn = [](real ax, real ay, real bx, real by) { return ax * by - ay * bx; };
    const real x0 = v[0].x, y0 = v[0].y;
    const real all = turn(v[1].x - x0, v[1].y - y0, v[2].x - x0, v[2].y - y0);
    const real to_1 = turn(x - x0, y - y0, v[2].x - x0, v[2].y - y0) / all;
    const real to_2 = turn(v[1].x - x0, v[1].y - y0, x - x0, y - y0) / all;
    return v[0].inv_w + to_1 * (real(v[1].inv_w) - v[0].inv_w) +
           to_2 * (real(v[2].inv_w) - v[0].inv_w);
}

/// Numbers without the standard library's distributions, which differ between implementations.
class dice {
public:
    explicit dice(std::mt19937& random) : random_(random) {}
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    double unit() { return static_cast<double>(random_()) / 4294967296.0; }
    double between(double a, double b) { return a + (b - a) * unit(); }

private:
    std::mt19937& random_;
};

l3d_micro_vertex vertex(double x, double y, double inv_w) {
    return {static_cast<std::int32_t>(std::lround(x * l3d_subpixel_one)),
            static_cast<std::int32_t>(std::lround(y * l3d_subpixel_one)),
            static_cast<float>(inv_w),
            {0, 0, 1}};
}

void add(std::vector<l3d_painter_triangle>& to, const corners& v) {
    to.push_back({.v = v, .material = static_cast<std::uint32_t>(to.size() + 1)});
}

l3d_micro_vertex anywhere(dice& d, l3d_size size, double margin, double least, double most) {
    return vertex(d.between(-margin, size.width + margin), d.between(-margin, size.height + margin),
                  d.between(least, most));
}

void add_tangled(std::vector<l3d_painter_triangle>& to, dice& d, l3d_size size, int count) {
    for (int i = 0; i < count; ++i) {
        const auto any = [&] { return anywhere(d, size, size.width / 3.0, 0.1, 2); };
        add(to, {any(), any(), any()});
    }
}

/// Long triangles round a centre, each over the next; cyclic for three and more.
void add_cycle(std::vector<l3d_painter_triangle>& to, dice& d, l3d_size size, int count) {
    const double x = d.between(0, size.width), y = d.between(0, size.height);
    const double reach = d.between(0.2, 0.7) * size.height, wide = d.between(0.05, 0.3) * reach;
    const double from = d.between(0, 6), near = d.between(0.5, 1.5), tilt = d.between(0.01, 0.3);
    for (int i = 0; i < count; ++i) {
        const double a = from + 2 * std::numbers::pi * i / count;
        const double cx = std::cos(a), cy = std::sin(a);
        const auto place = [&](double along, double beside, double inv_w) {
            return vertex(x + along * cx - beside * cy, y + along * cy + beside * cx, inv_w);
        };
        add(to, {place(-reach, 0.3 * reach, near + tilt), place(reach, 0.3 * reach, near - tilt),
                 place(reach, 0.3 * reach + wide, near - tilt)});
    }
}

void add_slivers(std::vector<l3d_painter_triangle>& to, dice& d, l3d_size size, int count) {
    for (int i = 0; i < count; ++i) {
        const l3d_micro_vertex a = anywhere(d, size, 8, 0.2, 1), b = anywhere(d, size, 8, 0.2, 1);
        l3d_micro_vertex c = a;
        c.x += d.below(700) - 350;
        c.y += d.below(700) - 350;
        c.inv_w = static_cast<float>(d.between(0.2, 1));
        add(to, {a, b, c});
    }
}

/// Fans about common corners: many shared edges, two sheets that go through each other.
void add_fans(std::vector<l3d_painter_triangle>& to, dice& d, l3d_size size) {
    for (int sheet = 0; sheet < 2; ++sheet) {
        const l3d_micro_vertex centre = anywhere(d, size, -8, 0.5, 1);
        std::vector<l3d_micro_vertex> rim;
        const int count = 5 + d.below(6);
        for (int i = 0; i < count; ++i) {
            const double a = 2 * std::numbers::pi * i / count, r = d.between(5, 0.6 * size.width);
            rim.push_back(vertex(centre.x / 256.0 + r * std::cos(a),
                                 centre.y / 256.0 + r * std::sin(a), d.between(0.3, 1.2)));
        }
        for (int i = 0; i < count; ++i)
            add(to, {centre, rim[static_cast<std::size_t>(i)],
                     rim[static_cast<std::size_t>((i + 1) % count)]});
    }
}

/// Corners on pixel centres and corners, few different depths: exact coincidences.
void add_on_raster(std::vector<l3d_painter_triangle>& to, dice& d, l3d_size size, int count) {
    const auto any = [&] {
        return vertex(0.5 * d.below(2 * size.width), 0.5 * d.below(2 * size.height),
                      0.25 * (1 + d.below(5)));
    };
    for (int i = 0; i < count; ++i)
        add(to, {any(), any(), any()});
}

/// One behind the other, in random order.
void add_layers(std::vector<l3d_painter_triangle>& to, dice& d, l3d_size size, int count) {
    for (int i = 0; i < count; ++i) {
        const double near = 0.1 * (1 + d.below(20));
        const auto any = [&] { return anywhere(d, size, 20, near, near + 0.02); };
        add(to, {any(), any(), any()});
    }
}

} // namespace

l3d_shading show_numbers() {
    l3d_shading shading;
    shading.lighting.ambient = {1, 1, 1};
    shading.lighting.color = {};
    return shading;
}

std::vector<l3d_material> materials_of(const l3d_shading& shading, std::size_t triangles) {
    std::vector<l3d_material> materials;
    if (!shading.lighting.is_usual())
        for (std::uint32_t number = 0; number <= triangles; ++number)
            materials.push_back({.color = number});
    return materials;
}

nearest_triangles find_nearest(const std::vector<l3d_painter_triangle>& triangles, l3d_size size) {
    const auto count = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    nearest_triangles result{std::vector<std::uint32_t>(count), std::vector<bool>(count)};
    std::vector<long double> first(count, 0), second(count, 0);
    for (const l3d_painter_triangle& t : triangles) {
        corners v = t.v;
        const std::int64_t area2 =
            (std::int64_t{v[1].x} - v[0].x) * (std::int64_t{v[2].y} - v[0].y) -
            (std::int64_t{v[1].y} - v[0].y) * (std::int64_t{v[2].x} - v[0].x);
        if (area2 == 0)
            continue;
        if (area2 < 0)
            std::swap(v[1], v[2]);
        for (int row = 0; row < size.height; ++row)
            for (int column = 0; column < size.width; ++column) {
                const std::int64_t x = 256 * column + 128, y = 256 * row + 128;
                if (!inside(v[0], v[1], x, y) || !inside(v[1], v[2], x, y) ||
                    !inside(v[2], v[0], x, y))
                    continue;
                const std::size_t at =
                    static_cast<std::size_t>(row) * static_cast<std::size_t>(size.width) +
                    static_cast<std::size_t>(column);
                const long double depth = depth_at(v, x, y);
                if (depth > first[at]) {
                    second[at] = first[at];
                    first[at] = depth;
                    result.number[at] = t.material;
                } else {
                    second[at] = std::max(second[at], depth);
                }
            }
    }
    for (std::size_t i = 0; i < count; ++i)
        result.tied[i] = first[i] > 0 && first[i] - second[i] <= nearest_triangles::tie * first[i];
    return result;
}

std::vector<l3d_painter_triangle> random_triangles(std::mt19937& random, l3d_size size) {
    dice d(random);
    std::vector<l3d_painter_triangle> result;
    switch (d.below(8)) {
    case 0:
        add_tangled(result, d, size, 2 + d.below(14));
        break;
    case 1:
        add_cycle(result, d, size, 3 + d.below(5));
        break;
    case 2:
        add_slivers(result, d, size, 4 + d.below(30));
        break;
    case 3:
        add_fans(result, d, size);
        break;
    case 4:
        add_on_raster(result, d, size, 2 + d.below(12));
        break;
    case 5:
        add_layers(result, d, size, 2 + d.below(20));
        break;
    case 6:
        add_cycle(result, d, size, 3 + d.below(3));
        add_cycle(result, d, size, 4);
        add_tangled(result, d, size, 2);
        break;
    default:
        add_tangled(result, d, size, 3);
        add_slivers(result, d, size, 6);
        add_on_raster(result, d, size, 3);
        add_layers(result, d, size, 5);
    }
    return result;
}

std::vector<l3d_painter_triangle> rectangle_cycle(l3d_size size) {
    std::vector<l3d_painter_triangle> result;
    const double x = 0.47 * size.width, y = 0.52 * size.height, reach = 0.4 * size.height;
    for (int i = 0; i < 3; ++i) {
        const double a = 0.3 + 2 * std::numbers::pi * i / 3;
        const auto place = [&](double along, double beside) {
            return vertex(x + reach * (along * std::cos(a) - beside * std::sin(a)),
                          y + reach * (along * std::sin(a) + beside * std::cos(a)),
                          1 - 0.3 * along);
        };
        const l3d_micro_vertex p = place(-1, 0.2), q = place(1, 0.2), r = place(1, 0.5),
                               s = place(-1, 0.5);
        add(result, {p, q, r});
        add(result, {p, r, s});
    }
    return result;
}

} // namespace pipeline_tests
