// SPDX-License-Identifier: MIT
// The GL calls of the peers that llvmpipe draws, a program of shaders, and a mesh in its buffers.
#ifndef L3D_TESTS_BENCH_MESA_CALLS_H
#define L3D_TESTS_BENCH_MESA_CALLS_H

#include "bench/peer_mesh.h"
#include "scene/camera.h"
#include "tool_2d/mesa/mesa_platform_p.h"
#include "tool_2d/pixels.h"

// The prototypes give the types of the pointers; nothing links with them.
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

// NOLINTBEGIN(bugprone-macro-parentheses)
// clang-format off
#define PEER_GL_CALLS(call) \
    call(GetString) call(Enable) call(Disable) call(Viewport) call(DepthFunc) call(ClearDepth) \
    call(Clear) call(Finish) call(CullFace) call(PixelStorei) call(ReadPixels) \
    call(GenBuffers) call(BindBuffer) call(BufferData) call(DeleteBuffers) \
    call(GenTextures) call(BindTexture) call(TexImage2D) call(TexImage2DMultisample) \
    call(TexParameteri) call(TexParameterf) call(GenerateMipmap) \
    call(GenRenderbuffers) call(BindRenderbuffer) call(RenderbufferStorage) \
    call(RenderbufferStorageMultisample) \
    call(GenFramebuffers) call(BindFramebuffer) call(FramebufferTexture2D) \
    call(FramebufferRenderbuffer) call(CheckFramebufferStatus) \
    call(CreateShader) call(ShaderSource) call(CompileShader) call(DeleteShader) \
    call(CreateProgram) call(AttachShader) call(BindAttribLocation) call(LinkProgram) \
    call(GetProgramiv) call(UseProgram) call(GetUniformLocation) \
    call(UniformMatrix4fv) call(VertexAttribPointer) call(EnableVertexAttribArray) \
    call(DrawArrays) call(DrawElements)
// clang-format on

/// calls.Clear(...) is glClear(...) of a software GL without a window.
struct mesa_calls {
    std::unique_ptr<l3d_detail::mesa_platform> platform;
#define PEER_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
    PEER_GL_CALLS(PEER_GL_MEMBER)
#undef PEER_GL_MEMBER

    /// Errors: null, with one line in `why`, if there is no software GL.
    /// LP_NUM_THREADS is read at the first call in a process.
    static std::unique_ptr<mesa_calls> open(std::string& why);

    std::string renderer() const;

    /// A program of two shaders; `position` is attribute 0, `grey` 1 and `place` 2.
    /// Errors: 0, with one line in `why`.
    unsigned program(const char* vertex, const char* fragment, std::string& why) const;

    /// The red channel of the framebuffer that is read from, top row first.
    std::vector<std::uint8_t> red_rows(l3d_size size) const;
};
// NOLINTEND(bugprone-macro-parentheses)

/// A vertex shader that places a mesh by `to_clip` and hands its greys on as `shade`.
extern const char* const mesa_mesh_shader;

/// A mesh in static buffers, and the matrix that places it.
///
/// Lives: no longer than the calls; the buffers end with the mesh.
class mesa_mesh {
public:
    /// Expects: a mesh for this camera and size, as far as proportions go.
    mesa_mesh(const mesa_calls& gl, const peer_mesh& mesh, const l3d_camera& camera, l3d_size size);
    mesa_mesh(const mesa_mesh&) = delete;
    mesa_mesh& operator=(const mesa_mesh&) = delete;
    ~mesa_mesh();

    /// Makes it what draw() draws, by the uniform `to_clip` of the program in use.
    void bind(int to_clip) const;
    void draw() const { gl_.DrawElements(GL_TRIANGLES, count_, type_, nullptr); }

private:
    const mesa_calls& gl_;
    std::array<unsigned, 3> buffers_{}; ///< places, greys, indices
    std::array<float, 16> to_clip_{};
    int count_ = 0;
    unsigned type_ = 0;
};

#endif
