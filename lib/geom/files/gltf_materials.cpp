// SPDX-License-Identifier: MIT
// gltf_materials: reads base colours and their pictures, and notes everything else.
#include "geom/files/gltf_materials_p.h"

#include <algorithm>
#include <cmath>

namespace l3d_detail {

namespace {

std::uint32_t word_of(const std::array<double, 3>& light) {
    std::uint32_t word = 0;
    for (const double component : light)
        word = word << 8 | static_cast<std::uint32_t>(std::lround(255 * encoded(component)));
    return word;
}

/// Whether a material has properties that are not drawn. A missing factor of metal or roughness
/// counts as 1, as glTF says.
bool says_more_than_color(const gltf_value& material) {
    std::array<double, 3> own_light{0, 0, 0};
    read_array(material, "emissiveFactor", own_light);
    const bool glows = own_light != std::array<double, 3>{0, 0, 0};
    if (glows || material.text_or("alphaMode", "") == "MASK")
        return true;
    if (!material.has("pbrMetallicRoughness"))
        return false;
    const gltf_value look = material.at("pbrMetallicRoughness");
    const auto factor = [&](const char* name) {
        return look.has(name) ? look.at(name).number() : 1;
    };
    return factor("metallicFactor") != 0 || factor("roughnessFactor") != 1;
}

} // namespace

double encoded(double light) {
    const double held = std::clamp(light, 0.0, 1.0);
    return held <= 0.0031308 ? 12.92 * held : 1.055 * std::pow(held, 1 / 2.4) - 0.055;
}

void gltf_materials::read() {
    for (std::size_t i = 0; i < root_.count("materials"); ++i)
        read_material(root_.element("materials", i), "material " + std::to_string(i));
    if (has_other_textures_)
        note("of textures, those of base colours are drawn alone");
    if (has_transforms_)
        note("'KHR_texture_transform' is skipped: pictures lie as they are");
    if (shines_)
        note("of materials, metalness, roughness, own light and cut-outs are skipped");
}

void gltf_materials::read_material(const gltf_value& material, const std::string& usual_name) {
    std::array<double, 4> color{1, 1, 1, 1};
    picture_use picture;
    const auto read_look = [&](const gltf_value& of, const char* factor, const char* texture) {
        read_array(of, factor, color);
        if (of.has(texture))
            picture = picture_of(of.at(texture));
    };
    if (material.has("pbrMetallicRoughness"))
        read_look(material.at("pbrMetallicRoughness"), "baseColorFactor", "baseColorTexture");
    if (material.has("extensions") && material.at("extensions").has(glossiness))
        read_look(material.at("extensions").at(glossiness), "diffuseFactor", "diffuseTexture");
    sets_.push_back(picture.set);
    note_other_textures(material);
    const bool is_blended = material.text_or("alphaMode", "") == "BLEND";
    const double alpha = is_blended ? std::clamp(color[3], 0.0, 1.0) : 1;
    shines_ = shines_ || says_more_than_color(material);
    model_.mesh.materials.push_back(material.text_or("name", usual_name));
    model_.mesh.looks.push_back({.color = word_of({color[0], color[1], color[2]}),
                                 .opacity = static_cast<float>(alpha),
                                 .picture = picture.place});
}

void gltf_materials::note_other_textures(const gltf_value& material) {
    const auto metal = [&] {
        return material.has("pbrMetallicRoughness") &&
               material.at("pbrMetallicRoughness").has("metallicRoughnessTexture");
    };
    has_other_textures_ = has_other_textures_ || material.has("normalTexture") ||
                          material.has("occlusionTexture") || material.has("emissiveTexture") ||
                          metal();
}

/// The picture of a material's texture. A fault becomes a note, so that no model is lost for a
/// picture.
gltf_materials::picture_use gltf_materials::picture_of(const gltf_value& use) {
    try {
        const gltf_value texture = root_.element("textures", use.at("index").whole());
        has_transforms_ = has_transforms_ || (use.has("extensions") &&
                                              use.at("extensions").has("KHR_texture_transform"));
        if (!texture.has("source"))
            texture.fail("has no source of a kind that is read here");
        return {picture_of_image(texture), use.whole_or("texCoord", 0)};
    } catch (const gltf_error& error) {
        note(std::string(error.what()).substr(1) +
             "; its faces have the colours of their materials");
        return {};
    }
}

/// The index of a texture's picture in the mesh. A faulty image is noted once, for the first
/// texture that uses it.
int gltf_materials::picture_of_image(const gltf_value& texture) {
    constexpr std::uint64_t clamp = 33071, mirror = 33648, repeat = 10497;
    std::uint64_t wrap_u = repeat, wrap_v = repeat;
    if (texture.has("sampler")) {
        const gltf_value sampler = root_.element("samplers", texture.at("sampler").whole());
        wrap_u = sampler.whole_or("wrapS", repeat);
        wrap_v = sampler.whole_or("wrapT", repeat);
    }
    const std::uint64_t source = texture.at("source").whole();
    const auto [found, is_new] =
        pictures_.try_emplace({source, wrap_u, wrap_v}, l3d_material::no_picture);
    if (is_new) {
        const gltf_value image = root_.element("images", source);
        std::string bytes = document_.image_bytes(image, files_);
        if (bytes.empty())
            image.fail("is empty");
        found->second = static_cast<int>(model_.mesh.pictures.size());
        model_.mesh.pictures.push_back({name_ + ": " + image.place(), std::move(bytes),
                                        wrap_u != clamp, wrap_v != clamp, wrap_u == mirror,
                                        wrap_v == mirror});
    }
    return found->second;
}

} // namespace l3d_detail
