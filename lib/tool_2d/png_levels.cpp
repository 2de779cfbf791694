// SPDX-License-Identifier: MIT
// decoded_png_levels: reads levels of 16 bits by libpng's usual interface, since its simple one
// takes them for linear light.
#include "tool_2d/png_levels_p.h"

#include "tool_2d/jpeg_image_p.h"

#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <cstring>

#include <png.h>

namespace l3d_detail {

namespace {

constexpr std::size_t bytes_per_pixel = 6; ///< red, green and blue, the high byte of each first

/// Reads a PNG file in steps. A fault ends a step by a jump, so a step has no locals that would
/// have to be destroyed.
class png_reader {
public:
    explicit png_reader(const std::string& bytes) : bytes_(bytes) {}
    png_reader(const png_reader&) = delete;
    png_reader& operator=(const png_reader&) = delete;
    ~png_reader() { png_destroy_read_struct(&png_, &info_, nullptr); }

    /// Reads the header. Like each step, returns false if it fails; then why() says what is wrong.
    bool read_header() {
        if (setjmp(back_) != 0)
            return false;
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore);
        info_ = png_ ? png_create_info_struct(png_) : nullptr;
        if (!info_)
            return false;
        png_set_read_fn(png_, this, read);
        png_read_info(png_, info_);
        return true;
    }
    /// Begins to decode. All pixels come as three channels of 16 bits.
    bool start() {
        if (setjmp(back_) != 0)
            return false;
        png_set_expand_16(png_);
        png_set_gray_to_rgb(png_);
        png_set_strip_alpha(png_);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        return true;
    }
    bool read_rows(png_bytep* rows) {
        if (setjmp(back_) != 0)
            return false;
        png_read_image(png_, rows);
        return true;
    }

    std::uint32_t width() const { return png_get_image_width(png_, info_); }
    std::uint32_t height() const { return png_get_image_height(png_, info_); }
    std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }
    const char* why() const { return why_.data(); }

private:
    [[noreturn]] static void fail(png_structp png, png_const_charp why) {
        auto* const self = static_cast<png_reader*>(png_get_error_ptr(png));
        std::snprintf(self->why_.data(), self->why_.size(), "%s", why);
        std::longjmp(self->back_, 1);
    }
    static void ignore(png_structp, png_const_charp) {}
    static void read(png_structp png, png_bytep to, std::size_t count) {
        auto* const self = static_cast<png_reader*>(png_get_io_ptr(png));
        if (count > self->bytes_.size() - self->at_)
            png_error(png, "the file ends too early");
        std::memcpy(to, self->bytes_.data() + self->at_, count);
        self->at_ += count;
    }

    const std::string& bytes_;
    std::size_t at_ = 0; ///< number of bytes that were read
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::jmp_buf back_{};
    std::array<char, 256> why_{"libpng has no memory"};
};

} // namespace

png_levels decoded_png_levels(const std::string& bytes, const std::string& path,
                              std::int64_t most_pixels) {
    png_reader reader(bytes);
    const auto must = begun(reader, path, most_pixels);
    const std::size_t height = reader.height(), row_bytes = reader.row_bytes();
    std::vector<png_byte> pixels(row_bytes * height);
    std::vector<png_bytep> rows;
    for (std::size_t y = 0; y < height; ++y)
        rows.push_back(pixels.data() + y * row_bytes);
    must(reader.read_rows(rows.data()));
    png_levels result{{static_cast<int>(reader.width()), static_cast<int>(height)}, {}};
    for (std::size_t at = 0; at < pixels.size(); at += bytes_per_pixel) {
        int sum = 0;
        for (std::size_t c = 0; c < bytes_per_pixel; c += 2)
            sum += pixels[at + c] << 8 | pixels[at + c + 1];
        result.means.push_back(sum / (3 * 65535.0));
    }
    return result;
}

} // namespace l3d_detail
