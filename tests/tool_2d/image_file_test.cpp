// SPDX-License-Identifier: MIT
// Image files: contents, repeatability, and what is left behind when writing fails.
#include "tool_2d/image_file.h"

#include "tool_2d/error.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

#include <unistd.h>

namespace {

namespace fs = std::filesystem;

/// A folder of its own for every test, gone afterwards.
class image_file : public testing::Test {
protected:
    image_file() : folder_(fs::temp_directory_path() / ("l3d_image_file_" + unique())) {
        fs::create_directory(folder_);
    }
    ~image_file() override { fs::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

private:
    static std::string unique() {
        return std::to_string(getpid()) +
               testing::UnitTest::GetInstance()->current_test_info()->name();
    }
    fs::path folder_;
};

std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Random words, rubbish in the unused byte and behind each row.
l3d_image random_image(l3d_size size) {
    const unsigned seed = std::random_device{}();
    testing::Test::RecordProperty("seed", std::to_string(seed));
    std::mt19937 random(seed);
    l3d_image image(size, size.width + 5);
    const auto pixels = image.pixels();
    for (std::ptrdiff_t i = 0; i < pixels.stride * pixels.height; ++i)
        pixels.words[i] = static_cast<std::uint32_t>(random());
    return image;
}

l3d_exit code_of(const auto& action, const std::string& part_of_text) {
    try {
        action();
    } catch (const l3d_error& error) {
        EXPECT_NE(std::string(error.what()).find(part_of_text), std::string::npos) << error.what();
        return error.code();
    }
    return l3d_exit::success;
}

/// The byte of a PNG that says which channels it has: 2 for colours, 6 for alpha, too.
int channels_of(const std::string& path) {
    constexpr std::size_t place = 25;
    return contents(path).at(place);
}

TEST_F(image_file, alpha_is_written_on_request_and_nowhere_else) {
    l3d_image image({2, 1}, 2);
    image.pixels().row(0)[0] = 0x40c0d0e0;
    image.pixels().row(0)[1] = l3d_pixels::transparent;
    l3d_write_png(path("a.png"), image.pixels());
    EXPECT_EQ(channels_of(path("a.png")), 2);
    EXPECT_EQ(l3d_read_png(path("a.png")).pixels().row(0)[0], 0x00c0d0e0u);
    l3d_write_image(path("b.PNG"), image.pixels(), l3d_alpha::transparency);
    EXPECT_EQ(channels_of(path("b.PNG")), 6);
    l3d_image on_black = l3d_read_png(path("b.PNG")); // by libpng, in linear light
    EXPECT_EQ(on_black.pixels().row(0)[1], 0u);
    EXPECT_LT(on_black.pixels().row(0)[0], 0x00c0d0e0u);
    EXPECT_GT(on_black.pixels().row(0)[0], 0u);
    l3d_image as_written = l3d_read_png(path("b.PNG"), l3d_alpha::transparency);
    EXPECT_EQ(as_written.pixels().row(0)[0], 0x40c0d0e0u);
    EXPECT_EQ(as_written.pixels().row(0)[1] >> 24, 0xffu);
    l3d_image opaque = l3d_read_png(path("a.png"), l3d_alpha::transparency);
    EXPECT_EQ(opaque.pixels().row(0)[0], 0x00c0d0e0u);
    const auto action = [&] {
        l3d_write_image(path("c.ppm"), image.pixels(), l3d_alpha::transparency);
    };
    EXPECT_EQ(code_of(action, "c.ppm"), l3d_exit::usage);
    EXPECT_EQ(files(), 2u);
}

TEST_F(image_file, png_round_trip) {
    auto image = random_image({37, 11});
    l3d_write_png(path("a.png"), image.pixels());
    auto read = l3d_read_png(path("a.png"));
    ASSERT_EQ(read.pixels().size(), image.pixels().size());
    for (int y = 0; y < 11; ++y)
        for (std::size_t x = 0; x < 37; ++x)
            EXPECT_EQ(read.pixels().row(y)[x], image.pixels().row(y)[x] & 0xFFFFFF)
                << x << " " << y;
}

TEST_F(image_file, same_pixels_same_bytes) {
    auto image = random_image({19, 23});
    for (const std::string end : {".png", ".ppm"}) {
        l3d_write_image(path("a" + end), image.pixels());
        l3d_write_image(path("b" + end), image.pixels());
        EXPECT_EQ(contents(path("a" + end)), contents(path("b" + end)));
        EXPECT_FALSE(contents(path("a" + end)).empty());
    }
    EXPECT_EQ(files(), 4U) << "a temporary file was left";
}

TEST_F(image_file, ppm_bytes) {
    l3d_image image({2, 3}, 4);
    image.pixels().row(0)[1] = 0x00FF80;
    image.pixels().row(2)[0] = 0xAB102030;
    l3d_write_image(path("a.PPM"), image.pixels());
    const std::string expected("P6\n2 3\n255\n"
                               "\0\0\0\0\xFF\x80"
                               "\0\0\0\0\0\0"
                               "\x10\x20\x30\0\0\0",
                               11 + 18);
    EXPECT_EQ(contents(path("a.PPM")), expected);
}

TEST_F(image_file, pfm_starts_with_the_bottom_row) {
    const float far = std::numeric_limits<float>::infinity();
    l3d_write_pfm(path("a.pfm"), 2, 3, std::vector<float>{1.0f, 2.0f, -0.5f, far, 3.0f, 0.25f});
    const std::string expected("Pf\n2 3\n-1.0\n"
                               "\0\0\x40\x40\0\0\x80\x3E"
                               "\0\0\0\xBF\0\0\x80\x7F"
                               "\0\0\x80\x3F\0\0\0\x40",
                               12 + 24);
    EXPECT_EQ(contents(path("a.pfm")), expected);
}

TEST_F(image_file, other_names_are_wrong_usage) {
    auto image = random_image({5, 4});
    for (const std::string name : {"a.gif", "png", "a.png.txt", "b"}) {
        const auto action = [&] { l3d_write_image(path(name), image.pixels()); };
        EXPECT_EQ(code_of(action, name), l3d_exit::usage);
    }
    EXPECT_EQ(files(), 0U);
}

TEST_F(image_file, a_folder_that_is_not_there_is_named) {
    auto image = random_image({5, 4});
    for (const std::string name : {"none/a.png", "none/a.ppm"}) {
        const auto action = [&] { l3d_write_image(path(name), image.pixels()); };
        EXPECT_EQ(code_of(action, name + ": No such file or directory"), l3d_exit::failure);
    }
}

TEST_F(image_file, a_full_disk_is_reported) {
    auto image = random_image({61, 47});
    const auto pixels = image.pixels();
    for (const std::string end : {".png", ".ppm"}) {
        fs::create_symlink("/dev/full", path("full" + end));
        const auto action = [&] { l3d_write_image(path("full" + end), pixels); };
        EXPECT_EQ(code_of(action, "full" + end + ": No space left on device"), l3d_exit::failure);
    }
    EXPECT_EQ(files(), 2U);
}

TEST_F(image_file, a_stream_that_ends_is_reported_with_its_picture) {
    auto image = random_image({5, 4});
    // So small that only the flush finds out.
    std::FILE* full = std::fopen("/dev/full", "wb");
    const auto action = [&] { l3d_write_ppm(full, "output", image.pixels()); };
    EXPECT_EQ(code_of(action, "output: No space left on device"), l3d_exit::failure);
    std::fclose(full);
}

TEST_F(image_file, a_failed_write_keeps_the_old_picture) {
    // Zero rows: libpng refuses to write them, after the temporary file was opened.
    l3d_image empty({5, 0}, 5);
    auto image = random_image({5, 4});
    l3d_write_png(path("a.png"), image.pixels());
    const auto before = contents(path("a.png"));
    const auto action = [&] { l3d_write_png(path("a.png"), empty.pixels()); };
    EXPECT_EQ(code_of(action, "a.png"), l3d_exit::failure);
    EXPECT_EQ(contents(path("a.png")), before);
    EXPECT_EQ(files(), 1U);
}

TEST_F(image_file, a_link_is_followed_not_replaced) {
    auto image = random_image({5, 4});
    l3d_write_ppm(path("real.ppm"), image.pixels());
    fs::create_symlink("real.ppm", path("link.ppm"));
    image.pixels().row(3)[4] ^= 0xFF;
    l3d_write_ppm(path("link.ppm"), image.pixels());
    EXPECT_TRUE(fs::is_symlink(path("link.ppm")));
    l3d_write_ppm(path("direct.ppm"), image.pixels());
    EXPECT_EQ(contents(path("real.ppm")), contents(path("direct.ppm")));
}

TEST_F(image_file, a_cut_or_damaged_picture_is_not_whole) {
    auto image = random_image({37, 11});
    for (const std::string name : {"a.png", "a.ppm"}) {
        EXPECT_FALSE(l3d_is_whole_image(path(name), {37, 11}));
        l3d_write_image(path(name), image.pixels());
        const std::string whole = contents(path(name));
        EXPECT_TRUE(l3d_is_whole_image(path(name), {37, 11}));
        EXPECT_FALSE(l3d_is_whole_image(path(name), {11, 37}));
        for (std::size_t size = 0; size < whole.size(); ++size) {
            fs::resize_file(path(name), size);
            ASSERT_FALSE(l3d_is_whole_image(path(name), {37, 11})) << name << " of " << size;
            std::ofstream(path(name), std::ios::binary) << whole;
        }
        std::ofstream(path(name), std::ios::binary | std::ios::app) << 'x';
        EXPECT_FALSE(l3d_is_whole_image(path(name), {37, 11})) << "longer";
    }
    // A disk that lost a block has zeros there.
    l3d_write_png(path("a.png"), image.pixels());
    std::string zeros = contents(path("a.png"));
    zeros.replace(zeros.size() / 2, 64, 64, '\0');
    std::ofstream(path("a.png"), std::ios::binary) << zeros;
    EXPECT_FALSE(l3d_is_whole_image(path("a.png"), {37, 11}));
}

TEST_F(image_file, a_stream_of_floats_has_the_bytes_of_a_file) {
    const std::vector<float> values{1.0f, 2.0f, -0.5f, 4.0f, 3.0f, 0.25f};
    l3d_write_pfm(path("a.pfm"), 2, 3, values);
    std::FILE* const stream = std::fopen(path("b.pfm").c_str(), "wb");
    l3d_write_pfm(stream, "stream", 2, 3, values);
    std::fclose(stream);
    EXPECT_EQ(contents(path("a.pfm")), contents(path("b.pfm")));
}

TEST_F(image_file, reading_names_what_is_wrong) {
    EXPECT_EQ(code_of([&] { l3d_read_png(path("none.png")); }, "none.png: No such file"),
              l3d_exit::bad_input);
    std::ofstream(path("bad.png")) << "not a picture";
    EXPECT_EQ(code_of([&] { l3d_read_png(path("bad.png")); }, "bad.png: "), l3d_exit::bad_input);
}

} // namespace
