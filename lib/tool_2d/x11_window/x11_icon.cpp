// SPDX-License-Identifier: MIT
// x11_icon: unpacks the library's own picture, which is a PNG.
#include "tool_2d/x11_window/x11_icon_p.h"

#include <cstddef>
#include <cstdint>

#include <png.h>

namespace l3d_detail {

namespace {

constexpr unsigned char file[] = {
#include "packaging/desktop/icon.png.bytes"
};

} // namespace

std::vector<long> x11_icon() {
    png_image picture{};
    picture.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&picture, file, sizeof file) == 0)
        return {};
    picture.format = PNG_FORMAT_RGBA;
    std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(picture));
    if (png_image_finish_read(&picture, nullptr, bytes.data(), 0, nullptr) == 0)
        return {};
    std::vector<long> words{static_cast<long>(picture.width), static_cast<long>(picture.height)};
    for (std::size_t i = 0; i < bytes.size(); i += 4)
        words.push_back(static_cast<long>(bytes[i + 3]) << 24 | static_cast<long>(bytes[i]) << 16 |
                        static_cast<long>(bytes[i + 1]) << 8 | static_cast<long>(bytes[i + 2]));
    return words;
}

} // namespace l3d_detail
