// SPDX-License-Identifier: MIT
// l3d_error: the library's exception for a program that cannot go on. It is never thrown while a
// program draws.
#ifndef L3D_BASE_ERROR_H
#define L3D_BASE_ERROR_H

#include "base/public.h"

#include <stdexcept>
#include <string>

/// Exit codes of every program; each l3d_error carries one.
enum class L3D_PUBLIC l3d_exit : int {
    success = 0,      ///< the program did what it was asked
    failure = 1,      ///< the system refused something, such as writing a file
    usage = 2,        ///< an option or a value is not right
    no_display = 3,   ///< no display can be opened
    no_backend = 4,   ///< no back-end can serve here
    bad_input = 5,    ///< a file has wrong contents
    display_lost = 6, ///< the display went away
};

/// Thrown when a program cannot go on; the text names the file, line, option or value at fault.
class L3D_PUBLIC l3d_error : public std::runtime_error {
public:
    /// An error with this text, and the exit code that the program ends with.
    l3d_error(l3d_exit code, const std::string& text) : std::runtime_error(text), code_(code) {}
    /// The exit code that main returns.
    l3d_exit code() const { return code_; }

private:
    l3d_exit code_;
};

#endif
