// SPDX-License-Identifier: MIT
// l3d_save_screenshot: finding a free name.
#include "system/screenshot.h"

#include "base/formatted_p.h"
#include "base/printable_p.h"
#include "system/reason_p.h"
#include "tool_2d/image_file.h"

#include <exception>
#include <filesystem>

std::string l3d_save_screenshot(const l3d_pixels& pixels) {
    std::error_code unknown; // on an error the name alone is told
    const std::filesystem::path folder = std::filesystem::current_path(unknown);
    constexpr int most = 9999;
    for (int number = 1; number <= most; ++number) {
        const std::string name = l3d_detail::formatted("l3d-%04d.png", number);
        // A link that leads nowhere is somebody's name, too.
        std::error_code problem;
        const auto type = std::filesystem::symlink_status(name, problem).type();
        if (type == std::filesystem::file_type::none)
            return "not saved: " + problem.message();
        if (type != std::filesystem::file_type::not_found)
            continue;
        try {
            l3d_write_png(name, pixels);
        } catch (const std::exception& error) {
            return l3d_detail::reason_of(error);
        }
        return "saved " + l3d_detail::printable((folder / name).string());
    }
    return "not saved: l3d-0001.png to l3d-9999.png exist";
}
