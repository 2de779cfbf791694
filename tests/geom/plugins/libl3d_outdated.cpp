// SPDX-License-Identifier: MIT
// A plug-in whose interface has version 7 and 8 bytes, for the test of what refuses it.
extern "C" {
extern const unsigned l3d_outdated_plugin[2];
const unsigned l3d_outdated_plugin[2] = {7, 8};
}
