// SPDX-License-Identifier: MIT
// Surfaces that are folded, collapsed, or thrown far away.
#include "cases.h"
#include "studio.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace stability {
namespace {

const studio oblique{{{-3.1, 2.7, 5.2}, {0.3, -0.4, 0.2}, {-0.2, 1, 0.1}, 37, 0.15}, {167, 127}};

seen_point bent(double u, double v) {
    return {0.12 + 0.7 * u + 0.1 * v * v, 0.1 + 0.08 * u * u + 0.76 * v,
            1.7 + 0.6 * u * (1 - v) + 0.2 * v};
}

void add_collapsed(std::vector<test_case>& to) {
    const auto moved_if = [&](const char* name, auto moves, seen_point where) {
        add_case(to, oblique, "collapsed", name, oblique.patch([&](double u, double v) {
            return moves(u, v) ? where : bent(u, v);
        }));
    };
    const seen_point middle = bent(0.5, 0.5), corner = bent(0, 0);
    moved_if(
        "edge v = 0", [](double, double v) { return v == 0; }, bent(0.5, 0));
    moved_if(
        "edge v = 1", [](double, double v) { return v == 1; }, bent(0.5, 1));
    moved_if(
        "edge u = 0", [](double u, double) { return u == 0; }, bent(0, 0.5));
    moved_if(
        "edge u = 1", [](double u, double) { return u == 1; }, bent(1, 0.5));
    moved_if(
        "two edges that meet", [](double u, double v) { return u == 0 || v == 0; }, corner);
    moved_if(
        "two edges that do not, to one point", [](double u, double) { return u == 0 || u == 1; },
        middle);
    moved_if(
        "all but a corner", [](double u, double v) { return u < 1 || v < 1; }, corner);
    moved_if(
        "all but an edge", [](double u, double) { return u < 1; }, corner);
    moved_if(
        "to a point", [](double, double) { return true; }, middle);
    moved_if("to a pixel's centre", [](double, double) { return true; },
             {80.5 / oblique.size.width, 60.5 / oblique.size.height, 2});
    moved_if("to the eye", [](double, double) { return true; }, {0.5, 0.5, 0});
    add_case(to, oblique, "collapsed", "to a line",
             oblique.patch([](double u, double) { return bent(u, 0.4); }));
    add_case(to, oblique, "collapsed", "to a curve there and back",
             oblique.patch([](double u, double v) { return bent(u * (1 - u) + 0.01 * v, 0.4); }));
    add_case(to, oblique, "collapsed", "two edges onto each other",
             oblique.patch([](double u, double v) { return bent(u, v == 1 ? 0 : v); }));
}

void add_folded(std::vector<test_case>& to) {
    for (int exponent = -1; exponent <= 4; ++exponent)
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            numbers random(100 * seed);
            const double reach = std::pow(10, exponent);
            add_case(to, oblique, "folded",
                     "points off by 1e" + std::to_string(exponent) + " pictures, seed " +
                         std::to_string(seed),
                     oblique.patch([&](double u, double v) {
                         seen_point p = bent(u, v);
                         p.x += random.between(-reach, reach);
                         p.y += random.between(-reach, reach);
                         p.w *= std::exp(random.between(-0.3, 0.3));
                         return p;
                     }));
        }
    add_case(to, oblique, "folded", "a bow tie",
             oblique.patch([](double u, double v) { return bent(v < 0.5 ? u : 1 - u, v); }));
    add_case(to, oblique, "folded", "a closed tube that cuts itself",
             oblique.patch([](double u, double v) {
                 return bent(u == 1 ? 0 : 2 * u - 1, v + (u > 0.5 ? 0.3 : -0.3) * (u < 1));
             }));
    add_case(to, oblique, "folded", "onto itself exactly",
             oblique.patch([](double u, double v) { return bent(u < 0.5 ? u : 1 - u, v); }));
    add_case(to, oblique, "folded", "seen edge on", oblique.patch([](double u, double v) {
        return seen_point{0.2 + 0.6 * u, 0.4 + 0.1 * u, 2 + u + v};
    }));
    add_case(to, oblique, "folded", "seen nearly edge on", oblique.patch([](double u, double v) {
        return seen_point{0.2 + 0.6 * u + 1e-4 * v, 0.4 + 0.1 * u + 1e-5 * v, 2 + u + v};
    }));
}

/// One control point of an ordinary patch is thrown far away.
void add_thrown(std::vector<test_case>& to) {
    for (int exponent = 1; exponent <= 11; exponent += 2)
        for (const std::size_t index : {0u, 5u, 14u}) {
            reference::patch p = oblique.patch(bent);
            const double away = std::pow(10, exponent);
            p.points[index] = {0.7 * away, -0.4 * away, 0.9 * away};
            add_case(to, oblique, "thrown",
                     "point " + std::to_string(index + 1) + " to 1e" + std::to_string(exponent), p);
        }
    numbers random(7);
    for (const int exponent : {2, 4, 8, 12}) {
        const double reach = std::pow(10, exponent);
        reference::patch p;
        for (reference::vec3& point : p.points)
            point = {random.between(-reach, reach), random.between(-reach, reach),
                     random.between(-reach, reach)};
        add_case(to, oblique, "thrown", "all within 1e" + std::to_string(exponent), p);
    }
}

/// Patches that ask for up to a million steps, and for more than there are.
void add_tolerances(std::vector<test_case>& to) {
    numbers random(5);
    const reference::patch gentle = oblique.patch(bent);
    const reference::patch folded = oblique.patch([&](double u, double v) {
        return seen_point{u + random.between(-1, 1), v + random.between(-1, 1), 2 + u};
    });
    for (const double tolerance : {1e300, 1e6, 100.0, 1.0, 1e-2, 5e-3, 1e-3, 1e-4, 1e-6, 1e-9,
                                   1e-12, 1e-30, 1e-300, 5e-324}) {
        char text[40];
        std::snprintf(text, sizeof text, "%g px", tolerance);
        add_case(to, oblique, "tolerance", std::string(text), gentle).tolerance = tolerance;
        add_case(to, oblique, "tolerance", std::string(text) + ", folded", folded).tolerance =
            tolerance;
    }
}

} // namespace

std::vector<test_case> shape_cases() {
    std::vector<test_case> result;
    add_collapsed(result);
    add_folded(result);
    add_thrown(result);
    add_tolerances(result);
    return result;
}

} // namespace stability
