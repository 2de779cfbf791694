// SPDX-License-Identifier: MIT
// Balls and rings.
#include "bodies.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dice_tests {
namespace {

using reference::patch;
using reference::vec3;

/// A control point on a cube's face from its place there, 0 to 3 each way, and the face's side.
///
/// Shape: corners at 1 / sqrt(3); points of edges so that arcs between corners are nearly circles
///        about the origin; inner points so that a face's middle has distance 1.
std::array<double, 3> on_face(int i, int j, double side) {
    constexpr double corner = 0.57735026918962576, along = 0.2314, beside = 0.7503;
    constexpr double inner = 0.32, above = 1.2134;
    const auto sign = [](int k) { return k < 2 ? -1.0 : 1.0; };
    const bool end_i = i == 0 || i == 3, end_j = j == 0 || j == 3;
    if (end_i && end_j)
        return {sign(i) * corner, sign(j) * corner, side * corner};
    if (end_i)
        return {sign(i) * beside, sign(j) * along, side * beside};
    if (end_j)
        return {sign(i) * along, sign(j) * beside, side * beside};
    return {sign(i) * inner, sign(j) * inner, side * above};
}

/// Control points of a unit circle, three for each quarter.
std::pair<double, double> on_circle(int i) {
    constexpr double arc = 0.5522847498307936;
    constexpr std::array<double, 12> cosines{1, 1, arc, 0, -arc, -1, -1, -1, -arc, 0, arc, 1};
    const auto at = [&](int k) { return cosines[static_cast<std::size_t>((k + 12) % 12)]; };
    return {at(i), at(i - 3)};
}

/// Halves along u. Reversed edges get the same points reversed, bit for bit.
std::array<patch, 2> halves(const patch& whole) {
    std::array<patch, 2> result;
    const auto middle = [](const vec3& a, const vec3& b) -> vec3 {
        return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
    };
    for (std::size_t row = 0; row < 16; row += 4) {
        const vec3* const p = &whole.points[row];
        const vec3 a = middle(p[0], p[1]), b = middle(p[1], p[2]), c = middle(p[2], p[3]);
        const vec3 ab = middle(a, b), bc = middle(b, c), all = middle(ab, bc);
        const std::array<vec3, 7> line{p[0], a, ab, all, bc, c, p[3]};
        for (std::size_t i = 0; i < 4; ++i) {
            result[0].points[row + i] = line[i];
            result[1].points[row + i] = line[i + 3];
        }
    }
    return result;
}

patch transposed(const patch& p) {
    patch result;
    for (std::size_t i = 0; i < 16; ++i)
        result.points[4 * (i % 4) + i / 4] = p.points[i];
    return result;
}

/// Each patch as four.
std::vector<patch> quartered(const std::vector<patch>& patches) {
    std::vector<patch> result;
    for (const patch& whole : patches)
        for (const patch& half : halves(whole))
            for (const patch& quarter : halves(transposed(half)))
                result.push_back(transposed(quarter));
    return result;
}

/// What is the same function of each point keeps common edges common.
template <class Move> std::vector<patch> moved(std::vector<patch> patches, Move move) {
    for (patch& p : patches)
        for (vec3& point : p.points)
            point = move(point);
    return patches;
}

std::vector<patch> waved(std::vector<patch> patches, reference::random_numbers& random,
                         double height) {
    std::array<double, 12> wave;
    for (double& number : wave)
        number = random.between(-2, 2);
    const double twist = random.between(-1, 1);
    return moved(std::move(patches), [&](const vec3& p) -> vec3 {
        const auto at = [&](std::size_t i) {
            return height *
                   std::sin(wave[i] * p.x + wave[i + 1] * p.y + wave[i + 2] * p.z + wave[i + 3]);
        };
        const double x = p.x + at(0), y = p.y + at(4), z = p.z + at(8);
        const double cosine = std::cos(twist * p.y), sine = std::sin(twist * p.y);
        return {cosine * x - sine * z, y, sine * x + cosine * z};
    });
}

std::vector<patch> with_arms(std::vector<patch> patches, reference::random_numbers& random) {
    const auto arms = static_cast<double>(3 + random.below(5));
    const double depth = random.between(0.05, 0.45), phase = random.between(0, 7);
    const double thickness = random.between(0.2, 1);
    return moved(std::move(patches), [&](const vec3& p) -> vec3 {
        const double out = std::hypot(p.x, p.z) / std::hypot(p.x, p.y, p.z);
        const double reach = 1 + depth * out * std::cos(arms * std::atan2(p.z, p.x) + phase);
        return {reach * p.x, thickness * p.y, reach * p.z};
    });
}

} // namespace

std::vector<patch> ball() {
    std::vector<patch> result;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0}) {
            patch& face = result.emplace_back();
            for (int row = 0; row < 4; ++row)
                for (int column = 0; column < 4; ++column) {
                    const auto p =
                        side > 0 ? on_face(column, row, side) : on_face(row, column, side);
                    std::array<double, 3> at{};
                    for (std::size_t k = 0; k < 3; ++k)
                        at[(axis + 1 + k) % 3] = p[k];
                    face.points[static_cast<std::size_t>(4 * row + column)] = {at[0], at[1], at[2]};
                }
        }
    return result;
}

std::vector<patch> ring(double radius, double thickness) {
    std::vector<patch> result;
    for (int around = 0; around < 12; around += 3)
        for (int across = 0; across < 12; across += 3) {
            patch& piece = result.emplace_back();
            for (int row = 0; row < 4; ++row)
                for (int column = 0; column < 4; ++column) {
                    const auto [x, z] = on_circle(around + row);
                    const auto [out, up] = on_circle(across + column);
                    const double r = radius + thickness * out;
                    piece.points[static_cast<std::size_t>(4 * row + column)] = {
                        r * x, thickness * up, r * z};
                }
        }
    return result;
}

std::vector<patch> globe() {
    std::vector<patch> result;
    for (int around = 0; around < 12; around += 3)
        for (const int south : {-3, 0}) {
            patch& piece = result.emplace_back();
            for (int row = 0; row < 4; ++row)
                for (int column = 0; column < 4; ++column) {
                    const auto [x, z] = on_circle(around + row);
                    const auto [out, up] = on_circle(south + column + 12);
                    piece.points[static_cast<std::size_t>(4 * row + column)] = {out * x, up,
                                                                                out * z};
                }
        }
    return result;
}

std::vector<patch> random_body(reference::random_numbers& random, body_kind kind) {
    switch (kind) {
    case body_kind::bent:
        return waved(ball(), random, random.between(0, 0.3));
    case body_kind::flattened: {
        const double thickness = random.of_any_size(0.05, 1);
        return moved(waved(globe(), random, random.between(0, 0.1)), [&](const vec3& p) -> vec3 {
            return {p.x, thickness * p.y, p.z};
        });
    }
    case body_kind::toroidal:
        return waved(ring(1.2, random.between(0.1, 0.7)), random, random.between(0, 0.2));
    case body_kind::starfish:
        break;
    }
    return with_arms(quartered(ball()), random);
}

std::vector<patch> placed(std::vector<patch> patches, const l3d_matrix<double>& placement) {
    return moved(std::move(patches), [&](const vec3& p) -> vec3 {
        const auto there = placement * l3d_vector<double, 4>(p.x, p.y, p.z, 1.0);
        return {there[0], there[1], there[2]};
    });
}

std::vector<patch> inside_out(std::vector<patch> patches) {
    for (patch& p : patches)
        for (std::size_t row = 0; row < 16; row += 4) {
            std::swap(p.points[row], p.points[row + 3]);
            std::swap(p.points[row + 1], p.points[row + 2]);
        }
    return patches;
}

} // namespace dice_tests
