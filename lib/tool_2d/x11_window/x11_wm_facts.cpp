// SPDX-License-Identifier: MIT
// x11_wm_facts: asks questions without waiting, and takes facts from the answers.
#include "tool_2d/x11_window/x11_wm_facts_p.h"

#include "tool_2d/x11_window/x11_resolution_p.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <X11/Xatom.h>
#include <X11/Xlib-xcb.h>
#include <X11/Xutil.h>

namespace l3d_detail {
namespace {

// The limit of a property's length, in words. Texts of settings have some kilobytes.
constexpr std::uint32_t longest_property = 1 << 16;

bool holds(const std::vector<std::uint32_t>& list, std::uint32_t wanted) {
    return std::ranges::find(list, wanted) != list.end();
}

/// Whether the window is on a workspace that is not shown. A manager that shows several workspaces
/// at once, one on each monitor, still names one as current. A manager without workspaces may
/// number windows by its own rules.
bool is_elsewhere(const std::vector<std::uint32_t>& desktop,
                  const std::vector<std::uint32_t>& current,
                  const std::vector<std::uint32_t>& desktops, std::size_t monitors) {
    return monitors <= 1 && !desktop.empty() && !current.empty() && !desktops.empty() &&
           desktop.front() < desktops.front() && desktop.front() != current.front();
}

} // namespace

x11_wm_facts::x11_wm_facts(const x11_window& window)
    : window_(window), xcb_(XGetXCBConnection(window.display())),
      echo_(window), facts_{.managed = window.was_managed(),
                            .fineness = x11_fineness(window.connection())} {}

void x11_wm_facts::ask() {
    if (window_.connection().lost())
        return;
    if (echo_.is_awaited()) {
        again_ = true;
        return;
    }
    is_due_ = !window_.connection().wait_writable({});
    if (is_due_)
        return;
    if (stage_ == stage::unwatched) {
        // Listening begins before the first question, so that no later change is missed.
        XSelectInput(window_.display(), window_.connection().root(),
                     PropertyChangeMask | StructureNotifyMask);
        ask_names();
    } else {
        ask_facts();
    }
}

void x11_wm_facts::ask_names() {
    const std::array<std::string, name_count> texts{
        "_NET_WM_STATE",
        "_NET_WM_STATE_FULLSCREEN",
        "_NET_WM_STATE_HIDDEN",
        "WM_STATE",
        "_NET_WM_DESKTOP",
        "_NET_CURRENT_DESKTOP",
        "_NET_NUMBER_OF_DESKTOPS",
        "_NET_SUPPORTED",
        "_NET_SUPPORTING_WM_CHECK",
        "_XSETTINGS_SETTINGS",
        "_NET_WM_PID",
        "_NET_WM_ICON",
        "_XSETTINGS_S" + std::to_string(window_.connection().screen()),
        "MANAGER"};
    stage_ = stage::naming;
    for (std::size_t i = 0; i < name_count; ++i)
        names_[i] =
            xcb_intern_atom(xcb_, 0, static_cast<std::uint16_t>(texts[i].size()), texts[i].data());
    xcb_prefetch_extension_data(xcb_, &xcb_randr_id);
    echo_.ask();
}

void x11_wm_facts::hear_names() {
    for (std::size_t i = 0; i < name_count; ++i) {
        const unique_reply<xcb_intern_atom_reply_t> reply(
            xcb_intern_atom_reply(xcb_, names_[i], nullptr));
        atoms_[i] = reply ? reply->atom : 0;
    }
    stage_ = stage::watching;
    window_.set_process_and_icon(atoms_[net_wm_pid], atoms_[net_wm_icon]);
}

xcb_get_property_cookie_t x11_wm_facts::ask_property(Window window, name property) const {
    return xcb_get_property(xcb_, 0, static_cast<xcb_window_t>(window), atoms_[property],
                            XCB_GET_PROPERTY_TYPE_ANY, 0, longest_property);
}

/// The answer about a property. The answer is empty if there is no such property, or if the
/// property is not a list of numbers.
std::vector<std::uint32_t> x11_wm_facts::hear_property(xcb_get_property_cookie_t cookie) const {
    const unique_reply<xcb_get_property_reply_t> reply(
        xcb_get_property_reply(xcb_, cookie, nullptr));
    if (!reply || reply->format != 32)
        return {};
    const std::span words(static_cast<const std::uint32_t*>(xcb_get_property_value(reply.get())),
                          reply->value_len);
    return {words.begin(), words.end()};
}

void x11_wm_facts::ask_facts() {
    const auto root = static_cast<xcb_window_t>(window_.connection().root());
    const auto window = static_cast<xcb_window_t>(window_.id());
    question_.root = xcb_get_window_attributes(xcb_, root);
    question_.window = xcb_get_window_attributes(xcb_, window);
    question_.check = ask_property(root, net_supporting_wm_check);
    question_.asked_check = check_;
    if (check_ != 0)
        question_.checked = ask_property(check_, net_supporting_wm_check);
    question_.supported = ask_property(root, net_supported);
    question_.current_desktop = ask_property(root, net_current_desktop);
    question_.desktops = ask_property(root, net_number_of_desktops);
    question_.state = ask_property(window, net_wm_state);
    question_.wm_state = ask_property(window, wm_state);
    question_.desktop = ask_property(window, net_wm_desktop);
    question_.settings_owner = xcb_get_selection_owner(xcb_, atoms_[xsettings_selection]);
    if (settings_ != 0)
        question_.settings = ask_property(settings_, xsettings);
    question_.resources =
        xcb_get_property(xcb_, 0, root, XA_RESOURCE_MANAGER, XA_STRING, 0, longest_property);
    // XCB knows the answer since the names were heard, so this does not wait.
    const auto* const randr = xcb_get_extension_data(xcb_, &xcb_randr_id);
    question_.has_randr = randr != nullptr && randr->present != 0;
    if (question_.has_randr) {
        // The server takes us for an old program unless we ask for its version.
        xcb_discard_reply(xcb_, xcb_randr_query_version(xcb_, 1, 5).sequence);
        question_.monitors = xcb_randr_get_monitors(xcb_, root, 1);
    }
    echo_.ask();
}

std::vector<l3d_pixel_box> x11_wm_facts::hear_monitors() {
    std::vector<l3d_pixel_box> monitors;
    if (!question_.has_randr)
        return monitors;
    const unique_reply<xcb_randr_get_monitors_reply_t> reply(
        xcb_randr_get_monitors_reply(xcb_, question_.monitors, nullptr));
    if (!reply)
        return monitors;
    for (auto at = xcb_randr_get_monitors_monitors_iterator(reply.get()); at.rem > 0;
         xcb_randr_monitor_info_next(&at))
        monitors.push_back(
            {at.data->x, at.data->y, at.data->x + at.data->width, at.data->y + at.data->height});
    return monitors;
}

/// Takes the fineness from the settings. The fineness changes only after the present manager of
/// settings has sent its own value.
void x11_wm_facts::hear_settings() {
    const auto hear_text = [this](xcb_get_property_cookie_t cookie) {
        return unique_reply<xcb_get_property_reply_t>(
            xcb_get_property_reply(xcb_, cookie, nullptr));
    };
    const auto text_of = [](const unique_reply<xcb_get_property_reply_t>& reply) {
        return !reply || reply->format != 8
                   ? std::string_view()
                   : std::string_view(static_cast<const char*>(xcb_get_property_value(reply.get())),
                                      reply->value_len);
    };
    const unique_reply<xcb_get_selection_owner_reply_t> owner(
        xcb_get_selection_owner_reply(xcb_, question_.settings_owner, nullptr));
    const auto settings = settings_ == 0 ? nullptr : hear_text(question_.settings);
    const auto resources = hear_text(question_.resources);
    const Window named = owner ? owner->owner : 0;
    if (named == settings_) {
        facts_.fineness = x11_fineness(text_of(settings), text_of(resources));
        return;
    }
    settings_ = named;
    if (named != 0)
        XSelectInput(window_.display(), named, PropertyChangeMask | StructureNotifyMask);
    again_ = true;
}

void x11_wm_facts::hear_facts() {
    const unique_reply<xcb_get_window_attributes_reply_t> root(
        xcb_get_window_attributes_reply(xcb_, question_.root, nullptr));
    const unique_reply<xcb_get_window_attributes_reply_t> window(
        xcb_get_window_attributes_reply(xcb_, question_.window, nullptr));
    const auto check = hear_property(question_.check);
    const auto checked = question_.asked_check == 0 ? check : hear_property(question_.checked);
    const auto supported = hear_property(question_.supported);
    const auto current_desktop = hear_property(question_.current_desktop);
    const auto desktops = hear_property(question_.desktops);
    const auto state = hear_property(question_.state);
    const auto icon = hear_property(question_.wm_state);
    const auto desktop = hear_property(question_.desktop);
    hear_settings();
    facts_.monitors = hear_monitors();

    const Window named = check.empty() ? 0 : check.front();
    if (named != check_) {
        check_ = named;
        if (named != 0)
            XSelectInput(window_.display(), named, StructureNotifyMask);
        again_ = true; // a dead manager may have left the name of its window
    }
    // A manager is the one client that redirects the root's children.
    facts_.managed = root && (root->all_event_masks & SubstructureRedirectMask) != 0;
    const bool lives =
        facts_.managed && check_ != 0 && holds(checked, static_cast<std::uint32_t>(check_));
    facts_.grants_fullscreen = lives && holds(supported, atoms_[net_wm_state_fullscreen]);
    facts_.fullscreen = facts_.grants_fullscreen && holds(state, atoms_[net_wm_state_fullscreen]);
    const bool is_icon = !icon.empty() && icon.front() != NormalState;
    const bool is_unviewable = window && window->map_state == XCB_MAP_STATE_UNVIEWABLE;
    facts_.away =
        facts_.managed &&
        (is_icon || is_unviewable || (lives && holds(state, atoms_[net_wm_state_hidden])) ||
         (lives && is_elsewhere(desktop, current_desktop, desktops, facts_.monitors.size())));
}

bool x11_wm_facts::take(const XEvent& event) {
    if (!echo_.take(event)) {
        if (stage_ == stage::watching && concerns_us(event))
            ask();
        return false;
    }
    if (stage_ == stage::naming) {
        hear_names();
        ask();
        return false;
    }
    const bool is_stale = std::exchange(again_, false);
    hear_facts();
    if (is_stale || std::exchange(again_, false))
        ask();
    return true;
}

bool x11_wm_facts::is_foreign(const XEvent& event) const {
    const Window about = event.xany.window;
    return about != 0 &&
           (about == window_.connection().root() || about == check_ || about == settings_);
}

bool x11_wm_facts::concerns_us(const XEvent& event) const {
    switch (event.type) {
    case PropertyNotify:
        return event.xproperty.atom == XA_RESOURCE_MANAGER ||
               std::ranges::count(std::span(atoms_).first(watched_count), event.xproperty.atom) !=
                   0;
    case ReparentNotify: // by a manager that comes or goes
        return true;
    case DestroyNotify:
        return event.xdestroywindow.window == check_ || event.xdestroywindow.window == settings_;
    case ClientMessage: // a manager of settings has come
        return event.xclient.message_type == atoms_[manager] &&
               static_cast<xcb_atom_t>(event.xclient.data.l[1]) == atoms_[xsettings_selection];
    case ConfigureNotify: // the monitors have changed
        return event.xany.window == window_.connection().root();
    case VisibilityNotify:
        return facts_.away;
    default:
        return false;
    }
}

} // namespace l3d_detail
