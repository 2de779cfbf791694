// SPDX-License-Identifier: MIT
// The exact picture, from all intersections.
#include "reference/exact.h"
#include "reference/hits.h"

#include <algorithm>
#include <cmath>

namespace reference {

exact_image::exact_image(std::span<const patch> patches, const camera& view, picture_size size,
                         const std::stop_token& stop)
    : size_(size), view_(view) {
    const std::size_t count =
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    samples_.resize(count);
    layers_.resize(count);
    const camera_frame frame(view, size);
    const sample_grid centers{0.5, 0.5, 1, size.width, size.height};
    for (std::size_t k = 0; k < patches.size(); ++k)
        find_hits(
            make_net(patches[k], frame), view.least_w(), centers,
            [&](const hit& at) {
                const std::size_t place = index(at.i, at.j);
                ++layers_[place];
                exact_sample& nearest = samples_[place];
                const double w =
                    view.parallel
                        ? static_cast<double>(exact_point(patches[k], frame, at.u, at.v).w)
                        : at.w;
                if (w < nearest.w)
                    nearest = {w, at.u, at.v, {}, static_cast<int>(k)};
            },
            stop);
    for (exact_sample& sample : samples_) {
        end_if_told(stop);
        if (sample.covered())
            sample.normal = exact_point(patches[static_cast<std::size_t>(sample.patch)], frame,
                                        sample.u, sample.v)
                                .normal;
    }
}

std::vector<unsigned char> exact_image::lambert(vec3 light) const {
    const camera_frame frame(view_, size_);
    const double length = std::sqrt(light.x * light.x + light.y * light.y + light.z * light.z);
    std::vector<unsigned char> result(samples_.size(), 0);
    for (int y = 0; y < size_.height; ++y)
        for (int x = 0; x < size_.width; ++x) {
            const exact_sample& sample = at(x, y);
            if (!sample.covered())
                continue;
            const vec3 seen = frame.unproject(x + 0.5, y + 0.5, sample.w);
            const vec3& n = sample.normal;
            const vec3 before = frame.unproject(x + 0.5, y + 0.5, sample.w - 1);
            const vec3& from = view_.parallel ? before : view_.eye;
            const double away =
                n.x * (seen.x - from.x) + n.y * (seen.y - from.y) + n.z * (seen.z - from.z);
            const double turn = away > 0 ? -1 : 1;
            const double cosine = turn * (n.x * light.x + n.y * light.y + n.z * light.z) / length;
            result[index(x, y)] =
                static_cast<unsigned char>(std::lround(255 * (0.1 + 0.9 * std::max(0.0, cosine))));
        }
    return result;
}

} // namespace reference
