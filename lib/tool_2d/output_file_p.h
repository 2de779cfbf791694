// SPDX-License-Identifier: MIT
// output_file: a file that replaces its predecessor only when it is complete.
#ifndef L3D_TOOL_2D_OUTPUT_FILE_P_H
#define L3D_TOOL_2D_OUTPUT_FILE_P_H

#include <cstdio>
#include <memory>
#include <string>

namespace l3d_detail {

/// Throws l3d_error(failure): "path: the system's text for errno".
[[noreturn]] void throw_write_error(const std::string& path);

struct file_closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using unique_file = std::unique_ptr<std::FILE, file_closer>;

/// A file that is being written. commit() writes it to the disk, and then gives it its name.
///
/// Before commit(), the file has no name at all where the system permits this (O_TMPFILE), so that
/// nothing is left behind, however the program ends. Elsewhere the file has a temporary name in the
/// same folder, which nobody can guess and which follows no link. Several threads or processes may
/// write one path: the file committed last stays, whole.
///
/// A device or a pipe is written directly, since it cannot be replaced. A file is written directly
/// if no second file can be made in its folder. A file that is replaced leaves its permissions, and
/// if possible its owner, to the new file. A link is followed, even to a file that does not exist
/// yet.
/// Lives:   a file that was not committed is removed.
class output_file {
public:
    /// Opens a file that will replace the one at this path.
    /// Errors:  l3d_error(failure) with the path and the system's reason.
    explicit output_file(const std::string& path);
    output_file(const output_file&) = delete;
    output_file& operator=(const output_file&) = delete;
    ~output_file();

    std::FILE* get() const { return file_.get(); }

    /// Writes the file to the disk, then gives it its name. Errors: as the constructor.
    void commit();

private:
    void open_directly();
    int open_nameless() const;
    int open_named();
    void link();
    void sync_folder() const;

    std::string path_;      ///< the path as the user wrote it, for messages
    std::string target_;    ///< the file that `path_` leads to through links
    std::string temporary_; ///< the name before commit(); empty: the file has none
    unique_file file_;
    bool is_direct_ = false;
};

} // namespace l3d_detail

#endif
