// SPDX-License-Identifier: MIT
// open_mesa_osmesa: makes a context by libOSMesa.
#include "tool_2d/mesa/mesa_gl_p.h"
#include "tool_2d/mesa/mesa_library_p.h"
#include "tool_2d/mesa/mesa_osmesa_p.h"
#include "tool_2d/mesa/mesa_platform_p.h"

#include <array>
#include <cstdint>

namespace {

using namespace l3d_detail;

struct osmesa_calls {
    osmesa::create_context_ext* create = nullptr;
    osmesa::destroy_context* destroy = nullptr;
    osmesa::make_current* make_current = nullptr;
    osmesa::get_current_context* current = nullptr;
    osmesa::get_proc_address* find = nullptr;

    bool load(const mesa_library& library) {
        return library.find(create, "OSMesaCreateContextExt") &&
               library.find(destroy, "OSMesaDestroyContext") &&
               library.find(make_current, "OSMesaMakeCurrent") &&
               library.find(current, "OSMesaGetCurrentContext") &&
               library.find(find, "OSMesaGetProcAddress");
    }
};

class osmesa_platform final : public mesa_platform {
public:
    explicit osmesa_platform(const osmesa_calls& calls)
        : calls_(calls), context_(calls.create(osmesa::bgra, 0, 0, 0, nullptr)) {}

    ~osmesa_platform() override {
        if (!context_)
            return;
        if (calls_.current() == context_)
            calls_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        calls_.destroy(context_);
    }

private:
    bool do_make_current() override {
        return context_ &&
               calls_.make_current(context_, words_.data(), GL_UNSIGNED_BYTE, side, side);
    }
    void* do_find(const char* name) override { return reinterpret_cast<void*>(calls_.find(name)); }

    /// The side of the picture that OSMesa wants in memory. We draw into a framebuffer object
    /// instead, as with EGL.
    static constexpr int side = 4;

    osmesa_calls calls_;
    osmesa::context context_;
    std::array<std::uint32_t, std::size_t{side} * side> words_{};
};

} // namespace

std::unique_ptr<mesa_platform> l3d_detail::open_mesa_osmesa(std::string& why) {
    const mesa_library library({"libOSMesa.so.8", "libOSMesa.so.6"});
    if (why = library.problem(); !why.empty())
        return nullptr;
    osmesa_calls calls;
    if (!calls.load(library)) {
        why = "libOSMesa lacks a call";
        return nullptr;
    }
    auto platform = std::make_unique<osmesa_platform>(calls);
    if (platform->make_current())
        return platform;
    why = "libOSMesa makes no context";
    return nullptr;
}
