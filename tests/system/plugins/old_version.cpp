// SPDX-License-Identifier: MIT
// A plug-in of a version that never was.
#include <l3d/object_plugin.h>

extern "C" const l3d_plugin_interface l3d_plugin;
const l3d_plugin_interface l3d_plugin{
    sizeof(l3d_plugin_interface), 99, nullptr, nullptr, nullptr, nullptr};
