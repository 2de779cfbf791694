// SPDX-License-Identifier: MIT
// reason_of: gives an exception's reason in words for the user.
#include "system/reason_p.h"

#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

namespace l3d_detail {

std::string reason_of(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error))
        return "there is not enough memory";
    if (dynamic_cast<const std::length_error*>(&error))
        return "something is larger than memory can hold";
    if (const auto* file = dynamic_cast<const std::filesystem::filesystem_error*>(&error))
        return (file->path1().empty() ? "" : file->path1().string() + ": ") +
               file->code().message();
    if (const auto* system = dynamic_cast<const std::system_error*>(&error))
        return system->code().message();
    return error.what();
}

} // namespace l3d_detail
