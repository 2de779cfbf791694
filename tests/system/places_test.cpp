// SPDX-License-Identifier: MIT
// Folders of plug-ins and data, and which file the name of a model means.
#include "system/places.h"
#include "system/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace {

TEST(places, are_beside_the_programs) {
    EXPECT_TRUE(std::filesystem::is_regular_file(l3d_data_folder() + "/torus.off"));
    EXPECT_TRUE(std::filesystem::is_regular_file(l3d_plugin_folder() + "/videoscape.so"));
}

TEST(places, a_plain_name_means_a_file_here_or_else_ours) {
    const temporary_folder folder;
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.file(""));
    EXPECT_EQ(l3d_data_file("torus.off"), l3d_data_folder() + "/torus.off");
    EXPECT_EQ(l3d_data_file("./torus.off"), "./torus.off");
    EXPECT_EQ(l3d_data_file("nothing.off"), "nothing.off");
    EXPECT_EQ(l3d_data_file(""), "");
    std::ofstream("torus.off") << "OFF 0 0 0\n";
    EXPECT_EQ(l3d_data_file("torus.off"), "torus.off");
    std::filesystem::current_path(before);
}

} // namespace
