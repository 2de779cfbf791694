// SPDX-License-Identifier: MIT
// l3d_read_text_file: whole files, and what is no file but can be read all the same.
#include "tool_2d/text_file.h"

#include "base/error.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

/// A folder of its own for every test, gone afterwards.
class text_files : public testing::Test {
protected:
    text_files() {
        std::string name = testing::TempDir() + "l3d_text_XXXXXX";
        EXPECT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    ~text_files() override { fs::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    std::string pipe(const std::string& name) const {
        EXPECT_EQ(mkfifo(path(name).c_str(), 0600), 0);
        return path(name);
    }

private:
    fs::path folder_;
};

std::string complaint_of(const std::string& path) {
    try {
        return "read: " + l3d_read_text_file(path).substr(0, 100);
    } catch (const l3d_error& error) {
        EXPECT_EQ(error.code(), l3d_exit::bad_input);
        return error.what();
    }
}

TEST_F(text_files, are_read_whole) {
    std::string text(100001, '\0');
    for (std::size_t i = 0; i < text.size(); ++i)
        text[i] = static_cast<char>(i * 7);
    std::ofstream(path("a"), std::ios::binary) << text;
    std::ofstream(path("empty"), std::ios::binary);
    EXPECT_EQ(l3d_read_text_file(path("a")), text);
    EXPECT_EQ(l3d_read_text_file(path("empty")), "");
    EXPECT_FALSE(l3d_read_text_file("/proc/self/status").empty()) << "it says that it has no bytes";
}

TEST_F(text_files, that_cannot_be_read_are_named) {
    EXPECT_EQ(complaint_of(path("none")), path("none") + ": No such file or directory");
    EXPECT_EQ(complaint_of(path("")), path("") + ": Is a directory");
}

/// Longer than what a pipe holds.
TEST_F(text_files, may_be_pipes) {
    const std::string text(1 << 20, 'x');
    const std::string name = pipe("p");
    std::thread writer([&] { std::ofstream(name) << text; });
    EXPECT_EQ(l3d_read_text_file(name), text);
    writer.join();
}

TEST_F(text_files, are_no_pipes_into_which_nobody_writes) {
    EXPECT_EQ(complaint_of(pipe("p")), path("p") + ": no program writes into this pipe");
}

TEST_F(text_files, end_in_pipes_whose_writer_has_nothing_to_say) {
    const std::string name = pipe("p");
    std::thread writer([&] { std::ofstream file(name); });
    EXPECT_EQ(l3d_read_text_file(name), "");
    writer.join();
}

TEST_F(text_files, have_an_end) {
    EXPECT_EQ(complaint_of("/dev/zero"), "/dev/zero: has no end within 256 MB, the most that is "
                                         "read of what is no regular file");
}

/// A file of holes takes no room on the disk, but would take it in memory.
TEST_F(text_files, have_a_largest_size) {
    std::ofstream file(path("large"));
    fs::resize_file(path("large"), (std::uintmax_t{4} << 30) + 1);
    EXPECT_EQ(complaint_of(path("large")),
              path("large") + ": has 4294967297 bytes; files of up to 4 GB are read");
}

} // namespace
