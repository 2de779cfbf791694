// SPDX-License-Identifier: MIT
// How far the greys of a picture are from those of the exact picture.
#ifndef L3D_TESTS_BENCH_PICTURE_JUDGE_H
#define L3D_TESTS_BENCH_PICTURE_JUDGE_H

#include "scene/camera.h"
#include "scene/patch_model.h"
#include "tool_2d/pixels.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Root mean squares of differences of grey levels. Units: levels of 255.
struct picture_error {
    double all = 0;    ///< over the pixels that this picture or the exact one covers
    double inside = 0; ///< over those of them that lie inside one surface
};

/// The exact picture of a model, lit as the library does unless it is told otherwise.
///
/// A pixel lies inside one surface if the exact picture covers all pixels up to two away from it.
/// The surface points seen in them must also lie in its tangent plane and it in theirs, to one
/// pixel. So no outline is near, neither of the model nor of one part before another.
/// Cost: as reference::exact_image.
class picture_judge {
public:
    picture_judge(const l3d_patch_model& model, const l3d_camera& camera, l3d_size size);

    /// Shape: grey levels row by row, as large as the exact picture; 0 where nothing is.
    picture_error operator()(std::span<const std::uint8_t> greys) const;

    std::size_t covered() const { return covered_; }
    std::size_t inside() const { return inside_count_; }

private:
    std::vector<unsigned char> levels_; ///< 0 where nothing is
    std::vector<bool> inside_;
    std::size_t covered_ = 0, inside_count_ = 0;
};

/// The grey levels of a picture, row by row.
std::vector<std::uint8_t> greys_of(const l3d_pixels& picture);

#endif
