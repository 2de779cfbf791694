// SPDX-License-Identifier: MIT
// x11_resolution: the display's fineness by the user's present settings.
#ifndef L3D_TOOL_2D_X11_WINDOW_X11_RESOLUTION_P_H
#define L3D_TOOL_2D_X11_WINDOW_X11_RESOLUTION_P_H

#include "tool_2d/x11_window/x11_echo_p.h"
#include "tool_2d/x11/x11_window_p.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include <xcb/xcb.h>

namespace l3d_detail {

/// The setting Xft/DPI in the text of an XSETTINGS manager, in dots an inch; none if there is none,
/// or if the text is not whole.
/// Source:  the XSETTINGS protocol of freedesktop.org: numbers in the writer's order of bytes, each
///          setting with type, name, serial and value, padded to words; dots in units of 1/1024.
std::optional<double> xsettings_dpi(std::span<const std::uint8_t> text);

/// Follows the dots an inch: those of a manager of settings, else those of the display's resources.
/// As in x11_wm_facts nobody waits for a reply.
/// Expects: x11_wm_facts has asked for events of the root.
/// Lives:   borrows the window.
class x11_resolution {
public:
    explicit x11_resolution(const x11_window& window);

    /// Asks for the settings the first time, and from then on hears of changes by itself. Asks
    /// later if the connection has no room. To be called now and then.
    void look_after() {
        if (stage_ == stage::unwatched || is_due_)
            proceed();
    }

    /// Looks at an event; the fineness, as x11_fineness has it, if it brought news of that.
    std::optional<double> take(const XEvent& event);

    /// Whether the event is about the window of the manager of settings.
    bool is_foreign(const XEvent& event) const {
        return manager_ != 0 && event.xany.window == manager_;
    }

private:
    enum class stage { unwatched, naming, named, finding, found, reading, watching };
    enum name { selection, settings, manager, name_count };

    void proceed();
    void ask_names();
    void hear_names();
    void find();
    void read();
    double hear();
    bool concerns_us(const XEvent& event) const;

    const x11_window& window_;
    xcb_connection_t* xcb_;
    x11_echo echo_;
    stage stage_ = stage::unwatched;
    bool is_due_ = false; ///< the next question is asked as soon as the connection has room
    bool again_ = false;  ///< something changed while a question was under way
    std::array<xcb_intern_atom_cookie_t, name_count> names_{};
    std::array<xcb_atom_t, name_count> atoms_{};
    xcb_get_selection_owner_cookie_t owner_{};
    xcb_get_property_cookie_t settings_{}, resources_{};
    Window manager_ = 0; ///< whose property has the settings; 0: there is none
};

} // namespace l3d_detail

#endif
