// SPDX-License-Identifier: MIT
// color_text: the one way to write a colour on a command line.
#ifndef L3D_SYSTEM_OPTIONS_COLOR_TEXT_P_H
#define L3D_SYSTEM_OPTIONS_COLOR_TEXT_P_H

#include "raster/lighting.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace l3d_detail {

/// The word by which --help names this kind of value, and the forms of a colour that messages and
/// --help list.
inline constexpr const char* color_kind = "COLOR";
inline constexpr const char* color_forms =
    "a colour: R,G,B from 0 to 255, #RGB, #RRGGBB or a name such as orange";

/// Reads a colour: three numbers from 0 to 255, hexadecimal digits after #, or a name of CSS.
/// Units:   levels of 255, which may have fractions.
/// Errors:  nothing for any other text.
std::optional<std::array<double, 3>> read_color(std::string_view text);

/// Reads a light's colour. Its channels are parts of full light.
/// Errors:  l3d_error(usage) that names the option and its value.
l3d_light_color read_light_color(const char* option, std::string_view text);

/// Reads a colour as a pixel word, 0x00RRGGBB.
/// Errors:  nothing for a text that read_color refuses, or for levels that are not whole.
std::optional<std::uint32_t> read_paint(std::string_view text);

/// The text "; did you mean 'red'?" if `text` is almost a colour's name, else "".
std::string meant_color(std::string_view text);

/// All names of colours, with blanks between them.
std::string color_names();

} // namespace l3d_detail

#endif
