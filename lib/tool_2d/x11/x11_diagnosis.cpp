// SPDX-License-Identifier: MIT
// Writes the lines of --diagnose about an X11 display.
#include "tool_2d/x11/x11_diagnosis_p.h"

#include "tool_2d/x11/x11_shm_segment_p.h"
#include "tool_2d/x11/x11_visual_p.h"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

namespace l3d_detail {
namespace {

using verdict = l3d_probe::verdict;

// A server that works answers in milliseconds.
constexpr std::chrono::seconds longest_answer{3};

l3d_probe probe_display(const x11_connection& connection) {
    auto* const display = connection.display();
    return {l3d_display_probe,
            std::string("'") + DisplayString(display) + "', " +
                (connection.is_local() ? "local" : "over a network") + ", " +
                ServerVendor(display) + " " + std::to_string(VendorRelease(display)),
            verdict::good,
            {}};
}

l3d_probe probe_visual(const x11_connection& connection) {
    l3d_probe probe{"visual", {}, verdict::good, {}};
    const auto visual = choose_x11_visual(connection, probe.result);
    if (visual) {
        probe.result = visual->layout.describe();
    } else {
        probe.outcome = verdict::bad;
        probe.remedy = "use a display of depth 8, 15, 16, 24 or 30";
    }
    return probe;
}

/// Whether the server trusts the connection. An untrusted connection, as that of ssh -X, sees only
/// the two extensions that this function names.
bool is_trusted(const x11_connection& connection) {
    int count = 0;
    char** const names = XListExtensions(connection.display(), &count);
    const bool shows_more = std::ranges::any_of(
        std::span(names, static_cast<std::size_t>(count)),
        [](const std::string_view name) { return name != "BIG-REQUESTS" && name != "XC-MISC"; });
    XFreeExtensionList(names);
    return shows_more;
}

/// Adds a probe for each thing that is special about the connection to the server.
void probe_way(const x11_connection& connection, l3d_probes& probes) {
    if (!is_trusted(connection))
        probes.push_back({"trust",
                          "the X server does not trust this connection, and hides most of "
                          "its extensions",
                          verdict::limited,
                          "ssh -Y in place of ssh -X, if you trust the other machine"});
    if (connection.is_local())
        return;
    const bool is_ssh = std::getenv("SSH_CONNECTION") != nullptr;
    probes.push_back({"way",
                      std::string(is_ssh ? "by ssh" : "over a network") +
                          "; --remote auto sends only what changed, coarse while it moves",
                      verdict::limited,
                      std::string("a smaller --size and --fps 5 make it lighter") +
                          (is_ssh ? "; so does ssh -C on a slow line" : "")});
}

l3d_probe probe_manager(const x11_connection& connection) {
    if (has_x11_manager(connection))
        return {"window manager", "there is one", verdict::good, {}};
    return {"window manager", "none; the window takes the keyboard itself and has no frame",
            verdict::limited, "start a window manager if you want frames"};
}

l3d_probe probe_extension(const x11_connection& connection) {
    int major = 0, minor = 0, pixmaps = 0;
    // Xlib would print a line of its own when it is asked for a missing extension's version.
    if (connection.has(XShmQueryExtension) &&
        XShmQueryVersion(connection.display(), &major, &minor, &pixmaps) != 0)
        return {"MIT-SHM",
                "version " + std::to_string(major) + "." + std::to_string(minor),
                verdict::good,
                {}};
    return {"MIT-SHM", "not there; pictures go over the wire", verdict::limited,
            is_trusted(connection) ? "Xnest has none, Xephyr has; others have it unless started "
                                     "with '-extension MIT-SHM'"
                                   : "hidden from connections that are not trusted"};
}

/// Advice to the user if no memory is shared.
std::string sharing_remedy(const x11_connection& connection) {
    const char* const refusal = std::getenv("L3D_NO_SHM");
    if (refusal != nullptr && *refusal != '\0')
        return "unset L3D_NO_SHM";
    if (!connection.is_local())
        return "none is needed: back-end ximage serves displays of other machines";
    return "needs an X server with MIT-SHM 1.2; with an older one, an X server in our IPC "
           "namespace "
           "(in a container: --ipc=host) and free segments (ipcs -lm)";
}

l3d_probe probe_sharing(x11_connection& connection) {
    l3d_probe probe{"shared memory", "the X server sees what we write", verdict::good, {}};
    std::string why;
    const auto visual = choose_x11_visual(connection, why);
    if (visual && x11_shm_segment::make(connection, visual->visual, visual->layout, 1, why)) {
        probe.result += connection.sharing() == x11_sharing::files ? ", in files that it is handed"
                                                                   : ", in segments of System V";
        return probe;
    }
    return {probe.what, why + "; pictures go over the wire", verdict::limited,
            sharing_remedy(connection)};
}

/// Opens a connection. If there is no display, returns null and adds a probe with the reason.
///
/// The function does not let Xlib connect to a server that refuses, since the library below Xlib
/// would print a line each time.
std::unique_ptr<x11_connection> diagnose_connection(l3d_probes& probes) {
    const auto before = std::ranges::find(probes, l3d_display_probe, &l3d_probe::what);
    if (before != probes.end() && before->outcome == verdict::bad)
        return nullptr;
    auto refusal = x11_refusal_of(std::getenv("DISPLAY"), longest_answer);
    std::unique_ptr<x11_connection> connection;
    if (!refusal.is_certain)
        connection = x11_connection::open(refusal.why);
    if (connection && connection->lost()) {
        connection.reset();
        refusal.why = x11_server_went_away;
    }
    if (!connection) {
        probes.push_back({l3d_display_probe, refusal.why, verdict::bad, refusal.remedy});
        return nullptr;
    }
    if (before != probes.end())
        return connection;
    probes.push_back(probe_display(*connection));
    probe_way(*connection, probes);
    probes.push_back(probe_visual(*connection));
    probes.push_back(probe_manager(*connection));
    return connection;
}

} // namespace

void diagnose_x11(l3d_probes& probes, bool with_shared_memory) {
    const auto connection = diagnose_connection(probes);
    if (!connection || !with_shared_memory)
        return;
    probes.push_back(probe_extension(*connection));
    probes.push_back(probe_sharing(*connection));
}

} // namespace l3d_detail
