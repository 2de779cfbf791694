// SPDX-License-Identifier: MIT
// l3d_box_lanes: the boxes around many things, side by side.
#ifndef L3D_SCENE_BOX_LANES_H
#define L3D_SCENE_BOX_LANES_H

#include "base/public.h"
#include "geom/vector.h"

#include <array>
#include <cstddef>
#include <vector>

/// A box that an affine map may have slanted: the points centre + r axes[0] + s axes[1] +
/// t axes[2] with r, s, t in [-1, 1].
struct L3D_PUBLIC l3d_slanted_box {
    l3d_vector<double, 3> centre{0.0, 0.0, 0.0}; ///< the middle, in world units
    std::array<l3d_vector<double, 3>, 3> axes{}; ///< from the middle to three sides that meet
    double reach = 0; ///< bound of the terms that coordinates inside are summed up from, if known
};

/// Boxes held so that a processor's lanes can each take one.
///
/// Shape: one array per coordinate, box i in element i; the arrays have room for a multiple of
///        `lanes`, with meaningless numbers behind the last box.
/// Cost:  13 doubles a box. add allocates only when there are more than ever before.
class L3D_PUBLIC l3d_box_lanes {
public:
    static constexpr std::size_t lanes = 16; ///< the arrays have room for a multiple of this

    /// The number of boxes.
    std::size_t count() const { return count_; }
    /// Forgets all boxes. Cost: keeps the memory.
    void clear() { count_ = 0; }

    /// Adds a box at the end.
    void add(const l3d_slanted_box& box) {
        if (count_ == centre_[0].size())
            grow();
        set(count_++, box);
    }

    /// Replaces a box. Expects: there is a box at that index.
    void set(std::size_t index, const l3d_slanted_box& box) {
        for (int i = 0; i < 3; ++i) {
            const auto at = static_cast<std::size_t>(i);
            centre_[at][index] = box.centre[i];
            for (std::size_t k = 0; k < 3; ++k)
                axes_[k][at][index] = box.axes[k][i];
        }
        reach_[index] = box.reach;
    }

    /// Coordinate i of the centres, from box `first` on.
    const double* centre(std::size_t i, std::size_t first) const { return &centre_[i][first]; }

    /// Coordinate i of the k-th axes, likewise.
    const double* axis(std::size_t k, std::size_t i, std::size_t first) const {
        return &axes_[k][i][first];
    }

    /// The bounds of their terms, likewise.
    const double* reach(std::size_t first) const { return &reach_[first]; }

private:
    void grow() {
        const std::size_t size = 2 * count_ + lanes;
        for (std::size_t i = 0; i < 3; ++i) {
            centre_[i].resize(size);
            for (auto& axis : axes_)
                axis[i].resize(size);
        }
        reach_.resize(size);
    }

    std::size_t count_ = 0;
    std::array<std::vector<double>, 3> centre_;
    std::array<std::array<std::vector<double>, 3>, 3> axes_;
    std::vector<double> reach_;
};

#endif
