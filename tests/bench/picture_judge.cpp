// SPDX-License-Identifier: MIT
// picture_judge: levels of the exact picture, and where no outline is near.
#include "bench/picture_judge.h"

#include "pipeline/pipeline_afd.h"
#include "reference/exact.h"
#include "reference/measure.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace {

reference::vec3 vec3_of(const l3d_vector<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

reference::exact_image exact_of(const l3d_patch_model& model, const l3d_camera& camera,
                                l3d_size size) {
    std::vector<reference::patch> patches;
    for (const auto& p : model.patches()) {
        auto& points = patches.emplace_back().points;
        std::ranges::transform(p.points, points.begin(), vec3_of);
    }
    const reference::camera view{vec3_of(camera.eye), vec3_of(camera.target), vec3_of(camera.up),
                                 camera.fov, camera.near_z};
    return {patches, view, {size.width, size.height}};
}

bool is_inside(const reference::exact_image& exact, const reference::camera_frame& frame, int x,
               int y) {
    constexpr int reach = 2;
    constexpr double most_px = 1;
    const auto [width, height] = exact.size();
    if (x < reach || y < reach || x + reach >= width || y + reach >= height || !exact.covered(x, y))
        return false;
    const auto& middle = exact.at(x, y);
    for (int j = y - reach; j <= y + reach; ++j)
        for (int i = x - reach; i <= x + reach; ++i) {
            const auto& other = exact.at(i, j);
            if (!other.covered() ||
                !(reference::tangent_distance_px(middle, x, y, frame, other, i, j) <= most_px) ||
                !(reference::tangent_distance_px(other, i, j, frame, middle, x, y) <= most_px))
                return false;
        }
    return true;
}

double root_mean(double sum, std::size_t count) {
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

} // namespace

picture_judge::picture_judge(const l3d_patch_model& model, const l3d_camera& camera,
                             l3d_size size) {
    const auto exact = exact_of(model, camera, size);
    const reference::camera_frame frame(exact.view(), exact.size());
    levels_ = exact.lambert(vec3_of(l3d_afd_settings().light));
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            inside_.push_back(is_inside(exact, frame, x, y));
            covered_ += exact.covered(x, y);
        }
    inside_count_ = static_cast<std::size_t>(std::ranges::count(inside_, true));
}

picture_error picture_judge::operator()(std::span<const std::uint8_t> greys) const {
    assert(greys.size() == levels_.size());
    double sum = 0, inside_sum = 0;
    std::size_t shown = 0;
    for (std::size_t i = 0; i < greys.size(); ++i) {
        const double off = int{greys[i]} - int{levels_[i]};
        shown += greys[i] != 0 || levels_[i] != 0;
        sum += off * off;
        if (inside_[i])
            inside_sum += off * off;
    }
    return {root_mean(sum, shown), root_mean(inside_sum, inside_count_)};
}

std::vector<std::uint8_t> greys_of(const l3d_pixels& picture) {
    std::vector<std::uint8_t> greys;
    for (int y = 0; y < picture.height; ++y)
        for (const std::uint32_t word : picture.row(y))
            greys.push_back(static_cast<std::uint8_t>(word & 0xff));
    return greys;
}
