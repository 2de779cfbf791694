// SPDX-License-Identifier: MIT
// x11_scale: the resource Xft.dpi.
#include "tool_2d/x11_window/x11_scale_p.h"

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

/// Dots an inch that the user has set in resources; null is no text.
double resource_dpi(const char* resources) {
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

double x11_fineness_of_dpi(double dpi) {
    const double wanted = dpi / usual_dpi;
    // This is 1 also for a resource that is no number.
    return wanted > 1 ? std::min<double>(wanted, l3d_largest_scale) : 1;
}

double x11_fineness_of(const char* resources) {
    return x11_fineness_of_dpi(resource_dpi(resources));
}

double x11_fineness(const x11_connection& connection) {
    return x11_fineness_of(XResourceManagerString(connection.display()));
}

l3d_size x11_picture_size(const x11_connection& connection, const l3d_screen_request& request) {
    if (request.scale != 0)
        return request.size;
    const double fits =
        static_cast<double>(largest_x11_side) / std::max(request.size.width, request.size.height);
    const double factor = std::clamp(fits, 1.0, x11_fineness(connection));
    return {static_cast<int>(std::lround(request.size.width * factor)),
            static_cast<int>(std::lround(request.size.height * factor))};
}

} // namespace l3d_detail
