// SPDX-License-Identifier: MIT
// smooth_judge: the exact means, and a file that keeps them.
#include "bench/smooth_judge.h"

#include "reference/box_image.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace {

reference::vec3 vec3_of(const l3d_vector<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

struct exact_scene {
    std::vector<reference::patch> patches;
    reference::camera view;
    reference::vec3 light;

    exact_scene(const l3d_patch_model& model, const l3d_camera& camera)
        : view{vec3_of(camera.eye), vec3_of(camera.target), vec3_of(camera.up), camera.fov,
               camera.near_z},
          light(vec3_of(l3d_afd_settings().light)) {
        for (const auto& p : model.patches()) {
            auto& points = patches.emplace_back().points;
            std::ranges::transform(p.points, points.begin(), vec3_of);
        }
    }

    /// Another one if any number of the scene differs (FNV-1a).
    std::uint64_t key() const {
        std::uint64_t hash = 0xcbf29ce484222325;
        const auto add = [&](const auto& number) {
            for (const std::byte b : std::as_bytes(std::span(&number, 1)))
                hash = (hash ^ std::to_integer<std::uint64_t>(b)) * 0x100000001b3;
        };
        const auto add_vector = [&](const reference::vec3& v) {
            for (const double number : {v.x, v.y, v.z})
                add(number);
        };
        for (const reference::patch& p : patches)
            for (const reference::vec3& point : p.points)
                add_vector(point);
        for (const reference::vec3& v : {view.eye, view.target, view.up, light})
            add_vector(v);
        for (const double number : {view.fov_degrees, view.near})
            add(number);
        return hash;
    }
};

using file = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

double root_mean(double sum, std::size_t count) {
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

} // namespace

smooth_judge::smooth_judge(const l3d_patch_model& model, const bench_view& view, l3d_size size,
                           const std::string& folder) {
    const exact_scene scene(model, view.camera);
    char name[96];
    std::snprintf(name, sizeof name, "%s_%dx%d_%016llx.exact", view.name, size.width, size.height,
                  static_cast<unsigned long long>(scene.key()));
    const std::string path = (std::filesystem::path(folder) / name).string();
    pixels_.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    if (read(path))
        return;
    std::fprintf(stderr, "the exact picture of %s at %d x %d: a minute or two\n", view.name,
                 size.width, size.height);
    const reference::box_image exact(scene.patches, scene.view, {size.width, size.height},
                                     scene.light);
    std::ranges::transform(exact.pixels(), pixels_.begin(), [](const reference::box_pixel& p) {
        return kept_pixel{static_cast<float>(p.level), static_cast<float>(p.unsure), p.covered > 0,
                          p.edge};
    });
    std::filesystem::create_directories(folder);
    write(path);
}

bool smooth_judge::read(const std::string& path) {
    const file in(std::fopen(path.c_str(), "rb"), std::fclose);
    return in && std::fread(pixels_.data(), sizeof pixels_[0], pixels_.size(), in.get()) ==
                     pixels_.size();
}

void smooth_judge::write(const std::string& path) const {
    file out(std::fopen(path.c_str(), "wb"), std::fclose);
    if (!out ||
        std::fwrite(pixels_.data(), sizeof pixels_[0], pixels_.size(), out.get()) !=
            pixels_.size() ||
        std::fclose(out.release()) != 0)
        throw std::runtime_error("cannot write " + path);
}

smooth_error smooth_judge::operator()(std::span<const std::uint8_t> greys) const {
    assert(greys.size() == pixels_.size());
    double sum = 0, edge_sum = 0;
    std::size_t shown = 0, edges = 0;
    for (std::size_t i = 0; i < greys.size(); ++i) {
        const kept_pixel& exact = pixels_[i];
        if (!exact.covered && greys[i] == 0)
            continue;
        const double off = double(greys[i]) - double{exact.level};
        ++shown;
        sum += off * off;
        if (exact.edge) {
            ++edges;
            edge_sum += off * off;
        }
    }
    return {root_mean(sum, shown), root_mean(edge_sum, edges)};
}

std::size_t smooth_judge::shown() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(pixels_, [](const kept_pixel& p) { return p.covered != 0; }));
}

std::size_t smooth_judge::edges() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        pixels_, [](const kept_pixel& p) { return p.covered != 0 && p.edge != 0; }));
}

double smooth_judge::unsure() const {
    double sum = 0;
    for (const kept_pixel& p : pixels_)
        if (p.covered && p.edge)
            sum += double{p.unsure} * double{p.unsure};
    return root_mean(sum, edges());
}
