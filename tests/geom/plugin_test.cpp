// SPDX-License-Identifier: MIT
// Plug-ins of the library: where they are looked for, and one line for each reason to refuse one.
#include "geom/files/plugin_p.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

using l3d_detail::load_plugin;
using l3d_detail::plugin_folders;

std::string complaint(const char* name, std::uint32_t version, std::size_t size) {
    std::string why;
    EXPECT_EQ(load_plugin(name, version, size, why), nullptr);
    EXPECT_EQ(why.find('\n'), why.npos);
    return why;
}

TEST(plugin, of_the_version_and_size_is_found_beside_the_programs) {
    std::string why;
    const auto* const found = load_plugin("outdated", 7, 8, why);
    ASSERT_NE(found, nullptr) << why;
    EXPECT_EQ(found->version, 7U);
    EXPECT_EQ(found->size, 8U);
}

TEST(plugin, that_is_missing_names_its_package) {
    EXPECT_EQ(
        complaint("nothing", 1, 8),
        "it takes the package l3d-nothing, which is not installed (libl3d_nothing.so is in no "
        "folder of plug-ins)");
}

TEST(plugin, of_another_version_or_size_is_refused) {
    EXPECT_NE(complaint("outdated", 8, 8)
                  .find("libl3d_outdated.so: the plug-in has version 7 of "
                        "its interface, and this program needs version 8"),
              std::string::npos);
    EXPECT_NE(complaint("outdated", 7, 16).find("the plug-in's interface has 8 bytes, not 16"),
              std::string::npos);
    EXPECT_NE(complaint("strange", 1, 8).find("it defines no symbol l3d_strange_plugin"),
              std::string::npos);
}

TEST(plugin, is_looked_for_in_the_environments_folders_first) {
    const std::filesystem::path folder = testing::TempDir() + "l3d_plugin_test";
    std::filesystem::create_directory(folder);
    std::ofstream(folder / "libl3d_outdated.so") << "no library\n";
    setenv("L3D_PLUGIN_PATH", ("relative:" + folder.string() + ":/elsewhere").c_str(), 1);
    const auto folders = plugin_folders();
    ASSERT_GT(folders.size(), 3U);
    EXPECT_EQ(folders[0], folder.string()) << "a relative folder is none";
    EXPECT_EQ(folders[1], "/elsewhere");
    EXPECT_NE(complaint("outdated", 7, 8).find("the plug-in cannot be loaded: " + folder.string()),
              std::string::npos);
    unsetenv("L3D_PLUGIN_PATH");
    std::filesystem::remove_all(folder);
}

} // namespace
