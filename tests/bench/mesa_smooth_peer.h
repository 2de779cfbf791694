// SPDX-License-Identifier: MIT
// Mesa's llvmpipe drawing anti-aliased pictures of static triangle meshes.
#ifndef L3D_TESTS_BENCH_MESA_SMOOTH_PEER_H
#define L3D_TESTS_BENCH_MESA_SMOOTH_PEER_H

#include "bench/mesa_calls.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// What llvmpipe takes the mean of.
enum class mesa_fineness {
    samples, ///< GL_SAMPLES 4, as many as llvmpipe has
    pixels,  ///< 4 x 4 times as many pixels
};

/// llvmpipe, off-screen, with the cheapest state that draws the picture.
///
/// It draws encoded greys, as without anti-aliasing, but into one channel of a finer framebuffer
/// object. A shader decodes them, takes the mean of each pixel in linear light, and encodes it by
/// the sRGB curve into an RGBA picture. Nothing is read back. GL's own ways to the same picture, a
/// blit or a linear filter of an sRGB framebuffer, took 1.0 to 1.33 times as long.
class mesa_smooth_peer {
public:
    /// Errors: null, with one line in `why`, if there is no software GL.
    static std::unique_ptr<mesa_smooth_peer> open(l3d_size size, std::string& why);

    std::string renderer() const { return gl_->renderer(); }

    /// A mesh to draw. Expects: made for pictures of this peer's size. Lives: no longer than it.
    std::unique_ptr<mesa_mesh> mesh(const peer_mesh& mesh, const l3d_camera& camera) const {
        return std::make_unique<mesa_mesh>(*gl_, mesh, camera, size_);
    }

    /// Clears colour and depth, draws a mesh of this peer's, takes the means, and waits until the
    /// picture is in memory.
    void draw(const mesa_mesh& mesh, mesa_fineness fineness);

    /// Grey of each pixel, top row first, of the last picture.
    std::vector<std::uint8_t> picture();

private:
    /// What is drawn to before means are taken, and the program that takes them.
    struct fine_picture {
        unsigned framebuffer = 0, texture = 0, mean = 0;
    };

    mesa_smooth_peer(std::unique_ptr<mesa_calls> gl, l3d_size size)
        : gl_(std::move(gl)), size_(size) {}
    bool make_programs(std::string& why);
    bool make_framebuffers(std::string& why);
    void make_fine_picture(mesa_fineness fineness);
    bool is_complete() const;
    fine_picture& of(mesa_fineness fineness) { return fine_[static_cast<std::size_t>(fineness)]; }

    std::unique_ptr<mesa_calls> gl_;
    l3d_size size_;
    unsigned mesh_program_ = 0;
    int to_clip_ = 0;
    std::array<fine_picture, 2> fine_;
    unsigned picture_ = 0; ///< the framebuffer of the means
};

#endif
