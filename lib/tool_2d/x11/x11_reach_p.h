// SPDX-License-Identifier: MIT
// Whether the host of a display answers, asked in bounded time.
#ifndef L3D_TOOL_2D_X11_X11_REACH_P_H
#define L3D_TOOL_2D_X11_X11_REACH_P_H

#include <chrono>
#include <string>

namespace l3d_detail {

/// False if DISPLAY names another host ("host:7", "[::1]:7.0") and nobody there takes a TCP
/// connection in time. Xlib itself would wait as long as the kernel does, two minutes.
///
/// A name without a host is true: what listens on this machine answers or refuses at once.
/// Cost:    besides `longest`, the time that looking up the host's name takes.
bool can_reach_x11_host(const std::string& display, std::chrono::milliseconds longest);

} // namespace l3d_detail

#endif
