// SPDX-License-Identifier: MIT
// Random patches: any shape, seen in any way.
#include "cases.h"
#include "studio.h"

#include "reference/random_patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace stability {
namespace {

/// A view of a world whose unit is `scale`, from about `scale` away.
studio random_studio(numbers& random) {
    // Up to 2^13 pixels and down to one; most are small, as large ones cost much to draw.
    constexpr std::array<reference::picture_size, 8> sizes{
        {{64, 48}, {97, 61}, {160, 120}, {317, 241}, {640, 480}, {1, 1}, {5, 300}, {8192, 7}}};
    studio result;
    const double scale = random.below(4) == 0 ? random.of_any_size(1e-9, 1e9) : 1;
    const auto place = [&](double reach) {
        return reference::vec3{scale * random.between(-reach, reach),
                               scale * random.between(-reach, reach),
                               scale * random.between(-reach, reach)};
    };
    result.eye.eye = place(5);
    result.eye.target = place(5);
    result.eye.up = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    result.eye.fov_degrees =
        random.below(4) == 0 ? random.of_any_size(0.01, 179) : random.between(15, 90);
    result.eye.near = scale * random.of_any_size(0.01, 1);
    result.size = sizes[std::min(random.below(16), random.below(sizes.size()))];
    return result;
}

/// An ordinary patch, `width` of the picture's lesser side wide.
reference::patch gentle(numbers& random, const studio& in, double width) {
    const double x = random.between(0, 1), y = random.between(0, 1);
    const double turned = random.between(0, 2 * std::numbers::pi);
    const double least = std::min(in.size.width, in.size.height) * width;
    const double w = in.eye.near * random.between(4, 40);
    return in.patch([&](double u, double v) {
        const double a = least * (u - 0.5 + random.between(-0.13, 0.13));
        const double b = least * (v - 0.5 + random.between(-0.13, 0.13));
        return seen_point{x + (std::cos(turned) * a - std::sin(turned) * b) / in.size.width,
                          y + (std::sin(turned) * a + std::cos(turned) * b) / in.size.height,
                          w * std::exp(random.between(-0.2, 0.2))};
    });
}

reference::patch with_weights(numbers& random, const studio& in) {
    const double most = random.of_any_size(1, 1e6);
    return in.patch([&](double u, double v) {
        return seen_point{u + random.between(-0.3, 0.3), v + random.between(-0.3, 0.3),
                          1.01 * in.eye.near * random.of_any_size(1, most * most)};
    });
}

reference::patch around_the_eye(numbers& random, const studio& in) {
    const double reach = in.eye.near * random.of_any_size(1, 1e4);
    return in.patch([&](double, double) {
        return seen_point{random.between(-1, 2), random.between(-1, 2),
                          random.between(-reach, reach)};
    });
}

/// A smooth sheet through the near plane.
reference::patch crossing(numbers& random, const studio& in) {
    return in.patch([&](double u, double v) {
        return seen_point{u + random.between(-0.2, 0.2), 1 - v + random.between(-0.2, 0.2),
                          in.eye.near * (random.between(-0.3, 0.3) - 1 + 12 * v)};
    });
}

/// Ordinary but for some control points that are thrown away.
reference::patch thrown(numbers& random, const studio& in) {
    const double reach = random.of_any_size(1, 1e5);
    reference::patch result = gentle(random, in, random.between(0.1, 0.8));
    const reference::camera_frame frame(in.eye, in.size);
    for (std::size_t n = 1 + random.below(3); n > 0; --n)
        result.points[random.below(16)] = frame.unproject(
            random.between(-reach, reach) * in.size.width,
            random.between(-reach, reach) * in.size.height, in.eye.near * random.between(1.5, 40));
    return result;
}

/// A needle up to a million times as long as wide, in any direction.
reference::patch needle(numbers& random, const studio& in) {
    const double width = random.of_any_size(1e-6, 1);
    const double x0 = random.between(0, 1), y0 = random.between(0, 1);
    const double x1 = random.between(0, 1), y1 = random.between(0, 1);
    const double near_end = in.eye.near * random.between(2, 20);
    const double far_end = in.eye.near * random.between(2, 20);
    return in.patch([&](double u, double v) {
        const double across = (v - 0.5) * width;
        return seen_point{
            x0 + (x1 - x0) * u - across * (y1 - y0) + random.between(-0.1, 0.1) * width,
            y0 + (y1 - y0) * u + across * (x1 - x0) + random.between(-0.1, 0.1) * width,
            near_end + (far_end - near_end) * u};
    });
}

reference::patch of_reference(numbers& random, const studio& in, reference::patch_kind kind) {
    return random_patches(random.next(), kind, 1, in.eye, in.size).front();
}

/// Far from the origin: what is left of a double's digits is the shape.
reference::patch far_off(numbers& random, studio& in) {
    const double away = random.of_any_size(1, 1e10) * in.eye.near;
    const reference::vec3 by{random.between(-away, away), random.between(-away, away),
                             random.between(-away, away)};
    const auto moved = [&](const reference::vec3& p) {
        return reference::vec3{p.x + by.x, p.y + by.y, p.z + by.z};
    };
    in.eye.eye = moved(in.eye.eye);
    in.eye.target = moved(in.eye.target);
    return gentle(random, in, random.between(0.1, 0.8));
}

constexpr std::array<const char*, 12> kinds{"gentle", "thin",    "folded",     "coincident",
                                            "stiff",  "weights", "around eye", "crossing",
                                            "thrown", "needle",  "far off",    "tiny"};

reference::patch patch_of_kind(std::size_t kind, numbers& random, studio& in) {
    using reference::patch_kind;
    switch (kind) {
    case 1:
        return of_reference(random, in, patch_kind::thin);
    case 2:
        return of_reference(random, in, patch_kind::folded);
    case 3:
        return of_reference(random, in, patch_kind::coincident);
    case 4:
        return of_reference(random, in, patch_kind::stiff);
    case 5:
        return with_weights(random, in);
    case 6:
        return around_the_eye(random, in);
    case 7:
        return crossing(random, in);
    case 8:
        return thrown(random, in);
    case 9:
        return needle(random, in);
    case 10:
        return far_off(random, in);
    case 11:
        return gentle(random, in, random.of_any_size(1e-4, 0.1));
    default:
        return gentle(random, in, random.between(0.05, 0.8));
    }
}

} // namespace

const char* random_kind(std::size_t kind) {
    return kind < kinds.size() ? kinds[kind] : "";
}

namespace {

test_case case_of(std::uint64_t seed, bool parallel) {
    numbers random(seed);
    const std::size_t kind = static_cast<std::size_t>(seed % kinds.size());
    test_case result;
    result.group = kinds[kind];
    result.name = "seed " + std::to_string(seed);
    studio in = random_studio(random);
    in.eye.parallel = parallel;
    result.patches.push_back(patch_of_kind(kind, random, in));
    result.eye = in.eye;
    result.size = in.size;
    result.tolerance = random.of_any_size(0.02, 2);
    return result;
}

} // namespace

test_case random_case(std::uint64_t seed) {
    return case_of(seed, false);
}

test_case parallel_case(std::uint64_t seed) {
    test_case result = case_of(seed, true);
    result.group = "parallel " + result.group;
    return result;
}

test_case ordinary_case(std::uint64_t seed) {
    numbers random(seed);
    test_case result;
    result.group = "ordinary";
    result.name = "seed " + std::to_string(seed);
    const studio in{{{2.5, 3.1, 6.3}, {0.4, 0.2, -0.3}, {0.1, 1, 0.05}, 41, 0.2}, {640, 480}};
    result.patches.push_back(gentle(random, in, random.between(0.05, 0.5)));
    result.eye = in.eye;
    result.size = in.size;
    return result;
}

} // namespace stability
