// SPDX-License-Identifier: MIT
// l3d_save_screenshot: a line for whatever happens, and nothing written over.
#include "system/frame_writer.h"
#include "system/temporary_folder.h"

#include "geom/files/model_file.h"
#include "geom/nurbs_surface.h"
#include "tool_2d/image.h"
#include "tool_2d/text_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <vector>

namespace {

namespace fs = std::filesystem;

TEST(screenshot, takes_the_first_name_that_nobody_has) {
    const temporary_folder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.file(""));
    l3d_image image({7, 5}, 7);
    std::ofstream("l3d-0001.png") << "mine";
    fs::create_symlink("l3d-0002.png", "l3d-0002.png"); // leads round
    fs::create_symlink("nothing", "l3d-0003.png");
    const auto saved = [](const char* name) { return "saved " + fs::absolute(name).string(); };
    EXPECT_EQ(l3d_save_screenshot(image.pixels()), saved("l3d-0004.png"));
    EXPECT_EQ(fs::file_size("l3d-0001.png"), 4u);
    EXPECT_FALSE(fs::exists("nothing"));
    EXPECT_EQ(l3d_save_screenshot(image.pixels()), saved("l3d-0005.png"));
    fs::current_path(before);
}

TEST(screenshot, says_why_there_is_none) {
    const fs::path before = fs::current_path();
    {
        const temporary_folder folder;
        fs::current_path(folder.file(""));
    }
    l3d_image image({7, 5}, 7);
    EXPECT_EQ(l3d_save_screenshot(image.pixels()), "l3d-0001.png: No such file or directory");
    fs::current_path(before);
}

TEST(screenshot, surfaces_are_saved_as_they_are) {
    const temporary_folder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.file(""));
    const std::vector<l3d_nurbs_surface> ball = l3d_sphere_surfaces();
    EXPECT_EQ(l3d_save_surfaces(ball), "saved " + fs::absolute("l3d-0001.obj").string());
    EXPECT_EQ(l3d_read_text_file("l3d-0001.obj"), l3d_write_obj_surfaces(ball));
    fs::current_path(before);
}

} // namespace
