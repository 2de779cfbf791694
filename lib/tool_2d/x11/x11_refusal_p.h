// SPDX-License-Identifier: MIT
// x11_refusal: the reason why a display refuses us, and the remedy.
#ifndef L3D_TOOL_2D_X11_X11_REFUSAL_P_H
#define L3D_TOOL_2D_X11_X11_REFUSAL_P_H

#include <chrono>
#include <string>

namespace l3d_detail {

/// The reason for a refused connection.
struct x11_refusal {
    std::string why;         ///< one line that gives the value of DISPLAY
    std::string remedy;      ///< one line: what to do about it
    bool is_certain = false; ///< Xlib could not connect, either
};

/// Finds out why Xlib cannot open a display: knocks at it, and hears what the server says. Xlib
/// does not tell the reason; the library below it prints the server's words and forgets them.
///
/// Shape:   `display` is the value of DISPLAY; null: it is not set.
/// Cost:    a connection; no more than `longest` for each of its two steps.
/// Source:  X Window System Protocol, chapter 8 (connection setup).
x11_refusal x11_refusal_of(const char* display, std::chrono::milliseconds longest);

} // namespace l3d_detail

#endif
