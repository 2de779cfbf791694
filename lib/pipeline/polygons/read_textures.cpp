// SPDX-License-Identifier: MIT
// l3d_read_textures: each picture that is shown, once.
#include "pipeline/polygons/read_textures.h"

#include "base/error.h"
#include "base/printable_p.h"
#include "tool_2d/image_file.h"

#include <cstddef>

namespace {

std::shared_ptr<const l3d_texture> texture_of(const l3d_mesh_picture& picture) {
    l3d_image image = picture.bytes.empty()
                          ? l3d_read_image(picture.name, l3d_most_texture_pixels)
                          : l3d_decoded_image(picture.bytes, picture.name, l3d_most_texture_pixels);
    const auto wrap = [](bool repeats) {
        return repeats ? l3d_texture_wrap::repeat : l3d_texture_wrap::clamp;
    };
    return std::make_shared<const l3d_texture>(image.pixels(), wrap(picture.repeats_u),
                                               wrap(picture.repeats_v));
}

} // namespace

std::vector<std::shared_ptr<const l3d_texture>> l3d_read_textures(const l3d_polygon_mesh& mesh,
                                                                  std::vector<std::string>& notes) {
    std::vector<std::shared_ptr<const l3d_texture>> textures(mesh.pictures.size());
    if (mesh.looks.empty())
        return textures;
    std::vector<bool> is_shown(mesh.pictures.size());
    for (const std::uint32_t material : mesh.face_materials)
        if (const int picture = mesh.looks[material].picture; picture != l3d_material::no_picture)
            is_shown[static_cast<std::size_t>(picture)] = true;
    for (std::size_t i = 0; i < textures.size(); ++i)
        try {
            if (is_shown[i])
                textures[i] = texture_of(mesh.pictures[i]);
        } catch (const l3d_error& error) {
            notes.push_back(l3d_detail::printable(error.what()) +
                            "; its faces have the colours of their materials");
        }
    return textures;
}
