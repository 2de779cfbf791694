// SPDX-License-Identifier: MIT
// What Embree's peers share: a scene with the tree of a mesh, and where rays go.
#ifndef L3D_TESTS_BENCH_EMBREE_SCENE_H
#define L3D_TESTS_BENCH_EMBREE_SCENE_H

#include "bench/peer_mesh.h"
#include "scene/camera.h"

#include <embree3/rtcore.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

/// The machine decides what loops over a packet compile to, as it does in Embree.
#ifdef __x86_64__
#define PEER_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define PEER_CLONES
#endif

/// The number of rays in a packet.
template <class Packet>
inline constexpr int embree_rays_of = sizeof(Packet::ray.dir_x) / sizeof(float);

/// Directions of the rays through the pixel centres of a picture: right and down are steps of one
/// pixel.
struct ray_directions {
    std::array<float, 3> eye{}, first{}, right{}, down{};

    ray_directions() = default;
    ray_directions(const l3d_camera& camera, l3d_size size);
};

/// A tree of high quality, and the greys of its triangles.
struct embree_scene {
    RTCDevice device = nullptr;
    RTCScene handle = nullptr;
    ray_directions directions;
    /// Levels of each triangle: at its corner, and their changes along both parameters.
    std::vector<float> grey, along_u, along_v;

    /// Errors: null, with one line in `why`, if there is no device.
    static std::unique_ptr<embree_scene> open(std::string& why);
    explicit embree_scene(RTCDevice made) : device(made) {}
    embree_scene(const embree_scene&) = delete;
    embree_scene& operator=(const embree_scene&) = delete;
    ~embree_scene();

    /// Puts a mesh in the place of what there was.
    void set(const peer_mesh& mesh, const l3d_camera& camera, l3d_size size);
};

/// Packets for a call, with origins and masks set.
template <class Packet, std::size_t Count>
std::array<Packet, Count> embree_packets(const ray_directions& d) {
    Packet first{};
    for (std::size_t i = 0; i < embree_rays_of<Packet>; ++i) {
        first.ray.org_x[i] = d.eye[0];
        first.ray.org_y[i] = d.eye[1];
        first.ray.org_z[i] = d.eye[2];
        first.ray.mask[i] = ~0u;
    }
    std::array<Packet, Count> packets;
    packets.fill(first);
    return packets;
}

#endif
