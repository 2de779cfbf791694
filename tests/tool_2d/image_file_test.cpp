// SPDX-License-Identifier: MIT
// Image files: contents, repeatability, and what is left behind when writing fails.
#include "tool_2d/image.h"

#include "base/error.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

#include <png.h>
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

TEST_F(image_file, png_in_memory_has_the_bytes_of_a_file) {
    auto image = random_image({37, 11});
    for (const auto alpha : {l3d_alpha::none, l3d_alpha::transparency}) {
        l3d_write_png(path("a.png"), image.pixels(), alpha);
        EXPECT_EQ(l3d_encoded_png(image.pixels(), alpha), contents(path("a.png")));
    }
    l3d_image empty;
    EXPECT_EQ(code_of([&] { l3d_encoded_png(empty.pixels()); }, "PNG: "), l3d_exit::failure);
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

/// A PNG that our writer does not write: libpng's description of it, and its rows.
struct described_png {
    int depth, channels, interlace = PNG_INTERLACE_NONE;
    std::vector<std::vector<png_byte>> rows{};
    std::function<void(png_structp, png_infop)> more{}; ///< chunks before the rows
};

std::string written(const described_png& what, const std::string& path) {
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    const std::size_t channels = what.channels == PNG_COLOR_TYPE_RGB          ? 3
                                 : what.channels == PNG_COLOR_TYPE_RGB_ALPHA  ? 4
                                 : what.channels == PNG_COLOR_TYPE_GRAY_ALPHA ? 2
                                                                              : 1;
    const auto bits = static_cast<std::size_t>(what.depth) * channels;
    png_set_IHDR(png, info, static_cast<png_uint_32>(8 * what.rows[0].size() / bits),
                 static_cast<png_uint_32>(what.rows.size()), what.depth, what.channels,
                 what.interlace, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (what.more)
        what.more(png, info);
    std::vector<std::vector<png_byte>> rows = what.rows;
    std::vector<png_bytep> starts;
    for (auto& row : rows)
        starts.push_back(row.data());
    png_set_rows(png, info, starts.data());
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
    return path;
}

/// The words of the first row.
std::vector<std::uint32_t> words_of(const described_png& what, const std::string& path,
                                    l3d_alpha alpha = l3d_alpha::none) {
    l3d_image image = l3d_read_png(written(what, path), alpha);
    const auto row = image.pixels().row(0);
    return {row.begin(), row.end()};
}

using words = std::vector<std::uint32_t>;

/// Numbers of 16 bits are levels as those of 8 bits are, unless the file says otherwise.
TEST_F(image_file, png_of_16_bits_holds_levels) {
    const described_png grey{
        16, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, {{0xff, 0xff, 0x80, 0x00, 0x01, 0x00}}};
    EXPECT_EQ(words_of(grey, path("g.png")), (words{0xffffff, 0x808080, 0x010101}));
    const described_png rgb{
        16, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, {{0xff, 0xff, 0x80, 0x80, 0x20, 0x20}}};
    EXPECT_EQ(words_of(rgb, path("c.png")), words{0xff8020});
    const described_png clear{16,
                              PNG_COLOR_TYPE_RGB_ALPHA,
                              PNG_INTERLACE_NONE,
                              {{0xff, 0xff, 0x80, 0x80, 0x20, 0x20, 0x40, 0x40}}};
    EXPECT_EQ(words_of(clear, path("a.png"), l3d_alpha::transparency), words{0xbfff8020});
}

/// Every other kind that the format has: few bits, palettes, keys of transparency, interlacing.
TEST_F(image_file, png_of_any_kind_has_the_levels_that_it_says) {
    const words two{0x000000, 0xffffff, 0x000000, 0xffffff, 0, 0, 0, 0};
    EXPECT_EQ(words_of({1, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, {{0x50}}}, path("1.png")), two);
    EXPECT_EQ(words_of({2, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, {{0x1b}}}, path("2.png")),
              (words{0, 0x555555, 0xaaaaaa, 0xffffff}));
    EXPECT_EQ(words_of({4, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, {{0x18}}}, path("4.png")),
              (words{0x111111, 0x888888}));
    described_png keyed{8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_ADAM7, {{0x80, 0x81}}};
    keyed.more = [](png_structp png, png_infop info) {
        png_color_16 key{};
        key.gray = 0x80;
        png_set_tRNS(png, info, nullptr, 0, &key);
    };
    EXPECT_EQ(words_of(keyed, path("k.png"), l3d_alpha::transparency),
              (words{0xff808080, 0x818181}));
    described_png palette{8, PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_ADAM7, {{1, 0}}};
    palette.more = [](png_structp png, png_infop info) {
        const png_color colors[] = {{0x80, 0x40, 0x20}, {1, 2, 3}};
        png_set_PLTE(png, info, colors, 2);
        const png_byte alpha[] = {0x40};
        png_set_tRNS(png, info, alpha, 1, nullptr);
    };
    EXPECT_EQ(words_of(palette, path("p.png"), l3d_alpha::transparency),
              (words{0x010203, 0xbf804020}));
}

/// A file that says how its levels stand for light is taken at its word. libpng's screen has the
/// exponent 2.2: 255 * (128 / 255)^(1 / 2.2) = 186.
TEST_F(image_file, png_that_says_what_its_levels_mean_is_heeded) {
    for (const int depth : {8, 16}) {
        described_png grey{depth, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, {{0x80, 0x80}}};
        const auto level = [&](auto more) {
            grey.more = more;
            return words_of(grey, path("m.png"))[0] & 0xff;
        };
        EXPECT_EQ(level([](auto png, auto info) { png_set_gAMA(png, info, 1.0); }), 186u);
        EXPECT_EQ(level([](auto png, auto info) { png_set_gAMA(png, info, 0.45455); }), 128u);
        EXPECT_EQ(level([](auto png, auto info) { png_set_sRGB(png, info, 0); }), 128u);
    }
}

/// The words of a picture would take 64 GB, but so small a file cannot hold as much.
TEST_F(image_file, png_that_promises_more_than_it_holds_is_refused_before_it_takes_memory) {
    std::FILE* const file = std::fopen(path("large.png").c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, 131071, 131071, 8, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    png_write_chunk(png, reinterpret_cast<png_const_bytep>("IDAT"),
                    reinterpret_cast<png_const_bytep>("few bytes"), 9);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
    EXPECT_EQ(code_of([&] { l3d_read_png(path("large.png")); },
                      "large.png: 131071 by 131071 pixels do not fit into a file of " +
                          std::to_string(fs::file_size(path("large.png"))) + " bytes"),
              l3d_exit::bad_input);
}

TEST_F(image_file, reading_what_has_no_end_ends) {
    EXPECT_EQ(code_of([] { l3d_read_png("/dev/zero"); }, "/dev/zero: has no end within 256 MB"),
              l3d_exit::bad_input);
    EXPECT_FALSE(l3d_is_whole_image("/dev/zero", {5, 4}));
}

} // namespace
