// SPDX-License-Identifier: MIT
// The plug-in libl3d_subdivision.so: Catmull-Clark surfaces as bicubic patches, by OpenSubdiv's
// Far.
#include "limit_patches.h"

#include "geom/files/subdivision_plugin_p.h"

#include <opensubdiv/far/error.h>

#include <exception>
#include <utility>

namespace {

using namespace l3d_limit;
using sdc_options = OpenSubdiv::Sdc::Options;

mesh_topology topology_of(const l3d_detail::subdivision_cage& cage) {
    const auto as_int = [](std::uint32_t number) { return static_cast<int>(number); };
    mesh_topology result;
    result.vertices = as_int(cage.vertices);
    std::uint32_t begin = 0;
    for (std::uint32_t face = 0; face < cage.faces; ++face) {
        result.face_sizes.push_back(as_int(cage.face_ends[face] - begin));
        for (; begin < cage.face_ends[face]; ++begin)
            result.corners.push_back(as_int(cage.corners[begin]));
    }
    for (std::uint32_t i = 0; i < cage.creases; ++i) {
        result.crease_vertices.push_back(as_int(cage.crease_vertices[2 * i]));
        result.crease_vertices.push_back(as_int(cage.crease_vertices[2 * i + 1]));
        result.crease_sharpness.push_back(cage.crease_sharpness[i]);
    }
    for (std::uint32_t i = 0; i < cage.points; ++i) {
        result.point_vertices.push_back(as_int(cage.point_vertices[i]));
        result.point_sharpness.push_back(cage.point_sharpness[i]);
    }
    for (std::uint32_t i = 0; i < cage.holes; ++i)
        result.holes.push_back(as_int(cage.hole_faces[i]));
    return result;
}

int subdivide(const l3d_detail::subdivision_cage* cage, const l3d_detail::subdivision_sink* sink,
              l3d_detail::subdivision_outcome* outcome) {
    try {
        // Otherwise Far prints to the standard output, which is the program's own.
        OpenSubdiv::Far::SetErrorCallback([](OpenSubdiv::Far::ErrorType, const char*) {});
        OpenSubdiv::Far::SetWarningCallback([](const char*) {});
        std::vector<place> places;
        for (std::size_t i = 0; i < cage->vertices; ++i)
            places.push_back(
                {cage->places[3 * i], cage->places[3 * i + 1], cage->places[3 * i + 2]});
        sdc_options options;
        options.SetVtxBoundaryInterpolation(cage->keeps_corners
                                                ? sdc_options::VTX_BOUNDARY_EDGE_AND_CORNER
                                                : sdc_options::VTX_BOUNDARY_EDGE_ONLY);
        const limit_patches made(topology_of(*cage), places, options, cage->wanted_error,
                                 cage->most_patches);
        for (std::size_t i = 0; i < made.patches.size(); ++i) {
            std::array<double, 48> points{};
            for (std::size_t k = 0; k < points.size(); ++k)
                points[k] = made.patches[i][k % 3][k / 3];
            sink->take(sink->to, static_cast<std::uint32_t>(made.leaves[i].base_face),
                       points.data(), made.errors[i], made.leaves[i].is_regular ? 0U : 1U);
        }
        *outcome = {made.error, static_cast<std::uint32_t>(made.levels),
                    static_cast<std::uint32_t>(made.caps)};
        return 1;
    } catch (const std::exception& error) {
        sink->fail(sink->to, error.what());
        return 0;
    }
}

} // namespace

extern "C" {
__attribute__((
    visibility("default"))) extern const l3d_detail::subdivision_plugin l3d_subdivision_plugin;
const l3d_detail::subdivision_plugin l3d_subdivision_plugin{
    {l3d_detail::subdivision_plugin_version, sizeof(l3d_detail::subdivision_plugin)}, subdivide};
}
