// SPDX-License-Identifier: MIT
// A picture that notices when somebody writes beside it.
#ifndef L3D_TESTS_RASTER_CANVAS_2D_H
#define L3D_TESTS_RASTER_CANVAS_2D_H

#include "raster/shapes/rasterizer_2d_sw.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

using pixel_set = std::set<std::pair<int, int>>;

/// A picture with guard words behind every row and before and after the picture.
class canvas {
public:
    canvas(int width, int height)
        : width_(width), height_(height),
          words_(std::size_t(width + gap) * std::size_t(height + 2), guard),
          imp_({words_.data() + width + gap, width, height, width + gap}), draw(imp_) {
        draw.clear_buffer();
    }

    /// What the test draws with.
    static constexpr std::uint32_t color = 0x0000ff80;

    std::uint32_t& at(int x, int y) {
        return words_[std::size_t(y + 1) * std::size_t(width_ + gap) + std::size_t(x)];
    }

    /// The pixels that are lit. A pixel of another colour than the test's fails.
    pixel_set lit() {
        pixel_set result;
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                const std::uint32_t word = at(x, y);
                if (word != 0)
                    result.insert({x, y});
                EXPECT_TRUE(word == 0 || word == color);
            }
        return result;
    }

    bool guards_intact() const {
        for (int i = 0; i < static_cast<int>(words_.size()); ++i) {
            const int x = i % (width_ + gap), y = i / (width_ + gap) - 1;
            const bool inside = x < width_ && y >= 0 && y < height_;
            if (!inside && words_[static_cast<std::size_t>(i)] != guard)
                return false;
        }
        return true;
    }

private:
    static constexpr int gap = 3;
    static constexpr std::uint32_t guard = 0xdeadbeef;
    int width_, height_;
    std::vector<std::uint32_t> words_;
    l3d_rasterizer_2d_sw_imp imp_;

public:
    l3d_rasterizer_2d draw;
};

#endif
