// SPDX-License-Identifier: MIT
// embree_smooth_peer: packets of the rays of one pixel, and the mean of their light.
#include "bench/embree_smooth_peer.h"

#include "reference/light_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

/// Rays of a pixel.
constexpr int samples = 16;

/// Packets a call, as without anti-aliasing.
constexpr int stream = 16;

/// Places of the rays in a pixel, from its centre: 4 x 4. With a Hammersley set, each ray in a
/// column and a row of its own, pictures of fine meshes err up to 1.4 times as much.
struct ray_places {
    std::array<float, samples> x{}, y{};

    constexpr ray_places() {
        constexpr int side = 4;
        for (int i = 0; i < samples; ++i) {
            const auto at = static_cast<std::size_t>(i);
            x[at] = (static_cast<float>(i % side) + 0.5f) / side - 0.5f;
            y[at] = (static_cast<float>(i / side) + 0.5f) / side - 0.5f;
        }
    }
};
constexpr ray_places places;

/// The level of a mean of light. Table entries are a fifth of a level apart at most.
class level_table {
public:
    level_table() {
        for (std::size_t i = 0; i < entries; ++i)
            levels_[i] = static_cast<std::uint8_t>(std::lround(
                reference::level_of_light(static_cast<double>(i) / double{entries - 1})));
    }
    std::uint32_t operator()(float light) const {
        const float at = std::min(light, 1.0f) * static_cast<float>(entries - 1) + 0.5f;
        return levels_[static_cast<std::size_t>(at)];
    }

private:
    static constexpr std::size_t entries = 16384;
    std::array<std::uint8_t, entries> levels_;
};

const level_table& table() {
    static const level_table made;
    return made;
}

template <class Packet>
[[gnu::always_inline]] inline void aim_packet(const ray_directions& d, float x, float y,
                                              int first_place, Packet& packet) {
    constexpr int rays = embree_rays_of<Packet>;
    float* const dir[3] = {packet.ray.dir_x, packet.ray.dir_y, packet.ray.dir_z};
    const float* const right = places.x.data() + first_place;
    const float* const down = places.y.data() + first_place;
    for (std::size_t k = 0; k < 3; ++k)
        for (int i = 0; i < rays; ++i)
            dir[k][i] = d.first[k] + (x + right[i]) * d.right[k] + (y + down[i]) * d.down[k];
    for (int i = 0; i < rays; ++i) {
        packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
}

PEER_CLONES void aim(const ray_directions& d, float x, float y, int first, RTCRayHit8& packet) {
    aim_packet(d, x, y, first, packet);
}
PEER_CLONES void aim(const ray_directions& d, float x, float y, int first, RTCRayHit16& packet) {
    aim_packet(d, x, y, first, packet);
}

struct triangle_greys {
    const float *grey, *along_u, *along_v;
};

/// The sum of a packet's light. Levels are decoded by a polynomial that is wrong by 0.06 levels at
/// most from 25.5 to 255: other levels there are none.
template <class Packet>
[[gnu::always_inline]] inline float packet_light(const Packet& packet, const triangle_greys& of) {
    const auto& hit = packet.hit;
    float sum = 0;
    std::array<float, embree_rays_of<Packet>> light;
    for (std::size_t i = 0; i < light.size(); ++i) {
        const bool is_hit = hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
        const std::uint32_t t = is_hit ? hit.primID[i] : 0;
        const float level = of.grey[t] + hit.u[i] * of.along_u[t] + hit.v[i] * of.along_v[t];
        const float c = level * (1 / 255.0f);
        const float l =
            c * (0.049479316f +
                 c * (0.416673993f + c * (0.933571666f + c * (-0.607616885f + c * 0.208379453f))));
        light[i] = is_hit ? l : 0.0f;
    }
    for (const float l : light)
        sum += l;
    return sum;
}

PEER_CLONES float light_of(const RTCRayHit8& packet, const triangle_greys& of) {
    return packet_light(packet, of);
}
PEER_CLONES float light_of(const RTCRayHit16& packet, const triangle_greys& of) {
    return packet_light(packet, of);
}

} // namespace

std::unique_ptr<embree_smooth_peer> embree_smooth_peer::open(const peer_mesh& mesh,
                                                             const l3d_camera& camera,
                                                             l3d_size size, std::string& why) {
    auto scene = embree_scene::open(why);
    if (!scene)
        return nullptr;
    scene->set(mesh, camera, size);
    return std::unique_ptr<embree_smooth_peer>(new embree_smooth_peer(std::move(scene), size));
}

void embree_smooth_peer::draw(l3d_workers& workers, int rays) {
    workers.for_each(picture_.pixels().height, [this, rays](int y, int) {
        if (rays == embree_rays_of<RTCRayHit8>)
            draw_row<RTCRayHit8>(y);
        else
            draw_row<RTCRayHit16>(y);
    });
}

template <class Packet> void embree_smooth_peer::draw_row(int y) {
    constexpr int rays = embree_rays_of<Packet>, packets_of_pixel = samples / rays;
    constexpr int pixels_of_call = stream / packets_of_pixel;
    const std::span<std::uint32_t> row = picture_.pixels().row(y);
    const ray_directions& d = scene_->directions;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    auto packets = embree_packets<Packet, stream>(d);
    const triangle_greys greys{scene_->grey.data(), scene_->along_u.data(), scene_->along_v.data()};
    const level_table& level_of = table();
    const int width = picture_.pixels().width;
    for (int left = 0; left < width; left += pixels_of_call) {
        const int count = std::min(pixels_of_call, width - left) * packets_of_pixel;
        for (int i = 0; i < count; ++i)
            aim(d, static_cast<float>(left + i / packets_of_pixel), static_cast<float>(y),
                i % packets_of_pixel * rays, packets[static_cast<std::size_t>(i)]);
        rtcIntersectNM(scene_->handle, &context, reinterpret_cast<RTCRayHitN*>(packets.data()),
                       rays, static_cast<unsigned>(count), sizeof(Packet));
        for (int i = 0; i < count; i += packets_of_pixel) {
            float sum = 0;
            for (int k = 0; k < packets_of_pixel; ++k)
                sum += light_of(packets[static_cast<std::size_t>(i + k)], greys);
            row[static_cast<std::size_t>(left + i / packets_of_pixel)] =
                level_of(sum / samples) * 0x010101u;
        }
    }
}
