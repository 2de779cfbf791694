// SPDX-License-Identifier: MIT
// take_character: reads UTF-8, character by character.
#ifndef L3D_RASTER_TEXT_UTF8_P_H
#define L3D_RASTER_TEXT_UTF8_P_H

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace l3d_detail {

/// The character that stands for bytes without a meaning.
inline constexpr char32_t replacement_character = 0xfffd;

/// Takes the first character off a text in UTF-8. Half of a surrogate pair counts as
/// replacement_character, and so does a byte that does not begin the shortest form of a character.
/// Expects: the text is not empty.
/// Source: RFC 3629.
inline char32_t take_character(std::string_view& text) {
    const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    std::size_t length = 1;
    char32_t code = first;
    char32_t least = 0; // least code that needs so many bytes
    if (first >= 0xf0 && first < 0xf5) {
        length = 4;
        code = first & 7;
        least = 0x10000;
    } else if (first >= 0xe0 && first < 0xf0) {
        length = 3;
        code = first & 15;
        least = 0x800;
    } else if (first >= 0xc2 && first < 0xe0) {
        length = 2;
        code = first & 31;
        least = 0x80;
    } else if (first >= 0x80) {
        code = replacement_character;
    }
    bool is_whole = length <= text.size();
    for (std::size_t i = 1; is_whole && i < length; ++i) {
        is_whole = (byte(i) & 0xc0) == 0x80;
        code = code << 6 | (byte(i) & 0x3f);
    }
    if (!is_whole || code < least || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) {
        length = 1;
        code = replacement_character;
    }
    text.remove_prefix(length);
    return code;
}

/// The character that marks where a word may be broken.
inline constexpr char32_t soft_hyphen = 0xad;

/// Whether a character is invisible in a line: a control character other than the tab, a sign that
/// ends a line or paragraph, or a soft hyphen. Code that breaks a line at a soft hyphen shows a
/// hyphen in its place.
constexpr bool is_unseen(char32_t code) {
    const bool is_control = code < 0x20 || (code >= 0x7f && code < 0xa0);
    return (is_control && code != U'\t') || code == soft_hyphen || code == 0x2028 || code == 0x2029;
}

} // namespace l3d_detail

#endif
