// SPDX-License-Identifier: MIT
// Samples of light, from all intersections or from one line of sight.
#include "reference/light_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

namespace reference {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();
constexpr double least_gap_px = 1e-3, grazing_px = 3e-8;

double dot(const vec3& p, const vec3& q) {
    return p.x * q.x + p.y * q.y + p.z * q.z;
}

vec3 unit(const vec3& p) {
    const double length = std::sqrt(dot(p, p));
    return {p.x / length, p.y / length, p.z / length};
}

double along(const long double (&axis)[3], const vec3& p) {
    return static_cast<double>(axis[0] * p.x + axis[1] * p.y + axis[2] * p.z);
}

} // namespace

// IEC 61966-2-1: a straight piece near black, a power of 2.4 beyond.
double light_of_level(double level) {
    const double v = level / 255;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

double level_of_light(double light) {
    return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

light_sampler::light_sampler(std::span<const patch> patches, const camera& view, picture_size size,
                             vec3 light, double background)
    : patches_(patches), view_(view), frame_(view, size), focal_(static_cast<double>(frame_.focal)),
      judge_(patches, view, size) {
    for (const patch& each : patches)
        nets_.push_back(make_net(each, frame_));
    light_ = to_axes(unit(light));
    nothing_.level = background;
    nothing_.light = light_of_level(background);
}

vec3 light_sampler::to_axes(const vec3& world) const {
    return {along(frame_.right, world), along(frame_.up, world), along(frame_.forward, world)};
}

void light_sampler::take(const lamp_light& lamps) {
    lamps_ = lamps;
    for (lamp& each : lamps_.lamps)
        each.direction = to_axes(unit(each.direction));
}

/// Expects: a unit normal, turned to the eye.
double light_sampler::level_by_lamps(const vec3& normal, const vec3& place) const {
    const vec3 way = unit(place);
    double level = lamps_.color * lamps_.ambient;
    for (const lamp& each : lamps_.lamps) {
        const vec3& to = each.direction;
        const double lit = dot(normal, to);
        if (!(lit > 0))
            continue;
        const vec3 between{to.x - way.x, to.y - way.y, to.z - way.z};
        const double facing =
            std::max(0.0, dot(normal, between)) / std::sqrt(dot(between, between));
        level += each.strength *
                 (0.9 * lamps_.color * lit + lamps_.highlight * std::pow(facing, lamps_.sharpness));
    }
    const double clear = 255 * std::min(1.0, level);
    if (!(lamps_.fog_far > lamps_.fog_near))
        return clear;
    const double share =
        std::clamp((place.z - lamps_.fog_near) / (lamps_.fog_far - lamps_.fog_near), 0.0, 1.0);
    return clear + share * (lamps_.fog_level - clear);
}

light_sample light_sampler::seen(double x, double y, double w, const vec3& world_normal) const {
    light_sample result;
    result.w = w;
    result.place = {(x - static_cast<double>(frame_.center_x)) / focal_ * w,
                    (static_cast<double>(frame_.center_y) - y) / focal_ * w, w};
    result.normal = to_axes(world_normal);
    // A normal that goes along with the line of sight shows its back.
    const double turn = dot(result.normal, result.place) > 0 ? -1 : 1;
    const vec3& n = result.normal;
    result.level = lamps_.lamps.empty()
                       ? 255 * (0.1 + 0.9 * std::max(0.0, turn * dot(n, light_)))
                       : level_by_lamps({turn * n.x, turn * n.y, turn * n.z}, result.place);
    result.light = light_of_level(result.level);
    return result;
}

std::vector<light_sample> light_sampler::grid(const sample_grid& places) const {
    struct nearest {
        double w = nowhere, u = 0, v = 0;
        std::size_t patch = 0;
        double behind = nowhere;
    };
    const auto columns = static_cast<std::size_t>(places.columns);
    std::vector<nearest> found(columns * static_cast<std::size_t>(places.rows));
    for (std::size_t k = 0; k < nets_.size(); ++k)
        find_hits(nets_[k], view_.near, places, [&](const hit& at) {
            nearest& so_far =
                found[static_cast<std::size_t>(at.j) * columns + static_cast<std::size_t>(at.i)];
            const bool front = at.w < so_far.w;
            const double behind = front ? so_far.w : at.w, before = front ? at.w : so_far.w;
            if ((behind - before) * focal_ > least_gap_px * before)
                so_far.behind = std::min(so_far.behind, behind);
            if (front)
                so_far = {at.w, at.u, at.v, k, so_far.behind};
        });
    std::vector<light_sample> result(found.size(), nothing_);
    for (std::size_t k = 0; k < found.size(); ++k) {
        const nearest& at = found[k];
        if (at.w == nowhere)
            continue;
        const vec3 normal = exact_point(patches_[at.patch], frame_, at.u, at.v).normal;
        const std::size_t row = k / columns;
        result[k] = seen(places.x0 + static_cast<double>(k % columns) * places.step,
                         places.y0 + static_cast<double>(row) * places.step, at.w, normal);
        const light_sample& front = result[k];
        result[k].gap =
            std::abs(dot(front.normal, front.place)) / at.w * (at.behind - at.w) * focal_ / at.w;
    }
    return result;
}

light_sample light_sampler::look(double x, double y) const {
    // Along a surface that is grazed exactly, points on the line of sight cannot be told apart.
    constexpr int most_tries = 4;
    for (int n = 0;; ++n)
        try {
            const double aside = n * grazing_px;
            const second_sample found = judge_.look(x + aside, y - aside);
            return found.covered() ? seen(x, y, found.w, found.normal) : nothing_;
        } catch (const std::runtime_error&) {
            if (n == most_tries)
                throw;
        }
}

bool light_sampler::differ(const light_sample& p, const light_sample& q) const {
    static const double least_cosine = std::cos(3 * std::numbers::pi / 180);
    constexpr double most_px = 0.1;
    if (!p.covered() || !q.covered())
        return p.covered() != q.covered();
    if (!(std::abs(dot(p.normal, q.normal)) > least_cosine))
        return true;
    const vec3 way{q.place.x - p.place.x, q.place.y - p.place.y, q.place.z - p.place.z};
    const double off = std::max(std::abs(dot(p.normal, way)), std::abs(dot(q.normal, way)));
    return !(off * focal_ < most_px * std::min(p.w, q.w));
}

} // namespace reference
