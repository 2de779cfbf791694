// SPDX-License-Identifier: MIT
// x11_scroll: the few messages of XInput 2 that tell of wheels.
#include "tool_2d/x11_window/x11_scroll_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>

#include <sys/uio.h>

#include <X11/Xlib-xcb.h>
#include <X11/Xproto.h>
#include <X11/extensions/XI.h>
#include <X11/extensions/XI2.h>
#include <X11/extensions/XI2proto.h>
#include <xcb/xcbext.h>

/// Names the function that reads an extension's events from the wire. Xlib exports it for libraries
/// of extensions, in a header that no program can include beside others.
extern "C" Bool (*XESetWireToEventCookie(Display* display, int extension,
                                         Bool (*read)(Display*, XGenericEventCookie*,
                                                      xEvent*)))(Display*, XGenericEventCookie*,
                                                                 xEvent*);

namespace l3d_detail {
namespace {

struct reply_freer {
    void operator()(void* reply) const { std::free(reply); }
};
template <class Reply> using unique_reply = std::unique_ptr<Reply, reply_freer>;
using bytes = std::span<const std::uint8_t>;

constexpr std::size_t word = 4;
// Size of replies and events; the rest behind them is counted in words.
constexpr std::size_t head = 32;

/// One message of the protocol at a place; nothing if it is cut off.
template <class Message> std::optional<Message> read(bytes data, std::size_t at) {
    if (at > data.size() || data.size() - at < sizeof(Message))
        return {};
    Message message;
    std::memcpy(&message, data.data() + at, sizeof message);
    return message;
}

double number(const FP3232& value) {
    constexpr double units = 4294967296.0;
    return value.integral + value.frac / units;
}

int whole(FP1616 value) {
    return value >> 16;
}

template <class Request> std::span<std::uint8_t> bytes_of(Request& request) {
    return {reinterpret_cast<std::uint8_t*>(&request), sizeof request};
}

/// Calls visit(type, place) for each class of a device, as far as they are whole.
template <class Visit> void visit_classes(bytes classes, Visit visit) {
    std::size_t at = 0;
    for (;;) {
        const auto any = read<xXIAnyInfo>(classes, at);
        if (!any || any->length == 0)
            return;
        visit(any->type, at);
        at += word * any->length;
    }
}

/// Keeps the message as it is: Xlib knows none of this extension.
Bool keep_message(Display* display, XGenericEventCookie* cookie, xEvent* wire) {
    const auto* const message = reinterpret_cast<const xXIDeviceEvent*>(wire);
    const std::size_t size = head + word * message->length;
    cookie->type = GenericEvent;
    cookie->serial = XLastKnownRequestProcessed(display);
    cookie->send_event = False;
    cookie->display = display;
    cookie->extension = message->extension;
    cookie->evtype = message->evtype;
    cookie->data = std::malloc(size); // Xlib frees it.
    if (cookie->data == nullptr)
        return False;
    std::memcpy(cookie->data, wire, size);
    return True;
}

/// The bytes of a reply, head included; none if there is none.
bytes hear_reply(xcb_connection_t* xcb, unsigned request, unique_reply<void>& owner) {
    owner.reset(xcb_wait_for_reply(xcb, request, nullptr));
    const auto* const generic = static_cast<const xcb_generic_reply_t*>(owner.get());
    if (generic == nullptr)
        return {};
    return {static_cast<const std::uint8_t*>(owner.get()), head + word * generic->length};
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
    if (stage_ == stage::unasked)
        search();
    else
        ask();
    echo_.ask();
}

void x11_scroll::search() {
    stage_ = stage::searching;
    constexpr std::string_view extension = INAME;
    extension_ =
        xcb_query_extension(xcb_, static_cast<std::uint16_t>(extension.size()), extension.data());
}

/// The server takes us for an old program unless we ask for its version.
void x11_scroll::ask() {
    stage_ = stage::asking;
    if (version_ == 0) {
        xXIQueryVersionReq version{};
        version.major_version = 2;
        version.minor_version = 1;
        version_ = send(bytes_of(version), X_XIQueryVersion, true);
        xcb_discard_reply(xcb_, version_);
        select(XI_DeviceChangedMask);
    }
    xXIQueryDeviceReq devices{};
    devices.deviceid = XIAllMasterDevices;
    devices_ = send(bytes_of(devices), X_XIQueryDevice, true);
}

unsigned x11_scroll::send(std::span<std::uint8_t> request, std::uint8_t kind,
                          bool has_reply) const {
    // The kind follows the number of the extension, which the library writes.
    request[1] = kind;
    // The first two parts are the library's.
    std::array<iovec, 3> parts{};
    parts[2] = {request.data(), request.size()};
    const xcb_protocol_request_t how{1, nullptr, opcode_,
                                     static_cast<std::uint8_t>(has_reply ? 0 : 1)};
    return xcb_send_request(xcb_, 0, &parts[2], &how);
}

void x11_scroll::select(std::uint32_t mask) {
    if (std::exchange(mask_, mask) == mask)
        return;
    struct {
        xXISelectEventsReq head;
        xXIEventMask device;
        std::uint32_t mask;
    } request{};
    request.head.win = static_cast<std::uint32_t>(window_.id());
    request.head.num_masks = 1;
    request.device = {XIAllMasterDevices, 1};
    // Bytes, each with its lowest bit first.
    request.mask = std::endian::native == std::endian::little ? mask : __builtin_bswap32(mask);
    send(bytes_of(request), X_XISelectEvents, false);
}

void x11_scroll::hear() {
    unique_reply<void> owner;
    const bytes reply = hear_reply(xcb_, devices_, owner);
    const auto first = read<xXIQueryDeviceReply>(reply, 0);
    wheels_.clear();
    std::size_t at = head;
    for (int i = 0; first && i < first->num_devices; ++i) {
        const auto device = read<xXIDeviceInfo>(reply, at);
        if (!device)
            break;
        at += sizeof(xXIDeviceInfo) + (device->name_len + word - 1) / word * word;
        const std::size_t begin = at;
        for (int k = 0; k < device->num_classes; ++k)
            if (const auto any = read<xXIAnyInfo>(reply, at))
                at += word * any->length;
        at = std::min(at, reply.size());
        add_wheels(device->deviceid, reply.subspan(begin, at - begin));
    }
    select(wheels_.empty() ? XI_DeviceChangedMask
                           : XI_DeviceChangedMask | XI_MotionMask | XI_EnterMask);
}

/// The wheels among a device's classes, and how far they have turned.
void x11_scroll::add_wheels(std::uint16_t device, bytes classes) {
    visit_classes(classes, [&](int type, std::size_t at) {
        const auto scroll = read<xXIScrollInfo>(classes, at);
        if (type == XIScrollClass && scroll && scroll->scroll_type == XIScrollTypeVertical &&
            number(scroll->increment) != 0)
            wheels_[{device, scroll->number}].increment = number(scroll->increment);
    });
    visit_classes(classes, [&](int type, std::size_t at) {
        const auto axis = read<xXIValuatorInfo>(classes, at);
        if (type != XIValuatorClass || !axis)
            return;
        const auto found = wheels_.find({device, axis->number});
        if (found != wheels_.end())
            found->second.last = number(axis->value);
    });
}

std::optional<x11_turn> x11_scroll::take(XEvent& event) {
    if (echo_.take(event)) {
        if (stage_ == stage::searching) {
            const unique_reply<xcb_query_extension_reply_t> reply(
                xcb_query_extension_reply(xcb_, extension_, nullptr));
            if (!reply || reply->present == 0)
                return {};
            opcode_ = reply->major_opcode;
            XESetWireToEventCookie(window_.display(), opcode_, keep_message);
            proceed();
        } else {
            stage_ = stage::watching;
            hear();
        }
        return {};
    }
    if (opcode_ == 0 || event.type != GenericEvent || event.xcookie.extension != opcode_ ||
        XGetEventData(window_.display(), &event.xcookie) == 0)
        return {};
    const auto* const message = static_cast<const std::uint8_t*>(event.xcookie.data);
    const auto generic = read<xcb_ge_generic_event_t>({message, head}, 0);
    const bytes data(message, head + word * generic->length);
    std::optional<x11_turn> turn;
    if (event.xcookie.evtype == XI_Motion) {
        turn = take_motion(data);
    } else {
        // A wheel of another device, or turned elsewhere: the last numbers mean nothing.
        for (auto& known : wheels_)
            known.second.last.reset();
        if (stage_ == stage::watching)
            proceed();
    }
    XFreeEventData(window_.display(), &event.xcookie);
    return turn;
}

std::optional<x11_turn> x11_scroll::take_motion(bytes message) {
    const auto event = read<xXIDeviceEvent>(message, 0);
    if (!event)
        return {};
    x11_turn turn{};
    turn.motion.type = MotionNotify;
    turn.motion.display = window_.display();
    turn.motion.window = event->event;
    turn.motion.root = event->root;
    turn.motion.time = event->time;
    turn.motion.x = whole(event->event_x);
    turn.motion.y = whole(event->event_y);
    turn.motion.state = event->mods.effective_mods;
    const std::size_t mask = sizeof(xXIDeviceEvent) + word * event->buttons_len;
    std::size_t value = mask + word * event->valuators_len;
    for (std::size_t bit = 0; bit < 8 * word * event->valuators_len; ++bit) {
        const auto eight = read<std::uint8_t>(message, mask + bit / 8);
        if (!eight || (*eight >> bit % 8 & 1) == 0)
            continue;
        const auto found = wheels_.find({event->deviceid, static_cast<std::uint16_t>(bit)});
        const auto place = read<FP3232>(message, value);
        value += sizeof(FP3232);
        if (found == wheels_.end() || !place)
            continue;
        // X counts turns towards the user.
        auto& [increment, last] = found->second;
        if (last)
            turn.notches -= (number(*place) - *last) / increment;
        last = number(*place);
    }
    return turn;
}

} // namespace l3d_detail
