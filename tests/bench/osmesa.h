// SPDX-License-Identifier: MIT
// Mesa's software GL, found at run time: the peer that the benchmarks compare with.
#ifndef L3D_TESTS_BENCH_OSMESA_H
#define L3D_TESTS_BENCH_OSMESA_H

#include "tool_2d/pixels.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// A triangle mesh in static vertex buffers, with the grey level of each vertex baked in: the
/// cheapest way there is to feed GL.
struct gl_mesh {
    std::vector<float> positions;       ///< x y z of each vertex
    std::vector<std::uint8_t> colors;   ///< r g b a of each vertex
    std::vector<std::uint32_t> indices; ///< three for each triangle
};

/// An off-screen GL context that draws on the CPU (llvmpipe).
class osmesa {
public:
    /// Errors: null, with one line in `why`, if libOSMesa is not there or refuses.
    /// `threads`: llvmpipe's workers; 0 draws on the caller's thread. Read once per process.
    static std::unique_ptr<osmesa> create(l3d_size size, int threads, std::string& why);
    ~osmesa();

    std::string renderer() const;

    /// Column-major, as GL wants it: clip space of the picture.
    void set_projection(std::span<const float, 16> matrix);
    void upload(const gl_mesh& mesh);
    /// Clears colour and depth, draws the mesh, and waits until the picture is in memory.
    void draw();
    /// Bytes r g b a, top row first, of the last picture.
    std::span<const std::uint8_t> picture() const { return picture_; }

private:
    struct api;
    osmesa(std::unique_ptr<api> gl, l3d_size size);

    std::unique_ptr<api> gl_;
    l3d_size size_;
    std::vector<std::uint8_t> picture_;
    unsigned buffers_[3] = {0, 0, 0};
    int index_count_ = 0;
};

#endif
