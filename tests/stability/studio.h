// SPDX-License-Identifier: MIT
// Making patches by what a camera sees of them.
#ifndef L3D_TESTS_STABILITY_STUDIO_H
#define L3D_TESTS_STABILITY_STUDIO_H

#include "reference/exact.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace stability {

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers with every library.
class numbers {
public:
    explicit numbers(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
    }
    /// Every order of magnitude alike. Expects: 0 < low <= high.
    double of_any_size(double low, double high) {
        return std::exp(between(std::log(low), std::log(high)));
    }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

private:
    std::uint64_t state_;
};

/// Units: x, y parts of the picture's width and height; w distance along the view axis, which is
///        the weight of the control point in the picture.
struct seen_point {
    double x, y, w;
};

/// A camera and its picture.
struct studio {
    reference::camera eye;
    reference::picture_size size;

    /// A patch from `at(u, v)`, u and v being 0, 1/3, 2/3 and 1, and `at`'s result a seen_point.
    template <class At> reference::patch patch(At at) const {
        const reference::camera_frame frame(eye, size);
        reference::patch result;
        for (std::size_t k = 0; k < 16; ++k) {
            const seen_point p = at(static_cast<double>(k % 4) / 3, static_cast<double>(k / 4) / 3);
            result.points[k] = frame.unproject(p.x * size.width, p.y * size.height, p.w);
        }
        return result;
    }
};

} // namespace stability

#endif
