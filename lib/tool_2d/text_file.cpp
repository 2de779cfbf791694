// SPDX-License-Identifier: MIT
// l3d_read_text_file: by standard streams.
#include "tool_2d/text_file.h"

#include "tool_2d/error.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

std::string l3d_read_text_file(const std::string& path) {
    const auto refuse = [&path]() {
        throw l3d_error(l3d_exit::bad_input, path + ": " + std::strerror(errno ? errno : EIO));
    };
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file)
        refuse();
    std::ostringstream text;
    text << file.rdbuf();
    // A folder opens like a file and fails only when read.
    if (errno == EISDIR || file.bad() || text.bad())
        refuse();
    return text.str();
}
