// SPDX-License-Identifier: MIT
// A connection attempt that does not block.
#include "tool_2d/x11/x11_reach_p.h"

#include <charconv>
#include <memory>

#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
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

/// The addresses of "[protocol/]host:number[.screen]"; null if there is no such host.
address_list look_up(const std::string& display, std::size_t colon) {
    auto host = display.substr(0, colon);
    host.erase(0, host.rfind('/') + 1);
    if (host.starts_with('[') && host.ends_with(']'))
        host = host.substr(1, host.size() - 2);
    int number = 0;
    std::from_chars(display.data() + colon + 1, display.data() + display.size(), number);
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* list = nullptr;
    if (getaddrinfo(host.c_str(), std::to_string(first_port + number).c_str(), &hints, &list) != 0)
        return nullptr;
    return address_list(list);
}

bool is_local(const std::string& display, std::size_t colon) {
    return colon == std::string::npos || colon == 0 || display.starts_with('/') ||
           display.starts_with("unix:") || display.starts_with("unix/");
}

bool accepts(const addrinfo& address, steady_clock::time_point deadline) {
    const int file =
        socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (file < 0)
        return false;
    // Connected or refused, the socket becomes writable; only its error tells which.
    static_cast<void>(connect(file, address.ai_addr, address.ai_addrlen));
    const auto left = std::chrono::ceil<milliseconds>(deadline - steady_clock::now());
    pollfd answer{file, POLLOUT, 0};
    int error = 0;
    socklen_t size = sizeof error;
    const bool accepted = left.count() > 0 &&
                          poll(&answer, 1, static_cast<int>(left.count())) > 0 &&
                          getsockopt(file, SOL_SOCKET, SO_ERROR, &error, &size) == 0 && error == 0;
    close(file);
    return accepted;
}

} // namespace

bool can_reach_x11_host(const std::string& display, milliseconds longest) {
    const auto colon = display.rfind(':');
    if (is_local(display, colon))
        return true;
    const auto list = look_up(display, colon);
    const auto deadline = steady_clock::now() + longest;
    for (const auto* address = list.get(); address != nullptr; address = address->ai_next) {
        if (accepts(*address, deadline))
            return true;
    }
    return false;
}

} // namespace l3d_detail
