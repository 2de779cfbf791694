// SPDX-License-Identifier: MIT
// Patches that pictures lie on, and the means of 256 samples of each pixel as the truth: for tests
// and benchmarks.
#ifndef L3D_TESTS_PIPELINE_TEXTURED_SCENES_H
#define L3D_TESTS_PIPELINE_TEXTURED_SCENES_H

#include "geom/nurbs_surface.h"
#include "hard_edged.h"
#include "pipeline/pipeline_afd.h"
#include "raster/color/srgb_light.h"
#include "raster/textures/texture.h"
#include "scene/patch_scene.h"
#include "tool_2d/image.h"
#include "words_of.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace textured_scenes {

inline constexpr l3d_size window{133, 101};

/// A picture by a function of x and y.
template <class Word> l3d_image picture_of(l3d_size size, const Word& word) {
    l3d_image image(size, size.width);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            image.pixels().row(y)[static_cast<std::size_t>(x)] = word(x, y);
    return image;
}

template <class Word>
std::shared_ptr<const l3d_texture> texture_of(l3d_size size, const Word& word,
                                              l3d_texture_wrap wrap = l3d_texture_wrap::clamp) {
    return std::make_shared<const l3d_texture>(picture_of(size, word).pixels(), wrap, wrap);
}

/// Squares of 4 by 4 pixels, as hard as colours can be.
inline l3d_image squares_picture(int size) {
    return picture_of({size, size},
                      [](int x, int y) { return (x / 4 + y / 4) % 2 ? 0xffe0c0U : 0x202040U; });
}
inline std::shared_ptr<const l3d_texture> squares(int size = 64) {
    return std::make_shared<const l3d_texture>(squares_picture(size).pixels(),
                                               l3d_texture_wrap::clamp, l3d_texture_wrap::clamp);
}

/// Squares of 8 by 8 pixels, every other one with waves of colour: no size of it is like another.
inline l3d_image waves_picture(int size) {
    return picture_of({size, size}, [](int x, int y) {
        const double wave = 0.5 + 0.5 * std::sin(0.2 * x) * std::cos(0.15 * y);
        const auto level = static_cast<std::uint32_t>(255 * wave);
        return (x / 8 + y / 8) % 2 ? level << 16 | (255 - level) << 8 | 40 : 0x203050U;
    });
}

/// The usual light, whose levels are multiplied by colours, and stairs at edges.
inline l3d_afd_settings by_levels(l3d_texture_filter filter = l3d_texture_filter::bilinear) {
    l3d_afd_settings settings = hard_edged();
    settings.texture_filter = filter;
    return settings;
}

/// Colours as they are, whatever the light: levels are 255.
inline l3d_afd_settings plainly(l3d_texture_filter filter) {
    l3d_afd_settings settings = by_levels(filter);
    settings.lighting.ambient = {1, 1, 1};
    settings.lighting.color = {0, 0, 0};
    return settings;
}

inline l3d_patch_scene scene_of(const l3d_patch_model& model,
                                const std::shared_ptr<const l3d_texture>& texture) {
    l3d_patch_scene scene(model);
    scene.lay(0, {texture});
    return scene;
}

inline l3d_camera teapot_camera() {
    l3d_camera camera;
    camera.eye = {3.2, 3.6, 7.4};
    camera.target = {0.2, 1.3, 0.0};
    return camera;
}

inline std::vector<std::uint32_t> drawn(const l3d_patch_scene& scene,
                                        const l3d_afd_settings& settings,
                                        const l3d_camera& camera = teapot_camera(),
                                        l3d_size size = window) {
    l3d_pipeline_afd pipeline(l3d_memory_canvas(size), scene, camera, settings);
    pipeline.draw_event();
    return words_of(pipeline.screen().pixels());
}

inline int channel(std::uint32_t word, int shift) {
    return static_cast<int>(word >> shift & 255);
}

/// A flat patch, 2 by 2, in the plane y = 0.
inline l3d_patch_model floor_patch() {
    l3d_patch_model::patch patch;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            patch.at(row, column) = {column * 2 / 3.0 - 1, 0.0, row * 2 / 3.0 - 1};
    return l3d_patch_model(std::vector{patch});
}

inline l3d_patch_model sphere() {
    return l3d_patch_model::from_surfaces(*l3d_exact_shape("sphere"));
}

/// A camera that sees the floor under an angle between it and the line of sight.
inline l3d_camera above_floor(double degrees) {
    const double angle = degrees * 3.14159265358979 / 180;
    l3d_camera camera;
    camera.target = {0.0, 0.0, 0.0};
    camera.eye = {0.0, 3 * std::sin(angle), 3 * std::cos(angle)};
    camera.up = {0.0, std::cos(angle), -std::sin(angle)};
    camera.fov = 30;
    return camera;
}

/// The light of each pixel, mean of 256 samples of the picture on a surface.
class means {
public:
    static constexpr l3d_size size{64, 48};

    means(const l3d_patch_scene& scene, const l3d_camera& camera) {
        constexpr int across = 16, samples = across * across;
        constexpr std::uint32_t nothing = 0x010203;
        l3d_afd_settings settings = plainly(l3d_texture_filter::nearest);
        settings.background = l3d_background::color(nothing);
        const auto fine =
            drawn(scene, settings, camera, {across * size.width, across * size.height});
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                std::array<double, 3> light{};
                bool is_covered = true;
                for (int k = 0; k < samples; ++k) {
                    const int row = y * across + k / across, column = x * across + k % across;
                    const std::uint32_t word =
                        fine[static_cast<std::size_t>(row * across * size.width + column)];
                    is_covered = is_covered && word != nothing;
                    for (std::size_t c = 0; c < 3; ++c)
                        light[c] +=
                            l3d_light_of_level(channel(word, 16 - 8 * static_cast<int>(c))) /
                            samples;
                }
                light_.push_back(light);
                covered_.push_back(is_covered);
            }
    }

    /// Root of the mean square of a picture's differences, where all samples see the surface.
    /// Units: levels of 255.
    double error_of(const std::vector<std::uint32_t>& words) const {
        double sum = 0;
        int count = 0;
        for (std::size_t p = 0; p < words.size(); ++p)
            for (std::size_t c = 0; covered_[p] && c < 3; ++c) {
                const double off = channel(words[p], 16 - 8 * static_cast<int>(c)) -
                                   l3d_level_of_light(light_[p][c]);
                sum += off * off;
                ++count;
            }
        return std::sqrt(sum / std::max(count, 1));
    }

private:
    std::vector<std::array<double, 3>> light_;
    std::vector<bool> covered_;
};

} // namespace textured_scenes

#endif
