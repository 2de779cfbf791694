// SPDX-License-Identifier: MIT
// A shared library that defines no plug-in.
extern "C" {
extern const int l3d_something_else;
const int l3d_something_else = 1;
}
