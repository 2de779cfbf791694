// SPDX-License-Identifier: MIT
// color_text: reads colours as numbers, as digits and by names.
#include "system/options/color_text_p.h"

#include "base/did_you_mean_p.h"
#include "base/error.h"
#include "base/printable_p.h"
#include "system/options/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <vector>

namespace l3d_detail {
namespace {

struct named_color {
    std::string_view name;
    std::uint32_t word;
};

/// Source: CSS Color Module Level 4, named colours.
constexpr std::array<named_color, 25> named_colors{
    {{"black", 0x000000},  {"white", 0xffffff},  {"gray", 0x808080},    {"grey", 0x808080},
     {"silver", 0xc0c0c0}, {"red", 0xff0000},    {"maroon", 0x800000},  {"orange", 0xffa500},
     {"brown", 0xa52a2a},  {"yellow", 0xffff00}, {"gold", 0xffd700},    {"olive", 0x808000},
     {"lime", 0x00ff00},   {"green", 0x008000},  {"teal", 0x008080},    {"cyan", 0x00ffff},
     {"aqua", 0x00ffff},   {"blue", 0x0000ff},   {"navy", 0x000080},    {"indigo", 0x4b0082},
     {"violet", 0xee82ee}, {"purple", 0x800080}, {"magenta", 0xff00ff}, {"fuchsia", 0xff00ff},
     {"pink", 0xffc0cb}}};

std::array<double, 3> levels_of(std::uint32_t word) {
    return {static_cast<double>(word >> 16 & 255), static_cast<double>(word >> 8 & 255),
            static_cast<double>(word & 255)};
}

/// Reads a colour in hexadecimal digits: RRGGBB, or RGB, in which each digit stands for two: f for
/// ff.
std::optional<std::uint32_t> read_digits(std::string_view digits) {
    std::string six(digits);
    if (digits.size() == 3)
        six = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
    std::uint32_t word = 0;
    const auto [stop, error] = std::from_chars(six.data(), six.data() + six.size(), word, 16);
    if (six.size() != 6 || error != std::errc() || stop != six.data() + six.size())
        return {};
    return word;
}

} // namespace

std::optional<std::array<double, 3>> read_color(std::string_view text) {
    constexpr double most = 255;
    if (text.starts_with('#')) {
        const auto word = read_digits(text.substr(1));
        return word ? std::optional(levels_of(*word)) : std::nullopt;
    }
    const auto* const named = std::ranges::find(named_colors, text, &named_color::name);
    if (named != named_colors.end())
        return levels_of(named->word);
    std::array<double, 3> levels{};
    const auto is_level = [](double level) { return level >= 0 && level <= most; };
    if (!l3d_read_numbers(text, ',', levels) || !std::ranges::all_of(levels, is_level))
        return {};
    return levels;
}

std::optional<std::uint32_t> read_paint(std::string_view text) {
    const auto levels = read_color(text);
    if (!levels || !std::ranges::all_of(*levels, [](double l) { return l == std::floor(l); }))
        return {};
    std::uint32_t word = 0;
    for (const double level : *levels)
        word = word << 8 | static_cast<std::uint32_t>(level);
    return word;
}

std::string meant_color(std::string_view text) {
    std::vector<std::string_view> names;
    for (const named_color& color : named_colors)
        names.push_back(color.name);
    return did_you_mean(text, names);
}

std::string color_names() {
    std::string names;
    for (const named_color& color : named_colors)
        names.append(names.empty() ? "" : " ").append(color.name);
    return names;
}

l3d_light_color read_light_color(const char* option, std::string_view text) {
    constexpr double white = 255;
    const auto levels = read_color(text);
    if (!levels)
        throw l3d_error(l3d_exit::usage, std::string(option) + ": '" + printable(text) +
                                             "' is not " + color_forms + meant_color(text));
    l3d_light_color result{};
    std::ranges::transform(*levels, result.begin(),
                           [](double level) { return static_cast<float>(level / white); });
    return result;
}

} // namespace l3d_detail
