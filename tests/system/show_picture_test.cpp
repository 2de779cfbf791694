// SPDX-License-Identifier: MIT
// l3d_show_picture: without a display, the picture is in a file of the name.
#include "system/program.h"
#include "system/temporary_folder.h"
#include "tool_2d/image.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

TEST(show_picture, is_a_file_where_nobody_would_see_it) {
    unsetenv("DISPLAY");
    unsetenv("L3D_BACKEND");
    const temporary_folder folder;
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.file(""));
    l3d_image picture({5, 3}, 8);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x)
            picture.pixels().row(y)[static_cast<std::size_t>(x)] =
                static_cast<std::uint32_t>(0x100000 * x + 0x2000 * y + 7);
    testing::internal::CaptureStderr();
    EXPECT_EQ(l3d_show_picture(picture.pixels(), "sail"), 0);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("sail.png"), std::string::npos);
    auto written = l3d_read_png("sail.png");
    std::filesystem::current_path(before);
    ASSERT_EQ(written.size(), picture.size());
    for (int y = 0; y < 3; ++y)
        for (std::size_t x = 0; x < 5; ++x)
            EXPECT_EQ(written.pixels().row(y)[x], picture.pixels().row(y)[x]) << x << ',' << y;
}
