// SPDX-License-Identifier: MIT
// formatted: a short line of text with numbers in it.
#ifndef L3D_BASE_FORMATTED_P_H
#define L3D_BASE_FORMATTED_P_H

#include <array>
#include <cstdio>
#include <string>

namespace l3d_detail {

/// As std::snprintf has it; what is more than 159 characters long is cut.
template <class... Values> std::string formatted(const char* format, Values... values) {
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), format, values...);
    return text.data();
}

} // namespace l3d_detail

#endif
