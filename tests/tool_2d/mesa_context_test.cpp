// SPDX-License-Identifier: MIT
// Contexts by every way, the choice among them, and what counts as software.
#include "tool_2d/mesa/mesa_context_p.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>
#include <thread>

namespace {

using namespace l3d_detail;

/// A value of an environment variable while it lives; null takes the variable away.
class environment {
public:
    environment(const char* variable, const char* value) : variable_(variable) {
        if (const char* const before = std::getenv(variable))
            before_ = before;
        set(value);
    }
    environment(const environment&) = delete;
    environment& operator=(const environment&) = delete;
    ~environment() { set(before_ ? before_->c_str() : nullptr); }

private:
    void set(const char* value) const {
        if (value)
            setenv(variable_, value, 1);
        else
            unsetenv(variable_);
    }

    const char* variable_;
    std::optional<std::string> before_;
};

TEST(MesaContext, IsSoftwareByEveryWay) {
    for (const mesa_way way : mesa_ways) {
        std::string why;
        const auto context = mesa_context::open(way, why);
        ASSERT_TRUE(context) << name_of(way) << ": " << why;
        EXPECT_EQ(context->way(), way);
        EXPECT_TRUE(is_software_renderer(context->renderer())) << context->renderer();
        EXPECT_EQ(context->make_current().GetError(), unsigned{GL_NO_ERROR});
    }
}

TEST(MesaContext, KnowsSoftwareByItsName) {
    for (const char* name : {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Software Rasterizer",
                             "zink Vulkan 1.3(llvmpipe (LLVM 19.1.7, 256 bits))"})
        EXPECT_TRUE(is_software_renderer(name)) << name;
    for (const char* name :
         {"", "NVIDIA GeForce RTX 3060/PCIe/SSE2", "Mesa Intel(R) UHD Graphics (CML GT2)",
          "AMD Radeon RX 6600 (radeonsi, navi23, LLVM 15.0.6, DRM 3.49)", "virgl", "V3D 4.2"})
        EXPECT_FALSE(is_software_renderer(name)) << name;
}

TEST(MesaContext, IsChosenByTheEnvironment) {
    const auto way_of = [](const char* value) -> std::optional<mesa_way> {
        const environment scope("L3D_MESA", value);
        std::string why;
        const auto context = mesa_context::open("", why);
        return context ? std::optional(context->way()) : std::nullopt;
    };
    EXPECT_EQ(way_of(nullptr), mesa_way::egl_surfaceless);
    EXPECT_EQ(way_of(""), mesa_way::egl_surfaceless);
    EXPECT_EQ(way_of("auto"), mesa_way::egl_surfaceless);
    EXPECT_EQ(way_of("egl"), mesa_way::egl_surfaceless);
    EXPECT_EQ(way_of("osmesa"), mesa_way::osmesa);
}

TEST(MesaContext, RefusesAnUnknownChoiceByName) {
    const environment scope("L3D_MESA", "glx");
    std::string why;
    EXPECT_FALSE(mesa_context::open("", why));
    EXPECT_EQ(why, "L3D_MESA: 'glx' is none of auto egl osmesa");
}

TEST(MesaContext, LeavesTheUsersVariablesAlone) {
    for (const char* value : {static_cast<const char*>(nullptr), "0", "true"}) {
        const environment scope("LIBGL_ALWAYS_SOFTWARE", value);
        for (const mesa_way way : mesa_ways) {
            std::string why;
            const auto context = mesa_context::open(way, why);
            const char* const after = std::getenv("LIBGL_ALWAYS_SOFTWARE");
            EXPECT_STREQ(after, value) << name_of(way);
        }
    }
}

TEST(MesaContext, HasStateOfItsOwn) {
    for (const mesa_way way : mesa_ways) {
        std::string why;
        const auto one = mesa_context::open(way, why), other = mesa_context::open(way, why);
        ASSERT_TRUE(one && other) << why;
        unsigned texture = 0, again = 0;
        one->make_current().GenTextures(1, &texture);
        other->make_current().GenTextures(1, &again);
        EXPECT_EQ(texture, again) << name_of(way); // the first name of each
        one->make_current().GenTextures(1, &again);
        EXPECT_NE(texture, again) << name_of(way);
    }
}

TEST(MesaContext, MayEndBeforeAnotherOfItsKind) {
    for (const mesa_way way : mesa_ways) {
        std::string why;
        const auto stays = mesa_context::open(way, why);
        ASSERT_TRUE(stays) << why;
        ASSERT_TRUE(mesa_context::open(way, why)) << why; // ends at once
        const auto& gl = stays->make_current();
        EXPECT_NE(gl.GetString(GL_RENDERER), nullptr) << name_of(way);
        EXPECT_EQ(gl.GetError(), unsigned{GL_NO_ERROR});
    }
}

TEST(MesaContext, ServesAThreadOfItsOwn) {
    std::string why;
    const auto here = mesa_context::open("", why);
    ASSERT_TRUE(here) << why;
    std::string renderer;
    std::thread([&renderer] {
        std::string reason;
        if (const auto there = mesa_context::open("", reason))
            renderer = there->renderer();
    }).join();
    EXPECT_EQ(renderer, here->renderer());
}

} // namespace
