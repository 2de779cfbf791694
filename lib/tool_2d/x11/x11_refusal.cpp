// SPDX-License-Identifier: MIT
// x11_refusal: the greeting of the protocol, and the meaning of its answers.
#include "tool_2d/x11/x11_refusal_p.h"

#include "tool_2d/x11/x11_reach_p.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

// X.h first: the header of cookies uses its families of addresses.
#include <X11/X.h>

#include <X11/Xauth.h>

namespace l3d_detail {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr std::string_view cookie_name = "MIT-MAGIC-COOKIE-1";
const std::string without_display = "do without: --backend memory --output picture.png";

struct cookie_freer {
    void operator()(Xauth* cookie) const { XauDisposeAuth(cookie); }
};
using unique_cookie = std::unique_ptr<Xauth, cookie_freer>;

/// The address by which the file of cookies knows the other end of a socket: servers of this
/// machine by its name, as Xlib looks them up.
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

/// Receives all bytes. Errors: false if they do not come in time.
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

/// Why the server refuses, in its own words. None if it accepts, or says nothing.
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
    // Some say two things, each on a line.
    return reason.substr(0, reason.find_first_of(std::string_view("\n\0", 2)));
}

/// Explains a server's refusal to the user.
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
