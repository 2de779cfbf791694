// SPDX-License-Identifier: MIT
// l3d_pipeline_world borrows its world: a temporary one would be gone before the first picture.
#include "pipeline/worlds/pipeline_world.h"

#include <utility>

void fly(l3d_canvas canvas);

void fly(l3d_canvas canvas) {
#ifdef L3D_MUST_FAIL
    l3d_pipeline_world pipeline(std::move(canvas), l3d_world({320, 200}));
#else
    l3d_world world({320, 200});
    l3d_pipeline_world pipeline(std::move(canvas), world);
#endif
    pipeline.draw_event();
}
