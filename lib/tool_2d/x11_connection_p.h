// SPDX-License-Identifier: MIT
// x11_connection: one connection to an X server, which may break without ending the program.
#ifndef L3D_TOOL_2D_X11_CONNECTION_P_H
#define L3D_TOOL_2D_X11_CONNECTION_P_H

#include <chrono>
#include <memory>
#include <string>

#include <X11/Xlib.h>

namespace l3d_detail {

/// Owns a Display.
///
/// Xlib's two error handlers belong to the whole process, and its own ones end it. While
/// connections of this class exist, ours stand in front: they keep what concerns these
/// connections and hand everything else to the handlers found there, which come back with the
/// end of the last connection.
class x11_connection {
public:
    /// Connects to the display that the environment names.
    /// Errors:  null, with one line in `why` that gives the value of DISPLAY.
    static std::unique_ptr<x11_connection> open(std::string& why);

    x11_connection(const x11_connection&) = delete;
    x11_connection& operator=(const x11_connection&) = delete;
    ~x11_connection();

    Display* display() const { return display_; }
    int screen() const { return DefaultScreen(display_); }
    Window root() const { return RootWindow(display_, screen()); }

    /// Whether the server is gone. From then on no call reaches it, and none may wait for it.
    bool lost() const { return lost_; }

    /// Sleeps until the server sent something.
    /// Expects: nothing was read since XPending last said 0; else there may be nothing to wait for.
    /// Errors:  false when the time is over or a signal came.
    bool wait_readable(std::chrono::steady_clock::time_point deadline) const;

private:
    friend class x11_error_trap;
    friend struct x11_handlers;

    explicit x11_connection(const char* name);

    Display* display_ = nullptr;
    bool lost_ = false;
    unsigned long trap_serial_ = 0; ///< first request whose errors are asked for; 0: none
    int trapped_error_ = 0;
};

/// Collects the X errors of the requests made while it lives.
///
/// Expects: at most one per connection at a time.
class x11_error_trap {
public:
    explicit x11_error_trap(x11_connection& connection);
    x11_error_trap(const x11_error_trap&) = delete;
    x11_error_trap& operator=(const x11_error_trap&) = delete;
    ~x11_error_trap();

    /// The error code of the first request that failed, 0 if all went well.
    /// Cost:    one round trip.
    int sync();

private:
    x11_connection& connection_;
};

} // namespace l3d_detail

#endif
