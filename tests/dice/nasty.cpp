// SPDX-License-Identifier: MIT
// Patches made in the eye's space and carried into the world.
#include "nasty.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace dice_tests {
namespace {

/// Picture position and distance; negative distances lie behind the eye.
struct seen_point {
    double x, y, w;
};

seen_point point_of(random_numbers& random, nasty_kind kind, std::size_t row, std::size_t column,
                    double near, reference::picture_size size) {
    const double width = size.width, height = size.height;
    const double a = static_cast<double>(column) / 3, b = static_cast<double>(row) / 3;
    switch (kind) {
    case nasty_kind::around_eye:
        return {random.between(-1, 2) * width, random.between(-1, 2) * height,
                random.between(-20, 20) * near};
    case nasty_kind::crossing:
        return {(random.between(-0.2, 0.2) + a) * width,
                (random.between(-0.2, 0.2) + 1 - b) * height,
                near * (random.between(-0.3, 0.3) - 1 + 12 * b)};
    case nasty_kind::spear:
        return {width * (0.4 + random.between(0, 0.2)), height * (0.3 + random.between(0, 0.2)),
                near * 1.01 * std::pow(1000, b) * random.between(1, 1.2)};
    case nasty_kind::deep:
        return {random.between(-0.5, 1.5) * width, random.between(-0.5, 1.5) * height,
                random.of_any_size(1.5, 1.5e5) * near};
    case nasty_kind::wide:
    case nasty_kind::flat:
        break;
    }
    return {random.between(-1e5, 1e5), random.between(-1e5, 1e5), random.between(2, 20) * near};
}

/// A parallelogram in the world; any three corners span it.
reference::patch plane(random_numbers& random, const reference::camera_frame& frame, double near,
                       reference::picture_size size) {
    std::array<reference::vec3, 3> corners;
    for (reference::vec3& corner : corners)
        corner = frame.unproject(random.between(0, 1) * size.width,
                                 random.between(0, 1) * size.height, near * random.between(2, 20));
    const auto [a, b, c] = corners;
    reference::patch result;
    for (std::size_t k = 0; k < 16; ++k) {
        const double u = static_cast<double>(k % 4) / 3, v = static_cast<double>(k / 4) / 3;
        result.points[k] = {a.x + u * (b.x - a.x) + v * (c.x - a.x),
                            a.y + u * (b.y - a.y) + v * (c.y - a.y),
                            a.z + u * (b.z - a.z) + v * (c.z - a.z)};
    }
    return result;
}

} // namespace

/// SplitMix64 (Steele, Lea, Flood 2014).
std::vector<reference::patch> nasty_patches(std::uint64_t seed, nasty_kind kind, int count,
                                            const reference::camera& view,
                                            reference::picture_size size) {
    random_numbers random(seed);
    const reference::camera_frame frame(view, size);
    std::vector<reference::patch> result(static_cast<std::size_t>(count));
    for (reference::patch& surface : result)
        if (kind == nasty_kind::flat)
            surface = plane(random, frame, view.near, size);
        else
            for (std::size_t k = 0; k < 16; ++k) {
                const seen_point p = point_of(random, kind, k / 4, k % 4, view.near, size);
                surface.points[k] = frame.unproject(p.x, p.y, p.w);
            }
    return result;
}

std::vector<reference::patch> hopeless_patches(std::uint64_t seed, const reference::camera& view,
                                               reference::picture_size size) {
    random_numbers random(seed);
    std::vector<reference::patch> result;
    const auto add = [&](auto point_at) {
        reference::patch p;
        for (std::size_t k = 0; k < 16; ++k)
            p.points[k] = point_at(k);
        result.push_back(p);
    };
    const auto any = [&](double r) {
        return reference::vec3{random.between(-r, r), random.between(-r, r), random.between(-r, r)};
    };
    const reference::camera_frame frame(view, size);
    add([&](std::size_t) { return any(1e12); });
    add([&](std::size_t) { return any(1e4); });
    add([&](std::size_t k) { return k == 5 ? any(1e12) : any(1); });
    const reference::vec3 point = any(2);
    add([&](std::size_t) { return point; });
    add([&](std::size_t) { return view.eye; });
    add([&](std::size_t k) { return k < 8 ? view.eye : any(3); });
    add([&](std::size_t) { // a speck before the eye, far nearer than the near plane
        return frame.unproject(random.between(0, 300), random.between(0, 200),
                               random.of_any_size(1e-12, 1e-3));
    });
    add([&](std::size_t k) { // in a plane through the eye, crossing it
        return frame.unproject(150, random.between(-1e3, 1e3), static_cast<double>(k) - 7);
    });
    add([&](std::size_t) { // at the near plane, plus and minus rounding
        return frame.unproject(random.between(0, 300), random.between(0, 200),
                               view.near * (1 + random.between(-1e-15, 1e-15)));
    });
    add([&](std::size_t k) { // a millionth of the parameter makes all the way
        const double at = std::pow(1e-6, static_cast<double>(3 - k % 4) / 3);
        return frame.unproject(300 * at, 60.0 * static_cast<double>(k / 4), 3 + at);
    });
    return result;
}

} // namespace dice_tests
