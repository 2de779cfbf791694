// SPDX-License-Identifier: MIT
// Reads and writes images: PNG by libpng's simplified interface, PPM and PFM by hand; not JPEG.
#include "tool_2d/image.h"

#include "base/error.h"
#include "tool_2d/jpeg_image_p.h"
#include "tool_2d/output_file_p.h"
#include "tool_2d/screen_info.h"
#include "tool_2d/text_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string_view>
#include <vector>

#include <png.h>

namespace {

using l3d_detail::output_file;
using l3d_detail::throw_write_error;

constexpr std::size_t rgb_bytes = 3;

/// Writes words as red, green, blue, and opacity if `to` has room for it. Shape: `to` has
/// bytes_of_word bytes for each word.
template <std::size_t bytes_of_word>
void put_words(std::span<const std::uint32_t> words, std::uint8_t* to) {
    for (const auto word : words) {
        to[0] = static_cast<std::uint8_t>(word >> 16);
        to[1] = static_cast<std::uint8_t>(word >> 8);
        to[2] = static_cast<std::uint8_t>(word);
        if constexpr (bytes_of_word > rgb_bytes)
            to[rgb_bytes] = static_cast<std::uint8_t>(~word >> 24);
        to += bytes_of_word;
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

/// The head of a PPM of this size. ppm_bytes() is the number of bytes after the head.
std::string ppm_head(l3d_size size) {
    return "P6\n" + std::to_string(size.width) + " " + std::to_string(size.height) + "\n255\n";
}

std::size_t ppm_bytes(l3d_size size) {
    return rgb_bytes * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

/// A picture that libpng reads in several calls. Its memory is freed with the object.
struct png_picture : png_image {
    png_picture() : png_image{} { version = PNG_IMAGE_VERSION; }
    png_picture(const png_picture&) = delete;
    png_picture& operator=(const png_picture&) = delete;
    ~png_picture() { png_image_free(this); }
};

/// Whether a file of this many bytes can hold a picture. The smallest pixel has one bit, and
/// deflate shortens 258 bytes to 2 bits at best.
bool may_hold(std::size_t bytes, const png_image& picture) {
    constexpr std::uint64_t most_pixels = std::uint64_t{258} * 4 * 8; // for each byte of the file
    return std::uint64_t{picture.width} * picture.height <= most_pixels * bytes;
}

/// Decodes a PNG file, whose bytes are `text`.
/// Errors:  l3d_error(bad_input) that names the path and the reason.
l3d_image decoded(const std::string& text, const std::string& path, l3d_alpha alpha,
                  std::int64_t most_pixels = l3d_most_image_pixels) {
    const bool with_alpha = alpha == l3d_alpha::transparency;
    const auto refuse = [&path](const std::string& why) {
        throw l3d_error(l3d_exit::bad_input, path + ": " + why);
    };
    png_picture picture;
    if (png_image_begin_read_from_memory(&picture, text.data(), text.size()) == 0)
        refuse(picture.message);
    if (!may_hold(text.size(), picture))
        refuse(std::to_string(picture.width) + " by " + std::to_string(picture.height) +
               " pixels do not fit into a file of " + std::to_string(text.size()) + " bytes");
    l3d_detail::check_image_size(path, picture.width, picture.height, most_pixels);
    picture.format = with_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    picture.flags |= PNG_IMAGE_FLAG_16BIT_sRGB; // else libpng would take 16 bits for linear light
    std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(picture));
    const png_color black{};
    if (png_image_finish_read(&picture, with_alpha ? nullptr : &black, bytes.data(), 0, nullptr) ==
        0)
        refuse(picture.message);

    l3d_image image({static_cast<int>(picture.width), static_cast<int>(picture.height)},
                    static_cast<std::ptrdiff_t>(picture.width));
    const auto* rgb = bytes.data();
    for (int y = 0; y < image.pixels().height; ++y) {
        for (auto& word : image.pixels().row(y)) {
            word = l3d_rgb(rgb[0], rgb[1], rgb[2]);
            if (with_alpha)
                word |= static_cast<std::uint32_t>(rgb[rgb_bytes] ^ 0xff) << 24;
            rgb += rgb_bytes + (with_alpha ? 1 : 0);
        }
    }
    return image;
}

/// Reads a number in the head of a PPM. Before the number, blanks are skipped, and comments from #
/// to the end of a line.
std::optional<int> next_number(std::string_view text, std::size_t& at) {
    for (bool in_comment = false; at < text.size(); ++at) {
        in_comment = (in_comment || text[at] == '#') && text[at] != '\n';
        if (!in_comment && std::isspace(static_cast<unsigned char>(text[at])) == 0)
            break;
    }
    int number = 0;
    const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
    at = static_cast<std::size_t>(end - text.data());
    return error == std::errc() ? std::optional(number) : std::nullopt;
}

/// Decodes a binary PPM, whose text begins with P6. Errors: l3d_error(bad_input), as decoded()
/// does.
l3d_image decoded_ppm(const std::string& text, const std::string& path, std::int64_t most_pixels) {
    const auto refuse = [&path](const std::string& why) {
        throw l3d_error(l3d_exit::bad_input, path + ": " + why);
    };
    std::size_t at = 2;
    const auto width = next_number(text, at), height = next_number(text, at);
    const auto most = next_number(text, at);
    if (!width || !height || !most || *width <= 0 || *height <= 0 || *most <= 0 || *most > 255)
        refuse("no binary PPM has a head like this: P6, width, height, a level of 1 to 255");
    l3d_detail::check_image_size(path, *width, *height, most_pixels);
    const l3d_size size{*width, *height};
    if (text.size() < at + 1 + ppm_bytes(size))
        refuse("the file ends after " + std::to_string(text.size()) + " of " +
               std::to_string(at + 1 + ppm_bytes(size)) + " bytes");
    l3d_image image(size);
    const char* rgb = text.data() + at + 1;
    for (int y = 0; y < size.height; ++y)
        for (auto& word : image.pixels().row(y)) {
            const auto level = [&](std::size_t i) {
                const int value = std::min<int>(static_cast<unsigned char>(rgb[i]), *most);
                return (255 * value + *most / 2) / *most;
            };
            word = l3d_rgb(level(0), level(1), level(2));
            rgb += rgb_bytes;
        }
    return image;
}

void write_png(std::FILE* file, const std::string& name, const l3d_pixels& pixels,
               l3d_alpha alpha) {
    const bool with_alpha = alpha == l3d_alpha::transparency;
    const std::size_t row =
        (rgb_bytes + (with_alpha ? 1 : 0)) * static_cast<std::size_t>(pixels.width);
    std::vector<std::uint8_t> bytes(row * static_cast<std::size_t>(pixels.height));
    for (int y = 0; y < pixels.height; ++y) {
        std::uint8_t* const to = bytes.data() + row * static_cast<std::size_t>(y);
        with_alpha ? put_words<rgb_bytes + 1>(pixels.row(y), to)
                   : put_words<rgb_bytes>(pixels.row(y), to);
    }

    png_picture picture;
    picture.width = static_cast<png_uint_32>(pixels.width);
    picture.height = static_cast<png_uint_32>(pixels.height);
    picture.format = with_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    errno = 0;
    if (png_image_write_to_stdio(&picture, file, 0, bytes.data(), 0, nullptr) == 0) {
        if (errno != 0)
            throw_write_error(name);
        throw l3d_error(l3d_exit::failure, name + ": " + picture.message);
    }
}

} // namespace

void l3d_detail::check_image_size(const std::string& path, std::int64_t width, std::int64_t height,
                                  std::int64_t most_pixels) {
    if (width > most_pixels / height)
        throw l3d_error(l3d_exit::bad_input, path + ": " + std::to_string(width) + " by " +
                                                 std::to_string(height) + " pixels are more than " +
                                                 std::to_string(most_pixels));
}

void l3d_write_png(const std::string& path, const l3d_pixels& pixels, l3d_alpha alpha) {
    output_file file(path);
    write_png(file.get(), path, pixels, alpha);
    file.commit();
}

std::string l3d_encoded_png(const l3d_pixels& pixels, l3d_alpha alpha) {
    char* bytes = nullptr;
    std::size_t size = 0;
    struct memory {
        char*& bytes;
        ~memory() { std::free(bytes); }
    };
    const memory owner{bytes}; // the stream moves the memory as it grows
    l3d_detail::unique_file file(open_memstream(&bytes, &size));
    if (!file)
        throw std::bad_alloc();
    write_png(file.get(), "PNG", pixels, alpha);
    file.reset();
    return {bytes, size};
}

void l3d_write_ppm(std::FILE* file, const std::string& name, const l3d_pixels& pixels) {
    write_text(file, name, ppm_head(pixels.size()));
    std::vector<std::uint8_t> bytes(rgb_bytes * static_cast<std::size_t>(pixels.width));
    for (int y = 0; y < pixels.height; ++y) {
        put_words<rgb_bytes>(pixels.row(y), bytes.data());
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
    return decoded(l3d_read_text_file(path), path, alpha);
}

l3d_image l3d_decoded_image(const std::string& bytes, const std::string& name,
                            std::int64_t most_pixels) {
    if (bytes.starts_with("\x89PNG"))
        return decoded(bytes, name, l3d_alpha::transparency, most_pixels);
    if (bytes.starts_with("\xFF\xD8"))
        return l3d_detail::decoded_jpeg(bytes, name, most_pixels);
    if (bytes.starts_with("P6"))
        return decoded_ppm(bytes, name, most_pixels);
    throw l3d_error(l3d_exit::bad_input, name + ": neither PNG nor JPEG nor binary PPM");
}

l3d_image l3d_read_image(const std::string& path, std::int64_t most_pixels) {
    return l3d_decoded_image(l3d_read_text_file(path), path, most_pixels);
}

bool l3d_is_whole_image(const std::string& path, l3d_size size) {
    // libpng stops reading after the last row. A file ends with an empty chunk and its checksum.
    constexpr std::string_view last_chunk("\0\0\0\0IEND\xAE\x42\x60\x82", 12);
    try {
        const std::string text = l3d_read_text_file(path);
        if (ends_with(path, ".png"))
            return decoded(text, path, l3d_alpha::none).pixels().size() == size &&
                   text.ends_with(last_chunk);
        const std::string head = ppm_head(size);
        return text.starts_with(head) && text.size() - head.size() == ppm_bytes(size);
    } catch (const l3d_error&) {
        return false;
    }
}
