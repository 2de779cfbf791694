// SPDX-License-Identifier: MIT
// mesa_peer: one sample a pixel.
#include "bench/mesa_peer.h"

namespace {

constexpr const char* fragment_text = R"(#version 130
in float shade;
out vec4 color;
void main() { color = vec4(shade); }
)";

} // namespace

mesa_peer::mesa_peer(std::unique_ptr<mesa_calls> gl) : gl_(std::move(gl)) {}

mesa_peer::~mesa_peer() = default;

std::unique_ptr<mesa_peer> mesa_peer::open(std::string& why) {
    auto gl = mesa_calls::open(why);
    if (!gl)
        return nullptr;
    std::unique_ptr<mesa_peer> peer(new mesa_peer(std::move(gl)));
    return peer->make_program(why) ? std::move(peer) : nullptr;
}

std::string mesa_peer::renderer() const {
    return gl_->renderer();
}

bool mesa_peer::make_program(std::string& why) {
    const unsigned program = gl_->program(mesa_mesh_shader, fragment_text, why);
    if (!program)
        return false;
    gl_->UseProgram(program);
    to_clip_ = gl_->GetUniformLocation(program, "to_clip");
    gl_->GenRenderbuffers(1, &color_);
    gl_->GenRenderbuffers(1, &depth_);
    gl_->GenFramebuffers(1, &framebuffer_);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_->Disable(GL_DITHER);
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_GREATER);
    gl_->ClearDepth(0);
    return true;
}

void mesa_peer::prepare(const peer_mesh& mesh, const l3d_camera& camera, l3d_size size,
                        culling sides) {
    size_ = size;
    gl_->BindRenderbuffer(GL_RENDERBUFFER, color_);
    gl_->RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.width, size.height);
    gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
    gl_->BindRenderbuffer(GL_RENDERBUFFER, depth_);
    gl_->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, size.width, size.height);
    gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
    gl_->Viewport(0, 0, size.width, size.height);
    mesh_ = std::make_unique<mesa_mesh>(*gl_, mesh, camera, size);
    mesh_->bind(to_clip_);
    if (sides != culling::none) {
        gl_->Enable(GL_CULL_FACE);
        gl_->CullFace(sides == culling::back ? GL_BACK : GL_FRONT);
    } else {
        gl_->Disable(GL_CULL_FACE);
    }
}

void mesa_peer::draw() {
    gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    mesh_->draw();
    gl_->Finish();
}

std::vector<std::uint8_t> mesa_peer::picture() {
    return gl_->red_rows(size_);
}
