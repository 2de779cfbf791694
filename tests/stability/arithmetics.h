// SPDX-License-Identifier: MIT
// The library's ways to draw a scene of patches, side by side in one program.
#ifndef L3D_TESTS_STABILITY_ARITHMETICS_H
#define L3D_TESTS_STABILITY_ARITHMETICS_H

#include "cases.h"

#include "scene/camera.h"
#include "scene/counts.h"
#include "dice/diced_piece.h"
#include "scene/patch_model.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace stability {

/// A case in the library's types.
struct library_case {
    l3d_patch_model model;
    l3d_camera camera;
    l3d_size size;
    double tolerance = 0;
    double dice_tolerance = 0; ///< less, for curved models
    double curved_px = 0;      ///< what the rest of the tolerance went to

    /// Errors: nothing, and why in `why`, if the library refuses it.
    static std::optional<library_case> of(const test_case& c, std::string& why);
};

/// The pieces of one patch, and the bound that holds for all of the frame so far.
using piece_sink =
    std::function<void(std::size_t patch, std::span<const l3d_diced_piece>, double frame_bound)>;

/// A drawn frame. Units: distances along the view axis, infinite where nothing is.
struct frame {
    l3d_dice_counts counts;
    double near = 0;         ///< as l3d_frame_report says
    double milliseconds = 0; ///< of processor time, dicing and filling
    std::vector<std::uint32_t> words;
    std::vector<float> distances;
};

/// One number type and way of dicing, with the memory that it keeps from frame to frame.
class arithmetic {
public:
    arithmetic() = default;
    arithmetic(const arithmetic&) = delete;
    arithmetic& operator=(const arithmetic&) = delete;
    virtual ~arithmetic() = default;

    virtual const char* name() const = 0;

    /// Dices without filling.
    virtual l3d_dice_counts dice(const library_case& c, const piece_sink& sink) = 0;

    /// The stages of l3d_pipeline_afd, with this number type.
    virtual frame draw(const library_case& c, const piece_sink& sink) = 0;
};

/// Single, double, 32-bit block-scaled (with its 64-bit fallback) and 32.32 fixed, and the first
/// without lanes.
std::vector<std::unique_ptr<arithmetic>> all_arithmetics();

/// The frame by l3d_pipeline_afd itself, into memory, in the number type of this build.
frame draw_by_pipeline(const library_case& c);

/// The arithmetic whose pictures draw_by_pipeline makes.
const char* pipeline_arithmetic();

} // namespace stability

#endif
