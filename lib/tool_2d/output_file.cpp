// SPDX-License-Identifier: MIT
// output_file: temporary name, checked close, rename.
#include "tool_2d/output_file_p.h"

#include "tool_2d/error.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <unistd.h>

namespace l3d_detail {

void throw_write_error(const std::string& path) {
    throw l3d_error(l3d_exit::failure, path + ": " + std::strerror(errno));
}

output_file::output_file(const std::string& path) : path_(path), target_(path) {
    std::error_code absent;
    const auto existing = std::filesystem::canonical(path, absent);
    if (!absent)
        target_ = existing.string();
    const bool replaceable = absent || std::filesystem::is_regular_file(existing, absent);
    temporary_ = replaceable ? target_ + ".part" + std::to_string(getpid()) : target_;
    file_.reset(std::fopen(temporary_.c_str(), "wb"));
    if (!file_)
        throw_write_error(path_);
}

output_file::~output_file() {
    if (!committed_ && temporary_ != target_)
        std::remove(temporary_.c_str());
}

void output_file::commit() {
    // The rest of the buffer is written now, and may find the disk full.
    if (std::fclose(file_.release()) != 0)
        throw_write_error(path_);
    if (temporary_ != target_ && std::rename(temporary_.c_str(), target_.c_str()) != 0)
        throw_write_error(path_);
    committed_ = true;
}

} // namespace l3d_detail
