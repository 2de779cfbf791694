// SPDX-License-Identifier: MIT
// The mesa screens: a window where there is a display, else pixels that nobody sees.
#include "tool_2d/mesa/screen_mesa.h"

#include "xvfb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace {

using level = l3d_service::level;
using verdict = l3d_probe::verdict;

class mesa_screen : public testing::Test {
protected:
    mesa_screen() {
        unsetenv("DISPLAY");
        unsetenv("L3D_MESA");
    }
    ~mesa_screen() override { unsetenv("L3D_MESA"); }

    l3d_screen_factory_mesa factory;
    l3d_screen_request request{.size = {67, 41}, .title = "mesa"};
};

TEST_F(mesa_screen, ServesUnseenWithoutADisplay) {
    const l3d_service service = factory.service();
    EXPECT_EQ(service.how, level::fully) << service.why;
    EXPECT_FALSE(service.is_seen);
    l3d_service refusal;
    const auto screen = factory.create(request, refusal);
    ASSERT_TRUE(screen) << refusal.why;
    EXPECT_FALSE(screen->is_window());
    EXPECT_EQ(screen->pixels().size(), request.size);
}

TEST_F(mesa_screen, ServesInAWindowOnADisplay) {
    const xvfb server("320x200x24");
    ASSERT_TRUE(server.started());
    EXPECT_TRUE(factory.service().is_seen);
    l3d_service refusal;
    const auto screen = factory.create(request, refusal);
    ASSERT_TRUE(screen) << refusal.why;
    EXPECT_TRUE(screen->is_window());
}

TEST_F(mesa_screen, SaysWhyThereIsNoGl) {
    setenv("L3D_MESA", "vulkan", 1);
    const l3d_service service = factory.service();
    EXPECT_EQ(service.how, level::not_here);
    EXPECT_EQ(service.why, "L3D_MESA: 'vulkan' is none of auto egl osmesa");
}

TEST_F(mesa_screen, DiagnosesEveryWay) {
    l3d_probes probes;
    factory.diagnose(probes);
    ASSERT_EQ(probes.size(), 3u);
    EXPECT_EQ(probes[0].what, "EGL surfaceless");
    EXPECT_EQ(probes[1].what, "EGL software device");
    EXPECT_EQ(probes[2].what, "OSMesa");
    for (const l3d_probe& probe : probes) {
        EXPECT_EQ(probe.outcome, verdict::good) << probe.what;
        EXPECT_NE(probe.result.find("llvmpipe"), std::string::npos) << probe.result;
        EXPECT_TRUE(probe.remedy.empty());
    }
    setenv("L3D_MESA", "osmesa", 1);
    probes.clear();
    factory.diagnose(probes);
    EXPECT_EQ(probes[0].result, "left out by L3D_MESA=osmesa");
    EXPECT_EQ(probes[1].outcome, verdict::limited);
    EXPECT_EQ(probes[2].outcome, verdict::good);
}

} // namespace
