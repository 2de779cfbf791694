// SPDX-License-Identifier: MIT
// Places, sizes and views at the ends of the range of numbers.
#include "cases.h"
#include "studio.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace stability {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double denormal = std::numeric_limits<double>::denorm_min();

const studio oblique{{{2.1, -1.7, 4.9}, {-0.2, 0.3, 0.4}, {0.15, 1, -0.1}, 43, 0.25}, {151, 113}};

seen_point bent(double u, double v) {
    return {0.13 + 0.7 * u + 0.1 * v * v, 0.12 + 0.08 * u * u + 0.71 * v,
            2.2 + 0.6 * u * (1 - v) + 0.3 * v};
}

/// Through the near plane, behind the eye at v = 0.
seen_point ground(double u, double v) {
    return {0.1 + 0.8 * u + 0.1 * v, 0.85 - 0.5 * v, 0.25 * (11 * v - 0.7 + 0.3 * u * v)};
}

reference::vec3 scaled(const reference::vec3& v, double by) {
    return {v.x * by, v.y * by, v.z * by};
}

/// The same picture of worlds of all sizes; those beyond 1e12 are refused.
void add_scales(std::vector<test_case>& to) {
    const reference::patch sheets[] = {oblique.patch(bent), oblique.patch(ground)};
    for (int exponent = -300; exponent <= 300;
         exponent += exponent < -30 || exponent >= 30 ? 90 : 3)
        for (const reference::patch& of : sheets) {
            const double by = std::pow(10, exponent);
            reference::patch p = of;
            for (reference::vec3& point : p.points)
                point = scaled(point, by);
            test_case& c = add_case(to, oblique, "scale",
                                    "1e" + std::to_string(exponent) +
                                        (&of == sheets ? "" : ", through the near plane"),
                                    p);
            c.eye.eye = scaled(c.eye.eye, by);
            c.eye.target = scaled(c.eye.target, by);
            c.eye.near *= by;
            c.far = std::max(c.far, 1e3 * c.eye.near);
        }
}

/// The same picture far from the origin, where a double's steps show.
void add_offsets(std::vector<test_case>& to) {
    for (int exponent = 1; exponent <= 12; ++exponent) {
        const double by = std::pow(10, exponent);
        const reference::vec3 away{0.61 * by, -0.37 * by, 0.83 * by};
        studio in = oblique;
        for (reference::vec3* v : {&in.eye.eye, &in.eye.target})
            *v = {v->x + away.x, v->y + away.y, v->z + away.z};
        add_case(to, in, "offset", "1e" + std::to_string(exponent), in.patch(bent));
        // The eye near the origin, a large surface far away.
        add_case(to, oblique, "offset", "distance 1e" + std::to_string(exponent),
                 oblique.patch([&](double u, double v) {
                     seen_point p = bent(u, v);
                     p.w *= by / 10;
                     return p;
                 }));
        // A speck far away from the origin: none of it is left.
        add_case(to, oblique, "offset", "a speck at 1e" + std::to_string(exponent),
                 oblique.patch([&](double u, double v) {
                     return seen_point{0.5 + (u - 0.5) / by, 0.5 + (v - 0.5) / by, by * 0.1};
                 }));
    }
}

void add_near_plane(std::vector<test_case>& to) {
    const auto all_at = [&](const char* name, auto w) {
        add_case(to, oblique, "near plane", name, oblique.patch([&](double u, double v) {
            seen_point p = bent(u, v);
            p.w = oblique.eye.near * w(u, v);
            return p;
        }));
    };
    all_at("on it", [](double, double) { return 1; });
    all_at("on it but for rounding", [](double u, double v) { return 1 + 1e-15 * (u - v); });
    all_at("within 1e-9 of it", [](double u, double v) { return 1 + 1e-9 * (u - v); });
    all_at("within 1e-3 of it", [](double u, double v) { return 1 + 1e-3 * (u - v * v); });
    all_at("just before it", [](double u, double) { return 1.0001 + u; });
    all_at("just behind it", [](double u, double) { return 0.9999 - u; });
    all_at("a corner beyond it", [](double u, double v) { return u + v < 0.1 ? 0.5 : 2 + u; });
    all_at("only a corner before it", [](double u, double v) { return u + v < 0.1 ? 3 : 0.5; });
    all_at("in and out", [](double u, double v) { return 1 + 3 * (u - 0.5) * (v - 0.5) * 4; });
    all_at("in the plane of the eye", [](double, double) { return 0; });
    all_at("near the plane of the eye", [](double u, double v) { return 1e-9 * (u - v); });
    all_at("through the plane of the eye", [](double u, double v) { return 4 * (u - v); });
    all_at("a corner behind the eye", [](double u, double v) { return u + v < 0.1 ? -9 : 3; });
    all_at("behind the eye", [](double u, double v) { return -1 - u - v; });
    all_at("a million behind, a million before",
           [](double u, double v) { return 1e6 * (u + v - 1); });
    add_case(to, oblique, "near plane", "ground to the horizon", oblique.patch(ground));
    add_case(to, oblique, "near plane", "a corner in the eye",
             oblique.patch([](double u, double v) {
                 seen_point p = bent(u, v);
                 p.w *= u + v;
                 return p;
             }));
    add_case(to, oblique, "near plane", "an edge in the eye", oblique.patch([](double u, double v) {
        seen_point p = bent(u, v);
        p.w *= u;
        return p;
    }));
    add_case(to, oblique, "near plane", "around the eye", [] {
        numbers random(3);
        reference::patch p;
        for (reference::vec3& point : p.points)
            point = {oblique.eye.eye.x + random.between(-2, 2),
                     oblique.eye.eye.y + random.between(-2, 2),
                     oblique.eye.eye.z + random.between(-2, 2)};
        return p;
    }());
    for (const int exponent : {-3, -6, -9, -12, -20, -30, -40, -100, -300}) {
        const auto with_near = [&](const char* name, const reference::patch& p) {
            add_case(to, oblique, "near plane", "near 1e" + std::to_string(exponent) + name, p)
                .eye.near = std::pow(10, exponent);
        };
        with_near("", oblique.patch(bent));
        with_near(", ground", oblique.patch(ground));
        with_near(", in the plane of the eye", oblique.patch([](double u, double v) {
            seen_point p = bent(u, v);
            p.w = 1e-12 * (u - 0.4) * (v - 0.6);
            return p;
        }));
    }
    for (const double far : {2.3, 2.5, 0.2500001, 1e300}) {
        char text[40];
        std::snprintf(text, sizeof text, "far at %g", far);
        add_case(to, oblique, "near plane", text, oblique.patch(bent)).far = far;
        add_case(to, oblique, "near plane", std::string(text) + ", ground", oblique.patch(ground))
            .far = far;
    }
}

void add_views(std::vector<test_case>& to) {
    for (const double fov : {0.01, 0.02, 0.05, 0.2, 1.0, 10.0, 60.0, 90.0, 120.0, 150.0, 170.0,
                             175.0, 178.0, 179.0, 179.9, 1e-5, 1e-9, 179.999999}) {
        char text[40];
        std::snprintf(text, sizeof text, "%g degrees", fov);
        studio in = oblique;
        in.eye.fov_degrees = fov;
        add_case(to, in, "field of view", text, in.patch(bent));
        add_case(to, in, "field of view", std::string(text) + ", through the near plane",
                 in.patch(ground));
        // Patches made for another field of view: a corner shows, or a speck.
        add_case(to, in, "field of view", std::string(text) + ", unfit", oblique.patch(bent));
    }
    constexpr reference::picture_size sizes[] = {
        {1, 1},     {1, 2},      {2, 1},      {3, 3},     {1, 1000},    {1000, 1},   {16384, 1},
        {1, 16384}, {16384, 16}, {16, 16384}, {16383, 7}, {16384, 500}, {4001, 3001}};
    for (const reference::picture_size& size : sizes) {
        const std::string text = std::to_string(size.width) + "x" + std::to_string(size.height);
        studio in = oblique;
        in.size = size;
        add_case(to, in, "picture", text, in.patch(bent));
        add_case(to, in, "picture", text + ", through the near plane", in.patch(ground));
        add_case(to, in, "picture", text + ", unfit", oblique.patch(bent));
    }
    // Up nearly along the line of sight, (-2.3, 2, -4.5).
    for (int exponent = 1; exponent <= 12; ++exponent) {
        studio in = oblique;
        in.eye.up = {-2.3 + std::pow(10, -exponent), 2, -4.5};
        add_case(to, in, "up", "off the line of sight by 1e-" + std::to_string(exponent),
                 in.patch(bent));
    }
    studio in = oblique;
    in.eye.up = scaled(in.eye.up, 1e-200);
    add_case(to, in, "up", "1e-200 long", oblique.patch(bent));
    in.eye.up = scaled(oblique.eye.up, 1e200);
    add_case(to, in, "up", "1e200 long", oblique.patch(bent));
    for (const int exponent : {-3, -9, -12, -15}) {
        in = oblique;
        const double by = std::pow(10, exponent);
        in.eye.target = {in.eye.eye.x - 0.46 * by, in.eye.eye.y + 0.4 * by,
                         in.eye.eye.z - 0.9 * by};
        add_case(to, in, "up", "target 1e" + std::to_string(exponent) + " from the eye",
                 in.patch(bent));
    }
}

void add_denormals(std::vector<test_case>& to) {
    reference::patch p = oblique.patch(bent);
    p.points[3] = {denormal, -denormal, 3 * denormal};
    add_case(to, oblique, "denormal", "a control point", p);
    for (reference::vec3& point : p.points)
        point = {denormal, 2 * denormal, -denormal};
    add_case(to, oblique, "denormal", "all control points", p);
    p = oblique.patch(bent);
    for (reference::vec3& point : p.points)
        point.y = 1e-310;
    add_case(to, oblique, "denormal", "one coordinate", p);
    test_case& speck = add_case(to, oblique, "denormal", "the near plane", oblique.patch(bent));
    speck.eye.near = denormal;
    test_case& cut =
        add_case(to, oblique, "denormal", "the near plane, ground", oblique.patch(ground));
    cut.eye.near = denormal;
    test_case& up = add_case(to, oblique, "denormal", "up", oblique.patch(bent));
    up.eye.up = {0, denormal, 0};
    test_case& aside =
        add_case(to, oblique, "denormal", "up but for one coordinate", oblique.patch(bent));
    aside.eye.up = {denormal, 1, -denormal};
    test_case& narrow = add_case(to, oblique, "denormal", "field of view", oblique.patch(bent));
    narrow.eye.fov_degrees = denormal;
}

} // namespace

std::vector<test_case> extreme_cases() {
    std::vector<test_case> result;
    add_scales(result);
    add_offsets(result);
    add_near_plane(result);
    add_views(result);
    add_denormals(result);
    return result;
}

std::vector<test_case> malformed_cases() {
    std::vector<test_case> result;
    const auto add_one = [&](std::string name) -> test_case& {
        return add_case(result, oblique, "malformed", std::move(name), oblique.patch(bent));
    };
    char text[60];
    for (const double value : {nan, infinity, -infinity, 1.7e308, -1.0001e12})
        for (const std::size_t index : {0u, 6u, 15u}) {
            std::snprintf(text, sizeof text, "%g in point %zu", value, index + 1);
            reference::vec3& point = add_one(text).patches[0].points[index];
            (index == 0 ? point.x : index == 6 ? point.y : point.z) = value;
        }
    for (const double value : {nan, infinity, 1e16}) {
        std::snprintf(text, sizeof text, "%g", value);
        add_one(std::string("eye ") + text).eye.eye.y = value;
        add_one(std::string("target ") + text).eye.target.z = value;
    }
    for (const double value : {nan, infinity}) {
        std::snprintf(text, sizeof text, "%g", value);
        add_one(std::string("up ") + text).eye.up.x = value;
    }
    for (const double value : {nan, infinity, 0.0, -1.0, 180.0, 1e300}) {
        std::snprintf(text, sizeof text, "field of view %g", value);
        add_one(text).eye.fov_degrees = value;
    }
    for (const double value : {nan, infinity, 0.0, -1.0, 2e13}) {
        std::snprintf(text, sizeof text, "near %g", value);
        add_one(text).eye.near = value;
    }
    for (const double value : {nan, infinity, 0.0, 0.25}) {
        std::snprintf(text, sizeof text, "far %g", value);
        add_one(text).far = value;
    }
    for (const double value : {nan, 0.0, -0.25, infinity}) {
        std::snprintf(text, sizeof text, "tolerance %g", value);
        add_one(text).tolerance = value;
    }
    add_one("eye in the target").eye.target = oblique.eye.eye;
    add_one("up is zero").eye.up = {0, 0, 0};
    add_one("up along the line of sight").eye.up = {-2.3, 2, -4.5};
    add_one("no pixel wide").size = {0, 113};
    add_one("no pixel high").size = {151, -1};
    add_one("wider than 16384 pixels").size = {16385, 1};
    return result;
}

bool is_malformed(const test_case& c) {
    const auto is_within = [](const reference::vec3& v, double most) {
        return std::abs(v.x) <= most && std::abs(v.y) <= most && std::abs(v.z) <= most;
    };
    const auto is_place = [&](const reference::vec3& v) { return is_within(v, 1e12); };
    for (const reference::patch& p : c.patches)
        if (!std::all_of(p.points.begin(), p.points.end(), is_place))
            return true;
    const reference::vec3 &eye = c.eye.eye, &target = c.eye.target, &up = c.eye.up;
    if (!is_within(eye, 1e15) || !is_place(target))
        return true;
    const long double x = static_cast<long double>(target.x) - eye.x,
                      y = static_cast<long double>(target.y) - eye.y,
                      z = static_cast<long double>(target.z) - eye.z;
    const long double across =
        std::hypot(y * up.z - z * up.y, z * up.x - x * up.z, x * up.y - y * up.x);
    const long double lengths =
        std::hypot(x, y, z) * std::hypot<long double, long double, long double>(up.x, up.y, up.z);
    const bool has_direction = across >= 1e-6L * lengths && lengths > 0 &&
                               lengths < std::numeric_limits<long double>::infinity();
    if (std::hypot(x, y, z) < 1e-32L)
        return true;
    const bool has_depth = c.eye.near >= 1e-32 && c.eye.near < c.far && c.far < infinity;
    const auto is_side = [](int pixels) { return pixels >= 1 && pixels <= 16384; };
    return !has_direction || !has_depth || !(c.eye.fov_degrees > 0 && c.eye.fov_degrees < 180) ||
           !(c.tolerance > 0 && c.tolerance <= 16384) || !is_side(c.size.width) ||
           !is_side(c.size.height);
}

std::vector<test_case> named_cases() {
    std::vector<test_case> result;
    for (std::vector<test_case> more :
         {stiff_cases(), shape_cases(), extreme_cases(), malformed_cases()})
        for (test_case& c : more)
            result.push_back(std::move(c));
    return result;
}

} // namespace stability
