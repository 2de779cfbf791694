// SPDX-License-Identifier: MIT
// Displays of other hosts: that one that never answers does not hold us up.
#include "tool_2d/x11/x11_diagnosis_p.h"

#include <gtest/gtest.h>

#include <vector>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace {

using namespace std::chrono_literals;
using l3d_detail::can_reach_x11_host;

/// A host's display: a TCP socket in the range of X ports that nobody else listens on.
class tcp_display {
public:
    explicit tcp_display(int waiting_room) {
        for (number_ = 700; number_ < 900 && !bind_to(6000 + number_); ++number_) {
        }
        listen(listener_, waiting_room);
    }
    tcp_display(const tcp_display&) = delete;
    tcp_display& operator=(const tcp_display&) = delete;
    ~tcp_display() {
        for (const int file : files_)
            close(file);
        close(listener_);
    }

    int number() const { return number_; }

    /// Takes all places, so that the kernel leaves the next without an answer.
    void fill() {
        for (int i = 0; i < 8; ++i) {
            files_.push_back(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0));
            // Nobody accepts, so most do not get through; that is the purpose.
            static_cast<void>(connect(files_.back(), reinterpret_cast<const sockaddr*>(&address_),
                                      sizeof address_));
        }
    }

private:
    bool bind_to(int port) {
        address_.sin_family = AF_INET;
        address_.sin_port = htons(static_cast<std::uint16_t>(port));
        address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        return bind(listener_, reinterpret_cast<const sockaddr*>(&address_), sizeof address_) == 0;
    }

    int listener_ = socket(AF_INET, SOCK_STREAM, 0);
    int number_ = 0;
    sockaddr_in address_{};
    std::vector<int> files_;
};

TEST(x11_reach, a_name_without_a_host_is_left_to_xlib) {
    for (const char* name :
         {":7", ":7.1", "unix:7", "unix/host:7", "/tmp/socket:7", "nonsense", ""})
        EXPECT_TRUE(can_reach_x11_host(name, 0ms)) << name;
}

TEST(x11_reach, a_host_that_listens) {
    const tcp_display display(16);
    const auto number = std::to_string(display.number());
    for (const std::string name : {"127.0.0.1:", "tcp/127.0.0.1:", "[127.0.0.1]:"}) {
        EXPECT_TRUE(can_reach_x11_host(name + number, 10s)) << name;
        EXPECT_TRUE(can_reach_x11_host(name + number + ".2", 10s)) << name;
    }
}

TEST(x11_reach, a_host_that_refuses) {
    std::string name;
    {
        const tcp_display display(4);
        name = "127.0.0.1:" + std::to_string(display.number());
    }
    EXPECT_FALSE(can_reach_x11_host(name, 10s));
}

TEST(x11_reach, a_host_that_never_answers) {
    tcp_display display(0);
    display.fill();
    // The test would take minutes if this waited for the kernel.
    EXPECT_FALSE(can_reach_x11_host("127.0.0.1:" + std::to_string(display.number()), 100ms));
}

} // namespace
