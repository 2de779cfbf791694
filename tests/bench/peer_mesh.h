// SPDX-License-Identifier: MIT
// Triangle meshes of a model for one view, as few triangles as an error allows.
#ifndef L3D_TESTS_BENCH_PEER_MESH_H
#define L3D_TESTS_BENCH_PEER_MESH_H

#include "bench/patch_mesh.h"
#include "scene/camera.h"
#include "scene/patch_model.h"

#include <cstdint>
#include <string>
#include <vector>

/// A triangle mesh with the grey of each vertex baked in: the cheapest way to feed a peer.
struct peer_mesh {
    std::string kind;                   ///< how it was made
    double error = 0;                   ///< measured, in pixels
    std::vector<float> positions;       ///< x y z of each vertex
    std::vector<float> greys;           ///< of each vertex, 0 to 1: its exact shade
    std::vector<std::uint32_t> indices; ///< three for each triangle, nearest patch first

    std::size_t vertices() const { return greys.size(); }
    std::size_t triangles() const { return indices.size() / 3; }
};

/// The case that a peer's mesh is made for.
struct mesh_wish {
    const l3d_patch_model& model;
    l3d_camera camera;
    l3d_size size;
    double tolerance; ///< the measured error is at most this. Units: pixels
    l3d_vector<double, 3> light;
};

/// On every patch a grid of its own, with lines where its bending wants them, and boundaries that
/// neighbours share. It needs two to three times fewer triangles than n x n quads on every patch.
peer_mesh adaptive_mesh(const mesh_wish& wish);

/// The adaptive mesh, finer to begin with, and then thinned out: 1.3 to 2.7 times fewer again.
peer_mesh thinned_mesh(const mesh_wish& wish);

#endif
