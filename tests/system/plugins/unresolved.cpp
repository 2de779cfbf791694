// SPDX-License-Identifier: MIT
// A plug-in that calls what nobody defines.
#include <l3d/object_plugin.h>

extern "C" void l3d_nobody_defines_this(void* data, double seconds);

extern "C" const l3d_plugin_interface l3d_plugin;
const l3d_plugin_interface l3d_plugin{sizeof(l3d_plugin_interface),
                                      L3D_PLUGIN_VERSION,
                                      nullptr,
                                      l3d_nobody_defines_this,
                                      nullptr,
                                      nullptr};
