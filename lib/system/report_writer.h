// SPDX-License-Identifier: MIT
// l3d_report_writer: a file of lines, one per frame.
#ifndef L3D_SYSTEM_REPORT_WRITER_H
#define L3D_SYSTEM_REPORT_WRITER_H

#include "base/public.h"

#include <fstream>
#include <ostream>
#include <string>

/// Writes lines as they come, so that a program that is stopped leaves whole lines behind.
class L3D_PUBLIC l3d_report_writer {
public:
    /// Opens the file of this name. The name - is the standard output as it is: earlier output
    /// stays, and the output of others comes in between.
    /// Errors: l3d_error(failure) that names the file and the system's reason.
    explicit l3d_report_writer(const std::string& path);
    l3d_report_writer(const l3d_report_writer&) = delete;
    l3d_report_writer& operator=(const l3d_report_writer&) = delete;

    /// Writes a line. Errors: as the constructor.
    void add(const std::string& line);

private:
    [[noreturn]] void refuse() const;

    std::string path_;
    std::ofstream file_;
    std::ostream* out_; ///< the file or the standard output
};

#endif
