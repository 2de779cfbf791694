// SPDX-License-Identifier: MIT
// gltf_materials: the materials of a glTF file, and the pictures of their base colours.
#ifndef L3D_GEOM_FILES_GLTF_MATERIALS_P_H
#define L3D_GEOM_FILES_GLTF_MATERIALS_P_H

#include "base/counted_p.h"
#include "geom/files/gltf_document_p.h"
#include "geom/files/model_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace l3d_detail {

/// The extension for materials of diffuse colour and glossiness, an older model than metal and
/// roughness.
inline constexpr const char* glossiness = "KHR_materials_pbrSpecularGlossiness";

/// Encodes an amount of linear light as sRGB.
/// Units: argument and result are from 0 to 1.
/// Source: IEC 61966-2-1, sRGB.
double encoded(double light);

/// Reads the numbers of an array member into `out`. Returns false if the member is missing.
/// Errors:  gltf_error if the member does not have N numbers.
template <std::size_t N>
bool read_array(const gltf_value& of, const char* name, std::array<double, N>& out) {
    if (!of.has(name))
        return false;
    const gltf_value array = of.at(name);
    if (array.size() != N)
        array.fail("has " + counted(array.size(), "numbers") + ", not " + std::to_string(N));
    for (std::size_t i = 0; i < N; ++i)
        out[i] = array[i].number();
    return true;
}

/// Reads all materials into the model's mesh, and adds notes on features that it skips.
/// Lives:   borrows all arguments but the name.
class gltf_materials {
public:
    /// `name` is the file's name, with which notes begin.
    gltf_materials(const gltf_document& document, l3d_model_file& model, std::string name,
                   const l3d_other_files& files)
        : root_(document.root()), document_(document), model_(model), name_(std::move(name)),
          files_(files) {}

    /// Reads all materials. Errors: gltf_error. A faulty picture is no error, but becomes a note.
    void read();

    /// The n of the attribute TEXCOORD_n, which places a material's picture.
    /// Expects: read() was called.
    std::uint64_t set_of_places(std::size_t material) const { return sets_[material]; }

private:
    /// A picture's index in the mesh, and the n of the attribute TEXCOORD_n that places it.
    struct picture_use {
        int place = l3d_material::no_picture;
        std::uint64_t set = 0;
    };

    void read_material(const gltf_value& material, const std::string& usual_name);
    void note_other_textures(const gltf_value& material);
    picture_use picture_of(const gltf_value& use);
    int picture_of_image(const gltf_value& texture);
    void note(const std::string& what) { model_.notes.push_back(name_ + ": " + what); }

    gltf_value root_;
    const gltf_document& document_;
    l3d_model_file& model_;
    std::string name_;
    const l3d_other_files& files_;
    /// Indices of the mesh's pictures. A key is an image and the codes for wrapping along u and v.
    std::map<std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>, int> pictures_;
    std::vector<std::uint64_t> sets_; ///< set_of_places() of each material
    bool shines_ = false, has_other_textures_ = false, has_transforms_ = false;
};

} // namespace l3d_detail

#endif
