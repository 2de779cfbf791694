// SPDX-License-Identifier: MIT
// l3d_read_image: PNG, PPM and JPEG by what the file holds, and what is said of broken ones.
#include "tool_2d/image.h"

#include "base/error.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <jpeglib.h>

namespace {

constexpr l3d_size size{19, 11};

/// Smooth, so that JPEG changes it little.
std::uint32_t word_at(int x, int y) {
    return static_cast<std::uint32_t>((40 + 8 * x) << 16 | (200 - 9 * y) << 8 |
                                      (60 + 3 * x + 4 * y));
}

l3d_image picture() {
    l3d_image image(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            image.pixels().row(y)[static_cast<std::size_t>(x)] = word_at(x, y);
    return image;
}

/// The bytes of a JPEG of that picture, of its red alone if `is_grey`.
std::string jpeg_bytes(bool is_grey, bool is_progressive) {
    jpeg_compress_struct info{};
    jpeg_error_mgr manager{};
    info.err = jpeg_std_error(&manager);
    jpeg_create_compress(&info);
    unsigned char* bytes = nullptr;
    unsigned long length = 0;
    jpeg_mem_dest(&info, &bytes, &length);
    info.image_width = static_cast<JDIMENSION>(size.width);
    info.image_height = static_cast<JDIMENSION>(size.height);
    info.input_components = is_grey ? 1 : 3;
    info.in_color_space = is_grey ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_set_defaults(&info);
    jpeg_set_quality(&info, 100, TRUE);
    if (is_progressive)
        jpeg_simple_progression(&info);
    jpeg_start_compress(&info, TRUE);
    for (int y = 0; y < size.height; ++y) {
        std::vector<std::uint8_t> row;
        for (int x = 0; x < size.width; ++x)
            for (int shift = 16; shift >= (is_grey ? 16 : 0); shift -= 8)
                row.push_back(static_cast<std::uint8_t>(word_at(x, y) >> shift));
        JSAMPROW rows[] = {row.data()};
        jpeg_write_scanlines(&info, rows, 1);
    }
    jpeg_finish_compress(&info);
    std::string result(reinterpret_cast<const char*>(bytes), length);
    jpeg_destroy_compress(&info);
    std::free(bytes);
    return result;
}

/// Why bytes are no picture; nothing if they are one.
std::string complaint(const std::string& bytes, std::int64_t most_pixels = l3d_most_image_pixels) {
    try {
        l3d_decoded_image(bytes, "name", most_pixels);
    } catch (const l3d_error& error) {
        EXPECT_EQ(error.code(), l3d_exit::bad_input);
        return error.what();
    }
    return "";
}

TEST(read_image, reads_what_was_written) {
    const std::string folder = testing::TempDir();
    for (const std::string name : {"read_image.png", "read_image.ppm"}) {
        l3d_image written = picture();
        l3d_write_image(folder + name, written.pixels());
        l3d_image image = l3d_read_image(folder + name);
        ASSERT_EQ(image.pixels().size(), size);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                EXPECT_EQ(image.pixels().row(y)[static_cast<std::size_t>(x)], word_at(x, y));
        std::filesystem::remove(folder + name);
        EXPECT_THROW(l3d_read_image(folder + name), l3d_error);
    }
}

TEST(read_image, reads_jpeg_grey_and_in_colour) {
    for (const bool is_grey : {false, true})
        for (const bool is_progressive : {false, true}) {
            l3d_image image = l3d_decoded_image(jpeg_bytes(is_grey, is_progressive), "name");
            ASSERT_EQ(image.pixels().size(), size);
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    for (const int shift : {0, 8, 16}) {
                        const std::uint32_t word =
                            image.pixels().row(y)[static_cast<std::size_t>(x)];
                        EXPECT_NEAR(double(word >> shift & 255),
                                    double(word_at(x, y) >> (is_grey ? 16 : shift) & 255), 6);
                        EXPECT_EQ(word >> 24, 0U);
                    }
        }
}

TEST(read_image, reads_ppm_with_comments_and_of_fewer_levels) {
    l3d_image image =
        l3d_decoded_image(std::string("P6 # a\n2#b\n 1 \n15\n\x0f\0\x07\x03\x0f\x01", 24), "name");
    EXPECT_EQ(image.pixels().row(0)[0], 0xff0077U);
    EXPECT_EQ(image.pixels().row(0)[1], 0x33ff11U);
}

TEST(read_image, says_of_what_file_something_is_wrong) {
    EXPECT_EQ(complaint("GIF89a"), "name: neither PNG nor JPEG nor binary PPM");
    EXPECT_EQ(complaint(""), "name: neither PNG nor JPEG nor binary PPM");
    EXPECT_EQ(complaint("P6 2 1 255\nabcde"), "name: the file ends after 16 of 17 bytes");
    const std::string head = "name: no binary PPM has a head like this: P6, width, height, a level "
                             "of 1 to 255";
    for (const std::string text : {"P6", "P6 2", "P6 0 1 255\n", "P6 2 1 256\n", "P6 2 -1 255\n"})
        EXPECT_EQ(complaint(text), head) << text;
    EXPECT_EQ(complaint("P6 5 4 255\n", 19), "name: 5 by 4 pixels are more than 19");
    EXPECT_EQ(complaint(jpeg_bytes(false, false), 19), "name: 19 by 11 pixels are more than 19");
    EXPECT_EQ(complaint("\xFF\xD8 no more").substr(0, 6), "name: ");
}

/// Decoders paint grey where bytes are missing; here that is an error.
TEST(read_image, refuses_a_jpeg_that_was_cut_off) {
    for (const bool is_progressive : {false, true}) {
        const std::string bytes = jpeg_bytes(false, is_progressive);
        EXPECT_EQ(complaint(bytes), "");
        for (std::size_t length = 2; length + 2 < bytes.size(); length += 7)
            EXPECT_NE(complaint(bytes.substr(0, length)), "") << length;
    }
}

} // namespace
