// SPDX-License-Identifier: MIT
// Embree tracing sixteen rays a pixel into a static triangle mesh.
#ifndef L3D_TESTS_BENCH_EMBREE_SMOOTH_PEER_H
#define L3D_TESTS_BENCH_EMBREE_SMOOTH_PEER_H

#include "bench/embree_scene.h"
#include "raster/parallel/workers.h"
#include "tool_2d/image.h"

#include <memory>
#include <string>
#include <utility>

/// A scene built once at high quality, seen by streams of coherent packets of 8 or 16 rays of one
/// pixel. Their levels, interpolated between vertices, are decoded; the mean of the light is
/// encoded by the sRGB curve.
class embree_smooth_peer {
public:
    /// Expects: made for this camera and size.
    /// Errors: null, with one line in `why`, if there is no device.
    static std::unique_ptr<embree_smooth_peer> open(const peer_mesh& mesh, const l3d_camera& camera,
                                                    l3d_size size, std::string& why);

    /// Every pixel of the picture, by packets of 8 or 16 rays.
    void draw(l3d_workers& workers, int rays);

    l3d_pixels picture() { return picture_.pixels(); }

private:
    embree_smooth_peer(std::unique_ptr<embree_scene> made, l3d_size size)
        : scene_(std::move(made)), picture_(size, l3d_padded_stride(size.width)) {}
    template <class Packet> void draw_row(int y);

    std::unique_ptr<embree_scene> scene_;
    l3d_image picture_;
};

#endif
