// SPDX-License-Identifier: MIT
// output_file: which names it makes, what it leaves behind, and what it replaces.
#include "tool_2d/output_file_p.h"

#include "base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using l3d_detail::output_file;

class output_files : public testing::Test {
protected:
    output_files() {
        std::string name = testing::TempDir() + "l3d_output_XXXXXX";
        EXPECT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    ~output_files() override {
        fs::permissions(folder_, fs::perms::owner_all);
        fs::remove_all(folder_);
    }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    auto files() const {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }
    std::string contents(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    void write(const std::string& name, const std::string& text) const {
        output_file file(path(name));
        std::fputs(text.c_str(), file.get());
        file.commit();
    }

private:
    fs::path folder_;
};

/// The mode of a new file, as the user's mask leaves it.
mode_t usual_mode() {
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

mode_t mode_of(const std::string& path) {
    struct stat info {};
    EXPECT_EQ(stat(path.c_str(), &info), 0);
    return info.st_mode & 07777;
}

TEST_F(output_files, the_name_appears_when_all_is_written) {
    {
        output_file file(path("a"));
        std::fputs("half", file.get());
        std::fflush(file.get());
        EXPECT_FALSE(fs::exists(path("a")));
    }
    EXPECT_EQ(files(), 0) << "what was not committed stays";
    write("a", "whole");
    EXPECT_EQ(contents("a"), "whole");
    write("a", "another");
    EXPECT_EQ(contents("a"), "another");
    EXPECT_EQ(files(), 1);
}

TEST_F(output_files, a_death_leaves_nothing_behind) {
    const pid_t child = fork();
    if (child == 0) {
        output_file file(path("a"));
        std::fputs("half", file.get());
        std::fflush(file.get());
        raise(SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(files(), 0);
}

TEST_F(output_files, what_a_death_before_renaming_left_is_removed_by_the_next_writer) {
    write("a", "old");
    const pid_t child = fork();
    if (child == 0) {
        output_file file(path("a"));
        std::fputs("new", file.get());
        // A folder in the way lets the renaming fail, which comes after the link.
        fs::remove(path("a"));
        fs::create_directory(path("a"));
        try {
            file.commit();
        } catch (const l3d_error&) {
            raise(SIGKILL);
        }
        _exit(1);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    fs::remove(path("a"));
    if (files() == 0)
        GTEST_SKIP() << "no files without names here";
    write("a", "old");
    write("a", "new");
    EXPECT_EQ(contents("a"), "new");
    EXPECT_EQ(files(), 1);
}

TEST_F(output_files, writers_of_one_path_do_not_collide) {
    constexpr std::size_t size = 100000;
    std::vector<std::thread> writers;
    for (const char letter : {'a', 'b', 'c', 'd'})
        writers.emplace_back([this, letter] {
            for (int i = 0; i < 20; ++i)
                write("shared", std::string(size, letter));
        });
    for (std::thread& writer : writers)
        writer.join();
    const std::string result = contents("shared");
    EXPECT_EQ(result, std::string(size, result.front()));
    EXPECT_EQ(files(), 1);
}

TEST_F(output_files, permissions_are_those_of_the_file_before) {
    write("a", "old");
    EXPECT_EQ(mode_of(path("a")), usual_mode());
    for (const mode_t mode : {0600u, 0640u, 0777u}) {
        chmod(path("a").c_str(), mode);
        write("a", "new");
        EXPECT_EQ(mode_of(path("a")), mode);
    }
}

TEST_F(output_files, a_link_to_nothing_is_followed) {
    fs::create_directory(path("there"));
    fs::create_symlink("there/real", path("link"));
    fs::create_symlink("link", path("link_to_link"));
    write("link_to_link", "text");
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_TRUE(fs::is_symlink(path("link_to_link")));
    EXPECT_EQ(contents("there/real"), "text");
    fs::create_symlink("nowhere/real", path("lost"));
    EXPECT_THROW(write("lost", ""), l3d_error);
    fs::create_symlink("round", path("round"));
    EXPECT_THROW(write("round", ""), l3d_error);
    EXPECT_TRUE(fs::is_symlink(path("lost")));
}

TEST_F(output_files, names_may_be_as_long_as_the_system_allows) {
    const std::string longest(255, 'n');
    write(longest, "text");
    write(longest, "again");
    EXPECT_EQ(contents(longest), "again");
    EXPECT_THROW(write(longest + 'n', ""), l3d_error);
    EXPECT_EQ(files(), 1);
}

TEST_F(output_files, a_file_in_a_folder_that_takes_no_other_is_written_in_place) {
    if (geteuid() == 0)
        GTEST_SKIP() << "root may write everywhere";
    write("a", "old");
    fs::permissions(path(""), fs::perms::owner_read | fs::perms::owner_exec);
    write("a", "new");
    EXPECT_EQ(contents("a"), "new");
    try {
        write("b", "");
        ADD_FAILURE() << "b was written";
    } catch (const l3d_error& error) {
        EXPECT_EQ(std::string(error.what()), path("b") + ": Permission denied");
    }
}

TEST_F(output_files, a_standard_stream_by_its_name_is_written_to_directly) {
    std::FILE* const deleted = std::fopen(path("gone").c_str(), "w+b");
    const std::string name = "/proc/self/fd/" + std::to_string(fileno(deleted));
    fs::remove(path("gone"));
    output_file file(name);
    std::fputs("text", file.get());
    file.commit();
    EXPECT_EQ(std::fseek(deleted, 0, SEEK_END), 0);
    EXPECT_EQ(std::ftell(deleted), 4);
    std::fclose(deleted);
    EXPECT_EQ(files(), 0);
}

} // namespace
