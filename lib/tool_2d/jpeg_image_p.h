// SPDX-License-Identifier: MIT
// decoded_jpeg: the picture of a JPEG file; and the first steps that readers of pictures share.
#ifndef L3D_TOOL_2D_JPEG_IMAGE_P_H
#define L3D_TOOL_2D_JPEG_IMAGE_P_H

#include "base/error.h"
#include "tool_2d/image.h"

#include <cstdint>
#include <string>

namespace l3d_detail {

/// Refuses a picture that is too large.
/// Errors:  l3d_error(bad_input) that names the path, if width * height exceeds `most_pixels`.
void check_image_size(const std::string& path, std::int64_t width, std::int64_t height,
                      std::int64_t most_pixels);

/// Takes the first steps with a reader of pictures: reads the header, checks the size, and starts
/// to decode. Returns a function that checks the results of further steps. `reader` and `path` must
/// outlive the returned function.
/// Errors:  l3d_error(bad_input) that names the path and the reason, also from the returned
///          function.
template <class Reader>
auto begun(Reader& reader, const std::string& path, std::int64_t most_pixels) {
    const auto must = [&reader, &path](bool is_done) {
        if (!is_done)
            throw l3d_error(l3d_exit::bad_input, path + ": " + reader.why());
    };
    must(reader.read_header());
    check_image_size(path, reader.width(), reader.height(), most_pixels);
    must(reader.start());
    return must;
}

/// The picture in the bytes of a JPEG file, grey or in colour, as l3d_read_image gives it.
/// Errors:  l3d_error(bad_input) that names the path and the reason. The decoder's warnings of
///          missing or damaged bytes are errors, too.
l3d_image decoded_jpeg(const std::string& bytes, const std::string& path, std::int64_t most_pixels);

} // namespace l3d_detail

#endif
