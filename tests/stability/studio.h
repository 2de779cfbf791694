// SPDX-License-Identifier: MIT
// Making patches by what a camera sees of them.
#ifndef L3D_TESTS_STABILITY_STUDIO_H
#define L3D_TESTS_STABILITY_STUDIO_H

#include "cases.h"
#include "reference/exact.h"
#include "reference/random_numbers.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace stability {

using numbers = reference::random_numbers;

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

/// One case more, of a patch seen in a studio.
inline test_case& add_case(std::vector<test_case>& to, const studio& in, const char* group,
                           std::string name, const reference::patch& p) {
    test_case& c = to.emplace_back();
    c.group = group;
    c.name = std::move(name);
    c.patches.push_back(p);
    c.eye = in.eye;
    c.size = in.size;
    return c;
}

} // namespace stability

#endif
