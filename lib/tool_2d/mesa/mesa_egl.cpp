// SPDX-License-Identifier: MIT
// open_mesa_egl_surfaceless, open_mesa_egl_device: make contexts by libEGL, on the CPU.
#include "tool_2d/mesa/mesa_egl_p.h"
#include "tool_2d/mesa/mesa_library_p.h"
#include "tool_2d/mesa/mesa_platform_p.h"

#include <array>
#include <cstdlib>
#include <span>
#include <sstream>

namespace {

using namespace l3d_detail;

struct egl_calls {
    egl::get_platform_display* get_platform_display = nullptr;
    egl::initialize* initialize = nullptr;
    egl::query_string* query_string = nullptr;
    egl::bind_api* bind_api = nullptr;
    egl::create_context* create_context = nullptr;
    egl::destroy_context* destroy_context = nullptr;
    egl::make_current* make_current = nullptr;
    egl::get_current_context* current = nullptr;
    egl::get_error* error = nullptr;
    egl::get_proc_address* find = nullptr;

    /// Finds the functions of libEGL.
    /// Errors:  false, with the reason in `why`.
    bool load(std::string& why) {
        const mesa_library library({"libEGL.so.1"});
        if (why = library.problem(); !why.empty())
            return false;
        const bool all =
            library.find(get_platform_display, "eglGetPlatformDisplay") &&
            library.find(initialize, "eglInitialize") &&
            library.find(query_string, "eglQueryString") && library.find(bind_api, "eglBindAPI") &&
            library.find(create_context, "eglCreateContext") &&
            library.find(destroy_context, "eglDestroyContext") &&
            library.find(make_current, "eglMakeCurrent") &&
            library.find(current, "eglGetCurrentContext") && library.find(error, "eglGetError") &&
            library.find(find, "eglGetProcAddress");
        if (!all)
            why = "libEGL is older than EGL 1.5";
        return all;
    }

    /// The text of a failure: "<call>: EGL error 0x3001".
    std::string failed(const char* call) const {
        std::ostringstream text;
        text << call << ": EGL error 0x" << std::hex << error();
        return text.str();
    }
};

/// Whether a list of words, separated by blanks, holds a word. A null list holds none.
bool lists(const char* list, std::string_view word) {
    std::istringstream words(list ? list : "");
    for (std::string each; words >> each;)
        if (each == word)
            return true;
    return false;
}

/// Keeps Mesa from looking for graphics cards while an object of this class lives, unless the user
/// has set the variable.
class software_only {
public:
    software_only() : ours_(!std::getenv(variable)) {
        if (ours_)
            setenv(variable, "1", 1);
    }
    software_only(const software_only&) = delete;
    software_only& operator=(const software_only&) = delete;
    ~software_only() {
        if (ours_)
            unsetenv(variable);
    }

private:
    static constexpr const char* variable = "LIBGL_ALWAYS_SOFTWARE";
    bool ours_;
};

/// A display of EGL. All users of EGL in this process share the display. So the display is not
/// terminated, since their use would end with ours.
class egl_platform final : public mesa_platform {
public:
    egl_platform(const egl_calls& calls, egl::display display, egl::context context)
        : calls_(calls), display_(display), context_(context) {}

    ~egl_platform() override {
        if (calls_.current() == context_)
            calls_.make_current(display_, nullptr, nullptr, nullptr);
        calls_.destroy_context(display_, context_);
    }

private:
    bool do_make_current() override {
        return calls_.make_current(display_, nullptr, nullptr, context_);
    }
    void* do_find(const char* name) override { return reinterpret_cast<void*>(calls_.find(name)); }

    egl_calls calls_;
    egl::display display_;
    egl::context context_;
};

/// Opens a display with a context that needs no surface, and makes it current.
/// Errors:  null, with the reason in `why`.
std::unique_ptr<mesa_platform> open_display(const egl_calls& calls, egl::display display,
                                            std::string& why) {
    int major = 0, minor = 0;
    if (!display || !calls.initialize(display, &major, &minor)) {
        why = calls.failed("eglInitialize");
        return nullptr;
    }
    const char* const extensions = calls.query_string(display, egl::extensions);
    for (const char* needed : {"EGL_KHR_surfaceless_context", "EGL_KHR_no_config_context"})
        if (!lists(extensions, needed)) {
            why = std::string("no ") + needed;
            return nullptr;
        }
    if (!calls.bind_api(egl::opengl_api)) {
        why = calls.failed("eglBindAPI");
        return nullptr;
    }
    const int no_attributes = egl::none;
    const egl::context context = calls.create_context(display, nullptr, nullptr, &no_attributes);
    if (!context) {
        why = calls.failed("eglCreateContext");
        return nullptr;
    }
    auto platform = std::make_unique<egl_platform>(calls, display, context);
    if (platform->make_current())
        return platform;
    why = calls.failed("eglMakeCurrent");
    return nullptr;
}

/// Finds the device that draws on the CPU.
/// Errors:  null, with the reason in `why`.
egl::device software_device(const egl_calls& calls, std::string& why) {
    const auto query_devices =
        reinterpret_cast<egl::query_devices*>(calls.find("eglQueryDevicesEXT"));
    const auto query_string =
        reinterpret_cast<egl::query_device_string*>(calls.find("eglQueryDeviceStringEXT"));
    std::array<egl::device, 16> devices{};
    int count = 0;
    if (!query_devices || !query_string ||
        !query_devices(static_cast<int>(devices.size()), devices.data(), &count)) {
        why = "libEGL lists no devices";
        return nullptr;
    }
    for (const egl::device device : std::span(devices).first(static_cast<std::size_t>(count)))
        if (lists(query_string(device, egl::extensions), "EGL_MESA_device_software"))
            return device;
    why = "none of " + std::to_string(count) + " EGL devices has EGL_MESA_device_software";
    return nullptr;
}

} // namespace

std::unique_ptr<mesa_platform> l3d_detail::open_mesa_egl_surfaceless(std::string& why) {
    egl_calls calls;
    if (!calls.load(why))
        return nullptr;
    if (!lists(calls.query_string(nullptr, egl::extensions), "EGL_MESA_platform_surfaceless")) {
        why = "no EGL_MESA_platform_surfaceless";
        return nullptr;
    }
    const software_only scope;
    return open_display(
        calls, calls.get_platform_display(egl::platform_surfaceless, nullptr, nullptr), why);
}

std::unique_ptr<mesa_platform> l3d_detail::open_mesa_egl_device(std::string& why) {
    egl_calls calls;
    if (!calls.load(why))
        return nullptr;
    const egl::device device = software_device(calls, why);
    if (!device)
        return nullptr;
    const software_only scope;
    return open_display(calls, calls.get_platform_display(egl::platform_device, device, nullptr),
                        why);
}
