// SPDX-License-Identifier: MIT
// l3d_afd_options: reads lights and fog, which are lists of numbers with a colour at the end.
#include "system/options/afd_options.h"

#include "base/error.h"
#include "base/printable_p.h"
#include "system/options/color_text_p.h"
#include "system/options/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace {

/// Reads N numbers at the beginning of a list, and returns the text after the comma that follows
/// the numbers, such as a colour. The result is empty if there is no further comma.
/// Errors:  returns nothing for fewer numbers, or if no text follows the comma.
template <std::size_t N>
std::optional<std::string_view> read_before_color(std::string_view text,
                                                  std::array<double, N>& numbers) {
    std::size_t end = text.find(',');
    for (std::size_t i = 1; i < N && end != text.npos; ++i)
        end = text.find(',', end + 1);
    if (!l3d_read_numbers(text.substr(0, end), ',', numbers) || end + 1 == text.size())
        return {};
    return end == text.npos ? "" : text.substr(end + 1);
}

} // namespace

/// Adds the light that one option --light describes. The first --light replaces the usual light.
void l3d_afd_options::add_light(const std::string& text) {
    std::array<double, 3> direction{};
    const auto rest = read_before_color(text, direction);
    if (!rest)
        throw l3d_error(l3d_exit::usage, "--light: '" + l3d_detail::printable(text) +
                                             "' is neither X,Y,Z nor X,Y,Z,COLOR");
    l3d_camera::vector towards{direction[0], direction[1], direction[2]};
    const double most =
        std::max({std::abs(towards[0]), std::abs(towards[1]), std::abs(towards[2])});
    if (most == 0)
        throw l3d_error(l3d_exit::usage, "--light: '" + text + "' has no direction");
    if (!(most > 1e-100 && most < 1e100)) // squares of others would be infinite or zero
        towards = towards / most;
    const l3d_light_color color =
        l3d_detail::read_light_color("--light", rest->empty() ? "white" : *rest);
    l3d_lighting& lighting = settings_.lighting;
    if (!gives_light_) {
        settings_.light = towards;
        lighting.color = color;
    } else if (lighting.count == l3d_lighting::most_further) {
        throw l3d_error(l3d_exit::usage, "--light: '" + text + "' is one more than " +
                                             std::to_string(l3d_lighting::most_further + 1));
    } else {
        lighting.add(towards, color);
    }
    gives_light_ = true;
}

/// Adds the light that one option --point-light describes. Without --light, point lights are the
/// only lights.
void l3d_afd_options::add_point_light(const std::string& text) {
    std::array<double, 4> numbers{};
    const auto rest = read_before_color(text, numbers);
    const auto most = static_cast<double>(std::numeric_limits<float>::max());
    if (!rest || !(numbers[3] >= 0) ||
        !std::ranges::all_of(numbers, [most](double number) { return std::abs(number) <= most; }))
        throw l3d_error(l3d_exit::usage, "--point-light: '" + l3d_detail::printable(text) +
                                             "' is neither X,Y,Z,REACH nor X,Y,Z,REACH,COLOR");
    l3d_lighting& lighting = settings_.lighting;
    if (lighting.point_count == l3d_lighting::most_points)
        throw l3d_error(l3d_exit::usage, "--point-light: '" + text + "' is one more than " +
                                             std::to_string(l3d_lighting::most_points));
    lighting.add_point(
        {.position = {numbers[0], numbers[1], numbers[2]},
         .reach = static_cast<float>(numbers[3]),
         .color = l3d_detail::read_light_color("--point-light", rest->empty() ? "white" : *rest)});
}

void l3d_afd_options::read_fog(const std::string& text) {
    std::array<double, 2> distances{};
    l3d_fog fog;
    const auto rest = read_before_color(text, distances);
    fog.from = static_cast<float>(distances[0]);
    fog.to = static_cast<float>(distances[1]);
    if (!rest ||
        !(distances[0] >= 0 && fog.is_on() && distances[1] <= std::numeric_limits<double>::max()))
        throw l3d_error(l3d_exit::usage,
                        "--fog: '" + l3d_detail::printable(text) +
                            "' is not NEAR,FAR or NEAR,FAR,COLOR with distances from 0 on, the "
                            "nearer first");
    if (!rest->empty())
        fog.color = l3d_detail::read_paint(*rest);
    if (!rest->empty() && !fog.color)
        throw l3d_error(l3d_exit::usage, "--fog: '" + l3d_detail::printable(*rest) + "' is not " +
                                             l3d_detail::color_forms +
                                             l3d_detail::meant_color(*rest));
    settings_.fog = fog;
}
