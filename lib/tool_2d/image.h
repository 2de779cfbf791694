// SPDX-License-Identifier: MIT
// l3d_image: the owner of a block of pixels.
#ifndef L3D_TOOL_2D_IMAGE_H
#define L3D_TOOL_2D_IMAGE_H

#include "base/public.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <utility>

/// A stride for rows of `width` words: an odd number of cache lines of 64 bytes, from one word to
/// two lines longer. If rows were 4096 bytes apart, a column's pixels would share a set of the
/// cache. A row's loads would wait for stores to the row above, since processors tell addresses
/// apart by their last 12 bits. A frame of 1024 x 768 would take a tenth more time.
inline std::ptrdiff_t l3d_padded_stride(int width) {
    constexpr std::ptrdiff_t words_per_line = 16;
    return ((width / words_per_line + 1) | 1) * words_per_line;
}

/// Owns the words that l3d_pixels views; black at first.
class L3D_PUBLIC l3d_image {
public:
    l3d_image() = default;

    /// A black image with rows of `stride` words.
    /// Expects: width and height not negative, stride >= width.
    /// Errors:  std::bad_alloc.
    l3d_image(l3d_size size, std::ptrdiff_t stride)
        : words_(std::make_unique<std::uint32_t[]>(word_count(size, stride))), size_(size),
          stride_(stride) {
        assert(size.width >= 0 && size.height >= 0 && stride >= size.width);
    }

    /// A copy of the picture; its words are its own. Errors: std::bad_alloc.
    l3d_image(const l3d_image& other) : l3d_image(other.size_, other.stride_) {
        std::copy_n(other.words_.get(), word_count(size_, stride_), words_.get());
    }
    /// Takes the words over; the other image is empty then.
    l3d_image(l3d_image&& other) noexcept
        : words_(std::move(other.words_)), size_(std::exchange(other.size_, {})),
          stride_(std::exchange(other.stride_, 0)) {}
    /// Copies or takes over another picture. Errors: std::bad_alloc; the image keeps its words.
    l3d_image& operator=(l3d_image other) noexcept {
        words_.swap(other.words_);
        std::swap(size_, other.size_);
        std::swap(stride_, other.stride_);
        return *this;
    }
    ~l3d_image() = default;

    /// Width and height, in pixels.
    l3d_size size() const { return size_; }

    /// A view of the words. Lives: it ends when the image does, or is assigned to.
    l3d_pixels pixels() { return {words_.get(), size_.width, size_.height, stride_}; }

private:
    /// Compilers differ in whether `new` refuses what no address space holds.
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

#endif
