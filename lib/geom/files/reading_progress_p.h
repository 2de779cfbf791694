// SPDX-License-Identifier: MIT
// reading_progress: readers of files that take long, which report their progress and can be
// stopped.
#ifndef L3D_GEOM_FILES_READING_PROGRESS_P_H
#define L3D_GEOM_FILES_READING_PROGRESS_P_H

#include "geom/files/model_file.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace l3d_detail {

/// A function that is told how far reading has come: the share of the work that is done, from 0 to
/// 1. The function is called a few times a second, and at the end with 1. If it returns false, the
/// reading stops. Only the readers of STEP and IGES, which take long, call it.
using reading_progress = std::function<bool(double share)>;

/// Reads as l3d_read_model_with does, and reports its progress.
/// Errors: as l3d_read_model_with. Stopped reading is an error, too.
std::optional<l3d_model_file> read_model(const l3d_other_files& files, std::string_view text,
                                         std::string_view name, std::string& why,
                                         const reading_progress& progress);

/// Reads as l3d_read_cad does, and reports its progress.
/// Errors: as read_model.
std::optional<l3d_model_file> read_cad(std::string_view text, std::string_view name,
                                       std::string& why, const reading_progress& progress);

} // namespace l3d_detail

#endif
