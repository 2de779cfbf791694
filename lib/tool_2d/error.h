// SPDX-License-Identifier: MIT
// l3d_error: the only exception type the library throws, and only while setting up.
#ifndef L3D_TOOL_2D_ERROR_H
#define L3D_TOOL_2D_ERROR_H

#include "base/public.h"

#include <stdexcept>
#include <string>

/// Exit codes of every program; an l3d_error carries the one its program ends with.
enum class L3D_PUBLIC l3d_exit : int {
    well = 0,
    failure = 1,
    usage = 2,
    no_display = 3,
    no_backend = 4,
    bad_input = 5,
    display_lost = 6,
};

/// Thrown when a program cannot go on; the text names the file, line, option or value at fault.
class L3D_PUBLIC l3d_error : public std::runtime_error {
public:
    /// An error for this reason, and the exit code that the program ends with.
    l3d_error(l3d_exit code, const std::string& text) : std::runtime_error(text), code_(code) {}
    /// The exit code that main returns.
    l3d_exit code() const { return code_; }

private:
    l3d_exit code_;
};

#endif
