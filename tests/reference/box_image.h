// SPDX-License-Identifier: MIT
// The exact anti-aliased picture: each pixel is the mean of the light from all of its square.
#ifndef L3D_REFERENCE_BOX_IMAGE_H
#define L3D_REFERENCE_BOX_IMAGE_H

#include "reference/light_samples.h"

#include <cstddef>
#include <span>
#include <vector>

namespace reference {

struct box_settings {
    double background = 0; ///< level where nothing is
    int cells = 4;         ///< of every pixel, along x and along y
    int edge_cells = 16;   ///< of a pixel that an edge may pass
    int most_lines = 64;   ///< across such a pixel: `edge_cells` + 1 and what is put between them
    double wanted = 0.5;   ///< levels: more lines are put between as long as `unsure` is more
    lamp_light lamps{};    ///< that light instead, if there are any
};

struct box_pixel {
    double level = 0;   ///< of the mean light, not rounded
    double unsure = 0;  ///< levels: the exact mean's level is no farther from `level`
    double covered = 0; ///< share of the square where a surface is seen
    int samples = 0;    ///< exact points of the surface (or of nothing) behind the mean
    bool edge = false;  ///< an edge may pass it or one of its eight neighbours
};

/// The picture through a box filter. Light is Lambert's: the encoded level is
/// 255 (0.1 + 0.9 max(0, n.l)), n turned to the eye; or that of lamps, if there are any.
///
/// Every pixel's square has a grid of samples, those on its sides included. Each is the nearest of
/// all surface points there, found as exact_image finds them. The trapezoid rule gives the mean.
///
/// An edge may pass a pixel in one of these cases:
/// - It or one of its eight neighbours has samples next to each other that differ
///   (light_sampler::differ).
/// - A border of a patch passes it, or a place where a surface may fold over (outline_map), and is
///   not hidden.
/// - The second surface is so near behind the first one that they may cross.
/// - The coarse samples alone are less sure of it than is wanted.
///
/// Such a pixel gets the finer grid, as lines in that direction in which light changes more. Lines
/// have exact samples on both sides of every border and on all pieces that fold. Between samples
/// that differ, exact lines of sight halve the way down to 1/4096 px. Lines are put where borders
/// turn or end, through folds that no line meets, and where sums of lines change unevenly.
///
/// Proved: each sample, to 1e-9 px (1e-7 px where it grazes a surface); all borders and folds in a
/// pixel are known. Taken for granted: a border or fold is hidden if it is farther away than all
/// that is seen in the pixel, by more than the range of what is seen. Estimated: light between
/// samples (stretch_errors), which is what `unsure` says. Not known: a piece of a surface that
/// comes through another between samples and shows at none, and folds thinner than 1e-6 px.
///
/// Errors: std::runtime_error as exact_image.
/// Cost:   30 us per covered pixel, 1 ms per edge pixel; 9 s for a teapot of 22000 pixels, 40 s for
///         one of 220000.
class box_image {
public:
    /// Expects: patches and camera as exact_image does; light of any length but zero, towards the
    ///          light, world space; edge_cells a multiple of 2.
    box_image(std::span<const patch> patches, const camera& view, picture_size size, vec3 light,
              const box_settings& settings = {});

    picture_size size() const { return size_; }
    const box_settings& settings() const { return settings_; }
    const box_pixel& at(int x, int y) const {
        return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
                       static_cast<std::size_t>(x)];
    }
    /// Shape: row by row.
    std::span<const box_pixel> pixels() const { return pixels_; }

private:
    picture_size size_;
    box_settings settings_;
    std::vector<box_pixel> pixels_;
};

} // namespace reference

#endif
