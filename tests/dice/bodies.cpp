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

std::vector<patch> inside_out(std::vector<patch> patches) {
    for (patch& p : patches)
        for (std::size_t row = 0; row < 16; row += 4) {
            std::swap(p.points[row], p.points[row + 3]);
            std::swap(p.points[row + 1], p.points[row + 2]);
        }
    return patches;
}

} // namespace dice_tests
