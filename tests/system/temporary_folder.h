// SPDX-License-Identifier: MIT
// A folder that is gone after the test.
#ifndef L3D_TESTS_SYSTEM_TEMPORARY_FOLDER_H
#define L3D_TESTS_SYSTEM_TEMPORARY_FOLDER_H

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>

class temporary_folder {
public:
    temporary_folder() {
        std::string name = testing::TempDir() + "l3d_system_XXXXXX";
        EXPECT_NE(mkdtemp(name.data()), nullptr);
        path_ = name;
    }
    temporary_folder(const temporary_folder&) = delete;
    temporary_folder& operator=(const temporary_folder&) = delete;
    ~temporary_folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    std::string file(const std::string& name) const { return path_ + '/' + name; }
    bool holds(const std::string& name) const { return std::filesystem::exists(file(name)); }
    auto count() const {
        return std::distance(std::filesystem::directory_iterator(path_),
                             std::filesystem::directory_iterator());
    }

private:
    std::string path_;
};

#endif
