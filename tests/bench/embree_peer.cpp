// SPDX-License-Identifier: MIT
// embree_peer: packets of rays, and their shading.
#include "bench/embree_peer.h"

#include <algorithm>
#include <array>
#include <limits>

namespace {

/// A packet is a tile of pixels so wide.
constexpr int tile = 4;

/// Packets a call: a twentieth faster than one by one.
constexpr int stream = 16;

template <class Packet>
[[gnu::always_inline]] inline void aim_packet(const ray_directions& d, int left, int top,
                                              Packet& packet) {
    constexpr int rays = embree_rays_of<Packet>;
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
    for (int i = 0; i < embree_rays_of<Packet>; ++i) {
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

std::unique_ptr<embree_peer> embree_peer::open(std::string& why) {
    auto scene = embree_scene::open(why);
    return scene ? std::unique_ptr<embree_peer>(new embree_peer(std::move(scene))) : nullptr;
}

void embree_peer::prepare(const peer_mesh& mesh, const l3d_camera& camera, l3d_size size,
                          int rays) {
    rays_ = rays;
    picture_ = l3d_image(size, l3d_padded_stride(size.width));
    scene_->set(mesh, camera, size);
}

void embree_peer::draw(l3d_workers& workers) {
    const int tall = rays_ / tile;
    workers.for_each(picture_.pixels().height / tall, [this, tall](int item, int) {
        if (rays_ == embree_rays_of<RTCRayHit8>)
            draw_row<RTCRayHit8>(item * tall);
        else
            draw_row<RTCRayHit16>(item * tall);
    });
}

template <class Packet> void embree_peer::draw_row(int top) {
    constexpr int rays = embree_rays_of<Packet>;
    const l3d_pixels pixels = picture_.pixels();
    const ray_directions& d = scene_->directions;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;

    auto packets = embree_packets<Packet, stream>(d);
    const triangle_greys greys{scene_->grey.data(), scene_->along_u.data(), scene_->along_v.data()};
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
