// SPDX-License-Identifier: MIT
// embree_scene: a device, and what is built of a mesh.
#include "bench/embree_scene.h"

#include <cstring>

ray_directions::ray_directions(const l3d_camera& camera, l3d_size size) {
    const auto axes = camera.axes();
    const double focal = camera.focal_length(size);
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        eye[i] = static_cast<float>(camera.eye[k]);
        right[i] = static_cast<float>(axes.right[k] / focal);
        down[i] = static_cast<float>(-axes.up[k] / focal);
        first[i] =
            static_cast<float>(axes.forward[k] + (0.5 - size.width / 2.0) * axes.right[k] / focal -
                               (0.5 - size.height / 2.0) * axes.up[k] / focal);
    }
}

std::unique_ptr<embree_scene> embree_scene::open(std::string& why) {
    const RTCDevice device = rtcNewDevice(nullptr);
    if (device)
        return std::make_unique<embree_scene>(device);
    why = "Embree has no device";
    return nullptr;
}

embree_scene::~embree_scene() {
    rtcReleaseScene(handle);
    rtcReleaseDevice(device);
}

void embree_scene::set(const peer_mesh& mesh, const l3d_camera& camera, l3d_size size) {
    directions = ray_directions(camera, size);
    rtcReleaseScene(handle);
    handle = rtcNewScene(device);
    rtcSetSceneBuildQuality(handle, RTC_BUILD_QUALITY_HIGH);
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const auto copy = [&](RTCBufferType type, RTCFormat format, const auto& values) {
        const std::size_t bytes = 3 * sizeof(values[0]);
        std::memcpy(rtcSetNewGeometryBuffer(geometry, type, 0, format, bytes, values.size() / 3),
                    values.data(), values.size() * sizeof(values[0]));
    };
    copy(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions);
    copy(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.indices);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(handle, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(handle);

    grey.clear();
    along_u.clear();
    along_v.clear();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto level = [&](std::size_t corner) {
            constexpr float white = 255;
            return white * mesh.greys[mesh.indices[i + corner]];
        };
        grey.push_back(level(0));
        along_u.push_back(level(1) - level(0));
        along_v.push_back(level(2) - level(0));
    }
}
