// SPDX-License-Identifier: MIT
// counted: a number and what it counts, as "1 patch" and "2 patches".
#ifndef L3D_BASE_COUNTED_P_H
#define L3D_BASE_COUNTED_P_H

#include <cstddef>
#include <string>
#include <string_view>

namespace l3d_detail {

/// Joins a number and its noun, as in "1 patch" and "2 patches".
/// Expects: `things` is the noun's plural, which must end with s: patches, faces, polygons.
inline std::string counted(std::string number, std::string_view things) {
    if (number == "1")
        things.remove_suffix(things.ends_with("ches") ? 2 : 1);
    return number.append(" ").append(things);
}

inline std::string counted(std::size_t count, std::string_view things) {
    return counted(std::to_string(count), things);
}

} // namespace l3d_detail

#endif
