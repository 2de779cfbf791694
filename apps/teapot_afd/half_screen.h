// SPDX-License-Identifier: MIT
// half_screen: the left or the right half of a screen, as a whole screen for a pipeline.
#ifndef L3D_APPS_TEAPOT_AFD_HALF_SCREEN_H
#define L3D_APPS_TEAPOT_AFD_HALF_SCREEN_H

#include <l3d/screen.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

/// The places of the left and the right half of a picture. Both are equally wide. Units: pixels.
struct halves {
    int width;       ///< width of each half
    int right_start; ///< first column of the right half

    /// Divides a picture of `whole` columns. If there are more than three columns, two or three
    /// stay free between the halves. A single column serves as both halves.
    /// Expects: at least one column.
    explicit halves(int whole) : width(std::max(1, (whole - 2) / 2)), right_start(whole - width) {}

    int line_width() const { return std::max(0, right_start - width); }
};

/// One half of a screen, as a screen of its own for a pipeline. Events go to the whole screen, and
/// the whole screen's owner shows the picture.
///
/// Lives: shares the whole screen.
class half_screen final : public l3d_screen {
public:
    enum class side { left, right };

    half_screen(std::shared_ptr<l3d_screen> whole, side half)
        : whole_(std::move(whole)), half_(half) {}

private:
    l3d_pixels do_pixels() override {
        l3d_pixels pixels = whole_->pixels();
        const halves parts(pixels.width);
        if (half_ == side::right)
            pixels.words += parts.right_start;
        pixels.width = parts.width;
        return pixels;
    }
    const l3d_screen_info& do_info() const override { return whole_->info(); }
    void do_show(const l3d_pixel_box&) override {}
    bool do_is_window() const override { return whole_->is_window(); }
    double do_usual_fps() const override { return whole_->usual_fps(); }
    double do_text_scale() const override { return whole_->text_scale(); }
    std::string do_describe() const override { return whole_->describe(); }
    bool do_next_event(l3d_event&) override { return false; }
    void do_wait(std::chrono::nanoseconds, int) override {}

    std::shared_ptr<l3d_screen> whole_;
    side half_;
};

#endif
