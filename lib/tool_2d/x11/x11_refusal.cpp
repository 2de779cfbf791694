// SPDX-License-Identifier: MIT
// x11_refusal: connects without blocking, greets the server, and explains its answer.
#include "tool_2d/x11/x11_diagnosis_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

// X.h comes first, as the header of cookies uses its families of addresses.
#include <X11/X.h>

#include <X11/Xauth.h>

namespace l3d_detail {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// Owns a socket, or none.
class x11_socket {
public:
    x11_socket() = default;
    explicit x11_socket(int file) : file_(file) {}
    x11_socket(x11_socket&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
    x11_socket& operator=(x11_socket&& other) noexcept {
        std::swap(file_, other.file_);
        return *this;
    }
    ~x11_socket() {
        if (file_ >= 0)
            close(file_);
    }

    explicit operator bool() const { return file_ >= 0; }
    int file() const { return file_; }

private:
    int file_ = -1;
};

// The port of a host's display 0. Display n listens n ports higher.
constexpr int first_port = 6000;

struct address_freer {
    void operator()(addrinfo* list) const { freeaddrinfo(list); }
};
using address_list = std::unique_ptr<addrinfo, address_freer>;

/// The display's number after the colon, without the screen. -1 if there is no number.
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

/// Connects to an address.
/// Errors:  no socket, with the kernel's error number in `error`.
x11_socket connected(const sockaddr* address, socklen_t size, steady_clock::time_point deadline,
                     int& error) {
    x11_socket knocker(socket(address->sa_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    error = 0;
    if (!knocker || (connect(knocker.file(), address, size) != 0 && errno != EINPROGRESS)) {
        error = errno;
        return {};
    }
    // The socket becomes writable when it is connected, and when it is refused. Only its error
    // tells which.
    const auto left = std::chrono::ceil<milliseconds>(deadline - steady_clock::now());
    pollfd answer{knocker.file(), POLLOUT, 0};
    socklen_t error_size = sizeof error;
    if (left.count() <= 0 || poll(&answer, 1, static_cast<int>(left.count())) <= 0)
        error = ETIMEDOUT;
    else
        getsockopt(knocker.file(), SOL_SOCKET, SO_ERROR, &error, &error_size);
    return error == 0 ? std::move(knocker) : x11_socket();
}

/// Connects by the abstract name that Linux keeps outside of any folder, or else by the file.
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

/// Connects to a display.
/// Shape:   `display` has the form of the variable DISPLAY.
/// Errors:  no socket, with a phrase in `why`, if nobody answers in time.
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

constexpr std::string_view cookie_name = "MIT-MAGIC-COOKIE-1";
const std::string without_display = "do without: --backend memory --output picture.png";

struct cookie_freer {
    void operator()(Xauth* cookie) const { XauDisposeAuth(cookie); }
};
using unique_cookie = std::unique_ptr<Xauth, cookie_freer>;

/// The address by which the file of cookies knows the other end of a socket. Servers on this
/// machine are looked up by its name, as Xlib does.
struct peer {
    unsigned short family = FamilyLocal;
    std::vector<char> address;

    explicit peer(int file) {
        sockaddr_storage storage{};
        socklen_t size = sizeof storage;
        getpeername(file, reinterpret_cast<sockaddr*>(&storage), &size);
        if (storage.ss_family == AF_INET)
            take_internet(reinterpret_cast<const sockaddr_in&>(storage).sin_addr);
        else if (storage.ss_family == AF_INET6)
            take_internet6(reinterpret_cast<const sockaddr_in6&>(storage).sin6_addr);
        if (family == FamilyLocal)
            take_name();
    }

private:
    void take_internet(const in_addr& found) {
        if (ntohl(found.s_addr) != INADDR_LOOPBACK)
            take(FamilyInternet, std::as_bytes(std::span(&found, 1)));
    }
    void take_internet6(const in6_addr& found) {
        if (!IN6_IS_ADDR_LOOPBACK(&found))
            take(FamilyInternet6, std::as_bytes(std::span(&found, 1)));
    }
    void take(unsigned short kind, std::span<const std::byte> bytes) {
        family = kind;
        const auto* const first = reinterpret_cast<const char*>(bytes.data());
        address.assign(first, first + bytes.size());
    }
    void take_name() {
        std::array<char, 256> name{}; // POSIX: a host's name has at most 255 bytes.
        gethostname(name.data(), name.size() - 1);
        address.assign(name.data(), name.data() + std::strlen(name.data()));
    }
};

/// The user's cookie for this display; null if there is none.
unique_cookie cookie_for(int file, const std::string& display) {
    const peer other(file);
    const auto colon = display.rfind(':') + 1;
    const std::string number = display.substr(colon, display.find('.', colon) - colon);
    std::array kinds{const_cast<char*>(cookie_name.data())};
    const std::array lengths{static_cast<int>(cookie_name.size())};
    return unique_cookie(
        XauGetBestAuthByAddr(other.family, static_cast<unsigned short>(other.address.size()),
                             other.address.data(), static_cast<unsigned short>(number.size()),
                             number.c_str(), kinds.size(), kinds.data(), lengths.data()));
}

/// The first message of a client. Texts are filled up to words of four bytes.
std::string greeting(const Xauth* cookie) {
    constexpr char little = 'l', big = 'B';
    constexpr std::uint16_t version = 11;
    const std::string name(cookie == nullptr ? std::string_view() : cookie_name);
    const std::string data(cookie == nullptr ? std::string_view()
                                             : std::string_view(cookie->data, cookie->data_length));
    const std::array<std::uint16_t, 5> numbers{version, 0, static_cast<std::uint16_t>(name.size()),
                                               static_cast<std::uint16_t>(data.size()), 0};
    std::string bytes{std::endian::native == std::endian::little ? little : big, '\0'};
    bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
    for (const std::string& text : {name, data}) {
        bytes += text;
        bytes.resize((bytes.size() + 3) / 4 * 4);
    }
    return bytes;
}

/// Receives bytes until the span is full. Errors: false if they do not come in time.
bool receive(int file, std::span<char> bytes, steady_clock::time_point deadline) {
    while (!bytes.empty()) {
        const auto left = std::chrono::ceil<milliseconds>(deadline - steady_clock::now());
        pollfd more{file, POLLIN, 0};
        if (left.count() <= 0 || poll(&more, 1, static_cast<int>(left.count())) <= 0)
            return false;
        const auto count = recv(file, bytes.data(), bytes.size(), 0);
        if (count <= 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

/// The server's own words for its refusal. Nothing if the server accepts, or gives no words.
std::optional<std::string> refused(int file, const Xauth* cookie,
                                   steady_clock::time_point deadline) {
    const auto said = greeting(cookie);
    std::array<char, 8> head{};
    if (send(file, said.data(), said.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(said.size()) ||
        !receive(file, head, deadline) || head[0] == 1)
        return {};
    std::uint16_t words = 0;
    std::memcpy(&words, &head[6], sizeof words);
    std::string reason(std::size_t{4} * words, '\0');
    if (!receive(file, reason, deadline))
        return {};
    reason.resize(
        std::min(reason.size(), static_cast<std::size_t>(static_cast<unsigned char>(head[1]))));
    // Some servers give two reasons, each on a line of its own.
    return reason.substr(0, reason.find_first_of(std::string_view("\n\0", 2)));
}

/// Explains a server's refusal to the user. `said` are the server's own words.
x11_refusal meaning(const std::string& said, bool has_cookie) {
    const char* const name = XauFileName();
    const std::string file = name == nullptr ? "any file" : name;
    const auto tell = [&said](const std::string& why, const std::string& remedy) {
        return x11_refusal{.why = why + " (" + said + ")", .remedy = remedy, .is_certain = true};
    };
    if (said.find("Maximum number of clients") != std::string::npos)
        return tell("the X server has no room for one more program",
                    "end some that use it, or start it with '-maxclients 2048'");
    if (has_cookie)
        return tell("the X server does not take the cookie from " + file,
                    "it is another server's cookie: get the right one from the display's owner, "
                    "with 'xauth extract' and 'xauth merge'");
    return tell(
        "the X server asks for a cookie, and " + file + " has none for it",
        "let XAUTHORITY name the file of the display's owner (in a container: mount it), or "
        "log in as the owner");
}

} // namespace

bool can_reach_x11_host(const std::string& display, milliseconds longest) {
    std::string why;
    return is_local(display) || connect_to_x11(display, longest, why);
}

x11_refusal x11_refusal_of(const char* display, milliseconds longest) {
    if (display == nullptr || *display == '\0')
        return {.why = display == nullptr ? "DISPLAY is not set" : "DISPLAY is empty",
                .remedy = "set DISPLAY, or " + without_display,
                .is_certain = true};
    const std::string begin =
        std::string("cannot open the display that DISPLAY names, '") + display + "'";
    std::string why;
    const auto line = connect_to_x11(display, longest, why);
    if (!line)
        return {.why = begin + ": " + why,
                .remedy = "set DISPLAY to another, or " + without_display};
    const auto cookie = cookie_for(line.file(), display);
    const auto said = refused(line.file(), cookie.get(), steady_clock::now() + longest);
    if (!said)
        return {.why = begin, .remedy = "try again, or " + without_display};
    auto found = meaning(*said, cookie != nullptr);
    found.why = begin + ": " + found.why;
    return found;
}

} // namespace l3d_detail
