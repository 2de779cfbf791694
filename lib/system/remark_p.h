// SPDX-License-Identifier: MIT
// pass_on_remarks: prints the remarks of a pipeline and its screen.
#ifndef L3D_SYSTEM_REMARK_P_H
#define L3D_SYSTEM_REMARK_P_H

#include "pipeline/pipeline.h"
#include "tool_2d/screen.h"

#include <iostream>
#include <string>
#include <string_view>

namespace l3d_detail {

/// Prints new remarks of the pipeline and of the screen on stderr. Each remark is one line,
/// "program: remark".
inline void pass_on_remarks(l3d_pipeline& pipeline, l3d_screen& screen, std::string_view program) {
    for (const std::string& remark : {pipeline.take_remark(), screen.take_remark()})
        if (!remark.empty())
            std::cerr << program << ": " << remark << '\n';
}

} // namespace l3d_detail

#endif
