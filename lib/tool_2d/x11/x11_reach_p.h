// SPDX-License-Identifier: MIT
// x11_reach: tries a connection to a display before Xlib makes one, and tells why it fails.
#ifndef L3D_TOOL_2D_X11_X11_REACH_P_H
#define L3D_TOOL_2D_X11_X11_REACH_P_H

#include <chrono>
#include <string>
#include <utility>

namespace l3d_detail {

/// Owns a socket, if it has one.
class x11_socket {
public:
    x11_socket() = default;
    explicit x11_socket(int file) : file_(file) {}
    x11_socket(x11_socket&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
    x11_socket& operator=(x11_socket&& other) noexcept {
        std::swap(file_, other.file_);
        return *this;
    }
    ~x11_socket();

    explicit operator bool() const { return file_ >= 0; }
    int file() const { return file_; }

private:
    int file_ = -1;
};

/// Knocks at the address of a display.
/// Shape:   `display` as in DISPLAY.
/// Errors:  none, with a phrase in `why`, if nobody answers in time.
x11_socket connect_to_x11(const std::string& display, std::chrono::milliseconds longest,
                          std::string& why);

/// False if DISPLAY names another host ("host:7", "[::1]:7.0") and nobody there takes a TCP
/// connection in time. Xlib itself would wait as long as the kernel does, two minutes.
///
/// A name without a host is true: what listens on this machine answers or refuses at once.
/// Cost:    besides `longest`, the time that looking up the host's name takes.
bool can_reach_x11_host(const std::string& display, std::chrono::milliseconds longest);

} // namespace l3d_detail

#endif
