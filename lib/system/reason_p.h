// SPDX-License-Identifier: MIT
// reason_of: describes any exception in words that users understand.
#ifndef L3D_SYSTEM_REASON_P_H
#define L3D_SYSTEM_REASON_P_H

#include <exception>
#include <string>

namespace l3d_detail {

/// The reason of a failure, in words for users. The library's own errors carry such a reason.
/// Errors of the standard library name its functions and types, which help no user.
std::string reason_of(const std::exception& error);

} // namespace l3d_detail

#endif
