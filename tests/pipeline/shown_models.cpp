// SPDX-License-Identifier: MIT
// shown_models: files, a random body, and views from all sides.
#include "shown_models.h"

#include "../scene/bodies.h"
#include "reference/views.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pipeline_tests {

namespace {

using reference::camera;
using reference::vec3;

/// From twelve sides, evenly spread by the golden angle, at 2.2 to 5 radii of the model.
void add_views(shown_model& to) {
    vec3 low = to.patches.front().points[0], high = low;
    for (const reference::patch& each : to.patches)
        for (const vec3& p : each.points) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
    const vec3 middle{(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2};
    const double radius = std::hypot(high.x - low.x, high.y - low.y, high.z - low.z) / 2;
    constexpr double golden_angle = 2.399963;
    while (to.views.size() < 12) {
        const auto k = static_cast<double>(to.views.size());
        const double height = 1 - (2 * k + 1) / 12, out = std::sqrt(1 - height * height);
        const double distance = radius * (2.2 + 2.8 * std::fmod(k * 0.618034, 1));
        camera view;
        view.eye = {middle.x + distance * out * std::cos(golden_angle * k + 0.3),
                    middle.y + distance * height,
                    middle.z + distance * out * std::sin(golden_angle * k + 0.3)};
        view.target = middle;
        view.up = {0.1, 1, 0.2};
        to.views.push_back(view);
    }
}

} // namespace

std::vector<shown_model> shown_models() {
    std::vector<shown_model> result(4);
    result[0] = {"teapot", reference::load_bpt_plain("data/teapot.bpt"), {}};
    for (const reference::view& each : reference::project_views())
        result[0].views.push_back(each.eye);
    // Towards the eye they bend, and nothing of that moves in the picture.
    result[1] = {"dome",
                 reference::load_bpt_plain("tests/data/dome.bpt"),
                 {{{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 38, 0.1}}};
    result[2] = {"bumps",
                 reference::load_bpt_plain("tests/data/bump3.bpt"),
                 {{{0, 0, 1e5}, {0, 0, 0}, {0, 1, 0}, 0.0012, 0.1}}};
    reference::random_numbers random(21);
    result[3] = {"starfish", dice_tests::random_body(random, dice_tests::body_kind::starfish), {}};
    for (shown_model& each : result)
        add_views(each);
    return result;
}

} // namespace pipeline_tests
