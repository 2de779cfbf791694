// SPDX-License-Identifier: MIT
// mesa_context: tries one library after the other, and checks the abilities of the context.
#include "tool_2d/mesa/mesa_context_p.h"

#include <algorithm>
#include <cstdlib>

namespace l3d_detail {

namespace {

std::unique_ptr<mesa_platform> open_platform(mesa_way way, std::string& why) {
    switch (way) {
    case mesa_way::egl_surfaceless:
        return open_mesa_egl_surfaceless(why);
    case mesa_way::egl_device:
        return open_mesa_egl_device(why);
    case mesa_way::osmesa:
        return open_mesa_osmesa(why);
    }
    return nullptr;
}

std::string wished_way() {
    const char* const value = std::getenv("L3D_MESA");
    return value && *value ? value : "auto";
}

} // namespace

const char* name_of(mesa_way way) {
    switch (way) {
    case mesa_way::egl_surfaceless:
        return "EGL surfaceless";
    case mesa_way::egl_device:
        return "EGL software device";
    case mesa_way::osmesa:
        return "OSMesa";
    }
    return "";
}

const char* packages_of(mesa_way way) {
    return way == mesa_way::osmesa ? "install libosmesa6 (Mesa before 25.1)"
                                   : "install libegl1 libegl-mesa0 libgl1-mesa-dri";
}

bool may_try(mesa_way way, const std::string& wish) {
    const std::string meant = wish.empty() ? wished_way() : wish;
    return meant == "auto" || meant == (way == mesa_way::osmesa ? "osmesa" : "egl");
}

bool is_software_renderer(std::string_view renderer) {
    // The driver swrast called itself "Software Rasterizer".
    constexpr std::array names{"llvmpipe", "softpipe", "swrast", "Software Rasterizer"};
    return std::ranges::any_of(names, [renderer](const char* name) {
        return renderer.find(name) != std::string_view::npos;
    });
}

bool mesa_context::load(std::string& why) {
    const char* const missing =
        gl_.load([this](const char* name) { return platform_->find(name); });
    if (missing) {
        why = std::string("no ") + missing;
        return false;
    }
    const auto text = [this](GLenum name) {
        const auto* const found = reinterpret_cast<const char*>(gl_.GetString(name));
        return std::string(found ? found : "");
    };
    renderer_ = text(GL_RENDERER);
    if (!is_software_renderer(renderer_)) {
        why = "the renderer '" + renderer_ + "' is not software";
        return false;
    }
    const std::string version = text(GL_VERSION);
    if (std::atoi(version.c_str()) < 3) { // older GL lacks framebuffer objects and depth in float
        why = "GL '" + version + "' is older than 3.0";
        return false;
    }
    return true;
}

std::unique_ptr<mesa_context> mesa_context::open(mesa_way way, std::string& why) {
    auto platform = open_platform(way, why);
    if (!platform)
        return nullptr;
    std::unique_ptr<mesa_context> context(new mesa_context(std::move(platform), way));
    return context->load(why) ? std::move(context) : nullptr;
}

std::unique_ptr<mesa_context> mesa_context::open(const std::string& wish, std::string& why) {
    const auto is_wished = [&wish](mesa_way way) { return may_try(way, wish); };
    if (std::ranges::none_of(mesa_ways, is_wished)) {
        why = (wish.empty() ? "L3D_MESA: '" + wished_way() : "GL by '" + wish) +
              "' is none of auto egl osmesa";
        return nullptr;
    }
    std::string reasons;
    for (const mesa_way way : mesa_ways) {
        if (!is_wished(way))
            continue;
        std::string reason;
        if (auto context = open(way, reason))
            return context;
        if (reasons.find(reason) == std::string::npos) // both ways of EGL may lack its library
            reasons += std::string("; ") + name_of(way) + ": " + reason;
    }
    why = std::string("no software GL; ") + packages_of(mesa_way::egl_surfaceless) +
          " or libosmesa6" + reasons;
    return nullptr;
}

} // namespace l3d_detail
