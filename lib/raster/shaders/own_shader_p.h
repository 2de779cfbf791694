// SPDX-License-Identifier: MIT
// own_shader: colours surfaces by a function of the program.
#ifndef L3D_RASTER_SHADERS_OWN_SHADER_P_H
#define L3D_RASTER_SHADERS_OWN_SHADER_P_H

#include "raster/shade.h"
#include "raster/shaders/inspection_shader_p.h"

#include <cstdint>
#include <vector>

namespace l3d_detail {

/// Colours a run of pixels by the program's function. It finds the exact point of the patch in each
/// pixel, and calls the function once for the run.
class own_shader : public patch_shader {
public:
    explicit own_shader(const l3d_shading& shading) : patch_shader(shading) {}

    /// Adds a pixel to the run. Later, end_run() writes the pixel's colour to `word`.
    /// Units: pixels from the picture's top left corner.
    void note(const float* guess, double x, double y, std::uint32_t& word) {
        places_.push_back(seen(guess, x, y));
        targets_.push_back(&word);
    }
    void end_run();

    /// The pixel word of a single place, from a guess of the patch's parameters.
    std::uint32_t word_at(const float* guess, double x, double y);
    std::uint32_t word_around(const float* guess, double x, double y) {
        return word_at(guess, x, y);
    }

private:
    l3d_seen_place seen(const float* guess, double x, double y);

    std::vector<l3d_seen_place> places_;
    std::vector<std::uint32_t*> targets_;
    std::vector<std::uint32_t> words_;
};

} // namespace l3d_detail

#endif
