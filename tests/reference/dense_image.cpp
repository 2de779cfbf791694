// SPDX-License-Identifier: MIT
// Brute force: a grid of triangles per patch.
#include "reference/dense_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace reference {
namespace {

/// Shape: [component][4 * j + i] is the coefficient of u^i v^j of x, y, w.
using powers = std::array<std::array<double, 16>, 3>;

/// Row k: the coefficients of 1, t, t^2, t^3 in the k-th Bernstein polynomial.
constexpr double basis[4][4] = {{1, -3, 3, -1}, {0, 3, -6, 3}, {0, 0, 3, -3}, {0, 0, 0, 1}};

powers in_powers(const patch& surface, const camera_frame& frame) {
    powers result{};
    for (std::size_t k = 0; k < 16; ++k) {
        const vec3& p = surface.points[k];
        const homogeneous_point h = frame.project({p.x, p.y, p.z});
        const double value[3] = {static_cast<double>(h.x), static_cast<double>(h.y),
                                 static_cast<double>(h.w)};
        for (std::size_t component = 0; component < 3; ++component)
            for (std::size_t c = 0; c < 16; ++c)
                result[component][c] +=
                    basis[k % 4][c % 4] * basis[k / 4][c / 4] * value[component];
    }
    return result;
}

double horner(const std::array<double, 16>& c, double u, double v) {
    double sum = 0;
    for (std::size_t j = 16; j > 0; j -= 4)
        sum = sum * v + ((c[j - 1] * u + c[j - 2]) * u + c[j - 3]) * u + c[j - 4];
    return sum;
}

} // namespace

dense_image::dense_image(std::span<const patch> patches, const camera& view, picture_size size,
                         int cells)
    : size_(size),
      depth_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), 0.0) {
    const camera_frame frame(view, size);
    for (const patch& surface : patches)
        draw(surface, frame, cells);
}

void dense_image::draw(const patch& surface, const camera_frame& frame, int cells) {
    const powers p = in_powers(surface, frame);
    std::vector<vertex> above, below;
    for (int j = 0; j <= cells; ++j) {
        below.clear();
        for (int i = 0; i <= cells; ++i) {
            const double u = static_cast<double>(i) / cells, v = static_cast<double>(j) / cells;
            const double w = horner(p[2], u, v);
            below.push_back({horner(p[0], u, v) / w, horner(p[1], u, v) / w, 1 / w});
        }
        for (std::size_t i = 0; j > 0 && i + 1 < below.size(); ++i) {
            fill(above[i], above[i + 1], below[i]);
            fill(below[i + 1], above[i + 1], below[i]);
        }
        std::swap(above, below);
    }
}

void dense_image::fill(const vertex& a, const vertex& b, const vertex& c) {
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0)
        return;
    const auto first = [](double low, int count) {
        return static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, static_cast<double>(count)));
    };
    const auto last = [](double high, int count) {
        return static_cast<int>(
            std::clamp(std::floor(high - 0.5), -1.0, static_cast<double>(count - 1)));
    };
    const int x0 = first(std::min({a.x, b.x, c.x}), size_.width);
    const int x1 = last(std::max({a.x, b.x, c.x}), size_.width);
    const int y0 = first(std::min({a.y, b.y, c.y}), size_.height);
    const int y1 = last(std::max({a.y, b.y, c.y}), size_.height);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
            const double s = (px * (c.y - a.y) - py * (c.x - a.x)) / area;
            const double t = (py * (b.x - a.x) - px * (b.y - a.y)) / area;
            if (s < 0 || t < 0 || s + t > 1)
                continue;
            double& nearest = depth_[place(x, y)];
            nearest =
                std::max(nearest, (1 - s - t) * a.inverse_w + s * b.inverse_w + t * c.inverse_w);
        }
}

} // namespace reference
