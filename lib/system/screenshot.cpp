// SPDX-License-Identifier: MIT
// l3d_save_screenshot: finding a free name.
#include "system/screenshot.h"

#include "tool_2d/error.h"
#include "tool_2d/image_file.h"

#include <array>
#include <cstdio>
#include <filesystem>

std::string l3d_save_screenshot(const l3d_pixels& pixels) {
    constexpr int most = 9999;
    for (int number = 1; number <= most; ++number) {
        std::array<char, 32> name{};
        std::snprintf(name.data(), name.size(), "l3d-%04d.png", number);
        if (std::filesystem::exists(name.data()))
            continue;
        try {
            l3d_write_png(name.data(), pixels);
        } catch (const l3d_error& error) {
            return error.what();
        }
        return std::string("saved ") + name.data();
    }
    return "not saved: l3d-0001.png to l3d-9999.png exist";
}
