// SPDX-License-Identifier: MIT
// Embree tracing one ray a pixel into a static triangle mesh.
#ifndef L3D_TESTS_BENCH_EMBREE_PEER_H
#define L3D_TESTS_BENCH_EMBREE_PEER_H

#include "bench/embree_scene.h"
#include "raster/parallel/workers.h"
#include "tool_2d/image.h"

#include <memory>
#include <string>
#include <utility>

/// A scene built once at high quality, seen by streams of coherent packets of rays, 4 x 2 or 4 x 4
/// pixels each, with the grey of each vertex interpolated.
class embree_peer {
public:
    /// Errors: null, with one line in `why`, if there is no device.
    static std::unique_ptr<embree_peer> open(std::string& why);

    std::string name() const;

    /// Expects: width and height are multiples of 4; packets of 8 or 16 rays.
    void prepare(const peer_mesh& mesh, const l3d_camera& camera, l3d_size size, int rays);

    /// Every pixel of the picture, from rays through pixel centres.
    void draw(l3d_workers& workers);

    l3d_pixels picture() { return picture_.pixels(); }

private:
    explicit embree_peer(std::unique_ptr<embree_scene> made) : scene_(std::move(made)) {}
    template <class Packet> void draw_row(int top);

    std::unique_ptr<embree_scene> scene_;
    l3d_image picture_{{4, 4}, 4};
    int rays_ = 16;
};

#endif
