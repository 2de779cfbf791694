// SPDX-License-Identifier: MIT
// x11_scroll: exchanges the few messages of XInput 2 that tell of wheels.
#include "tool_2d/x11_window/x11_scroll_p.h"

#include <cstdlib>
#include <cstring>

#include <X11/Xlib-xcb.h>
#include <X11/Xproto.h>

/// Sets the function that reads an extension's events from the wire. Xlib exports this call for
/// libraries of extensions. Its header cannot be included beside others, so it is declared here.
extern "C" Bool (*XESetWireToEventCookie(Display* display, int extension,
                                         Bool (*read)(Display*, XGenericEventCookie*,
                                                      xEvent*)))(Display*, XGenericEventCookie*,
                                                                 xEvent*);

namespace l3d_detail {
namespace {

double number(const xcb_input_fp3232_t& value) {
    constexpr double units = 4294967296.0;
    return value.integral + value.frac / units;
}

int whole(xcb_input_fp1616_t value) {
    return value >> 16;
}

/// Keeps a message, of which Xlib knows nothing, in the form of XCB's events. In this form, a
/// number of XCB's own follows the first 32 bytes. The length counts the words after these 32
/// bytes.
Bool keep_message(Display* display, XGenericEventCookie* cookie, xEvent* wire) {
    constexpr std::size_t head = 32, word = 4;
    const auto* const first = reinterpret_cast<const std::uint8_t*>(wire);
    const auto* const event = reinterpret_cast<const xcb_input_motion_event_t*>(wire);
    auto* const kept =
        static_cast<std::uint8_t*>(std::calloc(head + word + word * event->length, 1));
    if (kept == nullptr)
        return False;
    std::memcpy(kept, first, head);
    std::memcpy(kept + head + word, first + head, word * event->length);
    cookie->type = GenericEvent;
    cookie->serial = XLastKnownRequestProcessed(display);
    cookie->send_event = False;
    cookie->display = display;
    cookie->extension = event->extension;
    cookie->evtype = event->event_type;
    cookie->data = kept; // Xlib frees it
    return True;
}

} // namespace

x11_scroll::x11_scroll(const x11_window& window)
    : window_(window), xcb_(XGetXCBConnection(window.display())), echo_(window) {}

void x11_scroll::look_after() {
    if (is_due_)
        proceed();
}

/// Sends the next question, if there is room for it.
void x11_scroll::proceed() {
    if (window_.connection().lost())
        return;
    is_due_ = !window_.connection().wait_writable({});
    if (is_due_)
        return;
    if (stage_ == stage::unasked) {
        stage_ = stage::searching;
        xcb_prefetch_extension_data(xcb_, &xcb_input_id);
    } else {
        ask();
    }
    echo_.ask();
}

/// Asks for the devices. The server takes us for an old program unless we ask for its version
/// first.
void x11_scroll::ask() {
    if (std::exchange(stage_, stage::asking) == stage::searching) {
        xcb_discard_reply(xcb_, xcb_input_xi_query_version(xcb_, 2, 1).sequence);
        select(XCB_INPUT_XI_EVENT_MASK_DEVICE_CHANGED);
    }
    devices_ = xcb_input_xi_query_device(xcb_, XCB_INPUT_DEVICE_ALL_MASTER);
}

/// Selects the events that the server sends.
/// Shape:   the first eight events as bits. The protocol has masks in bytes, the lowest first.
void x11_scroll::select(std::uint8_t mask) {
    if (std::exchange(mask_, mask) == mask)
        return;
    const struct {
        xcb_input_event_mask_t device;
        std::uint8_t mask[4];
    } request{{XCB_INPUT_DEVICE_ALL_MASTER, 1}, {mask}};
    xcb_input_xi_select_events(xcb_, static_cast<xcb_window_t>(window_.id()), 1, &request.device);
}

void x11_scroll::hear() {
    const unique_reply<xcb_input_xi_query_device_reply_t> reply(
        xcb_input_xi_query_device_reply(xcb_, devices_, nullptr));
    wheels_.clear();
    if (!reply)
        return;
    for (auto at = xcb_input_xi_query_device_infos_iterator(reply.get()); at.rem > 0;
         xcb_input_xi_device_info_next(&at))
        add_wheels(*at.data);
    std::erase_if(wheels_, [](const auto& axis) { return axis.second.increment == 0; });
    select(wheels_.empty() ? XCB_INPUT_XI_EVENT_MASK_DEVICE_CHANGED
                           : XCB_INPUT_XI_EVENT_MASK_DEVICE_CHANGED |
                                 XCB_INPUT_XI_EVENT_MASK_MOTION | XCB_INPUT_XI_EVENT_MASK_ENTER);
}

/// Adds all axes of a device with their positions. For wheels, also notes the length of a notch.
void x11_scroll::add_wheels(const xcb_input_xi_device_info_t& device) {
    for (auto at = xcb_input_xi_device_info_classes_iterator(&device); at.rem > 0;
         xcb_input_device_class_next(&at)) {
        const auto* const scroll = reinterpret_cast<const xcb_input_scroll_class_t*>(at.data);
        const auto* const axis = reinterpret_cast<const xcb_input_valuator_class_t*>(at.data);
        if (at.data->type == XCB_INPUT_DEVICE_CLASS_TYPE_VALUATOR)
            wheels_[{device.deviceid, axis->number}].last = number(axis->value);
        else if (at.data->type == XCB_INPUT_DEVICE_CLASS_TYPE_SCROLL &&
                 scroll->scroll_type == XCB_INPUT_SCROLL_TYPE_VERTICAL)
            wheels_[{device.deviceid, scroll->number}].increment = number(scroll->increment);
    }
}

std::optional<x11_turn> x11_scroll::take(XEvent& event) {
    if (echo_.take(event)) {
        if (stage_ == stage::asking) {
            stage_ = stage::watching;
            hear();
        } else if (const auto* const found = xcb_get_extension_data(xcb_, &xcb_input_id);
                   found != nullptr && found->present != 0) {
            opcode_ = found->major_opcode;
            XESetWireToEventCookie(window_.display(), opcode_, keep_message);
            proceed();
        }
        return {};
    }
    if (opcode_ == 0 || event.type != GenericEvent || event.xcookie.extension != opcode_ ||
        XGetEventData(window_.display(), &event.xcookie) == 0)
        return {};
    std::optional<x11_turn> turn;
    if (event.xcookie.evtype == XCB_INPUT_MOTION) {
        turn = take_motion(*static_cast<const xcb_input_motion_event_t*>(event.xcookie.data));
    } else {
        // Another device's wheel turns, or a wheel turned elsewhere, so the last places mean
        // nothing.
        for (auto& known : wheels_)
            known.second.last.reset();
        if (stage_ == stage::watching)
            proceed();
    }
    XFreeEventData(window_.display(), &event.xcookie);
    return turn;
}

x11_turn x11_scroll::take_motion(const xcb_input_motion_event_t& event) {
    x11_turn turn{};
    turn.motion.type = MotionNotify;
    turn.motion.display = window_.display();
    turn.motion.window = event.event;
    turn.motion.root = event.root;
    turn.motion.time = event.time;
    turn.motion.x = whole(event.event_x);
    turn.motion.y = whole(event.event_y);
    turn.motion.state = event.mods.effective;
    const auto* const mask = xcb_input_button_press_valuator_mask(&event);
    const auto* value = xcb_input_button_press_axisvalues(&event);
    for (unsigned axis = 0; axis < 32U * event.valuators_len; ++axis) {
        if ((mask[axis / 32] >> axis % 32 & 1) == 0)
            continue;
        const double place = number(*value++);
        const auto found = wheels_.find({event.deviceid, static_cast<std::uint16_t>(axis)});
        if (found == wheels_.end())
            continue;
        // X counts turns towards the user as positive.
        auto& [increment, last] = found->second;
        if (last)
            turn.notches -= (place - *last) / increment;
        last = place;
    }
    return turn;
}

} // namespace l3d_detail
