// SPDX-License-Identifier: MIT
// l3d_image: the owner of a block of pixels; pictures read from files and written to them.
#ifndef L3D_TOOL_2D_IMAGE_H
#define L3D_TOOL_2D_IMAGE_H

#include "base/public.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <utility>

/// The stride to use for rows of `width` words: an odd number of cache lines of 64 bytes. The
/// stride exceeds the row by one word to two lines. If rows were 4096 bytes apart, a column's
/// pixels would share a set of the cache. A row's loads would wait for stores to the row above,
/// since processors tell addresses apart by their last 12 bits. A frame of 1024 x 768 would take a
/// tenth more time.
inline std::ptrdiff_t l3d_padded_stride(int width) {
    constexpr std::ptrdiff_t words_per_line = 16;
    return ((width / words_per_line + 1) | 1) * words_per_line;
}

/// Owns the words of a picture, which is black at first. l3d_pixels is a view of such words.
class L3D_PUBLIC l3d_image {
public:
    l3d_image() = default;

    /// A black image whose rows follow each other without padding.
    /// Expects: width and height not negative.
    /// Errors:  std::bad_alloc.
    explicit l3d_image(l3d_size size) : l3d_image(size, size.width) {}

    /// A black image with rows of `stride` words.
    /// Expects: width and height not negative, stride >= width.
    /// Errors:  std::bad_alloc.
    l3d_image(l3d_size size, std::ptrdiff_t stride)
        : words_(std::make_unique<std::uint32_t[]>(word_count(size, stride))), size_(size),
          stride_(stride) {
        assert(size.width >= 0 && size.height >= 0 && stride >= size.width);
    }

    /// A copy of the picture, with words of its own. Errors: std::bad_alloc.
    l3d_image(const l3d_image& other) : l3d_image(other.size_, other.stride_) {
        std::copy_n(other.words_.get(), word_count(size_, stride_), words_.get());
    }
    /// Takes over the words of the other image, which is then empty.
    l3d_image(l3d_image&& other) noexcept
        : words_(std::move(other.words_)), size_(std::exchange(other.size_, {})),
          stride_(std::exchange(other.stride_, 0)) {}
    /// Copies or takes over another picture.
    /// Errors:  std::bad_alloc, which leaves this image as it was.
    l3d_image& operator=(l3d_image other) noexcept {
        words_.swap(other.words_);
        std::swap(size_, other.size_);
        std::swap(stride_, other.stride_);
        return *this;
    }
    ~l3d_image() = default;

    /// Width and height, in pixels.
    l3d_size size() const { return size_; }

    /// A view of the words. The view is valid until the image is destroyed or assigned to.
    l3d_pixels pixels() { return {words_.get(), size_.width, size_.height, stride_}; }

private:
    /// The number of words of an image.
    /// Errors:  std::bad_alloc if no address space can hold the words. Compilers differ in whether
    ///          `new` refuses so large a size.
    static std::size_t word_count(l3d_size size, std::ptrdiff_t stride) {
        constexpr std::ptrdiff_t most = PTRDIFF_MAX / sizeof(std::uint32_t);
        if (size.height > 0 && stride > most / size.height)
            throw std::bad_alloc();
        return static_cast<std::size_t>(stride) * static_cast<std::size_t>(size.height);
    }

    std::unique_ptr<std::uint32_t[]> words_;
    l3d_size size_{};
    std::ptrdiff_t stride_ = 0;
};

// A file appears under its name only when it is complete and on the disk. So neither a full disk
// nor a power failure costs the old picture or leaves half a new one. The same pixels give the same
// bytes: no time and no program name is stored.

/// Whether a picture file has alpha. In memory, the highest byte of a pixel word is its
/// transparency.
enum class L3D_PUBLIC l3d_alpha {
    none,         ///< no: the file has red, green and blue only
    transparency, ///< yes: alpha is 255 less the transparency of the words
};

/// Writes an 8-bit PNG: RGB, or RGBA with l3d_alpha::transparency. Alpha is the share of the pixel
/// that is covered.
/// Errors:  l3d_error(failure) that names the path and the system's or libpng's reason.
L3D_PUBLIC void l3d_write_png(const std::string& path, const l3d_pixels& pixels,
                              l3d_alpha alpha = l3d_alpha::none);

/// The bytes of the PNG file that l3d_write_png would write.
/// Errors:  std::bad_alloc; l3d_error(failure) with libpng's reason.
L3D_PUBLIC std::string l3d_encoded_png(const l3d_pixels& pixels, l3d_alpha alpha = l3d_alpha::none);

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

/// Writes a picture of floats as a grey PFM into an open file, for streams.
/// Shape, Expects: as for the function that takes a path.
/// Errors:  l3d_error(failure) that gives `name` and the system's reason.
L3D_PUBLIC void l3d_write_pfm(std::FILE* file, const std::string& name, int width, int height,
                              std::span<const float> values);

/// Writes PNG or PPM, as the path's ending says: .png or .ppm, in capital or small letters.
/// Errors:  l3d_error(usage) that names the path if the ending is another one, or .ppm with
///          l3d_alpha::transparency; else as l3d_write_png.
L3D_PUBLIC void l3d_write_image(const std::string& path, const l3d_pixels& pixels,
                                l3d_alpha alpha = l3d_alpha::none);

/// Reads any PNG as 8-bit RGB, rows without padding. Values of 8 and of 16 bits are sRGB levels,
/// unless the file says otherwise (gAMA, sRGB). With l3d_alpha::transparency, the words' highest
/// bytes say how transparent the pixels are, as l3d_write_png takes them. Otherwise the picture is
/// laid on black, in linear light.
/// Errors:  l3d_error(bad_input) that names the path and the reason. A file too short for its
///          picture is refused before memory is taken for the picture.
L3D_PUBLIC l3d_image l3d_read_png(const std::string& path, l3d_alpha alpha = l3d_alpha::none);

/// The largest number of pixels of a picture that is read, unless the caller gives another limit. A
/// picture of this size has 8 GB of words.
inline constexpr std::int64_t l3d_most_image_pixels = std::numeric_limits<std::int32_t>::max();

/// Reads PNG, binary PPM (P6, levels up to 255) or JPEG, whichever the contents are. Rows have no
/// padding. The words' highest bytes say how transparent the pixels are, as from l3d_read_png with
/// l3d_alpha::transparency. For PPM and JPEG, these bytes are 0.
/// Errors:  l3d_error(bad_input) that names the path and the reason, also for a file that is cut
///          off or damaged. A picture of more than `most_pixels` is refused before memory is taken
///          for it.
L3D_PUBLIC l3d_image l3d_read_image(const std::string& path,
                                    std::int64_t most_pixels = l3d_most_image_pixels);

/// Decodes the bytes of a file that l3d_read_image would read.
/// Errors:  as l3d_read_image, with `name` in place of the path.
L3D_PUBLIC l3d_image l3d_decoded_image(const std::string& bytes, const std::string& name,
                                       std::int64_t most_pixels = l3d_most_image_pixels);

/// Whether a file holds a whole PNG or PPM picture of this size. The ending of the file's name says
/// which of the two is expected, as for l3d_write_image. The result is false, without a reason, for
/// a file that is missing, cut off or damaged.
/// Cost:    reads and unpacks the file.
L3D_PUBLIC bool l3d_is_whole_image(const std::string& path, l3d_size size);

#endif
