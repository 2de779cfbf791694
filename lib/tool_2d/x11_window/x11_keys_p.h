// SPDX-License-Identifier: MIT
// x11_keys: finds the key that an event means, whatever the layout, and the text it types.
#ifndef L3D_TOOL_2D_X11_WINDOW_X11_KEYS_P_H
#define L3D_TOOL_2D_X11_WINDOW_X11_KEYS_P_H

#include <memory>
#include <string>

#include <X11/Xlib.h>

struct xkb_context;
struct xkb_compose_table;
struct xkb_compose_state;

namespace l3d_detail {

/// The key of an event: ASCII or an l3d_key; 0 for other keys. The key follows the keyboard
/// layout's group and shift level in use, without regard to Caps Lock. On a Greek or Cyrillic
/// layout, a key at the place of a Latin letter gives that letter, whatever it types.
int key_of(XKeyEvent event);

/// Turns presses of keys into text, dead keys and the key Compose included.
///
/// Xlib would need an input method, which it asks and waits for, and the locale of the whole
/// process. This class needs neither. The rules by which keys are composed are read at the first
/// dead key.
class x11_text {
public:
    x11_text();
    ~x11_text();

    /// The text that this press types, in UTF-8; empty for none. Keys with Ctrl, Alt or Super type
    /// nothing.
    std::string typed(XKeyEvent press);

private:
    struct freer {
        void operator()(xkb_context* context) const;
        void operator()(xkb_compose_table* table) const;
        void operator()(xkb_compose_state* state) const;
    };

    void open();

    std::unique_ptr<xkb_context, freer> context_;
    std::unique_ptr<xkb_compose_table, freer> table_;
    /// The sequence that is being typed; null without a table.
    std::unique_ptr<xkb_compose_state, freer> state_;
    bool is_open_ = false; ///< whether opening the table was tried
};

} // namespace l3d_detail

#endif
