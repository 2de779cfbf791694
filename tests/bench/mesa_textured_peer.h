// SPDX-License-Identifier: MIT
// Mesa's llvmpipe laying a picture on patches, by GL's own filters.
#ifndef L3D_TESTS_BENCH_MESA_TEXTURED_PEER_H
#define L3D_TESTS_BENCH_MESA_TEXTURED_PEER_H

#include "bench/mesa_calls.h"
#include "raster/textures/texture.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// llvmpipe, off-screen. As ours, it takes the picture's levels for light by the sRGB curve, and
/// encodes what it writes. Greys at vertices take the place of light.
class mesa_textured_peer {
public:
    /// Errors: null, with one line in `why`, if there is no software GL.
    static std::unique_ptr<mesa_textured_peer> open(std::string& why);

    std::string renderer() const { return gl_->renderer(); }

    /// The whole picture lies on each piece of the model, `quads` by `quads` to a patch. Its border
    /// goes on beyond it. `is_plain`: all greys are 1.
    void prepare(const l3d_patch_model& model, const l3d_camera& camera, l3d_size size, int quads,
                 const l3d_pixels& picture, bool is_plain);

    /// Sets the filter. False if GL has no such filter.
    bool take(l3d_texture_filter filter);

    /// Clears colour and depth, draws, and waits until the picture is in memory.
    void draw();

    /// The words of the last picture, top row first; those of pixels without a surface are 0.
    std::vector<std::uint32_t> picture() const;

private:
    explicit mesa_textured_peer(std::unique_ptr<mesa_calls> gl) : gl_(std::move(gl)) {}
    bool make_program(std::string& why);
    void make_framebuffer(l3d_size size);

    std::unique_ptr<mesa_calls> gl_;
    std::unique_ptr<mesa_mesh> mesh_;
    l3d_size size_;
    int to_clip_ = 0;
};

#endif
