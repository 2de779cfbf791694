// SPDX-License-Identifier: MIT
// A connection attempt that does not block.
#include "tool_2d/x11/x11_reach_p.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <memory>
#include <system_error>

#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace l3d_detail {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

// Display 0 of a host listens here, display n at n more.
constexpr int first_port = 6000;

struct address_freer {
    void operator()(addrinfo* list) const { freeaddrinfo(list); }
};
using address_list = std::unique_ptr<addrinfo, address_freer>;

/// The display's number behind the colon, without the screen; -1 if there is none.
int number_of(const std::string& display, std::size_t colon) {
    int number = -1;
    if (colon != std::string::npos)
        std::from_chars(display.data() + colon + 1, display.data() + display.size(), number);
    return number;
}

/// The host's name in "[protocol/]host:number[.screen]".
std::string host_of(const std::string& display, std::size_t colon) {
    auto host = display.substr(0, colon);
    host.erase(0, host.rfind('/') + 1);
    if (host.starts_with('[') && host.ends_with(']'))
        host = host.substr(1, host.size() - 2);
    return host;
}

bool is_local(const std::string& display) {
    const auto colon = display.rfind(':');
    return colon == std::string::npos || colon == 0 || display.starts_with('/') ||
           display.starts_with("unix:") || display.starts_with("unix/");
}

/// Errors:  none, with the kernel's number in `error`.
x11_socket connected(const sockaddr* address, socklen_t size, steady_clock::time_point deadline,
                     int& error) {
    x11_socket knocker(socket(address->sa_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    error = 0;
    if (!knocker || (connect(knocker.file(), address, size) != 0 && errno != EINPROGRESS)) {
        error = errno;
        return {};
    }
    // Connected or refused, the socket becomes writable; only its error tells which.
    const auto left = std::chrono::ceil<milliseconds>(deadline - steady_clock::now());
    pollfd answer{knocker.file(), POLLOUT, 0};
    socklen_t error_size = sizeof error;
    if (left.count() <= 0 || poll(&answer, 1, static_cast<int>(left.count())) <= 0)
        error = ETIMEDOUT;
    else
        getsockopt(knocker.file(), SOL_SOCKET, SO_ERROR, &error, &error_size);
    return error == 0 ? std::move(knocker) : x11_socket();
}

/// Connects by the abstract name that Linux keeps outside of any folder, else by the file.
x11_socket connected_here(const std::string& path, steady_clock::time_point deadline) {
    int error = 0;
    for (const std::size_t hidden : {std::size_t{1}, std::size_t{0}}) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        if (path.size() + hidden >= sizeof address.sun_path)
            return {};
        std::ranges::copy(path, address.sun_path + hidden);
        const auto size = offsetof(sockaddr_un, sun_path) + hidden + path.size();
        if (auto found = connected(reinterpret_cast<const sockaddr*>(&address),
                                   static_cast<socklen_t>(size), deadline, error))
            return found;
    }
    return {};
}

x11_socket connected_there(const std::string& host, int port, steady_clock::time_point deadline,
                           std::string& why) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) {
        why = "no host of the name '" + host + "' is known";
        return {};
    }
    const address_list list(found);
    int error = ETIMEDOUT;
    for (const auto* at = list.get(); at != nullptr; at = at->ai_next) {
        if (auto reached = connected(at->ai_addr, at->ai_addrlen, deadline, error))
            return reached;
    }
    const std::string place = "'" + host + "', port " + std::to_string(port);
    if (error == ETIMEDOUT)
        why = place + " does not answer";
    else if (error == ECONNREFUSED)
        why = "no X server listens at " + place;
    else
        why = place + " cannot be reached: " + std::generic_category().message(error);
    return {};
}

} // namespace

x11_socket::~x11_socket() {
    if (file_ >= 0)
        close(file_);
}

x11_socket connect_to_x11(const std::string& display, milliseconds longest, std::string& why) {
    const auto deadline = steady_clock::now() + longest;
    const auto colon = display.rfind(':');
    const int number = number_of(display, colon);
    const bool is_path = display.starts_with('/');
    if (number < 0 && !is_path) {
        why = "a display's name has a colon and a number, as in ':0'";
        return {};
    }
    if (!is_local(display))
        return connected_there(host_of(display, colon), first_port + number, deadline, why);
    const std::string path = is_path ? display : "/tmp/.X11-unix/X" + std::to_string(number);
    auto reached = connected_here(path, deadline);
    if (!reached)
        why = "no X server listens at " + path;
    return reached;
}

bool can_reach_x11_host(const std::string& display, milliseconds longest) {
    std::string why;
    return is_local(display) || connect_to_x11(display, longest, why);
}

} // namespace l3d_detail
