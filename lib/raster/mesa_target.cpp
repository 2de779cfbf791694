// SPDX-License-Identifier: MIT
// mesa_target: makes textures, a framebuffer object and a program. They end with their context.
#include "raster/mesa_target_p.h"

#include "base/error.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace l3d_detail {

mesa_target::mesa_target(std::unique_ptr<mesa_context> context, const program_text& text,
                         bool with_depth)
    : context_(std::move(context)), with_depth_(with_depth) {
    const mesa_gl& gl = context_->make_current();
    make_program(text);
    color_ = make_texture();
    if (with_depth_)
        depth_ = make_texture();
    unsigned framebuffer = 0;
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_, 0);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
    gl.Disable(GL_DITHER);
    if (with_depth_)
        gl.Enable(GL_DEPTH_TEST);
}

void mesa_target::make_program(const program_text& text) {
    const mesa_gl& gl = context_->make_current();
    program_ = gl.CreateProgram();
    for (const auto& [kind, source] :
         {std::pair{GL_VERTEX_SHADER, text.vertex}, std::pair{GL_FRAGMENT_SHADER, text.fragment}}) {
        const unsigned shader = gl.CreateShader(static_cast<GLenum>(kind));
        gl.ShaderSource(shader, 1, &source, nullptr);
        gl.CompileShader(shader);
        gl.AttachShader(program_, shader);
        gl.DeleteShader(shader); // the program keeps it
    }
    unsigned place = 0;
    for (const char* name : text.attributes) {
        gl.BindAttribLocation(program_, place, name);
        gl.EnableVertexAttribArray(place++);
    }
    gl.LinkProgram(program_);
    int linked = 0;
    gl.GetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (!linked)
        throw l3d_error(l3d_exit::no_backend,
                        std::string(name_of(context_->way())) + " does not compile our shaders");
    gl.UseProgram(program_);
}

unsigned mesa_target::make_texture() {
    const mesa_gl& gl = context_->make_current();
    unsigned texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture); // the first binding gives it this kind
    return texture;
}

bool mesa_target::resize(l3d_size size) {
    const mesa_gl& gl = context_->make_current();
    size_ = size;
    if (size.width < 1 || size.height < 1)
        return false;
    while (gl.GetError() != GL_NO_ERROR) {
    }
    const auto allocate = [&](unsigned texture, int inner, GLenum format, GLenum type) {
        gl.BindTexture(GL_TEXTURE_2D, texture);
        gl.TexImage2D(GL_TEXTURE_2D, 0, inner, size.width, size.height, 0, format, type, nullptr);
    };
    allocate(color_, GL_RGBA8, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV);
    if (with_depth_)
        allocate(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
    gl.Viewport(middle_x() - reach, middle_y() - reach, 2 * reach, 2 * reach);
    return gl.GetError() == GL_NO_ERROR &&
           gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void mesa_target::upload(const l3d_pixels& pixels) {
    const mesa_gl& gl = context_->make_current();
    gl.BindTexture(GL_TEXTURE_2D, color_);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<int>(pixels.stride));
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size_.width, size_.height, GL_BGRA,
                     GL_UNSIGNED_INT_8_8_8_8_REV, pixels.words);
}

void mesa_target::download(const l3d_pixels& pixels) {
    const mesa_gl& gl = context_->make_current();
    gl.PixelStorei(GL_PACK_ROW_LENGTH, static_cast<int>(pixels.stride));
    gl.ReadPixels(0, 0, size_.width, size_.height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                  pixels.words);
}

void mesa_target::clear(const l3d_background& background) {
    const mesa_gl& gl = this->gl();
    gl.ClearColor(0, 0, 0, background == l3d_background() ? 0 : 1);
    gl.ClearDepth(0);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void mesa_target::download(const l3d_pixels& pixels, const l3d_background& background) {
    download(pixels);
    if (background == l3d_background())
        return;
    for (int y = 0; y < pixels.height; ++y)
        std::ranges::replace(pixels.row(y), l3d_pixels::transparent,
                             background.word(y, pixels.height));
}

void mesa_target::download(l3d_depth_buffer& depth) {
    const mesa_gl& gl = context_->make_current();
    const auto width = static_cast<std::size_t>(size_.width);
    scaled_.resize(width * static_cast<std::size_t>(size_.height));
    gl.PixelStorei(GL_PACK_ROW_LENGTH, 0);
    gl.ReadPixels(0, 0, size_.width, size_.height, GL_DEPTH_COMPONENT, GL_FLOAT, scaled_.data());
    auto from = scaled_.cbegin();
    for (int y = 0; y < size_.height; ++y, from += size_.width)
        std::transform(from, from + size_.width, depth.row(y).begin(),
                       [](float scaled) { return scaled / depth_scale; });
}

} // namespace l3d_detail
