// SPDX-License-Identifier: MIT
// reason_of: describes any exception in words that users understand.
#ifndef L3D_SYSTEM_REASON_P_H
#define L3D_SYSTEM_REASON_P_H

#include <exception>
#include <string>

namespace l3d_detail {

/// The reason of an error, in words for users. l3d's own errors have such words. Errors of the
/// standard library name C++ functions and types, which help no user, so this function has words of
/// its own for these errors.
std::string reason_of(const std::exception& error);

} // namespace l3d_detail

#endif
