// SPDX-License-Identifier: MIT
// Anti-aliasing: against a picture of 16 x 16 times the pixels, and against exact areas.
#include "raster/refine/linear_light_p.h"
#include "surface_scene.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace {

using l3d_detail::light_of_level;

constexpr int fine = 16; ///< samples of a pixel along x and along y

l3d_shading antialiased(l3d_shade mode) {
    l3d_shading shading = scene_shading(mode);
    shading.antialias = true;
    return shading;
}

/// A part in a picture of so many times the pixels.
l3d_surface_part enlarged(l3d_surface_part part) {
    for (auto* const numbers : {&part.grid.x, &part.grid.y})
        for (std::int32_t& number : *numbers)
            number *= fine;
    for (l3d_micro_triangles::corner& c : part.triangles.corners)
        for (auto* const numbers : {&c.x, &c.y})
            for (std::int32_t& number : *numbers)
                number *= fine;
    return part;
}

surface_parts enlarged(const surface_parts& scene) {
    surface_parts result;
    for (const l3d_surface_part& part : scene)
        result.push_back(enlarged(part));
    return result;
}

void draw(surface_picture& picture, const surface_parts& scene, const l3d_shading& shading) {
    picture.begin(shading);
    picture.rasterizer.draw(pointers(scene));
    picture.rasterizer.finish();
}

/// The slow twin: every pixel by 256 samples, each drawn as a pixel of its own.
class slow_picture {
public:
    slow_picture(const surface_parts& scene, l3d_size size, l3d_shade mode)
        : picture_(size.width * fine, size.height * fine) {
        l3d_shading shading = scene_shading(mode);
        for (auto* const ray : {&shading.ray_right, &shading.ray_down})
            for (float& part : *ray)
                part /= fine;
        draw(picture_, enlarged(scene), shading);
    }

    /// The mean light of a pixel as a level, and the levels of its darkest and brightest samples.
    struct pixel {
        double level = 0;
        int darkest = 255, brightest = 0;
    };
    pixel at(int x, int y) {
        pixel result;
        double sum = 0;
        for (int row = 0; row < fine; ++row)
            for (int column = 0; column < fine; ++column) {
                const int level = int(picture_.word(x * fine + column, y * fine + row) & 255);
                result.darkest = std::min(result.darkest, level);
                result.brightest = std::max(result.brightest, level);
                sum += light_of_level(level);
            }
        result.level = level_of_light(sum / (fine * fine));
        return result;
    }

    static double level_of_light(double light) {
        return 255 * (light <= 0.0031308 ? 12.92 * light
                                         : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
    }

private:
    surface_picture picture_;
};

/// Errors as shares of the pixel's contrast.
struct share_errors {
    int outlines = 0; ///< pixels of some contrast
    double largest = 0, sum = 0;

    void add(double drawn, const slow_picture::pixel& exact) {
        const double dark = light_of_level(exact.darkest), bright = light_of_level(exact.brightest);
        if (exact.brightest - exact.darkest < 24)
            return;
        const double error =
            std::abs(light_of_level(drawn) - light_of_level(exact.level)) / (bright - dark);
        ++outlines;
        sum += error * error;
        largest = std::max(largest, error);
    }
    double rms() const { return outlines > 0 ? std::sqrt(sum / outlines) : 0; }
};

TEST(Refine, DrawsWhatTheSlowTwinDraws) {
    constexpr l3d_size size{101, 67};
    for (const l3d_shade mode : {l3d_shade::gouraud, l3d_shade::flat, l3d_shade::levels})
        for (unsigned n = 0; n < 6; ++n) {
            const surface_parts scene = random_scene(scene_seed + n, size, 6);
            surface_picture drawn(size.width, size.height, 2);
            draw(drawn, scene, antialiased(mode));
            slow_picture slow(scene, size, mode);
            share_errors errors;
            int far = 0;
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) {
                    const auto exact = slow.at(x, y);
                    const int level = int(drawn.word(x, y) & 255);
                    errors.add(level, exact);
                    if (std::abs(level - exact.level) > 30)
                    far += std::abs(level - exact.level) > 30;
                }
            printf("mode %d n %u outlines %d rms %.4f largest %.3f far %d\n", int(mode), n,
                   errors.outlines, errors.rms(), errors.largest, far);
            EXPECT_LT(errors.rms(), 1.0 / 4);
        }
}

} // namespace
