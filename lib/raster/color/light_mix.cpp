// SPDX-License-Identifier: MIT
// light_mix: turns words into linear light, and back.
#include "raster/color/light_mix_p.h"

#include "raster/background.h"
#include "raster/color/linear_light_p.h"

#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// Calls visit(y, index of row y's first sum) for all rows of the box. Workers share the rows in
/// runs of 16.
template <class Visit> void light_mix::for_rows(l3d_workers& workers, const Visit& visit) const {
    constexpr int run = 16;
    const int rows = box_.bottom - box_.top;
    const auto width = static_cast<std::size_t>(box_.right - box_.left);
    workers.for_each((rows + run - 1) / run, [&](int item, int) {
        for (int row = item * run; row < std::min(rows, (item + 1) * run); ++row)
            visit(box_.top + row, static_cast<std::size_t>(row) * width);
    });
}

void light_mix::begin(const l3d_pixel_box& box) {
    box_ = box;
    sums_.assign(static_cast<std::size_t>(box.area()), {});
}

void light_mix::add(const l3d_pixels& picture, float weight, l3d_workers& workers) {
    const linear_light& tables = linear_light_tables();
    for_rows(workers, [&](int y, std::size_t first) {
        sum* to = sums_.data() + first;
        for (const std::uint32_t word : l3d_row(picture, y, box_)) {
            const float empty = weight * static_cast<float>(word >> 24) / 255;
            const float filled = weight - empty;
            to->red += filled * tables.light(word >> 16 & 255);
            to->green += filled * tables.light(word >> 8 & 255);
            to->blue += filled * tables.light(word & 255);
            to->empty += empty;
            ++to;
        }
    });
}

void light_mix::write(const l3d_pixels& target, l3d_workers& workers) const {
    const linear_light& tables = linear_light_tables();
    for_rows(workers, [&](int y, std::size_t first) {
        const sum* from = sums_.data() + first;
        for (std::uint32_t& word : l3d_row(target, y, box_)) {
            const sum& s = *from++;
            const std::uint32_t empty = l3d_transparency_of(s.empty);
            if (empty == l3d_pixels::transparent) {
                word = empty;
                continue;
            }
            const float whole = 1 / (1 - s.empty);
            word = empty | tables.level(s.red * whole) << 16 | tables.level(s.green * whole) << 8 |
                   tables.level(s.blue * whole);
        }
    });
}

} // namespace l3d_detail
