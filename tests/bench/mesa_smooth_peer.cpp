// SPDX-License-Identifier: MIT
// mesa_smooth_peer: finer framebuffers, and shaders that take means.
#include "bench/mesa_smooth_peer.h"

#include <utility>

namespace {

constexpr int samples = 4; ///< llvmpipe has no more
constexpr int finer = 4;   ///< times as many pixels along x and along y

/// A pixel that a triangle covers in part would else be shaded from outside of it, and pictures
/// would err 1.2 to 1.4 times as much.
constexpr const char* mesh_text = R"(#version 130
centroid in float shade;
out vec4 color;
void main() { color = vec4(shade); }
)";

constexpr const char* whole_picture_text = R"(#version 130
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

/// Light of levels by a polynomial that is wrong by 0.06 levels at most, from 0.1 to 1 and at 0:
/// other greys there are none. The mean's level is by the sRGB curve itself.
#define PEER_LIGHT                                                                                 \
    "vec4 light(vec4 c) {\n"                                                                       \
    "    return c * (0.049479316 + c * (0.416673993 + c * (0.933571666 + c * (-0.607616885 +\n"    \
    "           c * 0.208379453))));\n"                                                            \
    "}\n"                                                                                          \
    "vec4 shown(float l) {\n"                                                                      \
    "    return vec4(l <= 0.0031308 ? 12.92 * l : 1.055 * pow(l, 1.0 / 2.4) - 0.055);\n"           \
    "}\n"

constexpr const char* mean_of_samples_text = R"(#version 150
uniform sampler2DMS fine;
out vec4 color;
)" PEER_LIGHT R"(
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 c = vec4(texelFetch(fine, at, 0).r, texelFetch(fine, at, 1).r,
                  texelFetch(fine, at, 2).r, texelFetch(fine, at, 3).r);
    color = shown(dot(light(c), vec4(0.25)));
}
)";

constexpr const char* mean_of_pixels_text = R"(#version 400
uniform sampler2D fine;
out vec4 color;
)" PEER_LIGHT R"(
void main() {
    vec2 texel = 1.0 / vec2(textureSize(fine, 0));
    vec2 middle = gl_FragCoord.xy * 4.0 * texel;
    vec2 x = vec2(texel.x, 0.0), y = vec2(0.0, texel.y);
    vec4 above = light(textureGather(fine, middle - x - y)) +
                 light(textureGather(fine, middle + x - y));
    vec4 below = light(textureGather(fine, middle - x + y)) +
                 light(textureGather(fine, middle + x + y));
    color = shown(dot(above + below, vec4(0.0625)));
}
)";

#undef PEER_LIGHT

} // namespace

std::unique_ptr<mesa_smooth_peer> mesa_smooth_peer::open(l3d_size size, std::string& why) {
    auto gl = mesa_calls::open(why);
    if (!gl)
        return nullptr;
    std::unique_ptr<mesa_smooth_peer> peer(new mesa_smooth_peer(std::move(gl), size));
    return peer->make_programs(why) && peer->make_framebuffers(why) ? std::move(peer) : nullptr;
}

bool mesa_smooth_peer::make_programs(std::string& why) {
    mesh_program_ = gl_->program(mesa_mesh_shader, mesh_text, why);
    of(mesa_fineness::samples).mean = gl_->program(whole_picture_text, mean_of_samples_text, why);
    of(mesa_fineness::pixels).mean = gl_->program(whole_picture_text, mean_of_pixels_text, why);
    to_clip_ = gl_->GetUniformLocation(mesh_program_, "to_clip");
    gl_->Disable(GL_DITHER);
    gl_->DepthFunc(GL_GREATER);
    gl_->ClearDepth(0);
    return mesh_program_ && of(mesa_fineness::samples).mean && of(mesa_fineness::pixels).mean;
}

bool mesa_smooth_peer::is_complete() const {
    return gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void mesa_smooth_peer::make_fine_picture(mesa_fineness fineness) {
    fine_picture& made = of(fineness);
    gl_->GenTextures(1, &made.texture);
    unsigned depth = 0;
    gl_->GenRenderbuffers(1, &depth);
    gl_->BindRenderbuffer(GL_RENDERBUFFER, depth);
    GLenum kind = GL_TEXTURE_2D;
    if (fineness == mesa_fineness::samples) {
        kind = GL_TEXTURE_2D_MULTISAMPLE;
        gl_->BindTexture(kind, made.texture);
        gl_->TexImage2DMultisample(kind, samples, GL_R8, size_.width, size_.height, GL_TRUE);
        gl_->RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT32F,
                                            size_.width, size_.height);
    } else {
        const l3d_size large{finer * size_.width, finer * size_.height};
        gl_->BindTexture(kind, made.texture);
        gl_->TexImage2D(kind, 0, GL_R8, large.width, large.height, 0, GL_RED, GL_UNSIGNED_BYTE,
                        nullptr);
        for (const GLenum filter : {GLenum{GL_TEXTURE_MIN_FILTER}, GLenum{GL_TEXTURE_MAG_FILTER}})
            gl_->TexParameteri(kind, filter, GL_NEAREST);
        for (const GLenum wrap : {GLenum{GL_TEXTURE_WRAP_S}, GLenum{GL_TEXTURE_WRAP_T}})
            gl_->TexParameteri(kind, wrap, GL_CLAMP_TO_EDGE);
        gl_->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, large.width, large.height);
    }
    gl_->GenFramebuffers(1, &made.framebuffer);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, made.framebuffer);
    gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, kind, made.texture, 0);
    gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
}

bool mesa_smooth_peer::make_framebuffers(std::string& why) {
    bool complete = true;
    for (const auto fineness : {mesa_fineness::samples, mesa_fineness::pixels}) {
        make_fine_picture(fineness);
        complete = complete && is_complete();
    }
    unsigned color = 0;
    gl_->GenRenderbuffers(1, &color);
    gl_->BindRenderbuffer(GL_RENDERBUFFER, color);
    gl_->RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size_.width, size_.height);
    gl_->GenFramebuffers(1, &picture_);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, picture_);
    gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    complete = complete && is_complete();
    if (!complete)
        why = "GL has no framebuffers fine enough";
    return complete;
}

void mesa_smooth_peer::draw(const mesa_mesh& mesh, mesa_fineness fineness) {
    const fine_picture& fine = of(fineness);
    const int scale = fineness == mesa_fineness::samples ? 1 : finer;
    gl_->Enable(GL_DEPTH_TEST);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, fine.framebuffer);
    gl_->Viewport(0, 0, scale * size_.width, scale * size_.height);
    gl_->UseProgram(mesh_program_);
    mesh.bind(to_clip_);
    gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    mesh.draw();

    gl_->Disable(GL_DEPTH_TEST);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, picture_);
    gl_->Viewport(0, 0, size_.width, size_.height);
    gl_->BindTexture(scale == 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, fine.texture);
    gl_->UseProgram(fine.mean);
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
    gl_->Finish();
}

std::vector<std::uint8_t> mesa_smooth_peer::picture() {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, picture_);
    return gl_->red_rows(size_);
}
