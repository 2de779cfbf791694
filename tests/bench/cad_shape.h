// SPDX-License-Identifier: MIT
// A shape of Open CASCADE's, and the meshes that its own mesher makes of it.
#ifndef L3D_TESTS_BENCH_CAD_SHAPE_H
#define L3D_TESTS_BENCH_CAD_SHAPE_H

#include "bench/peer_mesh.h"
#include "scene/camera.h"

#include <memory>
#include <string>
#include <vector>

/// How finely the mesher works.
struct cad_fineness {
    double deflection = 0; ///< the largest distance of chords from curves and faces that it aims at
    double angle = 1;      ///< the largest turn of a curve along a chord. Units: radians
    bool in_parallel = false;
};

/// How far a mesh is from the shape in a picture. All of the shape counts that is in the window,
/// seen or hidden.
struct cad_error {
    /// The largest image distance of a point of a triangle from the nearest point of its face, and
    /// of a point of a border from the nearest point of its edge. Units: pixels.
    double places = 0;
    /// The largest difference of a triangle's interpolated grey from that of the nearest point of
    /// its face. Units: levels of 255.
    double shades = 0;
};

/// A STEP file as Open CASCADE holds it.
class cad_shape {
public:
    /// Errors: std::runtime_error if this program was built without Open CASCADE.
    static void expect_open_cascade();

    /// Writes the shapes of docs/SPEED.md into a folder, and returns the files.
    static std::vector<std::string> write_examples(const std::string& folder);

    /// Reads a file as the plug-in `cad` does. Errors: std::runtime_error if it is no STEP file.
    explicit cad_shape(const std::string& path);
    cad_shape(cad_shape&&) noexcept;
    ~cad_shape();

    /// Forgets the mesh that there is, and makes another.
    void mesh(const cad_fineness& fineness);

    /// The mesh's places and the greys of its exact normals, which point out of the shape.
    peer_mesh vertices(const l3d_vector<double, 3>& light) const;

    /// The errors of the mesh, at the lattice of the fourths of each triangle and border.
    cad_error error(const l3d_camera& camera, l3d_size size,
                    const l3d_vector<double, 3>& light) const;

    /// The nearest place to `eye` among the middles of edges that are not straight.
    l3d_vector<double, 3> round_edge_near(const l3d_vector<double, 3>& eye) const;

private:
    struct kernel;
    std::unique_ptr<kernel> kernel_;
};

#endif
