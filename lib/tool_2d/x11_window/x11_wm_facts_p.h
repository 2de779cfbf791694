// SPDX-License-Identifier: MIT
// x11_wm_facts: the state of our window, as window manager, server and settings tell it.
#ifndef L3D_TOOL_2D_X11_WINDOW_X11_WM_FACTS_P_H
#define L3D_TOOL_2D_X11_WINDOW_X11_WM_FACTS_P_H

#include "tool_2d/pixels.h"
#include "tool_2d/x11_window/x11_echo_p.h"
#include "tool_2d/x11/x11_window_p.h"

#include <array>
#include <optional>
#include <vector>

#include <xcb/randr.h>
#include <xcb/xcb.h>

namespace l3d_detail {

/// The facts that the window manager last told.
struct x11_facts {
    bool managed = false;           ///< a window manager looks after windows
    bool grants_fullscreen = false; ///< the manager lives, and makes windows fullscreen on request
    bool fullscreen = false;        ///< the manager says that our window is fullscreen
    bool away = false; ///< our window is minimised, on another workspace, or not viewable
    /// The places of monitors, in display pixels; empty: not known.
    std::vector<l3d_pixel_box> monitors{};
    /// The display's fineness (x11_fineness), by a manager of settings or by resources.
    double fineness = 1;
};

/// Keeps the facts up to date by properties that others write: of our window, of the root, and of
/// the windows by which managers of windows and of settings show that they live.
/// Each change asks for all facts anew, in one go. The last request sends an event to ourselves. So
/// nobody waits for a reply: when this event comes, the replies are there.
/// Lives:   borrows the window.
class x11_wm_facts {
public:
    enum name {
        net_wm_state,
        net_wm_state_fullscreen,
        net_wm_state_hidden,
        wm_state,
        net_wm_desktop,
        net_current_desktop,
        net_number_of_desktops,
        net_supported,
        net_supporting_wm_check,
        xsettings,
        watched_count, ///< the number of properties above, which others write
        net_wm_pid = watched_count,
        net_wm_icon,
        xsettings_selection,
        manager,
        name_count
    };

    explicit x11_wm_facts(const x11_window& window);

    const x11_facts& facts() const { return facts_; }

    /// The number that X has for a name; 0 as long as the server has not told it.
    Atom atom(name which) const { return atoms_[which]; }

    /// Asks for everything, and from then on hears of changes by itself.
    void ask();

    /// Calls ask() if it was never called, or if the connection had no room. So a slow or stopped
    /// server does not stop the program. Call it now and then.
    void look_after() {
        if (stage_ == stage::unwatched || is_due_)
            ask();
    }

    /// Whether the answer to the last call of ask() is still due.
    bool is_asking() const { return is_due_ || echo_.is_awaited(); }

    /// Looks at an event. True if it brought new facts.
    bool take(const XEvent& event);

    /// Whether the event is about a window that is not ours.
    bool is_foreign(const XEvent& event) const;

private:
    enum class stage { unwatched, naming, watching };
    /// The requests of one question.
    struct question {
        xcb_get_window_attributes_cookie_t root, window;
        xcb_get_property_cookie_t check, checked, supported, current_desktop, desktops;
        xcb_get_property_cookie_t state, wm_state, desktop;
        xcb_get_property_cookie_t settings, resources;
        xcb_get_selection_owner_cookie_t settings_owner;
        xcb_randr_get_monitors_cookie_t monitors;
        Window asked_check = 0; ///< the window whose property `checked` asks for
        bool has_randr = false;
    };

    void ask_names();
    void hear_names();
    void ask_facts();
    void hear_facts();
    std::vector<l3d_pixel_box> hear_monitors();
    void hear_settings();
    xcb_get_property_cookie_t ask_property(Window window, name property) const;
    std::vector<std::uint32_t> hear_property(xcb_get_property_cookie_t cookie) const;
    bool concerns_us(const XEvent& event) const;

    const x11_window& window_;
    xcb_connection_t* xcb_;
    x11_echo echo_;
    x11_facts facts_;
    stage stage_ = stage::unwatched;
    bool is_due_ = false; ///< a question waits until the connection has room
    bool again_ = false;  ///< something changed while a question was under way
    std::array<xcb_intern_atom_cookie_t, name_count> names_{};
    std::array<xcb_atom_t, name_count> atoms_{};
    question question_{};
    Window check_ = 0;    ///< the window that shows that the manager lives
    Window settings_ = 0; ///< the window whose property has the settings; 0: there is none
};

} // namespace l3d_detail

#endif
