// SPDX-License-Identifier: MIT
// Four models and twelve views of each, for the judges of whole pictures.
#ifndef L3D_TESTS_PIPELINE_SHOWN_MODELS_H
#define L3D_TESTS_PIPELINE_SHOWN_MODELS_H

#include "reference/exact.h"

#include <string>
#include <vector>

namespace pipeline_tests {

struct shown_model {
    std::string name;
    std::vector<reference::patch> patches;
    std::vector<reference::camera> views; ///< twelve
};

/// The teapot, a dome, bumps and a body like a starfish.
std::vector<shown_model> shown_models();

} // namespace pipeline_tests

#endif
