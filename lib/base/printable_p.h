// SPDX-License-Identifier: MIT
// printable: makes texts of others fit for messages on a terminal.
#ifndef L3D_BASE_PRINTABLE_P_H
#define L3D_BASE_PRINTABLE_P_H

#include <cstddef>
#include <string>
#include <string_view>

namespace l3d_detail {

/// The number of bytes of the UTF-8 character at the beginning of a text. It is 0 for a control
/// character, and for bytes that are not UTF-8. Overlong forms are not UTF-8. Overlong forms of
/// control characters begin with 0xC0, 0xE0 0x80 or 0xF0 0x80.
/// Expects: the text is not empty.
inline std::size_t printable_size(std::string_view text) {
    const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80)
        return first >= ' ' && first != 0x7f ? 1 : 0;
    const std::size_t size = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    if (size == 0 || first > 0xf4 || text.size() < size)
        return 0;
    for (std::size_t i = 1; i < size; ++i)
        if ((byte(i) & 0xc0) != 0x80)
            return 0;
    const bool controls = first == 0xc2 && byte(1) < 0xa0; // U+0080 to U+009F
    const bool overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
    return controls || overlong ? 0 : size;
}

/// Writes control characters and bytes that are not UTF-8 as \xNN. So the text cannot steer a
/// terminal or begin a new line.
inline std::string printable(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string result;
    while (!text.empty()) {
        const std::size_t size = printable_size(text);
        if (size > 0) {
            result += text.substr(0, size);
        } else {
            const auto code = static_cast<unsigned char>(text.front());
            result.append("\\x").append(1, digits[code / 16]).append(1, digits[code % 16]);
        }
        text.remove_prefix(size > 0 ? size : 1);
    }
    return result;
}

} // namespace l3d_detail

#endif
