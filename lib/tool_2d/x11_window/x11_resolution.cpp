// SPDX-License-Identifier: MIT
// x11_resolution: dots an inch from two sources.
#include "tool_2d/x11_window/x11_resolution_p.h"

#include "tool_2d/x11/x11_reply_p.h"

#include "tool_2d/x11_window/x11_scale_p.h"

#include <bit>
#include <memory>
#include <string>
#include <string_view>

#include <X11/Xatom.h>
#include <X11/Xlib-xcb.h>

namespace l3d_detail {
namespace {

// Limit of a text of settings, in words: desktops have some kilobytes.
constexpr std::uint32_t longest_text = 1 << 16;

/// Reads numbers one by one; after a missing one, all others count as missing.
class settings_reader {
public:
    explicit settings_reader(std::span<const std::uint8_t> text) : rest_(text) {
        // The first byte is 0 for the low byte first.
        const bool is_low_first = !text.empty() && text[0] == 0;
        is_swapped_ = is_low_first != (std::endian::native == std::endian::little);
        skip(4);
    }

    bool is_whole() const { return is_whole_; }

    void skip(std::size_t bytes) { take(bytes); }

    std::uint32_t number(std::size_t bytes) {
        const auto found = take(bytes);
        std::uint32_t value = 0;
        const bool is_low_first = (std::endian::native == std::endian::little) != is_swapped_;
        for (std::size_t i = 0; i < found.size(); ++i)
            value = value << 8 | found[is_low_first ? found.size() - 1 - i : i];
        return value;
    }

    /// Takes a text and the bytes that fill up its last word.
    std::string_view text(std::size_t bytes) {
        const auto found = take(bytes);
        skip((4 - bytes % 4) % 4);
        return {reinterpret_cast<const char*>(found.data()), found.size()};
    }

private:
    std::span<const std::uint8_t> take(std::size_t bytes) {
        if (!is_whole_ || bytes > rest_.size()) {
            is_whole_ = false;
            return {};
        }
        const auto found = rest_.first(bytes);
        rest_ = rest_.subspan(bytes);
        return found;
    }

    std::span<const std::uint8_t> rest_;
    bool is_swapped_ = false;
    bool is_whole_ = true;
};

std::span<const std::uint8_t> bytes_of(const xcb_get_property_reply_t* reply) {
    if (reply == nullptr || reply->format != 8)
        return {};
    return {static_cast<const std::uint8_t*>(xcb_get_property_value(reply)), reply->value_len};
}

} // namespace

std::optional<double> xsettings_dpi(std::span<const std::uint8_t> text) {
    enum type : std::uint32_t { whole_number, words, color };
    constexpr double units = 1024;
    settings_reader reader(text);
    reader.skip(4); // the serial of all
    for (auto count = reader.number(4); count > 0 && reader.is_whole(); --count) {
        const auto type = reader.number(1);
        reader.skip(1);
        const auto name = reader.text(reader.number(2));
        reader.skip(4); // the serial of this one
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

x11_resolution::x11_resolution(const x11_window& window)
    : window_(window), xcb_(XGetXCBConnection(window.display())), echo_(window) {}

/// Asks the next question.
void x11_resolution::proceed() {
    if (window_.connection().lost())
        return;
    is_due_ = !window_.connection().wait_writable({});
    if (is_due_)
        return;
    if (stage_ == stage::unwatched)
        ask_names();
    else if (stage_ == stage::named)
        find();
    else if (stage_ == stage::found)
        read();
    echo_.ask();
}

void x11_resolution::ask_names() {
    stage_ = stage::naming;
    const std::array<std::string, name_count> texts{
        "_XSETTINGS_S" + std::to_string(window_.connection().screen()), "_XSETTINGS_SETTINGS",
        "MANAGER"};
    for (std::size_t i = 0; i < name_count; ++i)
        names_[i] =
            xcb_intern_atom(xcb_, 0, static_cast<std::uint16_t>(texts[i].size()), texts[i].data());
}

void x11_resolution::hear_names() {
    for (std::size_t i = 0; i < name_count; ++i) {
        const unique_reply<xcb_intern_atom_reply_t> reply(
            xcb_intern_atom_reply(xcb_, names_[i], nullptr));
        atoms_[i] = reply ? reply->atom : 0;
    }
}

void x11_resolution::find() {
    stage_ = stage::finding;
    again_ = false;
    owner_ = xcb_get_selection_owner(xcb_, atoms_[selection]);
}

void x11_resolution::read() {
    stage_ = stage::reading;
    if (manager_ != 0) {
        XSelectInput(window_.display(), manager_, PropertyChangeMask | StructureNotifyMask);
        settings_ = xcb_get_property(xcb_, 0, static_cast<xcb_window_t>(manager_), atoms_[settings],
                                     XCB_GET_PROPERTY_TYPE_ANY, 0, longest_text);
    }
    resources_ = xcb_get_property(xcb_, 0, static_cast<xcb_window_t>(window_.connection().root()),
                                  XA_RESOURCE_MANAGER, XA_STRING, 0, longest_text);
}

double x11_resolution::hear() {
    const unique_reply<xcb_get_property_reply_t> text(
        manager_ == 0 ? nullptr : xcb_get_property_reply(xcb_, settings_, nullptr));
    const unique_reply<xcb_get_property_reply_t> resources(
        xcb_get_property_reply(xcb_, resources_, nullptr));
    stage_ = stage::watching;
    if (const auto dpi = xsettings_dpi(bytes_of(text.get())))
        return x11_fineness_of_dpi(*dpi);
    const auto bytes = bytes_of(resources.get());
    return x11_fineness_of(std::string(bytes.begin(), bytes.end()).c_str());
}

std::optional<double> x11_resolution::take(const XEvent& event) {
    if (!echo_.take(event)) {
        again_ = again_ || concerns_us(event);
        if (again_ && stage_ == stage::watching) {
            stage_ = stage::named;
            proceed();
        }
        return {};
    }
    if (stage_ == stage::naming) {
        hear_names();
        stage_ = stage::named;
    } else if (stage_ == stage::finding) {
        const unique_reply<xcb_get_selection_owner_reply_t> owner(
            xcb_get_selection_owner_reply(xcb_, owner_, nullptr));
        manager_ = owner ? owner->owner : 0;
        stage_ = stage::found;
    } else {
        const double fineness = hear();
        if (again_) {
            stage_ = stage::named;
            proceed();
        }
        return fineness;
    }
    proceed();
    return {};
}

bool x11_resolution::concerns_us(const XEvent& event) const {
    const auto root = window_.connection().root();
    switch (event.type) {
    case PropertyNotify:
        return (event.xproperty.window == root && event.xproperty.atom == XA_RESOURCE_MANAGER) ||
               (is_foreign(event) && event.xproperty.atom == atoms_[settings]);
    case DestroyNotify:
        return is_foreign(event);
    case ClientMessage:
        return event.xclient.window == root && event.xclient.message_type == atoms_[manager] &&
               static_cast<xcb_atom_t>(event.xclient.data.l[1]) == atoms_[selection];
    default:
        return false;
    }
}

} // namespace l3d_detail
