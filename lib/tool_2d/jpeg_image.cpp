// SPDX-License-Identifier: MIT
// decoded_jpeg: reads by libjpeg, whose errors end in jumps.
#include "tool_2d/jpeg_image_p.h"

#include "tool_2d/screen_info.h"

#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <vector>

#include <jpeglib.h>

namespace l3d_detail {

namespace {

/// Reads a JPEG file row by row. A fault ends a step by a jump, so a step has no locals that would
/// have to be destroyed.
class jpeg_reader {
public:
    explicit jpeg_reader(const std::string& bytes) : bytes_(bytes) {
        info_.err = jpeg_std_error(&manager_);
        manager_.error_exit = fail;
        manager_.emit_message = warn;
        info_.client_data = this;
    }
    jpeg_reader(const jpeg_reader&) = delete;
    jpeg_reader& operator=(const jpeg_reader&) = delete;
    ~jpeg_reader() { jpeg_destroy_decompress(&info_); }

    /// Reads the header. Like each step, returns false if it fails; then why() says what is wrong.
    bool read_header() {
        if (setjmp(back_) != 0)
            return false;
        jpeg_create_decompress(&info_);
        jpeg_mem_src(&info_, reinterpret_cast<const unsigned char*>(bytes_.data()), bytes_.size());
        jpeg_read_header(&info_, TRUE);
        return true;
    }
    bool start() {
        if (setjmp(back_) != 0)
            return false;
        info_.out_color_space = JCS_RGB;
        jpeg_start_decompress(&info_);
        return true;
    }
    bool read_row(std::uint8_t* row) {
        if (setjmp(back_) != 0)
            return false;
        jpeg_read_scanlines(&info_, &row, 1);
        return true;
    }
    /// Ends the file. Some faults show only after the last row.
    bool finish() {
        if (setjmp(back_) != 0)
            return false;
        jpeg_finish_decompress(&info_);
        return true;
    }

    int width() const { return static_cast<int>(info_.image_width); }
    int height() const { return static_cast<int>(info_.image_height); }
    const char* why() const { return why_.data(); }

private:
    [[noreturn]] static void fail(j_common_ptr info) {
        auto* const self = static_cast<jpeg_reader*>(info->client_data);
        info->err->format_message(info, self->why_.data());
        std::longjmp(self->back_, 1);
    }
    /// Treats reports of damage as errors. A report of damage has a level below 0. Messages of
    /// higher levels only tell of the file's contents.
    static void warn(j_common_ptr info, int level) {
        if (level < 0)
            fail(info);
    }

    const std::string& bytes_;
    jpeg_decompress_struct info_{};
    jpeg_error_mgr manager_{};
    std::jmp_buf back_{};
    std::array<char, JMSG_LENGTH_MAX> why_{};
};

} // namespace

l3d_image decoded_jpeg(const std::string& bytes, const std::string& path,
                       std::int64_t most_pixels) {
    constexpr std::size_t rgb_bytes = 3;
    jpeg_reader reader(bytes);
    const auto must = begun(reader, path, most_pixels);
    l3d_image image({reader.width(), reader.height()}, reader.width());
    std::vector<std::uint8_t> row(rgb_bytes * static_cast<std::size_t>(reader.width()));
    for (int y = 0; y < reader.height(); ++y) {
        must(reader.read_row(row.data()));
        const std::uint8_t* rgb = row.data();
        for (auto& word : image.pixels().row(y)) {
            word = l3d_rgb(rgb[0], rgb[1], rgb[2]);
            rgb += rgb_bytes;
        }
    }
    must(reader.finish());
    return image;
}

} // namespace l3d_detail
