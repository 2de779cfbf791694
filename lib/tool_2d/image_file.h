// SPDX-License-Identifier: MIT
// Pictures in files: PNG, PPM, PFM and JPEG.
#ifndef L3D_TOOL_2D_IMAGE_FILE_H
#define L3D_TOOL_2D_IMAGE_FILE_H

#include "base/public.h"
#include "tool_2d/image.h"
#include "tool_2d/pixels.h"

#include <cstdint>
#include <cstdio>
#include <limits>
#include <span>
#include <string>

// A file appears under its name only when it is complete and on the disk. So neither a full disk
// nor a power failure costs the old picture or leaves half a new one. The same pixels give the same
// bytes: no time and no program name is stored.

/// The meaning of a pixel word's highest byte in a file.
enum class L3D_PUBLIC l3d_alpha {
    none,         ///< nothing: the file has red, green and blue
    transparency, ///< how transparent a pixel is (l3d_pixels): the file has an alpha channel
};

/// Writes an 8-bit RGB or RGBA PNG. Alpha is the share of the pixel that is covered.
/// Errors:  l3d_error(failure) that names the path and the system's or libpng's reason.
L3D_PUBLIC void l3d_write_png(const std::string& path, const l3d_pixels& pixels,
                              l3d_alpha alpha = l3d_alpha::none);

/// Writes a binary PPM (P6) into an open file, for streams; pictures may follow each other.
/// Errors:  l3d_error(failure) that gives `name` and the system's reason.
L3D_PUBLIC void l3d_write_ppm(std::FILE* file, const std::string& name, const l3d_pixels& pixels);

/// Writes a binary PPM (P6) file. Errors: as l3d_write_png.
L3D_PUBLIC void l3d_write_ppm(const std::string& path, const l3d_pixels& pixels);

/// Writes a picture of floats as a grey PFM: little-endian (scale -1.0), bottom row first.
/// Shape:   height rows of width values, row 0 on top.
/// Expects: values.size() == width * height.
/// Errors:  as l3d_write_png.
L3D_PUBLIC void l3d_write_pfm(const std::string& path, int width, int height,
                              std::span<const float> values);

/// The same into an open file, for streams.
/// Errors:  l3d_error(failure) that gives `name` and the system's reason.
L3D_PUBLIC void l3d_write_pfm(std::FILE* file, const std::string& name, int width, int height,
                              std::span<const float> values);

/// Writes PNG or PPM, by the end of the path: .png or .ppm, in either case.
/// Errors:  l3d_error(usage) that names the path if it ends otherwise, or in .ppm although there is
///          alpha; else as l3d_write_png.
L3D_PUBLIC void l3d_write_image(const std::string& path, const l3d_pixels& pixels,
                                l3d_alpha alpha = l3d_alpha::none);

/// Reads any PNG as 8-bit RGB, rows without padding. Values of 8 and of 16 bits are levels, unless
/// the file says otherwise (gAMA, sRGB). With l3d_alpha::transparency, the words' highest bytes say
/// how transparent they are, as l3d_write_png takes them; else the picture is laid on black, in
/// linear light.
/// Errors:  l3d_error(bad_input) that names the path and the reason, also for a file that is too
///          short for its picture, before memory is taken for it.
L3D_PUBLIC l3d_image l3d_read_png(const std::string& path, l3d_alpha alpha = l3d_alpha::none);

/// The most pixels that are read unless somebody says otherwise: 8 GB of words.
inline constexpr std::int64_t l3d_most_image_pixels = std::numeric_limits<std::int32_t>::max();

/// Reads PNG, binary PPM (P6, levels up to 255) or JPEG, by what the file holds. Rows have no
/// padding. The words' highest bytes say how transparent they are, as l3d_read_png has them with
/// l3d_alpha::transparency; of PPM and JPEG they are 0.
/// Errors:  l3d_error(bad_input) that names the path and the reason, also for a file that is cut
///          off or damaged, and for one of more pixels, before memory is taken for them.
L3D_PUBLIC l3d_image l3d_read_image(const std::string& path,
                                    std::int64_t most_pixels = l3d_most_image_pixels);

/// The picture that such a file's bytes hold. Errors: the same, with `name` in place of the path.
L3D_PUBLIC l3d_image l3d_decoded_image(const std::string& bytes, const std::string& name,
                                       std::int64_t most_pixels = l3d_most_image_pixels);

/// Whether a file holds a whole PNG or PPM of that size. Its name says which kind, as for
/// l3d_write_image. False, without a reason, if there is no file, or one that was cut off or
/// damaged on the disk.
/// Cost:    reads and unpacks the file.
L3D_PUBLIC bool l3d_is_whole_image(const std::string& path, l3d_size size);

#endif
