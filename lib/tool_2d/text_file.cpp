// SPDX-License-Identifier: MIT
// l3d_read_text_file: checks sizes before it takes memory, and never waits without an end.
#include "tool_2d/text_file.h"

#include "base/error.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

/// The limit of a file's size. A mesh counts in 32 bits, and so does the container of glTF.
constexpr std::uint64_t most_of_file = std::uint64_t{1} << 32;
/// The limit for pipes. A pipe that gives more may have no end, as /dev/zero, and no model is so
/// large.
constexpr std::uint64_t most_of_stream = std::uint64_t{256} << 20;
/// The longest wait for a pipe's first byte. A shell starts the programs at both ends together, but
/// one of them comes first.
constexpr int patience_ms = 2000;

/// An open file. Opening a pipe does not wait for a program at its other end.
class opened {
public:
    explicit opened(const std::string& path)
        : descriptor_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {}
    opened(const opened&) = delete;
    opened& operator=(const opened&) = delete;
    ~opened() {
        if (descriptor_ >= 0)
            close(descriptor_);
    }
    int get() const { return descriptor_; }

    /// Waits until there is something to read, or the end. Errors: false if neither comes in time.
    bool is_ready_within(int milliseconds) const {
        pollfd waiting{descriptor_, POLLIN, 0};
        return poll(&waiting, 1, milliseconds) != 0;
    }

private:
    int descriptor_;
};

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw l3d_error(l3d_exit::bad_input, path + ": " + why);
}

[[noreturn]] void refuse(const std::string& path) {
    refuse(path, std::strerror(errno));
}

} // namespace

std::string l3d_read_text_file(const std::string& path) {
    const opened file(path);
    struct stat status {};
    if (file.get() < 0 || fstat(file.get(), &status) != 0)
        refuse(path);
    // The system's own files, as those in /proc, say that they are empty.
    const bool is_sized = S_ISREG(status.st_mode) && status.st_size > 0;
    const auto size = is_sized ? static_cast<std::uint64_t>(status.st_size) : 0;
    if (size > most_of_file)
        refuse(path, "has " + std::to_string(size) + " bytes; files of up to 4 GB are read");
    const std::uint64_t most = is_sized ? most_of_file : most_of_stream;

    constexpr std::size_t least_step = std::size_t{1} << 16;
    std::string text;
    std::size_t length = 0;
    bool may_wait = S_ISFIFO(status.st_mode);
    for (;;) {
        if (length == text.size()) // room for one more byte finds the end
            text.resize(std::max(length == 0 ? size + 1 : 2 * length, least_step));
        const ssize_t count = read(file.get(), text.data() + length, text.size() - length);
        if (count > 0) {
            length += static_cast<std::size_t>(count);
            if (length > most)
                refuse(path, "has no end within 256 MB, the most that is read of what is no "
                             "regular file");
        } else if (count < 0) {
            if (errno != EAGAIN || !file.is_ready_within(-1))
                refuse(path);
            may_wait = false; // the other end is there, but has written nothing yet
        } else if (length == 0 && may_wait) {
            may_wait = false;
            if (!file.is_ready_within(patience_ms) &&
                read(file.get(), text.data(), text.size()) == 0)
                refuse(path, "no program writes into this pipe");
        } else {
            break;
        }
    }
    text.resize(length);
    return text;
}
