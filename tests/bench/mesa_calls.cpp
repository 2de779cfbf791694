// SPDX-License-Identifier: MIT
// mesa_calls: GL without a window, by the library's own way to it.
#include "bench/mesa_calls.h"

#include "tool_2d/mesa/mesa_context_p.h"

#include <algorithm>
#include <limits>
#include <utility>

using namespace l3d_detail;

namespace {

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

const char* const mesa_mesh_shader = R"(#version 130
uniform mat4 to_clip;
in vec3 position;
in float grey;
out float shade;
void main() { shade = grey; gl_Position = to_clip * vec4(position, 1.0); }
)";

std::unique_ptr<mesa_calls> mesa_calls::open(std::string& why) {
    auto gl = std::make_unique<mesa_calls>();
    gl->platform = open_mesa_egl_surfaceless(why);
    if (!gl->platform)
        gl->platform = open_mesa_osmesa(why);
    if (!gl->platform)
        return nullptr;
    const char* missing = nullptr;
// NOLINTNEXTLINE(bugprone-macro-parentheses)
#define PEER_GL_FIND(name)                                                                         \
    if (gl->name = reinterpret_cast<decltype(gl->name)>(gl->platform->find("gl" #name));           \
        !gl->name)                                                                                 \
        missing = "gl" #name;
    PEER_GL_CALLS(PEER_GL_FIND)
#undef PEER_GL_FIND
    if (missing) {
        why = std::string("no ") + missing;
        return nullptr;
    }
    if (!is_software_renderer(gl->renderer())) {
        why = gl->renderer() + " is not software";
        return nullptr;
    }
    return gl;
}

std::string mesa_calls::renderer() const {
    return reinterpret_cast<const char*>(GetString(GL_RENDERER));
}

unsigned mesa_calls::program(const char* vertex, const char* fragment, std::string& why) const {
    const unsigned made = CreateProgram();
    for (const auto& [kind, text] :
         {std::pair{GL_VERTEX_SHADER, vertex}, std::pair{GL_FRAGMENT_SHADER, fragment}}) {
        const unsigned shader = CreateShader(static_cast<GLenum>(kind));
        ShaderSource(shader, 1, &text, nullptr);
        CompileShader(shader);
        AttachShader(made, shader);
        DeleteShader(shader);
    }
    BindAttribLocation(made, 0, "position");
    BindAttribLocation(made, 1, "grey");
    BindAttribLocation(made, 2, "place");
    LinkProgram(made);
    int linked = 0;
    GetProgramiv(made, GL_LINK_STATUS, &linked);
    if (linked)
        return made;
    why = "GL does not compile the peer's shaders";
    return 0;
}

std::vector<std::uint8_t> mesa_calls::red_rows(l3d_size size) const {
    const auto width = static_cast<std::size_t>(size.width);
    const auto height = static_cast<std::size_t>(size.height);
    std::vector<std::uint8_t> below(width * height), result;
    PixelStorei(GL_PACK_ALIGNMENT, 1);
    ReadPixels(0, 0, size.width, size.height, GL_RED, GL_UNSIGNED_BYTE, below.data());
    for (std::size_t y = height; y-- > 0;)
        result.insert(result.end(), below.begin() + static_cast<std::ptrdiff_t>(y * width),
                      below.begin() + static_cast<std::ptrdiff_t>((y + 1) * width));
    return result;
}

mesa_mesh::mesa_mesh(const mesa_calls& gl, const peer_mesh& mesh, const l3d_camera& camera,
                     l3d_size size)
    : gl_(gl), count_(static_cast<int>(mesh.indices.size())) {
    gl_.GenBuffers(3, buffers_.data());
    const auto fill = [&](unsigned target, unsigned buffer, const auto& values) {
        gl_.BindBuffer(target, buffer);
        gl_.BufferData(target, static_cast<std::ptrdiff_t>(values.size() * sizeof(values[0])),
                       values.data(), GL_STATIC_DRAW);
    };
    fill(GL_ARRAY_BUFFER, buffers_[0], mesh.positions);
    fill(GL_ARRAY_BUFFER, buffers_[1], mesh.greys);
    if (mesh.vertices() <= 65536) {
        const std::vector<std::uint16_t> indices(mesh.indices.begin(), mesh.indices.end());
        fill(GL_ELEMENT_ARRAY_BUFFER, buffers_[2], indices);
        type_ = GL_UNSIGNED_SHORT;
    } else {
        fill(GL_ELEMENT_ARRAY_BUFFER, buffers_[2], mesh.indices);
        type_ = GL_UNSIGNED_INT;
    }
    constexpr double in_front = 0.999; // what rounding of positions may bring nearer
    to_clip_ = clip_matrix(camera, size,
                           std::max(camera.near_z, in_front * nearest_w(mesh, camera, size)));
}

mesa_mesh::~mesa_mesh() {
    gl_.DeleteBuffers(3, buffers_.data());
}

void mesa_mesh::bind(int to_clip) const {
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    gl_.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[1]);
    gl_.VertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl_.EnableVertexAttribArray(0);
    gl_.EnableVertexAttribArray(1);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[2]);
    gl_.UniformMatrix4fv(to_clip, 1, GL_FALSE, to_clip_.data());
}
