// SPDX-License-Identifier: MIT
// l3d_screen_memory: the screen without a display; tests, batches and benches run on it.
#ifndef L3D_TOOL_2D_SCREEN_MEMORY_H
#define L3D_TOOL_2D_SCREEN_MEMORY_H

#include "base/public.h"
#include "tool_2d/image.h"
#include "tool_2d/screen.h"

/// Pixels that nobody sees. There are no events, and wait returns at once.
///
/// Shape:   rows are longer than the picture, so that nobody comes to rely on stride == width.
class L3D_PUBLIC l3d_screen_memory final : public l3d_screen {
public:
    /// A screen of this size. Expects: width and height at least 1.
    /// Errors:  std::bad_alloc.
    explicit l3d_screen_memory(l3d_size size);

private:
    l3d_pixels do_pixels() override { return image_.pixels(); }
    const l3d_screen_info& do_info() const override { return info_; }
    void do_show(const l3d_pixel_box&) override {}
    std::string do_describe() const override;
    bool do_next_event(l3d_event&) override { return false; }
    void do_wait(std::chrono::nanoseconds, int) override {}

    l3d_image image_;
    l3d_screen_info info_;
};

/// Makes screens without a display; serves everywhere.
class L3D_PUBLIC l3d_screen_factory_memory final : public l3d_screen_factory {
private:
    /// Errors:  none.
    l3d_service do_service() const override { return {.is_seen = false}; }

    /// Errors:  null, with the size in the reason, if there is not enough memory for it.
    std::unique_ptr<l3d_screen> do_create(const l3d_screen_request& request,
                                          l3d_service& refusal) const override;
};

#endif
