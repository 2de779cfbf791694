// SPDX-License-Identifier: MIT
// x11_scale: the resource Xft.dpi.
#include "tool_2d/x11/x11_scale_p.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <memory>
#include <type_traits>

#include <X11/Xresource.h>

namespace l3d_detail {
namespace {

struct database_freer {
    void operator()(XrmDatabase database) const { XrmDestroyDatabase(database); }
};
using unique_database = std::unique_ptr<std::remove_pointer_t<XrmDatabase>, database_freer>;

constexpr double usual_dpi = 96;

/// Dots an inch, as the user has set them.
double resource_dpi(Display* display) {
    const char* resources = XResourceManagerString(display);
    if (resources == nullptr)
        return usual_dpi;
    XrmInitialize();
    const unique_database database(XrmGetStringDatabase(resources));
    char* type = nullptr;
    XrmValue value{};
    double dpi = usual_dpi;
    // The value is text that ends with a zero, which is counted. Not read by the locale's rules.
    if (XrmGetResource(database.get(), "Xft.dpi", "Xft.Dpi", &type, &value) != 0)
        std::from_chars(value.addr, value.addr + std::strlen(value.addr), dpi);
    return dpi;
}

} // namespace

int x11_scale(const x11_connection& connection, const l3d_screen_request& request) {
    if (request.scale != 0)
        return request.scale;
    const int fits = largest_x11_side / std::max(request.size.width, request.size.height);
    const int largest = std::clamp(fits, 1, l3d_largest_scale);
    return static_cast<int>(std::lround(std::min<double>(x11_fineness(connection), largest)));
}

double x11_fineness(const x11_connection& connection) {
    const double wanted = resource_dpi(connection.display()) / usual_dpi;
    // Also for a resource that is no number.
    return wanted > 1 ? std::min<double>(wanted, l3d_largest_scale) : 1;
}

} // namespace l3d_detail
