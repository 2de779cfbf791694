// SPDX-License-Identifier: MIT
// sizable_screen: pixels in memory that get another size when a test says so.
#ifndef L3D_TESTS_PIPELINE_SIZABLE_SCREEN_H
#define L3D_TESTS_PIPELINE_SIZABLE_SCREEN_H

#include "tool_2d/image.h"
#include "tool_2d/screen.h"

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace pipeline_tests {

/// Pixels in memory, of any size. Rows lie three words farther apart than they are long.
class sizable_screen final : public l3d_screen {
public:
    explicit sizable_screen(l3d_size size) { resize(size); }

    bool slow = false;               ///< pictures travel over a slow line
    std::vector<l3d_pixel_box> text; ///< where it was last said to stand

    void resize(l3d_size size) { image_ = l3d_image(size, size.width + 3); }

private:
    l3d_pixels do_pixels() override { return image_.pixels(); }
    const l3d_screen_info& do_info() const override { return info_; }
    void do_show(const l3d_pixel_box&) override {}
    bool do_is_slow() const override { return slow; }
    void do_set_text(std::vector<l3d_pixel_box> boxes) override { text = std::move(boxes); }
    std::string do_describe() const override { return "sizable"; }
    bool do_next_event(l3d_event&) override { return false; }
    void do_wait(std::chrono::nanoseconds, int) override {}

    l3d_image image_;
    l3d_screen_info info_;
};

} // namespace pipeline_tests

#endif
