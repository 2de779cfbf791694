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

/// The word that stands for a colour in --help. color_forms tells the forms of a colour, for
/// messages and --help.
inline constexpr const char* color_kind = "COLOR";
inline constexpr const char* color_forms =
    "a colour: R,G,B from 0 to 255, #RGB, #RRGGBB or a name such as orange";

/// Reads a colour: three numbers from 0 to 255, hexadecimal digits after #, or a name of CSS.
/// Units:   levels from 0 to 255, which may have fractions.
/// Errors:  returns nothing for any other text.
std::optional<std::array<double, 3>> read_color(std::string_view text);

/// Reads a light's colour. The result's channels are parts of full light, from 0 to 1.
/// Errors:  l3d_error(usage) that names the option and its value.
l3d_light_color read_light_color(const char* option, std::string_view text);

/// Reads a colour as the pixel word 0x00RRGGBB.
/// Errors:  returns nothing for a text that read_color refuses, or for levels that are not whole.
std::optional<std::uint32_t> read_paint(std::string_view text);

/// A question for messages, such as "; did you mean 'red'?", if `text` is almost a colour's name;
/// otherwise "".
std::string meant_color(std::string_view text);

/// All names of colours, with blanks between them.
std::string color_names();

} // namespace l3d_detail

#endif
