// SPDX-License-Identifier: MIT
// mesa_target: a picture in GL, which comes from pixels in memory and goes back there.
#ifndef L3D_RASTER_MESA_TARGET_P_H
#define L3D_RASTER_MESA_TARGET_P_H

#include "tool_2d/mesa/mesa_context_p.h"
#include "tool_2d/pixels.h"
#include "raster/background.h"
#include "raster/depth_buffer.h"

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace l3d_detail {

/// The framebuffer object of a GL context, with a program that draws triangles into it.
///
/// Row 0 of the picture is row 0 in GL, so pictures are never flipped. A triangle's left and top
/// sides in GL are its left and top sides in the picture. The viewport extends `reach` pixels to
/// all sides of the picture's middle, whatever its size. So positions on the lattice of 1/256 pixel
/// stay exact: in clip space they are multiples of 2^-21 and at most 1.
/// Cost:    every call of GL takes locks and makes checks; batches of thousands of triangles hide
///          this cost.
class mesa_target {
public:
    /// Half the width of the viewport, in pixels; llvmpipe's largest viewport is 2^14 wide.
    static constexpr int reach = 8192;

    /// The sources of a program. `attributes` are the names of the vertex shader's inputs, from
    /// location 0 on.
    struct program_text {
        const char* vertex;
        const char* fragment;
        std::initializer_list<const char*> attributes;
    };

    /// Errors:  l3d_error(no_backend) if this GL does not compile the program.
    mesa_target(std::unique_ptr<mesa_context> context, const program_text& text, bool with_depth);

    std::string describe() const { return context_->describe(); }

    /// Makes the context current, and returns its GL functions.
    const mesa_gl& gl() { return context_->make_current(); }

    int uniform(const char* name) { return gl().GetUniformLocation(program_, name); }

    /// Sets the size of the picture.
    /// Errors:  false if GL cannot hold a picture of this size; then nothing may be drawn.
    bool resize(l3d_size size);

    /// The column and row of the pixel in the middle of the viewport.
    int middle_x() const { return size_.width / 2; }
    int middle_y() const { return size_.height / 2; }

    void upload(const l3d_pixels& pixels);
    void download(const l3d_pixels& pixels);

    /// Empties the picture and the depth before surfaces are drawn.
    /// Expects: surfaces are drawn with an alpha of 0. Empty pixels are marked by another alpha,
    ///          except on a black background, where they need no mark.
    void clear(const l3d_background& background);
    /// Copies the picture that was drawn since clear() to pixels in memory. Empty pixels get the
    /// background.
    void download(const l3d_pixels& pixels, const l3d_background& background);

    /// Copies the depth to memory. GL keeps it as inv_w * depth_scale. Expects: with_depth.
    void download(l3d_depth_buffer& depth);

    /// The factor between inv_w and GL's depth. As the factor is a power of two, it loses no bits.
    /// It takes every inv_w from 2^-94 to 2^32 to [0, 1], the range of GL's depth.
    static constexpr float depth_scale = 1.0f / 65536.0f / 65536.0f;

private:
    void make_program(const program_text& text);
    unsigned make_texture();

    std::unique_ptr<mesa_context> context_;
    bool with_depth_;
    unsigned program_ = 0, color_ = 0, depth_ = 0;
    l3d_size size_;
    std::vector<float> scaled_;
};

} // namespace l3d_detail

#endif
