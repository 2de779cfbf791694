// SPDX-License-Identifier: MIT
// section_keys: lays planes through the middle of a model, and moves them along their normals.
#include "section_keys.h"

#include <array>
#include <charconv>
#include <cstddef>

namespace {

using vector = section_keys::vector;

constexpr std::array<const char*, 3> names{"x", "y", "z"};

vector along(std::size_t axis) {
    vector result{0.0, 0.0, 0.0};
    result[static_cast<int>(axis)] = 1;
    return result;
}

/// The axis that a normal points along or against. For a normal along no axis it is the number of
/// axes.
std::size_t axis_of(const vector& normal) {
    std::size_t axis = 0;
    while (axis < names.size() && normal != along(axis) && normal != -along(axis))
        ++axis;
    return axis;
}

/// The shortest text that reads as these numbers again.
std::string text_of(const vector& v) {
    std::string result;
    for (int i = 0; i < 3; ++i) {
        std::array<char, 32> text{};                // the longest double has 24 characters
        const double number = v[i] == 0 ? 0 : v[i]; // no -0
        const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
        result += (i > 0 ? "," : "") + std::string(text.data(), end);
    }
    return result;
}

} // namespace

std::string section_keys::take_next(const l3d_reach& reach) {
    const std::size_t next = plane_ ? axis_of(plane_->normal) + 1 : 0;
    if (next >= names.size()) {
        plane_.reset();
        return "no section";
    }
    const vector axis = along(next);
    const double middle = (reach(axis) - reach(-axis)) / 2;
    plane_ = {-axis, middle};
    return text();
}

std::string section_keys::move(double part, const l3d_reach& reach) {
    if (!plane_)
        return "no section to move; / makes one";
    plane_->d += part * (reach(plane_->normal) + reach(-plane_->normal));
    return text();
}

std::string section_keys::flip() {
    if (!plane_)
        return "no section to turn; / makes one";
    plane_ = plane_->flipped();
    return text();
}

std::string section_keys::text() const {
    const std::size_t axis = axis_of(plane_->normal);
    const vector place = plane_->normal * -plane_->d;
    if (axis == names.size())
        return "section at " + text_of(place);
    const double at = place[static_cast<int>(axis)];
    std::array<char, 32> number{}; // six digits, a sign, a point and an exponent
    const auto end = std::to_chars(number.data(), number.data() + number.size(), at,
                                   std::chars_format::general, 6)
                         .ptr;
    const bool keeps_larger = plane_->normal[static_cast<int>(axis)] > 0;
    return std::string("section: ") + names[axis] + (keeps_larger ? " above " : " below ") +
           std::string(number.data(), end);
}

std::string section_keys::options() const {
    if (!plane_)
        return "";
    return " --section " + text_of(plane_->normal) + " --section-at " +
           text_of(plane_->normal * -plane_->d);
}
