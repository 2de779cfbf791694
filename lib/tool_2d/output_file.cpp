// SPDX-License-Identifier: MIT
// output_file: writes a nameless or temporary file, checks and synchronises it, then links or
// renames it.
#include "tool_2d/output_file_p.h"

#include "base/error.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

namespace l3d_detail {

namespace {

namespace fs = std::filesystem;

/// The mode of a new file, which the user's mask reduces.
constexpr mode_t everybody = 0666;

std::string folder_of(const std::string& target) {
    const fs::path folder = fs::path(target).parent_path();
    return folder.empty() ? "." : folder.string();
}

/// Follows a name through links to its target, which need not exist.
/// Expects: the links form no circle.
std::string led_to(fs::path name) {
    constexpr int most_links = 40; // as many as Linux follows
    for (int i = 0; i < most_links; ++i) {
        std::error_code no_link;
        const fs::path next = fs::read_symlink(name, no_link);
        if (no_link)
            break;
        name = name.parent_path() / next;
    }
    return name.string();
}

/// The name of a temporary file in a folder. The name is short enough for any file system.
std::string part_name(const std::string& folder, std::uint64_t number) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "/.l3d-%016llx.part",
                  static_cast<unsigned long long>(number));
    return folder + name.data();
}

/// A name with 64 random bits. Nobody can guess it and put a link there.
std::string free_name(const std::string& folder) {
    std::uint64_t number = 0;
    if (getrandom(&number, sizeof number, 0) != sizeof number)
        number = static_cast<std::uint64_t>(getpid());
    return part_name(folder, number);
}

/// The name of a complete file between its link and its renaming. The name is always the same, so
/// that the next writer finds a file that a dead writer left behind in this moment. The name need
/// not be secret, as a hard link follows no link and replaces no file.
std::string complete_name(const std::string& target) {
    return part_name(folder_of(target), std::hash<std::string>()(target));
}

/// Removes a file that a dead writer left behind. A living writer holds a lock on its file.
void remove_left_behind(const std::string& name) {
    const int descriptor = open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0)
        return;
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0)
        unlink(name.c_str());
    close(descriptor);
}

/// Calls make(name) with new names while the call fails with EEXIST. Returns the last call's
/// result.
template <class Make> int with_free_name(const std::string& folder, std::string& name, Make make) {
    constexpr int most_tries = 100;
    int result = -1;
    for (int i = 0; i < most_tries; ++i) {
        name = free_name(folder);
        result = make(name.c_str());
        if (result >= 0 || errno != EEXIST)
            break;
    }
    if (result < 0)
        name.clear();
    return result;
}

/// The path by which the system refers to an open file that has no name.
std::string name_of(int descriptor) {
    return "/proc/self/fd/" + std::to_string(descriptor);
}

bool lacks_permission(int error) {
    return error == EACCES || error == EPERM || error == EROFS;
}

} // namespace

void throw_write_error(const std::string& path) {
    throw l3d_error(l3d_exit::failure, path + ": " + std::strerror(errno));
}

output_file::output_file(const std::string& path) : path_(path), target_(path) {
    struct stat old {};
    const bool exists = stat(path.c_str(), &old) == 0;
    if (!exists && errno != ENOENT)
        throw_write_error(path_);
    std::error_code unknown;
    const fs::path whole = fs::canonical(path, unknown);
    // A file that is open elsewhere may have no name, as /dev/stdout has none.
    if (exists && (!S_ISREG(old.st_mode) || unknown)) {
        open_directly();
        return;
    }
    target_ = exists ? whole.string() : led_to(path);
    int descriptor = open_nameless();
    if (descriptor < 0)
        descriptor = open_named();
    if (descriptor < 0) {
        if (!exists || !lacks_permission(errno))
            throw_write_error(path_);
        open_directly();
        return;
    }
    // Tells remove_left_behind that this writer lives; file systems without locks ignore it.
    static_cast<void>(flock(descriptor, LOCK_EX | LOCK_NB));
    if (exists) {
        // Only root may give a file away; a refusal does no harm.
        static_cast<void>(!fchown(descriptor, old.st_uid, old.st_gid));
        fchmod(descriptor, old.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO));
    }
    file_.reset(fdopen(descriptor, "wb"));
    if (!file_)
        throw_write_error(path_);
}

output_file::~output_file() {
    if (!temporary_.empty())
        unlink(temporary_.c_str());
}

void output_file::open_directly() {
    is_direct_ = true;
    file_.reset(std::fopen(path_.c_str(), "wb"));
    if (!file_)
        throw_write_error(path_);
}

int output_file::open_nameless() const {
    const int descriptor =
        open(folder_of(target_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, everybody);
    if (descriptor < 0 || access(name_of(descriptor).c_str(), F_OK) == 0)
        return descriptor;
    close(descriptor); // without /proc, the file could get no name
    return -1;
}

int output_file::open_named() {
    return with_free_name(folder_of(target_), temporary_, [](const char* name) {
        return open(name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, everybody);
    });
}

/// Gives the nameless file its name. If another file has this name, the nameless file first gets a
/// temporary name.
void output_file::link() {
    const std::string open_file = name_of(fileno(file_.get()));
    const auto link_to = [&](const char* name) {
        return linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW);
    };
    if (link_to(target_.c_str()) == 0)
        return;
    if (errno != EEXIST)
        throw_write_error(path_);
    // A hard link cannot replace a file, but renaming can.
    const std::string name = complete_name(target_);
    int result = link_to(name.c_str());
    if (result != 0 && errno == EEXIST) {
        remove_left_behind(name);
        result = link_to(name.c_str());
    }
    if (result == 0)
        temporary_ = name;
    else if (errno != EEXIST || with_free_name(folder_of(target_), temporary_, link_to) < 0)
        throw_write_error(path_);
}

/// Writes the folder to the disk, since otherwise a new name may be lost. Some file systems cannot
/// do this.
void output_file::sync_folder() const {
    const int folder = open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0)
        return;
    static_cast<void>(fsync(folder));
    close(folder);
}

void output_file::commit() {
    // The rest of the buffer is written now, and may find the disk full.
    if (std::fflush(file_.get()) != 0)
        throw_write_error(path_);
    if (!is_direct_) {
        // Otherwise, after a power failure, the name might lead to an empty file.
        if (fsync(fileno(file_.get())) != 0)
            throw_write_error(path_);
        if (temporary_.empty())
            link();
        if (!temporary_.empty() && std::rename(temporary_.c_str(), target_.c_str()) != 0)
            throw_write_error(path_);
        temporary_.clear();
    }
    if (std::fclose(file_.release()) != 0)
        throw_write_error(path_);
    if (!is_direct_)
        sync_folder();
}

} // namespace l3d_detail
