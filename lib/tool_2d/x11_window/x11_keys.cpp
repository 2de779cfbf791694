// SPDX-License-Identifier: MIT
// x11_keys: finds keys by keysyms, layouts of other scripts and places. x11_text: finds symbols,
// one by one or composed.
#include "tool_2d/x11_window/x11_keys_p.h"

#include "tool_2d/event.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <X11/XKBlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>
#include <xkbcommon/xkbcommon-compose.h>

namespace l3d_detail {
namespace {

constexpr std::array<std::pair<KeySym, int>, 34> named_keys{{
    {XK_BackSpace, l3d_key_backspace},
    {XK_Tab, l3d_key_tab},
    {XK_Return, l3d_key_return},
    {XK_KP_Enter, l3d_key_return},
    {XK_Escape, l3d_key_escape},
    {XK_Left, l3d_key_left},
    {XK_Right, l3d_key_right},
    {XK_Up, l3d_key_up},
    {XK_Down, l3d_key_down},
    {XK_Page_Up, l3d_key_page_up},
    {XK_Page_Down, l3d_key_page_down},
    {XK_Home, l3d_key_home},
    {XK_End, l3d_key_end},
    {XK_KP_Left, l3d_key_left},
    {XK_KP_Right, l3d_key_right},
    {XK_KP_Up, l3d_key_up},
    {XK_KP_Down, l3d_key_down},
    {XK_KP_Page_Up, l3d_key_page_up},
    {XK_KP_Page_Down, l3d_key_page_down},
    {XK_KP_Home, l3d_key_home},
    {XK_KP_End, l3d_key_end},
    {XK_ISO_Left_Tab, l3d_key_tab},
    {XK_Delete, l3d_key_delete},
    {XK_KP_Delete, l3d_key_delete},
    {XK_Insert, l3d_key_insert},
    {XK_KP_Insert, l3d_key_insert},
    {XK_Shift_L, l3d_key_shift},
    {XK_Shift_R, l3d_key_shift},
    {XK_Control_L, l3d_key_control},
    {XK_Control_R, l3d_key_control},
    {XK_Alt_L, l3d_key_alt},
    {XK_Alt_R, l3d_key_alt},
    {XK_Meta_L, l3d_key_alt}, // Alt with Shift held
    {XK_Meta_R, l3d_key_alt},
}};

/// The key of a keysym. 0 for a keysym that is none of our keys.
int key_of_keysym(KeySym keysym) {
    const auto* named = std::ranges::find(named_keys, keysym, &std::pair<KeySym, int>::first);
    if (named != named_keys.end())
        return named->second;
    if (keysym >= XK_F1 && keysym <= XK_F10)
        return l3d_key_f1 + static_cast<int>(keysym - XK_F1);
    // The keysyms of ASCII characters are their codes.
    return keysym >= ' ' && keysym <= '~' ? static_cast<int>(keysym) : 0;
}

/// The key at a place of an American keyboard, by key code: a letter, or a sign right of the
/// letters. PCs number their keys alike under every layout.
int key_in_place(unsigned code) {
    struct row {
        unsigned first_code;
        std::string_view keys;
    };
    constexpr std::array<row, 3> rows{
        {{24, "qwertyuiop[]"}, {38, "asdfghjkl;'`"}, {52, "zxcvbnm,./"}}};
    for (const auto& [first_code, keys] : rows)
        if (code >= first_code && code - first_code < keys.size())
            return static_cast<unsigned char>(keys[code - first_code]);
    return 0;
}

constexpr bool is_letter(int key) {
    return key >= 'a' && key <= 'z';
}

KeySym symbol_of(Display* display, unsigned code, unsigned group, int level) {
    return XkbKeycodeToKeysym(display, static_cast<KeyCode>(code), static_cast<int>(group), level);
}

/// Whether a group of the layout has at least half of the Latin letters. Layouts of other scripts
/// have no Latin letters, although some have signs of ASCII in their places.
bool is_latin(Display* display, unsigned group) {
    constexpr int half_of_alphabet = 13;
    int letters = 0;
    for (unsigned code = 8; code < 256; ++code) // X numbers keys from 8 to 255
        letters += is_letter(static_cast<int>(symbol_of(display, code, group, 0))) ? 1 : 0;
    return letters >= half_of_alphabet;
}

/// The Latin letter or sign of a key whose own group has another script. The letter comes from the
/// first group with Latin letters, or else from the key's place.
int latin_key(const XKeyEvent& event, unsigned own_group) {
    const int level = (event.state & ShiftMask) != 0 ? 1 : 0;
    for (unsigned group = 0; group < XkbNumKbdGroups; ++group) {
        if (group != own_group && is_latin(event.display, group))
            return key_of_keysym(symbol_of(event.display, event.keycode, group, level));
    }
    return key_in_place(event.keycode);
}

/// Whether a symbol begins a sequence of several keys.
bool begins_a_sequence(KeySym symbol) {
    return symbol == XK_Multi_key ||
           (symbol >= XK_dead_grave && symbol <= XK_dead_longsolidusoverlay);
}

/// The locale that chooses the user's table of sequences.
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

int key_of(XKeyEvent event) {
    event.state &= ~static_cast<unsigned>(LockMask);
    const unsigned group = XkbGroupForCoreState(event.state);
    if (!is_latin(event.display, group)) {
        const int key = latin_key(event, group);
        if (is_letter(key | ('a' ^ 'A')))
            return key;
    }
    std::array<char, 8> text{};
    KeySym keysym = NoSymbol;
    const int length = XLookupString(&event, text.data(), text.size(), &keysym, nullptr);
    if (const int key = key_of_keysym(keysym); key != 0)
        return key;
    // The digits and signs of the number pad have keysyms of their own, but their text is plain.
    if (length == 1 && text[0] >= ' ' && text[0] <= '~')
        return text[0];
    return latin_key(event, group);
}

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

/// Opens the table of sequences, which is a file of Xlib's. Without this table, dead keys type
/// nothing.
void x11_text::open() {
    if (is_open_)
        return;
    is_open_ = true;
    context_.reset(xkb_context_new(XKB_CONTEXT_NO_DEFAULT_INCLUDES));
    if (!context_)
        return;
    // The library's messages are for people who write such files.
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
        std::array<char, 256> bytes{}; // the longest text that xkbcommon gives
        xkb_compose_state_get_utf8(state_.get(), bytes.data(), bytes.size());
        return bytes.data();
    }
    default:
        return {}; // the sequence goes on, or it was broken off
    }
}

} // namespace l3d_detail
