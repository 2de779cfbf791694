// SPDX-License-Identifier: MIT
// l3d_frame_writer: which names it takes, and which files it leaves.
#include "system/frame_writer.h"
#include "system/temporary_folder.h"

#include "base/error.h"
#include "tool_2d/image.h"

#include <gtest/gtest.h>

namespace {

constexpr l3d_size size{7, 5};

l3d_image picture(std::uint32_t corner) {
    l3d_image image(size, 11);
    image.pixels().row(4)[6] = corner;
    return image;
}

std::uint32_t corner_of(const std::string& path) {
    l3d_image image = l3d_read_png(path);
    return image.pixels().row(4)[6];
}

void expect_refused(const std::string& name, l3d_exit code) {
    try {
        l3d_frame_writer writer(name);
        ADD_FAILURE() << name << " was taken";
    } catch (const l3d_error& error) {
        EXPECT_EQ(error.code(), code) << name;
        EXPECT_NE(std::string(error.what()).find("'" + name + "'"), std::string::npos)
            << error.what();
    }
}

TEST(frame_writer, nothing_named_nothing_written) {
    l3d_frame_writer writer("");
    writer.frame(picture(0x123456).pixels());
    writer.finish(picture(0x123456).pixels());
}

TEST(frame_writer, plain_name_holds_the_last_frame) {
    const temporary_folder folder;
    l3d_frame_writer writer(folder.file("a.PNG"));
    writer.frame(picture(0x111111).pixels());
    EXPECT_EQ(folder.count(), 0);
    writer.finish(picture(0x123456).pixels());
    EXPECT_EQ(corner_of(folder.file("a.PNG")), 0x123456u);
    EXPECT_EQ(folder.count(), 1);
}

TEST(frame_writer, numbers_count_from_nought) {
    const temporary_folder folder;
    for (const auto& [pattern, second] :
         {std::pair{"a%d.png", "a1.png"}, {"b%04d.png", "b0001.png"}, {"c%3d.png", "c  1.png"}}) {
        l3d_frame_writer writer(folder.file(pattern));
        writer.frame(picture(0x010203).pixels());
        writer.frame(picture(0x040506).pixels());
        writer.finish(picture(0x070809).pixels());
        EXPECT_EQ(corner_of(folder.file(second)), 0x040506u) << pattern;
    }
    EXPECT_TRUE(folder.holds("b0000.png"));
    EXPECT_EQ(folder.count(), 6);
}

TEST(frame_writer, skipped_frames_have_their_numbers) {
    const temporary_folder folder;
    l3d_frame_writer writer(folder.file("f%d.png"));
    writer.skip_frame();
    EXPECT_FALSE(writer.has_frame(size));
    writer.frame(picture(0x010203).pixels());
    EXPECT_EQ(corner_of(folder.file("f1.png")), 0x010203u);
    l3d_frame_writer again(folder.file("f%d.png"));
    EXPECT_FALSE(again.has_frame(size));
    again.skip_frame();
    EXPECT_TRUE(again.has_frame(size));
    EXPECT_FALSE(l3d_frame_writer(folder.file("f1.png")).has_frame(size)) << "not numbered";
}

TEST(frame_writer, a_frame_that_is_not_whole_is_missing) {
    const temporary_folder folder;
    l3d_frame_writer(folder.file("f%d.png")).frame(picture(0x010203).pixels());
    const l3d_frame_writer writer(folder.file("f%d.png"));
    EXPECT_TRUE(writer.has_frame(size));
    EXPECT_FALSE(writer.has_frame({size.height, size.width + 1})) << "of another size";
    std::filesystem::resize_file(folder.file("f0.png"), 40);
    EXPECT_FALSE(writer.has_frame(size));
    std::filesystem::resize_file(folder.file("f0.png"), 0);
    EXPECT_FALSE(writer.has_frame(size));
}

TEST(frame_writer, number_wider_than_its_field) {
    const temporary_folder folder;
    l3d_frame_writer writer(folder.file("%01d.ppm"));
    for (int i = 0; i <= 10; ++i)
        writer.frame(picture(0x010203).pixels());
    EXPECT_TRUE(folder.holds("9.ppm"));
    EXPECT_TRUE(folder.holds("10.ppm"));
}

TEST(frame_writer, dash_streams_every_frame) {
    testing::internal::CaptureStdout();
    l3d_frame_writer writer("-");
    writer.frame(picture(0x414243).pixels());
    writer.frame(picture(0x444546).pixels());
    writer.finish(picture(0x474849).pixels());
    const std::string stream = testing::internal::GetCapturedStdout();
    const std::string header = "P6\n7 5\n255\n";
    const std::size_t length = header.size() + 7 * 5 * 3;
    ASSERT_EQ(stream.size(), 2 * length);
    EXPECT_EQ(stream.substr(0, header.size()), header);
    EXPECT_EQ(stream.substr(length - 3, 3), "ABC");
    EXPECT_EQ(stream.substr(2 * length - 3, 3), "DEF");
}

TEST(frame_writer, percent_signs_that_begin_no_number_field_are_percent_signs) {
    const temporary_folder folder;
    std::filesystem::create_directory(folder.file("50%"));
    for (const auto& [pattern, file] : {std::pair{"50%/a.png", "50%/a.png"},
                                        {"a%.png", "a%.png"},
                                        {"50%off.png", "50%off.png"},
                                        {"b%%.png", "b%.png"},
                                        {"%%d.png", "%d.png"},
                                        {"%%%%.png", "%%.png"},
                                        {"c%s%n.png", "c%s%n.png"},
                                        {"50%%off%d.png", "50%off0.png"},
                                        {"%d%.png", "0%.png"},
                                        {"e%%%d%%d.png", "e%0%d.png"},
                                        {"f%12d.png", "f           0.png"},
                                        {"g%00d.png", "g0.png"},
                                        {"50%/%02d.png", "50%/00.png"}}) {
        l3d_frame_writer writer(folder.file(pattern));
        writer.frame(picture(0x123456).pixels());
        writer.finish(picture(0x123456).pixels());
        EXPECT_TRUE(folder.holds(file)) << pattern;
        EXPECT_TRUE(writer.has_frame_in(folder.file(file))) << pattern;
        EXPECT_FALSE(writer.has_frame_in(folder.file("other.png"))) << pattern;
    }
}

TEST(frame_writer, refuses_other_names) {
    for (const char* name : {"a.jpg", "png", "a.png.", "a%d%d.png", "a%d%%%4d.png", "a%04d", "%png",
                             "a%-4d.png", "a%ld.png", "a%123d.png"})
        expect_refused(name, l3d_exit::usage);
}

TEST(frame_writer, misses_a_folder_early) {
    expect_refused("/no/such/folder/a.png", l3d_exit::failure);
    expect_refused("no_such_folder/a%d.png", l3d_exit::failure);
}

} // namespace
