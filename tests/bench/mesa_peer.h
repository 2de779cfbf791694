// SPDX-License-Identifier: MIT
// Mesa's llvmpipe drawing a static triangle mesh: the peer that the benchmarks compare with.
#ifndef L3D_TESTS_BENCH_MESA_PEER_H
#define L3D_TESTS_BENCH_MESA_PEER_H

#include "bench/mesa_calls.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// llvmpipe, off-screen, with the cheapest state that draws the picture: a framebuffer object,
/// one matrix, vertices of a position and a grey, no blending, nothing read back.
class mesa_peer {
public:
    /// Errors: null, with one line in `why`, if there is no software GL.
    /// LP_NUM_THREADS is read at the first call in a process.
    static std::unique_ptr<mesa_peer> open(std::string& why);
    ~mesa_peer();

    std::string renderer() const;

    /// Which side of triangles is left out.
    enum class culling { none, back, front };

    /// Expects: a mesh for this camera and size.
    void prepare(const peer_mesh& mesh, const l3d_camera& camera, l3d_size size, culling sides);

    /// Clears colour and depth, draws the mesh, and waits until the picture is in memory, where a
    /// software GL keeps it.
    void draw();

    /// Grey of each pixel, top row first, of the last picture.
    std::vector<std::uint8_t> picture();

private:
    explicit mesa_peer(std::unique_ptr<mesa_calls> gl);
    bool make_program(std::string& why);

    std::unique_ptr<mesa_calls> gl_;
    std::unique_ptr<mesa_mesh> mesh_;
    l3d_size size_;
    unsigned color_ = 0, depth_ = 0, framebuffer_ = 0;
    int to_clip_ = 0;
};

#endif
