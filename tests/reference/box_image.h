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
    double background = 0; ///< the level where nothing is seen
    int cells = 4;         ///< cells along each side of every pixel
    int edge_cells = 16;   ///< cells along each side of a pixel that an edge may pass
    int most_lines = 64;   ///< most lines across such a pixel; at first `edge_cells` + 1
    double wanted = 0.5;   ///< levels: more lines are added as long as `unsure` is larger
    lamp_light lamps{};    ///< the light in place of Lambert's, if it has lamps
};

struct box_pixel {
    double level = 0;   ///< level of the mean light, not rounded
    double unsure = 0;  ///< levels: the exact mean's level is no farther than this from `level`
    double covered = 0; ///< share of the square in which a surface is seen
    int samples = 0;    ///< number of exact samples behind the mean, of the surface or of nothing
    bool edge = false;  ///< whether an edge may pass the pixel or one of its eight neighbours
};

/// The exact picture through a box filter. Its light is Lambert's, or that of lamps, if there are
/// any. Lambert's encoded level is 255 (0.1 + 0.9 max(0, n.l)), where n is turned to the eye.
///
/// Every pixel's square has a grid of samples, also on its sides. Each sample is the nearest of all
/// surface points there, as exact_image finds them. The trapezoid rule gives the mean.
///
/// An edge may pass a pixel in one of these cases:
/// - The pixel or one of its eight neighbours has samples next to each other that differ
///   (light_sampler::differ).
/// - A border, or a place where a surface may fold over (outline_map), passes the pixel and is not
///   hidden.
/// - The second surface is so near behind the first one that they may cross.
/// - The coarse samples alone leave the pixel more unsure than is wanted.
///
/// Such a pixel gets the finer grid, as lines in the direction in which light changes more. Lines
/// have exact samples on both sides of every border and on all pieces that fold. Between samples
/// that differ, exact lines of sight halve the distance down to 1/4096 px. Lines are added where
/// borders turn or end, through folds that no line meets, and where the sums of lines change
/// unevenly.
///
/// Proved: each sample is right to 1e-9 px, or 1e-7 px where it grazes a surface. All borders and
/// folds in a pixel are known.
///
/// Taken for granted: a border or fold is hidden if it is farther than all that is seen in the
/// pixel. It must be farther by more than the range of depths seen there.
///
/// Estimated: the light between samples (stretch_errors); `unsure` says how wrong it may be.
///
/// Not known: pieces of a surface that come through another between samples and show at none, and
/// folds thinner than 1e-6 px.
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
    /// All pixels. Shape: row by row.
    std::span<const box_pixel> pixels() const { return pixels_; }

private:
    picture_size size_;
    box_settings settings_;
    std::vector<box_pixel> pixels_;
};

} // namespace reference

#endif
