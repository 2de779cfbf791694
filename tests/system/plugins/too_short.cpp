// SPDX-License-Identifier: MIT
// A plug-in whose interface ends before its functions.
#include <l3d/object_plugin.h>

extern "C" const l3d_plugin_interface l3d_plugin;
const l3d_plugin_interface l3d_plugin{8, L3D_PLUGIN_VERSION, nullptr, nullptr, nullptr, nullptr};
