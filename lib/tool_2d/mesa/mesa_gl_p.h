// SPDX-License-Identifier: MIT
// mesa_gl: the GL calls that the mesa files make, found at run time.
#ifndef L3D_TOOL_2D_MESA_MESA_GL_P_H
#define L3D_TOOL_2D_MESA_MESA_GL_P_H

// The prototypes give the types of the pointers; nothing links with them.
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/gl.h>
#include <GL/glext.h>

// One list for both the members and the search for them, one family of calls a line. The names
// are pasted, so they cannot stand in parentheses. NOLINTBEGIN(bugprone-macro-parentheses)
// clang-format off
#define L3D_MESA_GL_CALLS(call) \
    call(GetString) call(GetError) \
    call(Enable) call(Disable) call(Viewport) call(PixelStorei) call(ReadPixels) \
    call(BlendFuncSeparate) call(ColorMask) call(DepthMask) call(DepthFunc) call(Clear) call(ClearColor) call(ClearDepth) \
    call(GenTextures) call(BindTexture) call(TexImage2D) call(TexSubImage2D) \
    call(GenFramebuffers) call(BindFramebuffer) call(FramebufferTexture2D) \
    call(CheckFramebufferStatus) \
    call(CreateShader) call(ShaderSource) call(CompileShader) call(DeleteShader) \
    call(CreateProgram) call(AttachShader) call(BindAttribLocation) call(LinkProgram) \
    call(GetProgramiv) call(UseProgram) call(GetUniformLocation) \
    call(Uniform1i) call(Uniform2f) call(Uniform3f) \
    call(UniformMatrix3fv) call(UniformMatrix4fv) \
    call(GenBuffers) call(DeleteBuffers) call(BindBuffer) call(BufferData) \
    call(VertexAttribPointer) call(EnableVertexAttribArray) call(DrawArrays) call(DrawElements) \
    call(GenQueries) call(BeginQuery) call(EndQuery) call(GetQueryObjectuiv)
// clang-format on

namespace l3d_detail {

/// The GL calls of the library that was found: gl.Clear(...) is glClear(...) of this library.
struct mesa_gl {
#define L3D_MESA_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
    L3D_MESA_GL_CALLS(L3D_MESA_GL_MEMBER)
#undef L3D_MESA_GL_MEMBER

    /// Fills the table: find(name) gives a pointer to each call, or null.
    /// Errors: returns the name of a call that is missing; null if no call is missing.
    template <class Find> const char* load(const Find& find) {
        const char* missing = nullptr;
#define L3D_MESA_GL_FIND(name)                                                                     \
    if (name = reinterpret_cast<decltype(name)>(find("gl" #name)); !name)                          \
        missing = "gl" #name;
        L3D_MESA_GL_CALLS(L3D_MESA_GL_FIND)
#undef L3D_MESA_GL_FIND
        return missing;
    }
};
// NOLINTEND(bugprone-macro-parentheses)

} // namespace l3d_detail

#endif
