// SPDX-License-Identifier: MIT
// mesa_textured_peer: places of vertices, a texture with mipmaps, an sRGB framebuffer.
#include "bench/mesa_textured_peer.h"

#include "geom/normal_net.h"
#include "scene/patch_scene.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace {

constexpr const char* vertex_text = R"(#version 130
uniform mat4 to_clip;
in vec3 position;
in float grey;
in vec2 place;
out float shade;
out vec2 at;
void main() { shade = grey; at = place; gl_Position = to_clip * vec4(position, 1.0); }
)";

/// The grey is a level, as ours is; the picture's colour is light.
constexpr const char* fragment_text = R"(#version 130
uniform sampler2D picture;
in float shade;
in vec2 at;
out vec4 color;
void main() { color = vec4(texture(picture, at).rgb * shade, 1.0); }
)";

struct placed_mesh {
    peer_mesh mesh;
    std::vector<float> places; ///< u and v of each vertex
};

placed_mesh mesh_of(const l3d_patch_model& model, const l3d_camera& camera, int quads,
                    bool is_plain) {
    placed_mesh result;
    const auto columns = static_cast<std::uint32_t>(quads + 1);
    for (std::size_t p = 0; p < model.patches().size(); ++p) {
        const l3d_parameter_range range = model.range_in_piece(p);
        const auto first = static_cast<std::uint32_t>(result.mesh.vertices());
        for (std::uint32_t i = 0; i < columns * columns; ++i) {
            const double u = double(i % columns) / quads, v = double(i / columns) / quads;
            const auto at = model.patches()[p].evaluate(u, v);
            for (int k = 0; k < 3; ++k)
                result.mesh.positions.push_back(static_cast<float>(at[k]));
            auto normal = l3d_normalized(model.normals(p).evaluate(u, v));
            if (l3d_dot(normal, camera.eye - at) < 0)
                normal = normal * -1.0;
            const double lit = std::max(0.0, l3d_dot(normal, l3d_normalized(l3d_usual_light)));
            result.mesh.greys.push_back(is_plain ? 1.0F : static_cast<float>(0.1 + 0.9 * lit));
            result.places.push_back(static_cast<float>(range.u0 + u * (range.u1 - range.u0)));
            result.places.push_back(static_cast<float>(range.v0 + v * (range.v1 - range.v0)));
        }
        for (std::uint32_t row = 0; row + 1 < columns; ++row)
            for (std::uint32_t column = 0; column + 1 < columns; ++column) {
                const std::uint32_t i = first + row * columns + column;
                for (const std::uint32_t corner :
                     {i, i + 1, i + columns, i + 1, i + columns + 1, i + columns})
                    result.mesh.indices.push_back(corner);
            }
    }
    return result;
}

} // namespace

std::unique_ptr<mesa_textured_peer> mesa_textured_peer::open(std::string& why) {
    auto gl = mesa_calls::open(why);
    if (!gl)
        return nullptr;
    std::unique_ptr<mesa_textured_peer> peer(new mesa_textured_peer(std::move(gl)));
    return peer->make_program(why) ? std::move(peer) : nullptr;
}

bool mesa_textured_peer::make_program(std::string& why) {
    const unsigned program = gl_->program(vertex_text, fragment_text, why);
    if (!program)
        return false;
    gl_->UseProgram(program);
    to_clip_ = gl_->GetUniformLocation(program, "to_clip");
    gl_->Disable(GL_DITHER);
    gl_->Enable(GL_FRAMEBUFFER_SRGB);
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_GREATER);
    gl_->ClearDepth(0);
    return true;
}

void mesa_textured_peer::make_framebuffer(l3d_size size) {
    unsigned color = 0, depth = 0, framebuffer = 0;
    gl_->GenRenderbuffers(1, &color);
    gl_->GenRenderbuffers(1, &depth);
    gl_->GenFramebuffers(1, &framebuffer);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl_->BindRenderbuffer(GL_RENDERBUFFER, color);
    gl_->RenderbufferStorage(GL_RENDERBUFFER, GL_SRGB8_ALPHA8, size.width, size.height);
    gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    gl_->BindRenderbuffer(GL_RENDERBUFFER, depth);
    gl_->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, size.width, size.height);
    gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    gl_->Viewport(0, 0, size.width, size.height);
    size_ = size;
}

void mesa_textured_peer::prepare(const l3d_patch_model& model, const l3d_camera& camera,
                                 l3d_size size, int quads, const l3d_pixels& picture,
                                 bool is_plain) {
    make_framebuffer(size);
    const placed_mesh placed = mesh_of(model, camera, quads, is_plain);
    mesh_ = std::make_unique<mesa_mesh>(*gl_, placed.mesh, camera, size);
    mesh_->bind(to_clip_);
    unsigned places = 0, texture = 0;
    gl_->GenBuffers(1, &places);
    gl_->BindBuffer(GL_ARRAY_BUFFER, places);
    gl_->BufferData(GL_ARRAY_BUFFER,
                    static_cast<std::ptrdiff_t>(placed.places.size() * sizeof(float)),
                    placed.places.data(), GL_STATIC_DRAW);
    gl_->VertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl_->EnableVertexAttribArray(2);
    gl_->GenTextures(1, &texture);
    gl_->BindTexture(GL_TEXTURE_2D, texture);
    std::vector<std::uint32_t> words;
    for (int y = 0; y < picture.height; ++y)
        for (const std::uint32_t word : picture.row(y))
            words.push_back(word | 0xff000000);
    gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, picture.width, picture.height, 0, GL_BGRA,
                    GL_UNSIGNED_INT_8_8_8_8_REV, words.data());
    gl_->GenerateMipmap(GL_TEXTURE_2D);
    for (const GLenum wrap : {GLenum{GL_TEXTURE_WRAP_S}, GLenum{GL_TEXTURE_WRAP_T}})
        gl_->TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
}

bool mesa_textured_peer::take(l3d_texture_filter filter) {
    using f = l3d_texture_filter;
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                       filter == f::nearest ? GL_NEAREST : GL_LINEAR);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                       filter == f::nearest    ? GL_NEAREST
                       : filter == f::bilinear ? GL_LINEAR
                                               : GL_LINEAR_MIPMAP_LINEAR);
    const auto* const extensions = reinterpret_cast<const char*>(gl_->GetString(GL_EXTENSIONS));
    const bool has_anisotropic =
        extensions && std::strstr(extensions, "texture_filter_anisotropic") != nullptr;
    if (has_anisotropic)
        gl_->TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT,
                           filter == f::anisotropic ? l3d_texture::most_samples : 1);
    return has_anisotropic || filter != f::anisotropic;
}

void mesa_textured_peer::draw() {
    gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    mesh_->draw();
    gl_->Finish();
}

std::vector<std::uint32_t> mesa_textured_peer::picture() const {
    const auto width = static_cast<std::size_t>(size_.width);
    std::vector<std::uint32_t> below(width * static_cast<std::size_t>(size_.height)), result;
    gl_->ReadPixels(0, 0, size_.width, size_.height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                    below.data());
    for (std::size_t y = static_cast<std::size_t>(size_.height); y-- > 0;)
        result.insert(result.end(), below.begin() + static_cast<std::ptrdiff_t>(y * width),
                      below.begin() + static_cast<std::ptrdiff_t>((y + 1) * width));
    return result;
}
