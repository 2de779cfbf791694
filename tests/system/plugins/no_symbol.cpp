// SPDX-License-Identifier: MIT
// A shared library that is no plug-in.

extern "C" int l3d_is_no_plugin();
extern "C" int l3d_is_no_plugin() {
    return 7;
}
