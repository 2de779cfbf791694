// SPDX-License-Identifier: MIT
// Random surfaces, made in the picture and carried into the world.
#include "reference/random_patches.h"

#include "reference/random_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace reference {
namespace {

/// A control point where it is made: picture position and distance.
struct seen_point {
    double x, y, w;
};
using seen_net = std::array<seen_point, 16>;

/// A turned rectangle of 4 x 4 points.
struct frame_2d {
    double x, y, angle, length_u, length_v;
};

frame_2d random_frame(random_numbers& random, picture_size size) {
    const double least = std::min(size.width, size.height);
    return {random.between(0, size.width), random.between(0, size.height),
            random.between(0, 2 * std::numbers::pi), least * random.between(0.05, 0.5),
            least * random.between(0.05, 0.5)};
}

/// Shape: `at` holds the four positions along u and v, 0 to 1; jitter in cells; depth as a ratio.
seen_net make_seen(random_numbers& random, const frame_2d& where, const std::array<double, 4>& at,
                   double jitter, double depth, double w) {
    seen_net result{};
    const double c = std::cos(where.angle), s = std::sin(where.angle);
    for (std::size_t k = 0; k < 16; ++k) {
        const double a = where.length_u * (at[k % 4] - 0.5 + random.between(-jitter, jitter) / 3);
        const double b = where.length_v * (at[k / 4] - 0.5 + random.between(-jitter, jitter) / 3);
        result[k] = {where.x + c * a - s * b, where.y + s * a + c * b,
                     w * std::exp(random.between(-depth, depth))};
    }
    return result;
}

void collapse(random_numbers& random, seen_net& net) {
    const std::size_t ways = 1 + random.below(3);
    for (std::size_t n = 0; n < ways; ++n) {
        const std::size_t line = random.below(2) * 3, from = random.below(16);
        switch (random.below(4)) {
        case 0: // one edge along u
            for (std::size_t i = 0; i < 4; ++i)
                net[4 * line + i] = net[4 * line];
            break;
        case 1: // one edge along v
            for (std::size_t i = 0; i < 4; ++i)
                net[4 * i + line] = net[line];
            break;
        case 2: // two points
            net[random.below(16)] = net[from];
            break;
        default: // the inner points of a boundary row with its end: speed 0 there
            net[4 * line + 1] = net[4 * line];
            net[4 * line + 2] = net[4 * line + 3];
        }
    }
}

seen_net make_kind(random_numbers& random, patch_kind kind, double w, picture_size size) {
    constexpr std::array<double, 4> even{0, 1.0 / 3, 2.0 / 3, 1};
    frame_2d where = random_frame(random, size);
    switch (kind) {
    case patch_kind::thin:
        (random.below(2) ? where.length_u : where.length_v) *= std::pow(10, random.between(-6, 0));
        return make_seen(random, where, even, 0.3, 0.3, w);
    case patch_kind::folded:
        return make_seen(random, where, even, 2.5, 0.4, w);
    case patch_kind::coincident: {
        seen_net net = make_seen(random, where, even, 0.3, 0.2, w);
        collapse(random, net);
        return net;
    }
    case patch_kind::stiff: {
        // Speeds 3 (p1 - p0) and 3 (p3 - p2) differ by up to 1e6.
        const double slow = std::pow(10, random.between(-6, -1));
        return make_seen(random, where, {0, slow, std::sqrt(slow), 1}, slow / 3, 0.2, w);
    }
    case patch_kind::moderate:
        break;
    }
    return make_seen(random, where, even, 0.4, 0.2, w);
}

/// The patch with its parameters mirrored and exchanged: eight ways.
patch turned(const patch& from, std::size_t way) {
    patch result;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
            const std::size_t r = way & 1 ? 3 - row : row, c = way & 2 ? 3 - column : column;
            result.points[4 * row + column] = from.points[way & 4 ? 4 * c + r : 4 * r + c];
        }
    return result;
}

/// A control point position along one side of the lattice: the first and last lie beyond the window
/// whatever the jitter (they are moved outward only), the others anywhere near their place.
double lattice_position(random_numbers& random, std::size_t i, std::size_t last, double extent,
                        double fold) {
    const double beyond = 0.2 * extent, cell = 1.4 * extent / static_cast<double>(last);
    const double place = -beyond + cell * static_cast<double>(i);
    if (i == 0)
        return place - random.between(0, 0.5) * cell;
    if (i == last)
        return place + random.between(0, 0.5) * cell;
    return place + random.between(-fold, fold) * cell;
}

} // namespace

std::vector<patch> random_patches(std::uint64_t seed, patch_kind kind, int count,
                                  const camera& view, picture_size size) {
    random_numbers random(seed);
    const camera_frame frame(view, size);
    std::vector<patch> result(static_cast<std::size_t>(count));
    for (patch& surface : result) {
        // 4 near * exp(-0.4) > 2 near.
        const double w = view.near * random.between(4, 40);
        const seen_net net = make_kind(random, kind, w, size);
        for (std::size_t k = 0; k < 16; ++k)
            surface.points[k] = frame.unproject(net[k].x, net[k].y, net[k].w);
    }
    return result;
}

std::vector<patch> random_tiling(std::uint64_t seed, int k, double fold, double depth,
                                 const camera& view, picture_size size) {
    random_numbers random(seed);
    const camera_frame frame(view, size);
    const std::size_t tiles = static_cast<std::size_t>(k), last = 3 * tiles, side = last + 1;
    const double w = view.near * (1 + depth) * random.between(4, 40);
    std::vector<vec3> lattice(side * side);
    for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i) {
            const double x = lattice_position(random, i, last, size.width, fold);
            const double y = lattice_position(random, j, last, size.height, fold);
            lattice[j * side + i] = frame.unproject(x, y, w / (1 + random.between(0, depth)));
        }
    std::vector<patch> result;
    for (std::size_t j = 0; j < tiles; ++j)
        for (std::size_t i = 0; i < tiles; ++i) {
            patch tile;
            for (std::size_t p = 0; p < 16; ++p)
                tile.points[p] = lattice[(3 * j + p / 4) * side + 3 * i + p % 4];
            result.push_back(turned(tile, random.below(8)));
        }
    return result;
}

} // namespace reference
