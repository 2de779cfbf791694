// SPDX-License-Identifier: MIT
// l3d_fd_dicer: forward differencing with one fixed step a patch.
#ifndef L3D_COMPARE_DICERS_FD_DICER_H
#define L3D_COMPARE_DICERS_FD_DICER_H

#include "scene/counts.h"
#include "dice/piece_pool.h"
#include "dice/edges/edge_polylines.h"
#include "compare/arithmetic.h"
#include "dice/patch_dicer.h"
#include "compare/dicers/uniform_grid.h"

#include <array>
#include <cstdint>
#include <vector>

/// Classic forward differencing. One bound of the whole patch gives the number of steps. Each
/// column v -> S(u, v) is started exactly and walked from end to end without a restart.
///
/// Homogeneous points may be multiplied by any number, so each arithmetic gets the scale that suits
/// it best. Slits beside neighbours with other numbers of steps are closed along the same edge
/// polylines as in the adaptive method. A patch with an edge that needs more than 4 x 32 steps is
/// left to l3d_patch_dicer.
/// Cost: 9 additions and a division a vertex.
class l3d_fd_dicer {
public:
    /// With steps > 0, each patch takes this number of steps. Otherwise the tolerance gives the
    /// number.
    explicit l3d_fd_dicer(l3d_arithmetic arithmetic, int steps = 0)
        : arithmetic_(arithmetic), steps_(steps) {}

    /// Dices a patch and adds its polygons to `out`. Expects: l3d_needs_no_clipping(net, view).
    void dice(const l3d_image_patch& net, const l3d_normal_net& normals, const l3d_dice_view& view,
              l3d_piece_pool& out, l3d_dice_counts& counts);

private:
    /// The four registers of each of three coordinates, for all columns side by side.
    template <class R> struct registers { std::array<std::array<std::vector<R>, 4>, 3> of; };
    /// The factor that each coordinate has in its registers, and the error of a walk.
    struct scales {
        std::array<double, 3> factor{1, 1, 1};
        double error_xy = 0, error_w = 0;
    };

    scales scales_of(const l3d_image_patch& net, int steps) const;
    template <class R>
    void walk(registers<R>& walked, const l3d_image_patch& net, const scales& scaled,
              const l3d_dice_view& view, const l3d_diced_piece& piece, l3d_micro_grid& grid);

    l3d_arithmetic arithmetic_;
    int steps_;
    l3d_uniform_grid grid_;
    l3d_edge_polylines edges_;
    l3d_patch_dicer<double> adaptive_;
    registers<float> floats_;
    registers<double> doubles_;
    registers<std::uint32_t> words_; ///< signed numbers that wrap around
    registers<std::uint64_t> long_words_;
};

#endif
