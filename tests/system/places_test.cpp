// SPDX-License-Identifier: MIT
// Folders of plug-ins and data, and which file the name of a model means.
#include "system/places.h"
#include "system/places_p.h"
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

TEST(places, a_program_whose_place_is_unknown_finds_nothing_in_the_current_folder) {
    const temporary_folder folder;
    std::filesystem::create_directories(folder.file("lib/l3d"));
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.file(""));
    for (const char* const program : {"", "program", "bin/program"}) {
        const auto found = l3d_detail::folder_beside(program, "lib/l3d");
        EXPECT_TRUE(found.is_absolute()) << found;
        EXPECT_NE(std::filesystem::weakly_canonical(found),
                  std::filesystem::canonical(folder.file("lib/l3d")));
    }
    EXPECT_EQ(l3d_detail::folder_beside(folder.file("bin/program"), "lib/l3d"),
              folder.file("lib/l3d"));
    std::filesystem::current_path(before);
}

} // namespace
