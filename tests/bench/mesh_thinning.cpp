#include "bench/mesh_thinning.h"
void thin_out(patch_mesh&, const seen_patch&, double) {}
