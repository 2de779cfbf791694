// SPDX-License-Identifier: MIT
// Scenes that are made for a rule by which frames leave work out, and scenes that it looks at in
// vain.
#ifndef L3D_TESTS_BENCH_LEAVING_OUT_CASES_H
#define L3D_TESTS_BENCH_LEAVING_OUT_CASES_H

#include "hard_edged.h"
#include "pipeline/pipeline_afd.h"

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

/// The data that differ from frame to frame.
enum class frame_change {
    eye, ///< it trembles: nothing can be kept
    one, ///< the last instance moves
    all, ///< every instance moves
    none
};

struct leaving_out_case {
    std::string rule, scene;
    bool applies = true;            ///< else what is measured is what it costs to ask
    bool l3d_kept_work::*keep = {}; ///< switches the rule off
    const char* unit = "";          ///< of what is left out
    std::int64_t (*left_out)(const l3d_frame_report&) = nullptr;
    l3d_patch_scene world{};
    l3d_afd_settings settings = hard_edged();
    frame_change change = frame_change::eye;
};

/// Lives: the models, as long as this does.
class leaving_out_cases {
public:
    /// Expects: data/teapot.bpt can be read. Errors: std::runtime_error if it cannot.
    leaving_out_cases();

    static constexpr l3d_size size{640, 480};
    static constexpr l3d_camera camera{.eye = {3.2, 3.6, 7.4}, .target = {0.2, 1.3, 0.0}};
    const std::vector<leaving_out_case>& all() const { return cases_; }

private:
    std::deque<l3d_patch_model> models_;
    std::vector<leaving_out_case> cases_;
};

#endif
