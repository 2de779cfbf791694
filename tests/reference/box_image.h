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
};

struct box_pixel {
    double level = 0;   ///< of the mean light, not rounded
    double unsure = 0;  ///< levels: the exact mean's level is no farther from `level`
    double covered = 0; ///< share of the square where a surface is seen
    int samples = 0;    ///< exact points of the surface (or of nothing) behind the mean
    bool edge = false;  ///< an edge may pass it or one of its eight neighbours
};

/// The picture through a box filter. Light is Lambert's: the encoded level is
/// 255 (0.1 + 0.9 max(0, n.l)), n turned to the eye.
///
/// Every pixel's square has a grid of samples, those on its sides included. Each is the nearest of
/// all surface points there, found as exact_image finds them. The trapezoid rule gives the mean.
///
/// An edge is taken to pass where neighbouring samples differ. They differ if one is not covered,
/// if the normal turns by 3 degrees, or if depth leaves the tangent plane by 0.1 px. Such a
/// pixel and its eight neighbours get the finer grid, as lines in that direction in which light
/// changes more. Where light changes by more than a level between samples of a line, exact lines of
/// sight halve the way down to 1/4096 px. Where the lines' sums change unevenly, lines are put
/// between them.
///
/// Exact: each sample, to 1e-9 px. Estimated: what lies between, by stretch_errors, which is what
/// `unsure` says. A surface that lies between the samples of its pixel and shows in none of them is
/// not known.
///
/// Errors: std::runtime_error as exact_image.
/// Cost:   20 us per covered pixel, 1 ms per edge pixel.
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
