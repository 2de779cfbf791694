// SPDX-License-Identifier: MIT
// mesa_peer: GL without a window, by the library's own way to it.
#include "bench/mesa_peer.h"

#include "tool_2d/mesa/mesa_context_p.h"
#include "tool_2d/mesa/mesa_platform_p.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <limits>

using namespace l3d_detail;

// NOLINTBEGIN(bugprone-macro-parentheses)
// clang-format off
#define PEER_GL_CALLS(call) \
    call(GetString) call(Enable) call(Disable) call(Viewport) call(DepthFunc) call(ClearDepth) \
    call(Clear) call(Finish) call(CullFace) call(PixelStorei) call(ReadPixels) \
    call(GenBuffers) call(BindBuffer) call(BufferData) call(DeleteBuffers) \
    call(GenRenderbuffers) call(BindRenderbuffer) call(RenderbufferStorage) \
    call(DeleteRenderbuffers) call(GenFramebuffers) call(BindFramebuffer) \
    call(FramebufferRenderbuffer) call(DeleteFramebuffers) call(CheckFramebufferStatus) \
    call(CreateShader) call(ShaderSource) call(CompileShader) call(DeleteShader) \
    call(CreateProgram) call(AttachShader) call(BindAttribLocation) call(LinkProgram) \
    call(GetProgramiv) call(UseProgram) call(DeleteProgram) call(GetUniformLocation) \
    call(UniformMatrix4fv) call(VertexAttribPointer) call(EnableVertexAttribArray) \
    call(DrawElements)
// clang-format on

struct mesa_peer::calls {
    std::unique_ptr<mesa_platform> platform;
#define PEER_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
    PEER_GL_CALLS(PEER_GL_MEMBER)
#undef PEER_GL_MEMBER

    bool load(std::string& why) {
        const char* missing = nullptr;
#define PEER_GL_FIND(name)                                                                         \
    if (name = reinterpret_cast<decltype(name)>(platform->find("gl" #name)); !name)                \
        missing = "gl" #name;
        PEER_GL_CALLS(PEER_GL_FIND)
#undef PEER_GL_FIND
        if (missing)
            why = std::string("no ") + missing;
        return !missing;
    }
};
// NOLINTEND(bugprone-macro-parentheses)

namespace {

constexpr const char* vertex_text = R"(#version 130
uniform mat4 to_clip;
in vec3 position;
in float grey;
out float shade;
void main() { shade = grey; gl_Position = to_clip * vec4(position, 1.0); }
)";
constexpr const char* fragment_text = R"(#version 130
in float shade;
out vec4 color;
void main() { color = vec4(shade); }
)";

/// Clip space from the world: x and y to [-w, w]; depth is nearest / w, so that it grows with 1/w
/// as l3d's does, and uses all of its range.
std::array<float, 16> clip_matrix(const l3d_camera& camera, l3d_size size, double nearest) {
    const l3d_matrix<double> m = camera.image_matrix(size);
    std::array<float, 16> clip{};
    for (int column = 0; column < 4; ++column) {
        const auto at = static_cast<std::size_t>(4 * column);
        clip[at] = static_cast<float>(m(0, column) / (size.width / 2.0));
        clip[at + 1] = static_cast<float>(-m(1, column) / (size.height / 2.0));
        clip[at + 2] = static_cast<float>((column == 3 ? 2 * nearest : 0.0) - m(3, column));
        clip[at + 3] = static_cast<float>(m(3, column));
    }
    return clip;
}

double nearest_w(const peer_mesh& mesh, const l3d_camera& camera, l3d_size size) {
    const seen_world world(camera, size);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3)
        least = std::min(
            least, world({mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]})[2]);
    return least;
}

} // namespace

mesa_peer::mesa_peer(std::unique_ptr<calls> gl) : gl_(std::move(gl)) {}

mesa_peer::~mesa_peer() = default;

std::unique_ptr<mesa_peer> mesa_peer::open(std::string& why) {
    auto gl = std::make_unique<calls>();
    gl->platform = open_mesa_egl_surfaceless(why);
    if (!gl->platform)
        gl->platform = open_mesa_osmesa(why);
    if (!gl->platform || !gl->load(why))
        return nullptr;
    std::unique_ptr<mesa_peer> peer(new mesa_peer(std::move(gl)));
    if (!is_software_renderer(peer->renderer())) {
        why = peer->renderer() + " is not software";
        return nullptr;
    }
    return peer->make_program(why) ? std::move(peer) : nullptr;
}

std::string mesa_peer::renderer() const {
    return reinterpret_cast<const char*>(gl_->GetString(GL_RENDERER));
}

bool mesa_peer::make_program(std::string& why) {
    program_ = gl_->CreateProgram();
    for (const auto& [kind, text] :
         {std::pair{GL_VERTEX_SHADER, vertex_text}, std::pair{GL_FRAGMENT_SHADER, fragment_text}}) {
        const unsigned shader = gl_->CreateShader(static_cast<GLenum>(kind));
        gl_->ShaderSource(shader, 1, &text, nullptr);
        gl_->CompileShader(shader);
        gl_->AttachShader(program_, shader);
        gl_->DeleteShader(shader);
    }
    gl_->BindAttribLocation(program_, 0, "position");
    gl_->BindAttribLocation(program_, 1, "grey");
    gl_->LinkProgram(program_);
    int linked = 0;
    gl_->GetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (!linked) {
        why = "GL does not compile the peer's shaders";
        return false;
    }
    gl_->UseProgram(program_);
    matrix_ = gl_->GetUniformLocation(program_, "to_clip");
    gl_->GenBuffers(3, buffers_);
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

    const auto fill = [&](unsigned target, unsigned buffer, const auto& values) {
        gl_->BindBuffer(target, buffer);
        gl_->BufferData(target, static_cast<std::ptrdiff_t>(values.size() * sizeof(values[0])),
                        values.data(), GL_STATIC_DRAW);
    };
    fill(GL_ARRAY_BUFFER, buffers_[0], mesh.positions);
    gl_->VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    fill(GL_ARRAY_BUFFER, buffers_[1], mesh.greys);
    gl_->VertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl_->EnableVertexAttribArray(0);
    gl_->EnableVertexAttribArray(1);
    index_count_ = static_cast<int>(mesh.indices.size());
    if (mesh.vertices() <= 65536) {
        const std::vector<std::uint16_t> indices(mesh.indices.begin(), mesh.indices.end());
        fill(GL_ELEMENT_ARRAY_BUFFER, buffers_[2], indices);
        index_type_ = GL_UNSIGNED_SHORT;
    } else {
        fill(GL_ELEMENT_ARRAY_BUFFER, buffers_[2], mesh.indices);
        index_type_ = GL_UNSIGNED_INT;
    }
    if (sides != culling::none) {
        gl_->Enable(GL_CULL_FACE);
        gl_->CullFace(sides == culling::back ? GL_BACK : GL_FRONT);
    } else {
        gl_->Disable(GL_CULL_FACE);
    }
    constexpr double in_front = 0.999; // what rounding of positions may bring nearer
    const auto matrix = clip_matrix(camera, size, in_front * nearest_w(mesh, camera, size));
    gl_->UniformMatrix4fv(matrix_, 1, GL_FALSE, matrix.data());
}

void mesa_peer::draw() {
    gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_->DrawElements(GL_TRIANGLES, index_count_, index_type_, nullptr);
    gl_->Finish();
}

std::vector<std::uint8_t> mesa_peer::picture() {
    const auto width = static_cast<std::size_t>(size_.width);
    const auto height = static_cast<std::size_t>(size_.height);
    std::vector<std::uint8_t> below(width * height), result;
    gl_->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_->ReadPixels(0, 0, size_.width, size_.height, GL_RED, GL_UNSIGNED_BYTE, below.data());
    for (std::size_t y = height; y-- > 0;)
        result.insert(result.end(), below.begin() + static_cast<std::ptrdiff_t>(y * width),
                      below.begin() + static_cast<std::ptrdiff_t>((y + 1) * width));
    return result;
}
