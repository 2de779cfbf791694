// SPDX-License-Identifier: MIT
// How far an anti-aliased picture is from the exact mean of the light in each pixel.
#ifndef L3D_TESTS_BENCH_SMOOTH_JUDGE_H
#define L3D_TESTS_BENCH_SMOOTH_JUDGE_H

#include "bench/bench_frame.h"
#include "scene/patch_model.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// Root mean squares of differences of levels. Units: levels of 255.
struct smooth_error {
    double all = 0;   ///< over the pixels that this picture or the exact one does not leave black
    double edges = 0; ///< over those of them that an edge may pass, or one of their neighbours
};

/// The exact picture of a model through a box filter in linear light, before black. It is lit as
/// the library does unless it is told otherwise.
class smooth_judge {
public:
    /// Reads the picture from `folder` if one of the same patches, view and size is kept there, and
    /// keeps it there if not.
    /// Errors: std::runtime_error if it cannot be written.
    /// Cost:   as reference::box_image, a minute or two; nothing if it was kept.
    smooth_judge(const l3d_patch_model& model, const bench_view& view, l3d_size size,
                 const std::string& folder);

    /// Shape: grey levels row by row, as large as the exact picture; 0 where nothing is.
    smooth_error operator()(std::span<const std::uint8_t> greys) const;

    std::size_t shown() const;
    std::size_t edges() const;
    /// The root mean square of what the exact picture itself is unsure of, over edge pixels;
    /// levels.
    double unsure() const;

private:
    /// What is kept of a pixel of the exact picture.
    struct kept_pixel {
        float level = 0, unsure = 0;
        std::uint32_t covered = 0, edge = 0;
    };
    bool read(const std::string& path);
    void write(const std::string& path) const;

    std::vector<kept_pixel> pixels_;
};

#endif
