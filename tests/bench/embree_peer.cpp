// SPDX-License-Identifier: MIT
// embree_peer: packets of rays, and their shading.
#include "bench/embree_peer.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace {

/// A packet is a tile of pixels so wide.
constexpr int tile = 4;

template <class Packet> constexpr int rays_of = sizeof(Packet::ray.dir_x) / sizeof(float);

/// Packets a call: a twentieth faster than one by one.
constexpr int stream = 16;

/// Directions of the rays of a picture: right and down are steps of one pixel.
struct ray_directions {
    std::array<float, 3> eye, first, right, down;
};

ray_directions directions_of(const l3d_camera& camera, l3d_size size) {
    const auto axes = camera.axes();
    const double focal = camera.focal_length(size);
    ray_directions d;
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        d.eye[i] = static_cast<float>(camera.eye[k]);
        d.right[i] = static_cast<float>(axes.right[k] / focal);
        d.down[i] = static_cast<float>(-axes.up[k] / focal);
        d.first[i] =
            static_cast<float>(axes.forward[k] + (0.5 - size.width / 2.0) * axes.right[k] / focal -
                               (0.5 - size.height / 2.0) * axes.up[k] / focal);
    }
    return d;
}

/// The machine decides what loops over a packet compile to, as it does in Embree.
#ifdef __x86_64__
#define PEER_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define PEER_CLONES
#endif

template <class Packet>
[[gnu::always_inline]] inline void aim_packet(const ray_directions& d, int left, int top,
                                              Packet& packet) {
    constexpr int rays = rays_of<Packet>;
    float* const dir[3] = {packet.ray.dir_x, packet.ray.dir_y, packet.ray.dir_z};
    for (std::size_t k = 0; k < 3; ++k)
        for (int i = 0; i < rays; ++i)
            dir[k][i] = d.first[k] + static_cast<float>(left + i % tile) * d.right[k] +
                        static_cast<float>(top + i / tile) * d.down[k];
    for (int i = 0; i < rays; ++i) {
        packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
}

PEER_CLONES void aim(const ray_directions& d, int left, int top, RTCRayHit8& packet) {
    aim_packet(d, left, top, packet);
}
PEER_CLONES void aim(const ray_directions& d, int left, int top, RTCRayHit16& packet) {
    aim_packet(d, left, top, packet);
}

/// Greys of a mesh's triangles: at a corner, and their changes along both parameters.
struct triangle_greys {
    const float *grey, *along_u, *along_v;
};

template <class Packet>
[[gnu::always_inline]] inline void shade_packet(const Packet& packet, const triangle_greys& of,
                                                std::uint32_t* words) {
    const auto& hit = packet.hit;
    for (int i = 0; i < rays_of<Packet>; ++i) {
        const bool is_hit = hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
        const std::uint32_t t = is_hit ? hit.primID[i] : 0;
        const float level = of.grey[t] + hit.u[i] * of.along_u[t] + hit.v[i] * of.along_v[t];
        words[i] =
            is_hit ? static_cast<std::uint32_t>(static_cast<int>(level + 0.5f)) * 0x010101u : 0;
    }
}

PEER_CLONES void shade(const RTCRayHit8& packet, const triangle_greys& of, std::uint32_t* words) {
    shade_packet(packet, of, words);
}
PEER_CLONES void shade(const RTCRayHit16& packet, const triangle_greys& of, std::uint32_t* words) {
    shade_packet(packet, of, words);
}

} // namespace

struct embree_peer::scene {
    RTCDevice device = nullptr;
    RTCScene handle = nullptr;
    ray_directions directions{};

    explicit scene(RTCDevice made) : device(made) {}
    scene(const scene&) = delete;
    scene& operator=(const scene&) = delete;
    ~scene() {
        rtcReleaseScene(handle);
        rtcReleaseDevice(device);
    }
};

embree_peer::embree_peer(std::unique_ptr<scene> made) : scene_(std::move(made)) {}
embree_peer::~embree_peer() = default;

std::unique_ptr<embree_peer> embree_peer::open(std::string& why) {
    const RTCDevice device = rtcNewDevice(nullptr);
    if (!device) {
        why = "Embree has no device";
        return nullptr;
    }
    return std::unique_ptr<embree_peer>(new embree_peer(std::make_unique<scene>(device)));
}

void embree_peer::prepare(const peer_mesh& mesh, const l3d_camera& camera, l3d_size size,
                          int rays) {
    rays_ = rays;
    scene& s = *scene_;
    s.directions = directions_of(camera, size);
    picture_ = l3d_image(size, l3d_padded_stride(size.width));

    rtcReleaseScene(s.handle);
    s.handle = rtcNewScene(s.device);
    rtcSetSceneBuildQuality(s.handle, RTC_BUILD_QUALITY_HIGH);
    const RTCGeometry geometry = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const auto copy = [&](RTCBufferType type, RTCFormat format, const auto& values) {
        const std::size_t bytes = 3 * sizeof(values[0]);
        std::memcpy(rtcSetNewGeometryBuffer(geometry, type, 0, format, bytes, values.size() / 3),
                    values.data(), values.size() * sizeof(values[0]));
    };
    copy(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions);
    copy(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.indices);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(s.handle, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(s.handle);

    grey_.clear();
    along_u_.clear();
    along_v_.clear();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto level = [&](std::size_t corner) {
            constexpr float white = 255;
            return white * mesh.greys[mesh.indices[i + corner]];
        };
        grey_.push_back(level(0));
        along_u_.push_back(level(1) - level(0));
        along_v_.push_back(level(2) - level(0));
    }
}

void embree_peer::draw(l3d_workers& workers) {
    const int tall = rays_ / tile;
    workers.for_each(picture_.pixels().height / tall, [this, tall](int item, int) {
        if (rays_ == rays_of<RTCRayHit8>)
            draw_row<RTCRayHit8>(item * tall);
        else
            draw_row<RTCRayHit16>(item * tall);
    });
}

template <class Packet> void embree_peer::draw_row(int top) {
    constexpr int rays = rays_of<Packet>;
    const l3d_pixels pixels = picture_.pixels();
    const ray_directions& d = scene_->directions;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;

    Packet first{};
    std::fill_n(first.ray.org_x, rays, d.eye[0]);
    std::fill_n(first.ray.org_y, rays, d.eye[1]);
    std::fill_n(first.ray.org_z, rays, d.eye[2]);
    std::fill_n(first.ray.mask, rays, ~0u);
    std::array<Packet, stream> packets;
    packets.fill(first);
    const triangle_greys greys{grey_.data(), along_u_.data(), along_v_.data()};
    std::array<std::uint32_t, rays> words;
    for (int left = 0; left < pixels.width; left += tile * stream) {
        const int count = std::min(stream, (pixels.width - left) / tile);
        for (int i = 0; i < count; ++i)
            aim(d, left + i * tile, top, packets[static_cast<std::size_t>(i)]);
        rtcIntersectNM(scene_->handle, &context, reinterpret_cast<RTCRayHitN*>(packets.data()),
                       rays, static_cast<unsigned>(count), sizeof(Packet));
        for (int i = 0; i < count; ++i) {
            shade(packets[static_cast<std::size_t>(i)], greys, words.data());
            for (int r = 0; r < rays / tile; ++r)
                std::copy_n(words.begin() + r * tile, tile,
                            pixels.row(top + r).begin() + left + i * tile);
        }
    }
}

std::string embree_peer::name() const {
    const auto version = rtcGetDeviceProperty(scene_->device, RTC_DEVICE_PROPERTY_VERSION);
    return "Embree " + std::to_string(version / 10000) + "." + std::to_string(version / 100 % 100) +
           "." + std::to_string(version % 100);
}
