// SPDX-License-Identifier: MIT
// The slow, obvious twin of draw_path: the area of each pixel inside of polygons.
#ifndef L3D_TESTS_RASTER_SLOW_AREA_H
#define L3D_TESTS_RASTER_SLOW_AREA_H

#include "raster/rasterizer_2d.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace slow_area {

/// Some polygons, and which points are inside of them.
struct shape {
    std::vector<std::vector<l3d_point_2d>> outlines;
    l3d_winding inside = l3d_winding::nonzero;
};

/// What lies inside of all shapes, pixel by pixel.
///
/// A pixel is cut at all heights where an edge ends, where two edges cross and where one crosses
/// the pixel's sides. Between two such heights the length that is inside changes linearly. So its
/// value half-way, times the height, is the area.
class picture {
public:
    explicit picture(const std::vector<shape>& shapes) {
        for (std::size_t s = 0; s < shapes.size(); ++s)
            for (const auto& o : shapes[s].outlines)
                for (std::size_t i = 0; i < o.size(); ++i)
                    add_edge(o[i], o[(i + 1) % o.size()], s);
        rules_.reserve(shapes.size());
        for (const shape& s : shapes)
            rules_.push_back(s.inside);
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            heights_.push_back(edges_[i].y0);
            heights_.push_back(edges_[i].y1);
            for (std::size_t k = 0; k < i; ++k)
                add_crossing(edges_[i], edges_[k]);
        }
        std::ranges::sort(heights_);
    }

    /// The share of a pixel's square that is inside, 0 to 1.
    long double share(int x, int y) const {
        const long double left = x - 0.5L, right = x + 0.5L, top = y - 0.5L, bottom = y + 0.5L;
        std::vector<long double> cuts{top, bottom};
        for (auto at = std::ranges::lower_bound(heights_, top);
             at != heights_.end() && *at < bottom; ++at)
            cuts.push_back(*at);
        for (const edge& e : edges_)
            for (const long double side : {left, right})
                if ((e.x0 < side) != (e.x1 < side)) {
                    const long double at = e.y0 + (side - e.x0) / (e.x1 - e.x0) * (e.y1 - e.y0);
                    if (at > top && at < bottom)
                        cuts.push_back(at);
                }
        std::ranges::sort(cuts);
        long double area = 0;
        for (std::size_t i = 1; i < cuts.size(); ++i)
            if (cuts[i] > cuts[i - 1])
                area += (cuts[i] - cuts[i - 1]) * length((cuts[i] + cuts[i - 1]) / 2, left, right);
        return area;
    }

private:
    struct edge {
        long double x0, y0, x1, y1; ///< y0 < y1
        int direction;
        std::size_t shape;

        long double at(long double y) const { return x0 + (y - y0) / (y1 - y0) * (x1 - x0); }
    };

    void add_edge(l3d_point_2d a, l3d_point_2d b, std::size_t shape) {
        if (a.y < b.y)
            edges_.push_back({a.x, a.y, b.x, b.y, -1, shape});
        else if (b.y < a.y)
            edges_.push_back({b.x, b.y, a.x, a.y, 1, shape});
    }

    void add_crossing(const edge& a, const edge& b) {
        const long double top = std::max(a.y0, b.y0), bottom = std::min(a.y1, b.y1);
        if (top >= bottom)
            return;
        const long double above = a.at(top) - b.at(top), below = a.at(bottom) - b.at(bottom);
        if (above * below < 0)
            heights_.push_back(top + (bottom - top) * (above / (above - below)));
    }

    long double length(long double y, long double left, long double right) const {
        std::vector<std::pair<long double, const edge*>> crossings;
        for (const edge& e : edges_)
            if (e.y0 <= y && y < e.y1)
                crossings.emplace_back(e.at(y), &e);
        std::ranges::sort(crossings);
        std::array<int, 2> turns{};
        long double sum = 0, from = 0;
        bool inside = false;
        for (const auto& [x, e] : crossings) {
            const long double to = std::clamp(x, left, right);
            sum += inside ? to - from : 0;
            from = to;
            turns[e->shape] += e->direction;
            inside = true;
            for (std::size_t s = 0; s < rules_.size(); ++s)
                inside &= rules_[s] == l3d_winding::nonzero ? turns[s] != 0 : turns[s] % 2 != 0;
        }
        return sum;
    }

    std::vector<edge> edges_;
    std::vector<long double> heights_;
    std::vector<l3d_winding> rules_;
};

} // namespace slow_area

#endif
