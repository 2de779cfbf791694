// SPDX-License-Identifier: MIT
// Whether there is a display: for remote ones with a limit of time, which Xlib does not have.
#include "system/display_x11.h"

#include <X11/Xlib.h>

#include <cstdlib>
#include <memory>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace {

/// Units: milliseconds. A network that takes longer for one answer is of no use for pictures; the
/// kernel alone would try for two minutes.
constexpr int longest_answer = 2000;

/// The X protocol's port of display 0.
constexpr int first_port = 6000;

struct tcp_name {
    std::string host, port;
};

/// The machine of "host:1.0", "tcp/host:1" or "[::1]:1"; no host if the display is local, or the
/// name is one that only Xlib can judge.
tcp_name remote_part(std::string display) {
    const std::size_t colon = display.rfind(':');
    const std::size_t slash = display.rfind('/');
    if (colon == std::string::npos || slash == 0)
        return {};
    const int number = std::atoi(display.c_str() + colon + 1);
    const std::size_t start = slash == std::string::npos ? 0 : slash + 1;
    std::string host = start < colon ? display.substr(start, colon - start) : "";
    if (host.size() > 1 && host.front() == '[' && host.back() == ']')
        host = host.substr(1, host.size() - 2);
    if (host == "unix" || display.rfind("unix/", 0) == 0 || display.rfind("local/", 0) == 0 ||
        number < 0 || number > 65535 - first_port)
        return {};
    return {host, std::to_string(first_port + number)};
}

bool connects(const addrinfo& address) {
    const int handle = socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC,
                              address.ai_protocol);
    if (handle == -1)
        return false;
    connect(handle, address.ai_addr, address.ai_addrlen);
    pollfd wait{handle, POLLOUT, 0};
    int error = -1;
    socklen_t size = sizeof error;
    const bool answered = poll(&wait, 1, longest_answer) == 1 &&
                          getsockopt(handle, SOL_SOCKET, SO_ERROR, &error, &size) == 0 &&
                          error == 0;
    close(handle);
    return answered;
}

/// Whether an address of the machine takes connections; true if there is no machine to ask.
bool answers(const tcp_name& name) {
    if (name.host.empty())
        return true;
    addrinfo wanted{};
    wanted.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (getaddrinfo(name.host.c_str(), name.port.c_str(), &wanted, &found) != 0)
        return false;
    const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owner(found, freeaddrinfo);
    for (const addrinfo* each = found; each; each = each->ai_next)
        if (connects(*each))
            return true;
    return false;
}

} // namespace

std::string l3d_display_problem() {
    const char* const name = std::getenv("DISPLAY");
    if (!name || !*name)
        return "DISPLAY is not set";
    if (answers(remote_part(name)))
        if (Display* const display = XOpenDisplay(nullptr)) {
            XCloseDisplay(display);
            return {};
        }
    return "cannot open the display that DISPLAY names, '" + std::string(name) + "'";
}
