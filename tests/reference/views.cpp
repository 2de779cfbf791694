// SPDX-License-Identifier: MIT
// The views, and the plain reader.
#include "reference/views.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace reference {

const std::vector<view>& project_views() {
    static const std::vector<view> views{
        {"full", {{3.2, 3.6, 7.4}, {0.2, 1.3, 0}, {0, 1, 0}, 38, 0.1}},
        {"closeup", {{1.2, 2.6, 4.4}, {-0.3, 1.5, 0}, {0, 1, 0}, 45, 0.1}},
        {"top", {{1.5, 7.5, 3.0}, {0.2, 1.2, 0}, {0, 1, 0}, 35, 0.1}},
        // From within the body, at the wall where the spout leaves.
        {"inside", {{-0.6, 1.1, 0.3}, {1.8, 1.3, 0.1}, {0, 1, 0}, 70, 0.1}},
        // The target is 8.3 away: the plane cuts lid, body and handle.
        {"near_cut", {{3.2, 3.6, 7.4}, {0.2, 1.3, 0}, {0, 1, 0}, 38, 7.9}},
        // 6.4 units across at distance 238: 6.4 * 1115 / 238 = 30 pixels of 768.
        {"tiny", {{91.8, 67.1, 211.9}, {0.2, 1.3, 0}, {0, 1, 0}, 38, 0.1}},
        // At the height of the rim, which is then seen edge on.
        {"grazing", {{0.4, 2.25, 8.5}, {0.1, 2.25, 0}, {0, 1, 0}, 40, 0.1}},
    };
    return views;
}

const view& project_view(std::string_view name) {
    const auto& views = project_views();
    const auto found =
        std::find_if(views.begin(), views.end(), [&](const view& v) { return v.name == name; });
    if (found == views.end())
        throw std::out_of_range("no view named " + std::string(name));
    return *found;
}

std::vector<patch> load_bpt_plain(const std::string& path) {
    std::ifstream file(path);
    std::size_t count = 0;
    if (!(file >> count) || count > 1'000'000)
        throw std::runtime_error(path + ": no patch count");
    std::vector<patch> result(count);
    for (patch& surface : result) {
        int degree_u = 0, degree_v = 0;
        if (!(file >> degree_u >> degree_v) || degree_u != 3 || degree_v != 3)
            throw std::runtime_error(path + ": a patch that is not 3 3");
        for (vec3& p : surface.points)
            if (!(file >> p.x >> p.y >> p.z))
                throw std::runtime_error(path + ": a point is missing");
    }
    return result;
}

} // namespace reference
