// SPDX-License-Identifier: MIT
// x11_resolution: finds the resolution by the setting Xft/DPI, or by the resource Xft.dpi.
#include "tool_2d/x11_window/x11_resolution_p.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>

#include <X11/Xresource.h>

namespace l3d_detail {
namespace {

struct database_freer {
    void operator()(XrmDatabase database) const { XrmDestroyDatabase(database); }
};
using unique_database = std::unique_ptr<std::remove_pointer_t<XrmDatabase>, database_freer>;

constexpr double usual_dpi = 96;

double resource_dpi(std::string_view resources) {
    XrmInitialize();
    const unique_database database(XrmGetStringDatabase(std::string(resources).c_str()));
    char* type = nullptr;
    XrmValue value{};
    double dpi = usual_dpi;
    // The value is text that ends with a zero, which is counted. It is not read by the locale's
    // rules.
    if (XrmGetResource(database.get(), "Xft.dpi", "Xft.Dpi", &type, &value) != 0)
        std::from_chars(value.addr, value.addr + std::strlen(value.addr), dpi);
    return dpi;
}

/// Reads the numbers and texts of settings one by one. After a missing value, all later values
/// count as missing.
class settings_reader {
public:
    /// Begins at the text's start. Expects: a text whose first byte is 0 if numbers have their low
    /// byte first.
    explicit settings_reader(std::string_view text)
        : rest_(text), is_low_first_(!text.empty() && text[0] == 0) {
        skip(4);
    }

    bool is_whole() const { return is_whole_; }

    void skip(std::size_t bytes) { take(bytes); }

    std::uint32_t number(std::size_t bytes) {
        const auto found = take(bytes);
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < found.size(); ++i)
            value = value << 8 |
                    static_cast<std::uint8_t>(found[is_low_first_ ? found.size() - 1 - i : i]);
        return value;
    }

    /// Takes a text, and the bytes that fill up its last word.
    std::string_view text(std::size_t bytes) {
        const auto found = take(bytes);
        skip((4 - bytes % 4) % 4);
        return found;
    }

private:
    std::string_view take(std::size_t bytes) {
        is_whole_ = is_whole_ && bytes <= rest_.size();
        const auto found = rest_.substr(0, is_whole_ ? bytes : 0);
        rest_.remove_prefix(found.size());
        return found;
    }

    std::string_view rest_;
    bool is_low_first_;
    bool is_whole_ = true;
};

/// The factor by which `dpi` exceeds the usual resolution, at least 1. For a `dpi` that is not a
/// number, it is 1.
double fineness_of(double dpi) {
    const double wanted = dpi / usual_dpi;
    return wanted > 1 ? std::min<double>(wanted, l3d_largest_scale) : 1;
}

} // namespace

std::optional<double> xsettings_dpi(std::string_view text) {
    enum type : std::uint32_t { whole_number, words, color };
    constexpr double units = 1024;
    settings_reader reader(text);
    reader.skip(4); // the serial number of all settings
    for (auto count = reader.number(4); count > 0 && reader.is_whole(); --count) {
        const auto type = reader.number(1);
        reader.skip(1);
        const auto name = reader.text(reader.number(2));
        reader.skip(4); // the serial number of this setting
        if (type == whole_number) {
            const auto value = static_cast<std::int32_t>(reader.number(4));
            if (name == "Xft/DPI" && reader.is_whole() && value > 0)
                return value / units;
        } else if (type == words) {
            reader.text(reader.number(4));
        } else if (type == color) {
            reader.skip(8);
        } else {
            return {};
        }
    }
    return {};
}

double x11_fineness(std::string_view settings, std::string_view resources) {
    const auto dpi = xsettings_dpi(settings);
    return fineness_of(dpi ? *dpi : resource_dpi(resources));
}

double x11_fineness(const x11_connection& connection) {
    const char* const resources = XResourceManagerString(connection.display());
    return x11_fineness({}, resources == nullptr ? "" : resources);
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
