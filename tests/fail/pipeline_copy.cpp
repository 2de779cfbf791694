// SPDX-License-Identifier: MIT
// A pipeline is plugged into a dispatcher by address: a copy would be a program nobody runs.
#include "pipeline/pipeline.h"

class program : public l3d_pipeline {};

void start(program& first);

void start(program& first) {
#ifdef L3D_MUST_FAIL
    program second = first;
#else
    program& second = first;
#endif
    second.done = true;
}
