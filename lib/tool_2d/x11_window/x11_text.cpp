// SPDX-License-Identifier: MIT
// x11_text: symbols of keys, one by one or composed.
#include "tool_2d/x11_window/x11_text_p.h"

#include <array>
#include <cstdlib>

#include <X11/Xutil.h>
#include <X11/keysym.h>
#include <xkbcommon/xkbcommon-compose.h>

namespace l3d_detail {
namespace {

/// Whether a symbol waits for another key.
bool begins_a_sequence(KeySym symbol) {
    return symbol == XK_Multi_key ||
           (symbol >= XK_dead_grave && symbol <= XK_dead_longsolidusoverlay);
}

/// The locale whose table of sequences the user has.
const char* locale_of_user() {
    for (const char* const variable : {"LC_ALL", "LC_CTYPE", "LANG"})
        if (const char* const value = std::getenv(variable); value != nullptr && *value != 0)
            return value;
    return "C";
}

bool is_control(const std::string& text) {
    const auto first = static_cast<unsigned char>(text.front());
    return first < ' ' || first == 127;
}

std::string text_of(xkb_keysym_t symbol) {
    std::array<char, 8> bytes{}; // UTF-8 has at most four, and a zero ends them
    const int size = xkb_keysym_to_utf8(symbol, bytes.data(), bytes.size());
    const std::string text = size > 0 ? bytes.data() : "";
    return text.empty() || is_control(text) ? "" : text;
}

} // namespace

x11_text::x11_text() = default;
x11_text::~x11_text() = default;

void x11_text::freer::operator()(xkb_context* context) const {
    xkb_context_unref(context);
}

void x11_text::freer::operator()(xkb_compose_table* table) const {
    xkb_compose_table_unref(table);
}

void x11_text::freer::operator()(xkb_compose_state* state) const {
    xkb_compose_state_unref(state);
}

/// Without a table, which is a file of Xlib's, dead keys type nothing.
void x11_text::open() {
    if (is_open_)
        return;
    is_open_ = true;
    context_.reset(xkb_context_new(XKB_CONTEXT_NO_DEFAULT_INCLUDES));
    if (!context_)
        return;
    // The library's own messages are for people who write such files.
    xkb_context_set_log_level(context_.get(), XKB_LOG_LEVEL_CRITICAL);
    table_.reset(xkb_compose_table_new_from_locale(context_.get(), locale_of_user(),
                                                   XKB_COMPOSE_COMPILE_NO_FLAGS));
    if (table_)
        state_.reset(xkb_compose_state_new(table_.get(), XKB_COMPOSE_STATE_NO_FLAGS));
}

std::string x11_text::typed(XKeyEvent press) {
    if ((press.state & (ControlMask | Mod1Mask | Mod4Mask)) != 0)
        return {};
    KeySym found = NoSymbol;
    XLookupString(&press, nullptr, 0, &found, nullptr);
    const auto symbol = static_cast<xkb_keysym_t>(found);
    if (begins_a_sequence(found))
        open();
    if (!state_)
        return text_of(symbol);
    xkb_compose_state_feed(state_.get(), symbol); // keys that are no character change nothing
    switch (xkb_compose_state_get_status(state_.get())) {
    case XKB_COMPOSE_NOTHING:
        return text_of(symbol);
    case XKB_COMPOSE_COMPOSED: {
        std::array<char, 256> bytes{}; // the longest that it gives
        xkb_compose_state_get_utf8(state_.get(), bytes.data(), bytes.size());
        return bytes.data();
    }
    default:
        return {}; // the sequence goes on, or was broken off
    }
}

} // namespace l3d_detail
