// SPDX-License-Identifier: MIT
// l3d_save_screenshot: finding a free name.
#include "system/screenshot.h"

#include "system/reason_p.h"
#include "tool_2d/image_file.h"

#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>

std::string l3d_save_screenshot(const l3d_pixels& pixels) {
    constexpr int most = 9999;
    for (int number = 1; number <= most; ++number) {
        std::array<char, 32> name{};
        std::snprintf(name.data(), name.size(), "l3d-%04d.png", number);
        // A link that leads nowhere is somebody's name, too.
        std::error_code problem;
        const auto type = std::filesystem::symlink_status(name.data(), problem).type();
        if (type == std::filesystem::file_type::none)
            return "not saved: " + problem.message();
        if (type != std::filesystem::file_type::not_found)
            continue;
        try {
            l3d_write_png(name.data(), pixels);
        } catch (const std::exception& error) {
            return l3d_detail::reason_of(error);
        }
        return std::string("saved ") + name.data();
    }
    return "not saved: l3d-0001.png to l3d-9999.png exist";
}
