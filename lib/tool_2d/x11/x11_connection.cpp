// SPDX-License-Identifier: MIT
// x11_connection: opens and closes it, handles its errors, and sleeps until something comes.
#include "tool_2d/x11/x11_connection_p.h"

#include "tool_2d/x11/x11_diagnosis_p.h"

#include <algorithm>
#include <cassert>
#include <csetjmp>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <vector>

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <X11/Xlib-xcb.h>
#include <X11/Xlibint.h> // after all others, as it has macros with common names
#undef min
#undef max

namespace l3d_detail {
namespace {

/// Makes room in Xlib's buffer, whose contents nobody will read. The first request of Xlib after
/// one of XCB may find the server gone while Xlib makes room for the request. Extensions of libX11
/// 1.8 then write to a null pointer, as `a_server_may_die_between_two_libraries` shows.
/// Expects: Xlib has just called the handler of broken connections for this display.
void make_x11_room(Display* display) {
    display->bufptr = display->buffer;
    // Without the connection, Xlib sets its buffer's size to 0. The buffer has at least the size
    // BUFSIZE.
    if (display->bufmax == display->buffer)
        display->bufmax = display->buffer + BUFSIZE;
}

} // namespace

/// The state of the process-wide handlers. Xlib calls the handlers without any argument of ours.
struct x11_handlers {
    std::mutex mutex;
    std::vector<x11_connection*> connections;
    std::vector<Display*> lost;
    XErrorHandler previous_error = nullptr;
    XIOErrorHandler previous_io_error = nullptr;
    struct sigaction previous_pipe {};

    /// Remembers a lost display until the end of the program, as it is never closed.
    void keep_lost(Display* display) {
        const std::lock_guard lock(mutex);
        lost.push_back(display);
    }

    static bool is_default(const struct sigaction& action) {
        return (action.sa_flags & SA_SIGINFO) == 0 && action.sa_handler == SIG_DFL;
    }

    static x11_handlers& instance() {
        // Never destroyed, since lost displays must still be known when the program ends.
        static auto& handlers = *std::make_unique<x11_handlers>().release();
        return handlers;
    }

    void add(x11_connection& connection);
    void remove(x11_connection& connection);

    x11_connection* find(Display* display) {
        const std::lock_guard lock(mutex);
        const auto found = std::ranges::find(connections, display, &x11_connection::display_);
        return found == connections.end() ? nullptr : *found;
    }

    static int on_error(Display* display, XErrorEvent* error);
    static int on_io_error(Display* display);
    static void on_pipe(int) {} // a write fails instead; child processes do not inherit it
    static void on_io_exit(Display* display, void* connection) {
        static_cast<x11_connection*>(connection)->lost_ = true;
        make_x11_room(display); // for the request that met the broken connection
    }
};

namespace {

/// The place to jump to if the server dies in ask_safely(); else null.
thread_local std::jmp_buf* way_out = nullptr;

// The size to ask for the socket's buffer: 8 MiB, two pictures of 1024 x 768. The system gives what
// it allows; on Linux, that is 208 KiB unless the limit was changed. Pictures go in pieces of at
// most one request of the protocol (262 KB, without the extension for larger ones). Before each
// piece, the socket is asked whether there is room. So a large buffer does not make pieces larger.
// It takes many pieces before anybody waits: half of the size that the system gave, 2 MiB where it
// allows 4.
constexpr int wanted_buffer = 1 << 23;
// The size of a request beside its data: 24 bytes for a picture.
constexpr std::size_t own_size = 32;
// The bytes that every system's sockets hold.
constexpr std::size_t least_writable = std::size_t{1} << 13;

// The longest wait for a connection. Displays worth drawing on need less, and users have more
// patience.
constexpr std::chrono::seconds longest_connect{3};
// The longest wait for the server to close its end. A server that is well closes at once, and a
// stopped one is not waited for.
constexpr std::chrono::milliseconds longest_leave{200};

/// Calls functions of Xlib that cannot go on if the server dies meanwhile. If the server dies,
/// jumps out of these functions.
///
/// Without the jump, XOpenDisplay would end the process, as it has no display yet for an exit
/// handler. XQueryExtension would take the reply that never came for the number of an extension.
/// The jump leaks the memory that Xlib has taken so far, once. The test
/// `a_server_may_die_at_any_byte` fails without this function.
/// Expects: nothing in `ask` has a destructor.
/// Errors:  false if the server died.
template <class Ask> bool ask_safely(Ask ask) {
    std::jmp_buf here;
    if (setjmp(here) != 0) {
        way_out = nullptr;
        return false;
    }
    way_out = &here;
    ask();
    way_out = nullptr;
    return true;
}

Display* open_display(const char* name, bool& lost) {
    Display* display = nullptr;
    if (can_reach_x11_host(name, longest_connect))
        lost = !ask_safely([&] { display = XOpenDisplay(name); });
    return lost ? nullptr : display;
}

} // namespace

void x11_handlers::add(x11_connection& connection) {
    const std::lock_guard lock(mutex);
    if (connections.empty()) {
        previous_error = XSetErrorHandler(on_error);
        previous_io_error = XSetIOErrorHandler(on_io_error);
        sigaction(SIGPIPE, nullptr, &previous_pipe);
        if (is_default(previous_pipe)) {
            struct sigaction ours {};
            ours.sa_handler = on_pipe;
            sigaction(SIGPIPE, &ours, nullptr);
        }
    }
    connections.push_back(&connection);
}

void x11_handlers::remove(x11_connection& connection) {
    const std::lock_guard lock(mutex);
    std::erase(connections, &connection);
    if (!connections.empty())
        return;
    // If a library set its handler after ours, that handler stays.
    if (const auto current = XSetErrorHandler(previous_error); current != on_error)
        XSetErrorHandler(current);
    if (const auto current = XSetIOErrorHandler(previous_io_error); current != on_io_error)
        XSetIOErrorHandler(current);
    struct sigaction current {};
    sigaction(SIGPIPE, nullptr, &current);
    if (current.sa_handler == on_pipe)
        sigaction(SIGPIPE, &previous_pipe, nullptr);
}

int x11_handlers::on_error(Display* display, XErrorEvent* error) {
    auto& handlers = instance();
    auto* connection = handlers.find(display);
    if (connection == nullptr)
        return handlers.previous_error(display, error);
    if (connection->trap_serial_ == 0 || error->serial < connection->trap_serial_)
        connection->keep({error->serial, error->error_code});
    else if (connection->trapped_error_ == 0)
        connection->trapped_error_ = error->error_code;
    return 0;
}

int x11_handlers::on_io_error(Display* display) {
    auto& handlers = instance();
    auto* const connection = handlers.find(display);
    if (way_out == nullptr) // our displays come to on_io_exit next
        return connection != nullptr ? 0 : handlers.previous_io_error(display);
    if (connection != nullptr) {
        on_io_exit(display, connection);
    } else {
        close(ConnectionNumber(display));
        handlers.keep_lost(display);
    }
    std::longjmp(*way_out, 1);
}

std::unique_ptr<x11_connection> x11_connection::open(std::string& why) {
    const char* const name = std::getenv("DISPLAY");
    std::unique_ptr<x11_connection> connection;
    if (name != nullptr && *name != '\0')
        connection.reset(new x11_connection(name));
    if (connection && (connection->display_ != nullptr || connection->lost_))
        return connection;
    // The reason is looked for only after a failure. Some forwarded ports carry one connection
    // only, and some servers end with their last connection.
    why = x11_refusal_of(name, longest_connect).why;
    return nullptr;
}

x11_connection::x11_connection(const char* name) {
    x11_handlers::instance().add(*this);
    display_ = open_display(name, lost_);
    if (display_ == nullptr)
        return;
    XSetIOErrorExitHandler(display_, x11_handlers::on_io_exit, this);
    // The address is asked for early, as a broken connection has no other end.
    sockaddr_storage peer{};
    socklen_t size = sizeof peer;
    local_ =
        getpeername(ConnectionNumber(display_), reinterpret_cast<sockaddr*>(&peer), &size) != 0 ||
        peer.ss_family == AF_UNIX;
    widen();
}

/// Finds out how much fits into the socket. Widens the buffer of a local socket as far as the
/// system allows.
void x11_connection::widen() {
    const int server = ConnectionNumber(display_);
    if (local_)
        setsockopt(server, SOL_SOCKET, SO_SNDBUF, &wanted_buffer, sizeof wanted_buffer);
    int buffer = 0;
    socklen_t size = sizeof buffer;
    if (getsockopt(server, SOL_SOCKET, SO_SNDBUF, &buffer, &size) != 0)
        buffer = 0;
    // Linux calls a local socket writable when at most a quarter of its buffer is full. A fifth of
    // the other three quarters is left for the kernel's own records. Requests are counted in words
    // of four bytes. Xlib cuts requests larger than `largest`, and waits before each piece.
    const auto largest = 4 * static_cast<std::size_t>(XMaxRequestSize(display_)) - own_size;
    writable_size_ = std::clamp(static_cast<std::size_t>(buffer) / 5 * 3, least_writable, largest);
}

x11_connection::~x11_connection() {
    if (display_ == nullptr) {
        // There is no connection to end.
    } else if (lost_) {
        // Extensions of Xlib may be half set up, and would crash in XCloseDisplay.
        close(ConnectionNumber(display_));
        x11_handlers::instance().keep_lost(display_);
    } else {
        leave();
        XCloseDisplay(display_);
    }
    x11_handlers::instance().remove(*this);
}

/// Breaks the connection once the server has done all requests, or after longest_leave. The server
/// then frees our resources. XCloseDisplay would wait for a reply without end.
void x11_connection::leave() {
    const int server = ConnectionNumber(display_);
    const auto deadline = std::chrono::steady_clock::now() + longest_leave;
    if (wait_writable({}))
        XFlush(display_);
    shutdown(server, SHUT_WR);
    // The server closes its end once it has read everything.
    std::array<char, 4096> unread;
    while (wait_readable(deadline) && recv(server, unread.data(), unread.size(), MSG_DONTWAIT) > 0)
        ;
    // Xlib learns of the end by reading, as writing could raise SIGPIPE.
    shutdown(server, SHUT_RD);
    if (!lost_)
        XEventsQueued(display_, QueuedAfterReading);
}

bool x11_connection::has(extension_query query) const {
    Bool has = False;
    return ask_safely([&] { has = query(display_); }) && has != False;
}

void x11_connection::keep(const failure& error) {
    failures_[failure_count_++ % failures_.size()] = error;
}

int x11_connection::error_of(unsigned long serial) const {
    const auto found = std::ranges::find(failures_, serial, &failure::serial);
    return found == failures_.end() ? 0 : found->code;
}

bool has_x11_manager(const x11_connection& connection) {
    // XGetWindowAttributes would also ask for the geometry, and each request delays a slow
    // display's first picture.
    auto* const xcb = XGetXCBConnection(connection.display());
    const auto question =
        xcb_get_window_attributes(xcb, static_cast<xcb_window_t>(connection.root()));
    const unique_reply<xcb_get_window_attributes_reply_t> root(
        xcb_get_window_attributes_reply(xcb, question, nullptr));
    // This call tells Xlib of earlier errors and of the server's end.
    XEventsQueued(connection.display(), QueuedAfterReading);
    // A window manager is the client that redirects the root's children; only one client can.
    return root && (root->all_event_masks & XCB_EVENT_MASK_SUBSTRUCTURE_REDIRECT) != 0;
}

std::string x11_error_text(const x11_connection& connection, int code) {
    std::array<char, 128> text{};
    XGetErrorText(connection.display(), code, text.data(), static_cast<int>(text.size()));
    return text.data();
}

bool x11_connection::wait_readable(std::chrono::steady_clock::time_point deadline,
                                   int waker) const {
    return wait(POLLIN, deadline, waker);
}

bool x11_connection::wait_writable(std::chrono::steady_clock::time_point deadline) const {
    return wait(POLLOUT, deadline);
}

bool x11_connection::wait_ready(std::chrono::steady_clock::time_point deadline, int waker) const {
    return wait(POLLIN | POLLOUT, deadline, waker);
}

bool x11_connection::wait(short events, std::chrono::steady_clock::time_point deadline,
                          int waker) const {
    using namespace std::chrono;
    const auto left = std::max(deadline - steady_clock::now(), steady_clock::duration::zero());
    if (lost_)
        return false;
    const auto whole = duration_cast<seconds>(left);
    const timespec timeout{whole.count(), duration_cast<nanoseconds>(left - whole).count()};
    // poll ignores a file with the number -1.
    std::array files{pollfd{ConnectionNumber(display_), events, 0}, pollfd{waker, POLLIN, 0}};
    return ppoll(files.data(), files.size(), &timeout, nullptr) > 0 && files[0].revents != 0;
}

x11_error_trap::x11_error_trap(x11_connection& connection) : connection_(connection) {
    assert(connection.trap_serial_ == 0);
    connection.trap_serial_ = XNextRequest(connection.display_);
    connection.trapped_error_ = 0;
}

x11_error_trap::~x11_error_trap() {
    connection_.trap_serial_ = 0;
}

int x11_error_trap::sync() {
    XSync(connection_.display_, False);
    return connection_.trapped_error_;
}

} // namespace l3d_detail
