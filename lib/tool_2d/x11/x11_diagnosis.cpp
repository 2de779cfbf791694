// SPDX-License-Identifier: MIT
// What --diagnose tells of an X11 display.
#include "tool_2d/x11/x11_diagnosis_p.h"

#include "tool_2d/x11/x11_extension_p.h"
#include "tool_2d/x11/x11_shm_segment_p.h"
#include "tool_2d/x11/x11_visual_p.h"

#include <algorithm>
#include <string>

namespace l3d_detail {
namespace {

using verdict = l3d_probe::verdict;

const std::string display_name = "display";

l3d_probe probe_display(const x11_connection& connection) {
    auto* const display = connection.display();
    return {display_name,
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

l3d_probe probe_manager(const x11_connection& connection) {
    if (has_x11_manager(connection))
        return {"window manager", "there is one", verdict::good, {}};
    return {"window manager", "none; the window takes the keyboard itself and has no frame",
            verdict::limited, "start a window manager if you want frames"};
}

l3d_probe probe_extension(const x11_connection& connection) {
    int major = 0, minor = 0, pixmaps = 0;
    // Asked for the version of what is not there, Xlib would print a line of its own.
    if (ask_for_extension([&] { return XShmQueryExtension(connection.display()); }) != 0 &&
        XShmQueryVersion(connection.display(), &major, &minor, &pixmaps) != 0)
        return {"MIT-SHM",
                "version " + std::to_string(major) + "." + std::to_string(minor),
                verdict::good,
                {}};
    return {"MIT-SHM", "not there; pictures go over the wire", verdict::limited,
            "start the X server without '-extension MIT-SHM'"};
}

l3d_probe probe_sharing(x11_connection& connection) {
    l3d_probe probe{"shared memory", "the X server sees what we write", verdict::good, {}};
    std::string why;
    const auto visual = choose_x11_visual(connection, why);
    if (visual && x11_shm_segment::make(connection, visual->visual, visual->layout, 1, why))
        return probe;
    return {probe.what, why + "; pictures go over the wire", verdict::limited,
            "needs a local X server in our IPC namespace (in a container: --ipc=host), free "
            "segments (ipcs -lm), and L3D_NO_SHM unset"};
}

/// Null if it has been told that there is no display.
std::unique_ptr<x11_connection> diagnose_connection(l3d_probes& probes) {
    std::string why;
    auto connection = x11_connection::open(why);
    if (connection && connection->lost()) {
        connection.reset();
        why = x11_server_went_away;
    }
    if (std::ranges::find(probes, display_name, &l3d_probe::what) != probes.end())
        return connection;
    if (!connection) {
        probes.push_back({display_name, why, verdict::bad,
                          "set DISPLAY, or do without: --backend memory --output picture.png"});
        return nullptr;
    }
    probes.push_back(probe_display(*connection));
    probes.push_back(probe_visual(*connection));
    probes.push_back(probe_manager(*connection));
    return connection;
}

} // namespace

void diagnose_x11_display(l3d_probes& probes) {
    diagnose_connection(probes);
}

void diagnose_x11_shm(l3d_probes& probes) {
    const auto connection = diagnose_connection(probes);
    if (!connection)
        return;
    probes.push_back(probe_extension(*connection));
    probes.push_back(probe_sharing(*connection));
}

} // namespace l3d_detail
