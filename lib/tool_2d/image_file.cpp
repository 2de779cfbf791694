// SPDX-License-Identifier: MIT
// PNG by libpng's simplified interface; PPM and PFM by hand.
#include "tool_2d/image_file.h"

#include "tool_2d/error.h"
#include "tool_2d/output_file_p.h"
#include "tool_2d/screen_info.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include <png.h>

namespace {

using l3d_detail::output_file;
using l3d_detail::throw_write_error;

constexpr std::size_t rgb_bytes = 3;

void append_rgb(std::vector<std::uint8_t>& bytes, std::span<const std::uint32_t> words) {
    for (const auto word : words) {
        bytes.push_back(static_cast<std::uint8_t>(word >> 16));
        bytes.push_back(static_cast<std::uint8_t>(word >> 8));
        bytes.push_back(static_cast<std::uint8_t>(word));
    }
}

void append_rgba(std::vector<std::uint8_t>& bytes, std::span<const std::uint32_t> words) {
    for (const auto word : words) {
        append_rgb(bytes, {&word, 1});
        bytes.push_back(static_cast<std::uint8_t>(~word >> 24));
    }
}

void write_bytes(std::FILE* file, const std::string& name, std::span<const std::uint8_t> bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size())
        throw_write_error(name);
}

void write_text(std::FILE* file, const std::string& name, const std::string& text) {
    if (std::fputs(text.c_str(), file) == EOF)
        throw_write_error(name);
}

bool ends_with(std::string_view path, std::string_view lower_case_end) {
    if (path.size() < lower_case_end.size())
        return false;
    const auto end = path.substr(path.size() - lower_case_end.size());
    return std::equal(end.begin(), end.end(), lower_case_end.begin(), [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == b;
    });
}

/// As l3d_write_ppm makes it: no comments, 255 levels.
bool is_whole_ppm(std::FILE* file, l3d_size size) {
    int width = 0, height = 0;
    char after = 0;
    if (std::fscanf(file, "P6 %9d %9d 255%c", &width, &height, &after) != 3 || after != '\n' ||
        l3d_size{width, height} != size)
        return false;
    const long begin = std::ftell(file);
    const auto bytes = static_cast<long>(rgb_bytes) * width * height;
    return std::fseek(file, 0, SEEK_END) == 0 && std::ftell(file) - begin == bytes;
}

/// libpng's picture, which holds memory between its calls.
struct png_picture : png_image {
    png_picture() : png_image{} { version = PNG_IMAGE_VERSION; }
    png_picture(const png_picture&) = delete;
    png_picture& operator=(const png_picture&) = delete;
    ~png_picture() { png_image_free(this); }
};

} // namespace

void l3d_write_png(const std::string& path, const l3d_pixels& pixels, l3d_alpha alpha) {
    const bool with_alpha = alpha == l3d_alpha::transparency;
    std::vector<std::uint8_t> bytes;
    bytes.reserve((rgb_bytes + (with_alpha ? 1 : 0)) * static_cast<std::size_t>(pixels.width) *
                  static_cast<std::size_t>(pixels.height));
    for (int y = 0; y < pixels.height; ++y)
        if (with_alpha)
            append_rgba(bytes, pixels.row(y));
        else
            append_rgb(bytes, pixels.row(y));

    png_picture picture;
    picture.width = static_cast<png_uint_32>(pixels.width);
    picture.height = static_cast<png_uint_32>(pixels.height);
    picture.format = with_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    output_file file(path);
    errno = 0;
    if (png_image_write_to_stdio(&picture, file.get(), 0, bytes.data(), 0, nullptr) == 0) {
        if (errno != 0)
            throw_write_error(path);
        throw l3d_error(l3d_exit::failure, path + ": " + picture.message);
    }
    file.commit();
}

void l3d_write_ppm(std::FILE* file, const std::string& name, const l3d_pixels& pixels) {
    write_text(file, name,
               "P6\n" + std::to_string(pixels.width) + " " + std::to_string(pixels.height) +
                   "\n255\n");
    std::vector<std::uint8_t> bytes;
    bytes.reserve(rgb_bytes * static_cast<std::size_t>(pixels.width));
    for (int y = 0; y < pixels.height; ++y) {
        bytes.clear();
        append_rgb(bytes, pixels.row(y));
        write_bytes(file, name, bytes);
    }
    if (std::fflush(file) != 0)
        throw_write_error(name);
}

void l3d_write_ppm(const std::string& path, const l3d_pixels& pixels) {
    output_file file(path);
    l3d_write_ppm(file.get(), path, pixels);
    file.commit();
}

void l3d_write_pfm(const std::string& path, int width, int height, std::span<const float> values) {
    output_file file(path);
    l3d_write_pfm(file.get(), path, width, height, values);
    file.commit();
}

void l3d_write_pfm(std::FILE* file, const std::string& name, int width, int height,
                   std::span<const float> values) {
    assert(values.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    // A negative scale says that the floats are little-endian.
    write_text(file, name,
               "Pf\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n");
    std::vector<std::uint8_t> bytes;
    for (int y = height - 1; y >= 0; --y) {
        bytes.clear();
        const auto columns = static_cast<std::size_t>(width);
        for (const float value : values.subspan(static_cast<std::size_t>(y) * columns, columns)) {
            const auto bits = std::bit_cast<std::uint32_t>(value);
            for (int shift = 0; shift < 32; shift += 8)
                bytes.push_back(static_cast<std::uint8_t>(bits >> shift));
        }
        write_bytes(file, name, bytes);
    }
    if (std::fflush(file) != 0)
        throw_write_error(name);
}

void l3d_write_image(const std::string& path, const l3d_pixels& pixels, l3d_alpha alpha) {
    if (ends_with(path, ".png"))
        l3d_write_png(path, pixels, alpha);
    else if (alpha == l3d_alpha::transparency)
        throw l3d_error(l3d_exit::usage, path + ": only a .png holds what is transparent");
    else if (ends_with(path, ".ppm"))
        l3d_write_ppm(path, pixels);
    else
        throw l3d_error(l3d_exit::usage, path + ": the name must end in .png or .ppm");
}

l3d_image l3d_read_png(const std::string& path, l3d_alpha alpha) {
    const l3d_detail::unique_file file(std::fopen(path.c_str(), "rb"));
    if (!file)
        throw l3d_error(l3d_exit::bad_input, path + ": " + std::strerror(errno));
    const bool with_alpha = alpha == l3d_alpha::transparency;
    png_picture picture;
    std::vector<std::uint8_t> bytes;
    bool well = png_image_begin_read_from_stdio(&picture, file.get()) != 0;
    if (well) {
        picture.format = with_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
        bytes.resize(PNG_IMAGE_SIZE(picture));
        const png_color black{};
        well = png_image_finish_read(&picture, with_alpha ? nullptr : &black, bytes.data(), 0,
                                     nullptr) != 0;
    }
    if (!well)
        throw l3d_error(l3d_exit::bad_input, path + ": " + picture.message);

    l3d_image image({static_cast<int>(picture.width), static_cast<int>(picture.height)},
                    static_cast<std::ptrdiff_t>(picture.width));
    const auto* rgb = bytes.data();
    for (int y = 0; y < image.pixels().height; ++y) {
        for (auto& word : image.pixels().row(y)) {
            word = l3d_screen_info::ext_to_native(rgb[0], rgb[1], rgb[2]);
            if (with_alpha)
                word |= static_cast<std::uint32_t>(rgb[rgb_bytes] ^ 0xff) << 24;
            rgb += rgb_bytes + (with_alpha ? 1 : 0);
        }
    }
    return image;
}

bool l3d_is_whole_image(const std::string& path, l3d_size size) {
    const l3d_detail::unique_file file(std::fopen(path.c_str(), "rb"));
    if (!file)
        return false;
    if (!ends_with(path, ".png"))
        return is_whole_ppm(file.get(), size);
    try {
        if (l3d_read_png(path).pixels().size() != size)
            return false;
    } catch (const l3d_error&) {
        return false;
    }
    // libpng stops reading behind the last row. A file ends with an empty chunk and its checksum.
    constexpr std::string_view last_chunk("\0\0\0\0IEND\xAE\x42\x60\x82", 12);
    std::array<char, last_chunk.size()> end{};
    return std::fseek(file.get(), -static_cast<long>(end.size()), SEEK_END) == 0 &&
           std::fread(end.data(), 1, end.size(), file.get()) == end.size() &&
           std::string_view(end.data(), end.size()) == last_chunk;
}
