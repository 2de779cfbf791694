// SPDX-License-Identifier: MIT
// A case as polygons: the same patches as a mesh, by a depth buffer and by an order.
#ifndef L3D_TESTS_STABILITY_POLYGON_WAYS_H
#define L3D_TESTS_STABILITY_POLYGON_WAYS_H

#include "judge.h"

namespace stability {

/// Draws each patch as 8 x 8 quads by method `tessellation`, whose picture is judged by its own
/// bound, as those of patches are. Then `zbuffer` and `zsort` draw the same mesh. They must cover
/// the same pixels, and show the same levels in all but a few. (Where two depths tie, either may
/// show its own.)
///
/// Only pictures are judged: `measured` is how far falsely covered or uncovered pixels are off.
verdict judged_as_polygons(const test_case& c);

} // namespace stability

#endif
