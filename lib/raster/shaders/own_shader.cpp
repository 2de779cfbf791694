// SPDX-License-Identifier: MIT
// own_shader: finds the places in the world of a patch's parameters.
#include "raster/shaders/own_shader_p.h"

#include <algorithm>
#include <cstddef>

namespace l3d_detail {

void own_shader::end_run() {
    if (places_.empty())
        return;
    words_.assign(places_.size(), 0);
    shading_.own->colors(places_, words_);
    for (std::size_t i = 0; i < words_.size(); ++i)
        *targets_[i] = words_[i] & 0x00ffffff;
    places_.clear();
    targets_.clear();
}

std::uint32_t own_shader::word_at(const float* guess, double x, double y) {
    const l3d_seen_place place = seen(guess, x, y);
    std::uint32_t word = 0;
    shading_.own->colors({&place, 1}, {&word, 1});
    return word & 0x00ffffff;
}

l3d_seen_place own_shader::seen(const float* guess, double x, double y) {
    const patch_parameters at = solved(guess, x, y);
    unsolved_ += !at.is_solved;
    const l3d_patch_jet jet = l3d_jet_of(*net_, at.u, at.v);
    l3d_seen_place result{.x = x,
                          .y = y,
                          .u = at.u,
                          .v = at.v,
                          .point = patches_.eye + patches_.in_world(jet.point),
                          .material = patches_.materials[index_]};
    double cosine = 0;
    if (const auto bend = l3d_bend_of(jet)) {
        const bool is_back = l3d_dot(bend->normal, jet.point) > 0;
        const auto normal = is_back ? -bend->normal : bend->normal;
        result.normal = patches_.in_world(normal);
        cosine = l3d_dot(normal, patches_.light);
    }
    result.light = 0.1 + 0.9 * std::clamp(cosine, 0.0, 1.0);
    return result;
}

} // namespace l3d_detail
