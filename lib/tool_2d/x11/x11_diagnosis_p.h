// SPDX-License-Identifier: MIT
// The reason why a display refuses a program, and the lines of --diagnose about it.
#ifndef L3D_TOOL_2D_X11_X11_DIAGNOSIS_P_H
#define L3D_TOOL_2D_X11_X11_DIAGNOSIS_P_H

#include "tool_2d/screen.h"

#include <chrono>
#include <string>

namespace l3d_detail {

/// Whether the host that DISPLAY names ("host:7", "[::1]:7.0") takes a TCP connection within
/// `longest`. Xlib itself would wait as long as the kernel does, two minutes.
///
/// The result is true for a name without a host, since this machine answers or refuses at once.
/// Cost:    besides `longest`, the time that looking up the host's name takes.
bool can_reach_x11_host(const std::string& display, std::chrono::milliseconds longest);

/// The reason for a refused connection.
struct x11_refusal {
    std::string why;         ///< one line that gives the value of DISPLAY
    std::string remedy;      ///< one line: what to do about it
    bool is_certain = false; ///< whether Xlib surely cannot connect, either
};

/// Finds out why Xlib cannot open a display: connects to it, and hears the server's words. Xlib
/// does not tell the reason; the library below it prints the server's words and forgets them.
///
/// Shape:   `display` is the value of DISPLAY; null: it is not set.
/// Cost:    a connection; no more than `longest` for each of its two steps.
/// Source:  X Window System Protocol, chapter 8 (connection setup).
x11_refusal x11_refusal_of(const char* display, std::chrono::milliseconds longest);

/// Adds probes of the display, its visual and its window manager, unless `probes` has them already.
/// If `with_shared_memory` is set, also adds a probe of memory that the display's server shares.
void diagnose_x11(l3d_probes& probes, bool with_shared_memory);

} // namespace l3d_detail

#endif
