// SPDX-License-Identifier: MIT
// x11_connection: one connection to an X server, which may break without ending the program.
#ifndef L3D_TOOL_2D_X11_X11_CONNECTION_P_H
#define L3D_TOOL_2D_X11_X11_CONNECTION_P_H

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>

#include <X11/Xlib.h>

namespace l3d_detail {

/// The reason given if the connection to the X server breaks while a screen is set up.
inline constexpr auto x11_server_went_away = "the X server went away";

/// Frees a reply that xcb read; replies come from malloc.
struct x11_reply_freer {
    void operator()(void* reply) const { std::free(reply); }
};
template <class Reply> using unique_reply = std::unique_ptr<Reply, x11_reply_freer>;

/// The way in which the server gets our memory.
enum class x11_sharing {
    unproven, ///< no way is proven yet
    files,    ///< the server gets memory as files that are handed over
    segments, ///< the server gets memory as segments of System V
};

/// Owns a Display.
///
/// Xlib's two error handlers belong to the whole process, and the default handlers end the process.
/// While connections of this class exist, our handlers stand in front. Our handlers keep errors of
/// these connections and hand all other errors to the previous handlers, which come back when the
/// last connection ends. The same holds for SIGPIPE, which Xlib raises by writing to a dead server,
/// unless the program handles or ignores it.
class x11_connection {
public:
    /// Connects to the display that the environment names.
    /// Errors:  null, with one line in `why` that gives the value of DISPLAY. If the server went
    ///          away while it answered, a connection that is lost(), without a display().
    static std::unique_ptr<x11_connection> open(std::string& why);

    x11_connection(const x11_connection&) = delete;
    x11_connection& operator=(const x11_connection&) = delete;
    ~x11_connection();

    Display* display() const { return display_; }
    int screen() const { return DefaultScreen(display_); }
    Window root() const { return RootWindow(display_, screen()); }

    /// The display's name, as in DISPLAY.
    std::string name() const { return DisplayString(display_); }

    /// Whether the server is reached without a network, so that it can share memory with us.
    bool is_local() const { return local_; }

    using extension_query = Bool (*)(Display* display);
    /// Whether the server has an extension. `query` is the function of the extension's library that
    /// asks the server for this extension. False if the server goes away meanwhile.
    /// Cost:    one round trip, the first time.
    bool has(extension_query query) const;

    /// The way that was proven to give the server our memory, and not a stranger's.
    x11_sharing sharing() const { return sharing_; }
    void set_sharing(x11_sharing sharing) { sharing_ = sharing; }

    /// Whether the server is gone. From then on no call reaches the server, and none may wait for
    /// it.
    bool lost() const { return lost_; }

    /// Sleeps until the server has sent something.
    /// Expects: nothing was read since XPending last returned 0; otherwise there may be nothing to
    ///          wait for.
    /// Errors:  false when the time is over, a signal came, or the file `waker` can be read; -1
    ///          stands for no file.
    bool wait_readable(std::chrono::steady_clock::time_point deadline, int waker = -1) const;

    /// Sleeps until a request with writable_size() bytes of data can be sent without blocking.
    /// Errors:  false when the time is over or a signal came.
    bool wait_writable(std::chrono::steady_clock::time_point deadline) const;

    /// Sleeps until the connection is readable or writable. Expects, Errors: as wait_readable.
    bool wait_ready(std::chrono::steady_clock::time_point deadline, int waker = -1) const;

    std::size_t writable_size() const { return writable_size_; }

    /// The error code of a request made outside any trap; 0 if none was reported. Only the last few
    /// errors are remembered, so ask soon.
    int error_of(unsigned long serial) const;

private:
    friend class x11_error_trap;
    friend struct x11_handlers;

    /// A request that the server refused.
    struct failure {
        unsigned long serial = 0;
        int code = 0;
    };

    explicit x11_connection(const char* name);
    void widen();
    void keep(const failure& error);
    bool wait(short events, std::chrono::steady_clock::time_point deadline, int waker = -1) const;
    void leave();

    Display* display_ = nullptr;
    bool local_ = false;
    std::size_t writable_size_ = 0;
    bool lost_ = false;
    x11_sharing sharing_ = x11_sharing::unproven;
    unsigned long trap_serial_ = 0; ///< first request whose errors are asked for; 0: none
    int trapped_error_ = 0;
    // Two pictures may be under way; the rest is room for errors that nobody asks about.
    std::array<failure, 16> failures_{};
    std::size_t failure_count_ = 0; ///< the number of all failures; the array is a ring
};

/// Whether a window manager looks after the windows of this display. After the call, the errors of
/// all earlier requests are known.
/// Errors:  false if the server goes away meanwhile.
/// Cost:    one round trip.
bool has_x11_manager(const x11_connection& connection);

/// The meaning of the error code, in words. No request is made.
std::string x11_error_text(const x11_connection& connection, int code);

/// Collects the X errors of the requests made while an object of this class lives.
///
/// Expects: at most one object per connection at a time.
class x11_error_trap {
public:
    explicit x11_error_trap(x11_connection& connection);
    x11_error_trap(const x11_error_trap&) = delete;
    x11_error_trap& operator=(const x11_error_trap&) = delete;
    ~x11_error_trap();

    /// The error code of the first request that failed, 0 if all went well.
    /// Cost:    one round trip.
    int sync();

    /// As sync(), but without a round trip. The result covers only requests before the last one
    /// that waited for a reply.
    int error() const { return connection_.trapped_error_; }

private:
    x11_connection& connection_;
};

} // namespace l3d_detail

#endif
