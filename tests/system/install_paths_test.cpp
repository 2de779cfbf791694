// SPDX-License-Identifier: MIT
// Folders of plug-ins and data, and which file the name of a model means.
#include "system/plugin_loader.h"
#include "system/options/model_names_p.h"
#include "system/install_paths_p.h"
#include "system/temporary_folder.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

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
    EXPECT_EQ(l3d_data_file("torus"), l3d_data_folder() + "/torus.off");
    EXPECT_EQ(l3d_data_file("teapot"), l3d_data_folder() + "/teapot.bpt");
    EXPECT_EQ(l3d_data_file("toru"), "toru");
    std::ofstream("torus.off") << "OFF 0 0 0\n";
    EXPECT_EQ(l3d_data_file("torus.off"), "torus.off");
    std::filesystem::current_path(before);
}

TEST(places, models_have_names_and_an_error_says_where_they_were_looked_for) {
    EXPECT_EQ(l3d_detail::model_names(),
              (std::vector<std::string>{"ball", "bird", "cone", "cube", "cylinder", "disc", "head",
                                        "mask", "plate", "spaceship", "sphere", "teapot",
                                        "teapot_bottom", "thing", "torus"}));
    EXPECT_GT(l3d_detail::load_named_model("torus.off").mesh.faces(), 0u);
    EXPECT_EQ(l3d_detail::load_named_model("torus").patches.size(), 16u); // the exact one
    try {
        l3d_detail::load_named_model("tours.off");
        ADD_FAILURE();
    } catch (const l3d_error& error) {
        EXPECT_EQ(error.code(), l3d_exit::bad_input);
        EXPECT_EQ(
            error.what(),
            "tours.off: no such file is here, nor a model of that name in " + l3d_data_folder() +
                ", which has ball bird cone cube cylinder disc head mask plate spaceship sphere "
                "teapot teapot_bottom thing torus; did you mean 'torus'?");
    }
    EXPECT_THROW(l3d_detail::load_named_model("no/such/torus"), l3d_error);
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
