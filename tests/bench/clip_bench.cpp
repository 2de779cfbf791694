// SPDX-License-Identifier: MIT
// Ways to clip lines and polygons against each other; one line of JSON each. The answers of both
// ways of a pair have to agree.
#include "geom/line_clip.h"
#include "geom/polygon_2d.h"
#include "geom/random.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace {

using position = l3d_position<double>;
const position least(0, 0), most(640, 480);

struct segment {
    position from, to;
};

/// Cohen and Sutherland: a bit for each border that an end is beyond.
int outside(const position& p) {
    return (p[0] < least[0]) | (p[0] > most[0]) << 1 | (p[1] < least[1]) << 2 |
           (p[1] > most[1]) << 3;
}

bool clip_by_codes(position& from, position& to) {
    int at_from = outside(from);
    int at_to = outside(to);
    while (at_from | at_to) {
        if (at_from & at_to)
            return false;
        const int code = at_from ? at_from : at_to;
        const int axis = code & 3 ? 0 : 1;
        const bool below = axis == 0 ? (code & 1) != 0 : (code & 4) != 0;
        const double border = below ? least[axis] : most[axis];
        position cut;
        cut[axis] = border;
        cut[1 - axis] = from[1 - axis] + (to[1 - axis] - from[1 - axis]) * (border - from[axis]) /
                                             (to[axis] - from[axis]);
        (at_from ? from : to) = cut;
        (at_from ? at_from : at_to) = outside(cut);
    }
    return true;
}

bool clip_by_parameters(position& from, position& to) {
    return l3d_clip_line<double>(from, to, least, most);
}

/// The book's way with an edge: find where a convex outline comes in and where it goes out.
template <class Side, class Cut>
void clip_by_crossings(const std::vector<std::uint32_t>& corners, Side side, Cut cut,
                       std::vector<std::uint32_t>& kept) {
    kept.clear();
    const std::size_t n = corners.size();
    std::size_t in = n;
    bool any = false;
    for (std::size_t i = 0; i < n && in == n; ++i) {
        const bool here = side(corners[i]) >= 0;
        any |= here;
        if (!here && side(corners[(i + 1) % n]) >= 0)
            in = i;
    }
    if (in == n) {
        if (any)
            kept = corners;
        return;
    }
    kept.push_back(cut(corners[(in + 1) % n], corners[in]));
    std::size_t i = (in + 1) % n;
    for (; side(corners[i]) >= 0; i = (i + 1) % n)
        kept.push_back(corners[i]);
    kept.push_back(cut(corners[(i + n - 1) % n], corners[i]));
}

/// Median of the nanoseconds for each of `count` items.
template <class Run> double time_of(std::size_t count, Run run) {
    using clock = std::chrono::steady_clock;
    std::vector<double> times;
    for (int round = 0; round < 15; ++round) {
        const auto start = clock::now();
        run();
        times.push_back(std::chrono::duration<double, std::nano>(clock::now() - start).count() /
                        static_cast<double>(count));
    }
    std::ranges::nth_element(times, times.begin() + 7);
    return times[7];
}

/// Up to rounding: of lengths, and of whether an end on a border counts.
bool agree(double one, double other) {
    if (std::abs(one - other) <= 1e-9 * one)
        return true;
    std::fprintf(stderr, "two ways do not agree: %.17g and %.17g\n", one, other);
    return false;
}

template <class Clip> double length_left(const std::vector<segment>& lines, Clip clip) {
    double sum = 0;
    for (segment line : lines)
        if (clip(line.from, line.to))
            sum += std::abs(line.to[0] - line.from[0]) + std::abs(line.to[1] - line.from[1]);
    return sum;
}

bool lines_of(const char* which, double reach) {
    l3d_random random(1);
    const auto any = [&] {
        return position(320 + reach * (random.fraction() - 0.5),
                        240 + reach * (random.fraction() - 0.5));
    };
    std::vector<segment> lines;
    for (int i = 0; i < 20000; ++i)
        lines.push_back({any(), any()});
    double codes = 0;
    double parameters = 0;
    const double ns_codes =
        time_of(lines.size(), [&] { codes = length_left(lines, clip_by_codes); });
    const double ns_parameters =
        time_of(lines.size(), [&] { parameters = length_left(lines, clip_by_parameters); });
    std::printf("{\"lines\": \"%s\", \"cohen_sutherland_ns\": %.1f, \"liang_barsky_ns\": %.1f}\n",
                which, ns_codes, ns_parameters);
    return agree(codes, parameters);
}

bool polygons_of(const char* which, double reach, int count) {
    l3d_random random(2);
    std::vector<l3d_coordinate<double>> vertices;
    std::vector<std::vector<std::uint32_t>> polygons;
    for (int i = 0; i < 4000; ++i) {
        const double x = 320 + reach * (random.fraction() - 0.5);
        const double y = 240 + reach * (random.fraction() - 0.5);
        polygons.emplace_back();
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * k / count;
            polygons.back().push_back(static_cast<std::uint32_t>(vertices.size()));
            vertices.emplace_back(
                l3d_point<double>(x + 90 * std::cos(angle), y + 70 * std::sin(angle), 0));
        }
    }
    l3d_vertex_list<double> list(vertices);
    const auto window = l3d_window_corners(least, most);
    std::vector<std::uint32_t> corners, kept;
    std::size_t steps = 0;
    std::size_t crossings = 0;
    const auto run = [&](std::size_t& total, auto clip) {
        total = 0;
        list.clear_varying();
        for (const auto& polygon : polygons) {
            corners = polygon;
            for (std::size_t e = 0; e < 4 && !corners.empty(); ++e) {
                const position& from = window[(e + 3) % 4];
                const position& to = window[e];
                const auto side = [&](std::uint32_t i) {
                    return l3d_side_2d<double>(l3d_in_picture(list[i]), from, to);
                };
                const auto cut = [&](std::uint32_t inside, std::uint32_t beyond) {
                    return list.add_varying(l3d_cut_vertex(
                        list[inside], list[beyond],
                        l3d_cross_line_2d<double>(l3d_in_picture(list[inside]),
                                                  l3d_in_picture(list[beyond]), from, to)));
                };
                clip(side, cut);
                corners.swap(kept);
            }
            total += corners.size();
        }
    };
    const double ns_steps = time_of(polygons.size(), [&] {
        run(steps, [&](auto side, auto cut) {
            l3d_clip_to_plane(std::span<const std::uint32_t>(corners), 0.0, side, cut, kept);
        });
    });
    const double ns_crossings = time_of(polygons.size(), [&] {
        run(crossings, [&](auto side, auto cut) { clip_by_crossings(corners, side, cut, kept); });
    });
    std::printf("{\"polygons\": \"%s\", \"corners\": %d, \"sutherland_hodgman_ns\": %.1f, "
                "\"two_crossings_ns\": %.1f}\n",
                which, count, ns_steps, ns_crossings);
    return agree(static_cast<double>(steps), static_cast<double>(crossings));
}

} // namespace

int main() {
    bool well = lines_of("inside", 400);
    well &= lines_of("half outside", 1100);
    well &= lines_of("mostly outside", 6000);
    for (const int corners : {3, 4, 8}) {
        well &= polygons_of("inside", 200, corners);
        well &= polygons_of("cut", 800, corners);
    }
    return well ? 0 : 1;
}
