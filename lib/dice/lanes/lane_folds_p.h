// SPDX-License-Identifier: MIT
// most_folded: measures the error of folded quads on a grid.
#ifndef L3D_DICE_LANES_LANE_FOLDS_P_H
#define L3D_DICE_LANES_LANE_FOLDS_P_H

#include "dice/step_plan.h"
#include "raster/surface_part.h"

namespace l3d_detail {

/// Finds the largest error of a grid's folded quads; 0 if none is folded.
///
/// A folded quad is drawn as four triangles around its centre. The triangles differ from the
/// bilinear surface between the corners by at most a sixteenth of the corners' mixed difference.
/// The mixed difference is taken relative to the quad's own place in the picture, so that it does
/// not depend on where the quad lies. Plans of kind `convex` leave this term out, since few quads
/// fold. NUMERICS, section 3.
/// Units: pixels.
/// Shape: `errors` has the errors of blocks without folded quads, as l3d_step_plan::errors.
/// Cost:  some eight instructions a quad with eight lanes.
double most_folded(const l3d_surface_part& part, const l3d_block_needs::per_block& errors);

} // namespace l3d_detail

#endif
