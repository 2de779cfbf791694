// SPDX-License-Identifier: MIT
// l3d_screen: where pixels become visible; and the factory that makes one.
#ifndef L3D_TOOL_2D_SCREEN_H
#define L3D_TOOL_2D_SCREEN_H

#include "tool_2d/event.h"
#include "tool_2d/pixels.h"
#include "tool_2d/screen_info.h"

#include <memory>
#include <string>

/// A passive output device: it owns pixels and shows them; it draws nothing itself.
class l3d_screen : public l3d_event_source {
public:
    /// The pixels to draw into. A resize event makes earlier views invalid.
    l3d_pixels pixels() { return do_pixels(); }

    /// How this screen's pixel words and its display's native pixels look.
    const l3d_screen_info& info() const { return do_info(); }

    /// Makes the pixels visible.
    void show() { do_show(); }

    /// One line for --verbose and --diagnose: kind, depth, bits per pixel, byte order.
    std::string describe() const { return do_describe(); }

private:
    virtual l3d_pixels do_pixels() = 0;
    virtual const l3d_screen_info& do_info() const = 0;
    virtual void do_show() = 0;
    virtual std::string do_describe() const = 0;
};

/// What a program asks of its screen.
struct l3d_screen_request {
    l3d_size size{1024, 768};
    std::string title = "l3d";
};

/// Makes screens of one kind.
class l3d_screen_factory {
public:
    l3d_screen_factory() = default;
    l3d_screen_factory(const l3d_screen_factory&) = delete;
    l3d_screen_factory& operator=(const l3d_screen_factory&) = delete;
    virtual ~l3d_screen_factory() = default;

    /// Whether this kind can serve here and now.
    ///
    /// Errors: false, with one line in `why`, if it cannot.
    bool can_serve(std::string& why) const { return do_can_serve(why); }

    /// Errors: null, with one line in `why`, if this kind cannot serve here.
    std::unique_ptr<l3d_screen> create(const l3d_screen_request& request, std::string& why) const {
        return do_create(request, why);
    }

private:
    virtual bool do_can_serve(std::string& why) const = 0;
    virtual std::unique_ptr<l3d_screen> do_create(const l3d_screen_request& request,
                                                  std::string& why) const = 0;
};

#endif
