// SPDX-License-Identifier: MIT
// cut_wire: an X display that is another one until so many bytes were sent to it.
#ifndef L3D_TEST_TOOL_2D_CUT_WIRE_H
#define L3D_TEST_TOOL_2D_CUT_WIRE_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <thread>

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

/// Passes one connection on to a real display, and cuts it after a number of bytes from the client.
class cut_wire {
public:
    /// Shape:   real_display as DISPLAY names it, ":7".
    cut_wire(const std::string& real_display, std::size_t bytes) : left_(bytes) {
        const auto real = address("/tmp/.X11-unix/X" + real_display.substr(1));
        const auto own = address(path());
        unlink(path().c_str());
        ready_ = bind(listener_, reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0 &&
                 listen(listener_, 1) == 0 &&
                 connect(server_, reinterpret_cast<const sockaddr*>(&real), sizeof real) == 0;
        carrier_ = std::thread([this] { carry(); });
    }
    cut_wire(const cut_wire&) = delete;
    cut_wire& operator=(const cut_wire&) = delete;
    ~cut_wire() {
        // Wakes the carrier wherever it is.
        shutdown(listener_, SHUT_RDWR);
        shutdown(server_, SHUT_RDWR);
        carrier_.join();
        for (const int file : {listener_, server_})
            close(file);
        unlink(path().c_str());
    }

    bool ready() const { return ready_; }
    std::string display() const { return ":" + number_; }

private:
    std::string path() const { return "/tmp/.X11-unix/X" + number_; }

    static sockaddr_un address(const std::string& path) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        path.copy(address.sun_path, sizeof address.sun_path - 1);
        return address;
    }

    void carry() {
        const int client = accept(listener_, nullptr, nullptr);
        if (client < 0)
            return;
        while (left_ > 0) {
            std::array<pollfd, 2> ends{{{client, POLLIN, 0}, {server_, POLLIN, 0}}};
            poll(ends.data(), ends.size(), -1);
            std::size_t unlimited = buffer_.size();
            if (ends[1].revents != 0 && !pass(server_, client, unlimited))
                break;
            if (ends[0].revents != 0 && !pass(client, server_, left_))
                break;
        }
        close(client);
    }

    /// Passes on what there is, but not more than `left`, which it reduces. False at the end.
    bool pass(int from, int to, std::size_t& left) {
        const auto count = recv(from, buffer_.data(), std::min(left, buffer_.size()), 0);
        if (count <= 0)
            return false;
        left -= static_cast<std::size_t>(count);
        return send(to, buffer_.data(), static_cast<std::size_t>(count), MSG_NOSIGNAL) == count;
    }

    // Beyond those of real servers, and not another test's.
    std::string number_ = std::to_string(100000 + getpid());
    int listener_ = socket(AF_UNIX, SOCK_STREAM, 0);
    int server_ = socket(AF_UNIX, SOCK_STREAM, 0);
    bool ready_ = false;
    std::size_t left_;
    std::array<char, 65536> buffer_{};
    std::thread carrier_;
};

#endif
