// SPDX-License-Identifier: MIT
// output_file: a file that replaces its predecessor only when it is complete.
#ifndef L3D_TOOL_2D_OUTPUT_FILE_P_H
#define L3D_TOOL_2D_OUTPUT_FILE_P_H

#include <cstdio>
#include <memory>
#include <string>

namespace l3d_detail {

/// Throws l3d_error(failure): "path: what the system says about errno".
[[noreturn]] void throw_write_error(const std::string& path);

struct file_closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using unique_file = std::unique_ptr<std::FILE, file_closer>;

/// A file being written: under a name of its own beside the final one until commit().
///
/// A name that leads to a device or a pipe is written directly, since it cannot be replaced.
/// Lives:   a file that was not committed is removed.
class output_file {
public:
    /// Errors:  l3d_error(failure) with the path and the system's reason.
    explicit output_file(const std::string& path);
    output_file(const output_file&) = delete;
    output_file& operator=(const output_file&) = delete;
    ~output_file();

    std::FILE* get() const { return file_.get(); }

    /// Closes the file and gives it its final name. Errors: as the constructor.
    void commit();

private:
    std::string path_;      ///< as the user wrote it, for messages
    std::string target_;    ///< what it leads to: a link is followed, not replaced
    std::string temporary_; ///< what is open; equal to target_ for a device
    unique_file file_;
    bool committed_ = false;
};

} // namespace l3d_detail

#endif
