// SPDX-License-Identifier: MIT
// x11_window: sets its attributes and its properties.
#include "tool_2d/x11/x11_window_p.h"

#include "tool_2d/x11_window/x11_resolution_p.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <utility>
#include <vector>

#include <png.h>
#include <unistd.h>

#include <X11/Xatom.h>
#include <X11/Xutil.h>

namespace l3d_detail {
namespace {

x11_atoms intern_atoms(Display* display) {
    constexpr std::array names{"WM_PROTOCOLS", "WM_DELETE_WINDOW", "_NET_WM_PING", "_NET_WM_NAME",
                               "UTF8_STRING"};
    std::array<Atom, names.size()> atoms{};
    XInternAtoms(display, const_cast<char**>(names.data()), static_cast<int>(names.size()), False,
                 atoms.data());
    return {atoms[0], atoms[1], atoms[2], atoms[3], atoms[4]};
}

constexpr long events_always = KeyPressMask | KeyReleaseMask | ButtonPressMask | ButtonReleaseMask |
                               Button1MotionMask | Button2MotionMask | Button3MotionMask |
                               StructureNotifyMask | ExposureMask | VisibilityChangeMask |
                               FocusChangeMask | PropertyChangeMask;

l3d_service too_large(l3d_size size, int scale) {
    return {l3d_service::level::not_here,
            "the X server does not make a window of " + std::to_string(size.width) + "x" +
                std::to_string(size.height) +
                (scale == 1 ? "" : " at scale " + std::to_string(scale))};
}

constexpr unsigned char icon_file[] = {
#include "packaging/desktop/icon.png.bytes"
};

/// The library's icon for desktops, in the form of _NET_WM_ICON. Its numbers are width, height, and
/// 0xAARRGGBB for each pixel from the top left on. Each number is a long, whatever size a long has.
/// Source:  Extended Window Manager Hints, 1.3.
std::vector<long> icon() {
    png_image picture{};
    picture.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&picture, icon_file, sizeof icon_file) == 0)
        return {};
    picture.format = PNG_FORMAT_RGBA;
    std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(picture));
    if (png_image_finish_read(&picture, nullptr, bytes.data(), 0, nullptr) == 0)
        return {};
    std::vector<long> words{static_cast<long>(picture.width), static_cast<long>(picture.height)};
    for (std::size_t i = 0; i < bytes.size(); i += 4)
        words.push_back(static_cast<long>(bytes[i + 3]) << 24 | static_cast<long>(bytes[i]) << 16 |
                        static_cast<long>(bytes[i + 1]) << 8 | static_cast<long>(bytes[i + 2]));
    return words;
}

} // namespace

std::unique_ptr<x11_window> x11_window::open(std::unique_ptr<x11_connection> connection,
                                             const x11_visual& visual,
                                             const l3d_screen_request& request,
                                             l3d_service& refusal) {
    assert(request.size.width >= 1 && request.size.height >= 1);
    const int scale = x11_scale(request);
    const l3d_size size = x11_picture_size(*connection, request);
    if (std::max(size.width, size.height) > largest_x11_side / scale) {
        refusal = too_large(request.size, scale);
        return nullptr;
    }
    auto colormap = x11_colormap::make(*connection, visual, refusal);
    if (!colormap)
        return nullptr;
    std::unique_ptr<x11_window> window(
        new x11_window(std::move(connection), std::move(colormap), visual, scale));
    const l3d_size native{size.width * scale, size.height * scale};
    const x11_error_trap trap(window->connection());
    window->create(native);
    window->set_names(request);
    window->set_hints(native);
    window->set_protocols();
    window->managed_ = has_x11_manager(window->connection());
    if (window->connection().lost()) {
        refusal = {l3d_service::level::display_lost, x11_server_went_away};
        return nullptr;
    }
    if (trap.error() != 0) {
        refusal = too_large(request.size, scale);
        return nullptr;
    }
    return window;
}

x11_window::x11_window(std::unique_ptr<x11_connection> connection,
                       std::unique_ptr<x11_colormap> colormap, const x11_visual& visual, int scale)
    : connection_(std::move(connection)), colormap_(std::move(colormap)), visual_(visual),
      atoms_(intern_atoms(display())), scale_(scale) {
    set_fineness(x11_fineness(*connection_));
}

x11_window::~x11_window() {
    const bool is_own = graphics_ != DefaultGC(display(), connection_->screen());
    if (connection_->lost()) {
        if (is_own)
            XFree(graphics_); // frees only Xlib's record of it, as there is no server to tell
        return;
    }
    if (is_own)
        XFreeGC(display(), graphics_);
    XDestroyWindow(display(), window_);
}

void x11_window::create(l3d_size native) {
    const auto root = connection_->root();
    XSetWindowAttributes attributes{};
    attributes.colormap = colormap_->id();
    // The border's pixel is not inherited: a parent of another depth has none that fits.
    attributes.border_pixel = 0;
    attributes.background_pixel = ground_ = info().to_display(0);
    // The picture stays when the window grows, and only new parts show the ground.
    attributes.bit_gravity = NorthWestGravity;
    attributes.event_mask = events_always;
    window_ = XCreateWindow(
        display(), root, 0, 0, static_cast<unsigned>(native.width),
        static_cast<unsigned>(native.height), 0, visual_.layout.depth, InputOutput, visual(),
        CWColormap | CWBorderPixel | CWBackPixel | CWBitGravity | CWEventMask, &attributes);
    // Each display comes with a graphics context for its usual depth.
    const bool is_usual = visual_.layout.depth == DefaultDepth(display(), connection_->screen());
    graphics_ = is_usual ? DefaultGC(display(), connection_->screen())
                         : XCreateGC(display(), window_, 0, nullptr);
}

void x11_window::set_property(Atom name, Atom type, int format, const void* data,
                              std::size_t count) const {
    XChangeProperty(display(), window_, name, type, format, PropModeReplace,
                    static_cast<const unsigned char*>(data), static_cast<int>(count));
}

/// Sets the title, in the property of today's managers and in the old one. The old property is in
/// Latin-1 if Latin-1 can hold the title, else in an encoding that Xlib chooses.
void x11_window::set_title(std::string title) {
    set_property(atoms_.net_wm_name, atoms_.utf8_string, 8, title.data(), title.size());
    XTextProperty old_name{};
    char* list = title.data();
    if (Xutf8TextListToTextProperty(display(), &list, 1, XStdICCTextStyle, &old_name) >= Success) {
        XSetWMName(display(), window_, &old_name);
        XFree(old_name.value);
    }
}

// Sets the window's names one by one. XSetWMProperties would set more. Each property is a request,
// and a slow display's start is the sum of its requests.
void x11_window::set_names(const l3d_screen_request& request) {
    set_title(request.title);
    std::string instance = request.name, class_name = "L3d";
    XClassHint names{instance.data(), class_name.data()};
    XSetClassHint(display(), window_, &names);
    // Managers write another machine's name into the title if they know it in time.
    if (!connection_->is_local())
        set_machine();
}

void x11_window::set_machine() const {
    std::array<char, 256> machine{}; // POSIX: a host's name has at most 255 bytes.
    gethostname(machine.data(), machine.size() - 1);
    set_property(XA_WM_CLIENT_MACHINE, XA_STRING, 8, machine.data(),
                 std::string_view(machine.data()).size());
}

void x11_window::set_process_and_icon(Atom net_wm_pid, Atom net_wm_icon) const {
    if (connection_->is_local())
        set_machine(); // without it, the number of the process means nothing
    const long process = getpid();
    set_property(net_wm_pid, XA_CARDINAL, 32, &process, 1);
    const auto words = icon();
    set_property(net_wm_icon, XA_CARDINAL, 32, words.data(), words.size());
}

void x11_window::set_hints(l3d_size native) {
    XSizeHints size{};
    size.flags = PSize | PMinSize;
    size.width = native.width;
    size.height = native.height;
    size.min_width = 1;
    size.min_height = 1;
    XSetWMNormalHints(display(), window_, &size);
    XWMHints hints{};
    hints.flags = InputHint | StateHint;
    hints.input = True;
    hints.initial_state = NormalState;
    XSetWMHints(display(), window_, &hints);
}

void x11_window::set_protocols() {
    const std::array protocols{atoms_.wm_delete_window, atoms_.net_wm_ping};
    set_property(atoms_.wm_protocols, XA_ATOM, 32, protocols.data(), protocols.size());
}

bool x11_window::set_fineness(double fineness) {
    const double text_scale = std::max(1.0, fineness / scale_);
    return std::exchange(text_scale_, text_scale) != text_scale;
}

void x11_window::set_ground(std::uint32_t word) {
    const unsigned long pixel = info().to_display(word);
    if (std::exchange(ground_, pixel) != pixel)
        XSetWindowBackground(display(), window_, pixel);
}

void x11_window::watch_pointer(watcher who, bool always) {
    const auto bit = static_cast<unsigned>(who);
    const bool was_watched = watchers_ != 0;
    watchers_ = always ? watchers_ | bit : watchers_ & ~bit;
    if (was_watched != (watchers_ != 0))
        XSelectInput(display(), window_,
                     watchers_ != 0 ? events_always | PointerMotionMask : events_always);
}

Cursor x11_window::make_empty_cursor() const {
    const char no_bits = 0;
    const Pixmap shape = XCreateBitmapFromData(display(), window_, &no_bits, 1, 1);
    XColor black{};
    const Cursor cursor = XCreatePixmapCursor(display(), shape, shape, &black, &black, 0, 0);
    XFreePixmap(display(), shape);
    return cursor;
}

void x11_window::take_focus() {
    XSetInputFocus(display(), window_, RevertToParent, CurrentTime);
    colormap_->install();
}

} // namespace l3d_detail
