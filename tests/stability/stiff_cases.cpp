// SPDX-License-Identifier: MIT
// Curves and surfaces whose parameters, shapes or weights are out of proportion.
#include "cases.h"
#include "studio.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

namespace stability {
namespace {

/// Not at the origin, not along an axis, no round numbers.
const studio oblique{{{2.5, 3.1, 6.3}, {0.4, 0.2, -0.3}, {0.1, 1, 0.05}, 41, 0.2}, {173, 131}};

/// Weights a million times as small and as large as 1.
studio for_weights() {
    studio result = oblique;
    result.eye.near = 1e-7;
    return result;
}

std::string power(const char* what, int exponent) {
    return std::string(what) + " 1e" + std::to_string(exponent);
}

/// The four places that stand for 0, 1/3, 2/3 and 1.
using places = std::array<double, 4>;

double at(const places& along, double parameter) {
    return along[static_cast<std::size_t>(std::lround(3 * parameter))];
}

/// A bent sheet whose control points along u and v stand at these places of its sides.
reference::patch sheet(const studio& in, const places& along_u, const places& along_v) {
    return in.patch([&](double u, double v) {
        const double a = at(along_u, u), b = at(along_v, v);
        return seen_point{0.11 + 0.74 * a + 0.09 * b, 0.08 + 0.07 * a + 0.79 * b,
                          2.3 + 0.8 * a * (1 - b) - 0.3 * b};
    });
}

constexpr places even{0, 1.0 / 3, 2.0 / 3, 1};

class collection {
public:
    explicit collection(std::vector<test_case>& cases) : cases_(cases) {}

    void add(const studio& in, const char* group, std::string name, const reference::patch& p) {
        add_case(cases_, in, group, std::move(name), p);
    }

    /// Along u, along v and along both.
    void add_ways(const char* group, const std::string& name, const places& along) {
        add(oblique, group, name + ", along u", sheet(oblique, along, even));
        add(oblique, group, name + ", along v", sheet(oblique, even, along));
        add(oblique, group, name + ", along both", sheet(oblique, along, along));
    }

private:
    std::vector<test_case>& cases_;
};

/// The speeds at both ends, 3 (p1 - p0) and 3 (p3 - p2), differ by the factor.
void add_speeds(collection& to) {
    for (int exponent = 3; exponent <= 9; ++exponent) {
        const double slow = std::pow(10, -exponent);
        to.add_ways("speed", power("speeds differ by", exponent), {0, slow, std::sqrt(slow), 1});
    }
    to.add_ways("speed", "stands still at one end", {0, 0, 0.6, 1});
    to.add_ways("speed", "stands still twice at one end", {0, 0, 0, 1});
    to.add_ways("speed", "stands still at both ends", {0, 0, 1, 1});
}

/// x = 0, 1, 0, 1 turns back twice; x = 0, 1, -y, ... has a cusp where both derivatives vanish.
void add_cusps(collection& to) {
    const studio& in = oblique;
    for (const double off : {0.0, 1e-3, 1e-6, 1e-9, 1e-12, -1e-3, -1e-6, -1e-9, -1e-12}) {
        // (0,0) (1,1) (0,1) (1,0) has its cusp at the parameter 1/2.
        const places x{0, 1 + off, 0, 1}, y{0, 1, 1, 0};
        char text[40];
        std::snprintf(text, sizeof text, "missed by %g", off);
        const auto add = [&](const char* way, bool along_u) {
            to.add(in, "cusp", std::string(text) + way, in.patch([&](double u, double v) {
                const double along = along_u ? u : v, across = along_u ? v : u;
                return seen_point{0.15 + 0.6 * at(x, along) + 0.1 * across,
                                  0.1 + 0.3 * at(y, along) + 0.5 * across,
                                  2 + 0.4 * across + along};
            }));
        };
        add(", along u", true);
        add(", along v", false);
    }
    to.add_ways("cusp", "back and forth", {0, 1.3, -0.3, 1});
}

void add_coincident(collection& to) {
    numbers random(11);
    for (const int exponent : {0, -2, -4, -6, -9, -12, -15}) {
        const double spread = std::pow(10, exponent);
        to.add(oblique, "coincident", power("all within parts of the picture", exponent),
               oblique.patch([&](double, double) {
                   return seen_point{0.43 + spread * random.between(-1, 1),
                                     0.57 + spread * random.between(-1, 1),
                                     2 + spread * random.between(-1, 1)};
               }));
        to.add(oblique, "coincident", power("two inner points within", exponent),
               sheet(oblique, {0, 0.5, 0.5 + spread, 1}, even));
        to.add(oblique, "coincident", power("three rows within", exponent),
               sheet(oblique, even, {0, 1 - spread, 1 - spread / 2, 1}));
    }
}

void add_needles(collection& to) {
    for (int exponent = 1; exponent <= 8; ++exponent) {
        const double thin = std::pow(10, -exponent);
        const auto scaled = [&](double by) {
            return places{0.4, 0.4 + by / 3, 0.4 + 2 * by / 3, 0.4 + by};
        };
        to.add(oblique, "needle", power("aspect", exponent) + ", along u",
               sheet(oblique, even, scaled(thin)));
        to.add(oblique, "needle", power("aspect", exponent) + ", along v",
               sheet(oblique, scaled(thin), even));
        to.add(oblique, "needle", power("aspect", exponent) + ", aslant",
               oblique.patch([&](double u, double v) {
                   return seen_point{0.05 + 0.9 * u + thin * v * (1 + u * (1 - u)),
                                     0.9 - 0.8 * u + thin * v, 2 + u + thin * v};
               }));
        // As wide as a pixel's eighth, and far beyond both sides.
        const double longer = std::pow(10, exponent - 2);
        to.add(
            oblique, "needle", power("pictures long", exponent - 2),
            oblique.patch([&](double u, double v) {
                return seen_point{0.5 + longer * (u - 0.5), 0.3 + 0.4 * u + 0.001 * v, 2 + 0.3 * u};
            }));
    }
}

/// p = 0, d, -d, 1: the third difference is 6 d + 1, the chord 1.
void add_third_differences(collection& to) {
    for (int exponent = 1; exponent <= 7; ++exponent) {
        const double d = std::pow(10, exponent) / 6;
        to.add_ways("third difference", power("to the chord", exponent), {0, d, -d, 1});
    }
}

/// A control point's distance is its weight: these are rational patches.
void add_weights(collection& to, const studio& in, const char* group) {
    using weight = std::function<double(double u, double v)>;
    for (int exponent = 1; exponent <= 6; ++exponent) {
        const double e = exponent;
        numbers random(static_cast<std::uint64_t>(exponent));
        const auto ten_to = [](double x) { return std::pow(10, x); };
        const auto is_inner = [](double t) { return t > 0 && t < 1; };
        const std::pair<const char*, weight> patterns[] = {
            {"rising along u", [&](double u, double) { return ten_to(e * (2 * u - 1)); }},
            {"rising along both", [&](double u, double v) { return ten_to(e * (u + v - 1)); }},
            {"heavy corner", [&](double u, double v) { return ten_to(u == 0 && v == 1 ? e : -e); }},
            {"light corner", [&](double u, double v) { return ten_to(u == 1 && v == 0 ? -e : e); }},
            {"heavy middle",
             [&](double u, double v) { return ten_to(is_inner(u) && is_inner(v) ? e : -e); }},
            {"like a chessboard",
             [&](double u, double v) {
                 return ten_to(std::lround(3 * u + 3 * v) % 2 == 0 ? e : -e);
             }},
            {"random", [&](double, double) { return ten_to(random.between(-e, e)); }},
        };
        for (const auto& [name, weight_of] : patterns)
            to.add(in, group, power(name, exponent),
                   in.patch([&weight_of = weight_of](double u, double v) {
                       return seen_point{0.1 + 0.7 * u + 0.1 * v * v, 0.1 + 0.1 * u * u + 0.7 * v,
                                         weight_of(u, v)};
                   }));
    }
}

} // namespace

std::vector<test_case> stiff_cases() {
    std::vector<test_case> result;
    collection to(result);
    add_speeds(to);
    add_cusps(to);
    add_coincident(to);
    add_needles(to);
    add_third_differences(to);
    add_weights(to, for_weights(), "weights");
    // In a world far from its origin the same weights are differences of large numbers.
    studio away = for_weights();
    away.eye.eye = {1002.5, -3003.1, 5006.3};
    away.eye.target = {1000.4, -3006, 4999.7};
    add_weights(to, away, "weights, far off");
    return result;
}

} // namespace stability
