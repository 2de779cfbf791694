// SPDX-License-Identifier: MIT
// l3d_report_writer: lines, flushed one by one.
#include "system/report_writer.h"

#include "base/error.h"

#include <cerrno>
#include <cstring>
#include <iostream>

l3d_report_writer::l3d_report_writer(const std::string& path) : path_(path), out_(&file_) {
    if (path == "-") {
        path_ = "standard output";
        out_ = &std::cout;
        return;
    }
    errno = 0;
    file_.open(path, std::ios::binary);
    if (!file_)
        refuse();
}

void l3d_report_writer::add(const std::string& line) {
    errno = 0;
    if (!(*out_ << line << std::endl))
        refuse();
}

void l3d_report_writer::refuse() const {
    throw l3d_error(l3d_exit::failure, path_ + ": " + std::strerror(errno ? errno : EIO));
}
