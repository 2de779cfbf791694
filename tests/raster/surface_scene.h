// SPDX-License-Identifier: MIT
// Scenes of random sheets and triangles for the tests of whole frames.
#ifndef L3D_TESTS_RASTER_SURFACE_SCENE_H
#define L3D_TESTS_RASTER_SURFACE_SCENE_H

#include "surface_fixture.h"

#include <array>
#include <vector>

constexpr unsigned scene_seed = 20070301;
constexpr l3d_size scene_size{203, 131}; ///< of no whole number of tiles
constexpr std::array<float, 3> scene_light{0.48f, 0.60f, 0.64f};

using surface_parts = std::vector<l3d_surface_part>;

std::vector<const l3d_surface_part*> pointers(const surface_parts& all);

/// Sheets over, through and beside each other, with triangles strewn in.
surface_parts random_scene(unsigned seed, l3d_size size, int sheets);

/// A tube round a line through (32, 24), seen from its side. Both of its outlines are folds. Its
/// levels are those of a light that comes from beside the eye. Units: pixels, radians.
l3d_surface_part tube(double direction, double radius, double light);

/// Lit by scene_light; each pixel looks along a ray of its own.
l3d_shading scene_shading(l3d_shade mode);

void draw_frame(surface_picture& picture, const surface_parts& scene, l3d_shade mode);

/// The same words and distances.
void expect_same(surface_picture& a, surface_picture& b);

#endif
