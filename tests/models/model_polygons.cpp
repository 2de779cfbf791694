// SPDX-License-Identifier: MIT
// model_polygons FILE...: what the readers find in model files, for comparison with other readers.
// A line `file NAME` for each, then `f` and the places of the corners for each face, or `error
// WHY`.
#include "base/error.h"
#include "scene/model_loader.h"

#include <cstdio>

namespace {

void print(const l3d_polygon_mesh& mesh) {
    for (std::size_t face = 0; face < mesh.faces(); ++face) {
        std::printf("f");
        for (const std::uint32_t corner : mesh.face(face)) {
            const auto& v = mesh.vertices[corner];
            std::printf(" %.17g %.17g %.17g", v[0], v[1], v[2]);
        }
        std::printf("\n");
    }
}

} // namespace

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        std::printf("file %s\n", argv[i]);
        try {
            print(l3d_load_model(argv[i], argv[i]).mesh);
        } catch (const l3d_error& error) {
            std::printf("error %s\n", error.what());
        }
    }
    return 0;
}
