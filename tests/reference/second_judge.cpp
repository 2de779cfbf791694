// SPDX-License-Identifier: MIT
// Lines of sight, parts of patches in tiles of the picture, and what is seen.
#include "reference/second_judge.h"
#include "reference/ray_clip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reference {
namespace {

/// Parts are as large as a tile, so that a line of sight meets a few of them only.
constexpr double tile_px = 8;
/// Around the picture there are tiles, too.
constexpr double margin_px = 4;
constexpr int deepest = 40;

/// A piece that is narrower on the line of sight is a point.
constexpr double point_px = 1e-9;

/// Two surfaces that are nearer to each other along the line of sight are one. Where it grazes a
/// surface that bends with a radius of 500 px, a point is sqrt(2 * 500 * point_px) long.
constexpr double seam_px = 1e-3;

vec3 plus(const vec3& p, double t, const vec3& q) {
    return {p.x + t * q.x, p.y + t * q.y, p.z + t * q.z};
}
vec3 minus(const vec3& p, const vec3& q) {
    return plus(p, -1, q);
}
double times(const vec3& p, const vec3& q) {
    return p.x * q.x + p.y * q.y + p.z * q.z;
}
vec3 across(const vec3& p, const vec3& q) {
    return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
double size_of(const vec3& p) {
    return std::sqrt(times(p, p));
}
vec3 unit(const vec3& p) {
    const double size = size_of(p);
    return {p.x / size, p.y / size, p.z / size};
}

using control_points = std::array<vec3, 16>;

/// One half of a net, along u or v, the one with the low or the high parameters.
control_points half_of(control_points p, bool along_u, bool high) {
    for (std::size_t line = 0; line < 4; ++line) {
        const auto at = [&](std::size_t i) -> vec3& {
            const std::size_t k = high ? i : 3 - i; // towards the end that is kept
            return p[along_u ? 4 * line + k : 4 * k + line];
        };
        for (std::size_t round = 1; round < 4; ++round)
            for (std::size_t i = 0; i + round < 4; ++i)
                at(i) = plus({at(i).x / 2, at(i).y / 2, at(i).z / 2}, 0.5, at(i + 1));
    }
    return p;
}

struct surface_at {
    vec3 value, by_u, by_v;
};

/// In powers of nothing: Bernstein's polynomials and their slopes, as they are defined.
surface_at evaluate(const control_points& p, double u, double v) {
    const auto weights = [](double t, std::array<double, 4>& value, std::array<double, 4>& slope) {
        const double s = 1 - t;
        value = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
        slope = {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
    };
    std::array<double, 4> bu{}, su{}, bv{}, sv{};
    weights(u, bu, su);
    weights(v, bv, sv);
    surface_at result;
    for (std::size_t k = 0; k < 16; ++k) {
        result.value = plus(result.value, bu[k % 4] * bv[k / 4], p[k]);
        result.by_u = plus(result.by_u, su[k % 4] * bv[k / 4], p[k]);
        result.by_v = plus(result.by_v, bu[k % 4] * sv[k / 4], p[k]);
    }
    return result;
}

/// Where the derivatives are parallel, that of a place further inside, if there is one.
vec3 normal_of(const control_points& p, double u, double v) {
    for (const double inward : {0.0, 1e-5, 1e-3}) {
        const surface_at at = evaluate(p, u + inward * (0.5 - u), v + inward * (0.5 - v));
        const vec3 n = across(at.by_u, at.by_v);
        if (size_of(n) > 1e-9 * size_of(at.by_u) * size_of(at.by_v))
            return unit(n);
    }
    return {};
}

} // namespace

second_judge::second_judge(std::span<const patch> patches, const camera& view, picture_size size)
    : patches_(patches), near_(view.near), center_x_(size.width / 2.0),
      center_y_(size.height / 2.0), eye_(view.eye), forward_(unit(minus(view.target, view.eye))),
      columns_(static_cast<int>(std::ceil((size.width + 2 * margin_px) / tile_px))),
      rows_(static_cast<int>(std::ceil((size.height + 2 * margin_px) / tile_px))) {
    right_ = unit(across(forward_, view.up));
    up_ = across(right_, forward_);
    focal_ = center_y_ / std::tan(view.fov_degrees * std::numbers::pi / 360);
    tiles_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (std::size_t k = 0; k < patches.size(); ++k) {
        part whole;
        whole.patch = static_cast<int>(k);
        for (std::size_t i = 0; i < 16; ++i)
            whole.points[i] = to_camera(patches[k].points[i]);
        add(whole, 0);
    }
}

vec3 second_judge::to_camera(const vec3& world) const {
    const vec3 p = minus(world, eye_);
    return {times(p, right_), times(p, up_), times(p, forward_)};
}

/// In the camera's axes, 1 along the last.
vec3 second_judge::direction(double x, double y) const {
    return {(x - center_x_) / focal_, (center_y_ - y) / focal_, 1};
}

std::size_t second_judge::tile(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
}

void second_judge::add(const part& whole, int depth) {
    double low = whole.points[0].z, high = low;
    for (const vec3& p : whole.points) {
        low = std::min(low, p.z);
        high = std::max(high, p.z);
    }
    if (high < near_)
        return;
    part boxed = whole;
    if (low > 0) {
        boxed.x0 = boxed.y0 = std::numeric_limits<double>::infinity();
        boxed.x1 = boxed.y1 = -boxed.x0;
        for (const vec3& p : whole.points) {
            const double x = center_x_ + focal_ * p.x / p.z, y = center_y_ - focal_ * p.y / p.z;
            boxed.x0 = std::min(boxed.x0, x);
            boxed.x1 = std::max(boxed.x1, x);
            boxed.y0 = std::min(boxed.y0, y);
            boxed.y1 = std::max(boxed.y1, y);
        }
        if (boxed.x1 < -margin_px || boxed.y1 < -margin_px ||
            boxed.x0 > 2 * center_x_ + margin_px || boxed.y0 > 2 * center_y_ + margin_px)
            return;
    }
    const bool small = low > 0 && boxed.x1 - boxed.x0 <= tile_px && boxed.y1 - boxed.y0 <= tile_px;
    if (small || depth == deepest) {
        if (low <= 0) { // a point within the near distance: no picture of it is known
            boxed.x0 = boxed.y0 = -margin_px;
            boxed.x1 = 2 * center_x_ + margin_px;
            boxed.y1 = 2 * center_y_ + margin_px;
        }
        enter(boxed);
        return;
    }
    const bool along_u = depth % 2 == 0;
    for (const bool upper : {false, true}) {
        part half = whole;
        half.points = half_of(whole.points, along_u, upper);
        (along_u ? half.du : half.dv) /= 2;
        if (upper)
            (along_u ? half.u0 : half.v0) += along_u ? half.du : half.dv;
        add(half, depth + 1);
    }
}

void second_judge::enter(const part& small) {
    const auto place = [](double position, int count) {
        const double tile = std::floor((position + margin_px) / tile_px);
        return static_cast<int>(std::clamp(tile, 0.0, static_cast<double>(count - 1)));
    };
    // The box is grown by what a point is.
    const int left = place(small.x0 - point_px, columns_), top = place(small.y0 - point_px, rows_);
    const int right = place(small.x1 + point_px, columns_);
    const int bottom = place(small.y1 + point_px, rows_);
    for (int row = top; row <= bottom; ++row)
        for (int column = left; column <= right; ++column)
            tiles_[tile(column, row)].push_back(parts_.size());
    parts_.push_back(small);
}

second_sample second_judge::look(double x, double y) const {
    const int column = static_cast<int>(std::floor((x + margin_px) / tile_px));
    const int row = static_cast<int>(std::floor((y + margin_px) / tile_px));
    second_sample result;
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_)
        return result;
    const vec3 d = direction(x, y);
    // Two unit vectors across the line of sight.
    const vec3 one = unit(across(d, {0, 1, 0})), two = unit(across(d, one));
    double at_u = 0, at_v = 0;
    std::vector<double> depths;
    for (const std::size_t k : tiles_[tile(column, row)]) {
        const part& each = parts_[k];
        if (x < each.x0 - point_px || x > each.x1 + point_px || y < each.y0 - point_px ||
            y > each.y1 + point_px)
            continue;
        second::offset_net net;
        double farthest = 0;
        for (std::size_t i = 0; i < 16; ++i) {
            net[i] = {times(each.points[i], one), times(each.points[i], two)};
            farthest = std::max(farthest, std::abs(each.points[i].z));
        }
        second::clip_ray(net, point_px * farthest / focal_, [&](double u, double v) {
            const double w = evaluate(each.points, u, v).value.z;
            if (w < near_)
                return;
            depths.push_back(w);
            if (w >= result.w)
                return;
            result.w = w;
            result.patch = each.patch;
            at_u = each.u0 + each.du * u;
            at_v = each.v0 + each.dv * v;
        });
    }
    for (const double w : depths)
        if ((w - result.w) / result.w * focal_ > seam_px)
            result.behind = std::min(result.behind, w);
    if (result.covered())
        result.normal =
            normal_of(patches_[static_cast<std::size_t>(result.patch)].points, at_u, at_v);
    return result;
}

unsigned char second_judge::grey(const second_sample& seen, double x, double y, vec3 light) const {
    if (!seen.covered())
        return 0;
    const vec3 d = direction(x, y);
    const vec3& n = seen.normal;
    // The line of sight in the world; a normal that goes along with it shows its back.
    const double along = d.x * times(n, right_) + d.y * times(n, up_) + times(n, forward_);
    const double cosine = (along > 0 ? -1 : 1) * times(n, unit(light));
    return static_cast<unsigned char>(std::lround(255 * (0.1 + 0.9 * std::max(0.0, cosine))));
}

second_judge::change second_judge::between(const second_sample& p, const second_sample& q) const {
    constexpr double most_px = 0.05;
    constexpr double most_angle = 3 * std::numbers::pi / 180;
    if (p.covered() != q.covered())
        return {std::numeric_limits<double>::infinity(), outline_kind::border};
    if (!p.covered())
        return {};
    const double px = std::abs(p.w - q.w) * focal_ / std::min(p.w, q.w);
    const double sine = size_of(across(p.normal, q.normal));
    const double angle = std::atan2(sine, std::abs(times(p.normal, q.normal)));
    const double jump = px / most_px, bend = angle / most_angle;
    // A jump is one, whatever it does to the normal.
    return {std::max(jump, bend), jump > 1 ? outline_kind::jump : outline_kind::crease};
}

/// The rest of the change from the middle to the end of a way when it has been halved often.
second_judge::change second_judge::sharpest(const second_sample& middle, const second_sample& end,
                                            double x, double y, double dx, double dy) const {
    constexpr int halvings = 18;
    double low = 0, high = 1;
    second_sample at_low = middle, at_high = end;
    change left = between(at_low, at_high);
    for (int n = 0; n < halvings && left.size > 1; ++n) {
        const double t = (low + high) / 2;
        const second_sample at = look(x + t * dx, y + t * dy);
        const change below = between(at_low, at), above = between(at, at_high);
        const bool in_low = below.size >= above.size;
        (in_low ? high : low) = t;
        (in_low ? at_high : at_low) = at;
        left = in_low ? below : above;
    }
    return left;
}

bool second_judge::is_close(const second_sample& seen, double x, double y, double close_px) const {
    if (!seen.covered() || !std::isfinite(seen.behind))
        return false;
    const vec3 d = direction(x, y);
    const vec3& n = seen.normal;
    const double toward = d.x * times(n, right_) + d.y * times(n, up_) + times(n, forward_);
    return (seen.behind - seen.w) * std::abs(toward) * focal_ / seen.w < close_px;
}

outline_kind second_judge::outline_within(double x, double y, double radius,
                                          double close_px) const {
    constexpr int ways = 16;
    const second_sample middle = look(x, y);
    bool close = is_close(middle, x, y, close_px);
    for (int k = 0; k < ways; ++k) {
        const double angle = 2 * std::numbers::pi * k / ways;
        const double dx = radius * std::cos(angle), dy = radius * std::sin(angle);
        const second_sample end = look(x + dx, y + dy);
        const change left = sharpest(middle, end, x, y, dx, dy);
        if (left.size > 1)
            return left.kind;
        close = close || is_close(end, x + dx, y + dy, close_px);
    }
    return close ? outline_kind::close : outline_kind::none;
}

} // namespace reference
