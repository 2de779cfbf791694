// SPDX-License-Identifier: MIT
// l3d_pixel_boxes: a few rectangles of a picture instead of one.
#ifndef L3D_TOOL_2D_PIXEL_BOXES_H
#define L3D_TOOL_2D_PIXEL_BOXES_H

#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

/// A few disjoint boxes that together hold all boxes that were added, such as the parts of a
/// picture that changed. Each box that a caller handles has a fixed cost, so near boxes are united.
/// Most of the space between distant boxes is left out.
class l3d_pixel_boxes {
public:
    static constexpr std::size_t most = 4;

    l3d_pixel_boxes() = default;
    explicit l3d_pixel_boxes(const l3d_pixel_box& box) { add(box); }

    void add(const l3d_pixel_box& box) {
        if (box.empty())
            return;
        boxes_[count_++] = box;
        while (unite_two()) {
        }
    }

    std::span<const l3d_pixel_box> boxes() const { return {boxes_.data(), count_}; }

    std::int64_t area() const {
        std::int64_t sum = 0;
        for (const l3d_pixel_box& box : boxes())
            sum += box.area();
        return sum;
    }

    /// The smallest box that holds all boxes.
    l3d_pixel_box around() const {
        l3d_pixel_box result;
        for (const l3d_pixel_box& box : boxes())
            result = result.united(box);
        return result;
    }

private:
    /// Two boxes are united if their union adds fewer needless pixels than this number. The
    /// smallest part of a picture costs as much as some 2000 pixels of a whole picture
    /// (tests/bench/still_bench).
    static constexpr std::int64_t cost = 2048;

    /// Finds the two boxes whose union adds the fewest needless pixels. Unites them if these pixels
    /// are fewer than `cost`, or if there are too many boxes. Boxes that overlap count as adding
    /// none. Returns whether two boxes were united.
    bool unite_two() {
        std::size_t a = 0, b = 0;
        std::int64_t least = count_ > most ? std::numeric_limits<std::int64_t>::max() : cost;
        for (std::size_t i = 0; i < count_; ++i)
            for (std::size_t k = i + 1; k < count_; ++k) {
                const l3d_pixel_box &one = boxes_[i], &other = boxes_[k];
                const std::int64_t lost = one.intersected(other).empty()
                                              ? one.united(other).area() - one.area() - other.area()
                                              : 0;
                if (lost < least) {
                    least = lost;
                    a = i;
                    b = k;
                }
            }
        if (a == b)
            return false;
        boxes_[a] = boxes_[a].united(boxes_[b]);
        boxes_[b] = boxes_[--count_];
        return true;
    }

    std::array<l3d_pixel_box, most + 1> boxes_;
    std::size_t count_ = 0;
};

#endif
