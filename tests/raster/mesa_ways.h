// SPDX-License-Identifier: MIT
// Tests that run once by every way to GL.
#ifndef L3D_TESTS_RASTER_MESA_WAYS_H
#define L3D_TESTS_RASTER_MESA_WAYS_H

#include "tool_2d/mesa/mesa_context_p.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

/// The test fails where a way that the test packages install is not there.
inline std::unique_ptr<l3d_detail::mesa_context> open_mesa(l3d_detail::mesa_way way) {
    std::string why;
    auto context = l3d_detail::mesa_context::open(way, why);
    if (!context)
        ADD_FAILURE() << l3d_detail::name_of(way) << ": " << why;
    return context;
}

/// The way without blanks, which GoogleTest does not want in names.
inline std::string test_name_of(const testing::TestParamInfo<l3d_detail::mesa_way>& way) {
    std::string name = l3d_detail::name_of(way.param);
    std::erase(name, ' ');
    return name;
}

#endif
