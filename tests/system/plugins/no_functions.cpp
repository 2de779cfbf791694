// SPDX-License-Identifier: MIT
// A plug-in with nothing behind its interface.
#include <l3d/object_plugin.h>

extern "C" const l3d_plugin_interface l3d_plugin;
const l3d_plugin_interface l3d_plugin{
    sizeof(l3d_plugin_interface), L3D_PLUGIN_VERSION, nullptr, nullptr, nullptr, nullptr};
